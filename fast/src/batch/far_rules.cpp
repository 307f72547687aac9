// SPDX-License-Identifier: MIT
#include "far_rules.h"

#include "cageproof/core/numbers/gauss_legendre.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace cageproof::closed_form::batch {
namespace {

// A symmetric rule by its orbits: weights, then barycentric coordinates of which the last is what is left to one. They
// solve the moment equations of all symmetric polynomials up to the degree (Dunavant 1985; Gatermann 1988; Xiao and
// Gimbutas 2010); far_faces_test.cpp integrates every polynomial. `least` is FarRule's, found by bisection over eight
// triangles, from equilateral to a fiftieth as high as long, and 27 directions, in long double, and raised by four in a
// hundred.
struct Orbits {
  int degree;
  std::array<double, 4> least;
  double centre;                                // the weight of the centroid, if it is a point
  std::vector<std::array<double, 2>> medians;   // a weight and the coordinate that two corners have: three points
  std::vector<std::array<double, 3>> general;   // a weight and two coordinates: six points
  std::vector<std::array<double, 3>> turned{};  // the same, and only what turning makes of these: three points
};

const std::array<Orbits, kQuickRules>& orbits() {
  static const std::array<Orbits, kQuickRules> all{{
      {4,
       {2.24e+03, 2.75e+03, 3.25e+03, 3.71e+03},
       0,
       {{0.1099517436553218676, 0.09157621350977074346}, {0.2233815896780114657, 0.4459484909159648863}},
       {}},
      {5,
       {575, 700, 822, 945},
       0.225,
       {{0.1259391805448271526, 0.1012865073234563388}, {0.1323941527885061807, 0.4701420641051150898}},
       {}},
      {7,
       {81.3, 96.5, 112, 127},
       0,
       {},
       {},
       {{0.0530340563148725028, 0.06238226509440211851, 0.06751786707391608479},
        {0.0877628174288921087, 0.05522545665692661057, 0.3215024938519818228},
        {0.05755008556996317511, 0.03432430294509715006, 0.6609491961867356521},
        {0.1349863740196055467, 0.5158423343535917788, 0.2777161669763917773}}},
      {8,
       {42.2, 48.3, 54, 56.5},
       0.1443156076777871683,
       {{0.09509163426728462479, 0.459292588292723156},
        {0.03245849762319808031, 0.05054722831703097546},
        {0.1032173705347182503, 0.1705693077517602066}},
       {{0.02723031417443499426, 0.008394777409957605337, 0.2631128296346381134}}},
      {9,
       {27.3, 31.8, 36.2, 40.6},
       0.09713579628279883382,
       {{0.03133470022713907054, 0.4896825191987376278},
        {0.07782754100477427932, 0.4370895914929366373},
        {0.02557767565869803126, 0.04472951339445270987},
        {0.07964773892721025303, 0.1882035356190327302}},
       {{0.04328353937728937729, 0.03683841205473628363, 0.2219629891607656957}}},
      {10,
       {13.8, 15.9, 18, 20.1},
       0.08174332914628596643,
       {{0.01335296881314956628, 0.03205537321694351293}, {0.04595796360474472801, 0.1421611010565643851}},
       {{0.03418464816295942863, 0.02961988948872976763, 0.3691467818278109869},
        {0.02529775770728838439, 0.02836766533993843925, 0.1637017337371824957},
        {0.06390490639642404543, 0.1481328857838205505, 0.3218129952888354212}}},
      {12,
       {8.32, 9.48, 10.7, 11.8},
       0,
       {{0.02426683808145203315, 0.4882037509455415518},
        {0.007931642509973638459, 0.02464636343633559477},
        {0.04991833492806094212, 0.440111648658593111},
        {0.06254121319590276047, 0.2714625070149260849},
        {0.028486052068877545, 0.1092578276593542906}},
       {{0.04322736365941421055, 0.1162960196779265866, 0.2554542286385173465},
        {0.01508367757651143859, 0.02138249025617058959, 0.1272797172335893688},
        {0.02178358503860755793, 0.02303415635526713948, 0.2916556797383409605}}},
  }};
  return all;
}

void add_node(FarRule& rule, double weight, double first, double second) {
  const double hats[3] = {1 - first - second, first, second};
  rule.along[0][rule.nodes] = first;
  rule.along[1][rule.nodes] = second;
  for (int k = 0; k < 3; ++k) rule.weight[rule.nodes][k] = weight * hats[k];
  for (int degree = 0, m = 0; m < kMostMonomials; ++degree)
    for (int j = 0; j <= degree; ++j, ++m)
      rule.monomial[rule.nodes][m] = weight * std::pow(first, degree - j) * std::pow(second, j);
  rule.weight[rule.nodes++][3] = weight;
}

FarRule expanded(const Orbits& from) {
  FarRule rule{};
  rule.degree = from.degree;
  std::ranges::copy(from.least, rule.least);
  if (from.centre != 0) add_node(rule, from.centre, 1. / 3, 1. / 3);
  for (const auto& [weight, a] : from.medians)
    for (const auto& [first, second] : {std::pair(a, a), {a, 1 - 2 * a}, {1 - 2 * a, a}})
      add_node(rule, weight, first, second);
  for (const auto& [weight, a, b] : from.general) {
    const double c = 1 - a - b;
    for (const auto& [first, second] : {std::pair(a, b), {b, a}, {a, c}, {c, a}, {b, c}, {c, b}})
      add_node(rule, weight, first, second);
  }
  for (const auto& [weight, a, b] : from.turned) {
    const double c = 1 - a - b;
    for (const auto& [first, second] : {std::pair(a, b), {b, c}, {c, a}}) add_node(rule, weight, first, second);
  }
  return rule;
}

// Gauss-Legendre points between a corner and the opposite edge, and along that edge.
FarRule product(int degree, const std::array<double, 4>& least) {
  FarRule rule{};
  rule.degree = degree;
  std::ranges::copy(least, rule.least);
  // The area between lines grows with the distance from the corner, which takes a degree.
  const GaussLegendre<double>& out = gauss_legendre<double>((degree + 3) / 2);
  const GaussLegendre<double>& along = gauss_legendre<double>((degree + 2) / 2);
  for (std::size_t i = 0; i < out.nodes.size(); ++i)
    for (std::size_t j = 0; j < along.nodes.size(); ++j) {
      const double s = out.nodes[i], t = along.nodes[j];
      add_node(rule, 2 * s * out.weights[i] * along.weights[j], s * (1 - t), s * t);
    }
  return rule;
}

}  // namespace

const FarRule* far_rules() {
  static const auto rules = [] {
    std::array<FarRule, kFarRules> all;
    std::ranges::transform(orbits(), all.begin(), expanded);
    all[kQuickRules] = product(15, {5.28, 5.87, 6.43, 7.05});
    all[kQuickRules + 1] = product(19, {3.29, 3.63, 3.92, 4.21});
    return all;
  }();
  return rules.data();
}

const LineRule* line_rule() {
  static const LineRule rule = [] {
    LineRule line{};
    const GaussLegendre<double>& gauss = gauss_legendre<double>(LineRule::nodes);
    for (int q = 0; q < LineRule::nodes; ++q) {
      line.along[q] = gauss.nodes[q];
      line.weight[q] = gauss.weights[q];
    }
    return line;
  }();
  return &rule;
}

}  // namespace cageproof::closed_form::batch
