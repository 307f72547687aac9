// SPDX-License-Identifier: MIT
// The potentials on bilinear quads against the integrals of their kernels as plain sums in two dimensions, against
// relations that share nothing with them, and in double against 100 digits.
#include "../src/quad/potentials/potential_parts.h"
#include "quad/engine/singular_pairs.h"
#include "quads.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>
#include <span>

namespace cageproof::adaptive_qmvc::quad_potentials_test {
namespace {

using Vec = Vec3<double>;
using Eigen::Matrix3d;

constexpr std::array kPotentials{Potential::SingleLayer,           Potential::DoubleLayer,
                                 Potential::BiharmonicSingleLayer, Potential::BiharmonicDoubleLayer,
                                 Potential::KelvinDisplacement,    Potential::KelvinTraction};
constexpr double kBeta = 0.375;  // exact, and so are 1 - beta and 1 - 2 beta

const Quad<double> kSquare{Vec(0, 0, 0), Vec(1, 0, 0), Vec(1, 1, 0), Vec(0, 1, 0)};
const Quad<double> kTwisted{Vec(0, 0, 0), Vec(1, 0, 0.25), Vec(1.125, 1, -0.25), Vec(-0.125, 0.875, 0.25)};
const Quad<double> kStrong{Vec(0, 0, 0.625), Vec(1, 0, -0.625), Vec(1, 1, 0.625), Vec(0, 1, -0.625)};
const Quad<double> kDart{Vec(0, 0, 0), Vec(1, 0, 0), Vec(0.25, 0.25, 0), Vec(0, 1, 0)};
const Quad<double> kLong{Vec(0, 0, 0), Vec(8, 0, 1), Vec(7, 0.5, 0), Vec(0.25, 0.375, 0)};

template <class R>
PotentialTask<R> task_of(Potential potential, int order, double digits) {
  PotentialTask<R> task{potential, order, digits};
  const R sphere = 4 * pi<R>();
  const bool displacement = potential == Potential::KelvinDisplacement,
             traction = potential == Potential::KelvinTraction;
  task.parameters[0] = (displacement ? R(1 - kBeta) : traction ? R(1 - 2 * kBeta) : R(1)) / sphere;
  task.parameters[1] = (displacement ? R(kBeta) : traction ? R(6 * kBeta) : R(1)) / sphere;
  return task;
}

template <class R>
PotentialTensors<R> found(Potential potential, const Quad<R>& q, const Vec3<R>& eta, int order, double digits) {
  PotentialTensors<R> tensors;
  const Statement statement = potential_form<R>(q, eta, task_of<R>(potential, order, digits), tensors);
  EXPECT_TRUE(statement.converged);
  return tensors;
}

// The kernels, times 4 pi, of x = xi - eta and N ([T24] Eq 5, 47, 49).
template <class R>
std::vector<R> kernel(Potential potential, const Vec3<R>& x, const Vec3<R>& n) {
  const R r2 = x.dot(x), r = sqrt(r2), r3 = r * r2, g = n.dot(x);
  std::vector<R> entries;
  switch (potential) {
    case Potential::SingleLayer: return {R(1 / r)};
    case Potential::DoubleLayer: return {R(g / r3)};
    case Potential::BiharmonicSingleLayer: return {R(r / 2)};
    case Potential::BiharmonicDoubleLayer: return {R(-g / (2 * r))};
    default: break;
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const R same(i == j ? 1 : 0);
      if (potential == Potential::KelvinDisplacement)
        entries.push_back(R((1 - kBeta) * same / r + kBeta * x[i] * x[j] / r3));
      else
        entries.push_back(
            R((1 - 2 * kBeta) * (g * same + n[i] * x[j] - x[i] * n[j]) / r3 + 6 * kBeta * g * x[i] * x[j] / (r3 * r2)));
    }
  return entries;
}

// Tensor Gauss rules on cells that are halved until none is larger than half its distance: corner after corner.
template <class R>
std::vector<R> plain_integral(Potential potential, const Quad<R>& q, const Vec3<R>& eta) {
  const auto& rule = gauss_legendre<R>(18);
  std::vector<R> sums(4 * static_cast<std::size_t>(entries_of(potential)), R(0));
  const auto at = [&](const R& u, const R& v) {
    return Vec3<R>(combined<R>(q, {R((1 - u) * (1 - v)), R(u * (1 - v)), R(u * v), R((1 - u) * v)}));
  };
  const auto cell = [&](const auto& self, double u, double v, double size) -> void {
    const Vec3<R> middle = at(R(u + size / 2), R(v + size / 2)) - eta;
    const double distance = static_cast<double>(R(sqrt(R(middle.dot(middle)))));
    double diameter = 0;
    for (const double s : {-.5, .5}) {
      const Vec3<R> half = at(R(u + size / 2 + s * size), R(v + size / 2 + size / 2)) - eta - middle;
      diameter = std::max(diameter, 2 * static_cast<double>(R(sqrt(R(half.dot(half))))));
    }
    if (diameter > 0.8 * distance) {
      for (const double du : {0., size / 2})
        for (const double dv : {0., size / 2}) self(self, u + du, v + dv, size / 2);
      return;
    }
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
      for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
        const R p = u + size * rule.nodes[i], s = v + size * rule.nodes[j];
        const Vec3<R> along_u = (1 - s) * (q[1] - q[0]) + s * (q[2] - q[3]),
                      along_v = (1 - p) * (q[3] - q[0]) + p * (q[2] - q[1]);
        const std::vector<R> entries = kernel<R>(potential, at(p, s) - eta, along_u.cross(along_v));
        const R weight = size * size * rule.weights[i] * rule.weights[j] / (4 * pi<R>());
        const std::array<R, 4> hats{R((1 - p) * (1 - s)), R(p * (1 - s)), R(p * s), R((1 - p) * s)};
        for (std::size_t k = 0; k < 4; ++k)
          for (std::size_t e = 0; e < entries.size(); ++e)
            sums[k * entries.size() + e] += weight * hats[k] * entries[e];
      }
  };
  cell(cell, 0, 0, 1);
  return sums;
}

template <class A, class B>
double relative(const std::vector<A>& a, const std::vector<B>& b) {
  Mp200 difference = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Mp200 d = Mp200(a[i]) - Mp200(b[i]);
    difference += d * d;
    size += Mp200(b[i]) * Mp200(b[i]);
  }
  return static_cast<double>(Mp200(sqrt(Mp200(difference / size))));
}

