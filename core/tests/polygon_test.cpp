// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/cage.h"

#include "cageproof/core/geometry/element.h"
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/numbers/random_stream.h"
#include "cageproof/core/geometry/winding_number.h"
#include "support.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace cageproof::polygon_test {
namespace {

using testing_support::expect_parts;
using testing_support::input_error_of;

using Loop = std::vector<Vec3<double>>;

std::vector<Face> segments_of(const std::vector<Loop>& loops) {
  std::vector<Face> segments;
  int first = 0;
  for (const Loop& loop : loops) {
    const int count = static_cast<int>(loop.size());
    for (int k = 0; k < count; ++k) segments.push_back({{first + k, first + (k + 1) % count, -1, -1}});
    first += count;
  }
  return segments;
}

Loop joined(const std::vector<Loop>& loops) {
  Loop all;
  for (const Loop& loop : loops) all.insert(all.end(), loop.begin(), loop.end());
  return all;
}

Cage polygon(const std::vector<Loop>& loops, CageOptions options = {}) {
  return Cage::make_polygon("p", joined(loops), segments_of(loops), std::move(options));
}

std::string error_of(const std::vector<Loop>& loops) {
  return input_error_of([&] { polygon(loops); });
}

std::string error_of(const Loop& vertices, const std::vector<std::array<int, 2>>& segments) {
  std::vector<Face> faces;
  faces.reserve(segments.size());
  for (const auto& [from, to] : segments) faces.push_back({{from, to, -1, -1}});
  return input_error_of([&] { Cage::make_polygon("p", vertices, faces, {.face_lines = {11, 12, 13, 14, 15, 16}}); });
}

Loop rectangle(double left, double bottom, double right, double top) {
  return {{left, bottom, 0}, {right, bottom, 0}, {right, top, 0}, {left, top, 0}};
}

Loop reversed(Loop loop) { return {loop.rbegin(), loop.rend()}; }

std::vector<Segment<double>> sides_of(const Cage& cage) {
  std::vector<Segment<double>> sides;
  for (const Face& face : cage.faces())
    sides.push_back({cage.vertices()[face.vertices[0]], cage.vertices()[face.vertices[1]]});
  return sides;
}

double area_of(const Cage& cage) {
  double twice = 0;
  for (const auto& [a, b] : sides_of(cage)) twice += a[0] * b[1] - a[1] * b[0];
  return twice / 2;
}

TEST(polygon_rejects, edges_that_cross) {
  expect_parts(error_of({{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}}),
               {"p: segments 0 and 2 cross each other", "counted from 0"});
  expect_parts(error_of({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 1, 0}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}),
               {"segments 0 and 2 (lines 11 and 13) cross each other"});
  expect_parts(error_of({rectangle(0, 0, 2, 2), rectangle(1, 1, 3, 3)}), {"segments 1 and 4 cross each other"});
  // The first pair is named, whichever comes first in the file.
  expect_parts(error_of({{{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {3, -1, 0}, {2, 1, 0}, {1, -1, 0}, {0, 1, 0}}}),
               {"segments 0 and 2 cross"});
}

TEST(polygon_rejects, edges_that_touch) {
  expect_parts(error_of({{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 0, 0}, {0, 2, 0}}}),
               {"segments 0 and 2 touch each other, at vertex 3"});
  // A hole may touch its shell in points: at a side, at a corner.
  EXPECT_NO_THROW(polygon({rectangle(0, 0, 4, 4), {{2, 1, 0}, {0, 2, 0}, {2, 3, 0}}}));
  EXPECT_NO_THROW(polygon({rectangle(0, 0, 4, 4), {{0, 0, 0}, {1, 2, 0}, {2, 1, 0}}}));
  // Two squares that share a side, or part of it.
  expect_parts(error_of({rectangle(0, 0, 1, 1), rectangle(1, 0, 2, 1)}), {"segments 1 and 7 lie on each other"});
  expect_parts(error_of({rectangle(0, 0, 1, 1), rectangle(1, 0.25, 2, 0.75)}), {"segments 1 and 7 lie on each other"});
  expect_parts(error_of({rectangle(0, 0, 1, 1), {{1, 2, 0}, {1, -1, 0}, {2, 0, 0}}}),
               {"segments 1 and 4 lie on each other"});
}

