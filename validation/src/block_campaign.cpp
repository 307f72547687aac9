// SPDX-License-Identifier: MIT
#include "cageproof/validation/block_campaign.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/lazy.h"
#include "cageproof/validation/promise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

// How many points an evaluation is given at once, of which the sample's is one: as many as the widest vectors hold.
constexpr std::size_t block_of_points = 16;

// The sample's point among generic ones.
std::vector<Vec3<double>> among_others(const CageElements& elements, const CageSample& sample) {
  Vec3<double> low = elements.vertices().front(), high = low;
  for (const Vec3<double>& v : elements.vertices()) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  std::vector<Vec3<double>> points;
  points.reserve(block_of_points);
  for (std::size_t i = 0; i < block_of_points; ++i) {
    const double t = 0.05 + 0.06 * static_cast<double>(i);
    points.emplace_back(low + (high - low).cwiseProduct(Vec3<double>(t, 0.93 - 0.8 * t, 0.31 + 0.4 * t)));
    if (elements.dimension() == 2) points.back()[2] = 0;
  }
  points[sample.index % block_of_points] = sample.point;
  return points;
}

std::vector<Result<double>> found_among(const CageCoordinates& coordinates, const CageSample& sample, int order) {
  const std::vector<Vec3<double>> points = among_others(coordinates.elements(), sample);
  const auto tables = coordinates.at<double>(points, order);
  std::vector<Result<double>> found(tables.size());
  for (std::size_t b = 0; b < tables.size(); ++b)
    for (int o = 0; o <= order; ++o) {
      const std::size_t stride = tables[b].stride[o];
      const auto from =
          tables[b].tensors[o].begin() + static_cast<std::ptrdiff_t>(stride * (sample.index % block_of_points));
      found[b].of(o).assign(from, from + static_cast<std::ptrdiff_t>(stride));
    }
  return found;
}

BlockFinding finding_at(const CageCoordinates& coordinates, const BlockTruths& truths, const CageSample& sample,
                        int order) {
  BlockFinding finding;
  finding.is_on_cage = !coordinates.elements().touching(sample.point).empty();
  const auto truth = truths.at(sample.point, order);
  finding.truth_reached = truth.has_value();
  if (!truth) return finding;
  finding.errors = block_errors(coordinates.at<double>(sample.point, order), *truth);
  const auto in_block = block_errors(found_among(coordinates, sample, order), *truth);
  for (int o = 0; o <= order; ++o)
    if (in_block[o].roundings > finding.errors[o].roundings) finding.errors[o] = in_block[o];
  return finding;
}

class BlockMeasurement final : public Measurement {
 public:
  BlockMeasurement(std::shared_ptr<const Cage> cage, const CoordinateKind& kind, BlockCampaignOptions options)
      : cage_(std::move(cage)), kind_(kind), options_(std::move(options)), setup_([this] {
          Setup setup{std::make_shared<const BlockErrors>(*cage_, kind_, options_.evaluation, options_.triangulation),
                      {}};
          const CageLocator locator(*cage_, options_.triangulation, kind_.keeps_quads);
          setup.samples = cage_samples(setup.errors->coordinates(), *cage_, locator, options_.seed, count());
          return setup;
        }) {}

  std::string name() const override {
    return fmt::format("{}, {}, {}, {}", block_error_check, cage_->name(), kind_.name, options_.evaluation);
  }
  int blocks() const override { return block_count(static_cast<std::size_t>(count()), 8); }

  Findings measure(int block) const override {
    const Setup& setup = setup_.get();
    Findings findings;
    for (std::size_t i = block; i < setup.samples.size(); i += blocks()) add(setup, setup.samples[i], findings);
    return findings;
  }

 private:
  struct Setup {
    std::shared_ptr<const BlockErrors> errors;
    std::vector<CageSample> samples;
  };

  int count() const { return block_points(kind_, *cage_, options_); }

