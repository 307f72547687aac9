// SPDX-License-Identifier: MIT
// Closed forms on segments with parameters, against the integrals of their kernels as the papers define them, whose
// derivatives are taken by forward differentiation.
#include "cageproof/closed_form/segment/engine/closed_form.h"
#include "cageproof/closed_form/segment/kelvin_displacement.h"
#include "cageproof/closed_form/segment/kelvin_traction.h"
#include "cageproof/closed_form/segment/polyharmonic_double_layer.h"
#include "cageproof/closed_form/segment/polyharmonic_single_layer.h"
#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/numbers/second_order.h"
#include "segment_truth.h"

#include <numbers>

namespace cageproof::closed_form::segment::segment_parameters_test {
namespace {

using Vec = Vec3<double>;
using Number = SecondOrder<Mp100>;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Number constant(const Mp100& x) { return Number(x); }
Number log_of(const Number& x) {
  const Mp100 inverse = 1 / x.value;
  return composed<Mp100>(log(x.value), inverse, Mp100(-inverse * inverse), x);
}

// The point's distance vector xi - eta, as a function of eta.
struct Seen {
  std::array<Number, 2> x;
  std::array<Mp100, 2> n;
  Number square, height;

  Seen(const Mp100& px, const Mp100& py, const Mp100& nx, const Mp100& ny)
      : x{-Number::variable(-px, 0), -Number::variable(-py, 1)}, n{nx, ny} {
    square = x[0] * x[0] + x[1] * x[1];
    height = constant(nx) * x[0] + constant(ny) * x[1];
  }
};

template <int C>
void add_number(const Number& f, const Mp100& weight, int c, Jet<Mp100, C, 2>& sum) {
  sum.value[c] += weight * f.value;
  for (int i = 0; i < 2; ++i) {
    sum.gradient[c][i] += weight * f.gradient[i];
    for (int j = 0; j < 2; ++j) sum.hessian[c](i, j) += weight * f.hessian[Number::entry(i, j)];
  }
}

// [C23] Eq 3 in the plane, times 2 pi.
struct Displacement {
  static constexpr int components = 4;
  double mu = 1, nu = 0.25;

  void add(const Mp100& weight, const Mp100&, const Mp100& px, const Mp100& py, const Mp100& nx, const Mp100& ny,
           Jet<Mp100, 4, 2>& sum) const {
    const Seen s(px, py, nx, ny);
    const Mp100 a = 1 / Mp100(mu), b = std::isinf(nu) ? Mp100(0) : Mp100(a / (4 * (1 - Mp100(nu))));
    const Number logarithm = constant((b - a) / 2) * log_of(s.square);
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        Number k = constant(b) * s.x[i] * s.x[j] / s.square;
        if (i == j) k += logarithm;
        add_number(k, weight, 2 * i + j, sum);
      }
  }
};

// [C23] Eq 4 in the plane, times 2 pi.
struct Traction {
  static constexpr int components = 8;
  double nu = 0.25;

  void add(const Mp100& weight, const Mp100& t, const Mp100& px, const Mp100& py, const Mp100& nx, const Mp100& ny,
           Jet<Mp100, 8, 2>& sum) const {
    const Seen s(px, py, nx, ny);
    const Mp100 b = std::isinf(nu) ? Mp100(0) : Mp100(1 / (4 * (1 - Mp100(nu))));
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        Number force = constant(s.n[i]) * s.x[j] - s.x[i] * constant(s.n[j]);
        if (i == j) force += s.height;
        const Number stretch = constant(4 * b) * s.height * s.x[i] * s.x[j] / s.square;
        const Number whole = (constant(1 - 2 * b) * force + stretch) / s.square;
        for (int k = 0; k < 2; ++k) add_number(whole, weight * (k == 0 ? 1 - t : t), 4 * k + 2 * i + j, sum);
      }
  }
};

// What [W12] Appendix B's recurrences resolve to: G_s = a r^(2(s - 1)) (ln r - harmonic), a = 1/(4^(s - 1) (s - 1)!^2).
struct GreenConstants {
  Mp100 a = 1, harmonic = 0;

  explicit GreenConstants(int order) {
    for (int i = 1; i < order; ++i) {
      harmonic += 1 / Mp100(i);
      a /= 4 * i * i;
    }
  }
};

Number power_of(const Number& square, int n) {
  Number power = constant(1);
  for (int i = 0; i < n; ++i) power *= square;
  return power;
}