TEST(polygon_rejects, edges_that_lie_on_each_other) {
  expect_parts(error_of({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {4, 2, 0}, {0, 2, 0}}}),
               {"segments 1 and 2 lie on each other", "a spike at vertex 2"});
  expect_parts(error_of({{{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {3, 3, 0}, {3, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}),
               {"segments 0 and 3 touch each other, at vertex 4"});
  // Parallel to no axis: exact, though no slope is.
  const double third = 1.0 / 3;
  expect_parts(error_of({{0, 0, 0}, {2, 2 * third, 0}, {1, third, 0}}, {{0, 1}, {1, 2}, {2, 0}}),
               {"(lines 11 and 12) lie on each other: a spike at vertex 1"});
  expect_parts(error_of({{0, 0, 0}, {1, 0, 0}}, {{0, 1}, {1, 0}}), {"segments 0 and 1 (lines 11 and 12) lie on"});
  expect_parts(error_of({{{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {0, 1, 0}}, {{1, 0, 0}, {3, 0, 0}, {2, -1, 0}}}),
               {"segments 0 and 4 lie on each other"});
}

TEST(polygon_rejects, vertices_twice_and_edges_of_no_length) {
  expect_parts(error_of({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}),
               {"segment 1 (line 12): degenerate: vertices 1 and 2 coincide"});
  expect_parts(error_of({{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}}}),
               {"vertex 5: repeated, it lies where vertex 2 does"});
  expect_parts(error_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, 0}}}), {"segment 3: degenerate"});
}

TEST(polygon_rejects, what_is_not_closed) {
  expect_parts(error_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1}, {1, 2}}),
               {"vertex 0: the polyline is open: segment 0 (line 11) begins there"});
  expect_parts(error_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0.5, 0}}, {{0, 1}, {1, 2}, {2, 0}, {2, 3}}),
               {"vertex 2: 3 segments meet there"});
  expect_parts(error_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1}, {2, 1}, {2, 0}}),
               {"vertex 1: segments 0 and 1 (lines 11 and 12) both end there", "--flip-inward"});
  expect_parts(error_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 0}}, {{0, 1}, {1, 2}, {2, 0}}),
               {"vertex 3: no segment uses it"});
  expect_parts(error_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1}, {1, 2}, {2, 3}}), {"segment 2", "index 3"});
  expect_parts(error_of({{0, 0, 0}}, {}), {"no segments"});
}

TEST(polygon_rejects, points_of_space) {
  expect_parts(error_of({{{0, 0, 0}, {1, 0, 0.25}, {0, 1, 0}}}), {"vertex 1: 3D points for a polygon", "0.25"});
  expect_parts(error_of({{{0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0}}}), {"vertex 2", "not finite"});
  expect_parts(input_error_of([] {
                 Cage::make_polygon("p", rectangle(0, 0, 1, 1), {{{0, 1, 2, -1}}});
               }),
               {"segment 0: a polygon's elements are segments"});
}

TEST(polygon_rejects, loops_that_run_the_wrong_way) {
  expect_parts(error_of({reversed(rectangle(0, 0, 1, 1))}), {"clockwise", "--flip-inward"});
  expect_parts(error_of({rectangle(0, 0, 4, 4), rectangle(1, 1, 2, 2)}),
               {"4 segments from segment 4 on", "within 1 other part", "bounds a hole", "clockwise"});
  expect_parts(error_of({rectangle(0, 0, 1, 1), reversed(rectangle(2, 0, 3, 1))}), {"bounds no hole", "clockwise"});
}

