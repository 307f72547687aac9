// SPDX-License-Identifier: MIT
// The table of promises: whole for what people rely on, and for other evaluations enough to tell another formula.
#include "cageproof/validation/promise.h"
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/validation/check.h"
#include "cageproof/validation/regime.h"
#include "cageproof/validation/truth.h"
#include "promises/verdicts.h"
#include "run/run_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace cageproof::validation {
namespace {

std::optional<double> bound(const char* subject, const char* evaluation, const char* regime, int order = 0) {
  return promise_for({"truth", subject, evaluation, "double", regime, order}).bound;
}

// An evaluation that is 170 % off, far away and within one size.
double error_when_wrong(const char* subject, const char* evaluation, double distance) {
  const Formula& formula = formula_named(subject);
  Sample sample{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0.25, 0.25, distance}, {}, 0, 0};
  if (formula.corners() == 4) sample.corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.3}, {0, 1, 0}};
  for (const Parameter& p : formula.parameters) sample.parameters.push_back(p.preset);
  const Truth truth = truth_from(truth_source(formula), sample, 0);
  Result<double> f = evaluate<double>(evaluation_named(subject, evaluation), sample, 0);
  for (double& x : f.value) x *= 2.7;
  return conditioned_error(f, truth, 0, Mp100(0x1p-53));
}

TEST(promises, of_rules_printed_forms_and_schemes_catch_another_formula) {
  struct Case {
    const char *subject, *evaluation, *regime;
  };
  for (const Case& c : {Case{"triangle.double_layer", "published", "generic"},
                        {"triangle.double_layer", "gauss-4", "far"},
                        {"triangle.kelvin_traction", "gauss-16", "far"},
                        {"triangle.kelvin_traction", "three-quad-75", "far"},
                        {"triangle.single_layer", "near-singular-16", "generic"},
                        {"quad.mean_value", "riemann-4", "far"},
                        {"quad.mean_value", "riemann-10", "generic"},
                        {"quad.mean_value", "tessellated-5", "far"}}) {
    const auto promised = bound(c.subject, c.evaluation, c.regime);
    ASSERT_TRUE(promised) << c.evaluation << ' ' << c.regime;
    EXPECT_GT(error_when_wrong(c.subject, c.evaluation, std::string_view(c.regime) == "far" ? 10 : 0.6), *promised)
        << c.subject << ' ' << c.evaluation;
  }
}

TEST(promises, stay_away_from_weak_spots) {
  EXPECT_FALSE(bound("triangle.double_layer", "published", "near-edge"));
  EXPECT_FALSE(bound("triangle.double_layer", "gauss-16", "near-face"));
  EXPECT_FALSE(bound("quad.mean_value", "riemann-10", "near-vertex"));
  EXPECT_EQ(bound("triangle.double_layer", "closed_form", "near-edge"), 64);
}

std::string words_of(const RowKey& row) {
  return row.check + ' ' + row.subject + ' ' + row.evaluation + ' ' + row.scalar + ' ' + row.setting + ' ' + row.place +
         " order " + std::to_string(row.order);
}

// All rows that a default run on a cage may fill, with those of elements where they are asked for.
std::set<RowKey> rows_of_run(std::string_view cage, bool with_elements) {
  VerifyOptions options;
  options.suite = suites().front();
  options.cage = embedded_cage(cage);
  options.only_cage = !with_elements;
  std::set<RowKey> rows;
  for (const auto& measurement : plan_run(options).measurements)
    for (RowKey& row : measurement->rows()) rows.insert(std::move(row));
  return rows;
}

// The role of the row's evaluation. Kinds that are no sums and deformers have none, and people rely on them, except on
// other ways to prepare a kind.
std::optional<Role> role_in(const RowKey& row) {
  if (row.section == RowKey::Section::Deformer) return Role::Recommended;
  const CoordinateKind* kind = row.section == RowKey::Section::Cage ? find_coordinate_kind(row.subject) : nullptr;
  if (kind != nullptr && !kind->is_sum()) {
    const bool is_other = std::ranges::find(kind->other_evaluations, row.evaluation) != kind->other_evaluations.end();
    return is_other ? std::nullopt : std::optional(Role::Recommended);
  }
  const std::string name = role_of(row);
  const auto role = std::ranges::find_if(roles, [&](const Role known) { return name_of(known) == name; });
  return role == roles.end() ? std::nullopt : std::optional(*role);
}

// A forgotten bound would look like a decision to promise nothing. Nothing is measured: the plan's questions say what
// they ask of which order, on all embedded cages and on somebody's own as on these two.
TEST(promises, are_made_or_declined_for_every_row_of_what_people_rely_on) {
  std::vector<std::string> settings{"somebody's.obj"};
  for (const auto& names : {embedded_cage_names(), extreme_cage_names()})
    for (const auto name : names) settings.emplace_back(name);
  std::map<RowKey::Section, int> asked;
  for (const bool in_space : {false, true})
    for (const RowKey& row : rows_of_run(in_space ? "cube" : "square", !in_space)) {
      ++asked[row.section];
      const bool of_cage = row.section != RowKey::Section::Element;
      for (const std::string& setting : of_cage ? settings : std::vector{row.setting})
        EXPECT_NO_THROW(
            require_row({row.check, row.subject, row.evaluation, row.scalar, setting, row.order}, role_in(row)))
            << words_of(row);
    }
  EXPECT_GT(asked[RowKey::Section::Element], 10000);
  EXPECT_GT(asked[RowKey::Section::Cage], 1000);
  EXPECT_GT(asked[RowKey::Section::Deformer], 1000);
}

TEST(promises, are_missed_where_the_table_has_no_row) {
  const auto truth_of = [](std::string_view evaluation) {
    return PromiseKey{"truth", "triangle.single_layer", evaluation, "double", "generic", 0};
  };
  // A rule's name does not make a rule of what people rely on.
  for (const Role role : {Role::Recommended, Role::Stated, Role::Batched})
    for (const std::string_view name : {"novel_form", "gauss-99", "near-singular-99", "adaptive"})
      EXPECT_THROW(require_row(truth_of(name), role), std::logic_error) << name_of(role) << ' ' << name;
  EXPECT_NO_THROW(require_row(truth_of("novel_form"), Role::Foreign));
  EXPECT_NO_THROW(require_row(truth_of("gauss-12"), Role::Rule));
  EXPECT_THROW(require_row({"novel_check", "green", "batched", "double", "cube", 0}, std::nullopt), std::logic_error);
}

// The name decides nothing: what the program's own register says of an evaluation does.
TEST(promises, stop_a_verdict_without_a_row) {
  ResultRow row;
  row.section = RowKey::Section::Cage;
  row.subject = "green";
  row.evaluation = "batched";
  row.scalar = "double";
  row.setting = "cube";
  row.check = "cage_truth";
  EXPECT_NO_THROW(judge(row));
  row.check = "novel_check";
  EXPECT_THROW(judge(row), std::logic_error);
  row.check = "cage_truth";
  row.scalar = "mp50";
  EXPECT_THROW(judge(row), std::logic_error);
}

}  // namespace
}  // namespace cageproof::validation