Vec inside(const Quad<double>& q, double u, double v, double distance) {
  return combined(q, basis_at(u, v)) - distance * normal_at(q, u, v).normalized();
}

// The kernels' derivatives as they are, line by line: no derivative along the quad is moved. A hundred digits hold
// forty where distances are ordinary; limits are taken in 200.
template <class R>
PotentialTensors<R> plain_lines(Potential potential, const Quad<double>& corners, const Vec3<R>& eta, int order,
                                double digits) {
  const Quad<R> wide = convert_quad<R>(corners);
  const auto q = quad_frame<R>(wide, eta);
  OuterRules<R> across;
  find_outer_rules(singular_pairs(*q), order + 1, digits, 300, across, false);
  const PotentialTask<R> task = task_of<R>(potential, order, digits);
  PotentialParts<R> parts(task);
  for (const OuterRule<R>& rule : across.rules) {
    const auto local =
        rule.plain ? LocalFrame<R>(*q) : frame_at<R>(*q, wide, eta, std::clamp(rule.centre, rule.lo, rule.hi));
    PotentialSums<R> sums(kernel_tape(potential, order), digits);
    sums.add_lines(LineReferences<R>(local, *q), rule, R(rule.centre - local.v0), across.panels_of(rule));
    parts.add(sums, NormalAxes<R>(), 0);
  }
  PotentialTensors<R> tensors;
  parts.put(q->unit, tensors);
  return tensors;
}

TEST(QuadPotentials, are_the_integrals_of_their_kernels) {
  using R = Mp50;
  for (const Quad<double>& corners : {kSquare, kTwisted, kDart})
    for (const double distance : {2.0, -0.25}) {
      const Quad<R> q = convert_quad<R>(corners);
      const Vec3<R> eta = convert<R>(inside(corners, 0.375, 0.3125, distance));
      for (const Potential potential : kPotentials)
        EXPECT_LT(relative(found<R>(potential, q, eta, 0, 36).of[0], plain_integral<R>(potential, q, eta)), 1e-19)
            << static_cast<int>(potential) << ' ' << distance;
    }
}

