// SPDX-License-Identifier: MIT
#include "cageproof/core/catalogue/field_words.h"

#include "cageproof/core/catalogue/unknown_name.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace cageproof {
namespace {

TEST(field_words, are_in_order_once_and_plain) {
  EXPECT_TRUE(std::ranges::is_sorted(field_words(), {}, &FieldWord::word));
  EXPECT_EQ(std::ranges::adjacent_find(field_words(), {}, &FieldWord::word), field_words().end());
  for (const FieldWord& entry : field_words()) {
    EXPECT_EQ(entry.word.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string_view::npos)
        << entry.word;
    EXPECT_EQ(entry.here.empty(), !entry.missing.empty()) << entry.word;
    EXPECT_EQ(find_field_word(entry.word), &entry);
  }
}

TEST(field_words, are_found_in_any_spelling) {
  for (const char* text :
       {"mvc", "MVC", "mean-value", "Mean_Value", "mean value", "mean-value-coordinates", "MVC_weights"}) {
    const FieldWord* entry = find_field_word(text);
    ASSERT_NE(entry, nullptr) << text;
    EXPECT_EQ(entry->here, std::vector<std::string_view>{"mean_value"}) << text;
  }
  ASSERT_NE(find_field_word("triangle.winding"), nullptr);
  for (const char* text : {"", "mvcs", "frobnicate", "-coordinates", "coordinates"})
    EXPECT_EQ(find_field_word(text), nullptr) << text;
}

TEST(field_words, come_before_the_nearest_name) {
  const std::vector<std::string_view> kinds{"mean_value", "green", "mvq"};
  EXPECT_STREQ(unknown_name("kind", "mvc", kinds).what(),
               "unknown kind 'mvc'; it is called 'mean_value' here (known: mean_value, green, mvq)");
  EXPECT_STREQ(unknown_name("kind", "mvx", kinds).what(),
               "unknown kind 'mvx'; did you mean 'mvq'? (known: mean_value, green, mvq)");
  EXPECT_STREQ(unknown_name("kind", "szego", kinds).what(),
               "unknown kind 'szego'; Szego coordinates are not there; cauchy is the kind of the same paper that is "
               "(known: mean_value, green, mvq)");
}

// [T24]'s constructions have one name as deformers and another as coordinates.
TEST(field_words, lead_from_deformers_to_coordinates_and_back) {
  const std::vector<std::string_view> kinds{"biharmonic", "regularised_1_2", "regularised_1_3", "regularised_weber"},
      deformers{"harmonic", "biharmonic_1_2", "biharmonic_1_3", "biharmonic_weber"};
  for (std::size_t i = 1; i < kinds.size(); ++i) {
    EXPECT_EQ(called_here("kind", deformers[i], kinds), fmt::format("; it is called '{}' here", kinds[i]));
    EXPECT_EQ(called_here("deformer", kinds[i], deformers), fmt::format("; it is called '{}' here", deformers[i]));
  }
  EXPECT_EQ(called_here("deformer", "biharmonic", deformers), "; it is called 'biharmonic_1_3' here");
}

TEST(field_words, name_formulas_of_all_elements) {
  EXPECT_EQ(called_here("formula", "winding", {"triangle.solid_angle", "triangle.mean_value", "segment.winding_angle"}),
            "; it is called 'triangle.solid_angle' or 'segment.winding_angle' here");
  // A name that two things have is mentioned once.
  EXPECT_EQ(called_here("name", "mec", {"maximum_entropy", "maximum_entropy"}),
            "; it is called 'maximum_entropy' here");
}

TEST(field_words, of_something_else_say_so) {
  EXPECT_EQ(called_here("deformer", "arb", {"green"}), "; here that is 'certified', and no deformer");
  EXPECT_EQ(called_here("deformer", "frobnicate", {"green"}), "");
}

}  // namespace
}  // namespace cageproof
