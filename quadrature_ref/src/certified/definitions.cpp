// SPDX-License-Identifier: MIT
// The catalogue's triangle kernels in the frame in which the outward normal is (0, 0, 1).
#include "kernel_terms.h"

namespace cageproof::quadrature_ref::certified {
namespace {

using Parameters = std::vector<Real>;

std::vector<Real> no_constants(const Parameters&) { return {}; }
Real over_pi(int numerator, int denominator) { return Real(numerator) / (pi_ball() * denominator); }

Polynomial x(int i) { return coordinate(i); }
Polynomial height() { return coordinate(2); }
Polynomial one_over_r(int q) { return inverse_distance(q); }

// b = a/(4 (1 - nu)), zero in the limits nu = +-infinity.
Real kelvin_b(const Real& a, const Real& nu) { return nu.is_finite() ? a / ((Real(1) - nu) * 4) : Real(0); }
// a - 2b = a (1 - 2 nu)/(2 (1 - nu)): exactly zero at nu = 1/2, where tractions in the plane vanish.
Real kelvin_a_minus_2b(const Real& a, const Real& nu) {
  return nu.is_finite() ? a * (Real(1) - nu * 2) / ((Real(1) - nu) * 2) : a;
}

// (a - b)/r I + b x x'/r^3 with a = 1/(4 pi mu), b = a/(4 (1 - nu)), [C23] Eq 3, [T24] Eq 47. Constants: a - b, b.
std::vector<Polynomial> kelvin_displacement() {
  std::vector<Polynomial> matrix;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Polynomial entry = constant(2) * x(i) * x(j) * one_over_r(3);
      if (i == j) entry = entry + constant(1) * one_over_r(1);
      matrix.push_back(entry);
    }
  return matrix;
}

// mu ((a - 2b)(x.n I + n x' - x n')/r^3 + 6b x.n x x'/r^5), [C23] Eq 4. Constants: mu (a - 2b), mu b; mu cancels.
std::vector<Polynomial> kelvin_traction() {
  std::vector<Polynomial> matrix;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Polynomial turn;
      if (i == j) turn = turn + height();
      if (i == 2) turn = turn + x(j);
      if (j == 2) turn = turn + (-1) * x(i);
      matrix.push_back(constant(1) * turn * one_over_r(3) + 6 * (constant(2) * height() * x(i) * x(j) * one_over_r(5)));
    }
  return matrix;
}

}  // namespace

const std::vector<Definition>& definitions() {
  static const std::vector<Definition> all{
      {"triangle.single_layer",
       false,
       {constant(1) * one_over_r(1)},
       [](const Parameters&) { return std::vector{over_pi(1, 4)}; }},
      {"triangle.double_layer",
       true,
       {constant(1) * height() * one_over_r(3)},
       [](const Parameters&) { return std::vector{over_pi(1, 4)}; }},
      {"triangle.solid_angle", false, {height() * one_over_r(3)}, no_constants},
      {"triangle.biharmonic_single_layer",
       false,
       {constant(1) * one_over_r(-1)},
       [](const Parameters&) { return std::vector{over_pi(1, 8)}; }},
      {"triangle.biharmonic_double_layer",
       true,
       {constant(1) * height() * one_over_r(1)},
       [](const Parameters&) { return std::vector{over_pi(-1, 8)}; }},
      {"triangle.affine_single_layer",
       true,
       {constant(1) * one_over_r(1)},
       [](const Parameters&) { return std::vector{over_pi(1, 4)}; }},
      {"triangle.kelvin_displacement", false, kelvin_displacement(),
       [](const Parameters& p) {
         const Real a = over_pi(1, 4) / p[0], b = kelvin_b(a, p[1]);
         return std::vector{a - b, b};
       }},
      {"triangle.kelvin_traction", true, kelvin_traction(),
       [](const Parameters& p) {
         const Real mu_a = over_pi(1, 4);
         return std::vector{kelvin_a_minus_2b(mu_a, p[1]), kelvin_b(mu_a, p[1])};
       }},
      {"triangle.mean_value", true, {height() * one_over_r(4)}, no_constants},
  };
  return all;
}

}  // namespace cageproof::quadrature_ref::certified