Number green_function(int order, const Number& square) {
  const GreenConstants g(order);
  return constant(g.a) * power_of(square, order - 1) * (constant(Mp100(1) / 2) * log_of(square) - constant(g.harmonic));
}

struct PolyharmonicSingle {
  static constexpr int components = 1;
  int order = 3;

  void add(const Mp100& weight, const Mp100&, const Mp100& px, const Mp100& py, const Mp100& nx, const Mp100& ny,
           Jet<Mp100, 1, 2>& sum) const {
    add_number(-green_function(order, Seen(px, py, nx, ny).square), weight, 0, sum);
  }
};

// The derivative along the normal by the slope in r^2: n.grad G = 2 x.n dG/d(r^2), a r^(2(s-2)) times a logarithm.
struct PolyharmonicDouble {
  static constexpr int components = 2;
  int order = 3;

  void add(const Mp100& weight, const Mp100& t, const Mp100& px, const Mp100& py, const Mp100& nx, const Mp100& ny,
           Jet<Mp100, 2, 2>& sum) const {
    const Seen s(px, py, nx, ny);
    // d/dq of q^m (ln(q)/2 - H) = q^(m - 1) (m ln(q)/2 - m H + 1/2), q = r^2, m = order - 1.
    const int m = order - 1;
    const GreenConstants g(order);
    Number slope = constant(Mp100(m) / 2) * log_of(s.square) + constant(Mp100(1) / 2 - m * g.harmonic);
    if (m == 0) slope /= s.square;
    else slope *= power_of(s.square, m - 1);
    const Number f = constant(2 * g.a) * s.height * slope;
    for (int k = 0; k < 2; ++k) add_number(f, weight * (k == 0 ? 1 - t : t), k, sum);
  }
};

TEST(segment_kelvin_displacement, is_the_kernels_integral_in_all_regimes) {
  for (const double nu : {0.25, -0.9, 0.0, 0.5, 0.4999999, kInfinity, -kInfinity}) {
    SCOPED_TRACE(nu);
    expect_exact_in_all_regimes<KelvinDisplacement>({10, 10, 10}, Displacement{3, nu}, std::array{3., nu});
  }
}

TEST(segment_kelvin_traction, is_the_kernels_integral_in_all_regimes) {
  for (const double nu : {0.25, -0.9, 0.0, 0.5, 0.4999999, kInfinity, -kInfinity}) {
    SCOPED_TRACE(nu);
    expect_exact_in_all_regimes<KelvinTraction>({10, 10, 10}, Traction{nu}, std::array{3., nu});
  }
}

TEST(segment_polyharmonic_single_layer, is_the_kernels_integral_in_all_regimes) {
  for (const int order : {1, 2, 3, 4, 5, 6}) {
    SCOPED_TRACE(order);
    expect_exact_in_all_regimes<PolyharmonicSingleLayer>({16, 16, 16}, PolyharmonicSingle{order},
                                                         std::array{static_cast<double>(order)});
  }
}

TEST(segment_polyharmonic_double_layer, is_the_kernels_integral_in_all_regimes) {
  for (const int order : {1, 2, 3, 4, 5, 6}) {
    SCOPED_TRACE(order);
    expect_exact_in_all_regimes<PolyharmonicDoubleLayer>({16, 16, 16}, PolyharmonicDouble{order},
                                                         std::array{static_cast<double>(order)});
  }
}

const Segment<double> unit{Vec(0, 0, 0), Vec(1, 0, 0)};  // the inside is where y > 0

Result<double> registered(const char* formula, const Segment<double>& s, const Vec& point, int order,
                          std::vector<double> parameters, bool finite_part = false) {
  Result<double> found;
  evaluation_named(formula, "closed_form")(Query<double>{s, point, order, parameters, finite_part}, found);
  return found;
}

// On the segment the matrix of the hat function's end is half the identity times the hat function, and off the diagonal
// (1 - 2 nu)/(2 (1 - nu)) of its principal value: F_k = int Gamma_k/z is real there.
TEST(segment_kelvin_traction, is_half_the_identity_on_the_segment) {
  const double nu = 0.25, turn = 0.5 / std::numbers::pi, shear = (1 - 2 * nu) / (2 * (1 - nu));
  const auto on = registered("segment.kelvin_traction", unit, Vec(0.25, 0, 0), 1, {1, nu});
  for (int k = 0; k < 2; ++k) {
    const double hat = k == 0 ? 0.75 : 0.25;
    // int (1 - t)/(t - 1/4) = 3/4 ln 3 - 1, int t/(t - 1/4) = 1/4 ln 3 + 1.
    const double pull = turn * shear * (hat * std::log(3.) + (k == 0 ? -1 : 1));
    EXPECT_DOUBLE_EQ(on.value[4 * k], hat / 2);
    EXPECT_DOUBLE_EQ(on.value[4 * k + 3], hat / 2);
    EXPECT_DOUBLE_EQ(on.value[4 * k + 1], pull);
    EXPECT_DOUBLE_EQ(on.value[4 * k + 2], -pull);
  }
  for (const double x : on.gradient) EXPECT_TRUE(std::isfinite(x));
}

