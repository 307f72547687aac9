// SPDX-License-Identifier: MIT
#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

#include <set>

namespace cageproof {
namespace {

std::vector<std::uint64_t> first_bits(RandomStream stream, int n) {
  std::vector<std::uint64_t> result;
  for (int i = 0; i < n; ++i) result.push_back(stream.bits());
  return result;
}

TEST(random_stream, is_philox) {
  // Random123's known answer of philox4x64-10 for counter 0 and key 0 (the empty name's checksum is 0).
  const std::vector<std::uint64_t> known{0x16554d9eca36314c, 0xdb20fe9d672d0fdc, 0xd7e772cee186176b,
                                         0x7e68b68aec7ba23b};
  EXPECT_EQ(first_bits(RandomStream(0, "", 0), 4), known);
}

TEST(random_stream, is_a_pure_function_of_its_key) {
  const auto expected = first_bits(RandomStream(7, "triangle.near-edge", 41), 100);
  first_bits(RandomStream(8, "other", 1), 17);
  EXPECT_EQ(first_bits(RandomStream(7, "triangle.near-edge", 41), 100), expected);
}

TEST(random_stream, every_part_of_the_key_matters) {
  std::set<std::vector<std::uint64_t>> streams;
  for (const std::uint64_t seed : {0ull, 1ull, 1ull << 63})
    for (const char* name : {"", "a", "b", "ab"})
      for (const std::uint64_t index : {0ull, 1ull, 4ull, 1ull << 40})
        streams.insert(first_bits(RandomStream(seed, name, index), 4));
  EXPECT_EQ(streams.size(), 3u * 4 * 4);
}

TEST(random_stream, blocks_do_not_repeat) {
  const auto bits = first_bits(RandomStream(3, "blocks", 5), 4000);
  EXPECT_EQ(std::set(bits.begin(), bits.end()).size(), bits.size());
}

TEST(random_stream, neighbouring_samples_share_no_block) {
  std::set<std::uint64_t> seen;
  for (std::uint64_t index = 0; index < 50; ++index)
    for (const std::uint64_t bits : first_bits(RandomStream(6, "samples", index), 40)) seen.insert(bits);
  EXPECT_EQ(seen.size(), 50u * 40);
}

TEST(random_stream, uniform_numbers_fill_the_half_open_interval) {
  RandomStream stream(4, "uniform", 0);
  constexpr int n = 100000;
  double sum = 0, low = 1, high = 0;
  for (int i = 0; i < n; ++i) {
    const double x = stream.uniform();
    ASSERT_GE(x, 0);
    ASSERT_LT(x, 1);
    sum += x;
    low = std::min(low, x);
    high = std::max(high, x);
  }
  EXPECT_NEAR(sum / n, 0.5, 0.005);
  EXPECT_LT(low, 1e-3);
  EXPECT_GT(high, 1 - 1e-3);
}

TEST(random_stream, below_reaches_every_number_alike) {
  RandomStream stream(5, "below", 0);
  std::array<int, 7> counts{};
  for (int i = 0; i < 70000; ++i) ++counts.at(stream.below(7));
  for (const int count : counts) EXPECT_NEAR(count, 10000, 500);
}

}  // namespace
}  // namespace cageproof
