// SPDX-License-Identifier: MIT
// A number that counts must be the double that it stands for, know what that double should have been, and say where it
// came to differ.
#include "cageproof/closed_form/arithmetic/counted_tape.h"
#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <source_location>

namespace cageproof::closed_form::counted_test {
namespace {

TEST(counted, a_cancellation_is_found_at_its_line) {
  const CountedTape tape;
  const Counted small = Counted(1) / Counted(3) * 0x1p-39;
  const Counted sum = 1 + small;
  const unsigned line = std::source_location::current().line() + 1;
  const Counted left = sum - 1;
  EXPECT_EQ(left.value, (1 + 1. / 3 * 0x1p-39) - 1);
  const auto lines = tape.lines(left);
  const auto found = std::ranges::find(lines, line, &CountedLine::line);
  ASSERT_NE(found, lines.end());
  EXPECT_EQ(found->operation, "-");
  EXPECT_EQ(found->bits, 41);
  EXPECT_TRUE(found->file.ends_with("closed_form/tests/counted_test.cpp"));
  EXPECT_LE(found->before, 1);
  EXPECT_GT(found->after, 0x1p38);
  EXPECT_EQ(found->count, 1U);
  // The rounding was the sum's, a line above; the difference itself is exact.
  EXPECT_EQ(found->rounded, 0);
  const double error = static_cast<double>(Mp200(left.value) - left.shadow);
  const auto at_sum = std::ranges::find(lines, line - 2, &CountedLine::line);
  ASSERT_NE(at_sum, lines.end());
  EXPECT_NEAR(at_sum->net, error, 1e-3 * std::abs(error));
  EXPECT_NEAR(found->lost, std::abs(error), 1e-3 * std::abs(error));
}

TEST(counted, what_is_exact_loses_nothing) {
  const CountedTape tape;
  const Counted left = (Counted(1) + 0x1p-40) - 1;
  EXPECT_EQ(left.value, 0x1p-40);
  EXPECT_TRUE(left.shadow == Mp200(0x1p-40));
  EXPECT_TRUE(tape.lines(left).empty());
  EXPECT_EQ(tape.size(), 2U);
}

TEST(counted, a_root_knows_its_rounding) {
  const CountedTape tape;
  const Counted root = sqrt(Counted(2));
  EXPECT_EQ(root.value, std::sqrt(2.));
  EXPECT_TRUE(abs(root.shadow * root.shadow - 2) < Mp200(1e-195));
  const auto lines = tape.lines(root);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].operation, "sqrt");
  EXPECT_NEAR(lines[0].net, static_cast<double>(Mp200(std::sqrt(2.)) - sqrt(Mp200(2))), 1e-20);
  EXPECT_LE(lines[0].after, 1);
}

// The branch that exact numbers would not take.
TEST(counted, comparisons_are_those_of_doubles) {
  const Counted nothing = (1 + Counted(0x1p-60)) - 1;
  EXPECT_TRUE(nothing.shadow == Mp200(0x1p-60));
  EXPECT_FALSE(nothing > 0);
  EXPECT_TRUE(nothing <= 0);
  EXPECT_TRUE(nothing == 0);
  const Counted tenth(0.1), three = tenth + tenth + tenth;
  EXPECT_TRUE(three > Counted(0.3));
  EXPECT_TRUE(abs(-three) == three);
}

// One expression after another, bit for bit, and the sum of all lines is the error.
template <class T>
std::array<T, 7> expressions(const T& a, const T& b, const T& c) {
  using std::abs, std::atan2, std::atanh, std::log, std::log1p, std::sqrt;
  const T s = sqrt(a * a + b * b + c * c);
  T folded = a;
  folded *= s;
  folded -= b / 3;
  folded /= c;
  folded += 2 * a;
  return {s - a,
          (s - abs(b)) / (s + a + 3),
          log(s / (s + c * c)) + log1p(c * c / s),
          atan2(b * (s - a), a + c),
          atanh(a / (s + 1)) - a / (s + 1),
          (a + b) * (a - b) - a * a + b * b,
          folded};
}

TEST(counted, values_are_those_of_doubles_and_lines_add_up_to_the_error) {
  for (int i = 0; i < 500; ++i) {
    RandomStream random(41, "counted", i);
    const double x = random.uniform(0.1, 1), y = random.uniform(-1, 1) * std::exp2(-random.below(12)),
                 z = random.uniform(0.01, 1);
    const auto plain = expressions<double>(x, y, z);
    const auto exact = expressions<Mp200>(x, y, z);
    const CountedTape tape;
    const auto counted = expressions<Counted>(x, y, z);
    for (std::size_t k = 0; k < plain.size(); ++k) {
      EXPECT_EQ(counted[k].value, plain[k]) << "expression " << k << ", sample " << i;
      EXPECT_TRUE(abs(counted[k].shadow - exact[k]) <= Mp200(1e-190)) << "expression " << k << ", sample " << i;
      double sum = 0, sizes = 0;
      for (const CountedLine& line : tape.lines(counted[k])) {
        sum += line.net;
        sizes += line.rounded;
      }
      const double error = static_cast<double>(Mp200(counted[k].value) - counted[k].shadow);
      EXPECT_NEAR(sum, error, 1e-9 * sizes) << "expression " << k << ", sample " << i;
    }
  }
}

TEST(counted, polynomials_count_for_the_line_that_asks) {
  const CountedTape tape;
  Taylor<Counted, 1> f, g;
  g.c[0] = Counted(1) / 3;
  const unsigned line = std::source_location::current().line() + 1;
  f.add(Counted(1) / 7, g);
  bool found = false;
  for (const CountedLine& l : tape.lines(f.c[0])) found = found || (l.line == line && l.operation == "* in add");
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace cageproof::closed_form::counted_test
