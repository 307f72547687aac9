// SPDX-License-Identifier: MIT
// Functions whose values are known everywhere, computed from only their exact data on the boundary.
#include "goursat/dirichlet_solver.h"
#include "goursat_polygons.h"

#include <gtest/gtest.h>

#include <complex>

namespace cageproof::solved::goursat {
namespace {

using Number = std::complex<double>;
constexpr Number kI(0, 1);

// w g(z) + h(z), w the conjugate of z, with all derivatives that its real part's Hessian needs.
struct Goursat {
  Number g, dg, ddg, h, dh, ddh;
};

struct Known {
  const char* name;
  Goursat (*at)(const Number& z);
  bool harmonic = false;
};

// Outside all polygons of these tests.
constexpr Number kPole(-1.3, -0.9);

// None is in a solver's basis but the first, which is a polynomial.
const std::vector<Known> known{
    {"polynomial",
     [](const Number& z) {
       return Goursat{z * z - 2.0 * kI * z, 2.0 * z - 2.0 * kI, 2, z * z * z + kI * z, 3.0 * z * z + kI, 6.0 * z};
     }},
    // r^2 log r, the kernel of the biharmonic equation, about a pole: (w - q)(z - p) log(z - p), q the conjugate of p.
    {"r^2 log r",
     [](const Number& z) {
       const Number d = z - kPole, q = std::conj(kPole), log = std::log(d);
       return Goursat{d * log, log + 1.0, 1.0 / d, -q * d * log, -q * (log + 1.0), -q / d};
     }},
    {"exponential",
     [](const Number& z) {
       const Number e = std::exp(0.7 * z), s = std::sin(z);
       return Goursat{e, 0.7 * e, 0.49 * e, s, std::cos(z), -s};
     }},
    {"poles",
     [](const Number& z) {
       const Number p = 1.0 / (z - kPole), q = 1.0 / (z - Number(-1.5, 0.4));
       return Goursat{p, -p * p, 2.0 * p * p * p, q, -q * q, 2.0 * q * q * q};
     }},
    {"harmonic log",
     [](const Number& z) {
       const Number d = z - kPole;
       return Goursat{0, 0, 0, std::log(d), 1.0 / d, -1.0 / (d * d)};
     },
     true}};

struct Exact {
  double value;
  std::array<double, 2> gradient;
  std::array<double, 4> hessian;
};

Exact exact(const Known& f, const Vec3<double>& point) {
  const Number z(point[0], point[1]), w = std::conj(z);
  const Goursat j = f.at(z);
  const Number by_z = w * j.dg + j.dh, by_w = j.g, zz = w * j.ddg + j.ddh, zw = j.dg;
  const double mixed = -std::imag(zz);
  return {std::real(w * j.g + j.h),
          {std::real(by_z + by_w), std::imag(by_w - by_z)},
          {std::real(zz + 2.0 * zw), mixed, mixed, std::real(2.0 * zw - zz)}};
}

DirichletSolution solved(const Cage& cage, const Known& f, Equation equation, const DirichletOptions& options = {}) {
  return {cage, equation, 1,
          [&](const EdgePoint& at, const BoundaryData& data) {
            const Exact e = exact(f, at.point);
            data.values[0] = e.value;
            data.normal_derivatives[0] = e.gradient[0] * at.normal[0] + e.gradient[1] * at.normal[1];
            data.derivatives_along[0] = e.gradient[0] * at.along[0] + e.gradient[1] * at.along[1];
          },
          options};
}

// The largest errors by order, over the largest number of that order, at points inside.
std::array<double, 3> errors_inside(const Cage& cage, const Known& f, const DirichletSolution& u, double least) {
  const auto points =
      points_within(cage, least, 24, [&](const Vec3<double>& p) { return u.place(p) == PointPlace::Inside; });
  EXPECT_GE(points.size(), 10) << cage.name();
  std::array<double, 3> errors{}, sizes{};
  for (const Vec3<double>& p : points) {
    const Exact e = exact(f, p);
    const auto found = u.at(p, 2);
    const auto add = [&](int order, double x, double truth) {
      const double error = std::abs(x - truth);
      if (!(error <= errors[order])) errors[order] = std::isnan(errors[order]) ? errors[order] : error;
      sizes[order] = std::max(sizes[order], std::abs(truth));
    };
    add(0, found[0][0], e.value);
    for (int i = 0; i < 2; ++i) add(1, found[1][i], e.gradient[i]);
    for (int i = 0; i < 4; ++i) add(2, found[2][i], e.hessian[i]);
  }
  for (int o = 0; o < 3; ++o) errors[o] /= sizes[o];
  return errors;
}

}  // namespace

TEST(goursat_manufactured, biharmonic_functions_return_from_their_boundary_data) {
  for (const Cage& cage : {unit_square(), triangle(), pentagon(), l_shape(), five_pointed_star()})
    for (const Known& f : known) {
      const DirichletSolution u = solved(cage, f, Equation::Biharmonic);
      const auto errors = errors_inside(cage, f, u, 0.02);
      const double stated = u.report().value_residual + u.report().gradient_residual;
      EXPECT_LE(u.report().value_residual, 1e-10) << cage.name() << ' ' << f.name;
      EXPECT_LE(errors[0], std::max(stated, 1e-13)) << cage.name() << ' ' << f.name;
      EXPECT_LE(errors[0], 1e-10) << cage.name() << ' ' << f.name;
      EXPECT_LE(errors[1], 1e-9) << cage.name() << ' ' << f.name;
      EXPECT_LE(errors[2], 1e-7) << cage.name() << ' ' << f.name;
    }
}

TEST(goursat_manufactured, harmonic_functions_return_from_their_boundary_values) {
  for (const Cage& cage : {unit_square(), triangle(), pentagon(), l_shape(), five_pointed_star()}) {
    const Known& f = known.back();
    const DirichletSolution u = solved(cage, f, Equation::Harmonic);
    const auto errors = errors_inside(cage, f, u, 0.02);
    // The maximum principle.
    EXPECT_LE(errors[0], std::max(2 * u.report().value_residual, 1e-14)) << cage.name();
    EXPECT_LE(errors[0], 1e-11) << cage.name();
    EXPECT_LE(errors[1], 1e-10) << cage.name();
    EXPECT_LE(errors[2], 1e-8) << cage.name();
  }
}

// Each degree brings its share of digits.
TEST(goursat_manufactured, errors_of_smooth_functions_fall_geometrically) {
  const Cage cage = pentagon();
  std::vector<double> logarithms;
  for (const int degree : {3, 6, 9, 12}) {
    const DirichletSolution u = solved(cage, known[2], Equation::Biharmonic, {.degree = degree, .terms = 1});
    logarithms.push_back(std::log10(errors_inside(cage, known[2], u, 0.05)[0]));
  }
  for (std::size_t i = 1; i < logarithms.size(); ++i) EXPECT_LE(logarithms[i], logarithms[i - 1] - 1) << i;
}

// The cost of corners. With only polynomials and the terms of its kink for the hat function of the L's notch, each
// degree's double leaves a half of the residual or more. With the exponents of the corners, each four of them bring a
// digit.
TEST(goursat_manufactured, corners_cost_their_exponents) {
  const Cage cage = l_shape();
  const auto residual = [&](int degree, int terms) {
    const DirichletSolution u(cage, Equation::Biharmonic, 1,
                              [](const EdgePoint& at, const BoundaryData& data) {
                                data.values[0] = at.face == 3 ? at.from_end : at.face == 2 ? at.from_start : 0;
                                data.derivatives_along[0] = at.face == 3 ? -1 : at.face == 2 ? 1 : 0;
                              },
                              {.degree = degree, .terms = terms});
    return u.report().value_residual;
  };
  const double ten = residual(10, 1), eighty = residual(80, 1);
  EXPECT_GE(eighty, 1e-4);
  EXPECT_LE(eighty, ten / 8);
  double before = residual(20, 4);
  for (const int terms : {8, 12, 16}) {
    const double here = residual(20, terms);
    EXPECT_LE(here, before / 8) << terms;
    before = here;
  }
  EXPECT_LE(before, 1e-9);
}

// A function that satisfies another equation has the data of a solution that it is not.
TEST(goursat_manufactured, other_functions_do_not_return) {
  const Cage cage = unit_square();
  const DirichletSolution u(cage, Equation::Biharmonic, 1, [](const EdgePoint& at, const BoundaryData& data) {
    const double x = at.point[0], y = at.point[1];
    data.values[0] = x * x * x * x * y;
    const double dx = 4 * x * x * x * y, dy = x * x * x * x;
    data.normal_derivatives[0] = dx * at.normal[0] + dy * at.normal[1];
    data.derivatives_along[0] = dx * at.along[0] + dy * at.along[1];
  });
  EXPECT_LE(u.report().value_residual, 1e-10);
  EXPECT_GE(std::abs(u.at(Vec3<double>(0.5, 0.5, 0), 0)[0][0] - 0.03125), 1e-3);
}

// Every problem by itself has the solution that it has among others.
TEST(goursat_manufactured, problems_do_not_mix) {
  const Cage cage = triangle();
  const auto data = [&](int first) {
    return [first](const EdgePoint& at, const BoundaryData& to) {
      for (int k = 0; k < static_cast<int>(to.values.size()); ++k) {
        const Exact e = exact(known[k + first], at.point);
        to.values[k] = e.value;
        to.normal_derivatives[k] = e.gradient[0] * at.normal[0] + e.gradient[1] * at.normal[1];
        to.derivatives_along[k] = e.gradient[0] * at.along[0] + e.gradient[1] * at.along[1];
      }
    };
  };
  const DirichletSolution both(cage, Equation::Biharmonic, 2, data(1)), one(cage, Equation::Biharmonic, 1, data(2));
  const Vec3<double> p(0.4, 0.3, 0);
  EXPECT_NEAR(both.at(p, 0)[0][1], one.at(p, 0)[0][0], 1e-12);
  EXPECT_NEAR(both.at(p, 0)[0][0], exact(known[1], p).value, 1e-11);
}

}  // namespace cageproof::solved::goursat
