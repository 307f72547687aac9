// SPDX-License-Identifier: MIT
// Many points under maps: as one by one, whatever the blocks, and what becomes of those without images.
#include "support.h"

#include "cageproof/deformation/point_images.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace cageproof::deformation {
namespace {

using test::Vec;

// More than two blocks of points, within +-1.2 times the reach of a cage.
std::vector<Vec> many_points(const test::Case& c) {
  std::vector<Vec> points;
  for (int i = 0; i < 300; ++i) {
    const double t = i / 300.0;
    const Vec way(std::cos(7 * t), std::sin(11 * t), c.cage.dimension() == 2 ? 0 : std::cos(5 * t + 1));
    points.emplace_back(c.points[0] + 0.6 * t * c.size * way);
  }
  return points;
}

TEST(PointImages, are_those_of_single_points_of_each_map) {
  for (const test::Case& c : {test::cube(), test::l_shape()}) {
    const int d = c.cage.dimension();
    const auto deformer = test::prepared(c.cage, d == 2 ? "cauchy" : "mean_value");
    const auto posed = deformer->pose({c.posed, {}}), rest = deformer->pose({c.cage.vertices(), {}});
    const std::vector<Vec> points = many_points(c);
    const int order = 1;
    const std::array maps{posed.get(), rest.get()};
    const PointImages found = images_of(deformer->coordinates(), points, maps, {order, 2}, std::nullopt);
    ASSERT_EQ(found.maps.size(), 2U);
    for (std::size_t k = 0; k < maps.size(); ++k)
      for (std::size_t p = 0; p < points.size(); ++p) {
        const Images<double> one = deformer->images(*maps[k], std::span(points).subspan(p, 1), order);
        for (int o = 0; o <= order; ++o) {
          const std::size_t width = one.tensors[o].size();
          for (std::size_t i = 0; i < width; ++i)
            EXPECT_NEAR(found.maps[k].tensors[o][p * width + i], one.tensors[o][i], 1e-11 * c.size)
                << c.name << ' ' << k << ' ' << p;
        }
      }
    const std::vector<Vec> vertices = vertices_of(found.maps[0], d);
    ASSERT_EQ(vertices.size(), points.size());
    EXPECT_EQ(vertices[217], test::image(found.maps[0], 217, d));
  }
}

TEST(PointImages, outside_the_cage_points_are_missing_where_coordinates_vanish) {
  const test::Case c = test::cube();
  const std::vector<Vec> points{{.1, .2, .3}, {3, 0, 0}, {.5, .5, .5}};
  for (const std::string method : {"green", "mean_value"}) {
    const auto deformer = test::prepared(c.cage, method);
    const auto posed = deformer->pose({c.posed, {}});
    const auto region = region_of(deformer->coordinates());
    EXPECT_EQ(region.has_value(), method == "green");
    const std::array maps{posed.get()};
    const PointImages found = images_of(deformer->coordinates(), points, maps, {}, region);
    EXPECT_EQ(found.missing, (std::vector<char>{0, method == "green", 0})) << method;
  }
}

TEST(PointImages, without_coordinates_points_are_missing) {
  // Only inside there are such ones.
  const test::Case c = test::cube();
  const auto deformer = test::prepared(c.cage, "maximum_entropy");
  const auto posed = deformer->pose({c.posed, {}});
  const std::vector<Vec> points{{.1, .2, .3}, {3, 0, 0}};
  const std::array maps{posed.get()};
  EXPECT_EQ(images_of(deformer->coordinates(), points, maps, {}, std::nullopt).missing, (std::vector<char>{0, 1}));
}

TEST(BoundPoints, have_the_images_that_points_have) {
  for (const test::Case& c : {test::cube(), test::l_shape()}) {
    const int d = c.cage.dimension();
    for (const std::string method : {d == 2 ? "cauchy" : "mean_value", "green", "somigliana"}) {
      const auto deformer = test::prepared(c.cage, method);
      const auto posed = deformer->pose({c.posed, {}}), rest = deformer->pose({c.cage.vertices(), {}});
      const std::array maps{posed.get(), rest.get()};
      const std::vector<Vec> points = many_points(c);
      const auto region = region_of(deformer->coordinates());
      for (const int kept : {0, 1})
        for (int order = 0; order <= kept; ++order) {
          const BoundPoints bound(deformer->coordinates(), points, {kept, 2}, region);
          EXPECT_EQ(bound.size(), points.size());
          EXPECT_EQ(bound.order(), kept);
          const PointImages found = bound.images(maps, order, 2),
                            asked = images_of(deformer->coordinates(), points, maps, {order, 1}, region);
          EXPECT_EQ(found.missing, asked.missing) << c.name << ' ' << method;
          const double allowed = order == kept ? 0 : 1e-14 * c.size;
          for (std::size_t k = 0; k < maps.size(); ++k)
            for (int o = 0; o <= order; ++o)
              for (std::size_t i = 0; i < asked.maps[k].tensors[o].size(); ++i) {
                // Points without images may have numbers of any size.
                if (allowed > 0 && asked.missing[i * points.size() / asked.maps[k].tensors[o].size()]) continue;
                const double x = found.maps[k].tensors[o][i], y = asked.maps[k].tensors[o][i];
                ASSERT_TRUE(x == y || std::abs(x - y) <= allowed || (std::isnan(x) && std::isnan(y)))
                    << c.name << ' ' << method << ' ' << order << ' ' << o << ' ' << i << ": " << x << ' ' << y;
              }
        }
    }
  }
}

TEST(BoundPoints, outside_are_continued_where_they_are_asked_to_be) {
  const test::Case c = test::cube();
  const auto deformer = test::prepared(c.cage, "green");
  const auto posed = deformer->pose({c.posed, {}});
  const std::array maps{posed.get()};
  const std::vector<Vec> points{{.1, .2, .3}, {.75, 0, 0}};
  ImageRun run;
  run.extend = true;
  const auto region = region_of(deformer->coordinates());
  const PointImages found = BoundPoints(deformer->coordinates(), points, run, region).images(maps, 0, 1),
                    asked = images_of(deformer->coordinates(), points, maps, run, region);
  EXPECT_EQ(found.beyond, asked.beyond);
  EXPECT_GT(found.beyond[1], 0.2);
  EXPECT_EQ(found.maps[0].tensors[0], asked.maps[0].tensors[0]);
}

// A point's values hang on its own coordinates, not on the points that come with it.
TEST(PointImages, are_the_same_in_any_blocks) {
  const test::Case c = test::cube();
  const std::vector<Vec> points = many_points(c);
  for (const std::string method : {"green", "somigliana"}) {
    const auto deformer = test::prepared(c.cage, method);
    const auto posed = deformer->pose({c.posed, {}});
    const auto tables = deformer->coordinates().at<double>(std::span(points), 0);
    const Images<double> together = posed->images(tables, points.size(), 0);
    for (std::size_t p = 0; p < points.size(); p += 7) {
      std::vector<CoordinateTable<double>> one(tables.size());
      for (std::size_t b = 0; b < tables.size(); ++b) {
        one[b].stride = tables[b].stride;
        const auto from = tables[b].tensors[0].begin() + static_cast<std::ptrdiff_t>(p * tables[b].stride[0]);
        one[b].tensors[0].assign(from, from + static_cast<std::ptrdiff_t>(tables[b].stride[0]));
      }
      const Images<double> alone = posed->images(one, 1, 0);
      for (int i = 0; i < 3; ++i) EXPECT_EQ(alone.tensors[0][i], together.tensors[0][3 * p + i]) << method << ' ' << p;
    }
  }
}

// Three points of the plane under two maps; the second point is missing.
PointImages three_points() {
  Images<double> images{{{{1, 2, 3, 4, 5, 6}, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}, {}}}};
  return {{images, images}, {0, 1, 0}};
}
const std::vector<Vec> at_rest{{.1, .2, 0}, {.3, .4, 0}, {.5, .6, 0}};

