// SPDX-License-Identifier: MIT
// Parameters from texts: values, defaults, combinations, and what is refused in whose words.
#include "cageproof/core/catalogue/named_parameters.h"

#include "support.h"

#include <fmt/format.h>

namespace cageproof {
namespace {

using testing_support::input_error_of;

using Values = std::vector<double>;
using Texts = std::vector<std::string>;

std::vector<KindParameter> some() {
  KindParameter nu{{"nu", 0.25, -1, 0.5}}, pieces{{"pieces", 2, 0, 8}}, rule{{"rule", 1, -1, 3}};
  nu.includes_highest = nu.includes_infinity = true;
  pieces.whole = pieces.includes_highest = true;
  rule.names = {"ends", "middles", "both"};
  return {nu, pieces, rule};
}

TEST(NamedParameters, have_the_given_values_and_else_their_defaults) {
  EXPECT_EQ(parameter_values({}, some(), {"x"}), (Values{0.25, 2, 1}));
  EXPECT_EQ(parameter_values({"rule=both", "nu=-0.5"}, some(), {"x"}), (Values{-0.5, 2, 2}));
  EXPECT_EQ(parameter_values({"nu=0.5", "pieces=8"}, some(), {"x"}), (Values{0.5, 8, 1}));
  EXPECT_EQ(parameter_values({"nu=-inf"}, some(), {"x"}).front(), -HUGE_VAL);
  EXPECT_TRUE(parameter_values({}, {}, {"x"}).empty());
}

TEST(NamedParameters, are_texts_of_pairs) {
  EXPECT_EQ(parameter_texts({{"nu", "0.3"}, {"rule", "both"}}), (Texts{"nu=0.3", "rule=both"}));
}

TEST(NamedParameters, of_several_values_are_combined_and_the_last_changes_first) {
  const std::vector<Values> sets = parameter_sets({"rule=both,ends", "nu=0,inf"}, some(), {"x"});
  EXPECT_EQ(sets, (std::vector<Values>{{0, 2, 2}, {0, 2, 0}, {HUGE_VAL, 2, 2}, {HUGE_VAL, 2, 0}}));
  EXPECT_EQ(parameter_sets({}, some(), {"x"}), (std::vector<Values>{{0.25, 2, 1}}));
}

TEST(NamedParameters, are_refused_in_the_words_of_who_asks) {
  const auto refused = [](const Texts& given, std::string_view word) {
    return input_error_of([&] { parameter_values(given, some(), {"elastic", word}); });
  };
  for (const std::string word : {"parameter", "--parameter"}) {
    EXPECT_EQ(refused({"nu=0.7"}, word),
              word + " nu=0.7: 0.7 is out of range for elastic, -1 < nu <= 0.5, or infinite");
    EXPECT_EQ(refused({"pieces=1.5"}, word),
              word + " pieces=1.5: 1.5 is out of range for elastic, 0 < pieces <= 8, a whole number");
    EXPECT_EQ(refused({"nu=x"}, word), word + " nu=x: 'x' is not a number");
    for (const std::string huge : {"1e400", "-1e400", "0x1p+1024"})
      EXPECT_EQ(refused({"nu=" + huge}, word),
                fmt::format("{0} nu={1}: {1} is beyond the range of a double", word, huge));
    EXPECT_EQ(refused({"nu=0,0.1"}, word), word + " nu=0,0.1: '0,0.1' is not a number");
    EXPECT_EQ(refused({"nu="}, word), word + " nu=: '' is not a number");
    EXPECT_EQ(refused({"nu"}, word), word + " nu: write nu=value");
    EXPECT_EQ(refused({"un=0"}, word), word + " un=0: elastic has only nu, pieces, rule; did you mean 'nu'?");
    EXPECT_EQ(refused({"rule=1"}, word), word + " rule=1: '1' is none of ends, middles, both");
    EXPECT_EQ(refused({"rule=bot"}, word),
              word + " rule=bot: 'bot' is none of ends, middles, both; did you mean 'both'?");
    EXPECT_EQ(refused({"nu=0", "nu=0.1"}, word), word + " nu=0.1: nu is given twice");
  }
  EXPECT_EQ(input_error_of([] { parameter_values({"nu=0"}, {}, {"plain"}); }),
            "parameter nu=0: plain has no parameters");
}

TEST(NamedParameters, that_may_be_zero_say_so) {
  const KindParameter weight{{"weight", 1, -std::numeric_limits<double>::denorm_min(), 10}};
  EXPECT_EQ(parameter_values({"weight=0"}, {weight}, {"x"}), Values{0});
  EXPECT_EQ(input_error_of([&] { parameter_values({"weight=-1"}, {weight}, {"x"}); }),
            "parameter weight=-1: -1 is out of range for x, 0 <= weight < 10");
}

TEST(NamedParameters, have_no_more_than_ten_thousand_combinations) {
  std::string hundred = "nu=0", more = "pieces=1";
  for (int i = 1; i < 100; ++i) {
    hundred += ",0";
    more += ",1";
  }
  EXPECT_EQ(parameter_sets({hundred, more}, some(), {"x"}).size(), 10'000U);
  EXPECT_EQ(input_error_of([&] {
              parameter_sets({hundred, more + ",1"}, some(), {"x", "--parameter"});
            }),
            "--parameter: 10100 combinations of values, 10000 are the most");
}

}  // namespace
}  // namespace cageproof
