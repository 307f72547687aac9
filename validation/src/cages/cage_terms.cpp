// SPDX-License-Identifier: MIT
#include "cageproof/validation/cage_terms.h"

#include "cageproof/core/coordinates/whole_evaluation.h"

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

// Over that of the identity where a coordinate is a matrix; a number counts as that multiple of the identity.
double coordinate_norm(const double* entries, std::size_t width, std::size_t stride, int dim) {
  if (width == 1) return std::abs(*entries);
  double length = 0;  // squares of entries may leave the range of numbers
  for (std::size_t e = 0; e < width; ++e) length = std::hypot(length, entries[e * stride]);
  return length / std::sqrt(static_cast<double>(dim));
}

}  // namespace

double length_of(std::span<const double> values) {
  double length = 0;
  for (const double x : values) length = std::hypot(length, x);
  return length;
}

// Sums of absolute values, by order; `ones` and `positions` also by derivative.
struct CageTerms::Sums {
  Sums(const CageCoordinates& coordinates, int order) : magnitudes(coordinates.blocks().size()) {
    for (int o = 0; o <= order; ++o) {
      const std::size_t derivatives = derivative_count(coordinates.dimension(), o);
      ones[o].resize(derivatives);
      totals[o].resize(derivatives);
      positions[o].resize(derivatives);
      for (std::size_t b = 0; b < magnitudes.size(); ++b) {
        const CoordinateBlock& block = coordinates.blocks()[b];
        magnitudes[b][o].resize(block.size * block.entries() * derivatives);
      }
    }
  }

  // One coordinate's term: the first of its entries and derivatives.
  void add(const CoordinateBlock& block, std::size_t b, int order, std::size_t coordinate, const double* term,
           double weight, int dim) {
    const std::size_t width = block.entries(), derivatives = ones[order].size();
    double* const to = &magnitudes[b][order][coordinate * width * derivatives];
    for (std::size_t i = 0; i < width * derivatives; ++i) to[i] += std::abs(term[i]);
    if (block.reproduces == Reproduces::Nothing) return;
    for (std::size_t d = 0; d < derivatives; ++d) {
      const double size = coordinate_norm(term + d, width, derivatives, dim);
      positions[order][d] += size * weight;
      if (block.reproduces != Reproduces::Normals) ones[order][d] += size;
    }
    if (width > 1) return;
    for (std::size_t d = 0; d < derivatives; ++d) totals[order][d] += term[d];
  }

  std::array<std::vector<double>, 3> ones, positions;
  std::vector<std::array<std::vector<double>, 3>> magnitudes;  // by block and order, as coordinates lie
  std::array<std::vector<double>, 3> totals;                   // of coordinates that are numbers, with their signs
};

CageTerms::CageTerms(const Cage& cage, const CoordinateKind& kind, Triangulation rule, std::string_view judged)
    : CageTerms(cage, CageCoordinates(cage, kind, CoordinateOptions{.triangulation = rule}), judged) {}

CageTerms::CageTerms(const Cage& cage, CageCoordinates coordinates, std::string_view judged)
    : moved_(find_whole_evaluation(judged) != nullptr ? cage.size() : 0), coordinates_(std::move(coordinates)) {
  const CoordinateKind& kind = coordinates_.kind();
  for (const Parameter& p : parameters_of(kind)) parameters_.push_back(p.preset);
  if (!kind.is_sum()) return;
  const auto& known = EvaluationRegister::instance();
  for (std::size_t e = 0; e < coordinates_.elements().count(); ++e) {
    const ElementKind element = coordinates_.elements().type(e).kind;
    auto& found = evaluations_[static_cast<std::size_t>(element)];
    if (!found.empty()) continue;
    for (const SummedBlock& spec : kind.blocks) {
      const std::string_view formula = find_formula(element, spec.kernel)->name;
      auto evaluation = known.with_role(formula, Role::Recommended);
      if (!evaluation) evaluation = known.with_role(formula, Role::Integral);
      found.push_back(std::move(evaluation.value()));
    }
  }
}

double CageTerms::weight_of(std::size_t b, int coordinate) const {
  const CoordinateBlock& block = coordinates_.blocks()[b];
  const CageElements& elements = coordinates_.elements();
  if (block.reproduces == Reproduces::Normals)
    return std::abs(block.normal_factor) * elements.normal_of(coordinate, block.owner).stableNorm();
  // Blocks of elements that reproduce nothing have no position.
  return block.owner == Owner::Vertex ? elements.vertices()[coordinate].stableNorm() : 0;
}

