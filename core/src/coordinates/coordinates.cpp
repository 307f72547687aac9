// SPDX-License-Identifier: MIT
#include "cageproof/core/coordinates/coordinates.h"

#include "summed/summed.h"

#include "cageproof/core/coordinates/coordinate_tables.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/catalogue/unknown_name.h"
#include "cageproof/core/coordinates/whole_evaluation.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof {
namespace {

// Defaults filled in, ranges checked.
std::vector<double> checked_parameters(const CoordinateKind& kind, std::vector<double> parameters) {
  const std::vector<KindParameter> known = parameters_of(kind);
  if (parameters.empty())
    for (const KindParameter& p : known) parameters.push_back(p.preset);
  if (parameters.size() != known.size())
    throw InputError(fmt::format("{} has {} parameters, not {}", kind.name, known.size(), parameters.size()));
  for (std::size_t i = 0; i < known.size(); ++i)
    if (!known[i].allows(parameters[i]))
      throw InputError(
          fmt::format("{}: the parameter {} = {} is out of range", kind.name, known[i].name, parameters[i]));
  return parameters;
}

void require_accepted(const CoordinateKind& kind, const Cage& cage, const std::vector<double>& parameters) {
  if (!exists_on(kind, cage))
    throw InputError(fmt::format("{}: {} coordinates do not exist on cages of this dimension", cage.name(), kind.name));
  // Sizes hang on parameters: other ones than the defaults are for what prepares the kind to judge.
  const bool defaults = std::ranges::equal(parameters, parameters_of(kind), {}, {}, &KindParameter::preset);
  if (accepts(kind, cage) || (kind.refuses != nullptr && !defaults)) return;
  if (!kind.keeps_quads)
    throw InputError(fmt::format("{}: no {} coordinates, {}", cage.name(), kind.name, why_refused(kind, cage)));
  const auto faults = invalid_quads(cage);
  const std::string more = faults.size() > 1 ? fmt::format(", and {} more", faults.size() - 1) : "";
  throw InputError(fmt::format(
      "{}: {} (faces counted from 0, corners within the face){}; {} wants valid quads, --allow-invalid-quads computes "
      "all the same",
      cage.name(), faults.front(), more, kind.name));
}

// The coordinates of one point.
template <Scalar R>
std::vector<Result<R>> results_of(std::vector<CoordinateTable<R>> tables, int order) {
  std::vector<Result<R>> results;
  for (CoordinateTable<R>& table : tables) {
    Result<R>& result = results.emplace_back();
    for (int o = 0; o <= order; ++o) result.of(o) = std::move(table.tensors[o]);
  }
  return results;
}

}  // namespace

CageCoordinates::CageCoordinates(const Cage& cage, const CoordinateKind& kind, CoordinateOptions options)
    : kind_(&kind) {
  options.parameters = checked_parameters(kind, std::move(options.parameters));
  require_accepted(kind, cage, options.parameters);
  elements_ = std::make_shared<const CageElements>(cage, kind.keeps_quads, options.triangulation);
  if (!kind.is_sum()) {
    if (options.evaluation == quickest && !kind.made_of_sums) options.evaluation.clear();
    try {
      prepared_ = kind.prepare(cage, options);
    } catch (const InputError& e) {
      // The evaluation may be refused in words that name the coordinates that this kind is made of.
      const std::string_view said = e.what();
      const bool of_evaluation = said.find(fmt::format("'{}'", options.evaluation)) != std::string_view::npos;
      if (options.evaluation.empty() || !of_evaluation || said.starts_with(kind.name)) throw;
      throw InputError(fmt::format("{}, which is made of other coordinates: {}", kind.name, e.what()));
    }
    return;
  }
  if (options.evaluation == quickest) options.evaluation = quickest_evaluation(kind, cage);
  if (find_whole_evaluation(options.evaluation) == nullptr) {
    require_evaluation(kind, cage, options.evaluation);
    prepared_ = prepare_sum(kind, elements_, options);
    return;
  }
  const WholeEvaluation* const whole = find_whole_evaluation(options.evaluation, kind, cage);
  if (whole == nullptr)
    throw InputError(fmt::format("{}: no {} evaluation of {} coordinates", cage.name(), options.evaluation, kind.name));
  CoordinateOptions plain = options;
  plain.evaluation.clear();
  prepared_ = whole->prepare(kind, elements_, options, prepare_sum(kind, elements_, plain));
}

CageCoordinates::CageCoordinates(std::shared_ptr<const CageElements> elements, const CoordinateKind& kind,
                                 CoordinateOptions options, const Cage& like)
    : kind_(&kind), elements_(std::move(elements)) {
  options.parameters = checked_parameters(kind, std::move(options.parameters));
  CoordinateOptions plain = options;
  plain.evaluation.clear();
  const WholeEvaluation* const whole = find_whole_evaluation(options.evaluation, kind, like);
  if (whole == nullptr)
    throw InputError(fmt::format("no {} evaluation of {} coordinates", options.evaluation, kind.name));
  prepared_ = whole->prepare(kind, elements_, options, prepare_sum(kind, elements_, plain));
}

