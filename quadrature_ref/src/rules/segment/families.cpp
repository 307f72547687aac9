// SPDX-License-Identifier: MIT
#include "../converging_sum.h"
#include "../rule_family.h"

#include "segment_rules.h"

namespace cageproof::quadrature_ref {

std::vector<RuleFamily> segment::families() {
  RuleFamily gauss{"gauss-<N>",
                   fixed_facts("Gauss-Legendre, N points"),
                   {"gauss-4", "gauss-8", "gauss-16"},
                   numbered("gauss-", 1, 256)};
  gauss.with_blocks([]<Scalar R>(const auto&... given) { integrate_gauss<R>(given...); });
  RuleFamily near_singular{"near-singular-<N>",
                           fixed_facts("graded towards the nearest point, N points per panel"),
                           {"near-singular-16"},
                           numbered("near-singular-", 2, 64)};
  near_singular.with_blocks([]<Scalar R>(const auto&... given) { integrate_near_singular<R>(given...); });
  RuleFamily adaptive{"adaptive",
                      adaptive_facts("bisection of graded intervals to a relative tolerance, or a refusal"),
                      {"adaptive"},
                      called("adaptive")};
  adaptive.with_points([]<Scalar R>(const auto& integrand, const Query<R>& query, Result<R>& result) {
    integrate_adaptive<R>(integrand, query, result);
  });
  RuleFamily multiprecision{"multiprecision", integral_facts(), {"multiprecision"}, called("multiprecision")};
  multiprecision.with_points([]<Scalar R>(const auto& integrand, const Query<R>& query, Result<R>& result) {
    integrate_multiprecision<R>(integrand, query, digits_wanted<R>(), result);
  });
  return {gauss, near_singular, adaptive, multiprecision};
}

}  // namespace cageproof::quadrature_ref
