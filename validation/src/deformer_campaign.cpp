// SPDX-License-Identifier: MIT
#include "cageproof/validation/deformer_campaign.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/random_stream.h"
#include "cageproof/validation/constrained_checks.h"
#include "cageproof/validation/promise.h"
#include "cageproof/validation/verdicts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

// How far inside points lie, in cage sizes: next to the cage second derivatives of layers grow without bound.
constexpr double depth = 2e-2;

bool is_small(const Cage& cage, Triangulation rule) { return cage.parts(false, rule).elements.size() <= few_elements; }

// A method prepared with its defaults, which its variants share.
using Prepared = Lazy<std::shared_ptr<const deformation::Deformer<double>>>;

class DeformerMeasurement final : public Measurement {
 public:
  DeformerMeasurement(std::shared_ptr<const Cage> cage, DeformerVariant variant, const DeformerCampaignOptions& options,
                      std::shared_ptr<const Prepared> prepared)
      : cage_(std::move(cage)), variant_(std::move(variant)), options_(options), prepared_(std::move(prepared)) {}

  std::string name() const override {
    return fmt::format("{}, deformer {}, {}", cage_->name(), variant_.method->name, variant_.name);
  }
  int blocks() const override { return 1; }

  Findings measure(int) const override {
    const DeformerChecks checks(cage_, variant_, options_.triangulation, prepared_->get().get());
    const auto points = interior_points(*cage_, options_.triangulation, options_.seed, options_.points);
    Findings findings;
    for (const DeformerChecks::Question& question : checks.questions()) {
      const bool costly = question.pose == bent_pose;
      const auto asked = std::span(points).first(std::min<std::size_t>(points.size(), costly ? few() : points.size()));
      const auto errors = checks.ask(question, asked);
      for (std::size_t p = 0; p < asked.size(); ++p)
        for (int o = question.lowest_order; o <= question.highest_order; ++o)
          add(findings.rows[key_of(question, o)], errors[p][o], asked[p], p, checks);
    }
    return findings;
  }

 private:
  int few() const { return is_small(*cage_, options_.triangulation) ? options_.few_points : 1; }

  RowKey key_of(const DeformerChecks::Question& question, int order) const {
    return {RowKey::Section::Deformer,
            std::string(variant_.method->name),
            variant_.name,
            std::string(name_of(question.scalar)),
            cage_->name(),
            question.check,
            question.pose,
            order};
  }

  static void add(Tally& tally, const DeformerError& error, const Vec3<double>& point, std::size_t index,
                  const DeformerChecks& checks) {
    tally.unit = "cage sizes";
    ++tally.asked;
    if (std::isnan(error.error)) ++(checks.may_be_missing(point) ? tally.without_truth : tally.unreached);
    else tally.add(error.error, error.plain, index, [&](double e) { return WorstCase{e, 0, index, {}, point, {}, 2}; });
  }

  std::shared_ptr<const Cage> cage_;
  DeformerVariant variant_;
  DeformerCampaignOptions options_;
  std::shared_ptr<const Prepared> prepared_;
};

// A method that takes constraints. Questions of energies have one answer each.
class ConstrainedMeasurement final : public Measurement {
 public:
  ConstrainedMeasurement(std::shared_ptr<const Cage> cage, ConstrainedVariant variant,
                         const DeformerCampaignOptions& options)
      : cage_(std::move(cage)), variant_(std::move(variant)), options_(options) {}

  std::string name() const override {
    return fmt::format("{}, deformer {}, {}", cage_->name(), variant_.method->name, variant_.name);
  }
  int blocks() const override { return 1; }

  Findings measure(int) const override {
    const ConstrainedChecks checks(cage_, variant_, options_.triangulation);
    const auto points = interior_points(*cage_, options_.triangulation, options_.seed, options_.points);
    Findings findings;
    for (const ConstrainedChecks::Question& question : checks.questions()) {
      Tally& tally =
          findings.rows[{RowKey::Section::Deformer, std::string(variant_.method->name), variant_.name,
                         std::string(name_of(ScalarKind::Double)), cage_->name(), question.check, question.pose, 0}];
      tally.unit = question.check.starts_with("constrained") ? "cage sizes" : "energies";
      const std::vector<DeformerError> errors = checks.ask(question, points);
      for (std::size_t p = 0; p < errors.size(); ++p) {
        ++tally.asked;
        tally.add(errors[p].error, errors[p].plain, p,
                  [&](double e) { return WorstCase{e, 0, p, {}, points[p], {}, 2}; });
      }
    }
    return findings;
  }

 private:
  std::shared_ptr<const Cage> cage_;
  ConstrainedVariant variant_;
  DeformerCampaignOptions options_;
};

