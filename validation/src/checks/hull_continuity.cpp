// SPDX-License-Identifier: MIT
#include "checks/hull_continuity.h"

#include "cageproof/adaptive_qmvc/quad/mean_value/continuity.h"
#include "cageproof/validation/promise.h"
#include "cageproof/validation/question.h"

namespace cageproof::validation {
namespace {

// How far the third corner is lifted out of the plane of the others: a block each.
constexpr std::array lifts{0.1, 0.3, 0.6};
constexpr int points = 64;

// A jump is of two points and a normal: no worst case could be run again from what is stored of one.
struct HullAt {
  static constexpr bool is_stored = false;
  adaptive_qmvc::Jump jump;
  std::uint64_t index;

  std::uint64_t number() const { return index; }
};

class HullMeasurement final : public Measurement {
 public:
  HullMeasurement(Evaluation evaluation, std::uint64_t seed) : evaluation_(std::move(evaluation)), seed_(seed) {
    question_.key = {RowKey::Section::Element,
                     std::string(hull_formula),
                     evaluation_.name(),
                     "double",
                     std::string(hull_regime),
                     "hull_jump",
                     "",
                     0};
    question_.unit = "relative";
    question_.orders = {0, 1};
    question_.ask = [](const HullAt& at) {
      using enum Finding::Status;
      return std::array{Finding{Measured, at.jump.value, at.jump.value},
                        Finding{Measured, at.jump.derivative, at.jump.derivative}, Finding{}};
    };
  }

  std::string name() const override { return "hull, " + evaluation_.name(); }
  int blocks() const override { return static_cast<int>(lifts.size()); }

  std::vector<RowKey> rows() const override {
    std::vector<RowKey> rows;
    add_rows_of(question_, rows);
    return rows;
  }

  PartialResult measure(int block) const override {
    const Quad<double> q{Vec3<double>(0, 0, 0), Vec3<double>(1, 0, 0), Vec3<double>(1, 1, lifts[block]),
                         Vec3<double>(0, 1, 0)};
    PartialResult gathered;
    std::uint64_t index = static_cast<std::uint64_t>(block) * points;
    for (const auto& jump : adaptive_qmvc::study_continuity(evaluation_, q, points, seed_).hull)
      record(question_, HullAt{jump, index++}, gathered.rows);
    return gathered;
  }

 private:
  Evaluation evaluation_;
  std::uint64_t seed_;
  Question<HullAt> question_;
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
