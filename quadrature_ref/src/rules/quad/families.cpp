// SPDX-License-Identifier: MIT
#include "../converging_sum.h"
#include "../rule_family.h"

#include "quad_rules.h"

namespace cageproof::quadrature_ref {

std::vector<RuleFamily> quad::families() {
  RuleFamily gauss{"gauss-<N>",
                   fixed_facts("Gauss-Legendre in both parameters, N points per side"),
                   {"gauss-4", "gauss-8", "gauss-16"},
                   numbered("gauss-", 1, 256),
                   {"gauss-8", "gauss-32"}};
  gauss.with_blocks([]<Scalar R>(const auto&... given) { integrate_gauss<R>(given...); });
  RuleFamily midpoint{"midpoint-<N>",
                      fixed_facts("Riemann sum: the kernel at the middles of N x N cells"),
                      {"midpoint-10"},
                      numbered("midpoint-", 1, 512),
                      {"midpoint-10", "midpoint-100"}};
  midpoint.with_blocks([]<Scalar R>(const auto&... given) { integrate_midpoint<R>(given...); });
  RuleFamily adaptive{
      "adaptive",
      adaptive_facts("bisection of cells about the nearest point to a relative tolerance, or a refusal"),
      {"adaptive"},
      called("adaptive")};
  adaptive.with_points([]<Scalar R>(const auto& integrand, const Query<R>& query, Result<R>& result) {
    integrate_adaptive<R>(integrand, query, result);
  });
  RuleFamily multiprecision{"multiprecision", integral_facts(), {"multiprecision"}, called("multiprecision")};
  multiprecision.with_points([]<Scalar R>(const auto& integrand, const Query<R>& query, Result<R>& result) {
    integrate_multiprecision<R>(integrand, query, digits_wanted<R>(), result);
  });
  return {gauss, midpoint, adaptive, multiprecision};
}

}  // namespace cageproof::quadrature_ref
