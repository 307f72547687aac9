// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/triangle_rules.h"
#include "registration.h"

namespace cageproof::quadrature_ref {
namespace {

// Points a side of the rule of 3 n^2 points.
std::optional<int> three_quad_side(int points) {
  for (int n = 1; n <= 256; ++n)
    if (3 * n * n == points) return n;
  return std::nullopt;
}

}  // namespace

void register_triangle_rules(const std::string& formula, std::shared_ptr<const KernelSet> kernels) {
  const auto add = [&](std::string pattern, std::vector<std::string> standard, auto make) {
    EvaluationRegister::instance().add({formula, std::move(pattern), std::move(standard), std::move(make)});
  };
  using Made = std::optional<Evaluation>;
  add("gauss-<N>", {"gauss-4", "gauss-8", "gauss-16"}, [=](std::string_view name) -> Made {
    const auto n = number_after("gauss-", name);
    if (!n || *n > 256) return std::nullopt;
    return evaluation(formula, name, "Gauss-Legendre on the collapsed square, N points a side", kernels,
                      [n = *n]<Scalar R>(const Integrand& integrand, const Query<R>& query, Result<R>& result) {
                        integrate_gauss(integrand, n, query, result);
                      });
  });
  add("three-quad-<P>", {"three-quad-75", "three-quad-300"}, [=](std::string_view name) -> Made {
    const auto points = number_after("three-quad-", name);
    const auto n = points ? three_quad_side(*points) : std::nullopt;
    if (!n) return std::nullopt;
    return evaluation(formula, name, "Gauss-Legendre on three quads, P points in all [C23]", kernels,
                      [n = *n]<Scalar R>(const Integrand& integrand, const Query<R>& query, Result<R>& result) {
                        integrate_three_quads(integrand, n, query, result);
                      });
  });
  add("near-singular-<N>", {"near-singular-16"}, [=](std::string_view name) -> Made {
    const auto n = number_after("near-singular-", name);
    if (!n || *n < 2 || *n > 64) return std::nullopt;
    return evaluation(formula, name, "polar coordinates about the nearest point, N points a panel", kernels,
                      [n = *n]<Scalar R>(const Integrand& integrand, const Query<R>& query, Result<R>& result) {
                        integrate_near_singular(integrand, n, query, result);
                      });
  });
  add("adaptive", {"adaptive"}, [=](std::string_view name) -> Made {
    if (name != "adaptive") return std::nullopt;
    return evaluation(formula, name, "bisection of polar rectangles to a relative tolerance, or a refusal", kernels,
                      []<Scalar R>(const Integrand& integrand, const Query<R>& query, Result<R>& result) {
                        integrate_adaptive(integrand, query, result);
                      });
  });
  add("multiprecision", {"multiprecision"}, [=](std::string_view name) -> Made {
    if (name != "multiprecision") return std::nullopt;
    return evaluation(formula, name, "the integral to 30 digits or more, with the digits it stands behind", kernels,
                      []<Scalar R>(const Integrand& integrand, const Query<R>& query, Result<R>& result) {
                        integrate_multiprecision(integrand, query, result);
                      });
  });
}

}  // namespace cageproof::quadrature_ref
