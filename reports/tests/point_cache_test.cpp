// SPDX-License-Identifier: MIT
// Point caches, read back byte by byte.
#include "cageproof/reports/point_cache.h"

#include "cageproof/core/input_error.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

namespace cageproof::reports {
namespace {

std::uint32_t bits_at(const std::string& text, std::size_t at, bool big) {
  std::uint32_t bits = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto byte = static_cast<unsigned char>(text.at(at + (big ? k : 3 - k)));
    bits = bits << 8U | byte;
  }
  return bits;
}

float float_at(const std::string& text, std::size_t at, bool big) {
  return std::bit_cast<float>(bits_at(text, at, big));
}

const std::vector<CacheFrame>& two_frames() {
  static const std::vector<CacheFrame> frames{{"rest.obj", {{0.5, -1, 2}, {3, 0.25, -7}}},
                                              {"bent.obj", {{1.5, 8, -0.125}, {0, 1e10, 1e-10}}}};
  return frames;
}

void expect_frames(const std::string& text, std::size_t at, bool big) {
  for (const CacheFrame& frame : two_frames())
    for (const Vec3<double>& vertex : frame.vertices)
      for (int k = 0; k < 3; ++k, at += 4) EXPECT_EQ(float_at(text, at, big), static_cast<float>(vertex[k])) << at;
  EXPECT_EQ(at, text.size());
}

TEST(PointCache, pc2_is_little_endian_behind_a_header_of_32_bytes) {
  const std::string text = pc2_of(two_frames()).bytes;
  EXPECT_EQ(text.substr(0, 12), std::string("POINTCACHE2\0", 12));
  EXPECT_EQ(text.substr(12, 4), std::string("\1\0\0\0", 4));
  EXPECT_EQ(bits_at(text, 16, false), 2U);
  EXPECT_EQ(float_at(text, 20, false), 1.0F);
  EXPECT_EQ(float_at(text, 24, false), 1.0F);
  EXPECT_EQ(bits_at(text, 28, false), 2U);
  expect_frames(text, 32, false);
}

TEST(PointCache, mdd_is_big_endian_with_a_time_for_each_frame) {
  const std::string text = mdd_of(two_frames(), 25).bytes;
  EXPECT_EQ(text.substr(0, 4), std::string("\0\0\0\2", 4));
  EXPECT_EQ(bits_at(text, 4, true), 2U);
  EXPECT_EQ(float_at(text, 8, true), 0.0F);
  EXPECT_EQ(float_at(text, 12, true), 0.04F);
  expect_frames(text, 16, true);
}

std::string refusal_of(const std::vector<CacheFrame>& frames, bool big) {
  try {
    big ? mdd_of(frames, 25) : pc2_of(frames);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(PointCache, places_beyond_single_precision_are_refused_by_frame_and_vertex) {
  const std::vector<CacheFrame> far{{"rest.obj", {{0, 0, 0}, {1, 0, 0}}}, {"far.obj", {{0, 0, 0}, {0, 1e39, 0}}}};
  for (const bool big : {false, true})
    EXPECT_TRUE(refusal_of(far, big).starts_with("frame 2 (far.obj), vertex 1 (counted from 0): 1e+39 is beyond"))
        << refusal_of(far, big);
}

TEST(PointCache, frames_of_different_lengths_are_refused_by_name) {
  const std::vector<CacheFrame> uneven{{"rest.obj", {{0, 0, 0}, {1, 0, 0}}}, {"less.obj", {{0, 0, 0}}}};
  for (const bool big : {false, true})
    EXPECT_TRUE(refusal_of(uneven, big).starts_with("frame 2 (less.obj) has 1 vertices, and frame 1 (rest.obj) has 2"))
        << refusal_of(uneven, big);
}

TEST(PointCache, rounding_is_told) {
  const std::vector<CacheFrame> exact{{"a.obj", {{0.5, -1, 16777216}}}}, rounded{{"a.obj", {{0.5, -1, 16777217}}}};
  EXPECT_FALSE(pc2_of(exact).rounded);
  EXPECT_TRUE(pc2_of(rounded).rounded);
  EXPECT_FALSE(mdd_of(exact, 24).rounded);
  EXPECT_TRUE(mdd_of(rounded, 24).rounded);
}

}  // namespace
}  // namespace cageproof::reports
