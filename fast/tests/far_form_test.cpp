// SPDX-License-Identifier: MIT
// The far form's error bound, against the edge form in 50 digits.
#include "cageproof/fast/triangle/hybrid.h"
#include "cageproof/closed_form/batch/instruction_set.h"
#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

namespace cageproof::fast::triangle {
namespace {

using R = Mp50;

/// Sums over n x n Gauss points, the square collapsed towards corner 0.
class SquareSums {
 public:
  explicit SquareSums(int n) : rule_(gauss_legendre<R>(n)) {}

  template <int p, int D>
  std::array<Taylor<R, D>, 3> hats(const Frame<R>& frame) const {
    const auto& corner = frame.p;
    const Vec3<R> side = corner[1] - corner[0], base = corner[2] - corner[1];
    return collapsed_sums<p, D>(corner[0], side, base, frame.area2, rule_, rule_);
  }

 private:
  const GaussLegendre<R>& rule_;
};
template <int N, int M>
using FarForm = HatMoments<R, N, M, SquareSums>;

Triangle<double> random_triangle(RandomStream& random, double thinness) {
  Triangle<double> t;
  for (auto& v : t) v = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  t[2] = t[0] + random.uniform() * (t[1] - t[0]) + thinness * (t[2] - t[0]);
  return t;
}

// The norm of the parts of degree k of a - b over that of b.
template <std::size_t C, int N>
double difference(const std::array<Taylor<R, N>, C>& a, const std::array<Taylor<R, N>, C>& b, int k) {
  R error = 0, size = 0;
  for (std::size_t c = 0; c < C; ++c)
    for (int m = Monomials<N>::first(k); m < Monomials<N>::first(k + 1); ++m) {
      const R d = a[c].c[m] - b[c].c[m];
      error += d * d;
      size += b[c].c[m] * b[c].c[m];
    }
  return static_cast<double>(R(sqrt(R(error / size))));
}

// The largest error over its bound, for n points, of the mean value weights and their derivatives.
double worst_weight_ratio(const Frame<R>& f, int n) {
  const auto far = FarForm<2, 2>(f, n).mean_value(), edge = EvenForm<R, 2>(f).mean_value();
  double worst = 0;
  for (int k = 0; k <= 2; ++k)
    worst = std::max(worst, difference<3, 2>(far, edge, k) / far_error(n, ellipse_of(f), -4, k));
  return worst;
}

// The largest error over its bound, for n points, of every moment and derivative.
double worst_ratio(const Frame<R>& f, int n) {
  const double rho = ellipse_of(f);
  const FarForm<2, 2> far(f, n);
  const EdgeForm<R, 2, 2> edge(f);
  double worst = 0;
  for (int k = 0; k <= 2; ++k) {
    const auto take = [&](double error, int p) { worst = std::max(worst, error / far_error(n, rho, p, k)); };
    take(difference<3, 2>(far.A(), edge.A(), k), -1);
    take(difference<3, 2>(far.B(), edge.B(), k), -3);
    take(difference<1, 2>({far.I()}, {edge.I()}, k), 1);
    take(difference<3, 2>(far.mean_value(), EvenForm<R, 2>(f).mean_value(), k), -4);
  }
  const FarForm<4, 3> steep(f, n);
  const EdgeForm<R, 4, 3> steep_edge(f);
  for (int k = 3; k <= 4; ++k) {
    worst = std::max(worst, difference<3, 4>(steep.A(), steep_edge.A(), k) / far_error(n, rho, -1, k));
    worst = std::max(worst, difference<1, 4>({steep.I()}, {steep_edge.I()}, k) / far_error(n, rho, 1, k));
  }
  return worst;
}

TEST(far_form, error_is_below_its_bound) {
  double worst = 0;
  for (int i = 0; i < 120; ++i) {
    RandomStream random(21, "far", i);
    const Triangle<double> t = random_triangle(random, i % 3 == 0 ? 0.01 : 1);
    Vec3<double> direction(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    if (i % 4 == 0)
      direction = (t[1] - t[0]) + 1e-3 * direction;  // in line with an edge, where the segment's end is nearest
    const Vec3<double> centre = (t[0] + t[1] + t[2]) / 3;
    const double size = std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
    const Vec3<double> eta = centre + random.uniform(1.3, 6) * size * direction.normalized();
    const Frame<R> f({convert<R>(t[0]), convert<R>(t[1]), convert<R>(t[2])}, convert<R>(eta));
    if (ellipse_of(f) < 2) continue;
    worst = std::max(worst, worst_ratio(f, 3 + i % 9));
  }
  EXPECT_LE(worst, 1);
  // A bound a million times too wide would waste points.
  EXPECT_GE(worst, 1e-6);
}

TEST(far_form, moments_keep_the_bound_of_the_distance_down_to_a_quarter_of_the_triangle) {
  double worst = 0;
  for (int i = 0; i < 240; ++i) {
    RandomStream random(22, "far", i);
    const Triangle<double> t = random_triangle(random, i % 3 == 0 ? 0.01 : 1);
    const double size = std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
    const Vec3<double> normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    const double u = random.uniform(), v = random.uniform(0, 1 - u);
    Vec3<double> at = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
    if (i % 4 == 0) at = t[i / 4 % 3] + random.uniform(0, 0.5) * (t[i / 4 % 3] - at);  // beyond a corner
    const Vec3<double> eta = at + random.uniform(0.25, 1.5) * size * normal;
    const Frame<R> f({convert<R>(t[0]), convert<R>(t[1]), convert<R>(t[2])}, convert<R>(eta));
    // The edge form's 50 digits, less what it cancels, are no measure of smaller errors.
    const int most = static_cast<int>(36 / (2 * std::log10(ellipse_of(f))));
    worst = std::max(worst, worst_weight_ratio(f, std::min(5 + i % 40, most)));
    // The other moments take over at the twenty points per side that kFarLimit allows.
    worst = std::max(worst, worst_ratio(f, std::min(5 + i % 16, most)));
  }
  EXPECT_LE(worst, 1);
  EXPECT_GE(worst, 1e-6);
}

// Panels' sums against the edge form in 50 digits: the largest error over its bound, and how many panels it took.
struct OnPanels {
  double worst = 0, value = 0;  // of values, in roundings
  std::size_t panels = 0;

  template <int N>
  void take(const Taylor<Tracked<double>, N>& sum, const Taylor<R, N>& exact) {
    for (int m = 0; m < Monomials<N>::count; ++m) {
      const double error = static_cast<double>(R(abs(R(sum.c[m].value) - exact.c[m])));
      worst = std::max(worst, error / (0x1p-53 * sum.c[m].error));
      // Nothing cancels in values.
      if (m == 0) value = std::max(value, error / (0x1p-53 * sum.c[0].magnitude()));
    }
  }
};

OnPanels on_panels(double thinness, int sample) {
  RandomStream random(23, "panels", sample);
  const Triangle<double> t = random_triangle(random, thinness);
  const double u = random.uniform(), v = random.uniform(0, 1 - u);
  const Vec3<double> direction(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  const Vec3<double> eta =
      t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]) + std::pow(10, random.uniform(-3, 1)) * direction.normalized();
  const Frame<double> seen(t, eta);
  OnPanels result;
  const Panels panels = cut_to_panels(seen, t, eta, {3 + 2, 12000});
  result.panels = panels.size();
  if (panels.empty()) return result;
  // In the unit of the frame in double.
  const R unit(seen.unit);
  const Frame<R> frame({convert<R>(t[0]) / unit, convert<R>(t[1]) / unit, convert<R>(t[2]) / unit},
                       Vec3<R>(convert<R>(eta) / unit));
  const Frame<Tracked<double>> tracked(seen);
  const PanelForm<Tracked<double>, 2, 2> sums(tracked, panels);
  const EdgeForm<R, 2, 2> edge(frame);
  for (int k = 0; k < 3; ++k) {
    result.take<2>(sums.A()[k], edge.A()[k]);
    result.take<2>(sums.B()[k], edge.B()[k]);
    result.take<2>(sums.mean_value()[k], EvenForm<R, 2>(frame).mean_value()[k]);
  }
  result.take<2>(sums.I(), edge.I());
  return result;
}

// The roundings of a panel's sum. With more lanes, each adds fewer terms one after the other: one lane has 18.3
// roundings, four have 13.2.
double most_roundings() {
  switch (closed_form::batch::instruction_set()) {
    case closed_form::batch::InstructionSet::Avx512: return 12;
    case closed_form::batch::InstructionSet::Avx2: return 14;
    default: return 20;
  }
}

TEST(panels, sums_are_as_good_as_they_say_near_and_far_and_on_thin_triangles) {
  for (const double thinness : {1., 0.1, 1e-3, 1e-8}) {
    double worst = 0, value = 0;
    int one = 0, many = 0;
    for (int i = 0; i < 60; ++i) {
      const OnPanels found = on_panels(thinness, i);
      worst = std::max(worst, found.worst);
      value = std::max(value, found.value);
      one += found.panels == 1;
      many += found.panels > 4;
    }
    EXPECT_LE(worst, 1) << thinness;
    EXPECT_LE(value, most_roundings()) << thinness;
    EXPECT_GE(worst, 1e-2) << thinness;
    EXPECT_GE(one, 5) << thinness;
    EXPECT_GE(many, 5) << thinness;
  }
}

}  // namespace
}  // namespace cageproof::fast::triangle
