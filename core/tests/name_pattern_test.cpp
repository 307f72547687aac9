// SPDX-License-Identifier: MIT
#include "cageproof/core/catalogue/name_pattern.h"

#include "cageproof/core/catalogue/unknown_name.h"

#include <gtest/gtest.h>

namespace cageproof {
namespace {

using Names = std::vector<std::string>;

std::string message_of(const auto& call) {
  try {
    call();
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(name_pattern, matches_names_globs_and_lists) {
  EXPECT_TRUE(matches("far", "far"));
  EXPECT_TRUE(matches("near-*,far", "far"));
  EXPECT_TRUE(matches("near-* , far", "far"));
  EXPECT_TRUE(matches("near-*,far", "near-face"));
  EXPECT_TRUE(matches("gauss-?", "gauss-8"));
  EXPECT_TRUE(matches("gauss-[48]", "gauss-8"));
  EXPECT_FALSE(matches("gauss-?", "gauss-16"));
  EXPECT_FALSE(matches("near-*,far", "generic"));
  EXPECT_FALSE(matches("", "generic"));
  EXPECT_FALSE(matches("far", "far,near-face"));
  EXPECT_FALSE(matches("FAR", "far"));
}

TEST(name_pattern, lists_have_no_empty_names) {
  EXPECT_EQ(names_in(" near-*, far"), (Names{"near-*", "far"}));
  for (const char* bad : {"", ",", "far,", ",far", "far,,generic", "far, ,generic"})
    EXPECT_NE(message_of([&] { names_in(bad); }).find("is no list of names"), std::string::npos) << bad;
}

TEST(name_pattern, every_name_of_a_list_must_be_known) {
  const std::vector<std::string_view> known{"near-face", "near-edge", "far"};
  EXPECT_EQ(message_of([&] { require_known("regime", "near-*,far", known); }), "");
  EXPECT_EQ(message_of([&] { require_known("regime", "near-*,fra", known); }),
            "unknown regime 'fra'; did you mean 'far'? (known: near-face, near-edge, far)");
  EXPECT_EQ(message_of([&] { require_known("regime", "on-*", known); }),
            "no regime matches 'on-*'; known: near-face, near-edge, far");
}

TEST(unknown_name, says_what_may_have_been_meant) {
  const std::vector<std::string_view> known{"triangle.solid_angle", "triangle.single_layer", "segment.winding_angle"};
  EXPECT_EQ(nearest_name("triangle.solid_angel", known), "triangle.solid_angle");
  EXPECT_EQ(nearest_name("Triangle.Solid-Angle", known), "triangle.solid_angle");
  EXPECT_EQ(nearest_name("winding_angle", known), "segment.winding_angle");
  EXPECT_EQ(nearest_name("triangle.sngle_layer", known), "triangle.single_layer");
  EXPECT_EQ(nearest_name("frobnicate", known), "");
  EXPECT_EQ(nearest_name("", known), "");
  EXPECT_EQ(nearest_name("x", {"a", "far"}), "");
  EXPECT_EQ(nearest_name("x", {}), "");
  // The first of two equally near names wins. Swapping neighbours counts as one letter, like a change or an insertion.
  EXPECT_EQ(nearest_name("gren", {"green", "grin"}), "green");
  EXPECT_EQ(nearest_name("abdc", {"abcd"}), "abcd");
  EXPECT_EQ(nearest_name("abxd", {"abcd"}), "abcd");
  EXPECT_EQ(nearest_name("abd", {"abcd"}), "abcd");
  EXPECT_EQ(nearest_name("abcxd", {"abcd"}), "abcd");
  EXPECT_EQ(nearest_name("near-edge", {"near-edgy", "NEAR_EDGE"}), "NEAR_EDGE");
  // A third of the letters may be off and no more; one always may.
  EXPECT_EQ(nearest_name("abcdef", {"xycdef"}), "xycdef");
  EXPECT_EQ(nearest_name("abcdef", {"xyzdef"}), "");
  EXPECT_EQ(nearest_name("ab", {"axb"}), "axb");
  EXPECT_EQ(nearest_name("abcde", {"xycde"}), "");
}

}  // namespace
}  // namespace cageproof
