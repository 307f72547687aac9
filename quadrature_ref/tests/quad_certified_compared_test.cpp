// SPDX-License-Identifier: MIT
// Enclosures over bilinear quads: the independent integrator's result lies in them, so do narrower ones, and nothing
// wrong does.
#include "quad_certified_support.h"

namespace cageproof::quadrature_ref {
namespace {

using Vec = Vec3<double>;

struct QuadView {
  std::string kind;
  Quad<double> corners;
  Vec point;
};

// Next to faces, sides and corners, in planes, far away; twisted, folded and thin.
std::vector<QuadView> views(std::uint64_t seed) {
  RandomStream random(seed, "enclosed-quads", 0);
  const auto uniform = [&](double low, double high) { return random.uniform(low, high); };
  const auto vector = [&](double size) {
    return Vec(uniform(-size, size), uniform(-size, size), uniform(-size, size));
  };
  const auto moved = [&](double by) -> Quad<double> {
    return {kSquare[0] + vector(by), kSquare[1] + vector(by), kSquare[2] + vector(by), kSquare[3] + vector(by)};
  };
  std::vector<QuadView> all;
  for (const double h : {1e-1, 1e-3, 1e-7, 1e-12}) {
    const Quad<double> q = moved(.3), strong = moved(.8);
    const Vec direction = vector(1).normalized();
    all.push_back({"face", q, on_quad(q, uniform(.1, .9), uniform(.1, .9)) + h * direction});
    all.push_back({"side", strong, on_quad(strong, uniform(.1, .9), 1) + h * direction});
    all.push_back({"corner", strong, strong[3] + h * direction});
    const double around = uniform(0, 1);
    all.push_back({"line", q, q[1] + (1 + around) * (q[2] - q[1]) + h * direction});
    all.push_back({"far", strong, std::pow(h, -.5) * direction});
    Quad<double> flat = strong;
    for (Vec& corner : flat) corner[2] = 0;
    all.push_back({"plane", flat, Vec(2.5 + h, uniform(-1, 1), 0)});
    all.push_back({"folded", {vector(1), vector(1), vector(1), vector(1)}, vector(1)});
    Quad<double> thin = q;
    for (Vec& corner : thin) corner[1] *= .01, corner[2] *= .01;
    all.push_back({"thin", thin, on_quad(thin, .3, .4) + .02 * direction});
  }
  all.push_back({"moved", kTwistedUp, kBelow + Vec(1e6, -1e6, 1e6)});
  const auto integer = [&] {
    return Vec(std::round(uniform(-3, 3)), std::round(uniform(-3, 3)), std::round(uniform(-3, 3)));
  };
  for (int i = 0; i < 14; ++i)
    all.push_back({"integer", {integer(), integer(), integer(), integer()}, integer() + Vec(0, 0, .5)});
  return all;
}

TEST(CertifiedQuad, independent_integrator_lies_inside_and_nothing_near_it) {
  std::size_t index = 0;
  for (const QuadView& view : views(3)) {
    const std::string& formula = enclosed_formulas()[index++ % enclosed_formulas().size()];
    const int order = formula.find("kelvin") == std::string::npos ? 2 : 1;  // the integral's Hessians take seconds
    const auto ball = enclosed_quad(formula, view.corners, view.point, order);
    EXPECT_TRUE(ball.converged) << formula << ' ' << view.kind;
    const auto& c = view.corners;
    const Quad<Mp50> corners{convert<Mp50>(c[0]), convert<Mp50>(c[1]), convert<Mp50>(c[2]), convert<Mp50>(c[3])};
    const std::vector<Mp50> parameters = parameters_for<Mp50>(formula, .25);
    Result<Mp50> integral;
    (*EvaluationRegister::instance().find(formula, "multiprecision"))(
        {corners, convert<Mp50>(view.point), order, parameters}, integral);
    for (int o = 0; o <= order; ++o) {
      Mp100 norm = 0, widest = 0;
      for (const Mp50& x : integral.of(o)) norm = std::max(norm, Mp100(abs(x)));
      const Mp100 slack = norm * Mp100("1e-30");  // what the integral promises
      int outside_if_wrong = 0;
      for (std::size_t i = 0; i < ball.of(o).size(); ++i) {
        const Mp100 off = abs(Mp100(Mp100(integral.of(o)[i]) - ball.of(o)[i])), radius = ball.radius_of(o)[i];
        EXPECT_TRUE(off <= radius + slack) << formula << ' ' << view.kind << ' ' << o << ' ' << i;
        widest = std::max(widest, radius);
        outside_if_wrong += abs(Mp100(ball.of(o)[i] + Mp100(integral.of(o)[i]))) > radius + slack;
      }
      EXPECT_TRUE(widest <= Mp100("1e-29") * norm) << formula << ' ' << view.kind << ' ' << o;
      if (norm > 0)
        EXPECT_GT(outside_if_wrong, 0) << "the wrong sign lies inside: " << formula << ' ' << view.kind << ' ' << o;
    }
  }
}

// At few bits the truncation error is what the radius holds.
TEST(CertifiedQuad, precisions_agree) {
  std::size_t index = 0;
  for (const int bits : {96, 128})
    for (const QuadView& view : views(static_cast<std::uint64_t>(bits))) {
      const std::string& formula = enclosed_formulas()[index++ % 4];
      const CertifiedEffort few{.first_bits = bits, .most_bits = bits}, many{.first_bits = 512, .most_bits = 512};
      const auto coarse = enclosed_quad<Mp200>(formula, view.corners, view.point, 2, few);
      const auto fine = enclosed_quad<Mp200>(formula, view.corners, view.point, 2, many);
      // Solid angles of folded quads may be zero, of which no digit is right.
      EXPECT_TRUE(fine.converged || view.kind == "integer") << formula << ' ' << view.kind;
      for (int o = 0; o <= 2; ++o)
        for (std::size_t i = 0; i < fine.of(o).size(); ++i) {
          const Mp200 &a = coarse.of(o)[i], &b = fine.of(o)[i];
          const Mp200 &ra = coarse.radius_of(o)[i], &rb = fine.radius_of(o)[i];
          if (isnan(a)) continue;  // nothing known at so few bits
          EXPECT_TRUE(abs(Mp200(a - b)) <= ra + rb && rb <= ra) << formula << ' ' << view.kind << ' ' << o << ' ' << i;
        }
    }
}

}  // namespace
}  // namespace cageproof::quadrature_ref
