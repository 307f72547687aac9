// SPDX-License-Identifier: MIT
// Deformation that keeps thickness, as users name it.
#include "../constraint_checks.h"
#include "../thinness.h"
#include "thickness.h"

namespace cageproof::deformation {
namespace {

// Solved in 50 digits, images in double.
class WideThickness final : public ConstrainedDeformer<double> {
 public:
  WideThickness(const Cage& cage, const Constraints& constraints, const ThicknessOptions& options)
      : wide_(cage, constraints, options), targets_(targets_of(constraints)) {}

  const CageCoordinates& coordinates() const override { return wide_.coordinates(); }
  DeformationReport prepared() const override {
    DeformationReport report = wide_.prepared();
    report.figures.emplace_back("digits of systems", 50);
    return report;
  }
  std::unique_ptr<const Posed<double>> pose(const StepWatcher& watch) const override {
    return wide_.pose_in<double>(targets_, watch);
  }
  std::unique_ptr<const Posed<double>> pose_to(const std::vector<Vec3<double>>& targets,
                                               const StepWatcher& watch) const override {
    return wide_.pose_in<double>(targets, watch);
  }

 private:
  Thickness<Mp50> wide_;
  std::vector<Vec3<double>> targets_;
};

// Second derivatives at a short edge are larger than elsewhere by the square of its share of the others: where it is
// shorter than a hundredth, double has fewer digits left than steps need to end.
constexpr double most_times_in_double = 64;

bool takes_50_digits(const Cage& cage, const ThicknessOptions& options) {
  const CageElements elements(cage, false, Triangulation::Shortest);
  if (cage.dimension() != 2 || thinness_of(elements).times <= most_times_in_double) return false;
  const CageCoordinates coordinates(cage, coordinate_kind_named("biharmonic_boundary"),
                                    {.evaluation = options.evaluation, .parameters = options.coordinates});
  return coordinates.is_exact_in(ScalarKind::Digits50) && coordinates.is_prompt_in(ScalarKind::Digits50);
}

std::shared_ptr<const ConstrainedDeformer<double>> prepare_thickness(const Cage& cage, const Constraints& constraints,
                                                                     const DeformOptions& options) {
  // In the order that they are registered in, the kind's last.
  const std::vector<double>& p = options.parameters;
  const ThicknessOptions chosen{.samples = static_cast<int>(p[0]),
                                .steps = static_cast<int>(p[1]),
                                .evaluation = options.evaluation,
                                .coordinates = {p.begin() + 2, p.end()}};
  if (takes_50_digits(cage, chosen)) return std::make_shared<WideThickness>(cage, constraints, chosen);
  return std::make_shared<Thickness<double>>(cage, constraints, chosen);
}

const ThicknessOptions thickness_presets;
const RegisterConstraintMethod thickness{{.name = "thickness",
                                          .source = "[W12] Section 5.4, Eq 22 as a sum",
                                          .keeps = "rigid targets",
                                          .parameters = {{{.name = "samples",
                                                           .preset = static_cast<double>(thickness_presets.samples),
                                                           .lowest = 0,
                                                           .highest = 64,
                                                           .includes_highest = true,
                                                           .whole = true},
                                                          "of the energy on each edge, which are part of the method"},
                                                         {{.name = "steps",
                                                           .preset = static_cast<double>(thickness_presets.steps),
                                                           .lowest = 0,
                                                           .highest = 1e6,
                                                           .includes_highest = true,
                                                           .whole = true},
                                                          "at most"}},
                                          .kind = "biharmonic_boundary",
                                          .dimension = 2,
                                          .positions_alone = true,
                                          .prepare = prepare_thickness}};

}  // namespace
}  // namespace cageproof::deformation