// By central differences of the definition.
TEST(QuadPotentials, have_the_derivatives_of_those_integrals) {
  using R = Mp50;
  const R step("1e-6");
  const Quad<R> q = convert_quad<R>(kTwisted);
  const Vec3<R> eta = convert<R>(inside(kTwisted, 0.375, 0.3125, 0.5));
  for (const Potential potential : kPotentials) {
    const auto moved = [&](int i, int a, int j, int b) {
      Vec3<R> to = eta;
      to[i] += a * step;
      to[j] += b * step;
      return plain_integral<R>(potential, q, to);
    };
    const PotentialTensors<R> form = found<R>(potential, q, eta, 2, 36);
    const std::vector<R> middle = plain_integral<R>(potential, q, eta);
    std::vector<R> gradient(3 * middle.size()), hessian(9 * middle.size());
    for (int i = 0; i < 3; ++i) {
      const auto after = moved(i, 1, i, 0), before = moved(i, -1, i, 0);
      for (std::size_t e = 0; e < middle.size(); ++e) {
        gradient[3 * e + i] = (after[e] - before[e]) / (2 * step);
        hessian[9 * e + 4 * i] = (after[e] - 2 * middle[e] + before[e]) / (step * step);
      }
      for (int j = 0; j < i; ++j) {
        const auto pp = moved(i, 1, j, 1), pm = moved(i, 1, j, -1), mp = moved(i, -1, j, 1), mm = moved(i, -1, j, -1);
        for (std::size_t e = 0; e < middle.size(); ++e)
          hessian[9 * e + 3 * i + j] = hessian[9 * e + 3 * j + i] = (pp[e] - pm[e] - mp[e] + mm[e]) / (4 * step * step);
      }
    }
    EXPECT_LT(relative(form.of[1], gradient), 1e-10) << static_cast<int>(potential);
    EXPECT_LT(relative(form.of[2], hessian), 1e-9) << static_cast<int>(potential);
  }
}

// Derivatives along the quad moved onto its border, in double, against those of the kernels in 100 digits.
TEST(QuadPotentials, keep_15_digits_in_double_at_all_distances) {
  for (const Quad<double>& corners : {kSquare, kTwisted, kStrong, kDart})
    for (const double distance : {3.0, 0.1, 1e-3, 1e-7, 1e-12})
      for (const Potential potential : kPotentials) {
        const Vec eta = inside(corners, 0.375, 0.3125, distance);
        const auto form = found<double>(potential, corners, eta, 2, 17);
        const auto truth =
            plain_lines(potential, corners, convert<Mp100>(eta), 2, 22 - 2 * std::log10(std::min(1., distance)));
        for (int o = 0; o <= 2; ++o)
          EXPECT_LT(relative(form.of[o], truth.of[o]), 1.5e-14)
              << static_cast<int>(potential) << ' ' << distance << " order " << o;
      }
}

// Integers, zeros, corners that coincide, sides that cross; in the quad's plane, over its corners, on its sides' lines.
TEST(QuadPotentials, keep_their_digits_at_ordinary_places) {
  const Quad<double> bow_tie{Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0), Vec(1, 1, 0)};
  const Quad<double> collapsed{Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 1), Vec(0, 1, 1)};
  const Quad<double> upright{Vec(0, 0, 0), Vec(2, 0, 0), Vec(2, 0, 2), Vec(0, 0, 2)};
  const std::array points{Vec(0.5, 0.5, 1), Vec(2, 0.5, 0), Vec(3, 0, 0),  Vec(0, 0, 3),
                          Vec(0, 0, -1),    Vec(1, 2, 0),   Vec(-1, 0, 0), Vec(0.5, 0.25, -0x1p-20)};
  for (const Quad<double>& corners : {kSquare, bow_tie, collapsed, upright})
    for (const Vec& point : points)
      for (const Potential potential : kPotentials) {
        ASSERT_FALSE(on_quad(corners, point));
        const auto form = found<double>(potential, corners, point, 2, 17);
        const auto truth = plain_lines(potential, corners, convert<Mp100>(point), 2, 40);
        for (int o = 0; o <= 2; ++o) {
          const bool is_zero = std::ranges::all_of(truth.of[o], [](const Mp100& x) { return x == 0; });
          if (is_zero) EXPECT_TRUE(std::ranges::all_of(form.of[o], [](double x) { return x == 0; }));
          else
            EXPECT_LT(relative(form.of[o], truth.of[o]), 1.5e-14)
                << static_cast<int>(potential) << " from " << point.transpose() << " order " << o;
        }
      }
}

