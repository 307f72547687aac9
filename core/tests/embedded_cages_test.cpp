// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/embedded_cages.h"

#include "cageproof/core/geometry/element.h"
#include "support.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <set>

namespace cageproof {
namespace {

using testing_support::expect_parts;
using testing_support::input_error_of;
using testing_support::volume;

std::vector<Cage> surfaces() {
  std::vector<Cage> found;
  for (const auto name : embedded_cage_names())
    if (Cage cage = embedded_cage(name); cage.dimension() == 3) found.push_back(std::move(cage));
  return found;
}

int quads_of(const Cage& cage) {
  return static_cast<int>(std::ranges::count(cage.faces(), 4, [](const Face& face) { return face.size(); }));
}

// Distance of a quad's last corner from the plane of the others.
double bulge(const Cage& cage, const Face& face) {
  const auto corner = [&](int k) { return cage.vertices()[face.vertices[k]]; };
  const Vec3<double> normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
  return face.size() == 3 ? 0 : std::abs(normal.dot(corner(3) - corner(0)));
}

TEST(embedded_cages, have_the_stated_names_and_order) {
  const std::vector<std::string_view> names{"cube",     "icosphere", "torus",  "l-block", "twisted-bar",
                                            "thin-box", "spiky-box", "square", "l-shape", "star",
                                            "comb",     "thin-bar",  "frame",  "figure"};
  EXPECT_EQ(embedded_cage_names(), names);
  for (const auto name : names) EXPECT_EQ(embedded_cage(name).name(), name);
}

TEST(embedded_cages, are_small_and_of_order_one) {
  for (const auto name : embedded_cage_names()) {
    const Cage cage = embedded_cage(name);
    EXPECT_LE(cage.parts(false, Triangulation::Shortest).elements.size(), 100u) << name;
    EXPECT_GT(cage.size(), 1) << name;
    EXPECT_LT(cage.size(), 5) << name;
  }
}

struct Expected {
  std::string_view name;
  int vertices, quads, triangles;
  double volume;
};

TEST(embedded_cages, have_the_counts_and_volume_of_their_shape) {
  const double cavity = (2 - 1.0 / 32) * (2 - 1.0 / 32) * (1 - 1.0 / 64);
  for (const Expected& e : {Expected{"cube", 8, 6, 0, 1}, Expected{"l-block", 12, 8, 4, 3},
                            Expected{"thin-box", 16, 14, 0, 4 - cavity}, Expected{"spiky-box", 38, 24, 24, 1.375}}) {
    const Cage cage = embedded_cage(e.name);
    EXPECT_EQ(cage.vertices().size(), e.vertices) << e.name;
    EXPECT_EQ(quads_of(cage), e.quads) << e.name;
    EXPECT_EQ(cage.faces().size(), e.quads + e.triangles) << e.name;
    EXPECT_NEAR(volume(cage), e.volume, 1e-14) << e.name;
  }
}

TEST(embedded_cages, have_the_genus_of_their_shape) {
  for (const Cage& cage : surfaces()) {
    std::set<std::pair<int, int>> edges;
    for (const Face& face : cage.faces())
      for (int k = 0; k < face.size(); ++k)
        edges.insert(std::minmax(face.vertices[k], face.vertices[(k + 1) % face.size()]));
    const auto characteristic =
        static_cast<int>(cage.vertices().size() + cage.faces().size()) - static_cast<int>(edges.size());
    EXPECT_EQ(characteristic, cage.name() == "torus" ? 0 : 2) << cage.name();
  }
}

TEST(embedded_cages, only_the_twisted_bar_has_curved_quads) {
  for (const Cage& cage : surfaces()) {
    int curved = 0;
    for (const Face& face : cage.faces()) curved += bulge(cage, face) > 1e-14;
    EXPECT_EQ(curved, cage.name() == "twisted-bar" ? 16 : 0) << cage.name();
  }
}

TEST(embedded_cages, icosphere_lies_on_the_unit_sphere) {
  const Cage cage = embedded_cage("icosphere");
  EXPECT_EQ(cage.vertices().size(), 42u);
  EXPECT_EQ(cage.faces().size(), 80u);
  EXPECT_FALSE(cage.has_quads());
  for (const auto& v : cage.vertices()) EXPECT_NEAR(v.norm(), 1, 1e-15);
  EXPECT_GT(volume(cage), 0.85 * 4 * std::numbers::pi / 3);
}

TEST(embedded_cages, torus_encloses_less_than_the_round_one) {
  const double round = 2 * std::numbers::pi * std::numbers::pi * 0.16;
  EXPECT_LT(volume(embedded_cage("torus")), round);
  EXPECT_GT(volume(embedded_cage("torus")), 0.7 * round);
}

TEST(embedded_cages, square_is_the_unit_square_counter_clockwise) {
  const Cage cage = embedded_cage("square");
  EXPECT_EQ(cage.dimension(), 2);
  ASSERT_EQ(cage.faces().size(), 4u);
  double twice_area = 0;
  for (const Face& face : cage.faces()) {
    EXPECT_EQ(face.kind(), ElementKind::Segment);
    const Vec3<double>&a = cage.vertices()[face.vertices[0]], &b = cage.vertices()[face.vertices[1]];
    EXPECT_DOUBLE_EQ((b - a).norm(), 1);
    EXPECT_EQ(a[2], 0);
    twice_area += a[0] * b[1] - a[1] * b[0];
  }
  EXPECT_DOUBLE_EQ(twice_area, 2);
}

TEST(extreme_cages, have_the_volume_of_their_shape) {
  for (const int decade : {3, 6, 12}) {
    const double h = std::pow(10.0, -decade);
    const auto volume_of = [&](const char* family) {
      return volume(embedded_cage(fmt::format("{}-1e-{}", family, decade)));
    };
    const double wall = 4 - (2 - 2 * h) * (2 - 2 * h) * (1 - h), cavity = 1 - std::pow(1 - 2 * h, 3);
    EXPECT_NEAR(volume_of("thin-wall"), wall, 4e-15);
    EXPECT_NEAR(volume_of("hollow"), cavity, 4e-15);
    EXPECT_NEAR(volume_of("gap"), 2, 4e-15);
    if (decade % 2 != 0) continue;
    EXPECT_NEAR(volume_of("wedge"), h / 2, 1e-16);
    EXPECT_NEAR(volume_of("crack"), 1 - h / 2, 4e-15);
  }
  for (const int decade : {2, 5, 8}) {
    const double w = std::pow(10.0, -decade);
    const auto volume_of = [&](const char* family) {
      return volume(embedded_cage(fmt::format("{}-1e-{}", family, decade)));
    };
    EXPECT_NEAR(volume_of("bevel"), (1 - w * w * w) / 6, 1e-15);
    EXPECT_NEAR(volume_of("bump"), 1 + w * w * w / 3, 4e-15);
    EXPECT_NEAR(volume_of("pinch"), (1 + w + w * w) / 3, 1e-15);
    EXPECT_NEAR(volume_of("needles"), (2 + 2 * w + 1.5 * w * w) / 3, 4e-15);
  }
  EXPECT_NEAR(volume(embedded_cage("graded")), 8.0 / 3, 4e-15);
  EXPECT_NEAR(volume(embedded_cage("nested")), 1 - std::pow(0.75, 3) + 2.5361507 / 64 + 1.0 / 512, 1e-8);
  EXPECT_NEAR(volume(embedded_cage("fan")), 1.25 / 3 * 32 * std::sin(2 * std::numbers::pi / 64), 1e-14);
}

TEST(extreme_cages, go_to_zero_by_decades) {
  const auto names = extreme_cage_names();
  EXPECT_EQ(names.front(), "thin-wall-1e-1");
  EXPECT_EQ(names[11], "thin-wall-1e-12");
  for (const auto name : names) {
    const Cage cage = embedded_cage(name);
    EXPECT_EQ(cage.name(), name);
    EXPECT_FALSE(crossing_warning(cage)) << name;
    EXPECT_TRUE(invalid_quads(cage).empty()) << name;
    EXPECT_TRUE(is_embedded_cage(name));
  }
  EXPECT_TRUE(is_embedded_cage("cube"));
  EXPECT_FALSE(is_embedded_cage("thin-wall"));
  EXPECT_FALSE(is_embedded_cage("thin-wall-1e-13"));
}

TEST(embedded_cages, unknown_name_lists_those_there_are) {
  expect_parts(input_error_of([] { embedded_cage("sphere"); }), {"\"sphere\"", "cube", "spiky-box"});
}

}  // namespace
}  // namespace cageproof