TEST(segment_kelvin_traction, has_infinite_entries_at_its_own_end) {
  const double turn = 0.5 / std::numbers::pi;
  for (const double nu : {0.25, kInfinity}) {
    const auto first = registered("segment.kelvin_traction", unit, unit[0], 1, {1, nu}),
               last = registered("segment.kelvin_traction", unit, unit[1], 1, {1, nu});
    EXPECT_DOUBLE_EQ(first.value[0], 0.25);
    EXPECT_EQ(first.value[1], kInfinity);
    EXPECT_EQ(first.value[2], -kInfinity);
    EXPECT_EQ(last.value[5], -kInfinity);
    EXPECT_EQ(last.value[6], kInfinity);
    // int t/t: one quarter turn of the shear's share.
    EXPECT_DOUBLE_EQ(first.value[5], turn * (std::isinf(nu) ? 1 : (1 - 2 * nu) / (2 * (1 - nu))));
    for (const double x : first.gradient) EXPECT_TRUE(std::isnan(x));
    for (const double x : registered("segment.kelvin_traction", unit, unit[0], 0, {1, nu}, true).value)
      EXPECT_TRUE(std::isfinite(x));
  }
  // Incompressible: no logarithm. Along the normal h/z^2 leaves (u n' + n u')/(2 pi).
  const auto finite = registered("segment.kelvin_traction", unit, unit[0], 0, {1, 0.5});
  EXPECT_DOUBLE_EQ(finite.value[1], -turn);
  EXPECT_DOUBLE_EQ(finite.value[2], -turn);
  const auto inside = registered("segment.kelvin_traction", unit, Vec(0, 1e-12, 0), 0, {1, 0.5});
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(inside.value[c], finite.value[c], 1e-10) << c;
}

TEST(segment_kelvin_displacement, slopes_at_an_end_are_infinite_where_the_logarithm_enters) {
  const auto end = registered("segment.kelvin_displacement", unit, unit[0], 1, {1, 0.25});
  for (const double x : end.value) EXPECT_TRUE(std::isfinite(x));
  const auto slope = [&](int row, int column, int i) { return end.gradient[2 * (2 * row + column) + i]; };
  EXPECT_EQ(slope(0, 0, 0), kInfinity);
  EXPECT_EQ(slope(1, 1, 0), kInfinity);
  EXPECT_EQ(slope(0, 1, 1), -kInfinity);
  EXPECT_TRUE(std::isnan(slope(0, 0, 1)));
  EXPECT_TRUE(std::isnan(slope(0, 1, 0)));
  const auto next = registered("segment.kelvin_displacement", unit, Vec(0, 1e-200, 0), 1, {1, 0.25});
  EXPECT_GT(next.gradient[0], 10);
  EXPECT_LT(next.gradient[3], -10);
  // Incompressible on a diagonal: (a - b) u_c - 2 b n_c u_0 n_0 is exactly zero.
  const Segment<double> diagonal{Vec(0, 0, 0), Vec(1, 1, 0)};
  const auto none = registered("segment.kelvin_displacement", diagonal, diagonal[0], 1, {1, 0.5});
  EXPECT_TRUE(std::isnan(none.gradient[0]));
  EXPECT_EQ(none.gradient[1], kInfinity);
}