// Beside a quad ten times as long as it is wide, all of whose sides are unequal, the way to a corner.
TEST(QuadPotentials, keep_their_digits_next_to_a_long_quads_corner) {
  for (const double distance : {1e-2, 1e-8})
    for (const Potential potential : kPotentials) {
      const Vec eta = kLong[2] - distance * Vec(0.25, -0.5, 1);
      const auto form = found<double>(potential, kLong, eta, 1, 17);
      const auto truth = plain_lines(potential, kLong, convert<Mp200>(eta), 1, 40);
      for (int o = 0; o <= 1; ++o)
        EXPECT_LT(relative(form.of[o], truth.of[o]), 4e-14)
            << static_cast<int>(potential) << ' ' << distance << " order " << o;
    }
}

// Derivatives of these orders up to the second have their digits, whichever corner is the first.
void expect_digits_in_every_turn(const Quad<double>& corners, const Vec& point, std::span<const Potential> potentials,
                                 int lowest_order) {
  for (std::size_t first = 0; first < 4; ++first)
    for (const Potential potential : potentials) {
      Quad<double> q;
      for (std::size_t k = 0; k < 4; ++k) q[k] = corners[(k + first) % 4];
      const auto form = found<double>(potential, q, point, 2, 17);
      const auto truth = plain_lines(potential, q, convert<Mp100>(point), 2, 40);
      for (int o = lowest_order; o <= 2; ++o)
        EXPECT_LT(relative(form.of[o], truth.of[o]), 1.5e-14)
            << static_cast<int>(potential) << " from corner " << first << " order " << o;
    }
}

// Three corners next to the point, the fourth 1e5 times as far away: a short side across the lines is known to its own
// rounding, not to that of the long one opposite. Found by hunts.
TEST(QuadPotentials, keep_their_digits_beside_sides_that_are_short) {
  struct Case {
    Quad<double> corners;
    Vec point;
  };
  const std::array cases{
      Case{
          {Vec(-0x1.da7c00608484ep-16, 0x1.8af3a69e10396p-17, 0), Vec(-0x1.114e13607109cp-17, 0x1.589844ae70396p-17, 0),
           Vec(-0x1.3aafc086f2138p-18, 0x1.ec0212602c396p-17, 0), Vec(-0x1.760f21683b021p-2, 0x1.246b0bd12f4ebp+0, 0)},
          Vec(-0x1.c90c3aae8909cp-17, -0x1.f1911dc87f1a7p-19, 0)},
      Case{{Vec(-0x1.15fcddf6ep-19, 0x1.2dcee187f8p-19, 0x1.b436d9c6p-19),
            Vec(-0x1.51bd822648p-17, -0x1.0ab20d7ebp-21, 0x1.54a59e3ep-21),
            Vec(-0x1.6cef7784bd9d6p-2, -0x1.92991b0713eedp-1, -0x1.fec6e2a8c3e89p-1),
            Vec(0x1.187507408p-19, -0x1.307d3613e8p-19, -0x1.b816d4294p-19)},
           Vec(0x1.7baca304p-21, 0x1.1fd189864p-22, 0x1.1cc6da68p-22)},
      Case{{Vec(0x1.0b382b205p-18, -0x1.0999b8fb2p-15, -0x1.0c790279dc8p-14),
            Vec(0x1.3f094ce94p-17, -0x1.6f9c07732p-19, -0x1.ff8da14108p-18),
            Vec(0x1.5109a16848p-17, -0x1.6962ee142p-19, -0x1.00c5f06a14p-17),
            Vec(0x1.9003763663fc6p-1, -0x1.ace9760c0bdd4p-3, -0x1.30c0688c30467p-1)},
           Vec(-0x1.13bae9b33cp-15, -0x1.6d7e11e2f6p-16, -0x1.2d74b47714p-15)},
      Case{{Vec(-0x1.7d687c043ccp-18, 0x1.43b9dc4aff3c1p-17, 0x1.94b9d2169ba13p-19),
            Vec(0x1.005bc19e069ep-1, 0x1.6a4077f56a89dp-1, -0x1.9fae31f570b1ep-1),
            Vec(-0x1.ae69f0ae3b9bep-22, 0x1.1bfc61b6bad6cp-19, -0x1.3839e8efc3f81p-22),
            Vec(-0x1.192002a9b3p-28, 0x1.8b6dc90c97806p-18, 0x1.4c6p-18)},
           Vec(-0x1.7d0000130a0afp-18, 0x1.000000d92d4c7p-21, -0x1.28e5fe82b12d2p-23)},
      Case{{Vec(0x1.7635453p-18, -0x1.a2dfe49c8p-14, -0x1.364a3ab44p-14),
            Vec(0x1.db8f5ecc54116p+3, -0x1.3a01db4f8a0fp+2, -0x1.6753194aaba0ep+3),
            Vec(0x1.08a94038cp-13, 0x1.18355c06p-14, 0x1.906b8ff3cp-13), Vec(0, 0, 0)},
           Vec(-0x1p-46, -0x1.4da9d676p-14, -0x1.2fbb7bb800003p-17)}};
  for (const Case& seen : cases) {
    SCOPED_TRACE(&seen - cases.data());
    // Values may be nothing in the quad's plane.
    expect_digits_in_every_turn(seen.corners, seen.point, kPotentials, 1);
  }
}

