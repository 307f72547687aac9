// SPDX-License-Identifier: MIT
// Variational deformation, as users name it.
#include "variational.h"

namespace cageproof::deformation {
namespace {

std::shared_ptr<const ConstrainedDeformer<double>> prepare(const Cage& cage, const Constraints& constraints,
                                                           const DeformOptions& options) {
  // In the order that they are registered in.
  const std::vector<double>& p = options.parameters;
  return std::make_shared<Variational<double>>(
      cage, constraints,
      VariationalOptions{.subspace = static_cast<Subspace>(static_cast<int>(p[0])),
                         .nearest = p[1] == 0 ? Nearest::Rotation : Nearest::Similarity,
                         .nu = p[7],
                         .alpha = p[2],
                         .beta = p[3],
                         .gamma = p[4],
                         .steps = static_cast<int>(p[5]),
                         .tolerance = p[6],
                         .evaluation = options.evaluation,
                         .triangulation = options.triangulation});
}

KindParameter weight(std::string_view name, double preset, std::string_view meaning) {
  return {{.name = name, .preset = preset, .lowest = kBelowZero, .highest = 1e300}, meaning};
}

const VariationalOptions presets;
const RegisterConstraintMethod variational{
    {.name = "variational",
     .source = "[T24] Section 4.2, Eq 37-40, and Section 5",
     .keeps = "rigid targets (rotations=similar: similar ones)",
     .parameters = {{{.name = "subspace", .preset = 1, .lowest = -1, .highest = 3, .whole = true},
                     "of maps",
                     {"harmonic", "biharmonic", "elastic"}},
                    {{.name = "rotations", .preset = 0, .lowest = -1, .highest = 2, .whole = true},
                     "what Jacobians at rotation points are drawn to",
                     {"rigid", "similar"}},
                    weight("alpha", presets.alpha, "weight of orientations; has the unit of an area"),
                    weight("beta", presets.beta, "weight of rotations, the same; the larger, the slower"),
                    weight("gamma", presets.gamma, "weight of Hessians; has the unit of the square of an area"),
                    {{.name = "steps",
                      .preset = static_cast<double>(presets.steps),
                      .lowest = 0,
                      .highest = 1e6,
                      .includes_highest = true,
                      .whole = true},
                     "at most"},
                    {{.name = "tolerance", .preset = presets.tolerance, .lowest = kBelowZero, .highest = 1},
                     "steps end when one lowers the energy by no more than this part of it"},
                    {{.name = "nu", .preset = presets.nu, .lowest = -1, .highest = 0.5, .includes_infinity = true},
                     "Poisson's ratio, of subspace=elastic and of --stress"}},
     .prepare = prepare}};

}  // namespace
}  // namespace cageproof::deformation
