// SPDX-License-Identifier: MIT
#include "kernel.h"

#include "cageproof/core/catalogue/evaluation.h"

#include <stdexcept>

namespace cageproof::quadrature_ref::certified {
namespace {

QuadFactor normal(int i) { return static_cast<QuadFactor>(static_cast<int>(QuadFactor::NormalX) + i); }

void add_to(QuadPolynomial& sum, QuadFactor factor, const Polynomial& polynomial) {
  sum[factor] = sum[factor] + polynomial;
}

// d (N.x) = -N_i.
QuadPolynomial derivative_of(const QuadPolynomial& sum, int i) {
  QuadPolynomial derivative;
  for (const auto& [factor, polynomial] : sum) {
    add_to(derivative, factor, polynomial.derivative(i));
    if (factor == QuadFactor::Height) add_to(derivative, normal(i), (-1) * polynomial);
  }
  return derivative;
}

Real part_of_pi(int numerator, int denominator) { return Real(numerator) / (pi_ball() * denominator); }

QuadKernel::Constants fixed(int numerator, int denominator) {
  return [=](const std::vector<Real>&) { return std::vector{part_of_pi(numerator, denominator)}; };
}

// 1/(4 (1 - nu)), zero in the limits nu = +-infinity.
Real beta(const Real& nu) { return nu.is_finite() ? Real(1) / ((Real(1) - nu) * 4) : Real(0); }
// 1 - 2 beta = (1 - 2 nu)/(2 (1 - nu)): exactly zero at nu = 1/2.
Real one_less_two_beta(const Real& nu) { return nu.is_finite() ? (Real(1) - nu * 2) / ((Real(1) - nu) * 2) : Real(1); }

// (a - b)/r I + b x x'/r^3, a = 1/(4 pi mu), b = a beta. Constants: a - b, b.
std::vector<QuadPolynomial> displacement_on_quads() {
  std::vector<QuadPolynomial> matrix(9);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      QuadPolynomial& entry = matrix[3 * i + j];
      add_to(entry, QuadFactor::One, constant(2) * coordinate(i) * coordinate(j) * inverse_distance(3));
      if (i == j) add_to(entry, QuadFactor::One, constant(1) * inverse_distance(1));
    }
  return matrix;
}

// mu ((a - 2b)(x.N I + N x' - x N')/r^3 + 6b x.N x x'/r^5). Constants: mu (a - 2b), mu b.
std::vector<QuadPolynomial> traction_on_quads() {
  std::vector<QuadPolynomial> matrix(9);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      QuadPolynomial& entry = matrix[3 * i + j];
      add_to(entry, QuadFactor::Height, 6 * (constant(2) * coordinate(i) * coordinate(j) * inverse_distance(5)));
      if (i == j) add_to(entry, QuadFactor::Height, constant(1) * inverse_distance(3));
      if (i == j) continue;  // N_i x_i - x_i N_i
      add_to(entry, normal(i), constant(1) * coordinate(j) * inverse_distance(3));
      add_to(entry, normal(j), (-1) * (constant(1) * coordinate(i) * inverse_distance(3)));
    }
  return matrix;
}

std::vector<QuadKernel> typed_in() {
  const auto one = [](const Polynomial& p) { return std::vector{QuadPolynomial{{QuadFactor::One, p}}}; };
  const auto height = [](const Polynomial& p) { return std::vector{QuadPolynomial{{QuadFactor::Height, p}}}; };
  const auto over_r = [](int q) { return constant(1) * inverse_distance(q); };
  std::vector<QuadKernel> all;
  const auto add = [&](std::string_view name, const std::vector<QuadPolynomial>& components,
                       QuadKernel::Constants constants) {
    all.emplace_back(formula_named(name), components, std::move(constants));
  };
  add("quad.single_layer", one(over_r(1)), fixed(1, 4));
  add("quad.double_layer", height(over_r(3)), fixed(1, 4));
  const auto none = [](const std::vector<Real>&) { return std::vector<Real>{}; };
  add("quad.solid_angle", height(inverse_distance(3)), none);
  add("quad.mean_value", height(inverse_distance(4)), none);
  add("quad.biharmonic_single_layer", one(over_r(-1)), fixed(1, 8));
  add("quad.biharmonic_double_layer", height(over_r(1)), fixed(-1, 8));
  add("quad.kelvin_displacement", displacement_on_quads(), [](const std::vector<Real>& p) {
    const Real a = part_of_pi(1, 4) / p[0], b = a * beta(p[1]);
    return std::vector{a - b, b};
  });
  add("quad.kelvin_traction", traction_on_quads(), [](const std::vector<Real>& p) {
    const Real mu_a = part_of_pi(1, 4);
    return std::vector{mu_a * one_less_two_beta(p[1]), mu_a * beta(p[1])};
  });
  return all;
}

}  // namespace

QuadKernel::QuadKernel(const Formula& formula, const std::vector<QuadPolynomial>& components, Constants constants)
    : formula_(&formula), constants_(std::move(constants)) {
  for (const QuadPolynomial& component : components) {
    auto& gradient = terms_[1].emplace_back();
    for (int i = 0; i < 3; ++i) gradient.push_back(derivative_of(component, i));
    auto& hessian = terms_[2].emplace_back();
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) hessian.push_back(derivative_of(gradient[i], j));
    terms_[0].push_back({component});
  }
}

const std::vector<QuadKernel>& quad_kernels() {
  static const std::vector<QuadKernel> all = typed_in();
  return all;
}

const QuadKernel& quad_kernel_of(std::string_view formula) {
  for (const QuadKernel& kernel : quad_kernels())
    if (kernel.formula().name == formula) return kernel;
  throw std::out_of_range("no definition of " + std::string(formula));
}

}  // namespace cageproof::quadrature_ref::certified
