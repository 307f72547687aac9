// SPDX-License-Identifier: MIT
// Registers the line form: `line_form`, which `closed_form` is another name of, and `line-<digits>` for those who want
// fewer digits sooner.
#include "instances.h"

#include "cageproof/core/catalogue/counted_name.h"
#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/catalogue/unknown_name.h"

namespace cageproof::adaptive_qmvc {
namespace {

constexpr std::string_view kFormula = "quad.mean_value";

// The digits of the integral that line_form asks for: a little more than a double holds, and in multiprecision enough
// for the differences that yardsticks and checks take of it.
template <Scalar R>
constexpr double own_digits() {
  return std::same_as<R, Mp50> ? 36 : std::same_as<R, Mp100> ? 48 : std::same_as<R, Mp200> ? 90 : 17;
}

// In float: the same in double, rounded.
void line_batch_in_double(const Batch<float>& batch, double digits, const BatchOutput<float>& output) {
  std::array<Vec3<double>, 4> corners;
  for (int k = 0; k < 4; ++k) corners[k] = convert<double>(batch.corners[k]);
  WeightTensors<double> wide;
  WeightTensors<float> weights;
  BatchOutput<double> stored{.tensors = {wide.value.data(), wide.gradient.data(), wide.hessian.data()}};
  Statement statement;
  stored.statements = &statement;
  for (std::size_t p = 0; p < batch.points.size(); ++p) {
    const Vec3<double> point = convert<double>(batch.points[p]);
    line_batch<double>({corners, {&point, 1}, batch.order}, digits, stored);
    output.state(p, statement);
    for (int o = 0; o <= batch.order; ++o) {
      std::ranges::transform(wide.of(o), weights.of(o).begin(), [](double x) { return static_cast<float>(x); });
      output.put(p, o, weights.of(o));
    }
  }
}

void set_functions(Evaluation& made, std::optional<double> digits) {
  for (const ScalarKind kind : scalar_kinds)
    with_scalar(kind, [&]<Scalar R>() {
      made.set_batch<R>([digits](const Batch<R>& batch, const BatchOutput<R>& output) {
        const double asked = digits.value_or(own_digits<R>());
        if constexpr (std::same_as<R, float>) line_batch_in_double(batch, asked, output);
        else line_batch<R>(batch, asked, output);
      });
    });
}

EvaluationFamily recommended() {
  EvaluationFamily family =
      single_family(kFormula, "line_form",
                    {.description = "line form: elementary along lines, Gauss-Legendre across them",
                     .role = Role::Recommended,
                     .cost = CostClass::Direct,
                     .substitutes = {"line-36", "line-46", "line-14"}},
                    true, [](Evaluation& made) { set_functions(made, std::nullopt); });
  family.alias = "closed_form";
  return family;
}

const RegisterEvaluation line_form{recommended()};

const RegisterEvaluation line{
    {std::string(kFormula),
     "line-<digits>",
     Role::Rule,
     {"line-12"},
     [](std::string_view name) -> std::optional<Evaluation> {
       const auto digits = number_after("line-", name);
       if (!digits || *digits < 2 || *digits > 90) return std::nullopt;
       Evaluation made(kFormula, name,
                       {.description = "line form to that many digits", .role = Role::Rule, .cost = CostClass::Direct});
       set_functions(made, *digits);
       return made;
     },
     {},
     {"line-12"}}};

const bool line_digits = (state_range("line-<digits>", "digits from 2 to 90"), true);

}  // namespace
}  // namespace cageproof::adaptive_qmvc
