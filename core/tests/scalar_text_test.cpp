// SPDX-License-Identifier: MIT
#include "cageproof/core/numbers/scalar_text.h"

#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace cageproof::scalar_text_test {
namespace {

template <class R>
class scalar_text : public testing::Test {};
using Scalars = testing::Types<float, double, Mp50, Mp100, Mp200>;
TYPED_TEST_SUITE(scalar_text, Scalars);

TYPED_TEST(scalar_text, round_trip_is_exact) {
  using R = TypeParam;
  RandomStream random(1, "round trip", 0);
  for (int i = 0; i < 200; ++i) {
    const R x = R(random.uniform(-1, 1)) / R(random.uniform(0.1, 9)) * R(i % 2 ? 1e-30 : 1e30);
    const std::optional<R> again = parse_scalar<R>(format_scalar(x));
    ASSERT_TRUE(again);
    ASSERT_EQ(*again, x) << format_scalar(x);
  }
}

TYPED_TEST(scalar_text, special_values_have_names) {
  using R = TypeParam;
  const R infinity = std::numeric_limits<R>::infinity();
  EXPECT_EQ(format_scalar(infinity), "inf");
  EXPECT_EQ(format_scalar(R(-infinity)), "-inf");
  EXPECT_EQ(format_scalar(std::numeric_limits<R>::quiet_NaN()), "nan");
  EXPECT_EQ(parse_scalar<R>("inf"), infinity);
  EXPECT_EQ(parse_scalar<R>("-inf"), R(-infinity));
  EXPECT_NE(*parse_scalar<R>("nan"), *parse_scalar<R>("nan"));
}

TYPED_TEST(scalar_text, reads_hexadecimal) {
  using R = TypeParam;
  EXPECT_EQ(parse_scalar<R>("0x1.8p-3"), R(0.1875));
  EXPECT_EQ(parse_scalar<R>("-0x1p+4"), R(-16));
}

TYPED_TEST(scalar_text, reads_decimals_rounded_to_its_own_precision) {
  using R = TypeParam;
  const R tenth = R(1) / 10;
  EXPECT_EQ(parse_scalar<R>("0.1"), tenth);
  EXPECT_EQ(parse_scalar<R>("+1e-1"), tenth);
  EXPECT_EQ(parse_scalar<R>("00.10"), tenth);
}

TYPED_TEST(scalar_text, rejects_everything_else) {
  for (const char* text :
       {"",       " ",   "1 ",       " 1",  "1,", "abc", "0x", "0xg",   "1e",  "1e+",  "--1", "1.2.3",
        "nan(1)", "NaN", "infinity", "1d5", "e5", ".",   "-",  "0b101", "0B1", "-0b1", "1p3", "1f"})
    EXPECT_FALSE(parse_scalar<TypeParam>(text)) << '"' << text << '"';
  EXPECT_FALSE(parse_scalar<TypeParam>(std::string_view("1\0", 2)));
}

TEST(format_scalar, is_the_shortest_decimal) {
  EXPECT_EQ(format_scalar(0.1), "0.1");
  EXPECT_EQ(format_scalar(0.1f), "0.1");
  EXPECT_EQ(format_scalar(5e-324), "5e-324");
}

TEST(format_hex, is_exact) {
  EXPECT_EQ(format_hex(0.1875), "0x1.8p-3");
  RandomStream random(2, "hex", 0);
  for (int i = 0; i < 2000; ++i) {
    const double x = std::bit_cast<double>(random.bits());
    if (!std::isfinite(x)) continue;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*parse_scalar<double>(format_hex(x))), std::bit_cast<std::uint64_t>(x));
  }
  EXPECT_EQ(format_hex(-0.0), "-0x0p+0");
  EXPECT_EQ(format_hex(std::numeric_limits<double>::infinity()), "inf");
}

}  // namespace
}  // namespace cageproof::scalar_text_test
