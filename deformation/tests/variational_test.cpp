// SPDX-License-Identifier: MIT
// Variational maps ([T24] Section 4.2): reference numbers computed elsewhere, and what the energy says by loops over
// constraints.
#include "variational_cases.h"
#include "variational_loops.h"

#include <gtest/gtest.h>

namespace cageproof::deformation::test {
namespace {

constexpr std::array all_subspaces{Subspace::Harmonic, Subspace::Biharmonic, Subspace::Elastic};

void expect_reference(Subspace subspace, const std::array<double, 4>& energies, const Vec& image_of_first) {
  const Case c = bar();
  const Variational<double> model(c.cage, bar_constraints(c.cage), bar_options(subspace, 20));
  const auto posed = model.pose();
  const std::vector<double>& found = posed->report().energies;
  ASSERT_EQ(found.size(), 40);
  constexpr std::array<std::size_t, 4> after{1, 2, 5, 20};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(found[2 * after[k] - 1], energies[k], 1e-11) << after[k];
  EXPECT_LT((image(model.images(*posed, c.points, 0), 0) - image_of_first).norm(), 1e-11 * c.size);
  EXPECT_EQ(posed->report().figures[0].second, found.back());
}

TEST(variational, reference) {
  expect_reference(Subspace::Harmonic, {0.171206209258, 0.0907690174056, 0.0853795419204, 0.0853741805447},
                   {0.174712103997, -0.00770710741613, 0.366648056717});
  expect_reference(Subspace::Biharmonic, {0.140782120366, 0.0749904787068, 0.0647914866448, 0.0646529156277},
                   {0.187437615309, -0.0176151028318, 0.365782832428});
}

TEST(variational, reference_in_50_digits) {
  const Case c = bar();
  const Variational<Mp50> model(c.cage, bar_constraints(c.cage), bar_options(Subspace::Harmonic, 5));
  const auto posed = model.pose();
  const std::vector<double>& found = posed->report().energies;
  ASSERT_EQ(found.size(), 10);
  EXPECT_NEAR(found[1], 0.171206209258, 6e-13);
  EXPECT_NEAR(found[3], 0.0907690174056, 6e-14);
  EXPECT_NEAR(found[9], 0.0853795419204, 6e-14);
}

// Every energy of the report is that of the map before or after its step, with the rotations of the step.
void expect_energies(const Cage& cage, const Constraints& constraints, VariationalOptions options) {
  const int d = cage.dimension(), steps = 3;
  options.steps = steps;
  options.tolerance = 0;
  const std::vector<double> energies = Variational<double>(cage, constraints, options).pose()->report().energies;
  ASSERT_EQ(energies.size(), 2 * steps);
  Map before = identity(d);
  for (int k = 0; k < steps; ++k) {
    const Map after = map_after(k + 1, cage, constraints, options);
    const auto terms = terms_of(constraints, options, nearest_at(before, constraints, options.nearest, d), d);
    EXPECT_NEAR(energies[2 * k], energy_of(before, terms), 1e-11 * energies[2 * k]) << "step " << k + 1;
    EXPECT_NEAR(energies[2 * k + 1], energy_of(after, terms), 1e-11 * energies[0]) << "step " << k + 1;
    before = after;
  }
}

// The images are mirrored, and flat: Jacobians have negative determinants, but nearest rotations.
Constraints mirrored(Constraints constraints) {
  for (auto& [at, to] : constraints.positions) to = Vec(1.2 * at[0], 1.1 * at[1] + .1 * at[0], -.5 * at[2]);
  return constraints;
}

TEST(variational, energies_are_those_of_the_maps) {
  for (const Nearest nearest : {Nearest::Rotation, Nearest::Similarity})
    for (const Subspace subspace : all_subspaces) {
      const VariationalOptions options{
          .subspace = subspace, .nearest = nearest, .alpha = .05, .beta = .2, .gamma = .003};
      expect_energies(bar().cage, with_orientations(bar().cage), options);
      expect_energies(pentagon().cage, plane_constraints(), options);
      VariationalOptions loose = options;
      loose.alpha = loose.beta = .001;
      expect_energies(bar().cage, mirrored(with_orientations(bar().cage)), loose);
    }
}

// After a global step no change of the coefficients lowers the energy, at the rotations of that step.
void expect_flat(const Cage& cage, const Constraints& constraints, const VariationalOptions& options) {
  const int d = cage.dimension();
  const Variational<double> model(cage, constraints, options);
  for (const int step : {1, 3}) {
    const Map before = map_after(step - 1, cage, constraints, options),
              after = map_after(step, cage, constraints, options);
    const auto terms = terms_of(constraints, options, nearest_at(before, constraints, options.nearest, d), d);
    const double at_rest = gradient_of(model.coordinates(), identity(d), terms).norm();
    EXPECT_LT(gradient_of(model.coordinates(), after, terms).norm(), 1e-11 * at_rest) << "step " << step;
  }
}

TEST(variational, gradient_vanishes_after_a_global_step) {
  for (const Subspace subspace : all_subspaces) {
    const VariationalOptions options{.subspace = subspace, .alpha = .05, .beta = .2, .gamma = .003};
    expect_flat(bar().cage, with_orientations(bar().cage), options);
    expect_flat(pentagon().cage, plane_constraints(), options);
  }
}

TEST(variational, energy_never_rises) {
  const Case c = bar();
  for (const Nearest nearest : {Nearest::Rotation, Nearest::Similarity})
    for (const double beta : {.01, 1.})
      for (const Subspace subspace : all_subspaces) {
        const VariationalOptions options{
            .subspace = subspace, .nearest = nearest, .beta = beta, .steps = 40, .tolerance = 0};
        const auto found = Variational<double>(c.cage, with_orientations(c.cage), options).pose()->report().energies;
        ASSERT_EQ(found.size(), 80);
        for (std::size_t k = 1; k < found.size(); ++k) EXPECT_LE(found[k], found[k - 1] * (1 + 1e-12)) << k;
      }
}

TEST(variational, rigid_targets_are_met) {
  const Case c = bar();
  const Mat turn = Eigen::AngleAxisd(1.1, Vec(1, 2, -.5).normalized()).toRotationMatrix();
  const Vec shift(.3, -.2, 1);
  for (const Subspace subspace : all_subspaces) {
    Constraints constraints = bar_constraints(c.cage);
    for (auto& [at, to] : constraints.positions) to = turn * at + shift;
    constraints.orientations = {{{.1, .2, .3}, turn}};
    const Variational<double> model(c.cage, constraints, bar_options(subspace, 600));
    const auto posed = model.pose();
    EXPECT_LT(posed->report().energies.back(), 1e-20);
    const Images<double> images = model.images(*posed, c.points, 1);
    for (std::size_t p = 0; p < c.points.size(); ++p) {
      EXPECT_LT((image(images, p) - (turn * c.points[p] + shift)).norm(), 1e-9);
      for (int k = 0; k < 9; ++k) EXPECT_NEAR(images.tensors[1][9 * p + k], turn(k / 3, k % 3), 1e-8);
    }
  }
}

// A face of 1e-5 has basis functions that hardly reach the constraints: what is solved for is rounded there.
TEST(variational, rigid_motions_are_kept_next_to_small_faces) {
  const Cage cage = embedded_cage("bevel-1e-5");
  const std::vector<Vec> inside{
      {.25, .25, .25}, {.5, .125, .125}, {.125, .5, .125}, {.125, .125, .5}, {.0625, .0625, .25}},
      points{{.3, .2, .25}, {2e-5, 1e-5, 1e-5}, {1e-5, 1e-5, 1e-3}};
  for (const auto& [angle, shift] : {std::pair{0., Vec(0, 0, 0)}, std::pair{.8, Vec(0, 0, 0)},
                                     std::pair{0., Vec(1e3, -700, 400)}, std::pair{.8, Vec(1e6, -7e5, 4e5)}}) {
    const Mat turn = Eigen::AngleAxisd(angle, Vec(1, 2, 3).normalized()).toRotationMatrix();
    Constraints constraints;
    for (const Vec& at : inside) constraints.positions.push_back({at, turn * at + shift});
    constraints.rotations = {{.2, .2, .2}, {.1, .1, .4}};
    for (int k = 0; k < 12; ++k) constraints.hessians.emplace_back(.1 + .02 * k, .3 - .02 * k, .2);
    for (const Subspace subspace : {Subspace::Harmonic, Subspace::Biharmonic}) {
      const Variational<double> model(cage, constraints, bar_options(subspace, 100));
      const auto posed = model.pose();
      const Images<double> images = model.images(*posed, points, 0);
      for (std::size_t p = 0; p < points.size(); ++p)
        EXPECT_LT((image(images, p) - (turn * points[p] + shift)).norm(), 1e-14 + 4e-16 * shift.norm())
            << angle << ' ' << shift[0] << ' ' << p;
    }
  }
}

// Few constraints leave most of the map open: it stays next to the motion that they ask for.
TEST(variational, few_positions_move_all) {
  const Case c = bar();
  const Vec shift(.3, -.2, 1);
  const Constraints one{.positions = {{{.1, .2, .3}, Vec(.1, .2, .3) + shift}}};
  const Variational<double> model(c.cage, one);
  const auto posed = model.pose();
  EXPECT_TRUE(warns_of(posed->report(), "the map next to a rigid motion is taken"));
  const Images<double> images = model.images(*posed, c.points, 0);
  for (std::size_t p = 0; p < c.points.size(); ++p) EXPECT_LT((image(images, p) - (c.points[p] + shift)).norm(), 1e-14);
}

// Without rotations the problem is linear, and affine maps of all constraints have no energy.
TEST(variational, affine_targets_are_met_at_once_without_rotations) {
  const Case c = bar();
  Constraints constraints = with_orientations(c.cage);
  constraints.rotations.clear();
  const Mat a = constraints.orientations[0].jacobian;
  const Vec shift(.3, -.2, 1);
  constraints.orientations[1].jacobian = a;
  for (auto& [at, to] : constraints.positions) to = a * at + shift;
  for (const Subspace subspace : all_subspaces) {
    const Variational<double> model(c.cage, constraints, {.subspace = subspace});
    const auto posed = model.pose();
    EXPECT_EQ(posed->report().energies.size(), 2);
    EXPECT_TRUE(posed->report().warnings.empty());
    EXPECT_LT(posed->report().energies[1], 1e-22);
    for (std::size_t p = 0; p < c.points.size(); ++p)
      EXPECT_LT((image(model.images(*posed, c.points, 0), p) - (a * c.points[p] + shift)).norm(), 1e-10);
  }
}

TEST(variational, similarities_are_met_where_asked_for) {
  const Case c = bar();
  Constraints constraints = bar_constraints(c.cage);
  for (auto& [at, to] : constraints.positions) to = 1.5 * at;
  VariationalOptions options = bar_options(Subspace::Biharmonic, 400);
  EXPECT_GT(Variational<double>(c.cage, constraints, options).pose()->report().energies.back(), 1e-3);
  options.nearest = Nearest::Similarity;
  EXPECT_LT(Variational<double>(c.cage, constraints, options).pose()->report().energies.back(), 1e-20);
}

Constraints scaled(Constraints c, double s) {
  for (auto& [at, to] : c.positions) at *= s, to *= s;
  for (auto& [at, jacobian] : c.orientations) at *= s;
  for (Vec& at : c.rotations) at *= s;
  for (Vec& at : c.hessians) at *= s;
  return c;
}

// The image of the bar's first point where all lengths are s times as large, over s.
Vec image_in_unit(double s, const Constraints& constraints, const VariationalOptions& options) {
  const Case c = bar();
  std::vector<Vec> vertices = c.cage.vertices();
  for (Vec& v : vertices) v *= s;
  const Variational<double> model(c.cage.with(vertices, c.cage.faces()), scaled(constraints, s), options);
  return image(model.images(*model.pose(), std::vector<Vec>{s * c.points[0]}, 0), 0) / s;
}

VariationalOptions in_unit(double s, VariationalOptions options) {
  options.alpha *= s * s;
  options.beta *= s * s;
  options.gamma *= s * s * s * s;
  return options;
}

TEST(variational, unit_of_length) {
  const Case c = bar();
  const Constraints constraints = with_orientations(c.cage);
  for (const double s : {10., 1e-3})
    for (const Subspace subspace : all_subspaces) {
      const VariationalOptions options = bar_options(subspace, 5);
      const Vec expected = image_in_unit(1, constraints, options);
      EXPECT_GT((image_in_unit(s, constraints, options) - expected).norm(), 1e-3) << "the weights have units";
      EXPECT_LT((image_in_unit(s, constraints, in_unit(s, options)) - expected).norm(), 1e-12 * c.size);
    }
}

// Coefficients that are not determined have a least norm that knows no unit either.
TEST(variational, unit_of_length_of_few_constraints) {
  Constraints few = bar_constraints(bar().cage);
  few.hessians.resize(2);
  for (const Subspace subspace : {Subspace::Biharmonic, Subspace::Elastic}) {
    const VariationalOptions options = bar_options(subspace, 5);
    const Vec expected = image_in_unit(1, few, options);
    for (const double s : {10., 1e-3, 1e4})
      EXPECT_LT((image_in_unit(s, few, in_unit(s, options)) - expected).norm(), 1e-10) << s;
  }
}

// Rows so heavy that double drops the others: the motion next to the targets is left.
TEST(variational, weights_that_are_too_uneven_do_not_raise_the_energy) {
  const Case c = bar();
  Constraints rest = bar_constraints(c.cage);
  for (auto& position : rest.positions) position.to = position.at;
  // No rigid motion, which would need no solution.
  rest.positions[0].to[0] += 1e-3;
  for (const double gamma : {1e23, 1e26}) {
    VariationalOptions options = bar_options(Subspace::Biharmonic, 20);
    options.gamma = gamma;
    const auto posed = Variational<double>(c.cage, rest, options).pose();
    const std::vector<double>& energies = posed->report().energies;
    for (std::size_t k = 1; k < energies.size(); ++k)
      EXPECT_LE(energies[k], energies[k - 1] * (1 + 1e-9)) << gamma << ' ' << k;
    const Variational<double> model(c.cage, rest, options);
    EXPECT_LT((image(model.images(*posed, std::span(c.points), 0), 0) - c.points[0]).norm(), 1e-3) << gamma;
  }
}

}  // namespace
}  // namespace cageproof::deformation::test
