// SPDX-License-Identifier: MIT
// The weights of a quad, integrated over both parameters, against relations that do not know how they were integrated.
#include "rules/quad/quad_rules.h"
#include "support.h"

namespace cageproof::quadrature_ref {
namespace {

using Vec = Vec3<double>;

struct QuadSample {
  std::string kind;
  Quad<double> corners;
  Vec point;
};

const Quad<double> kPlanar{Vec(0, 0, 0), Vec(1, .125, 0), Vec(1.25, .875, 0), Vec(-.125, 1, 0)};
const Quad<double> kTwisted{Vec(0, 0, 0), Vec(1, .125, .125), Vec(1.125, .875, -.25), Vec(-.125, 1, .375)};
const Quad<double> kSaddle{Vec(0, 0, .75), Vec(1, 0, -.75), Vec(1, 1, .75), Vec(0, 1, -.75)};
const Quad<double> kSlender{Vec(0, 0, 0), Vec(1, 0, .2), Vec(1.1, 1e-10, .2), Vec(0, 2e-10, 1e-10)};

Vec on(const Quad<double>& q, double u, double v) {
  return (1 - u) * (1 - v) * q[0] + u * (1 - v) * q[1] + u * v * q[2] + (1 - u) * v * q[3];
}

// Next to faces, edges, corners and the surface continued, and far away.
std::vector<QuadSample> samples() {
  std::vector<QuadSample> all;
  const auto add = [&](const char* kind, const Quad<double>& q, double h) {
    const Vec n = (q[1] - q[0]).cross(q[3] - q[0]).normalized();
    const Vec face = on(q, .3125, .625), edge = on(q, .4, 0);
    all.push_back({std::string(kind) + " face", q, face - h * (q[1] - q[0]).cross(q[2] - q[1]).normalized()});
    all.push_back({std::string(kind) + " edge", q, edge + h * Vec(.1, -.6, -.8)});
    all.push_back({std::string(kind) + " corner", q, q[0] - h * Vec(.5, .6, .4)});
    all.push_back({std::string(kind) + " outside", q, on(q, .5, -.3) - h * n});
  };
  for (const double h : {1e8, 1.0, 1e-3}) add("planar", kPlanar, h);
  for (const double h : {10.0, 1e-1, 1e-10}) add("twisted", kTwisted, h);
  for (const double h : {1.0, 1e-6}) add("saddle", kSaddle, h);
  add("slender", kSlender, .1);
  return all;
}

template <Scalar R>
Result<R> evaluate_quad(const std::string& name, const Quad<R>& q, const Vec3<R>& point, int order) {
  const auto found = EvaluationRegister::instance().find("quad.mean_value", name);
  if (!found) throw std::runtime_error("no evaluation " + name);
  Result<R> result;
  (*found)(Query<R>{q, point, order}, result);
  return result;
}

template <Scalar R>
Result<R> evaluate_quad(const std::string& name, const QuadSample& s, int order) {
  Quad<R> q;
  for (int k = 0; k < 4; ++k) q[k] = convert<R>(s.corners[k]);
  return evaluate_quad<R>(name, q, convert<R>(s.point), order);
}

// The references of `samples`, integrated once.
const std::vector<Result<Mp50>>& references() {
  static const std::vector<Result<Mp50>> all = [] {
    std::vector<Result<Mp50>> results;
    for (const QuadSample& s : samples()) results.push_back(evaluate_quad<Mp50>("multiprecision", s, 0));
    return results;
  }();
  return all;
}

using Weights = std::vector<Mp100>;

// sum_k w_k (q_k - eta), [T18] Eq 15.
Weights from_weights(const std::vector<Mp50>& w, const Quad<Mp50>& q, const Vec3<Mp50>& point) {
  Weights m(3);
  for (int k = 0; k < 4; ++k)
    for (int i = 0; i < 3; ++i) m[i] += Mp100(w[k]) * (Mp100(q[k][i]) - Mp100(point[i]));
  return m;
}

// The mean vector of the spherical polygon that the border draws on the unit sphere about eta: half the sum of the
// edges' angles times their unit normals ([T18] Eq 16, [J05]).
Vec3<Mp100> mean_vector(const Quad<Mp50>& q, const Vec3<Mp100>& point) {
  Vec3<Mp100> m = Vec3<Mp100>::Zero();
  for (int k = 0; k < 4; ++k) {
    const Vec3<Mp100> a = convert<Mp100>(q[k]) - point, b = convert<Mp100>(q[(k + 1) % 4]) - point;
    const Vec3<Mp100> n = a.cross(b);
    const Mp100 length = sqrt(Mp100(n.dot(n)));
    if (length > 0) m += n * Mp100(atan2(length, Mp100(a.dot(b))) / (2 * length));
  }
  return m;
}

Quad<Mp50> wide(const Quad<double>& q) {
  return {convert<Mp50>(q[0]), convert<Mp50>(q[1]), convert<Mp50>(q[2]), convert<Mp50>(q[3])};
}

TEST(Quad, multiprecision_keeps_its_word_and_the_mean_vector) {
  int index = 0;
  for (const QuadSample& s : samples()) {
    const Result<Mp50>& r = references()[index++];
    EXPECT_TRUE(r.converged && r.stated_digits >= 30) << s.kind << r.stated_digits;
    const Quad<Mp50> q = wide(s.corners);
    const Vec3<Mp50> point = convert<Mp50>(s.point);
    const Vec3<Mp100> m = mean_vector(q, convert<Mp100>(s.point));
    const Weights found = from_weights(r.value, q, point);
    // Weights may be large where the vector is not (next to a corner): the sum's own terms are the scale.
    Mp100 scale = 0, difference = 0;
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < 3; ++i) scale += abs(Mp100(r.value[k]) * (Mp100(q[k][i]) - Mp100(point[i])));
    for (int i = 0; i < 3; ++i) difference += abs(found[i] - m[i]);
    EXPECT_LE(difference, scale * pow(Mp100(10), -28)) << s.kind << ' ' << log10_of(Mp100(difference / scale));
  }
}

// Derivatives of both sides of sum_k w_k (q_k - eta) = m agree; those of the right side are central differences of step
// 1e-19.
TEST(Quad, derivatives_of_the_mean_vector_relation) {
  for (const QuadSample& s :
       {QuadSample{"twisted", kTwisted, {.4, .5, -.2}}, QuadSample{"planar", kPlanar, {1.5, .3, .01}},
        QuadSample{"saddle", kSaddle, on(kSaddle, .5, .5) + Vec(0, 0, .001)}}) {
    const auto r = evaluate_quad<Mp50>("multiprecision", s, 2);
    const Quad<Mp50> q = wide(s.corners);
    const Vec3<Mp100> eta = convert<Mp100>(s.point);
    const Mp100 d = pow(Mp100(10), -19);
    const auto at = [&](int i, int a, int j, int b) {
      Vec3<Mp100> moved = eta;
      moved[i] += a * d;
      moved[j] += b * d;
      return mean_vector(q, moved);
    };
    std::vector<Mp100> gradient, gradient_found, hessian, hessian_found;
    for (int c = 0; c < 3; ++c)
      for (int i = 0; i < 3; ++i) {
        gradient.push_back((at(i, 1, i, 0)[c] - at(i, -1, i, 0)[c]) / (2 * d));
        Mp100 sum = 0;
        for (int k = 0; k < 4; ++k) {
          sum += Mp100(r.gradient[3 * k + i]) * (Mp100(q[k][c]) - eta[c]);
          if (i == c) sum -= Mp100(r.value[k]);
        }
        gradient_found.push_back(sum);
        for (int j = 0; j < 3; ++j) {
          const Mp100 corners = at(i, 1, j, 1)[c] - at(i, 1, j, -1)[c] - at(i, -1, j, 1)[c] + at(i, -1, j, -1)[c];
          hessian.push_back(corners / (4 * d * d));
          Mp100 second = 0;
          for (int k = 0; k < 4; ++k) {
            second += Mp100(r.hessian[9 * k + 3 * i + j]) * (Mp100(q[k][c]) - eta[c]);
            if (i == c) second -= Mp100(r.gradient[3 * k + j]);
            if (j == c) second -= Mp100(r.gradient[3 * k + i]);
          }
          hessian_found.push_back(second);
        }
      }
    // Differences are off by d^2 times two more derivatives over the distance squared.
    EXPECT_LT(log10_error(gradient_found, gradient), -27) << s.kind;
    EXPECT_LT(log10_error(hessian_found, hessian), -27) << s.kind;
  }
}

// A hat function of the whole is the combination of its four quarters' hats with its values at their corners.
TEST(Quad, is_the_sum_over_its_four_quarters) {
  for (const QuadSample& s :
       {QuadSample{"twisted", kTwisted, on(kTwisted, .25, .25) + Vec(0, 0, 1e-3)},
        QuadSample{"planar", kPlanar, {.3, .4, -.2}}, QuadSample{"saddle", kSaddle, {.9, -.1, .3}}}) {
    const Quad<Mp50> q = wide(s.corners);
    const Vec3<Mp50> point = convert<Mp50>(s.point);
    const auto whole = evaluate_quad<Mp50>("multiprecision", q, point, 2);
    Result<Mp50> sum;
    sum.reset(4, 3, 2);
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        Quad<Mp50> part;
        std::array<std::array<Mp50, 4>, 4> hat;
        for (int k = 0; k < 4; ++k) {
          const Mp50 u = Mp50(i + (k == 1 || k == 2)) / 2, v = Mp50(j + (k >= 2)) / 2;
          hat[k] = {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
          part[k] = q[0] * hat[k][0] + q[1] * hat[k][1] + q[2] * hat[k][2] + q[3] * hat[k][3];
        }
        const auto r = evaluate_quad<Mp50>("multiprecision", part, point, 2);
        for (int o = 0; o < 3; ++o) {
          const std::size_t entries = r.of(o).size() / 4;
          for (int k = 0; k < 4; ++k)
            for (int c = 0; c < 4; ++c)
              for (std::size_t e = 0; e < entries; ++e)
                sum.of(o)[c * entries + e] += hat[k][c] * r.of(o)[k * entries + e];
        }
      }
    for (int o = 0; o < 3; ++o) EXPECT_LT(log10_error(sum.of(o), whole.of(o)), -28) << s.kind << o;
  }
}

TEST(Quad, gauss_converges_to_it) {
  const QuadSample s{"twisted", kTwisted, {.4, .5, -1}};
  const auto truth = evaluate_quad<Mp50>("multiprecision", s, 2);
  for (int o = 0; o < 3; ++o) {
    double before = 0;
    for (const char* name : {"gauss-4", "gauss-8", "gauss-16", "gauss-32"}) {
      const double error = log10_error(evaluate_quad<Mp50>(name, s, 2).of(o), truth.of(o));
      EXPECT_LT(error, 1.6 * before) << name;
      before = error;
    }
    EXPECT_LT(before, -22);
    EXPECT_LT(log10_error(evaluate_quad<double>("gauss-32", s, 2).of(o), truth.of(o)), -14);
  }
}

TEST(Quad, gauss_keeps_the_height_next_to_the_plane) {
  for (const double h : {0.0, 1e-16, 1e-300}) {
    const QuadSample s{"planar", kPlanar, {3, .5, -h}};
    const auto found = evaluate_quad<double>("gauss-32", s, 1);
    const auto truth = evaluate_quad<Mp50>("multiprecision", s, 1);
    for (int o = 0; o < 2; ++o) EXPECT_LT(log10_error(found.of(o), truth.of(o)), -13) << h;
    if (h == 0) {
      for (const double w : found.value) EXPECT_EQ(w, 0);
    }
  }
}

// Next to a corner at the origin the others' differences to the point lose all that it is off the plane by.
TEST(Quad, gauss_keeps_the_height_next_to_every_corner) {
  const std::array<Vec, 4> around{Vec(0, 0, 0), Vec(1, .25, -.5), Vec(.75, 1.125, .5), Vec(-.25, .875, 1)};
  for (int turn = 0; turn < 4; ++turn) {
    QuadSample s{"turned", {}, Vec(-3e-20, -1e-20, 7e-20)};
    for (int k = 0; k < 4; ++k) s.corners[(k + turn) % 4] = around[k];
    const auto found = evaluate_quad<double>("gauss-8", s, 0);
    const auto truth = evaluate_quad<Mp50>("gauss-8", s, 0);
    EXPECT_LT(log10_error(found.value, truth.value), -13) << turn;
  }
}

// The tolerance that docs and headers state.
TEST(Quad, adaptive_aims_at_its_tolerance) {
  EXPECT_EQ(quad::adaptive_tolerance<float>(), 1e-4);
  EXPECT_EQ(quad::adaptive_tolerance<double>(), 1e-10);
  EXPECT_EQ(quad::adaptive_tolerance<Mp50>(), 1e-10);
}

TEST(Quad, adaptive_is_honest) {
  int met = 0, met_float = 0, count = 0;
  for (const QuadSample& s : samples()) {
    const Result<Mp50>& truth = references()[count++];
    const auto found = evaluate_quad<double>("adaptive", s, 0);
    EXPECT_LE(found.nodes, kAdaptiveNodeLimit);
    if (found.stated_digits > 0) {
      EXPECT_LE(log10_error(found.value, truth.value), -found.stated_digits) << s.kind;
    }
    met += found.converged;
    if (s.point.norm() < 100 && s.kind.starts_with("twisted"))
      met_float += evaluate_quad<float>("adaptive", s, 1).converged;
  }
  EXPECT_EQ(met, count);
  EXPECT_GE(met_float, 8);
  const QuadSample close{"twisted", kTwisted, on(kTwisted, .3, .6) + Vec(0, 0, .01)};
  const auto truth = evaluate_quad<Mp50>("multiprecision", close, 2);
  const auto found = evaluate_quad<double>("adaptive", close, 2);
  EXPECT_TRUE(found.converged && found.stated_digits >= 10);
  for (int o = 0; o < 3; ++o) EXPECT_LE(log10_error(found.of(o), truth.of(o)), -found.stated_digits);
}

TEST(Quad, without_a_limit_on_the_quad_and_without_geometry) {
  for (const auto& [u, v] : {std::pair{.5, .5}, {.25, 0.}, {0., 0.}}) {
    const QuadSample s{"saddle", kSaddle, on(kSaddle, u, v)};
    const auto r = evaluate_quad<Mp50>("multiprecision", s, 1);
    EXPECT_TRUE(r.converged && isnan(r.value[0]) && isnan(r.gradient[0]) && std::isnan(r.stated_digits));
    EXPECT_FALSE(evaluate_quad<double>("adaptive", s, 0).converged);
  }
  QuadSample bad{"planar", kPlanar, {.1, .1, .1}};
  bad.corners[2][1] = std::numeric_limits<double>::infinity();
  const QuadSample line{"line", {Vec(0, 0, 0), Vec(1, 0, 0), Vec(2, 0, 0), Vec(3, 0, 0)}, {.1, .1, .1}};
  for (const char* name : {"gauss-4", "adaptive", "multiprecision"})
    for (const QuadSample& s : {bad, line})
      EXPECT_TRUE(std::isnan(evaluate_quad<double>(name, s, 1).gradient[0])) << name;
}

// Newton's method ends at the nearest point of narrow twisted quads too: else these points would be none of the quad's.
TEST(Quad, sees_points_on_narrow_twisted_ones) {
  const std::array<Quad<double>, 2> narrow{
      Quad<double>{Vec(-0.14606474060565233, -0.0008593544916948304, 0.00040213228840002557),
                   Vec(0.6528186975046992, -0.0005585475446423516, 0.00017928449142345926),
                   Vec(0.6412687478587031, 0.0003957917360821739, -7.711699527135352e-05),
                   Vec(-0.058214169926941395, 5.39320899406448e-05, -3.5540892895369325e-05)},
      Quad<double>{Vec(-1.060554993338883, -0.0013931933026469778, -0.0005427273536042776),
                   Vec(0.2740425942465663, -0.001913728116051061, -0.00016621971371932887),
                   Vec(0.04627178888767958, 0.002810085268720286, 0.00029810791966156103),
                   Vec(-0.8626542212441564, 0.0019654762763821054, 0.0004952912604494486)}};
  for (const Quad<double>& q : narrow) {
    const QuadSample s{"narrow", q, Vec(0, 0, 0)};
    const auto r = evaluate_quad<Mp50>("multiprecision", s, 0);
    EXPECT_TRUE(r.converged && isnan(r.value[0]) && std::isnan(r.stated_digits));
    EXPECT_TRUE(std::isnan(evaluate_quad<double>("adaptive", s, 0).value[0]));
  }
}

TEST(Quad, units_of_length_change_nothing_but_the_scale) {
  const QuadSample s{"twisted", kTwisted, {.4, .5, -.1}};
  QuadSample scaled = s;
  for (Vec& corner : scaled.corners) corner *= 0x1p-400;
  scaled.point *= 0x1p-400;
  for (const char* name : {"gauss-8", "adaptive", "multiprecision"}) {
    const auto one = evaluate_quad<double>(name, s, 0), other = evaluate_quad<double>(name, scaled, 0);
    for (int k = 0; k < 4; ++k) EXPECT_EQ(one.value[k] * 0x1p400, other.value[k]) << name;
  }
}

// Beside the quad, close to its plane, weights are linear in the height, whose 290 digits no scalar holds.
TEST(quad_heights, are_exact_beside_the_quad) {
  const Quad<double> q{Vec(-1.5, 1.25, 1.375), Vec(.5, 1.25, .375), Vec(.5, 3.25, 1.375), Vec(-1.5, 3.25, 2.375)};
  const auto slope = [&](double h) {
    const Quad<Mp50> wide{convert<Mp50>(q[0]), convert<Mp50>(q[1]), convert<Mp50>(q[2]), convert<Mp50>(q[3])};
    Result<Mp50> found = evaluate_quad<Mp50>("multiprecision", wide, convert<Mp50>(Vec(0, -h, 0)), 0);
    EXPECT_TRUE(found.converged);
    for (Mp50& x : found.value) x /= Mp50(h);
    return found.value;
  };
  const auto expected = slope(1e-30);
  for (const double h : {1e-100, 1e-291}) {
    const auto found = slope(h);
    for (int k = 0; k < 4; ++k)
      EXPECT_LT(std::abs(static_cast<double>(Mp50(found[k] / expected[k] - 1))), 1e-28) << h << ' ' << k;
  }
}

// Squares of what such a quad gives underflow, and with them the error that the rule would find.
TEST(quad_adaptive, finds_its_error_as_far_away_as_doubles_reach) {
  const Quad<double> q{Vec(-0x1.9da24f862f2aep+20, -0x1.4aee9d525d91p+21, -0x1.5d42aa836c17cp+20),
                       Vec(-0x1.9da23f9addc08p+20, -0x1.4aeead525d91p+21, -0x1.5d42bac36c17cp+20),
                       Vec(-0x1.9da22f863160cp+20, -0x1.4aeead525d91p+21, -0x1.5d42ca836c17cp+20),
                       Vec(-0x1.9da24c862f2aep+20, -0x1.4aee9e525d91p+21, -0x1.5d42ab836c17cp+20)};
  for (const double far : {0x1p+307, 0x1p+290, 0x1p+200}) {
    const Vec point = far * Vec(-.4, .5, .6);
    const Result<double> found = evaluate_quad<double>("adaptive", q, point, 0);
    const Result<double> truth = evaluate_quad<double>("multiprecision", q, point, 0);
    double error = 0, size = 0;
    for (int k = 0; k < 4; ++k) {
      error = std::hypot(error, found.value[k] - truth.value[k]);
      size = std::hypot(size, truth.value[k]);
    }
    EXPECT_TRUE(found.converged) << far;
    EXPECT_LE(error, std::pow(10, -found.stated_digits) * size) << far;
  }
}

// Not on the quad, but nearer than powers of the distance are doubles: beside a side in the plane, where nothing is
// seen of the quad, and on the other side than limits are taken from. Found by hunts.
TEST(quad_adaptive, states_nothing_next_to_the_quad) {
  struct Case {
    std::string formula;
    int order;
    Quad<double> corners;
    Vec point;
  };
  const Quad<double> upright{Vec(0, 0, -0.5), Vec(0, 0, 0.5), Vec(1, 0, 0.5), Vec(1, 0, -0.5)};
  const Quad<double> level{Vec(0, 0, 0), Vec(3, -4, 0), Vec(-1, -3, 0), Vec(-1, -1, 0)};
  const Quad<double> twisted{Vec(0.625, 1.171875, -1.421875), Vec(0.625, 1.171875, -0.421875),
                             Vec(-0.375, -0.828125, 0.578125), Vec(-0.375, 0.171875, -1.421875)};
  const std::array parameters{1.5, 0.5};
  for (const Case& c : {Case{"quad.double_layer", 0, upright, Vec(-0x1.ep-461, 0, 0)},
                        Case{"quad.kelvin_traction", 0, upright, Vec(-0x1p-1072, 0, 0)},
                        Case{"quad.solid_angle", 0, level, Vec(0, 0x1p-1074, 0)},
                        Case{"quad.single_layer", 1, twisted, Vec(0x1.a8p-518, 0, 0)},
                        Case{"quad.biharmonic_double_layer", 2, twisted, Vec(-0x1.5ep-786, 0, 0)},
                        Case{"quad.kelvin_displacement", 1, twisted, Vec(0x1.08p-700, 0, 0)}}) {
    const auto adaptive = EvaluationRegister::instance().find(c.formula, "adaptive");
    const std::span<const double> given(parameters.data(), c.formula.starts_with("quad.kelvin") ? 2 : 0);
    Result<double> found;
    (*adaptive)(Query<double>{c.corners, c.point, c.order, given}, found);
    EXPECT_FALSE(found.converged) << c.formula;
    EXPECT_EQ(found.stated_digits, 0) << c.formula;
    // On the planar ones, where values have limits.
    if (c.order > 0) continue;
    (*adaptive)(Query<double>{c.corners, (c.corners[0] + c.corners[2]) / 2, 0, given}, found);
    EXPECT_TRUE(found.converged) << c.formula;
    EXPECT_GT(found.stated_digits, 8) << c.formula;
  }
}

}  // namespace
}  // namespace cageproof::quadrature_ref