TEST(PointImages, what_is_not_finite_is_named_by_its_first_point_and_last_map) {
  PointImages images = three_points();
  images.maps[0].tensors[0][2] = NAN;  // of the missing point
  images.maps[1].tensors[1][0] = NAN;  // a derivative
  EXPECT_FALSE(first_not_finite(images));
  images.maps[0].tensors[0][5] = HUGE_VAL;
  ASSERT_TRUE(first_not_finite(images));
  EXPECT_EQ(first_not_finite(images)->point, 2U);
  EXPECT_EQ(first_not_finite(images)->map, 0U);
  images.maps[1].tensors[0][4] = NAN;
  EXPECT_EQ(first_not_finite(images)->map, 1U);
  images.maps[0].tensors[0][0] = NAN;
  EXPECT_EQ(first_not_finite(images)->point, 0U);
  EXPECT_EQ(first_not_finite(images)->map, 0U);
}

TEST(PointImages, missing_points_rest_or_are_nan_and_others_stay) {
  PointImages rest = three_points(), nan = three_points();
  fill_missing(rest, at_rest, 2, Missing::Rest);
  fill_missing(nan, at_rest, 2, Missing::Nan);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(rest.maps[k].tensors[0], (std::vector<double>{1, 2, .3, .4, 5, 6}));
    EXPECT_EQ(rest.maps[k].tensors[1], (std::vector<double>{1, 2, 3, 4, 1, 0, 0, 1, 9, 10, 11, 12}));
    for (int o = 0; o <= 1; ++o) {
      const std::vector<double>&tensor = nan.maps[k].tensors[o], before = three_points().maps[k].tensors[o];
      const std::size_t width = tensor.size() / 3;
      for (std::size_t i = 0; i < tensor.size(); ++i)
        if (i / width == 1) EXPECT_TRUE(std::isnan(tensor[i]));
        else EXPECT_EQ(tensor[i], before[i]);
    }
  }
}

}  // namespace
}  // namespace cageproof::deformation
