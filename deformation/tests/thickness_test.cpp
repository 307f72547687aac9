// SPDX-License-Identifier: MIT
// Deformation that keeps thickness ([W12] Section 5.4): the specification's bar, what must hold of a minimum, and what
// is refused.
#include "plane/thickness.h"

#include "support.h"
#include "constraint_checks.h"
#include "thickness_loops.h"

#include "cageproof/core/input_error.h"
#include "cageproof/deformation/stretch.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <numbers>

namespace cageproof::deformation::test::thickness_test {
namespace {

constexpr int kSamples = 4;
// pieces, collocation=vertices-and-midpoints, unit=own.
const std::vector<double> as_printed{1, 1, 1};

// [0, 6] x [0, 1], with a vertex at every whole number.
Cage long_bar() {
  std::vector<Vec> vertices;
  std::vector<Face> segments;
  vertices.reserve(14);
  segments.reserve(14);
  for (int i = 0; i <= 6; ++i) vertices.emplace_back(i, 0, 0);
  for (int i = 6; i >= 0; --i) vertices.emplace_back(i, 1, 0);
  for (int k = 0; k < 14; ++k) segments.push_back({{k, (k + 1) % 14, -1, -1}});
  return Cage::make_polygon("bar", vertices, segments, {});
}

Constraints lifted(double by = 1) {
  return {.positions = {{{.5, .5, 0}, {.5, .5, 0}}, {{3, .5, 0}, {3, .5 + by, 0}}, {{5.5, .5, 0}, {5.5, .5, 0}}}};
}

TEST(thickness, bar_is_that_of_the_specification) {
  const Thickness<double> model(long_bar(), lifted(), {.coordinates = as_printed});
  const auto posed = model.pose();
  const DeformationReport& report = posed->report();
  EXPECT_TRUE(report.warnings.empty()) << report.warnings.front();
  EXPECT_NEAR(figure(report, "energy a sample"), 0.0560932547, 1e-8 * 0.0560932547);
  EXPECT_NEAR(figure(report, "energy"), 56 * figure(report, "energy a sample"), 1e-14);
  EXPECT_LT(figure(report, "constraint misfit"), 1e-12);
  EXPECT_LT(figure(report, "projected gradient"), 1e-9);
  const std::vector<Vec> vertices = posed->vertices();
  ASSERT_EQ(vertices.size(), 14U);
  EXPECT_LT((vertices[0] - Vec(0.334251300004, -0.194328728691, 0)).norm(), 1e-8);
  EXPECT_LT((vertices[3] - Vec(3, 1.03421989826, 0)).norm(), 1e-8);
  const std::vector<Vec> points{{1.5, .25, 0}};
  EXPECT_LT((image(model.images(*posed, std::span(points), 0), 0, 2) - Vec(1.5518651391, 0.831145214807, 0)).norm(),
            1e-8);
}

TEST(thickness, merit_does_not_rise) {
  for (const double by : {1., 2.5, -1.}) {
    const Thickness<double> model(long_bar(), lifted(by), {.coordinates = as_printed});
    const auto posed = model.pose();
    const DeformationReport& report = posed->report();
    EXPECT_EQ(report.unsolved, "");
    ASSERT_EQ(report.merits.size(), 1 + static_cast<std::size_t>(figure(report, "steps")));
    for (std::size_t k = 1; k < report.merits.size(); ++k)
      EXPECT_LE(report.merits[k], report.merits[k - 1] * (1 + 1e-12)) << by << ", step " << k;
    // The constraints are met in the end: nothing but the energy is left.
    EXPECT_NEAR(report.merits.back(), figure(report, "energy"), 1e-9 * report.merits.back());
  }
}

TEST(thickness, bar_stays_symmetric) {
  const auto vertices = Thickness<double>(long_bar(), lifted(), {.coordinates = as_printed}).pose()->vertices();
  for (int i = 0; i <= 6; ++i)
    for (const auto& [one, other] : {std::pair{i, 6 - i}, std::pair{13 - i, 7 + i}})
      EXPECT_LT((vertices[one] - Vec(6 - vertices[other][0], vertices[other][1], 0)).norm(), 1e-10) << i;
}

TEST(thickness, rigid_targets_are_met_without_energy) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(2.2, Vec::UnitZ()).toRotationMatrix();
  const Vec shift(3, -1, 0);
  // By default edges have four pieces, next to whose ends second derivatives, and their roundings, are larger.
  for (const auto& [parameters, rounding] : {std::pair{as_printed, 1e-25}, std::pair{std::vector<double>{}, 1e-24}}) {
    Constraints constraints = lifted();
    for (auto& [at, to] : constraints.positions) to = turn * at + shift;
    const Thickness<double> model(long_bar(), constraints, {.coordinates = parameters});
    const auto posed = model.pose();
    EXPECT_LE(figure(posed->report(), "energy"), rounding);
    EXPECT_EQ(posed->report().unsolved, "");
    const std::vector<Vec> points{{1.5, .25, 0}, {4, .75, 0}}, rest = long_bar().vertices();
    const Images<double> images = model.images(*posed, std::span(points), 0);
    for (std::size_t p = 0; p < points.size(); ++p)
      EXPECT_LT((image(images, p, 2) - (turn * points[p] + shift)).norm(), 1e-11);
    for (std::size_t v = 0; v < rest.size(); ++v)
      EXPECT_LT((posed->vertices()[v] - (turn * rest[v] + shift)).norm(), 1e-11);
  }
}

TEST(thickness, newton_step_of_the_dense_equations_leaves_the_minimum) {
  const Constraints constraints = lifted();
  const Thickness<double> model(long_bar(), constraints, {.coordinates = as_printed});
  const auto posed = model.pose();
  const ThicknessLoops loops(model.coordinates(), constraints, kSamples);
  Eigen::VectorXd f(28);
  for (int v = 0; v < 14; ++v) f.segment(2 * v, 2) = posed->vertices()[v].head(2);
  EXPECT_NEAR(loops.energy(f), figure(posed->report(), "energy"), 1e-11);
  EXPECT_LT(loops.misfit(f).norm(), 1e-12);
  const Eigen::MatrixXd gradients = loops.constraint_gradients(f);
  const Eigen::VectorXd multipliers = gradients.colPivHouseholderQr().solve(-loops.energy_gradient(f));
  const auto lagrangian = [&](const Eigen::VectorXd& at) -> Eigen::VectorXd {
    return loops.energy_gradient(at) + loops.constraint_gradients(at) * multipliers;
  };
  const double h = 1e-5;
  Eigen::MatrixXd equations = Eigen::MatrixXd::Zero(34, 34);
  for (int k = 0; k < 28; ++k) {
    const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(28, k);
    equations.col(k).head(28) = (lagrangian(f + step) - lagrangian(f - step)) / (2 * h);
  }
  equations.topRightCorner(28, 6) = gradients;
  equations.bottomLeftCorner(6, 28) = gradients.transpose();
  Eigen::VectorXd right(34);
  right << -lagrangian(f), -loops.misfit(f);
  EXPECT_LT(equations.fullPivLu().solve(right).head(28).cwiseAbs().maxCoeff(), 1e-10);
  // A minimum along the constraints, not a saddle.
  const Eigen::MatrixXd orthogonal = Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(gradients).householderQ();
  const Eigen::MatrixXd along = orthogonal.rightCols(22);
  const Eigen::MatrixXd hessian = along.transpose() * equations.topLeftCorner(28, 28) * along;
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>((hessian + hessian.transpose()) / 2).eigenvalues()[0], 1e-3);
  // Elsewhere the step is none of nothing.
  EXPECT_GT(loops.energy_gradient(f + Eigen::VectorXd::Constant(28, 1e-3)).norm(), 1e-3);
}

