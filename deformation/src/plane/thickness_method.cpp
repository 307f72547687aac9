// SPDX-License-Identifier: MIT
// Deformation that keeps thickness, as users name it.
#include "thickness.h"

namespace cageproof::deformation {
namespace {

std::shared_ptr<const ConstrainedDeformer<double>> prepare_thickness(const Cage& cage, const Constraints& constraints,
                                                                     const DeformOptions& options) {
  // In the order that they are registered in, the kind's last.
  const std::vector<double>& p = options.parameters;
  return std::make_shared<Thickness<double>>(cage, constraints,
                                             ThicknessOptions{.samples = static_cast<int>(p[0]),
                                                              .steps = static_cast<int>(p[1]),
                                                              .evaluation = options.evaluation,
                                                              .coordinates = {p.begin() + 2, p.end()}});
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
