// SPDX-License-Identifier: MIT
#include "figure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cageproof::reports {
namespace {

TEST(Figure, ErrorsHaveTwoDigits) {
  EXPECT_EQ(short_error(0), "0");
  EXPECT_EQ(short_error(3.2), "3.2");
  EXPECT_EQ(short_error(1), "1");
  EXPECT_EQ(short_error(0.1), "0.1");
  EXPECT_EQ(short_error(0.25), "0.25");
  EXPECT_EQ(short_error(64), "64");
  EXPECT_EQ(short_error(120), "120");
  EXPECT_EQ(short_error(1.4e5), "1.4e5");
  EXPECT_EQ(short_error(1e-12), "1e-12");
  EXPECT_EQ(short_error(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(short_error(std::nan("")), "nan");
  EXPECT_EQ(short_error(std::numeric_limits<double>::max()), "1.8e308");
  EXPECT_EQ(short_error(5e-324), "5e-324");
}

TEST(Figure, ErrorsAreRoundedUp) {
  EXPECT_EQ(short_error(64.01), "65");
  EXPECT_EQ(short_error(3.21), "3.3");
  EXPECT_EQ(short_error(9.91), "10");
  EXPECT_EQ(short_error(99.5), "100");
  EXPECT_EQ(short_error(996), "1e3");
  EXPECT_EQ(short_error(1.01e-12), "1.1e-12");
}

TEST(Figure, PlainNumbers) {
  EXPECT_EQ(short_number(64), "64");
  EXPECT_EQ(short_number(1e-12), "1e-12");
  EXPECT_EQ(short_number(-16.32), "-16.32");
  EXPECT_EQ(short_number(9.99999e-5), "1e-4");
  EXPECT_EQ(short_number(-9.99999e7), "-1e8");
  EXPECT_EQ(short_number(0), "0");
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(12345678), "12,345,678");
}

TEST(Figure, FileNames) {
  EXPECT_EQ(file_name("triangle.single_layer"), "triangle.single_layer");
  EXPECT_EQ(file_name("../data/a b.obj"), "_..-data-a-b.obj");
  EXPECT_EQ(file_name(""), "_");
}

}  // namespace
}  // namespace cageproof::reports