CageTerms::Sums CageTerms::sums_of_terms(const Vec3<double>& point, int order) const {
  Sums sums(coordinates_, order);
  const CageElements& elements = coordinates_.elements();
  Result<double> term;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto corners = elements.corners(e);
    const auto& evaluations = evaluations_[static_cast<std::size_t>(elements.type(e).kind)];
    for (std::size_t b = 0; b < evaluations.size(); ++b) {
      const CoordinateBlock& block = coordinates_.blocks()[b];
      evaluations[b](Query<double>{corners, point, order, parameters_}, term);
      const std::span<const int> shares = elements.shares_of(e, block.owner);
      for (int o = 0; o <= order; ++o)
        for (std::size_t i = 0; block.owner == Owner::Normal && i < term.of(o).size(); ++i)
          term.of(o)[i] *= elements.area_element_of(shares[i * shares.size() / term.of(o).size()], block.owner);
      for (int o = 0; o <= order; ++o)
        for (std::size_t k = 0; k < shares.size(); ++k)
          sums.add(block, b, o, shares[k], &term.of(o)[k * term.of(o).size() / shares.size()], weight_of(b, shares[k]),
                   elements.dimension());
    }
  }
  return sums;
}

CageTerms::Sums CageTerms::sums_of_coordinates(const Vec3<double>& point, int order) const {
  Sums sums(coordinates_, order);
  const auto found = coordinates_.terms_at(point, order);
  for (std::size_t b = 0; b < found.size(); ++b) {
    const CoordinateBlock& block = coordinates_.blocks()[b];
    for (int o = 0; o <= order; ++o)
      for (int i = 0; i < block.size; ++i)
        sums.add(block, b, o, i, &found[b].of(o)[i * found[b].of(o).size() / block.size], weight_of(b, i),
                 coordinates_.dimension());
  }
  return sums;
}

void CageTerms::add_moved_point(const Vec3<double>& point, int order, TermSizes& sizes) const {
  const std::size_t dim = coordinates_.dimension();
  const auto found = coordinates_.at<double>(point, std::min(order + 1, 2));
  for (std::size_t b = 0; b < found.size(); ++b) {
    const CoordinateBlock& block = coordinates_.blocks()[b];
    for (int o = 0; o <= std::min(order, 1); ++o) {
      const std::vector<double>& next = found[b].of(o + 1);
      std::array<double, 3> along{};
      for (std::size_t i = 0; i < next.size(); ++i) along[i % dim] = std::hypot(along[i % dim], next[i]);
      sizes.blocks[b][o] += moved_ * (along[0] + along[1] + along[2]);
      if (block.reproduces == Reproduces::Nothing) continue;
      const std::size_t width = next.size() / block.size;
      for (int i = 0; i < block.size; ++i) {
        const double change = moved_ * length_of(std::span(next).subspan(i * width, width)) /
                              std::sqrt(static_cast<double>(block.entries() > 1 ? dim : 1));
        sizes.positions[o] += change * weight_of(b, i);
        if (block.reproduces != Reproduces::Normals) sizes.ones[o] += change;
      }
    }
  }
}

TermSizes CageTerms::at(const Vec3<double>& point, int order) const {
  TermSizes sizes = sizes_of_terms(point, order);
  if (moved_ > 0) add_moved_point(point, order, sizes);
  return sizes;
}

TermSizes CageTerms::sizes_of_terms(const Vec3<double>& point, int order) const {
  const bool normalised = coordinates_.kind().normalised;
  const bool sum = coordinates_.kind().is_sum();
  const Sums sums = sum ? sums_of_terms(point, order) : sums_of_coordinates(point, order);
  const double whole = normalised && sum ? std::abs(sums.totals[0][0]) : 1;
  TermSizes sizes;
  std::array<double, 3> changes{};  // of the sum that weights are divided by, over itself
  for (int o = 0; o <= order; ++o) {
    sizes.ones[o] = length_of(sums.ones[o]) / whole;
    sizes.positions[o] = length_of(sums.positions[o]) / whole;
    changes[o] = length_of(sums.totals[o]) / whole;
  }
  for (const auto& magnitudes : sums.magnitudes) {
    auto& of_block = sizes.blocks.emplace_back();
    for (int o = 0; o <= order; ++o) of_block[o] = length_of(magnitudes[o]) / whole;
  }
  if (!normalised) return sizes;
  const std::array<double, 3> weights = sizes.ones;
  const auto found = coordinates_.at<double>(point, order)[0];
  std::array<double, 3> lambda{};
  for (int o = 0; o <= order; ++o) lambda[o] = length_of(found.of(o));
  auto& block = sizes.blocks[0];
  block[0] += lambda[0] * weights[0];
  if (!sum) return sizes;
  for (auto* t : {&sizes.ones, &sizes.positions}) {
    (*t)[1] += (*t)[0] * changes[1];
    (*t)[2] += (*t)[0] * changes[2] + 2 * (*t)[1] * changes[1];
  }
  block[1] += lambda[1] * weights[0] + lambda[0] * weights[1] + block[0] * changes[1];
  block[2] += lambda[2] * weights[0] + lambda[0] * weights[2] + block[0] * changes[2] +
              2 * (block[1] * changes[1] + lambda[1] * weights[1]);
  return sizes;
}

}  // namespace cageproof::validation
