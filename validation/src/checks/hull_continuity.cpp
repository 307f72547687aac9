// SPDX-License-Identifier: MIT
#include "checks/hull_continuity.h"

#include "cageproof/adaptive_qmvc/quad/mean_value/continuity.h"
#include "cageproof/validation/promise.h"

namespace cageproof::validation {
namespace {

// How far the third corner is lifted out of the plane of the others: a block each.
constexpr std::array lifts{0.1, 0.3, 0.6};
constexpr int points = 64;

class HullMeasurement final : public Measurement {
 public:
  HullMeasurement(Evaluation evaluation, std::uint64_t seed) : evaluation_(std::move(evaluation)), seed_(seed) {}

  std::string name() const override { return "hull, " + evaluation_.name(); }
  int blocks() const override { return static_cast<int>(lifts.size()); }

  Findings measure(int block) const override {
    const Quad<double> q{Vec3<double>(0, 0, 0), Vec3<double>(1, 0, 0), Vec3<double>(1, 1, lifts[block]),
                         Vec3<double>(0, 1, 0)};
    Findings findings;
    for (const int order : {0, 1}) tally_of(findings, order).asked = points;
    for (const auto& jump : adaptive_qmvc::study_continuity(evaluation_, q, points, seed_).hull) {
      add(findings, 0, jump.value);
      add(findings, 1, jump.derivative);
    }
    return findings;
  }

 private:
  Tally& tally_of(Findings& findings, int order) const {
    Tally& tally = findings.rows[{RowKey::Section::Element, std::string(hull_formula), evaluation_.name(), "double",
                                  std::string(hull_regime), "hull_jump", "", order}];
    tally.unit = "relative";
    return tally;
  }

  // A jump is of two points and a normal: no worst case could be run again from what is stored of one.
  void add(Findings& findings, int order, double jump) const {
    Tally& tally = tally_of(findings, order);
    tally.errors.add(jump);
    tally.max_relative = std::max(tally.max_relative, jump);
  }

  Evaluation evaluation_;
  std::uint64_t seed_;
};

}  // namespace

Measurements hull_measurements(const std::string& evaluations, std::uint64_t seed) {
  Measurements measurements;
  for (const Role role : {Role::Recommended, Role::Scheme}) {
    const auto evaluation = EvaluationRegister::instance().with_role(hull_formula, role);
    if (evaluation && matches_evaluation(evaluations, *evaluation))
      measurements.push_back(std::make_unique<HullMeasurement>(*evaluation, seed));
  }
  return measurements;
}

}  // namespace cageproof::validation