template <Scalar R>
std::vector<CoordinateTable<R>> CageCoordinates::at(std::span<const Vec3<R>> points, int order) const {
  auto tables = zero_tables<R>(blocks(), dimension(), points.size(), order);
  prepared_->fill(points, order, tables);
  return tables;
}

void CageCoordinates::at(std::span<const Vec3<double>> points, int order,
                         std::vector<CoordinateTable<double>>& tables) const {
  tables.resize(blocks().size());
  for (std::size_t b = 0; b < tables.size(); ++b)
    for (int o = 0; o < 3; ++o) {
      const bool asked = o <= order;
      tables[b].stride[o] =
          asked ? static_cast<std::size_t>(blocks()[b].size) * blocks()[b].entries() * derivative_count(dimension(), o)
                : 0;
      tables[b].tensors[o].resize(points.size() * tables[b].stride[o]);
      if (!prepared_->overwrites()) std::ranges::fill(tables[b].tensors[o], 0.0);
    }
  prepared_->fill(points, order, tables);
}

AppliedTable CageCoordinates::apply(std::span<const Vec3<double>> points, int order, const CageData& data) const {
  const std::size_t rows = blocks().front().shape.rows, sets = data.sets;
  for (const CoordinateBlock& block : blocks())
    if (static_cast<std::size_t>(block.shape.rows) != rows)
      throw InputError(fmt::format("{} coordinates make no one function of cage data", kind_->name));
  AppliedTable result;
  for (int o = 0; o <= order; ++o) {
    result.stride[o] = rows * sets * derivative_count(dimension(), o);
    result.tensors[o].assign(points.size() * result.stride[o], 0.0);
  }
  if (const AppliesData* products = prepared_->products(order)) {
    products->apply(points, order, data, result);
    return result;
  }
  constexpr std::size_t block_size = 64;
  for (std::size_t first = 0; first < points.size(); first += block_size) {
    const auto here = points.subspan(first, std::min(block_size, points.size() - first));
    const auto tables = at<double>(here, order);
    for (std::size_t p = 0; p < here.size(); ++p)
      for (int o = 0; o <= order; ++o) {
        const auto to = std::span(result.tensors[o]).subspan((first + p) * result.stride[o], result.stride[o]);
        for (std::size_t b = 0; b < tables.size(); ++b)
          add_products(std::span(tables[b].tensors[o]).subspan(p * tables[b].stride[o], tables[b].stride[o]),
                       blocks()[b], data.blocks[b], data.sets, derivative_count(dimension(), o), to);
      }
  }
  return result;
}

std::unique_ptr<const StatedSum> CageCoordinates::sum_to(double error, const CageData& data, std::size_t points) const {
  const AppliesData* const products = prepared_->products(0);
  return products == nullptr ? nullptr : products->sum_to(error, data, points);
}

template <Scalar R>
std::vector<CoordinateTable<R>> CageCoordinates::limits_at(std::span<const Touching> places, int order) const {
  const HasLimits* limits = prepared_->limits();
  if (limits == nullptr)
    throw InputError(fmt::format("{} coordinates have no limits at points within elements", kind_->name));
  auto tables = zero_tables<R>(blocks(), dimension(), places.size(), order);
  limits->fill_limits(places, order, tables);
  return tables;
}

template <Scalar R>
std::vector<CoordinateTable<R>> CageCoordinates::boundary_laplacians() const {
  const SolvesLaplacians* laplacians = prepared_->boundary_laplacians();
  if (laplacians == nullptr)
    throw InputError(fmt::format("{} coordinates are not solved for by Laplacians on the boundary", kind_->name));
  std::vector<CoordinateTable<R>> tables;
  laplacians->fill_boundary_laplacians(tables);
  return tables;
}

template <Scalar R>
std::vector<Result<R>> CageCoordinates::at(const Vec3<R>& point, int order) const {
  return results_of(at<R>(std::span(&point, 1), order), order);
}

std::vector<Result<double>> CageCoordinates::terms_at(const Vec3<double>& point, int order) const {
  const HasTerms* terms = prepared_->terms();
  if (terms == nullptr) return at<double>(point, order);
  auto tables = zero_tables<double>(blocks(), dimension(), 1, order);
  terms->fill_terms(std::span(&point, 1), order, tables);
  return results_of(std::move(tables), order);
}

#define CAGEPROOF_INSTANTIATE(R)                                                                        \
  template std::vector<CoordinateTable<R>> CageCoordinates::at<R>(std::span<const Vec3<R>>, int) const; \
  template std::vector<Result<R>> CageCoordinates::at<R>(const Vec3<R>&, int) const;
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
#undef CAGEPROOF_INSTANTIATE
template std::vector<CoordinateTable<double>> CageCoordinates::limits_at<double>(std::span<const Touching>, int) const;
template std::vector<CoordinateTable<Mp50>> CageCoordinates::limits_at<Mp50>(std::span<const Touching>, int) const;
template std::vector<CoordinateTable<double>> CageCoordinates::boundary_laplacians<double>() const;
template std::vector<CoordinateTable<Mp50>> CageCoordinates::boundary_laplacians<Mp50>() const;

}  // namespace cageproof
