// SPDX-License-Identifier: MIT
// Enclosures over bilinear quads: numbers known by hand or by another program lie in them; what is declined.
#include "quad_certified_support.h"

namespace cageproof::quadrature_ref {
namespace {

using Vec = Vec3<double>;

Mp100 total(const std::vector<Mp100>& v) {
  Mp100 sum = 0;
  for (const Mp100& x : v) sum += x;
  return sum;
}

// The six faces of a cube see its middle alike.
TEST(CertifiedQuad, solid_angle_of_a_square) {
  const auto r = enclosed_quad("quad.solid_angle", kSquare, {.5, .5, -.5}, 0);
  EXPECT_TRUE(r.converged);
  EXPECT_TRUE(holds(r.value[0], r.value_radius[0], 2 * pi<Mp100>() / 3));
  const auto other = enclosed_quad("quad.solid_angle", kSquare, {.5, .5, .5}, 0);
  EXPECT_TRUE(holds(other.value[0], other.value_radius[0], -2 * pi<Mp100>() / 3));
  // A corner of the cube sees the square opposite under an eighth of a sphere over three.
  const auto eighth = enclosed_quad("quad.solid_angle", kSquare, {0, 0, -1}, 0);
  EXPECT_TRUE(holds(eighth.value[0], eighth.value_radius[0], pi<Mp100>() / 6));
}

// Numbers from the definition by mpmath, not by this project's code: tensor Gauss-Legendre with 26 points per direction
// on 3 x 3 cells, in 45 digits; 22 points agree to 1e-35.
struct TypedIn {
  const char* formula;
  int order;
  std::size_t corner, entry;  // of the corner's tensor
  const char* value;
};
constexpr TypedIn kTypedIn[]{
    {"quad.solid_angle", 0, 0, 0, "1.6744536073875682193514817499665"},
    {"quad.solid_angle", 1, 0, 0, "-0.08599621831646684362644059871719"},
    {"quad.solid_angle", 2, 0, 2, "-0.9830974918928366164137980876904"},
    {"quad.single_layer", 0, 0, 0, "0.030086394826223942748422764006439"},
    {"quad.single_layer", 0, 1, 0, "0.0285063768976866089352865821943"},
    {"quad.single_layer", 0, 2, 0, "0.024161792010466068411827323283058"},
    {"quad.single_layer", 0, 3, 0, "0.026496234600282517783828406956156"},
    {"quad.single_layer", 1, 0, 1, "-0.0051645944594624242087883758615059"},
    {"quad.single_layer", 1, 2, 1, "0.0072811300935530875071667940646839"},
    {"quad.single_layer", 2, 1, 1, "-0.0053909524124611811581556694369812"},
    {"quad.single_layer", 2, 3, 8, "0.055893481939394123314831251737556"},
    {"quad.double_layer", 0, 0, 0, "0.041818709567563529741447853543209"},
    {"quad.double_layer", 0, 1, 0, "0.037197706170380358151855357734382"},
    {"quad.double_layer", 0, 2, 0, "0.023351520624093560999805715408805"},
    {"quad.double_layer", 0, 3, 0, "0.030880847934856188776788984551084"},
    {"quad.double_layer", 1, 3, 2, "0.05969276991431324162049193298126"},
    {"quad.double_layer", 2, 0, 5, "-0.081931106517999038859650009225815"},
    {"quad.double_layer", 2, 2, 7, "0.0880417573377600304729036919798"},
    {"quad.mean_value", 0, 0, 0, "0.81721206514622899595205876056451"},
    {"quad.mean_value", 0, 3, 0, "0.55021348719834519837233865159363"},
    {"quad.mean_value", 1, 1, 0, "0.62447189285928796798682057733778"},
    {"quad.mean_value", 2, 2, 5, "2.0860188583001848469377833335544"},
    {"quad.biharmonic_single_layer", 0, 1, 0, "0.0071004525306495965395631789083575"},
    {"quad.biharmonic_single_layer", 0, 3, 0, "0.0076494706556532226536399922265912"},
    {"quad.biharmonic_double_layer", 0, 0, 0, "-0.0088770103275409306206665177880926"},
    {"quad.biharmonic_double_layer", 0, 2, 0, "-0.0069570169838699050082305989002768"},
    {"quad.kelvin_displacement", 0, 1, 1, "-0.00026201725801623665709077253043319"},
    {"quad.kelvin_displacement", 0, 3, 8, "0.023595752853488561511753131269841"},
    {"quad.kelvin_traction", 0, 3, 1, "-0.0060370898308466261929560387636506"},
    {"quad.kelvin_traction", 0, 2, 4, "0.013571078227443558008348857297595"},
};

TEST(CertifiedQuad, values_by_another_program) {
  const Mp100 typed_digits("1e-30");
  for (const TypedIn& known : kTypedIn) {
    const auto r = enclosed_quad(known.formula, kTwistedUp, kBelow, known.order);
    EXPECT_TRUE(r.converged);
    const std::size_t tensor = r.of(known.order).size() / (std::string(known.formula) == "quad.solid_angle" ? 1 : 4);
    const std::size_t at = known.corner * tensor + known.entry;
    const Mp100 middle = r.of(known.order)[at], radius = r.radius_of(known.order)[at];
    EXPECT_LT(radius, Mp100("1e-28"));
    EXPECT_TRUE(abs(Mp100(Mp100(known.value) - middle)) <= radius + typed_digits)
        << known.formula << ' ' << known.order << ' ' << known.corner << ' ' << known.entry << ' ' << middle;
  }
}

TEST(CertifiedQuad, declines_on_the_quad) {
  for (const std::string& formula : enclosed_formulas())
    for (const Vec& point : {on_quad(kTwistedUp, .25, .75), Vec(.5, 0, 0), Vec(1, 1, .5)}) {
      const auto r = enclosed_quad(formula, kTwistedUp, point, 1);
      EXPECT_FALSE(r.converged) << formula;
      for (int o = 0; o <= 1; ++o) EXPECT_TRUE(isnan(r.of(o)[0]) && isinf(r.radius_of(o)[0])) << formula;
    }
}

TEST(CertifiedQuad, declines_what_is_no_quad) {
  const auto declined = [](const Quad<double>& q, const Vec& point) {
    const auto r = enclosed_quad("quad.single_layer", q, point, 0);
    return !r.converged && isnan(r.value[0]) && isinf(r.value_radius[0]);
  };
  const Vec p(0, 0, 0), q(1, 1, 1);
  EXPECT_TRUE(declined({p, q, 2 * q, 3 * q}, kBelow));
  EXPECT_TRUE(declined({p, p, p, p}, kBelow));
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(declined(kSquare, {0, nan, 0}));
  EXPECT_TRUE(declined({p, q, Vec(infinity, 0, 0), Vec(0, 1, 0)}, kBelow));
  const Quad<Mp200> far{convert<Mp200>(p), Vec3<Mp200>(ldexp(Mp200(1), 30000), Mp200(0), Mp200(0)), convert<Mp200>(q),
                        convert<Mp200>(kSquare[3])};
  Result<Mp200> r;
  integrate_certified("quad.single_layer", Query<Mp200>{far, convert<Mp200>(kBelow), 0}, r);
  EXPECT_TRUE(!r.converged && isnan(r.value[0]) && isinf(r.value_radius[0]));
}

// A side of no length is a triangle's corner: fans of two have the quad's solid angle.
TEST(CertifiedQuad, collapsed_sides_are_triangles) {
  const Quad<double> fan{Vec(0, 0, 0), Vec(1, 0, .25), Vec(.25, 1, .5), Vec(.25, 1, .5)};
  const Triangle<Mp100> triangle{convert<Mp100>(fan[0]), convert<Mp100>(fan[1]), convert<Mp100>(fan[2])};
  Result<Mp100> known;
  integrate_certified("triangle.solid_angle", Query<Mp100>{triangle, convert<Mp100>(kBelow), 2}, known);
  const auto r = enclosed_quad("quad.solid_angle", fan, kBelow, 2);
  for (int o = 0; o <= 2; ++o)
    for (std::size_t i = 0; i < r.of(o).size(); ++i)
      EXPECT_TRUE(holds(r.of(o)[i], r.radius_of(o)[i] + known.radius_of(o)[i], known.of(o)[i])) << o << ' ' << i;
}

TEST(CertifiedQuad, vanishing_tensors_are_exact_zeros) {
  const Vec beside(3, .5, 0);
  for (const std::string formula :
       {"quad.kelvin_traction", "quad.double_layer", "quad.solid_angle", "quad.mean_value"}) {
    const auto r = enclosed_quad(formula, kSquare, beside, 2, {}, .5);
    EXPECT_TRUE(r.converged) << formula;
    for (std::size_t i = 0; i < r.value.size(); ++i) EXPECT_TRUE(r.value[i] == 0 && r.value_radius[i] == 0) << formula;
    EXPECT_TRUE(total(r.gradient_radius) > 0) << formula;
  }
}

// b = 0 in the limit nu to infinity: K = a/r I.
TEST(CertifiedQuad, infinite_poisson_ratio) {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto r = enclosed_quad("quad.kelvin_displacement", kTwistedUp, kBelow, 0, {}, infinity);
  const auto single = enclosed_quad("quad.single_layer", kTwistedUp, kBelow, 0);
  EXPECT_TRUE(holds(r.value[4], r.value_radius[4] + single.value_radius[0], single.value[0]));
  EXPECT_TRUE(holds(r.value[1], r.value_radius[1], Mp100(0)));
}

TEST(CertifiedQuad, orders_asked_alone_are_the_same) {
  for (const std::string& formula : enclosed_formulas()) {
    const auto all = enclosed_quad(formula, kTwistedUp, kBelow, 2);
    for (int order = 0; order <= 1; ++order) {
      const auto some = enclosed_quad(formula, kTwistedUp, kBelow, order);
      EXPECT_TRUE(some.of(order + 1).empty() && some.radius_of(order + 1).empty()) << formula;
      for (std::size_t i = 0; i < some.of(order).size(); ++i)
        EXPECT_TRUE(abs(Mp100(some.of(order)[i] - all.of(order)[i])) <=
                    some.radius_of(order)[i] + all.radius_of(order)[i]);
    }
  }
}

TEST(CertifiedQuad, what_costs_too_much_is_wide_or_declined_and_says_so) {
  const Vec close = on_quad(kTwistedUp, .25, .75) + Vec(0, 0, 1e-9);
  const auto fine = enclosed_quad("quad.double_layer", kTwistedUp, close, 2);
  EXPECT_TRUE(fine.converged);
  for (const double work : {1e2, 1e4, 1e5}) {
    const auto r = enclosed_quad("quad.double_layer", kTwistedUp, close, 2, {.most_work = work});
    EXPECT_FALSE(r.converged) << work;
    for (int o = 0; o <= 2; ++o)
      for (std::size_t i = 0; i < r.of(o).size(); ++i)
        EXPECT_TRUE(isinf(r.radius_of(o)[i]) ||
                    abs(Mp100(r.of(o)[i] - fine.of(o)[i])) <= r.radius_of(o)[i] + fine.radius_of(o)[i]);
  }
}

TEST(CertifiedQuad, radii_hold_the_rounding_of_the_midpoint) {
  const auto exact = enclosed_quad("quad.double_layer", kTwistedUp, kBelow, 1);
  const auto narrow = enclosed_quad<float>("quad.double_layer", kTwistedUp, kBelow, 1);
  EXPECT_TRUE(narrow.converged);
  for (int o = 0; o <= 1; ++o)
    for (std::size_t i = 0; i < exact.of(o).size(); ++i) {
      EXPECT_TRUE(abs(Mp100(exact.of(o)[i] - narrow.of(o)[i])) <= narrow.radius_of(o)[i]);
      EXPECT_LE(narrow.radius_of(o)[i], 6.1e-8f * std::abs(narrow.of(o)[i]) + 1e-30f);
    }
}

TEST(CertifiedQuad, every_quad_formula_lists_it_and_no_campaign_runs_it) {
  for (const Formula& row : catalogue()) {
    if (row.element != ElementKind::Quad) continue;
    EXPECT_TRUE(EvaluationRegister::instance().find(row.name, "certified")) << row.name;
    for (const std::string& name : EvaluationRegister::instance().standard(row.name)) EXPECT_NE(name, "certified");
  }
}

}  // namespace
}  // namespace cageproof::quadrature_ref