// 1e5 times as long as wide, across all axes: turned to those of the normal, long sides must know how wide it is. The
// measure du dv does not. Found by a hunt.
TEST(QuadPotentials, keep_their_digits_over_thin_quads) {
  const Quad<double> corners{Vec(-0x1.7b2532964384bp+4, -0x1.61dacd2b3b132p+5, -0x1.e4ea422bc0cap+4),
                             Vec(-0x1.34762ed3e6b88p+5, -0x1.3a9a6eba9e508p+5, -0x1.313fed50a2ffbp+4),
                             Vec(-0x1.347670fe36c6bp+5, -0x1.3a9a91c149d14p+5, -0x1.3140b5866af99p+4),
                             Vec(-0x1.34766e10a6dd1p+5, -0x1.3a9ac61d2d6b9p+5, -0x1.3141031910da6p+4)};
  const Vec point(-0x1.5804c4e03d2d3p+4, -0x1.67a7457365d24p+5, -0x1.ff7510885ed0ep+4);
  expect_digits_in_every_turn(corners, point, std::array{Potential::SingleLayer, Potential::KelvinDisplacement}, 0);
}

// A rounding once took this point for one beside the side, whose limit was then asked for without end. The single layer
// is continuous there.
TEST(QuadPotentials, have_values_on_sides_that_are_short) {
  const Quad<double> q{
      Vec(-0x1.11759p-2, -0x1.c2e466p-1, 0x1.f21668p-5), Vec(-0x1.783374p-2, -0x1.0b3f7cp-2, 0x1.9d64d8p-2),
      Vec(0x1.d82f94p-2, -0x1.33b57ep-1, -0x1.5d7ebep-15), Vec(0x1.d82f94p-2, -0x1.33b57ep-1, -0x1.5d7ed8p-15)};
  const Vec point(0x1.d82f94p-2, -0x1.33b57ep-1, -0x1.5d7ecp-15);
  Quad<Mp100> wide;
  for (int k = 0; k < 4; ++k) wide[k] = convert<Mp100>(q[k]);
  Vec3<Mp100> beside = convert<Mp100>(point);
  beside[0] += Mp100("1e-40");
  const auto on = found<double>(Potential::SingleLayer, q, point, 0, 17);
  const auto near = found<Mp100>(Potential::SingleLayer, wide, beside, 0, 30);
  ASSERT_EQ(on.of[0].size(), 4u);
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(on.of[0][k], static_cast<double>(near.of[0][k]), 1e-14) << k;
}