TEST(polygon_turns, loops_and_single_segments_when_told) {
  const Cage clockwise = polygon({reversed(rectangle(0, 0, 2, 1))}, {.flip_inward = true});
  EXPECT_DOUBLE_EQ(area_of(clockwise), 2);
  EXPECT_DOUBLE_EQ(area_of(polygon({rectangle(0, 0, 4, 4), rectangle(1, 1, 2, 2)}, {.flip_inward = true})), 15);
  // Edges in no order and no direction, as some modellers write them.
  const Loop square = rectangle(0, 0, 1, 1);
  for (int mask = 0; mask < 16; ++mask) {
    std::vector<Face> segments{{{2, 3, -1, -1}}, {{0, 1, -1, -1}}, {{3, 0, -1, -1}}, {{1, 2, -1, -1}}};
    for (int k = 0; k < 4; ++k)
      if (mask >> k & 1) std::swap(segments[k].vertices[0], segments[k].vertices[1]);
    const Cage cage = Cage::make_polygon("p", square, segments, {.flip_inward = true});
    EXPECT_DOUBLE_EQ(area_of(cage), 1) << mask;
    for (int k = 0; k < 4; ++k)
      EXPECT_EQ(std::minmax(cage.faces()[k].vertices[0], cage.faces()[k].vertices[1]),
                std::minmax(segments[k].vertices[0], segments[k].vertices[1]));
    if (mask == 0) {
      EXPECT_NO_THROW(Cage::make_polygon("p", square, segments));
    } else {
      EXPECT_THROW(Cage::make_polygon("p", square, segments), InputError) << mask;
    }
  }
}

// One ulp decides, at every size of numbers.
TEST(polygon_checks, are_exact) {
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  for (const double unit : {1.0, 1e-150, 1e150, 1e-300, 1e300}) {
    const auto notched = [&](double depth) {
      return Loop{
          {0, 0, 0}, {3 * unit, 1 * unit, 0}, {3 * unit, 3 * unit, 0}, {1.5 * unit, depth, 0}, {0, 3 * unit, 0}};
    };
    const double on = 0.5 * unit;
    EXPECT_NO_THROW(polygon({notched(std::nextafter(on, HUGE_VAL))})) << unit;
    expect_parts(error_of({notched(on)}), {"segments 0 and 2 touch each other, at vertex 3"});
    expect_parts(error_of({notched(std::nextafter(on, 0.0))}), {"segments 0 and 2 cross each other"});
  }
  EXPECT_NO_THROW(polygon({rectangle(0, 0, tiny, tiny)}));
  EXPECT_NO_THROW(polygon({rectangle(0, 0, 1, tiny)}));
  EXPECT_NO_THROW(polygon({{{0, 0, 0}, {1, 1, 0}, {1, std::nextafter(1, 2), 0}}}));
  EXPECT_NO_THROW(polygon({rectangle(-1e308, -1e308, 1e308, 1e308)}));
  EXPECT_THROW(polygon({reversed(rectangle(0, 0, 1, tiny))}), InputError);
  // Between walls a subnormal apart lies nothing.
  expect_parts(error_of({rectangle(0, 0, 1, tiny), {{0.25, 0, 0}, {0.25, tiny, 0}, {0.5, 0, 0}}}),
               {"segments 0 and 6 lie on each other"});
}

// Against all pairs, by rational arithmetic that shares nothing with the predicates: small integers, where everything
// touches.
TEST(polygon_checks, agree_with_integers) {
  int simple = 0;
  for (int sample = 0; sample < 4000; ++sample) {
    RandomStream random(3, "polygons", sample);
    const int count = 3 + sample % 4;
    std::vector<std::array<long, 2>> p;
    Loop loop;
    for (int k = 0; k < count; ++k) {
      p.push_back({static_cast<long>(random.uniform(0, 5)), static_cast<long>(random.uniform(0, 5))});
      loop.emplace_back(p.back()[0], p.back()[1], 0);
    }
    const auto turn = [](const auto& a, const auto& b, const auto& c) {
      const long t = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
      return t > 0 ? 1 : t < 0 ? -1 : 0;
    };
    const auto holds = [&](const auto& a, const auto& b, const auto& c) {
      return turn(a, b, c) == 0 && std::min(a[0], b[0]) <= c[0] && c[0] <= std::max(a[0], b[0]) &&
             std::min(a[1], b[1]) <= c[1] && c[1] <= std::max(a[1], b[1]);
    };
    bool good = true;
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < count; ++j) {
        const auto &a = p[i], &b = p[(i + 1) % count], &c = p[j], &d = p[(j + 1) % count];
        if (i != j && a == c) good = false;
        // No vertex on a side but its own two.
        if (j != i && j != (i + 1) % count && holds(a, b, c)) good = false;
        if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) good = false;
      }
    bool found = true;
    try {
      polygon({loop}, {.flip_inward = true});
    } catch (const InputError&) {
      found = false;
    }
    ASSERT_EQ(found, good) << "sample " << sample;
    simple += good;
  }
  EXPECT_GT(simple, 500);
}

