// SPDX-License-Identifier: MIT
// Other parameters for the same coordinates give the images that preparing for only these would give.
#include "support.h"

#include "cageproof/core/input_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

namespace cageproof::deformation::test {
namespace {

template <Scalar R>
double distance(const Images<R>& a, const Images<R>& b, int order) {
  double worst = 0;
  for (std::size_t i = 0; i < a.tensors[order].size(); ++i)
    keep_larger(worst, std::abs(static_cast<double>(R(a.tensors[order][i] - b.tensors[order][i]))));
  return worst;
}

template <Scalar R>
std::vector<Vec3<R>> in(const std::vector<Vec>& points) {
  std::vector<Vec3<R>> found;
  found.reserve(points.size());
  for (const Vec& p : points) found.push_back(convert<R>(p));
  return found;
}

template <Scalar R>
void expect_any_nu(std::string_view name, const Case& c, double tolerance, int order) {
  const DeformMethod& method = deform_method_named(name);
  const auto posed = in<R>(c.posed), points = in<R>(c.points);
  const auto common = prepare_deformer<R>(method, c.cage, {.parameters = {0, 0.3, 0, 0, 0.5}, .varied = {"nu"}});
  for (const double variant : {0.0, 1.0})
    for (const double nu : {-0.9, 0.0, 0.3, 0.49, static_cast<double>(INFINITY), static_cast<double>(-INFINITY)}) {
      const std::vector<double> parameters{variant, nu, 1, 0, 0.5};
      const auto shared = with_other_parameters<R>(method, *common, parameters);
      const auto alone = prepare_deformer<R>(method, c.cage, {.parameters = parameters});
      const Images<R> from_parts = deformed(*shared, posed, points, order),
                      whole = deformed(*alone, posed, points, order);
      // Tractions grow like one over this.
      const double size = std::isinf(nu) ? 1 : 1 / std::abs(1 - 2 * nu);
      for (int o = 0; o <= order; ++o)
        EXPECT_LT(distance(from_parts, whole, o), tolerance * (1 + size)) << c.name << ' ' << nu << ' ' << o;
    }
}

TEST(parameters, of_somigliana_change_without_other_coordinates) {
  for (const Case& c : {cube(), bar(), square(), l_shape(), pentagon()})
    expect_any_nu<double>("somigliana", c, 2e-13, 2);
  for (const Case& c : {cube(), pentagon()}) expect_any_nu<Mp50>("somigliana", c, 1e-45, 0);
  expect_any_nu<double>("quad_somigliana", cube(), 2e-13, 2);
}

TEST(parameters, of_layers_change_without_other_coordinates) {
  const std::vector<std::tuple<std::string_view, std::vector<double>, std::vector<double>>> changes{
      {"green", {0}, {3}},
      {"biharmonic_1_3", {1, 3, 1, 0}, {0, 0, 100, 0}},
      {"biharmonic_1_3", {1, 3, 1, 0, 1}, {2, 0, 0, 2, 1}},
      {"biharmonic_1_2", {1, 3, 0}, {2, 1, 0}},
      {"biharmonic_weber", {1, 3, 0}, {2, 2, 0}},
      {"biharmonic_direct", {3, 0}, {1, 0}},
      {"ahap", {1, 1, 0, 1, 1}, {0, 2, 2, 1, 3}},
      {"aaap", {1, 1, 0, 1, 1}, {1, 1, 1, 7, 1}},
      {"biharmonic_direct", {3, 1}, {0, 1}},
      {"quad_green", {0}, {4}},
      {"quad_biharmonic_1_3", {1, 3, 1, 0}, {2, 4, 100, 0}},
      {"tp", {1, 1, 0, 1, 1}, {1, 1, 3, 1, 5}}};
  for (const Case& c : {cube(), pentagon()})
    for (const auto& [name, before, after] : changes) {
      const DeformMethod& method = deform_method_named(name);
      if (!why_refused(method, c.cage).empty()) continue;
      const auto shared = with_other_parameters<double>(method, *prepared(c.cage, name, before), after);
      const auto alone = prepared(c.cage, name, after);
      EXPECT_EQ(deformed(*shared, c.posed, c.points).tensors[0], deformed(*alone, c.posed, c.points).tensors[0])
          << c.name << ' ' << name;
      EXPECT_GT(distance(deformed(*shared, c.posed, c.points),
                         deformed(*prepared(c.cage, name, before), c.posed, c.points), 0),
                1e-6)
          << c.name << ' ' << name;
    }
}

TEST(parameters, of_boundary_normals_change_without_other_coordinates) {
  for (const Case& c : {square(), pentagon()}) {
    const DeformMethod& method = deform_method_named("biharmonic_boundary");
    const auto before = prepared(c.cage, method.name);
    for (const double normals : {1.0, 2.0}) {
      const auto shared = with_other_parameters<double>(method, *before, {normals});
      const auto alone = prepared(c.cage, method.name, {normals});
      EXPECT_EQ(deformed(*shared, c.posed, c.points).tensors[0], deformed(*alone, c.posed, c.points).tensors[0])
          << c.name;
      EXPECT_GT(distance(deformed(*shared, c.posed, c.points), deformed(*before, c.posed, c.points), 0), 1e-6);
    }
    // Two pieces per edge.
    EXPECT_THROW(with_other_parameters<double>(method, *before, {0, 2}), InputError);
  }
}

// The program refuses beforehand exactly those parameters that decide the coordinates.
TEST(parameters, that_decide_coordinates_are_those_that_are_refused) {
  const Case in_space = cube(), in_plane = square();
  int deciding = 0, free = 0;
  for (const DeformMethod& method : deform_methods()) {
    const Case& c = why_refused(method, in_space.cage).empty() ? in_space : in_plane;
    const auto known = parameters_of(method);
    for (std::size_t i = 0; i < known.size(); ++i) {
      std::vector<double> changed;
      changed.reserve(known.size());
      for (const KindParameter& p : known) changed.push_back(p.preset);
      for (const double step : {1., -1., -0.125})
        if (known[i].allows(known[i].preset + step)) changed[i] = known[i].preset + step;
      ASSERT_TRUE(known[i].allows(changed[i])) << method.name << ' ' << known[i].name;
      const auto common = prepare_deformer<double>(method, c.cage, {.varied = {known[i].name}});
      const bool decides = common->with_parameters(changed) == nullptr;
      EXPECT_EQ(decides, decides_coordinates(method, known[i].name)) << method.name << ' ' << known[i].name;
      ++(decides ? deciding : free);
    }
  }
  EXPECT_GT(deciding, 5);
  EXPECT_GT(free, 20);
}

TEST(parameters, that_take_other_coordinates_are_refused) {
  const Case c = cube();
  const auto refused = [&](std::string_view name, const std::vector<double>& before, const std::vector<double>& after) {
    const DeformMethod& method = deform_method_named(name);
    EXPECT_THROW(with_other_parameters<double>(method, *prepared(c.cage, name, before), after), InputError) << name;
  };
  refused("somigliana", {0, 0.3, 0, 0, 0.5}, {0, 0.25, 0, 0, 0.5});
  refused("biharmonic_1_3", {1, 3, 1, 0, 0}, {1, 3, 1, 0, 1});
  refused("biharmonic_1_3", {1, 3, 1, 0, 0}, {1, 3, -1, 0, 0});
  refused("biharmonic_direct", {3, 0}, {3, 1});
  // With the same coordinates, others may change.
  EXPECT_NO_THROW(with_other_parameters<double>(
      deform_method_named("somigliana"), *prepared(c.cage, "somigliana", {0, 0.3, 0, 0, 0.5}), {1, 0.3, 2, 1, 0.5}));
}

}  // namespace
}  // namespace cageproof::deformation::test