// Beside a side that is longer than its opposite one lines are counted from, however the corners are numbered; sums are
// two triangles' solid angle. Points lie on either side of the side's line, where that changes by a turn.
TEST(QuadPotentials, have_the_solid_angle_beside_a_longer_side) {
  const Evaluation solid_angle = evaluation_named("quad.solid_angle", "closed_form");
  RandomStream random(7, "beside", 0);
  for (const Quad<double>& corners :
       {Quad<double>{Vec(0, 0, 0), Vec(3, 0, 0), Vec(2, 1, 0), Vec(1, 1, 0)},
        Quad<double>{Vec(-4, 0, 0), Vec(4, 0, 0), Vec(1, 1, 0), Vec(-1, 1, 0)},
        Quad<double>{Vec(-1.5, 0, 0), Vec(1.5, 0, 0), Vec(1, 1, 0.25), Vec(-0.5, 1, -0.25)}})
    for (const double distance : {1e-9, 1e-12, 1e-15, 1e-20, 1e-40})
      for (int i = 0; i < 12; ++i)
        for (int first = 0; first < 4; ++first) {
          const double turn = random.uniform(0, 2 * std::numbers::pi), t = random.uniform(0.1, 0.9);
          const Vec point(corners[0][0] + t * (corners[1][0] - corners[0][0]), distance * std::cos(turn),
                          distance * std::sin(turn));
          Quad<double> q;
          for (int k = 0; k < 4; ++k) q[k] = corners[(k + first) % 4];
          const auto form = found<double>(Potential::DoubleLayer, q, point, 0, 17);
          const Quad<Mp100> wide = convert_quad<Mp100>(q);
          Result<Mp100> expected;
          solid_angle(Query<Mp100>{.corners = wide, .point = convert<Mp100>(point)}, expected);
          EXPECT_NEAR(form.of[0][0] + form.of[0][1] + form.of[0][2] + form.of[0][3],
                      static_cast<double>(Mp100(expected.value[0] / (4 * pi<Mp100>()))), 1e-15)
              << distance << " " << i << " " << first;
        }
}

// 1e-30 sizes inside, where nothing is moved either.
TEST(QuadPotentials, have_their_limits_from_inside_on_the_quad) {
  for (const Quad<double>& corners : {kSquare, kTwisted, kDart}) {
    // A point that doubles hold, and that the dart covers once.
    const Vec middle = combined(corners, basis_at(0.125, 0.25));
    ASSERT_TRUE(on_quad(corners, middle));
    const Vec3<Mp200> near =
        convert<Mp200>(middle) - Mp200("1e-30") * convert<Mp200>(Vec(normal_at(corners, 0.125, 0.25).normalized()));
    for (const Potential potential : kPotentials) {
      const auto form = found<double>(potential, corners, middle, 2, 17);
      const auto limit = plain_lines(potential, corners, near, 2, 85);
      for (int o = 0; o <= 2; ++o) {
        // By symmetry a limit may be zero.
        double largest = 0, size = 1e-2;
        for (std::size_t i = 0; i < limit.of[o].size(); ++i) {
          const auto expected = static_cast<double>(limit.of[o][i]);
          largest = std::max(largest, std::abs(form.of[o][i] - expected));
          size = std::max(size, std::abs(expected));
        }
        EXPECT_LT(largest, 1e-14 * size) << static_cast<int>(potential) << " order " << o;
      }
    }
  }
}