TEST(thickness, fifty_digits_agree) {
  const ThicknessOptions options{.steps = 12, .coordinates = as_printed};
  const auto exact = Thickness<Mp50>(long_bar(), lifted(), options).pose();
  const auto found = Thickness<double>(long_bar(), lifted(), options).pose();
  for (int v = 0; v < 14; ++v)
    EXPECT_LT((convert<double>(exact->vertices()[v]) - found->vertices()[v]).norm(), 1e-9) << v;
}

TEST(thickness, is_registered_with_the_parameters_of_its_coordinates) {
  const ConstraintMethod* method = find_constraint_method("thickness");
  ASSERT_NE(method, nullptr);
  std::vector<std::string> names;
  names.reserve(method->parameters.size());
  for (const KindParameter& p : method->parameters) names.emplace_back(p.name);
  EXPECT_EQ(names, (std::vector<std::string>{"samples", "steps", "pieces", "collocation", "unit"}));
  const auto model = prepare_constrained(*method, long_bar(), lifted(), {.parameters = {kSamples, 100, 1, 1, 1}});
  const auto expected = Thickness<double>(long_bar(), lifted(), {.coordinates = as_printed}).pose();
  EXPECT_EQ(model->pose()->vertices(), expected->vertices());
  // Parameters at their defaults, and targets that move.
  const auto other = prepare_constrained(*method, long_bar(), lifted(), {});
  const auto moved = other->pose_to({{.5, .5, 0}, {3, .25, 0}, {5.5, .5, 0}});
  EXPECT_EQ(moved->vertices(), prepare_constrained(*method, long_bar(), lifted(-.25), {})->pose()->vertices());
  EXPECT_EQ(moved->report().unsolved, "");
}