TEST(polygon_checks, take_little_time) {
  constexpr int count = 2000;
  Loop saw;
  for (int k = 0; k < count / 2; ++k) saw.emplace_back(k, k % 2, 0);
  for (int k = count / 2; k-- > 0;) saw.emplace_back(k, 2 + k % 2, 0);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_NO_THROW(polygon({saw}));
  // All pairs of a fan of chords cross.
  std::vector<Loop> chords;
  constexpr int parts = count / 4;
  for (int k = 0; k < parts; ++k) {
    const double angle = std::numbers::pi * (k + 0.25) / parts, c = std::cos(angle), s = std::sin(angle);
    chords.push_back({{c, s, 0}, {-c, -s, 0}, {-c - 1e-6 * s, -s + 1e-6 * c, 0}, {c - 1e-6 * s, s + 1e-6 * c, 0}});
  }
  expect_parts(error_of(chords), {"cross each other"});
  // Squares in squares, each a part.
  std::vector<Loop> nested;
  for (int k = 0; k < parts; ++k) {
    const Loop square = rectangle(k, k, 2 * count - k, 2 * count - k);
    nested.push_back(k % 2 == 0 ? square : reversed(square));
  }
  EXPECT_NO_THROW(polygon(nested));
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  EXPECT_LT(spent.count(), 10) << "it takes a fraction of a second, more under sanitizers on a busy machine";
}

TEST(embedded_polygons, enclose_what_they_should) {
  const double star = 5 * 0.375 * std::sin(std::numbers::pi / 5);
  for (const auto& [name, edges, area] : {std::tuple{"square", 4u, 1.0},
                                          {"l-shape", 6u, 3.0},
                                          {"star", 10u, star},
                                          {"comb", 20u, 1.125 * 0.25 + 5 * 0.125},
                                          {"thin-bar", 4u, 2.0 / 64},
                                          {"frame", 8u, 3.0}}) {
    const Cage cage = embedded_cage(name);
    EXPECT_EQ(cage.dimension(), 2);
    EXPECT_EQ(cage.faces().size(), edges) << name;
    // The star's corners are rounded to 2^-10.
    EXPECT_NEAR(area_of(cage), area, std::string_view(name) == "star" ? 2e-3 : 1e-15) << name;
  }
  const Cage figure = embedded_cage("figure");
  EXPECT_EQ(figure.faces().size(), 100u);
  EXPECT_NEAR(area_of(figure), 1, 0.5);
}

// The winding number against the sum of the angles that the edges are seen under.
TEST(embedded_polygons, wind_once_around_what_is_inside) {
  for (const auto name : embedded_cage_names()) {
    const Cage cage = embedded_cage(name);
    if (cage.dimension() != 2) continue;
    const auto sides = sides_of(cage);
    int seen = 0;
    for (int i = 0; i < 300; ++i) {
      RandomStream random(1, name, i);
      const Vec3<double> at(random.uniform(-1, 2), random.uniform(-1, 2), 0);
      double angle = 0;
      for (const auto& [a, b] : sides) {
        const Vec3<double> p = a - at, q = b - at;
        angle += std::atan2(p[0] * q[1] - p[1] * q[0], p[0] * q[0] + p[1] * q[1]);
      }
      const auto found = winding_number(sides, at);
      ASSERT_TRUE(found) << name;
      EXPECT_NEAR(*found, angle / (2 * std::numbers::pi), 1e-12) << name;
      seen |= 1 << *found;
    }
    EXPECT_EQ(seen, name == "thin-bar" ? seen : 3) << name;
  }
  EXPECT_EQ(winding_number(sides_of(embedded_cage("frame")), Vec3<double>(0, 0, 0)), 0);
  EXPECT_EQ(winding_number(sides_of(embedded_cage("thin-bar")), Vec3<double>(0, 1.0 / 128, 0)), 1);
}

TEST(polygon, with_looks_for_no_contacts) {
  const Cage square = embedded_cage("square");
  EXPECT_NO_THROW(square.with(rectangle(0, 0, 5, 5), square.faces()));
  EXPECT_THROW(square.with(reversed(rectangle(0, 0, 5, 5)), square.faces()), InputError);
}

}  // namespace
}  // namespace cageproof::polygon_test
