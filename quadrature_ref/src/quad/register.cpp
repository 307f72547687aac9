// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/quad_rules.h"
#include "../rules/registration.h"

namespace cageproof::quadrature_ref {

void register_quad_rules(const std::string& formula, std::shared_ptr<const KernelSet> kernels) {
  const auto add = [&](std::string pattern, std::vector<std::string> standard, auto make) {
    EvaluationRegister::instance().add({formula, std::move(pattern), std::move(standard), std::move(make)});
  };
  using Made = std::optional<Evaluation>;
  add("gauss-<N>", {"gauss-4", "gauss-8", "gauss-16"}, [=](std::string_view name) -> Made {
    const auto n = number_after("gauss-", name);
    if (!n || *n > 256) return std::nullopt;
    return evaluation(formula, name, "Gauss-Legendre in both parameters, N points a side", kernels,
                      [n = *n]<Scalar R>(const Integrand& integrand, const Query<R>& query, Result<R>& result) {
                        integrate_quad_gauss(integrand, n, query, result);
                      });
  });
  add("adaptive", {"adaptive"}, [=](std::string_view name) -> Made {
    if (name != "adaptive") return std::nullopt;
    return evaluation(formula, name, "bisection of cells about the nearest point to a relative tolerance, or a refusal",
                      kernels, []<Scalar R>(const Integrand& integrand, const Query<R>& query, Result<R>& result) {
                        integrate_quad_adaptive(integrand, query, result);
                      });
  });
  add("multiprecision", {"multiprecision"}, [=](std::string_view name) -> Made {
    if (name != "multiprecision") return std::nullopt;
    return evaluation(formula, name, "the integral to 30 digits or more, with the digits it stands behind", kernels,
                      []<Scalar R>(const Integrand& integrand, const Query<R>& query, Result<R>& result) {
                        integrate_quad_multiprecision(integrand, query, result);
                      });
  });
}

}  // namespace cageproof::quadrature_ref
