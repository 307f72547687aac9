// SPDX-License-Identifier: MIT
// The catalogue's kernels in the frame whose last axis is the outward normal.
#include "kernel_terms.h"

#include "cageproof/core/catalogue/formula.h"

#include <stdexcept>
#include <string>

namespace cageproof::quadrature_ref::certified {
namespace {

using Parameters = std::vector<Real>;

std::vector<Real> no_constants(const Parameters&) { return {}; }
Real over_pi(int numerator, int denominator) { return Real(numerator) / (pi_ball() * denominator); }

Polynomial height() { return coordinate(2); }
Polynomial one_over_r(int q) { return inverse_distance(q); }

// b = a/(4 (1 - nu)), zero in the limits nu = +-infinity.
Real kelvin_b(const Real& a, const Real& nu) { return nu.is_finite() ? a / ((Real(1) - nu) * 4) : Real(0); }
// a - 2b = a (1 - 2 nu)/(2 (1 - nu)): exactly zero at nu = 1/2, where tractions in the plane vanish.
Real kelvin_a_minus_2b(const Real& a, const Real& nu) {
  return nu.is_finite() ? a * (Real(1) - nu * 2) / ((Real(1) - nu) * 2) : a;
}

// x_i of a space of `dim` dimensions, in the order of its frame's axes: the normal is the last of them.
Polynomial axis(int dim, int i) { return coordinate(i == dim - 1 ? 2 : i); }

// (a - b)/r I + b x x'/r^3 with a = 1/(4 pi mu), b = a/(4 (1 - nu)), [C23] Eq 3, [T24] Eq 47; in the plane
// (b - a) ln r I + b x x'/r^2 with a = 1/(2 pi mu). Constants: a - b, b.
std::vector<Polynomial> kelvin_displacement(int dim) {
  const Polynomial potential = dim == 2 ? (-1) * logarithm() : one_over_r(1);
  std::vector<Polynomial> matrix;
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j) {
      Polynomial entry = constant(2) * axis(dim, i) * axis(dim, j) * one_over_r(dim);
      if (i == j) entry = entry + constant(1) * potential;
      matrix.push_back(entry);
    }
  return matrix;
}
std::vector<Real> displacement_constants(int dim, const Parameters& p) {
  const Real a = over_pi(1, dim == 2 ? 2 : 4) / p[0], b = kelvin_b(a, p[1]);
  return {a - b, b};
}

// mu ((a - 2b)(x.n I + n x' - x n')/r^3 + 6b x.n x x'/r^5), [C23] Eq 4; in the plane (...)/r^2 + 4b x.n x x'/r^4.
// Constants: mu (a - 2b), mu b; mu cancels.
std::vector<Polynomial> kelvin_traction(int dim) {
  std::vector<Polynomial> matrix;
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j) {
      Polynomial turn;
      if (i == j) turn = turn + height();
      if (i == dim - 1) turn = turn + axis(dim, j);
      if (j == dim - 1) turn = turn + (-1) * axis(dim, i);
      matrix.push_back(constant(1) * turn * one_over_r(dim) +
                       2 * dim * (constant(2) * height() * axis(dim, i) * axis(dim, j) * one_over_r(dim + 2)));
    }
  return matrix;
}
std::vector<Real> traction_constants(int dim, const Parameters& p) {
  const Real mu_a = over_pi(1, dim == 2 ? 2 : 4);
  return {kelvin_a_minus_2b(mu_a, p[1]), kelvin_b(mu_a, p[1])};
}