// T = phi I + c J and K = psi/mu I for an infinite Poisson ratio ([C23] Section 5), J the quarter turn.
TEST(segment_kelvin, are_green_coordinates_and_a_quarter_turn_for_an_infinite_ratio) {
  for (int i = 0; i < 40; ++i) {
    const SegmentSample sample = segment_regimes()[0].second(i);
    const auto traction = registered("segment.kelvin_traction", sample.s, sample.point, 2, {2, kInfinity}),
               displacement = registered("segment.kelvin_displacement", sample.s, sample.point, 2, {2, -kInfinity});
    const auto phi = registered("segment.double_layer", sample.s, sample.point, 2, {}),
               psi = registered("segment.single_layer", sample.s, sample.point, 2, {});
    for (int o = 0; o <= 2; ++o) {
      const std::size_t width = derivative_count(2, o);
      for (std::size_t d = 0; d < width; ++d) {
        EXPECT_NEAR(displacement.of(o)[d], psi.of(o)[d] / 2, 1e-13 * std::pow(30, o)) << i;
        EXPECT_EQ(displacement.of(o)[width + d], 0);
        for (std::size_t k = 0; k < 2; ++k) {
          EXPECT_NEAR(traction.of(o)[4 * k * width + d], phi.of(o)[k * width + d], 1e-13 * std::pow(30, o)) << i;
          EXPECT_EQ(traction.of(o)[(4 * k + 1) * width + d], -traction.of(o)[(4 * k + 2) * width + d]) << i;
        }
      }
    }
  }
}

TEST(segment_polyharmonic, has_all_limits_at_the_ends_from_order_three_on) {
  for (double order = 3; order <= 6; ++order) {
    const auto single = registered("segment.polyharmonic_single_layer", unit, unit[0], 2, {order}),
               twice = registered("segment.polyharmonic_double_layer", unit, unit[0], 2, {order});
    for (int o = 0; o <= 2; ++o) {
      for (const double x : single.of(o)) EXPECT_TRUE(std::isfinite(x)) << order << ' ' << o;
      for (const double x : twice.of(o)) EXPECT_TRUE(std::isfinite(x)) << order << ' ' << o;
    }
  }
  // int t^4 (ln t - 3/2) = -1/25 - 3/10 = -0.34, over 128 pi.
  EXPECT_DOUBLE_EQ(registered("segment.polyharmonic_single_layer", unit, unit[0], 0, {3}).value[0],
                   0.34 / (128 * std::numbers::pi));
}

// u = x^4 y: its Laplacians are 12 x^2 y, 24 y and zero, so that it is triharmonic.
struct Triharmonic {
  static std::array<double, 3> value(const Vec& p) {
    return {std::pow(p[0], 4) * p[1], 12 * p[0] * p[0] * p[1], 24 * p[1]};
  }
  static std::array<double, 3> derivative(const Vec& p, const Vec& n) {
    return {4 * std::pow(p[0], 3) * p[1] * n[0] + std::pow(p[0], 4) * n[1],
            24 * p[0] * p[1] * n[0] + 12 * p[0] * p[0] * n[1], 24 * n[1]};
  }
};

// The right side of the s-th Green identity ([W12] Appendix B after the errata) in the unit square, each edge in so
// many pieces, with values between them linear and normal derivatives constant on each.
double green_identity(int s, const Vec& point, int pieces) {
  const std::array<Vec, 4> corners{Vec(0, 0, 0), Vec(1, 0, 0), Vec(1, 1, 0), Vec(0, 1, 0)};
  double sum = 0;
  for (int e = 0; e < 4; ++e)
    for (int k = 0; k < pieces; ++k) {
      const Vec along = corners[(e + 1) % 4] - corners[e];
      const Segment<double> piece{corners[e] + k * along / pieces, corners[e] + (k + 1) * along / pieces};
      const Vec normal(along[1], -along[0], 0);
      for (int i = 1; i <= 4 - s; ++i) {
        const auto phi = registered("segment.polyharmonic_double_layer", piece, point, 0, {double(i)}).value;
        for (int end = 0; end < 2; ++end) sum += Triharmonic::value(piece[end])[s + i - 2] * phi[end];
        sum += Triharmonic::derivative((piece[0] + piece[1]) / 2, normal)[s + i - 2] *
               registered("segment.polyharmonic_single_layer", piece, point, 0, {double(i)}).value[0];
      }
    }
  return sum;
}

TEST(segment_polyharmonic, layers_keep_greens_identities) {
  for (const Vec& point : {Vec(0.5, 0.5, 0), Vec(0.25, 0.625, 0), Vec(0.875, 0.25, 0)})
    for (int s = 1; s <= 3; ++s) {
      const double coarse = green_identity(s, point, 16), fine = green_identity(s, point, 32),
                   finest = green_identity(s, point, 64);
      // The errors are series of the square of a piece's length.
      const double first = fine + (fine - coarse) / 3, second = finest + (finest - fine) / 3;
      EXPECT_NEAR(second + (second - first) / 15, Triharmonic::value(point)[s - 1], 1e-7) << s;
    }
}

}  // namespace
}  // namespace cageproof::closed_form::segment::segment_parameters_test
