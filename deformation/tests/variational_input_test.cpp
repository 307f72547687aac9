// SPDX-License-Identifier: MIT
// Inputs that variational maps take and refuse, and their reports.
#include "variational_cases.h"

#include "cageproof/core/input_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cageproof::deformation::test {
namespace {

TEST(variational_input, targets_may_move) {
  const Case c = bar();
  Constraints constraints = with_orientations(c.cage);
  const VariationalOptions options = bar_options(Subspace::Biharmonic, 4);
  const Variational<double> model(c.cage, constraints, options);
  std::vector<Vec> targets;
  targets.reserve(constraints.positions.size());
  for (auto& [at, to] : constraints.positions) targets.emplace_back(to = to + .2 * Vec(at[1], -at[2], .3));
  const auto moved = model.pose_to(targets);
  const Variational<double> other(c.cage, constraints, options);
  EXPECT_EQ(moved->report().energies, other.pose()->report().energies);
  targets[3][1] = NAN;
  const auto complaint = [&] {
    try {
      model.pose_to(targets);
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(complaint(), "target 3 is not finite");
  targets.pop_back();
  EXPECT_EQ(complaint(), "7 targets for 8 positional constraints");
}

TEST(variational_input, reports) {
  const Case c = bar();
  const Constraints all = bar_constraints(c.cage);
  VariationalOptions options = bar_options(Subspace::Biharmonic, 3);
  const auto stopped = Variational<double>(c.cage, all, options).pose();
  EXPECT_TRUE(warns_of(stopped->report(), "not converged"));
  ASSERT_EQ(stopped->report().systems.size(), 1);
  const SolvedSystem& system = stopped->report().systems[0];
  EXPECT_EQ(system.rows, 8 + 27 + 9 * 36);
  EXPECT_EQ(system.columns, 112);
  EXPECT_EQ(system.rank, 112);
  EXPECT_GT(system.condition, 10);
  EXPECT_LT(system.condition, 1e6);
  options.steps = 1000;
  options.tolerance = 1e-8;
  const auto done = Variational<double>(c.cage, all, options).pose();
  EXPECT_TRUE(done->report().warnings.empty());
  EXPECT_LE(done->report().figures[2].second, 1e-8);
  EXPECT_LT(done->report().figures[1].second, 1000);

  Constraints few = all;
  few.hessians.resize(2);
  const Variational<double> loose(c.cage, few, options);
  EXPECT_EQ(loose.prepared().systems[0].rank, 8 + 27 + 2 * 6);  // symmetric Hessians have six numbers
  few = all;
  few.positions.clear();
  EXPECT_TRUE(warns_of(Variational<double>(c.cage, few, options).prepared(), "no positional constraint"));
}

// A mirror image has many nearest rotations.
TEST(variational_input, rotations_that_are_not_unique_are_reported) {
  const Case c = bar();
  Constraints constraints = bar_constraints(c.cage);
  for (auto& [at, to] : constraints.positions) to = Vec(at[0], at[1], -at[2]);
  VariationalOptions options = bar_options(Subspace::Harmonic, 2);
  options.beta = 1e-16;
  const auto posed = Variational<double>(c.cage, constraints, options).pose();
  EXPECT_TRUE(warns_of(posed->report(), "rotations[0]: the nearest rotation is not unique in step 2"));
}

void expect_refused(const Constraints& constraints, const VariationalOptions& options, const std::string& words) {
  try {
    const Variational<double> model(bar().cage, constraints, options);
    ADD_FAILURE() << "not refused: " << words;
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
  }
}

TEST(variational_input, rejects) {
  const Constraints good = with_orientations(bar().cage);
  expect_refused({}, {}, "no constraints");
  expect_refused(good, {.alpha = -1}, "alpha");
  expect_refused(good, {.beta = NAN}, "beta");
  expect_refused(good, {.gamma = HUGE_VAL}, "gamma");
  expect_refused(good, {.steps = 0}, "steps");
  expect_refused(good, {.tolerance = -1}, "tolerance");
  expect_refused(good, {.evaluation = "no such"}, "no such");
  Constraints bad = good;
  bad.positions[2].to[1] = NAN;
  expect_refused(bad, {}, "positions[2].to");
  bad = good;
  bad.orientations[1].jacobian(2, 0) = HUGE_VAL;
  expect_refused(bad, {}, "orientations[1].jacobian[2]");
  bad = good;
  bad.hessians[4][2] = NAN;
  expect_refused(bad, {}, "hessians[4]");
  bad = good;
  bad.positions[3].at = {.3, .3, 1.001};
  expect_refused(bad, {}, "positions[3] at (0.3, 0.3, 1.001) is outside");
  bad = good;
  bad.orientations[0].at = {4, 0, 0};
  expect_refused(bad, {}, "orientations[0]");
  bad = good;
  bad.rotations[8] = {0, 0, -3};
  expect_refused(bad, {}, "rotations[8]");
  bad = good;
  bad.hessians[1] = {.5, .5, 0};
  expect_refused(bad, {}, "hessians[1] at (0.5, 0.5, 0) is on the cage");
  bad = good;
  bad.positions[0].to = {1e300, 0, 0};
  EXPECT_THROW(Variational<double>(bar().cage, bad, {}).pose(), InputError);
}

// Positions may be asked for on the cage itself.
TEST(variational_input, positions_on_the_cage) {
  const Case c = bar();
  Constraints constraints = bar_constraints(c.cage);
  constraints.positions.push_back({c.cage.vertices()[0], c.cage.vertices()[0]});
  EXPECT_NO_THROW(Variational<double>(c.cage, constraints, {}));
}

}  // namespace
}  // namespace cageproof::deformation::test
