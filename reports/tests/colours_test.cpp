// SPDX-License-Identifier: MIT
#include "colours.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cageproof::reports {
namespace {

ImageField::Array array_of(std::vector<double> values) { return {"error", "", 1, std::move(values)}; }

TEST(colours, are_of_the_magnitudes_logarithm_on_a_logarithmic_scale_alone) {
  const ImageField::Array array = array_of({1e-4, -1e-2, std::nan("")});
  const Colours logarithmic = colours_of(array, ColourScale::Log10, {});
  EXPECT_DOUBLE_EQ(logarithmic.values[0], -4);
  EXPECT_DOUBLE_EQ(logarithmic.values[1], -2);
  EXPECT_TRUE(std::isnan(logarithmic.values[2]));
  EXPECT_EQ(logarithmic.low, -4);
  EXPECT_EQ(logarithmic.high, -2);
  EXPECT_EQ(logarithmic.largest, 1e-4);
  const Colours linear = colours_of(array, ColourScale::Linear, {});
  EXPECT_EQ(linear.values[0], 1e-4);
  EXPECT_LE(linear.low, 1e-4);
  EXPECT_GE(linear.high, 1e-4);
}

}  // namespace
}  // namespace cageproof::reports