// Targets so far off that steps lower nothing: the merit stays where it was, and steps end.
TEST(thickness, merit_does_not_rise_for_targets_that_tear) {
  Constraints far;
  far.positions = {{{.5, .5, 0}, {.5, .7, 0}}, {{.25, .25, 0}, {3, -5, 0}}, {{.75, .25, 0}, {-4, -5, 0}}};
  const auto posed = Thickness<double>(square().cage, far, {}).pose();
  const std::vector<double>& merits = posed->report().merits;
  ASSERT_GT(merits.size(), 2U);
  for (std::size_t k = 1; k < merits.size(); ++k) EXPECT_LE(merits[k], merits[k - 1] * (1 + 1e-12)) << k;
}

// Ranks of what has other units of length do not depend on the user's.
TEST(thickness, does_not_depend_on_the_unit) {
  const Case c = square();
  const auto image_in = [&](double s) {
    std::vector<Vec> vertices = c.cage.vertices();
    for (Vec& v : vertices) v *= s;
    Constraints drawn;
    drawn.positions = {{{.5 * s, .5 * s, 0}, {.5 * s, .5 * s, 0}}, {{.25 * s, .75 * s, 0}, {.2 * s, .8 * s, 0}}};
    const Thickness<double> model(c.cage.with(vertices, c.cage.faces()), drawn, {});
    EXPECT_EQ(model.prepared().warnings.empty(),
              Thickness<double>(c.cage, {.positions = {{{.5, .5, 0}, {.5, .5, 0}}, {{.25, .75, 0}, {.2, .8, 0}}}}, {})
                  .prepared()
                  .warnings.empty())
        << s;
    const std::vector<Vec> point{{.3 * s, .6 * s, 0}};
    return Vec(image(model.images(*model.pose(), std::span(point), 0), 0, 2) / s);
  };
  const Vec here = image_in(1);
  for (const double s : {1e-80, 1e-6, 1e8}) EXPECT_LT((image_in(s) - here).norm(), 1e-9) << s;
}

// A hexagon with a corner cut off by an edge of that length.
Cage cut_hexagon(double edge) {
  const double half = std::sqrt(3) / 2;
  const std::vector<Vec> vertices{{1, 0, 0},
                                  {.5, half, 0},
                                  {-.5, half, 0},
                                  {-1, 0, 0},
                                  {-.5, -half, 0},
                                  {.5, -half, 0},
                                  {.5 + .5 * edge, half * (edge - 1), 0}};
  std::vector<Face> segments;
  segments.reserve(7);
  for (int k = 0; k < 7; ++k) segments.push_back({{k, (k + 1) % 7, -1, -1}});
  return Cage::make_polygon("cut hexagon", vertices, segments, {});
}

const std::vector<Vec> in_hexagon{{0, 0, 0}, {.5, .25, 0}, {-.375, .375, 0}};

Constraints moved_in_hexagon(double angle, const Vec& shift) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vec::UnitZ()).toRotationMatrix();
  Constraints constraints;
  for (const Vec& at : in_hexagon) constraints.positions.push_back({at, turn * at + shift});
  return constraints;
}

// Second derivatives at an edge are as large as it is short, squared: steps from rest did not come to an end.
TEST(thickness, rigid_motions_are_kept_next_to_short_edges) {
  for (const double edge : {1e-2, 1e-4}) {
    const Cage cage = cut_hexagon(edge);
    const Thickness<double> model(cage, moved_in_hexagon(0, {0, 0, 0}));
    const std::vector<Vec> points{{.1, .2, 0}, {-.7, .1, 0}, {.5 + .2 * edge, edge - std::sqrt(3) / 2, 0}};
    for (const auto& [angle, shift] : {std::pair{0., Vec(0, 0, 0)}, std::pair{2.2, Vec(0, 0, 0)},
                                       std::pair{0., Vec(2e3, -1400, 0)}, std::pair{0., Vec(2e6, -1.4e6, 0)}}) {
      const Constraints constraints = moved_in_hexagon(angle, shift);
      const auto posed = model.pose_to(targets_of(constraints));
      EXPECT_EQ(posed->report().unsolved, "") << edge;
      const Images<double> images = model.images(*posed, std::span(points), 0);
      const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vec::UnitZ()).toRotationMatrix();
      for (std::size_t p = 0; p < points.size(); ++p)
        EXPECT_LT((image(images, p, 2) - (turn * points[p] + shift)).norm(), 1e-12 + 4e-16 * shift.norm())
            << edge << ' ' << angle << ' ' << shift[0] << ' ' << p;
    }
  }
}