// Of small cages, whose constraints determine their maps.
void add_constrained(const std::shared_ptr<const Cage>& cage, const DeformerCampaignOptions& options,
                     Measurements& measurements) {
  if (!is_small(*cage, options.triangulation)) return;
  for (const deformation::ConstraintMethod& method : deformation::constraint_methods()) {
    if (!matches(options.methods, method.name) || !can_be_asked(method, *cage, options.triangulation)) continue;
    for (ConstrainedVariant& variant : variants_of(method))
      measurements.push_back(std::make_unique<ConstrainedMeasurement>(cage, std::move(variant), options));
  }
}

}  // namespace

const std::vector<std::string_view>& deformer_cage_names() {
  static const std::vector<std::string_view> names{"cube", "l-block", "twisted-bar", "square", "l-shape"};
  return names;
}

std::vector<Vec3<double>> interior_points(const Cage& cage, Triangulation rule, std::uint64_t seed, int count) {
  Vec3<double> low = cage.vertices().front(), high = low;
  for (const Vec3<double>& v : cage.vertices()) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const CageLocator locator(cage, rule);
  std::vector<Vec3<double>> points;
  for (int i = 0; i < count; ++i) {
    RandomStream random(seed, fmt::format("deformer/{}", cage.name()), i);
    // Thin cages have no points so deep.
    constexpr int tries = 20000;
    bool found = false;
    for (int t = 0; t < tries && !found; ++t) {
      Vec3<double> p = Vec3<double>::Zero();
      for (int c = 0; c < cage.dimension(); ++c) p[c] = random.uniform(low[c], high[c]);
      found = locator.distance(p) >= depth * cage.size() && locator.inside(p);
      if (found) points.push_back(p);
    }
    if (!found) break;
  }
  return points;
}

Measurements deformer_measurements(const std::shared_ptr<const Cage>& cage, const DeformerCampaignOptions& options) {
  Measurements measurements;
  if (interior_points(*cage, options.triangulation, options.seed, 1).empty()) return measurements;
  for (const deformation::DeformMethod& method : deformation::deform_methods()) {
    if (!matches(options.methods, method.name) || !deformation::why_refused(method, *cage).empty()) continue;
    std::vector<DeformerVariant> variants = variants_of(method);
    // All are asked on small cages, elsewhere every second and the default; of quads that are kept, whose layers take
    // several times as long, on the smallest alone.
    const bool few = coordinate_kind_named(method.kind).keeps_quads ? cage->faces().size() > 6
                                                                    : !is_small(*cage, options.triangulation);
    if (variants.size() > 2 && few) {
      std::size_t index = 0;
      std::erase_if(variants, [&](const DeformerVariant& v) { return index++ % 2 == 1 && !v.is_default; });
    }
    const auto prepared = std::make_shared<const Prepared>([cage, &method, rule = options.triangulation] {
      return deformation::prepare_deformer<double>(method, *cage, {.evaluation = {}, .triangulation = rule});
    });
    for (DeformerVariant& variant : variants)
      measurements.push_back(std::make_unique<DeformerMeasurement>(cage, std::move(variant), options, prepared));
  }
  add_constrained(cage, options, measurements);
  return measurements;
}

std::vector<ResultRow> run_deformer_campaign(const Cage& cage, const DeformerCampaignOptions& options) {
  return judged(measure_all(deformer_measurements(std::make_shared<const Cage>(cage), options), options.jobs).rows)
      .rows;
}

DeformerError deformer_error_at(const Cage& cage, const RowKey& row, const Vec3<double>& point, Triangulation rule) {
  const auto not_asked = [&] {
    return InputError(fmt::format("the check '{}' is not asked of {} posed '{}' in {}, order {}", row.check,
                                  row.subject, row.place, row.scalar, row.order));
  };
  if (const auto* method = deformation::find_constraint_method(row.subject)) {
    const ConstrainedChecks checks(std::make_shared<const Cage>(cage), variant_named(*method, row.evaluation), rule);
    for (const ConstrainedChecks::Question& question : checks.questions())
      if (question.check == row.check && question.pose == row.place && row.order == 0)
        return checks.ask(question, std::span(&point, 1)).front();
    throw not_asked();
  }
  const DeformerChecks checks(std::make_shared<const Cage>(cage),
                              variant_named(deformation::deform_method_named(row.subject), row.evaluation), rule);
  for (const DeformerChecks::Question& question : checks.questions())
    if (question.check == row.check && question.pose == row.place && name_of(question.scalar) == row.scalar &&
        question.lowest_order <= row.order && row.order <= question.highest_order)
      return checks.ask(question, std::span(&point, 1)).front()[row.order];
  throw not_asked();
}

}  // namespace cageproof::validation
