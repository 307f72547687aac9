// SPDX-License-Identifier: MIT
// The line form where two sheets of a quad, or two singularities of one, are next to the point. Truths: the definition
// integrated in two dimensions by adaptive Gauss-Legendre in 80-bit arithmetic, apart from this project's code.
#include "cageproof/core/catalogue/evaluation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cageproof::adaptive_qmvc::line_form_folds_test {
namespace {

using Vec = Vec3<double>;

struct Case {
  std::vector<Vec> corners;
  Vec point;
  std::array<double, 4> weights;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      // a line of length zero beside others
      {{Vec(0, 0, 0), Vec(1, 0, 0), Vec(3.7252902984619141e-09, 0, 1.862645149230957e-09),
        Vec(1.0000000037252903, 0, 1.862645149230957e-09)},
       Vec(0.25, 0.5, 1),
       {4.75660668072435e-11, 3.78979132181095e-11, -4.75660670042781e-11, -3.78979133047773e-11}},
      // the same, crossed
      {{Vec(0, 0, 0), Vec(1, 0, 0), Vec(-0.31340320339260752, 0.01, 0.02), Vec(1.3134032033926075, 0.01, 0.02)},
       Vec(0.10000000000000001, -3, 0.10000000000000001),
       {-2.47626729051573e-05, -2.07354730421488e-05, 0.000136138821602776, 0.000127003982822795}},
      // a dart, above its notch
      {{Vec(0, 0, 0), Vec(1, 0, 0), Vec(0.25, 0.25, 0), Vec(0, 1, 0)},
       Vec(0.28125, 0.265625, 0.0001),
       {-11841.9078274902, -5920.95476335794, 23683.6597271193, -5920.95094461946}},
      {{Vec(0, 0, 0), Vec(1, 0, 0), Vec(0.25, 0.25, 0), Vec(0, 1, 0)},
       Vec(0.28125, 0.265625, 9.9999999999999995e-07),
       {-1184192.15126888, -592096.075642939, 2368384.30097847, -592096.075604751}},
      // a dart, beside its notch
      {{Vec(0, 0, 0), Vec(1, 0, 0), Vec(0.25, 0.25, 0), Vec(0, 1, 0)},
       Vec(0.11436093757440527, 0.66662153041052985, -0.001),
       {58.2152335411628, 28.7338282787223, -81.3967454261496, 71.6824590527543}},
      // a fold: two sheets at the point
      {{Vec(-0.007515267435569406, 0.0074858546530739978, -0.17371900018341113),
        Vec(1.1164484348493953, -0.12055188148399099, 0.24250184727430962),
        Vec(-0.007515267435569406, 0.0074858546530739978, -0.17371900018341113),
        Vec(0.2071381092706886, 0.93106927612512025, -0.20163494738979726)},
       Vec(-0.0065614205282915295, 0.0089940968286369247, -0.1735172455501143),
       {-105496.005320383, -5.23695219117594e-16, 105496.005320383, -1.74260702337514e-15}},
      // trapezoids
      {{Vec(-0.73979383307415159, -0.083571665044011478, -0.4211984132573996),
        Vec(-0.41652337060304334, -0.7770368149620166, 0.097408603223819723),
        Vec(-0.40714842874351947, -0.78140795807916907, 0.10669431748569068),
        Vec(0.23294141723231387, -0.53711741048980288, 0.54227866448248152)},
       Vec(-0.41984365851675054, -0.75537942062978181, 0.097924651529809253),
       {-9.32598298955328, -218.911303882185, -102.578424248901, -4.90186278035432}},
      {{Vec(0.80932444280033344, 0.87001449916816553, -0.35346383387974378),
        Vec(-0.65361908998559515, 0.21874232038516928, -0.36887634331599584),
        Vec(-0.65434300828031167, 0.21798615957183859, -0.36846236666321341),
        Vec(-0.75723939882528213, -0.76632235992714004, 0.54238430293257456)},
       Vec(-0.62452439279234573, 0.18506279419072091, -0.37016452398198163),
       {1.73232729242085, 27.8151327292841, 36.4080750230888, 2.27721742651343}},
      // twisted
      {{Vec(0.19028943494994155, 0.93309250118751752, -0.38699821057647754),
        Vec(-0.2578469297147834, 0.94407967804262438, -0.037893012004436066),
        Vec(0.84224967637557091, 0.86197704899778294, 0.74150741979009638),
        Vec(0.073463095725131433, 0.97595899480895776, -0.080730819745510773)},
       Vec(0.15764952448103198, 0.94724044300821841, -0.31290509885129125),
       {-286.937796386566, -17.004229548135, -2.84730747895987, -58.689568997798}},
      // weights whose integrand changes sign
      {{Vec(-264.51313447319467, 42.860113811154491, 58.432890543290902),
        Vec(172.9185799593057, 0.5094649735441209, 6.0850231675003466),
        Vec(6039.8330381711767, 572.23643239872672, 651.47470830436839),
        Vec(4215.3764027559391, 95.179496024140406, -0.87198238313808252)},
       Vec(-1592.993591875317, 2.3996107982099701, -30.507420512973646),
       {1.34944085225041e-08, 1.22844274995343e-08, -3.70039210542551e-08, -4.96045809886788e-08}},
      {{Vec(-0.13673731564229188, -0.07456541004753045, -0.13412448709176361),
        Vec(0.87757659280136435, 0.01764360304454668, -0.13278988183162843),
        Vec(0.97105144966943446, 0.90993808666667197, -0.19163353514709158),
        Vec(-0.015715954634305918, 0.80027427412540653, 0.072725508108348214)},
       Vec(-0.14091782748906323, -0.16000290775252882, -0.15152020743365149),
       {0.0183849061186088, 0.0340863242581838, 0.0236348669623155, 0.0262614812462112}},
  };
  return all;
}

