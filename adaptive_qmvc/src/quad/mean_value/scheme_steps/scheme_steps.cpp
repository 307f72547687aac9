// SPDX-License-Identifier: MIT
// Registers the steps of `riemann-<n>` and its variants.
#include "scheme_steps.h"
#include "quad/mean_value/riemann/variants.h"

namespace cageproof::adaptive_qmvc {
namespace {

StepFunctions steps_with(int n, const PoleGuard& guard) {
  StepFunctions functions;
  for (const ScalarKind kind : scalar_kinds)
    with_scalar(kind, [&]<Scalar R>() {
      functions.of<R>() = [n, guard](const Query<R>& query) {
        const Quad<R> q{query.corners[0], query.corners[1], query.corners[2], query.corners[3]};
        return SchemeSteps<R>(q, query.point, n, guard).all();
      };
    });
  return functions;
}

RegisterSteps steps_of_variant(const SchemeVariant& variant) {
  return {"quad.mean_value", std::string("riemann-<n>") + variant.suffix,
          [&variant](std::string_view name) -> std::optional<StepFunctions> {
            const auto n = count_in("riemann", variant.suffix, name);
            if (!n) return std::nullopt;
            return steps_with(*n, guard_of(variant));
          }};
}

const RegisterSteps scheme{steps_of_variant(kSchemeVariants[0])}, uncorrected{steps_of_variant(kSchemeVariants[1])},
    unguarded{steps_of_variant(kSchemeVariants[2])};

}  // namespace
}  // namespace cageproof::adaptive_qmvc
