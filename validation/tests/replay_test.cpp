// SPDX-License-Identifier: MIT
// Every stored worst case replays to the bits that were stored.
#include "cageproof/validation/replay.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/coordinates/whole_evaluation.h"
#include "cages/block_campaign.h"
#include "checks/element_questions.h"
#include "cageproof/validation/cage_campaign.h"
#include "run/campaign.h"
#include "deformers/deformer_campaign.h"
#include "cages/one_ring.h"
#include "thinned.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <set>

namespace cageproof::validation::replay_test {
namespace {

std::string text_of(const RowKey& row) {
  return row.subject + ' ' + row.evaluation + ' ' + row.scalar + ' ' + row.setting + ' ' + row.check + ' ' + row.place +
         " order " + std::to_string(row.order);
}

// \return the checks that had a case
std::set<std::string> expect_the_same_again(const Measurements& measurements) {
  std::set<std::string> checks;
  std::set<RowKey> named;
  for (const auto& measurement : measurements)
    for (RowKey& row : measurement->rows()) named.insert(std::move(row));
  Replayer replayer;
  for (const auto& [row, tally] : measure_all(measurements, 1).rows) {
    EXPECT_TRUE(named.contains(row)) << text_of(row) << " is a row that its measurement does not name";
    for (const WorstCase& worst : tally.worst.cases()) {
      checks.insert(row.check);
      try {
        Finding again = replayer.replay(row, worst, Triangulation::Shortest);
        EXPECT_EQ(again.status, Finding::Status::Measured) << text_of(row) << ", point " << worst.sample;
        // Tallies count what is not a number as infinite.
        if (std::isnan(again.error)) again.error = HUGE_VAL;
        EXPECT_EQ(std::bit_cast<std::uint64_t>(again.error), std::bit_cast<std::uint64_t>(worst.error))
            << text_of(row) << ", point " << worst.sample << ": " << again.error << ", stored " << worst.error;
      } catch (const InputError& e) {
        ADD_FAILURE() << text_of(row) << ": " << e.what();
      }
    }
  }
  return checks;
}

Measurements only(std::unique_ptr<const Measurement> one) {
  Measurements all;
  all.push_back(std::move(one));
  return all;
}

std::shared_ptr<const Cage> cage_named(std::string_view name) {
  return std::make_shared<const Cage>(embedded_cage(name));
}

CageCampaignOptions few_points() {
  CageCampaignOptions options;
  options.points = 6;
  options.truth_points = 1;
  options.on_points = 6;
  return options;
}

// Inside, outside, nearer to a face than the promise reaches, and on it.
std::shared_ptr<const Mesh> mesh_in_the_cube() {
  auto mesh = std::make_shared<Mesh>();
  mesh->vertices = {{0.1, 0.2, -0.3}, {0.31, -0.07, 0.44}, {1.7, 0.2, 0.1}, {0.25, 0.125, 0.9999999}, {0.01, 0, 0}};
  return mesh;
}

TEST(replayed, elements_are_what_was_measured) {
  CampaignOptions options;
  options.samples = 3;
  options.quadrature_divisor = 2;
  options.integral_samples = 2;
  options.integral_entries = 1;
  for (const char* formula : {"segment.double_layer", "triangle.double_layer"}) {
    options.formulas = formula;
    const auto checks = expect_the_same_again(element_measurements(options));
    for (const char* check : {"truth", "integral", "limit", "scaling", "enclosure"})
      EXPECT_TRUE(checks.contains(check)) << formula << ' ' << check;
  }
}

// One sample of each formula, far away, where integrals are quick.
TEST(replayed, every_formula_is_what_was_measured) {
  CampaignOptions options;
  options.regimes = "far";
  options.samples = options.swept_samples = options.integral_samples = options.integral_entries = 1;
  options.enclosures = 0;
  std::vector<std::string> names;
  for (const Formula& formula : catalogue())
    if (has_truth_source(formula)) names.emplace_back(formula.name);
  for (const std::string& name : thinned(std::move(names))) {
    options.formulas = name;
    EXPECT_TRUE(expect_the_same_again(element_measurements(options)).contains("truth")) << name;
  }
}

// A matrix's integrals on quads are asked for values only, of which a check of derivatives says nothing.
TEST(replayed, checks_are_not_asked_below_their_orders) {
  const Evaluation line_form = evaluation_named("quad.kelvin_traction", "line_form");
  const Check& differences = *find_check("gradient_by_differences");
  EXPECT_FALSE(element_question(differences, line_form, ScalarKind::Digits200, "far", 0));
  EXPECT_TRUE(element_question(differences, line_form, ScalarKind::Digits200, "far", 1));
}

// Costly integrals are asked for fewer orders than their evaluations have.
TEST(replayed, elements_with_costly_truths_are_what_was_measured) {
  CampaignOptions options;
  options.formulas = "quad.single_layer";
  options.regimes = "on-face";
  options.evaluations = "line_form";
  options.samples = options.integral_samples = 2;
  options.integral_entries = 1;
  EXPECT_TRUE(expect_the_same_again(element_measurements(options)).contains("integral"));
}

TEST(replayed, cages_are_what_was_measured) {
  for (const char* cage : {"square", "cube"}) {
    CageCampaignOptions options = few_points();
    options.signs = true;
    const auto checks = expect_the_same_again(cage_measurements(cage_named(cage), options));
    for (const char* check :
         {"partition_of_unity", "non_negativity", "zero_outside", "linear_reproduction", "cage_laplacian", "cage_truth",
          "cage_scaling", "cage_subdivision", "cage_differences", "limit_from_inside", "second_route"})
      EXPECT_TRUE(checks.contains(check)) << cage << ' ' << check;
  }
}

TEST(replayed, relations_alone_are_what_was_measured) {
  CageCampaignOptions options = few_points();
  options.kinds = "green";
  options.properties_alone = true;
  options.evaluation = "gauss-4";
  expect_the_same_again(cage_measurements(cage_named("cube"), options));
}

TEST(replayed, whole_coordinates_are_what_was_measured) {
  const auto cage = cage_named("cube");
  CageCampaignOptions options = few_points();
  options.kinds = "green";
  options.evaluation = quickest_evaluation(coordinate_kind_named("green"), *cage);
  ASSERT_FALSE(options.evaluation.empty());
  expect_the_same_again(cage_measurements(cage, options));
  const BlockCampaignOptions block{.evaluation = options.evaluation, .points = 24};
  EXPECT_EQ(expect_the_same_again(only(block_measurement(cage, coordinate_kind_named("green"), block))).size(), 1);
}

TEST(replayed, meshes_are_what_was_measured) {
  const auto cage = cage_named("cube");
  const auto mesh = mesh_in_the_cube();
  for (const CoordinateKind& kind : coordinate_kinds())
    if (accepts(kind, *cage) && is_affordable(kind, *cage, {}))
      expect_the_same_again(only(mesh_measurement(cage, kind, mesh, "mesh", 0, {})));
}

TEST(replayed, one_ring_is_what_was_measured) {
  EXPECT_EQ(expect_the_same_again(only(one_ring_measurement(cage_named("cube"), {.points = 2}))).size(), 2);
}

TEST(replayed, deformers_and_constrained_methods_are_what_was_measured) {
  DeformerCampaignOptions options;
  options.points = 2;
  options.few_points = 1;
  for (const char* cage : {"square", "cube"}) {
    // Methods on quads take one second per case, and those that solve for elastic or harmonic layers five.
    if (cage_named(cage)->dimension() == 3)
      options.methods = "green,mean_value,biharmonic_*,somigliana,maximum_entropy,variational*";
    const auto checks = expect_the_same_again(deformer_measurements(cage_named(cage), options));
    for (const char* check : {"keeps_rigid", "keeps_mirror", "deformer_truth", "deformer_jacobian",
                              "deformer_by_quadrature", "energy_falls", "constrained_motion", "second_route"})
      EXPECT_TRUE(checks.contains(check)) << cage << ' ' << check;
  }
}

TEST(replayed, what_was_never_asked_is_refused) {
  const RowKey row{RowKey::Section::Cage, "green", "closed_form", "double", "cube", "zero_outside", "inside", 0};
  EXPECT_THROW(replay(row, {}, Triangulation::Shortest), InputError);
}

}  // namespace
}  // namespace cageproof::validation::replay_test