// The largest error over the largest weight.
template <Scalar R>
double error(const Case& c, std::string_view name) {
  std::vector<Vec3<R>> q;
  q.reserve(c.corners.size());
  for (const Vec& corner : c.corners) q.push_back(convert<R>(corner));
  Result<R> result;
  (*EvaluationRegister::instance().find("quad.mean_value", name))(Query<R>{q, convert<R>(c.point), 0, {}}, result);
  double worst = 0, size = 0;
  for (int k = 0; k < 4; ++k) {
    const double d = std::abs(static_cast<double>(result.value[k]) - c.weights[k]);
    worst = std::isfinite(d) ? std::max(worst, d) : HUGE_VAL;
    size = std::max(size, std::abs(c.weights[k]));
  }
  return worst / size;
}

// Weights grow like 1/distance, and so does what a rounding of the corners does to them.
double conditioning(const Case& c) {
  double size = 0, weight = 0;
  for (int k = 0; k < 4; ++k) {
    size = std::max(size, (c.corners[k] - c.corners[0]).norm());
    weight = std::max(weight, std::abs(c.weights[k]));
  }
  return 1 + size * weight;
}

TEST(line_form, keeps_its_digits_where_two_sheets_are_near) {
  constexpr double u = 0x1p-53;
  for (const Case& c : cases()) {
    SCOPED_TRACE(testing::Message() << "point " << c.point.transpose());
    // The truths have 15 digits.
    EXPECT_LT(error<Mp50>(c, "line_form"), 1e-14);
    EXPECT_LT(error<double>(c, "line_form"), 64 * u * conditioning(c) + 1e-14);
    EXPECT_LT(error<double>(c, "line-12"), 1e-12 + 64 * u * conditioning(c));
    EXPECT_LT(error<double>(c, "line-6"), 1e-6);
  }
}

}  // namespace
}  // namespace cageproof::adaptive_qmvc::line_form_folds_test