// Three corners next to a point on the quad: its lines and sides are where each of them says, to its own rounding.
TEST(QuadPotentials, have_their_limits_where_corners_are_near) {
  const Quad<double> corners{
      Vec(0x1.697f35361e435p-37, 0x1.2188a8b4a7563p-39, 0), Vec(0x1.65823f849a8c9p-2, 0x1.00b260e79f1eep-1, 0),
      Vec(-0x1.c9bc3d6088f54p-42, 0x1.b124db8399056p-37, 0), Vec(-0x1.2333332e4d5e5p-39, 0x1.d38215514e5d1p-40, 0)};
  const Vec point(0x1.6647a26fa2bd4p-37, 0x1.b9e613810c4d2p-38, 0);
  ASSERT_TRUE(on_quad(corners, point));
  const double side = normal_at(corners, 0, 0)[2] > 0 ? 1 : -1;
  const Vec3<Mp200> near = convert<Mp200>(point) - ldexp(Mp200(side), -130) * Vec3<Mp200>(0, 0, 1);
  for (int first = 0; first < 4; ++first) {
    Quad<double> q;
    for (int k = 0; k < 4; ++k) q[k] = corners[(k + first) % 4];
    for (const Potential potential : {Potential::SingleLayer, Potential::DoubleLayer, Potential::KelvinTraction}) {
      const auto form = found<double>(potential, q, point, 2, 17);
      const auto limit = plain_lines(potential, q, near, 2, 85);
      for (int o = 0; o <= 2; ++o)
        EXPECT_LT(relative(form.of[o], limit.of[o]), 2e-14)
            << static_cast<int>(potential) << ' ' << first << " order " << o;
    }
  }
}

// The middle of a side of the unit square has all singularities across the lines above one another.
TEST(QuadPotentials, have_the_limits_that_there_are_on_the_border) {
  struct Case {
    const Quad<double>& corners;
    double u, v;
  };
  for (const auto& [corners, u, v] :
       {Case{kTwisted, 0.5, 0}, Case{kTwisted, 1, 1}, Case{kSquare, 0.5, 0}, Case{kSquare, 0.5, 1},
        Case{kSquare, 0, 0.5}, Case{kSquare, 1, 0.125}, Case{kSquare, 0, 0}}) {
    const Vec point = combined(corners, basis_at(u, v));
    ASSERT_TRUE(on_quad(corners, point));
    const Vec3<Mp200> near =
        convert<Mp200>(point) - Mp200("1e-40") * convert<Mp200>(Vec(normal_at(corners, u, v).normalized()));
    for (const Potential potential : kPotentials) {
      const auto form = found<double>(potential, corners, point, 0, 17);
      if (potential == Potential::KelvinTraction) {
        EXPECT_TRUE(std::isnan(form.of[0][0]));
        continue;
      }
      const auto limit = plain_lines(potential, corners, near, 0, 60);
      // The limit of a plane's biharmonic double layer is zero; its value 1e-40 inside is as small as the step.
      double largest = 1e-30;
      for (const auto& x : limit.of[0]) largest = std::max(largest, std::abs(static_cast<double>(x)));
      for (std::size_t i = 0; i < form.of[0].size(); ++i)
        EXPECT_NEAR(form.of[0][i], static_cast<double>(limit.of[0][i]), 4e-15 * largest + 1e-40)
            << static_cast<int>(potential) << " " << i;
    }
  }
}

// Points that no doubles are, and which lie on a side all the same.
TEST(QuadPotentials, are_on_the_border_in_multiprecision_too) {
  using R = Mp100;
  const Quad<R> q = convert_quad<R>(kTwisted);
  const Vec3<R> point = q[0] + (R(0.375) + ldexp(R(3), -90)) * (q[1] - q[0]);
  EXPECT_TRUE(isnan(found<R>(Potential::DoubleLayer, q, point, 1, 36).of[1][0]));
  EXPECT_TRUE(isnan(found<R>(Potential::KelvinTraction, q, point, 0, 36).of[0][0]));
  const Vec3<Mp200> near = convert<Mp200>(point) + Mp200("1e-40") * Vec3<Mp200>(3, -2, 1);
  EXPECT_LT(relative(found<R>(Potential::SingleLayer, q, point, 0, 36).of[0],
                     plain_lines(Potential::SingleLayer, kTwisted, near, 0, 50).of[0]),
            1e-30);
}

