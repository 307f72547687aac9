// SPDX-License-Identifier: MIT
// Registers the line form of the potentials: `line_form`, which `closed_form` is another name of, and `line-<digits>`.
#include "quad/potentials/potential_form.h"

#include "cageproof/core/catalogue/evaluation.h"
#include "line_rule.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cageproof::adaptive_qmvc {
namespace {

struct Row {
  std::string_view formula;
  Potential potential;
};

constexpr std::array rows{Row{"quad.single_layer", Potential::SingleLayer},
                          Row{"quad.double_layer", Potential::DoubleLayer},
                          Row{"quad.biharmonic_single_layer", Potential::BiharmonicSingleLayer},
                          Row{"quad.biharmonic_double_layer", Potential::BiharmonicDoubleLayer},
                          Row{"quad.kelvin_displacement", Potential::KelvinDisplacement},
                          Row{"quad.kelvin_traction", Potential::KelvinTraction}};

// Factors of the kernel's two parts: a - b and b, or mu (a - 2b) and 6 mu b, for a = 1/(4 pi mu) and
// b = a/(4 (1 - nu)). a - 2b is computed as (1/2 - nu)/(1 - nu) times a, because the difference cancels in a medium
// that is nearly incompressible.
template <Scalar R>
std::array<R, 2> parameters_of(Potential potential, std::span<const R> given) {
  using std::isinf;
  const R sphere = 4 * pi<R>();
  if (potential != Potential::KelvinDisplacement && potential != Potential::KelvinTraction)
    return {R(1) / sphere, R(1) / sphere};
  const R &mu = given[0], &nu = given[1];
  const R bulk = isinf(nu) ? R(0) : R(1 / (4 * (1 - nu)));
  if (potential == Potential::KelvinDisplacement) {
    const R a = 1 / (sphere * mu);
    return {isinf(nu) ? a : R(a * ((R(3) / 4 - nu) / (1 - nu))), R(a * bulk)};
  }
  return {isinf(nu) ? R(1 / sphere) : R((R(1) / 2 - nu) / (1 - nu) / sphere), R(6 * bulk / sphere)};
}

template <Scalar R>
void line_batch(Potential potential, const Batch<R>& batch, std::optional<double> digits,
                const BatchOutput<R>& output) {
  if constexpr (std::same_as<R, float>) {
    // The same in double, rounded.
    std::array<Vec3<double>, 4> corners;
    for (int k = 0; k < 4; ++k) corners[k] = convert<double>(batch.corners[k]);
    std::array<double, 2> given{1, 0};
    std::ranges::copy(batch.parameters, given.begin());
    const PotentialTask<double> task{potential, batch.order, digits.value_or(own_digits<double>()),
                                     parameters_of<double>(potential, given), batch.finite_part};
    PotentialTensors<double> wide;
    std::vector<float> narrow;
    for (std::size_t p = 0; p < batch.points.size(); ++p) {
      output.state(p, potential_form<double>(corners, convert<double>(batch.points[p]), task, wide));
      for (int o = 0; o <= batch.order; ++o) {
        narrow.assign(wide.of[o].begin(), wide.of[o].end());
        output.put(p, o, narrow);
      }
    }
  } else {
    const PotentialTask<R> task{potential, batch.order, digits.value_or(own_digits<R>()),
                                parameters_of<R>(potential, batch.parameters), batch.finite_part};
    PotentialTensors<R> tensors;
    for (std::size_t p = 0; p < batch.points.size(); ++p) {
      output.state(p, potential_form<R>(batch.corners, batch.points[p], task, tensors));
      for (int o = 0; o <= batch.order; ++o) output.put(p, o, tensors.of[o]);
    }
  }
}

void set_functions(Evaluation& made, Potential potential, std::optional<double> digits) {
  for (const ScalarKind kind : scalar_kinds)
    with_scalar(kind, [&]<Scalar R>() {
      made.set_batch<R>([potential, digits](const Batch<R>& batch, const BatchOutput<R>& output) {
        line_batch<R>(potential, batch, digits, output);
      });
    });
}

EvaluationFamily recommended(const Row& row) {
  EvaluationFamily family =
      single_family(row.formula, "line_form",
                    {.description = "line form: elementary along lines, Gauss-Legendre across them",
                     .role = Role::Recommended,
                     .cost = CostClass::Direct,
                     .substitutes = {"line-36", "line-41", "line-14"}},
                    true, [row](Evaluation& made) { set_functions(made, row.potential, std::nullopt); });
  family.alias = "closed_form";
  return family;
}

const bool registered = [] {
  for (const Row& row : rows) {
    const RegisterEvaluation line_form{recommended(row)};
    const RegisterEvaluation line{line_rule(
        row.formula, "line form to that many digits",
        [row](Evaluation& made, std::optional<double> digits) { set_functions(made, row.potential, digits); })};
  }
  return true;
}();

}  // namespace
}  // namespace cageproof::adaptive_qmvc