// Bent poses next to a short edge take more digits than double has, which users get.
TEST(thickness, solves_in_50_digits_next_to_short_edges) {
  const ConstraintMethod& method = *find_constraint_method("thickness");
  Constraints bent = moved_in_hexagon(0, {0, 0, 0});
  bent.positions[0].to = {.05, -.1, 0};
  const auto model = prepare_constrained(method, cut_hexagon(1e-3), bent, {});
  EXPECT_EQ(figure(model->prepared(), "digits of systems"), 50);
  const auto posed = model->pose();
  EXPECT_EQ(posed->report().unsolved, "");
  const auto short_edged = prepare_constrained(method, cut_hexagon(.1), bent, {});
  EXPECT_TRUE(std::ranges::none_of(short_edged->prepared().figures, [](const auto& f) { return f.first[0] == 'd'; }));
  // Stationary, by derivatives that explicit sums make at points next to the samples.
  const ThicknessLoops loops(model->coordinates(), bent, kSamples);
  Eigen::VectorXd f(14);
  for (int v = 0; v < 7; ++v) f.segment(2 * v, 2) = posed->vertices()[v].head(2);
  EXPECT_LT(loops.misfit(f).norm(), 1e-11);
}

TEST(thickness, reports) {
  const auto stopped = Thickness<double>(long_bar(), lifted(), {.steps = 1, .coordinates = as_printed}).pose();
  EXPECT_TRUE(stopped->report().unsolved.starts_with("not converged after 1 steps: the last changed vertices by"));
  EXPECT_EQ(figure(stopped->report(), "steps"), 1);
  Constraints one = lifted();
  one.positions.resize(1);
  EXPECT_TRUE(warns_of(Thickness<double>(long_bar(), one, {.coordinates = as_printed}).prepared(),
                       "the positions leave 1 of 28 unknowns free"));
  Constraints twice = lifted();
  twice.positions.push_back(twice.positions[1]);
  const Thickness<double> model(long_bar(), twice, {.coordinates = as_printed});
  const auto consistent = model.pose();
  EXPECT_TRUE(warns_of(model.prepared(), "the positions are not independent: rank 6 of 8"));
  EXPECT_NEAR(figure(consistent->report(), "energy a sample"), 0.0560932547, 1e-8 * 0.0560932547);
  twice.positions[3].to[1] += .5;
  const auto contradicting = Thickness<double>(long_bar(), twice, {.coordinates = as_printed}).pose();
  EXPECT_TRUE(contradicting->report().unsolved.starts_with("not converged"));
  EXPECT_GT(figure(contradicting->report(), "constraint misfit"), .1);
}

void expect_refused(const Cage& cage, const Constraints& constraints, const ThicknessOptions& options,
                    const std::string& words) {
  try {
    const Thickness<double> model(cage, constraints, options);
    ADD_FAILURE() << "not refused: " << words;
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
  }
}

TEST(thickness, rejects) {
  const Cage bar = long_bar();
  expect_refused(bar, {}, {}, "there are no positions");
  expect_refused(embedded_cage("cube"), lifted(), {}, "only in the plane");
  expect_refused(bar, lifted(), {.samples = 0}, "samples = 0");
  expect_refused(bar, lifted(), {.steps = 0}, "steps = 0");
  expect_refused(bar, lifted(), {.coordinates = {8, 1, 0}},
                 "sample 1 of 4 on edge 0: it lies where two of the edge's pieces meet");
  Constraints bad = lifted();
  bad.positions[1].at = {3, 1.01, 0};
  expect_refused(bar, bad, {}, "positions[1] at (3, 1.01) is outside");
  bad = lifted();
  bad.positions[2].to[0] = NAN;
  expect_refused(bar, bad, {}, "positions[2].to");
  bad = lifted();
  bad.rotations.emplace_back(3, .5, 0);
  expect_refused(bar, bad, {}, "only positions");
  bad = lifted();
  for (int k = 0; k < 12; ++k) bad.positions.push_back({{.5 + .4 * k, .25, 0}, {.5 + .4 * k, .25, 0}});
  expect_refused(bar, bad, {}, "15 positions are more than the 14 vertices");
}

}  // namespace
}  // namespace cageproof::deformation::test::thickness_test
