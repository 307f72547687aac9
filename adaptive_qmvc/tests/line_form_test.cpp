// SPDX-License-Identifier: MIT
// The line form against the integral in two dimensions, and its parts against plain quadrature.
#include "quad/mean_value/line_form/line_form.h"
#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

namespace cageproof::adaptive_qmvc::line_form_test {
namespace {

using Vec = Vec3<double>;
using Corners = std::vector<Vec>;

const Corners kFlat{{0, 0, 0}, {1, 0, 0}, {1.25, 1, 0}, {-0.125, 0.875, 0}};
const Corners kTwisted{{0, 0, 0}, {1, 0, 0.25}, {1.125, 1, -0.25}, {-0.125, 0.875, 0.25}};
const Corners kStrong{{0, 0, 0.625}, {1, 0, -0.625}, {1, 1, 0.625}, {0, 1, -0.625}};

Vec at(const Corners& q, double u, double v) {
  return (1 - v) * ((1 - u) * q[0] + u * q[1]) + v * (u * q[2] + (1 - u) * q[3]);
}

Vec normal(const Corners& q, double u, double v) {
  const Vec along = (1 - v) * (q[1] - q[0]) + v * (q[2] - q[3]), across = (1 - u) * (q[3] - q[0]) + u * (q[2] - q[1]);
  return along.cross(across).normalized();
}

template <Scalar R>
Result<R> evaluate(std::string_view name, const Corners& corners, const Vec& point, int order) {
  std::vector<Vec3<R>> q;
  for (const Vec& c : corners) q.push_back(convert<R>(c));
  Result<R> result;
  const Evaluation evaluation = *EvaluationRegister::instance().find("quad.mean_value", name);
  evaluation(Query<R>{q, convert<R>(point), order, {}}, result);
  return result;
}

// |a - b| / |b|, norm-wise.
template <Scalar A, Scalar B>
double relative(const std::vector<A>& a, const std::vector<B>& b) {
  Mp100 difference = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Mp100 d = Mp100(a[i]) - Mp100(b[i]);
    difference += d * d;
    size += Mp100(b[i]) * Mp100(b[i]);
  }
  return static_cast<double>(Mp100(sqrt(Mp100(difference / size))));
}

class LineFormOn : public testing::TestWithParam<int> {
 protected:
  const Corners& quad() const { return GetParam() == 0 ? kFlat : GetParam() == 1 ? kTwisted : kStrong; }
};

TEST_P(LineFormOn, is_the_integral_at_all_distances_to_30_digits) {
  for (const double distance : {3.0, 0.25, 0x1p-10, 0x1p-30}) {
    const Vec point = at(quad(), 0.375, 0.625) - distance * normal(quad(), 0.375, 0.625);
    const Result<Mp50> integral = evaluate<Mp50>("multiprecision", quad(), point, 2);
    ASSERT_TRUE(integral.converged) << distance;
    const Result<Mp100> line = evaluate<Mp100>("line_form", quad(), point, 2);
    for (int o = 0; o <= 2; ++o) EXPECT_LT(relative(line.of(o), integral.of(o)), 1e-30) << distance << " order " << o;
  }
}

TEST_P(LineFormOn, is_the_integral_beside_edges_and_corners) {
  for (const auto& [u, v] : {std::pair{0.0, 0.375}, std::pair{1.0, 1.0}, std::pair{-0.25, 0.5}}) {
    const Vec point = at(quad(), u, v) + 0x1p-12 * Vec(0.5, 0.25, 0.75);
    const Result<Mp50> integral = evaluate<Mp50>("multiprecision", quad(), point, 1);
    ASSERT_TRUE(integral.converged);
    const Result<Mp100> line = evaluate<Mp100>("line_form", quad(), point, 1);
    for (int o = 0; o <= 1; ++o)
      EXPECT_LT(relative(line.of(o), integral.of(o)), 1e-30) << u << ' ' << v << " order " << o;
  }
}

// With the corner at the origin a double says exactly how close the point is, and nothing is ill-conditioned.
TEST_P(LineFormOn, keeps_all_digits_next_to_a_corner_at_the_origin) {
  Corners q = quad();
  for (Vec& c : q) c -= quad()[0];
  for (double distance = 1; distance > 1e-17; distance /= 16) {
    const Vec point = distance * Vec(0.5, 0.25, -0.75);
    const Result<double> found = evaluate<double>("line_form", q, point, 2);
    const Result<Mp100> exact = evaluate<Mp100>("line_form", q, point, 2);
    // By homogeneity (Euler) relative changes of the coordinates change tensors at least 1 + o times as much.
    for (int o = 0; o <= 2; ++o)
      EXPECT_LT(relative(found.of(o), exact.of(o)), 64 * (2 + o) * 0x1p-53) << distance << " order " << o;
  }
}

TEST_P(LineFormOn, gives_the_digits_that_its_name_says) {
  for (int i = 0; i < 200; ++i) {
    RandomStream random(1, "line digits", i);
    const double u = random.uniform(-0.5, 1.5), v = random.uniform(-0.5, 1.5),
                 height = std::pow(10.0, random.uniform(-4, 1));
    const Vec point = at(quad(), u, v) + height * normal(quad(), u, v);
    const Result<double> full = evaluate<double>("line_form", quad(), point, 2);
    for (const auto& [name, digits] : {std::pair{"line-4", 4}, std::pair{"line-8", 8}, std::pair{"line-12", 12}}) {
      const Result<double> few = evaluate<double>(name, quad(), point, 2);
      for (int o = 0; o <= 2; ++o) {
        // Next to the quad rounding is multiplied by 1/distance.
        const double allowed = std::pow(10.0, -digits) + 1e-14 / std::min(1.0, height);
        EXPECT_LT(relative(few.of(o), full.of(o)), allowed) << name << " order " << o << " height " << height;
      }
    }
  }
}

TEST_P(LineFormOn, diverges_on_the_quad) {
  // Dyadic corners and parameters: exactly on.
  for (const auto& [u, v] : {std::pair{0.375, 0.625}, std::pair{0.0, 0.5}, std::pair{1.0, 1.0}}) {
    const Result<double> found = evaluate<double>("line_form", quad(), at(quad(), u, v), 1);
    const std::array<double, 4> basis{(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
    for (int k = 0; k < 4; ++k) {
      if (basis[k] > 0) {
        EXPECT_EQ(found.value[k], std::numeric_limits<double>::infinity());
      } else {
        EXPECT_TRUE(std::isnan(found.value[k])) << "no limit where the basis function vanishes";
      }
    }
    for (const double w : found.gradient) EXPECT_TRUE(std::isnan(w));
  }
}

std::string kind_of(const testing::TestParamInfo<int>& quad) {
  return quad.param == 0 ? "flat" : quad.param == 1 ? "twisted" : "strongly_twisted";
}

INSTANTIATE_TEST_SUITE_P(quads, LineFormOn, testing::Values(0, 1, 2), kind_of);

// The lines' directions vanish beyond the other side: a double root that once hid the pair next to the point.
TEST(line_form, sees_the_peak_beside_the_long_side_of_a_trapezoid) {
  const Corners q{{-0.5, -0.5, -0.5}, {-0.5, 0.5, -0.5}, {-0.25, 0.25, -0.5}, {-0.25, -0.25, -0.5}};
  const Vec point(-0.5 + 0x1p-35, 0, -0.5 + 0x1p-35);
  const Result<Mp50> integral = evaluate<Mp50>("multiprecision", q, point, 1);
  ASSERT_TRUE(integral.converged);
  const Result<Mp100> line = evaluate<Mp100>("line_form", q, point, 1);
  const Result<double> found = evaluate<double>("line_form", q, point, 1);
  for (int o = 0; o <= 1; ++o) {
    EXPECT_LT(relative(line.of(o), integral.of(o)), 1e-30) << o;
    // A rounding of the corners' coordinates moves them by that part of the distance.
    EXPECT_LT(relative(found.of(o), integral.of(o)), 64 * 0x1p-53 / 0x1p-35) << o;
  }
}

// Zeros have no rounding, so that the distance is exact, and nothing excuses a loss of digits by it.
TEST(line_form, loses_nothing_to_a_distance_that_is_exact) {
  const struct {
    Corners quad;
    Vec point;
  } cases[]{{{{0, 1, 0}, {0, 1, 1}, {0, 0, 1}, {0, 0, 0}},
             {0x1.3068d7d71e89ep-39, 0x1.19f845bd4c36ep-1, 0x1.d24661cf7e7dfp-1}},
            {{{0x1.755dfde711052p-3, 0x1.07fdd668c000ep+0, 0x1.56403f04f2a42p-2},
              {0, 0, 0},
              {1, 0, 0},
              {0x1.dedbd6c4eee74p-1, 0x1.0ec0a5282fc14p+0, -0x1.7afbf569ffc00p-3}},
             {0x1.13f9fb4795409p-1, 0x1.0a81431ba37e6p-45, -0x1.295aa4cb4958bp-46}}};
  for (const auto& [quad, point] : cases) {
    const Result<Mp50> integral = evaluate<Mp50>("multiprecision", quad, point, 2);
    ASSERT_TRUE(integral.converged);
    const Result<double> found = evaluate<double>("line_form", quad, point, 2);
    for (int o = 0; o <= 2; ++o) EXPECT_LT(relative(found.of(o), integral.of(o)), 256 * 0x1p-53) << o;
  }
}

// The nearest corner goes first, whatever its number.
TEST(line_form, has_the_bits_of_the_same_quad_with_corners_renumbered) {
  const Corners q{{0, 0, 0}, {1, .125, .25}, {1.125, .875, -.5}, {-.25, 1, .375}};
  for (const auto& corner : q)
    for (const double d : {.25, 1e-3, 1e-9}) {
      const Vec3<double> point = corner + d * Vec3<double>(-.5, .3, .6);
      const Result<double> plain = evaluate<double>("line_form", q, point, 2);
      for (int turn = 1; turn < 4; ++turn) {
        Corners turned(4);
        for (int k = 0; k < 4; ++k) turned[(k + turn) % 4] = q[k];
        const Result<double> found = evaluate<double>("line_form", turned, point, 2);
        for (int o = 0; o <= 2; ++o) {
          const std::size_t entries = plain.of(o).size() / 4;
          for (int k = 0; k < 4; ++k)
            for (std::size_t i = 0; i < entries; ++i)
              EXPECT_EQ(found.of(o)[entries * ((k + turn) % 4) + i], plain.of(o)[entries * k + i])
                  << point.transpose() << ", order " << o;
        }
      }
    }
}

TEST(local_frame, lies_about_the_point_of_its_line_that_is_nearest) {
  int inside = 0;
  for (const double size : {.25, 1., 5.}) {
    Corners q{{0, 0, 0}, {1, .125, .25}, {1.125, .875, -.5}, {-.25, 1, .375}};
    for (auto& corner : q) corner *= size;
    const Vec3<double> point = size * Vec3<double>(.5, .45, -1.5);
    const auto frame = quad_frame<double>(std::span<const Vec3<double>>(q), point);
    ASSERT_TRUE(frame);
    for (const double v : {0., .25, .5, .75, 1.}) {
      const double u = frame_at<double>(*frame, q, point, v).u0;
      const auto distance = [&](double at) { return (frame->start(v) + at * frame->direction(v)).norm(); };
      for (const double other : {0., 1., u - 1e-3, u + 1e-3})
        if (other >= 0 && other <= 1) {
          EXPECT_LE(distance(u), distance(other)) << size << ' ' << v << ' ' << u;
        }
      inside += u > 0 && u < 1;
    }
  }
  EXPECT_GE(inside, 3);
}

// One ulp off the quad a double's differences are nothing but rounding.
TEST(line_form, is_finite_one_ulp_off_a_twisted_quad) {
  for (const double u : {0.125, 0.5, 0.875})
    for (const double direction : {-9.0, 9.0}) {
      Vec point = at(kTwisted, u, 0.375);
      point[2] = std::nextafter(point[2], direction);
      const Result<double> found = evaluate<double>("line_form", kTwisted, point, 0);
      const Result<Mp100> exact = evaluate<Mp100>("line_form", kTwisted, point, 0);
      EXPECT_LT(relative(found.value, exact.value), 1e-15) << u;
    }
}

TEST(outer_rules, say_where_a_singularity_leaves_them_too_few_nodes) {
  const auto whole = [](double width) {
    SingularPairs<double> pairs;
    pairs.add({0.5, width});
    pairs.add({0.75, 0.01});
    OuterRules<double> across;
    find_outer_rules(pairs, 1.5, 12, 36, across);
    return std::ranges::all_of(across.rules, [](const auto& rule) { return rule.whole; });
  };
  EXPECT_TRUE(whole(1e-2));
  EXPECT_TRUE(whole(1e-12));
  EXPECT_FALSE(whole(0));
}

// Moments in double against a fine rule along the line, over feet within, beyond and next to it.
TEST(line_moments, are_the_integrals_along_a_line) {
  const Vec3<Mp50> direction(1, Mp50(1) / 2, Mp50(-1) / 4);
  const Mp50 length2 = direction.dot(direction);
  const Vec3<Mp50> across = Vec3<Mp50>(Mp50(1) / 4, -1, -1).normalized();
  for (const double foot : {0.5, 0.01, -1e-6, -1e-3, -0.25, -0.7, 1.3})
    for (const double height : {1e-9, 1e-5, 1e-3, 0.1, 0.5, 1.2}) {
      const Vec3<Mp50> a = -Mp50(foot) * direction + Mp50(height) * across;
      const Vec3<double> start = convert<double>(a), e = convert<double>(direction);
      const Vec3<double> c = start.cross(e);
      const LineMoments<double> m = moments_about_foot<2>(start, e, 0.0, 1.0, c.dot(c), 17);
      // In s = k sinh w, panels of length one keep off the singularities at +-i pi/2.
      const Mp50 k = height / sqrt(length2), t0 = -Mp50(foot);
      const auto integral = [&](int j, int p) {
        const Mp50 lo = asinh(Mp50(t0 / k)), hi = asinh(Mp50((t0 + 1) / k));
        const int panels = static_cast<int>(Mp50(hi - lo)) + 1;
        const auto& rule = gauss_legendre<Mp50>(40);
        Mp50 sum = 0;
        for (int i = 0; i < panels; ++i)
          for (int n = 0; n < 40; ++n) {
            const Mp50 w = lo + (hi - lo) * (i + rule.nodes[n]) / panels;
            const Mp50 s = k * sinh(w);
            sum += rule.weights[n] * (hi - lo) / panels * k * cosh(w) * pow(s, j) /
                   pow(Mp50((s * s + k * k) * length2), p);
          }
        return static_cast<double>(sum);
      };
      // Rounded input moves the line; r^-2p changes by 2p times that over the distance.
      const double outside = std::max({0.0, -foot, foot - 1});
      const double bound = 64 * 0x1p-53 * (1 + 8 / std::hypot(height, outside));
      const double sizes[3]{integral(0, 2), integral(0, 3), integral(0, 4)};
      for (int j = 0; j <= 2; ++j)
        EXPECT_NEAR(m.p2[j], integral(j, 2), bound * sizes[0]) << foot << ' ' << height << ' ' << j;
      for (int j = 0; j <= 3; ++j)
        EXPECT_NEAR(m.p3[j], integral(j, 3), bound * sizes[1]) << foot << ' ' << height << ' ' << j;
      for (int j = 0; j <= 4; ++j)
        EXPECT_NEAR(m.p4[j], integral(j, 4), bound * sizes[2]) << foot << ' ' << height << ' ' << j;
    }
}

TEST(atan_remainders, are_their_integrals) {
  const auto& rule = gauss_legendre<Mp50>(200);
  for (const double y : {0.0, 1e-20, 1e-3, 0.3, 0.999, 1.0, 2.0, 50.0}) {
    const auto k = atan_remainders<3>(y, 17);
    for (int n = 0; n <= 3; ++n) {
      Mp50 sum = 0;
      for (int i = 0; i < 200; ++i) {
        const Mp50 x2 = rule.nodes[i] * rule.nodes[i];
        sum += rule.weights[i] * pow(x2, n) / pow(Mp50(1 + Mp50(y) * x2), n + 1);
      }
      EXPECT_NEAR(k[n] / static_cast<double>(sum), 1, 1e-14) << y << ' ' << n;
    }
  }
}

}  // namespace
}  // namespace cageproof::adaptive_qmvc::line_form_test