  void add(const Setup& setup, const CageSample& sample, Findings& findings) const {
    const CageCoordinates& coordinates = setup.errors->coordinates();
    const BlockFinding found = setup.errors->at(sample);
    RowKey key{RowKey::Section::Cage, std::string(kind_.name), coordinates.evaluation(),  "double",
               cage_->name(),         block_error_check,       std::string(sample.place), 0};
    for (int o = 0; o <= setup.errors->order(); ++o) {
      key.order = o;
      Tally& tally = findings.rows[key];
      tally.unit = "block";
      ++tally.asked;
      const CageError& error = found.errors[o];
      // On the cage derivatives may not exist.
      const bool none =
          !found.is_input || (std::isnan(error.roundings) && found.truth_reached && found.is_on_cage && o > 0);
      if (none) ++tally.without_truth;
      else if (std::isnan(error.roundings)) ++tally.unreached;
      else tally.add(error.roundings, error.relative, sample.index, [&](double e) { return block_case(sample, e); });
    }
  }

  std::shared_ptr<const Cage> cage_;
  const CoordinateKind& kind_;
  BlockCampaignOptions options_;
  Lazy<Setup> setup_;
};

}  // namespace

int block_order(const CoordinateKind& kind, const CageCoordinates& coordinates) {
  const std::string evaluation = coordinates.evaluation();
  for (int order = coordinates.max_order(); order >= 0; --order)
    if (promise_for({block_error_check, kind.name, evaluation, "double", "*", order}).bound) return order;
  return coordinates.max_order();
}

int block_points(const CoordinateKind& kind, const Cage& cage, const BlockCampaignOptions& options) {
  const CageElements elements(cage, kind.keeps_quads, options.triangulation);
  // Milliseconds that the truth of an element takes.
  double cost = 0;
  for (std::size_t e = 0; e < elements.count(); ++e)
    for (const SummedBlock& block : kind.blocks) {
      const Formula& formula = *find_formula(elements.type(e).kind, block.kernel);
      cost += elements.type(e).splits.empty() ? (formula.shape.rows > 1 ? 4 : 1) : 30;
    }
  // Small cages carry the sweeps.
  const double budget = options.milliseconds * std::max(1.0, 72.0 / static_cast<double>(elements.count()));
  return std::clamp(static_cast<int>(budget / cost), 4, std::max(4, options.points));
}

BlockErrors::BlockErrors(const Cage& cage, const CoordinateKind& kind, std::string evaluation, Triangulation rule)
    : cage_(cage),
      kind_(kind),
      evaluation_(std::move(evaluation)),
      rule_(rule),
      coordinates_(cage, kind, evaluation_, rule),
      truths_(cage, kind, rule),
      order_(block_order(kind, coordinates_)) {}

BlockFinding BlockErrors::at(const CageSample& sample) const {
  if (sample.frame.is_own()) return finding_at(coordinates_, truths_, sample, order_);
  std::optional<Cage> there;
  try {
    there = framed(cage_, sample.frame);
    if (!accepts(kind_, *there)) return {.is_input = false};
  } catch (const InputError&) {
    // Far from the origin rounding may have flattened a face.
    return {.is_input = false};
  }
  return finding_at({*there, kind_, evaluation_, rule_}, {*there, kind_, rule_}, sample, order_);
}

std::unique_ptr<const Measurement> block_measurement(std::shared_ptr<const Cage> cage, const CoordinateKind& kind,
                                                     const BlockCampaignOptions& options) {
  return std::make_unique<BlockMeasurement>(std::move(cage), kind, options);
}

WorstCase block_case(const CageSample& sample, double error) {
  const Vec3<double>& shift = sample.frame.shift;
  return {error, sample.parameter, sample.index, {}, sample.point, {sample.frame.unit, shift[0], shift[1], shift[2]}};
}

CageSample block_sample(const WorstCase& worst) {
  const std::vector<double>& p = worst.parameters;
  if (p.size() != 4 || !std::ranges::all_of(p, [](double x) { return std::isfinite(x); }) || p[0] <= 0)
    throw InputError("a block error needs four parameters: the cage's unit, and where it is moved");
  return {.place = {},
          .parameter = worst.parameter,
          .frame = {{p[1], p[2], p[3]}, p[0]},
          .point = worst.point,
          .index = worst.sample};
}

}  // namespace cageproof::validation
