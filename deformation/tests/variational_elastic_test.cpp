// SPDX-License-Identifier: MIT
// Variational maps of elastic bodies: reference numbers computed elsewhere from Kelvin's kernels by Gauss points, the
// equation that they solve, and what they keep.
#include "variational_cases.h"

#include "cageproof/core/input_error.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace cageproof::deformation::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

VariationalOptions elastic_options(double nu, int steps) {
  return {
      .subspace = Subspace::Elastic, .nu = nu, .alpha = .05, .beta = .2, .gamma = .003, .steps = steps, .tolerance = 0};
}

Case slanted_tetrahedron() {
  return {"tetrahedron",
          Cage::make("tetrahedron", {{0, 0, 0}, {3, .2, 0}, {.4, 2.8, -.1}, {.3, .5, 3}},
                     {{{0, 2, 1, -1}}, {{0, 1, 3, -1}}, {{0, 3, 2, -1}}, {{1, 2, 3, -1}}}, {}),
          {},
          {{.9, .8, .9}, {.5, .6, .4}},
          1};
}

Constraints space_constraints() {
  Mat a;
  a << 1.1, .2, -.1, .05, .8, .3, -.2, .1, 1.2;
  return {.positions = {{{.6, .6, .6}, {.5, .7, .6}},
                        {{1.5, .6, .5}, {1.7, .5, .8}},
                        {{.7, 1.4, .5}, {.6, 1.6, .3}},
                        {{.6, .7, 1.6}, {.9, .7, 1.7}},
                        {{.9, .9, .8}, {.9, 1, .9}}},
          .orientations = {{{.8, .7, .7}, a}},
          .rotations = {{1.1, .7, .6}, {.7, 1, .7}, {.7, .8, 1.1}},
          .hessians = {{1, .6, .5}, {.6, 1.2, .5}, {.7, .6, 1.2}}};
}

// After steps 1, 2, 5 and 20; the image of the case's first point.
void expect_elastic_reference(const Case& c, const Constraints& constraints, double nu,
                              const std::array<double, 4>& energies, const Vec& image_of_first) {
  const Variational<double> model(c.cage, constraints, elastic_options(nu, 20));
  const auto posed = model.pose();
  const std::vector<double>& found = posed->report().energies;
  ASSERT_EQ(found.size(), 40);
  constexpr std::array<std::size_t, 4> after{1, 2, 5, 20};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(found[2 * after[k] - 1], energies[k], 1e-11) << after[k];
  EXPECT_LT((image(model.images(*posed, std::span(c.points).first(1), 0), 0) - image_of_first).norm(), 1e-10);
}

TEST(variational_elastic, reference_in_the_plane) {
  expect_elastic_reference(pentagon(), plane_constraints(), .3,
                           {.198297180905259, .168582013704497, .162403372480876, .162359625045887},
                           {1.02498469048798, .944534834022315, 0});
  expect_elastic_reference(pentagon(), plane_constraints(), -.5,
                           {.210079883831457, .188441500427102, .184439997790435, .184417275395528},
                           {.980593303560572, .969642890689023, 0});
}

TEST(variational_elastic, reference_in_space) {
  expect_elastic_reference(slanted_tetrahedron(), space_constraints(), .3,
                           {.116366445357483, .0927980028347394, .0887506319740758, .0886203874171761},
                           {.91080354682216, .924080760775457, .955230669665478});
  expect_elastic_reference(slanted_tetrahedron(), space_constraints(), -.5,
                           {.113994150597849, .0910159419030482, .0874316715769958, .0873116147980146},
                           {.90922663781669, .909804830013491, .962125448864826});
}

// (1 - 2 nu) laplacian(f) + grad div f = 0: no load within. For infinite nu f is harmonic.
TEST(variational_elastic, maps_are_in_equilibrium) {
  for (const double nu : {-.9, 0., .3, .49, infinity})
    for (const Case& c : {slanted_tetrahedron(), pentagon()}) {
      const int d = c.cage.dimension();
      const Variational<double> model(c.cage, d == 3 ? space_constraints() : plane_constraints(),
                                      elastic_options(nu, 2));
      const auto images = model.images(*model.pose(), std::span(c.points).first(1), 2);
      const auto second = [&](int component, int a, int b) { return images.tensors[2][(component * d + a) * d + b]; };
      double largest = 0;
      for (const double x : images.tensors[2]) largest = std::max(largest, std::abs(x));
      EXPECT_GT(largest, 1e-2);
      for (int component = 0; component < d; ++component) {
        double laplacian = 0, slope = 0;
        for (int a = 0; a < d; ++a) laplacian += second(component, a, a), slope += second(a, a, component);
        const double left = std::isinf(nu) ? laplacian : (1 - 2 * nu) * laplacian + slope;
        EXPECT_LT(std::abs(left), 1e-11 * largest) << nu << ' ' << c.name;
      }
    }
}

// Constant strains have constant stresses.
TEST(variational_elastic, affine_targets_are_met_for_all_nu) {
  const Case c = slanted_tetrahedron();
  Constraints constraints = space_constraints();
  constraints.rotations.clear();
  const Mat a = constraints.orientations[0].jacobian;
  const Vec shift(.3, -.2, 1);
  for (auto& [at, to] : constraints.positions) to = a * at + shift;
  for (const double nu : {-.99, 0., .499, infinity}) {
    const Variational<double> model(c.cage, constraints, elastic_options(nu, 1));
    const auto posed = model.pose();
    EXPECT_LT(posed->report().energies[1], 1e-22) << nu;
    for (std::size_t p = 0; p < c.points.size(); ++p)
      EXPECT_LT((image(model.images(*posed, c.points, 0), p) - (a * c.points[p] + shift)).norm(), 1e-10) << nu;
  }
}

// Displacements that constraints leave free are none.
TEST(variational_elastic, what_is_left_free_stays_at_rest) {
  const Case c = slanted_tetrahedron();
  const Constraints few{.positions = {{{.6, .6, .6}, {.6, .6, .6}}}, .rotations = {{.7, .8, 1.1}}};
  const Variational<double> model(c.cage, few, elastic_options(.3, 3));
  const auto posed = model.pose();
  EXPECT_TRUE(warns_of(posed->report(), "unknowns free"));
  for (std::size_t p = 0; p < c.points.size(); ++p)
    EXPECT_LT((image(model.images(*posed, c.points, 0), p) - c.points[p]).norm(), 1e-13);
}

TEST(variational_elastic, nu_has_its_range) {
  const Case c = slanted_tetrahedron();
  for (const double nu : {-1., .5, 2., std::nan("")})
    EXPECT_THROW(Variational<double>(c.cage, space_constraints(), elastic_options(nu, 1)), InputError) << nu;
  EXPECT_TRUE(warns_of(Variational<double>(c.cage, space_constraints(), elastic_options(.5 - 1e-7, 1)).prepared(),
                       "next to its pole"));
  EXPECT_FALSE(warns_of(Variational<double>(c.cage, space_constraints(), elastic_options(.49, 1)).prepared(), "pole"));
}

}  // namespace
}  // namespace cageproof::deformation::test