// In the plane G_m = r^(2m-2) (ln r - h)/(2 pi c), c = 4^(m-1) (m-1)!^2 and h the sum of 1/i up to m - 1: the Laplacian
// of each is the one before, [W12] Appendix B after the errata. Constants of -G_m, two an order: before r^(2m-2) ln r
// and before r^(2m-2); all but those of the order asked for are zero.
constexpr int kHighestOrder = 6;
std::vector<Real> polyharmonic_constants(const Parameters& p) {
  std::vector<Real> constants;
  Real c = pi_ball() * 2, h(0);
  for (int m = 1; m <= kHighestOrder; ++m) {
    if (m > 1) {
      c = c * (4 * (m - 1) * (m - 1));
      h += Real(1) / (m - 1);
    }
    const bool asked = (p[0] - Real(m)).is_zero();
    constants.push_back(asked ? Real(-1) / c : Real(0));
    constants.push_back(asked ? h / c : Real(0));
  }
  return constants;
}
Polynomial polyharmonic_single_layer() {
  Polynomial sum;
  for (int m = 1; m <= kHighestOrder; ++m)
    sum = sum + (constant(2 * m - 1) * logarithm() + constant(2 * m)) * one_over_r(2 - 2 * m);
  return sum;
}
// dG_m/dn: x.n times -g, where g x is the gradient of -G_m.
Polynomial polyharmonic_double_layer() {
  Polynomial sum;
  for (int m = 1; m <= kHighestOrder; ++m) {
    Polynomial slope = constant(2 * m - 1) * one_over_r(4 - 2 * m);
    if (m > 1)
      slope = slope + (2 * m - 2) * ((constant(2 * m - 1) * logarithm() + constant(2 * m)) * one_over_r(4 - 2 * m));
    sum = sum + (-1) * (slope * height());
  }
  return sum;
}

std::vector<Definition> of_triangles() {
  return {
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
      {"triangle.kelvin_displacement", false, kelvin_displacement(3),
       [](const Parameters& p) { return displacement_constants(3, p); }},
      {"triangle.kelvin_traction", true, kelvin_traction(3),
       [](const Parameters& p) { return traction_constants(3, p); }},
      {"triangle.mean_value", true, {height() * one_over_r(4)}, no_constants},
  };
}

// [W12] Sections 3, 4 and Appendix A after the errata, [C23], [T18] and [T24] in the plane.
std::vector<Definition> of_segments() {
  return {
      {"segment.single_layer",
       false,
       {constant(1) * logarithm()},
       [](const Parameters&) { return std::vector{over_pi(-1, 2)}; }},
      {"segment.double_layer",
       true,
       {constant(1) * height() * one_over_r(2)},
       [](const Parameters&) { return std::vector{over_pi(1, 2)}; }},
      {"segment.affine_single_layer",
       true,
       {constant(1) * logarithm()},
       [](const Parameters&) { return std::vector{over_pi(-1, 2)}; }},
      {"segment.biharmonic_single_layer",
       false,
       {constant(1) * one_over_r(-2) * (logarithm() + (-1) * one_over_r(0))},
       [](const Parameters&) { return std::vector{over_pi(-1, 8)}; }},
      {"segment.biharmonic_double_layer",
       true,
       {constant(1) * height() * (2 * logarithm() + (-1) * one_over_r(0))},
       [](const Parameters&) { return std::vector{over_pi(1, 8)}; }},
      {"segment.kelvin_displacement", false, kelvin_displacement(2),
       [](const Parameters& p) { return displacement_constants(2, p); }},
      {"segment.kelvin_traction", true, kelvin_traction(2),
       [](const Parameters& p) { return traction_constants(2, p); }},
      {"segment.polyharmonic_single_layer", false, {polyharmonic_single_layer()}, polyharmonic_constants},
      {"segment.polyharmonic_double_layer", true, {polyharmonic_double_layer()}, polyharmonic_constants},
      {"segment.mean_value", true, {height() * one_over_r(3)}, no_constants},
      {"segment.winding_angle", false, {height() * one_over_r(2)}, no_constants},
  };
}

}  // namespace

const std::vector<Definition>& definitions() {
  static const std::vector<Definition> all = [] {
    std::vector<Definition> known = of_triangles();
    for (Definition& definition : of_segments()) known.push_back(std::move(definition));
    for (const Definition& definition : known)
      if (find_formula(definition.formula) == nullptr)
        throw std::logic_error("no formula is called " + std::string(definition.formula));
    return known;
  }();
  return all;
}

}  // namespace cageproof::quadrature_ref::certified
