// SPDX-License-Identifier: MIT
// Nearest places against the nearest of many places.
#include "cageproof/core/geometry/nearest.h"

#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof {
namespace {

Vec3<double> drawn(RandomStream& random, double reach) {
  const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach), z = random.uniform(-reach, reach);
  return {x, y, z};
}

// The least distance of a grid of places.
double least_of_grid(const std::vector<Vec3<double>>& corners, const Vec3<double>& point, int n) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double u = double(i) / n, v = double(j) / n;
      Vec3<double> place;
      if (corners.size() == 2) place = (1 - u) * corners[0] + u * corners[1];
      else if (corners.size() == 3) place = (1 - u) * corners[0] + u * ((1 - v) * corners[1] + v * corners[2]);
      else place = (1 - v) * ((1 - u) * corners[0] + u * corners[1]) + v * ((1 - u) * corners[3] + u * corners[2]);
      least = std::min(least, (place - point).norm());
    }
  return least;
}

TEST(Nearest, is_as_near_as_any_place) {
  constexpr int n = 120;
  for (const std::size_t count : {2U, 3U, 4U})
    for (int sample = 0; sample < 60; ++sample) {
      RandomStream random(1, "nearest", static_cast<int>(count) * 1000 + sample);
      std::vector<Vec3<double>> corners;
      // Quads are bent a little: where they are far from flat several places may be about as near.
      if (count == 4)
        for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
          corners.emplace_back(Vec3<double>(x, y, 0) + drawn(random, 0.3));
      else
        for (std::size_t k = 0; k < count; ++k) corners.push_back(drawn(random, 1));
      const Vec3<double> point = drawn(random, sample % 2 == 0 ? 1 : 3);
      const NearestPlace found = nearest_place(corners, point);
      double sum = 0;
      Vec3<double> place = Vec3<double>::Zero();
      for (std::size_t k = 0; k < count; ++k) {
        EXPECT_GE(found.basis[k], 0);
        sum += found.basis[k];
        place += found.basis[k] * corners[k];
      }
      EXPECT_NEAR(sum, 1, 1e-15);
      EXPECT_NEAR((place - found.place).norm(), 0, 1e-15);
      const double distance = (found.place - point).norm(), least = least_of_grid(corners, point, n);
      EXPECT_LE(distance, least * (1 + 1e-14)) << count << ' ' << sample;
      EXPECT_GE(distance, least - 4.0 / n) << count << ' ' << sample;
    }
}

TEST(Nearest, is_the_same_in_any_unit) {
  for (const double unit : {0x1p-500, 0x1p500}) {
    const std::vector<std::vector<Vec3<double>>> elements{{{0, 0, 0}, {1, 2, 0}},
                                                          {{0, 0, 0}, {1, 0, 0}, {0.25, 1, 0.5}},
                                                          {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.25}, {0, 1, 0}}};
    for (const auto& element : elements) {
      std::vector<Vec3<double>> scaled;
      scaled.reserve(element.size());
      for (const Vec3<double>& corner : element) scaled.emplace_back(unit * corner);
      const Vec3<double> point(0.4, 0.3, 0.75);
      EXPECT_EQ(nearest_place(scaled, unit * point).place, unit * nearest_place(element, point).place);
    }
  }
}

TEST(Nearest, of_a_unit_square_is_exact_where_it_is_simple) {
  const std::vector<Vec3<double>> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(nearest_place(square, {0.25, 0.5, 2}).place, Vec3<double>(0.25, 0.5, 0));
  EXPECT_EQ(nearest_place(square, {-1, -2, 3}).place, Vec3<double>(0, 0, 0));
  EXPECT_EQ(nearest_place(square, {0.5, 4, 0}).place, Vec3<double>(0.5, 1, 0));
}

}  // namespace
}  // namespace cageproof