// The Laplacian of the biharmonic layers is the layers, and of these nothing, up to denormal distances and extreme
// units.
TEST(QuadPotentials, have_each_others_laplacians) {
  struct Case {
    int exponent;
    double distance;
  };
  for (const Case& one : {Case{0, 1e-5}, Case{0, 1e-40}, Case{0, 1e-100}, Case{-300, 0.25}, Case{300, 1e-3}}) {
    Quad<double> q = kTwisted;
    for (Vec& corner : q)
      for (double& x : corner) x = std::ldexp(x, one.exponent);
    Vec eta = combined(kTwisted, basis_at(0.25, 0.75));
    for (double& x : eta) x = std::ldexp(x, one.exponent);
    // Next to corner 0, which is the origin.
    if (one.distance < 1e-20) eta = one.distance * Vec(0.5, 0.25, -1);
    else eta[2] -= std::ldexp(one.distance, one.exponent);
    const auto laplacian = [&](const PotentialTensors<double>& of, std::size_t k) {
      return of.of[2][9 * k] + of.of[2][9 * k + 4] + of.of[2][9 * k + 8];
    };
    const auto psi = found<double>(Potential::SingleLayer, q, eta, 2, 17),
               phi = found<double>(Potential::DoubleLayer, q, eta, 2, 17),
               psibar = found<double>(Potential::BiharmonicSingleLayer, q, eta, 2, 17),
               phibar = found<double>(Potential::BiharmonicDoubleLayer, q, eta, 2, 17);
    const auto size_of = [](const std::vector<double>& hessians) {
      double size = 0;
      for (const double x : hessians) size = std::max(size, std::abs(x));
      return size;
    };
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_LE(std::abs(laplacian(psi, k)), 1e-13 * size_of(psi.of[2])) << one.exponent << ' ' << one.distance;
      EXPECT_LE(std::abs(laplacian(phi, k)), 1e-13 * size_of(phi.of[2])) << one.exponent << ' ' << one.distance;
      EXPECT_LE(std::abs(laplacian(psibar, k) - psi.of[0][k]), 1e-13 * size_of(psibar.of[2])) << one.exponent;
      EXPECT_LE(std::abs(laplacian(phibar, k) - phi.of[0][k]), 1e-13 * size_of(phibar.of[2])) << one.exponent;
    }
  }
}

// Sums over corners with positions and normals give only logarithms of the sides.
TEST(QuadPotentials, add_up_to_line_integrals_over_the_sides) {
  using R = Mp100;
  for (const Quad<double>& corners : {kTwisted, kStrong})
    for (const double distance : {1.5, -0x1p-20}) {
      const Quad<R> q = convert_quad<R>(corners);
      const Vec3<R> eta = convert<R>(inside(corners, 0.25, 0.625, distance));
      const auto value = [&](Potential potential) { return found<R>(potential, q, eta, 0, 48).of[0]; };
      const auto phi = value(Potential::DoubleLayer), psi = value(Potential::SingleLayer),
                 phibar = value(Potential::BiharmonicDoubleLayer), psibar = value(Potential::BiharmonicSingleLayer);
      Vec3<R> first = Vec3<R>::Zero(), second = Vec3<R>::Zero();
      for (int k = 0; k < 4; ++k) {
        const Vec3<R> normal = (q[(k + 1) % 4] - q[k]).cross(q[(k + 3) % 4] - q[k]);
        first += phi[k] * (q[k] - eta) + psi[k] * normal;
        second += phibar[k] * (q[k] - eta) + 3 * psibar[k] * normal;
        // int 1/r and int r along the side, by the textbook's primitives.
        const Vec3<R> a = q[k] - eta, b = q[(k + 1) % 4] - eta;
        const R length = sqrt(R((b - a).dot(b - a)));
        const Vec3<R> unit = (b - a) / length;
        const R s0 = a.dot(unit), s1 = b.dot(unit), r0 = sqrt(R(a.dot(a))), r1 = sqrt(R(b.dot(b)));
        const R height2 = a.cross(unit).dot(a.cross(unit));
        const R logarithm = log(R((r1 + s1) / (r0 + s0)));
        first -= a.cross(unit) * logarithm / (4 * pi<R>());
        second -= a.cross(unit) * (s1 * r1 - s0 * r0 + height2 * logarithm) / (16 * pi<R>());
      }
      EXPECT_LT(static_cast<double>(R(sqrt(R(first.dot(first))))), 1e-40) << distance;
      EXPECT_LT(static_cast<double>(R(sqrt(R(second.dot(second))))), 1e-40) << distance;
    }
}

}  // namespace
}  // namespace cageproof::adaptive_qmvc::quad_potentials_test
