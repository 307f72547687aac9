// SPDX-License-Identifier: MIT
#include "block_campaign.h"

#include "cageproof/core/geometry/box.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/lazy.h"
#include "cageproof/validation/promise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

// Number of points that an evaluation gets at once, the sample's among them: as many as the widest vectors hold.
constexpr std::size_t block_of_points = 16;

// The sample's point among generic ones.
std::vector<Vec3<double>> among_others(const CageElements& elements, const CageSample& sample) {
  const auto [low, high] = box_of(elements.vertices());
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

std::array<Finding, 3> findings_at(const CageCoordinates& coordinates, const BlockTruths& truths,
                                   const CageSample& sample, int order) {
  std::array<Finding, 3> found;
  const auto truth = truths.at(sample.point, order);
  std::array<CageError, 3> errors;
  if (truth) {
    errors = block_errors(coordinates.at<double>(sample.point, order), *truth);
    const auto in_block = block_errors(found_among(coordinates, sample, order), *truth);
    for (int o = 0; o <= order; ++o)
      if (in_block[o].roundings > errors[o].roundings) errors[o] = in_block[o];
  }
  // On the cage derivatives may not exist.
  const bool may_lack = truth && !coordinates.elements().touching(sample.point).empty();
  for (int o = 0; o <= order; ++o) {
    if (!std::isnan(errors[o].roundings))
      found[o] = {Finding::Status::Measured, errors[o].roundings, errors[o].relative};
    else found[o].status = may_lack && o > 0 ? Finding::Status::NoTruth : Finding::Status::Unreached;
  }
  return found;
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

  std::vector<RowKey> rows() const override {
    std::vector<RowKey> rows;
    for (const std::string_view place : cage_places()) add_rows_of(setup_.get().errors->question(place), rows);
    return rows;
  }

  PartialResult measure(int block) const override {
    const Setup& setup = setup_.get();
    PartialResult gathered;
    for (std::size_t i = block; i < setup.samples.size(); i += blocks()) {
      const BlockAt at{setup.samples[i]};
      record(setup.errors->question(at.sample.place), at, gathered.rows);
    }
    return gathered;
  }

 private:
  struct Setup {
    std::shared_ptr<const BlockErrors> errors;
    std::vector<CageSample> samples;
  };

  int count() const { return block_points(kind_, *cage_, options_); }

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

std::array<Finding, 3> BlockErrors::at(const CageSample& sample) const {
  if (sample.frame.is_own()) return findings_at(coordinates_, truths_, sample, order_);
  std::array<Finding, 3> none;
  std::fill_n(none.begin(), order_ + 1, Finding{Finding::Status::NoTruth});
  std::optional<Cage> there;
  try {
    there = framed(cage_, sample.frame);
    if (!accepts(kind_, *there)) return none;
  } catch (const InputError&) {
    // Far from the origin rounding may have flattened a face.
    return none;
  }
  return findings_at({*there, kind_, evaluation_, rule_}, {*there, kind_, rule_}, sample, order_);
}

Question<BlockAt> BlockErrors::question(std::string_view place) const {
  Question<BlockAt> question;
  question.key = {RowKey::Section::Cage, std::string(kind_.name), coordinates_.evaluation(), "double",
                  cage_.name(),          block_error_check,       std::string(place),        0};
  question.unit = "block";
  question.orders = {0, order_};
  question.ask = [this](const BlockAt& asked) { return at(asked.sample); };
  return question;
}

std::unique_ptr<const Measurement> block_measurement(std::shared_ptr<const Cage> cage, const CoordinateKind& kind,
                                                     const BlockCampaignOptions& options) {
  return std::make_unique<BlockMeasurement>(std::move(cage), kind, options);
}

WorstCase BlockAt::case_of(const Finding& finding, int /*order*/) const {
  WorstCase worst{finding.error, sample.parameter, sample.index, {}, sample.point};
  worst.frame = sample.frame;
  return worst;
}

CageSample block_sample(const WorstCase& worst) {
  return {.place = {}, .parameter = worst.parameter, .frame = worst.frame, .point = worst.point, .index = worst.sample};
}

}  // namespace cageproof::validation
