// SPDX-License-Identifier: MIT
#include "../converging_sum.h"
#include "../rule_family.h"

#include "triangle_rules.h"

namespace cageproof::quadrature_ref {
namespace {

// Points a side of the rule of 3 n^2 points.
std::optional<int> three_quad_side(std::string_view name) {
  const auto points = number_after("three-quad-", name);
  for (int n = 1; points && n <= 256; ++n)
    if (3 * n * n == *points) return n;
  return std::nullopt;
}

}  // namespace

std::vector<RuleFamily> triangle::families() {
  RuleFamily gauss{"gauss-<N>",
                   fixed_facts("Gauss-Legendre on the collapsed square, N points per side"),
                   {"gauss-4", "gauss-8", "gauss-16"},
                   numbered("gauss-", 1, 256)};
  gauss.with_blocks([]<Scalar R>(const auto&... given) { integrate_gauss<R>(given...); });
  RuleFamily three_quads{"three-quad-<P>",
                         fixed_facts("Gauss-Legendre on three quads, P points in all [C23]"),
                         {"three-quad-75", "three-quad-300"},
                         {three_quad_side, "P = 3 n^2, as 75 and 300, n from 1 to 256"},
                         {"three-quad-75", "three-quad-300", "three-quad-1200", "three-quad-7500"}};
  three_quads.with_blocks([]<Scalar R>(const auto&... given) { integrate_three_quads<R>(given...); });
  RuleFamily near_singular{"near-singular-<N>",
                           fixed_facts("polar coordinates about the nearest point, N points per panel"),
                           {"near-singular-16"},
                           numbered("near-singular-", 2, 64)};
  near_singular.with_blocks([]<Scalar R>(const auto&... given) { integrate_near_singular<R>(given...); });
  RuleFamily adaptive{"adaptive",
                      adaptive_facts("bisection of polar rectangles to a relative tolerance, or a refusal"),
                      {"adaptive"},
                      called("adaptive")};
  adaptive.with_points([]<Scalar R>(const auto& integrand, const Query<R>& query, Result<R>& result) {
    integrate_adaptive<R>(integrand, query, result);
  });
  RuleFamily multiprecision{"multiprecision", integral_facts(), {"multiprecision"}, called("multiprecision")};
  multiprecision.with_points([]<Scalar R>(const auto& integrand, const Query<R>& query, Result<R>& result) {
    integrate_multiprecision<R>(integrand, query, digits_wanted<R>(), result);
  });
  return {gauss, three_quads, near_singular, adaptive, multiprecision};
}

}  // namespace cageproof::quadrature_ref
