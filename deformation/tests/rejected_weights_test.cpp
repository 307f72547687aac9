// SPDX-License-Identifier: MIT
// Parameters that are refused, that have a meaning of their own, or that cost digits: weights of values, of alignment
// and of constraints, Poisson's ratio, levels.
#include "settings.h"

#include "cageproof/deformation/constrained.h"

namespace cageproof::deformation::test {
namespace {

const double nan = NAN, inf = INFINITY;

std::string refusal(const Cage& cage, std::string_view method, std::string_view parameter, double value) {
  return refusal_of([&] { prepared_with(cage, {method, {{parameter, value}}}); });
}

bool takes(const DeformMethod& method, std::string_view parameter) {
  return std::ranges::any_of(parameters_of(method), [&](const KindParameter& p) { return p.name == parameter; });
}

TEST(rejected, weights_that_are_negative_or_no_numbers) {
  int asked = 0;
  for (const Case& c : {cube(), l_shape()})
    for (const DeformMethod& method : deform_methods())
      for (const char* weight : {"gamma_d", "gamma_rel", "gamma_a"}) {
        if (!why_refused(method, c.cage).empty() || !takes(method, weight)) continue;
        for (const double bad : {-1., -1e-300, nan, inf, -inf}) {
          const std::string said = refusal(c.cage, method.name, weight, bad);
          EXPECT_TRUE(contains(said, std::string(weight) + " = ") && contains(said, "out of range"))
              << method.name << ' ' << weight << ' ' << bad << ": " << said;
        }
        ++asked;
      }
  // (1,3) and the three aligned methods in both dimensions; (1,3) on quads in space.
  EXPECT_EQ(asked, 2 * (2 + 3 * 3) + 2);
}

TEST(rejected, weights_of_constraints_that_are_negative_or_no_numbers) {
  const Cage cage = embedded_cage("cube");
  const Constraints constraints{.positions = {{{0, 0, 0}, {0, 0, 0}}, {{.25, 0, 0}, {.25, 0, 0}}}};
  int asked = 0;
  for (const ConstraintMethod& method : constraint_methods())
    for (std::size_t k = 0; k < method.parameters.size(); ++k) {
      const std::string name(method.parameters[k].name);
      if (name != "alpha" && name != "beta" && name != "gamma") continue;
      for (const double bad : {-1., nan, inf}) {
        std::vector<double> values;
        values.reserve(method.parameters.size());
        for (const KindParameter& p : method.parameters) values.push_back(p.preset);
        values[k] = bad;
        const std::string said =
            refusal_of([&] { prepare_constrained(method, cage, constraints, {.parameters = values}); });
        EXPECT_TRUE(contains(said, name + " = ")) << said;
        ++asked;
      }
    }
  EXPECT_EQ(asked, 9);
}

// In the cube, gamma_d times the size's fourth power is nine times gamma_d.
TEST(reported, weights_of_values_from_nothing_to_infinity) {
  const Case c = cube();
  const Images<double> green = deformed(*prepared(c.cage, "green", {3}), c.posed, c.points);
  for (const char* method : {"biharmonic_1_3", "aaap", "tp"}) {
    const auto with = [&](double gamma) { return prepared_with(c.cage, {method, {{"gamma_d", gamma}}}); };
    EXPECT_TRUE(warns_of(with(0)->prepared(), "gamma_d = 0: Green coordinates, by definition")) << method;
    for (const double tiny : {1e-300, 1e-30, 1e-10}) {
      EXPECT_TRUE(warns_of(with(tiny)->prepared(), "gamma_d is ")) << method << tiny;
      EXPECT_TRUE(warns_of(with(tiny)->prepared(), "digits are lost")) << method << tiny;
    }
    for (const double harmless : {1e-8, 1., 1e8})
      EXPECT_TRUE(with(harmless)->prepared().warnings.empty()) << method << harmless;
    for (const double huge : {1e12, 1e30, 1e200}) {
      const DeformationReport report = with(huge)->prepared();
      ASSERT_EQ(report.systems.size(), 1U);
      // The rows of Laplacians are tiny compared with those of values. The condition tells it, and the rank does where
      // values do not determine the densities.
      EXPECT_GT(report.systems[0].condition, 10) << method << huge;
      EXPECT_TRUE(is_finite(deformed(*with(huge), c.posed, c.points))) << method << huge;
    }
  }
  const Images<double> none = deformed(*prepared_with(c.cage, {"biharmonic_1_3", {{"gamma_d", 0}}}), c.posed, c.points);
  for (std::size_t i = 0; i < none.tensors[0].size(); ++i) EXPECT_NEAR(none.tensors[0][i], green.tensors[0][i], 1e-15);
}

TEST(rejected, poles_of_the_ratio) {
  for (const Case& c : {cube(), l_shape()}) {
    for (const double bad : {0.5, 1., -1., 0.75, 2., -3., nan})
      EXPECT_TRUE(contains(refusal(c.cage, "somigliana", "nu", bad), "nu = ")) << bad;
    for (const double good : {inf, -inf, 0., -0.5, 0.4999})
      EXPECT_EQ(refusal(c.cage, "somigliana", "nu", good), "") << good;
    // Both infinities are one material.
    for (const double variant : {0., 1.}) {
      const auto image_at = [&](double nu) {
        return deformed(*prepared_with(c.cage, {"somigliana", {{"nu", nu}, {"variant", variant}}}), c.posed, c.points);
      };
      EXPECT_EQ(image_at(inf).tensors[0], image_at(-inf).tensors[0]);
      EXPECT_TRUE(is_finite(image_at(inf)));
    }
  }
}

// One sample per triangle of the cube leaves two densities open, and Weber's construction two of its first eight. One
// sample per quad has twelve equations, of which ten are independent, for the 32 densities of vertices and corners.
TEST(reported, ranks_that_are_deficient) {
  const Case c = cube();
  int asked = 0;
  for (const DeformMethod& method : deform_methods()) {
    if (!why_refused(method, c.cage).empty() || !takes(method, "level")) continue;
    const auto deformer = prepared_with(c.cage, {method.name, {{"level", 0}}});
    // Their equations are as many as their unknowns at any level.
    if (method.name == "harmonic" || method.name == "elastic") {
      EXPECT_FALSE(deformer->prepared().systems.at(0).is_singular());
      continue;
    }
    const DeformationReport report = deformer->prepared();
    const bool weber = method.name == "biharmonic_weber", kept = method.name == "quad_biharmonic_1_3";
    const SolvedSystem& system = report.systems.at(weber ? 1 : 0);
    EXPECT_EQ(system.rank, weber ? 6 : kept ? 10 : 18) << method.name;
    EXPECT_EQ(system.columns, weber ? 8 : kept ? 32 : 20) << method.name;
    EXPECT_TRUE(system.is_singular());
    EXPECT_GT(system.condition, 1e12) << method.name;
    EXPECT_TRUE(warns_of(report, "of deficient rank, the solution of least norm is taken")) << method.name;
    EXPECT_TRUE(is_finite(deformed(*deformer, c.posed, c.points)));
    // Level 1 has samples enough.
    const DeformationReport full = prepared_with(c.cage, {method.name})->prepared();
    for (const SolvedSystem& s : full.systems) EXPECT_FALSE(s.is_singular()) << method.name;
    EXPECT_TRUE(full.warnings.empty()) << method.name;
    ++asked;
  }
  EXPECT_EQ(asked, 7);
}

// [W12]'s square system, with one collocation point per piece and one piece per edge.
TEST(reported, square_systems_that_are_singular) {
  for (const double normals : {0., 1., 2.}) {
    const auto report_with = [&](const Case& c, double collocation) {
      return prepared_with(c.cage,
                           {"biharmonic_boundary", {{"normals", normals}, {"pieces", 1}, {"collocation", collocation}}})
          ->prepared();
    };
    for (const Case& c : {square()}) {
      const DeformationReport report = report_with(c, 0);
      EXPECT_TRUE(report.systems.at(0).is_singular()) << c.name;
      EXPECT_TRUE(warns_of(report, "rank 3 of 4")) << c.name;
      EXPECT_TRUE(warns_of(report, "collocation=vertices-and-midpoints")) << c.name;
    }
    for (const Case& c : {square(), l_shape(), pentagon()}) EXPECT_TRUE(report_with(c, 1).warnings.empty()) << c.name;
  }
}

}  // namespace
}  // namespace cageproof::deformation::test
