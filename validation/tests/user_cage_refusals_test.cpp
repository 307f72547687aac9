// SPDX-License-Identifier: MIT
// Deformers that refuse only a moved copy or a pose of a user's cage are named, and judged by the rest.
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/input_error.h"
#include "deformers/deformer_campaign.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace cageproof::validation {
namespace {

// A method for cages next to the origin, so that only moved copies are refused.
constexpr std::string_view only_near = "near_cage_alone";

std::string why_far_is_refused(const Cage& cage) { return cage.name() == only_near ? "" : "not of this cage"; }

template <Scalar R>
std::shared_ptr<const deformation::Deformer<R>> prepare_near(const Cage& cage, const deformation::DeformOptions&) {
  if (cage.vertices()[0].cwiseAbs().maxCoeff() > 1e5) throw InputError("far cages are refused");
  return deformation::prepare_deformer<R>(deformation::deform_method_named("mean_value"), cage, {});
}

TEST(UserCage, names_deformers_that_refuse_a_moved_copy_and_judges_the_rest) {
  // Here, not at program start: other tests ask all methods.
  static const deformation::RegisterDeformMethod near_method{{.name = "only_near",
                                                              .source = "a test's",
                                                              .keeps = "linear maps",
                                                              .kind = "mean_value",
                                                              .refuses = why_far_is_refused,
                                                              .prepare = prepare_near<double>,
                                                              .prepare_in_50_digits = prepare_near<Mp50>}};
  const Cage cube = embedded_cage("cube");
  const auto cage = std::make_shared<const Cage>(Cage::make(std::string(only_near), cube.vertices(), cube.faces()));
  RefusedMethods refused;
  const PartialResult found = measure_all(deformer_measurements(cage, {.methods = "only_near"}, &refused), 1);
  EXPECT_TRUE(refused.empty());
  ASSERT_EQ(found.refused.size(), 1U);
  EXPECT_EQ(found.refused.begin()->first, "far cages are refused");
  EXPECT_EQ(found.refused.begin()->second,
            std::set<std::string>{"near_cage_alone, deformer only_near, keeps_offset, 1e6 sizes off"});
  const auto has = [&](std::string_view check, std::string_view place) {
    return std::ranges::any_of(found.rows, [&](const auto& row) {
      return row.first.check == check && row.first.place == place && row.second.errors.count() > 0;
    });
  };
  EXPECT_TRUE(has("keeps_offset", "1e3 sizes off"));
  EXPECT_FALSE(has("keeps_offset", "1e6 sizes off"));
  EXPECT_TRUE(has("keeps_symmetry_of_quads", "symmetric in x"));
  EXPECT_TRUE(has("deformer_truth", "bent"));
  EXPECT_THROW(measure_all(deformer_measurements(cage, {.methods = "only_near"}), 1), InputError)
      << "without a user's cage nothing may be left out";
}

}  // namespace
}  // namespace cageproof::validation
