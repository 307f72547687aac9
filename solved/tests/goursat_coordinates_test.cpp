// SPDX-License-Identifier: MIT
// Properties of the true biharmonic and harmonic coordinates of polygons.
#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/geometry/winding_number.h"
#include "goursat_polygons.h"

#include <gtest/gtest.h>

namespace cageproof::solved::goursat {
namespace {

using Vec = Vec3<double>;

CageCoordinates coordinates_of(const Cage& cage, const char* kind) {
  return {cage, coordinate_kind_named(kind), CoordinateOptions{}};
}

std::vector<Vec> points_in(const Cage& cage, double least, int side) {
  std::vector<Segment<double>> segments;
  for (const Face& f : cage.faces())
    segments.push_back({cage.vertices()[f.vertices[0]], cage.vertices()[f.vertices[1]]});
  return points_within(cage, least, side, [&](const Vec& p) { return winding_number(segments, p) == 1; });
}

}  // namespace

// The boundary is met to the digits that are asked of convex cages and of the L.
TEST(goursat_coordinates, residuals_are_those_promised) {
  for (const char* kind : {"biharmonic_goursat", "harmonic_goursat"}) {
    for (const Cage& cage : convex_polygons()) {
      const SolvedSystem s = coordinates_of(cage, kind).solved().front();
      // A rectangle's 1.3e-10 are the most: of values, beside which slopes are ten times as large.
      EXPECT_LE(s.boundary_values, 2e-10) << cage.name() << ' ' << kind;
      EXPECT_FALSE(s.boundary_gradients > 1e-9) << cage.name() << ' ' << kind << ' ' << s.boundary_gradients;
      EXPECT_LE(s.residual, 1e-9);
      EXPECT_GT(s.rank, 10);
      EXPECT_LT(s.rank, s.columns);  // rotations, at least, are in the basis twice
      EXPECT_GT(s.condition, 1);
    }
    const SolvedSystem l = coordinates_of(l_shape(), kind).solved().front();
    EXPECT_LE(l.boundary_values, 1e-10) << kind;
    EXPECT_FALSE(l.boundary_gradients > 1e-9) << kind;
    const SolvedSystem star = coordinates_of(five_pointed_star(), kind).solved().front();
    EXPECT_LE(star.boundary_values, 1e-9) << kind;
    EXPECT_FALSE(star.boundary_gradients > 1e-7) << kind;
  }
}

// [W12] Eq 5 and 6, with their derivatives.
TEST(goursat_coordinates, reproduce_linear_functions) {
  for (const char* kind : {"biharmonic_goursat", "harmonic_goursat"})
    for (const Cage& cage : {unit_square(), triangle(), pentagon(), rectangle(), l_shape(), five_pointed_star()}) {
      const CageCoordinates coordinates = coordinates_of(cage, kind);
      const auto& normals = coordinates.elements().normals();
      for (const Vec& p : points_in(cage, 0.02, 9)) {
        const auto found = coordinates.at<double>(p, 2);
        for (int o = 0; o <= 2; ++o) {
          const int entries = 1 << o;
          for (int e = 0; e < entries; ++e) {
            double ones = 0;
            Vec positions = Vec::Zero();
            for (std::size_t i = 0; i < cage.vertices().size(); ++i) {
              ones += found[0].of(o)[i * entries + e];
              positions += found[0].of(o)[i * entries + e] * cage.vertices()[i];
            }
            for (std::size_t i = 0; found.size() > 1 && i < cage.faces().size(); ++i)
              positions += found[1].of(o)[i * entries + e] * normals[i];
            Vec expected = Vec::Zero();
            if (o == 0) expected = p;
            if (o == 1) expected[e] = 1;
            const double bound = o == 0 ? 1e-10 : o == 1 ? 1e-9 : 1e-7;
            EXPECT_NEAR(ones, o == 0 ? 1 : 0, bound) << cage.name() << ' ' << kind << ' ' << p.transpose();
            EXPECT_LE((positions - expected).norm(), bound * cage.size()) << cage.name() << ' ' << kind;
          }
        }
      }
    }
}

// On a rectangle harmonic coordinates are bilinear.
TEST(goursat_coordinates, harmonic_ones_of_a_rectangle_are_bilinear) {
  const CageCoordinates coordinates = coordinates_of(rectangle(), "harmonic_goursat");
  for (const Vec& p : {Vec(5, 0.5, 0), Vec(1, 0.25, 0), Vec(9.875, 0.0625, 0)}) {
    const auto found = coordinates.at<double>(p, 2).front();
    const double x = p[0] / 10, y = p[1];
    const std::array expected{(1 - x) * (1 - y), x * (1 - y), x * y, (1 - x) * y};
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(found.value[k], expected[k], 1e-12);
    EXPECT_NEAR(found.gradient[2 * 2], y / 10, 1e-12);
    EXPECT_NEAR(found.hessian[4 * 2 + 1], 0.1, 1e-11);
    EXPECT_NEAR(found.hessian[4 * 2], 0, 1e-11);
  }
}

// [W12] Eq 7: hat functions without normal derivatives, and normal derivatives of one on an edge.
TEST(goursat_coordinates, meet_their_data_on_edges) {
  for (const Cage& cage : {unit_square(), triangle(), l_shape()}) {
    const CageCoordinates coordinates = coordinates_of(cage, "biharmonic_goursat");
    const int n = static_cast<int>(cage.faces().size());
    for (int f = 0; f < n; ++f) {
      const Vec a = cage.vertices()[f], b = cage.vertices()[(f + 1) % n], normal = coordinates.elements().normals()[f];
      for (const double t : {0.03125, 0.25, 0.5, 0.875}) {
        const Vec on = (1 - t) * a + t * b, near = on - 1e-7 * normal;
        const auto found = coordinates.at<double>(near, 1);
        for (int i = 0; i < n; ++i) {
          const double hat = i == f ? 1 - t : i == (f + 1) % n ? t : 0;
          EXPECT_NEAR(found[0].value[i], hat, 1e-9) << cage.name() << ' ' << f << ' ' << i;
          EXPECT_NEAR(found[1].value[i], i == f ? -1e-7 : 0, 1e-9);
          const auto slope = [&](const Result<double>& r) {
            return r.gradient[2 * i] * normal[0] + r.gradient[2 * i + 1] * normal[1];
          };
          EXPECT_NEAR(slope(found[0]), 0, 1e-4) << cage.name() << ' ' << f << ' ' << i;
          EXPECT_NEAR(slope(found[1]), i == f ? 1 : 0, 1e-4) << cage.name() << ' ' << f << ' ' << i;
        }
      }
    }
  }
}

// On the cage the data are exact; at its corners nothing else is known.
TEST(goursat_coordinates, are_the_data_on_the_cage) {
  const CageCoordinates coordinates = coordinates_of(unit_square(), "biharmonic_goursat");
  const auto middle = coordinates.at<double>(Vec(0.25, 0, 0), 2);
  EXPECT_EQ(middle[0].value, (std::vector<double>{0.75, 0.25, 0, 0}));
  EXPECT_EQ(middle[1].value, (std::vector<double>{0, 0, 0, 0}));
  EXPECT_NEAR(middle[0].gradient[0], -1, 1e-11);
  EXPECT_NEAR(middle[1].gradient[1], -1, 1e-11);
  EXPECT_TRUE(std::isfinite(middle[0].hessian[0]));
  const auto inside = coordinates.at<double>(Vec(0.25, 1e-9, 0), 2);
  for (std::size_t i = 0; i < middle[0].hessian.size(); ++i)
    EXPECT_NEAR(middle[0].hessian[i], inside[0].hessian[i], 1e-6);
  const auto corner = coordinates.at<double>(Vec(1, 0, 0), 1);
  EXPECT_EQ(corner[0].value, (std::vector<double>{0, 1, 0, 0}));
  EXPECT_EQ(corner[1].value, (std::vector<double>{0, 0, 0, 0}));
  EXPECT_TRUE(std::isnan(corner[0].gradient[0]));
  const auto outside = coordinates.at<double>(Vec(0.5, -1e-12, 0), 1);
  for (const auto& block : outside)
    for (int o = 0; o < 2; ++o)
      for (const double x : block.of(o)) EXPECT_TRUE(std::isnan(x));
}

// The maximum principle, and a vanishing Laplacian.
TEST(goursat_coordinates, harmonic_ones_are_positive_and_harmonic) {
  for (const Cage& cage : {pentagon(), l_shape(), five_pointed_star()}) {
    const CageCoordinates coordinates = coordinates_of(cage, "harmonic_goursat");
    for (const Vec& p : points_in(cage, 0.01, 12)) {
      const auto found = coordinates.at<double>(p, 2).front();
      for (std::size_t i = 0; i < found.value.size(); ++i) {
        EXPECT_GT(found.value[i], 0) << cage.name() << ' ' << p.transpose();
        EXPECT_LT(found.value[i], 1);
        const double trace = found.hessian[4 * i] + found.hessian[4 * i + 3];
        EXPECT_NEAR(trace, 0, 1e-9 * (1 + std::abs(found.hessian[4 * i])));
      }
    }
  }
}

// Derivatives by differences, in 50 digits; and the Laplacian's Laplacian, by differences of the Laplacian.
TEST(goursat_coordinates, derivatives_are_derivatives_and_biharmonic) {
  for (const char* kind : {"biharmonic_goursat", "harmonic_goursat"})
    for (const Cage& cage : {unit_square(), l_shape()}) {
      const CageCoordinates coordinates = coordinates_of(cage, kind);
      const Vec3<Mp50> p = convert<Mp50>(Vec(0.25, 0.375, 0));
      const Mp50 step("1e-12");
      const auto here = coordinates.at<Mp50>(p, 2);
      std::vector<std::vector<Mp50>> laplacians(here.size());
      for (int a = 0; a < 2; ++a) {
        Vec3<Mp50> plus = p, minus = p;
        plus[a] += step;
        minus[a] -= step;
        const auto up = coordinates.at<Mp50>(plus, 2), down = coordinates.at<Mp50>(minus, 2);
        for (std::size_t b = 0; b < here.size(); ++b) {
          laplacians[b].resize(here[b].value.size());
          for (int o = 1; o <= 2; ++o)
            for (std::size_t i = 0; i < up[b].of(o - 1).size(); ++i) {
              const Mp50 difference = (up[b].of(o - 1)[i] - down[b].of(o - 1)[i]) / (2 * step);
              EXPECT_LE(std::abs(static_cast<double>(Mp50(difference - here[b].of(o)[2 * i + a]))), 1e-18)
                  << kind << ' ' << cage.name() << " order " << o;
            }
          for (std::size_t i = 0; i < here[b].value.size(); ++i) {
            const auto trace = [&](const Result<Mp50>& r) { return Mp50(r.hessian[4 * i] + r.hessian[4 * i + 3]); };
            laplacians[b][i] += (trace(up[b]) - 2 * trace(here[b]) + trace(down[b])) / (step * step);
          }
        }
      }
      for (const auto& block : laplacians)
        for (const Mp50& x : block) EXPECT_LE(std::abs(static_cast<double>(x)), 1e-9) << kind << ' ' << cage.name();
    }
}

// Units of length, places far from the origin, turns, and orders of vertices and segments are nobody's business.
TEST(goursat_coordinates, do_not_depend_on_unit_or_place) {
  const Cage cage = l_shape();
  const Vec point(0.75, 0.5, 0);
  const double c = std::cos(0.7), s = std::sin(0.7);
  const auto turned = [&](const Vec& p) { return Vec(c * p[0] - s * p[1], s * p[0] + c * p[1], 0); };
  struct Change {
    const char* name;
    std::function<Vec(const Vec&)> move;
    double unit, tolerance;
  };
  for (const char* kind : {"biharmonic_goursat", "harmonic_goursat"}) {
    const auto expected = coordinates_of(cage, kind).at<double>(point, 1);
    for (const Change& change : {Change{"small", [](const Vec& p) { return Vec(1e-6 * p); }, 1e-6, 1e-10},
                                 Change{"large", [](const Vec& p) { return Vec(1e6 * p); }, 1e6, 1e-10},
                                 Change{"power of two", [](const Vec& p) { return Vec(0x1p-600 * p); }, 0x1p-600, 0},
                                 Change{"huge", [](const Vec& p) { return Vec(0x1p1000 * p); }, 0x1p1000, 0},
                                 // An ulp of the offset is 1e-10.
                                 Change{"far", [](const Vec& p) { return Vec(p + Vec(1e6, -1e6, 0)); }, 1, 1e-9},
                                 Change{"turned", turned, 1, 1e-10}}) {
      std::vector<Vec> vertices;
      for (const Vec& v : cage.vertices()) vertices.push_back(change.move(v));
      const auto found = coordinates_of(cage.with(vertices, cage.faces()), kind).at<double>(change.move(point), 1);
      for (std::size_t i = 0; i < expected[0].value.size(); ++i) {
        EXPECT_NEAR(found[0].value[i], expected[0].value[i], change.tolerance) << kind << ' ' << change.name;
        if (found.size() > 1) {
          EXPECT_NEAR(found[1].value[i] / change.unit, expected[1].value[i], change.tolerance) << change.name;
        }
        if (std::string_view(change.name) != "turned") {
          EXPECT_NEAR(found[0].gradient[2 * i] * change.unit, expected[0].gradient[2 * i], 100 * change.tolerance);
        }
      }
    }
  }
}

TEST(goursat_coordinates, follow_the_cages_order) {
  const std::vector<Vec> vertices{{1, 1, 0}, {0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {2, 0, 0}, {1, 2, 0}};
  const std::vector<Face> faces{{{2, 0, -1, -1}}, {{1, 4, -1, -1}}, {{0, 5, -1, -1}},
                                {{3, 1, -1, -1}}, {{4, 2, -1, -1}}, {{5, 3, -1, -1}}};
  const Cage mixed = Cage::make_polygon("mixed", vertices, faces), cage = l_shape();
  const std::array vertex{3, 0, 2, 5, 1, 4}, face{2, 0, 3, 5, 1, 4};
  const Vec point(0.375, 1.25, 0);
  const auto expected = coordinates_of(cage, "biharmonic_goursat").at<double>(point, 1);
  const auto found = coordinates_of(mixed, "biharmonic_goursat").at<double>(point, 1);
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(found[0].value[i], expected[0].value[vertex[i]], 1e-10);
    EXPECT_NEAR(found[1].value[i], expected[1].value[face[i]], 1e-10);
    EXPECT_NEAR(found[1].gradient[2 * i + 1], expected[1].gradient[2 * face[i] + 1], 1e-8);
  }
}

// A flat corner: the hat function of a vertex within an edge, whose sum with its neighbours' is the undivided one.
TEST(goursat_coordinates, of_divided_edges_add_up) {
  const Cage divided = polygon("divided", {{0, 0}, {0.5, 0}, {1, 0}, {1, 1}, {0, 1}});
  for (const char* kind : {"biharmonic_goursat", "harmonic_goursat"}) {
    const CageCoordinates fine = coordinates_of(divided, kind), coarse = coordinates_of(unit_square(), kind);
    EXPECT_LE(fine.solved().front().boundary_values, 1e-9) << kind;
    for (const Vec& p : points_in(divided, 0.05, 8)) {
      const auto a = fine.at<double>(p, 0), b = coarse.at<double>(p, 0);
      EXPECT_NEAR(a[0].value[0] + a[0].value[1] / 2, b[0].value[0], 1e-9) << kind;
      if (a.size() > 1) {
        EXPECT_NEAR(a[1].value[0] + a[1].value[1], b[1].value[0], 1e-9);
      }
    }
  }
}

// The ranges that the audit of [W12] found for the square at some points, at least 0.05 sizes from the boundary: ours,
// more of them, must hold them, and have the same extreme of beta, which no edge of the range cuts off.
TEST(goursat_coordinates, have_the_ranges_of_the_audit) {
  const Cage cage = unit_square();
  const CageCoordinates coordinates = coordinates_of(cage, "biharmonic_goursat");
  std::vector<double> alpha, beta;
  for (const Vec& p : points_in(cage, 0.05, 80)) {
    const auto found = coordinates.at<double>(p, 0);
    alpha.insert(alpha.end(), found[0].value.begin(), found[0].value.end());
    beta.insert(beta.end(), found[1].value.begin(), found[1].value.end());
  }
  EXPECT_GE(std::ranges::min(alpha), 0);
  EXPECT_LE(std::ranges::min(alpha), 0.001);
  EXPECT_GE(std::ranges::max(alpha), 0.814);
  EXPECT_LE(std::ranges::max(alpha), 0.9);
  EXPECT_NEAR(std::ranges::min(beta), -0.1, 5e-4);
  EXPECT_LE(std::ranges::max(beta), 0);
  EXPECT_GE(std::ranges::max(beta), -0.0005);
}

TEST(goursat_coordinates, refuse_many_edges_by_name) {
  std::vector<std::array<double, 2>> points;
  points.reserve(49);
  for (int k = 0; k < 49; ++k)
    points.push_back({std::cos(2 * std::numbers::pi * k / 49), std::sin(2 * std::numbers::pi * k / 49)});
  const Cage cage = polygon("circle", points);
  try {
    coordinates_of(cage, "harmonic_goursat");
    ADD_FAILURE() << "49 edges were taken";
  } catch (const InputError& e) {
    for (const char* part : {"circle", "harmonic_goursat", "49 edges"})
      EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
  }
  points.pop_back();
  EXPECT_TRUE(accepts(coordinate_kind_named("harmonic_goursat"), polygon("48 edges", points)));
}

// Along an edge of length 1e-6, slopes are a million times as large as values. They must not hide errors of values,
// which are some tenths here: the same cage, turned, has other coordinates.
TEST(goursat_coordinates, state_what_values_miss_beside_a_short_edge) {
  const Cage cage = polygon("short edge", {{0, 0}, {1, 0}, {1, 1e-6}, {1.25, 1}, {0, 1}});
  EXPECT_GT(coordinates_of(cage, "biharmonic_goursat").solved().front().boundary_values, 0.05);
}

// Twenty-four corners next to flat, and slender cages: fewer functions per corner, higher polynomials.
TEST(goursat_coordinates, of_round_and_slender_cages) {
  std::vector<std::array<double, 2>> points;
  points.reserve(24);
  for (int k = 0; k < 24; ++k)
    points.push_back({std::cos(std::numbers::pi * k / 12), std::sin(std::numbers::pi * k / 12)});
  const SolvedSystem round = coordinates_of(polygon("round", points), "biharmonic_goursat").solved().front();
  EXPECT_LE(round.boundary_values, 1e-8);
  const Cage bar = polygon("bar", {{-1, 0}, {1, 0}, {1, 0x1p-6}, {-1, 0x1p-6}});
  const CageCoordinates coordinates = coordinates_of(bar, "biharmonic_goursat");
  EXPECT_LE(coordinates.solved().front().boundary_values, 2e-6);
  // Far from both ends a cubic across the bar, straight along it.
  const double h = 0x1p-6, y = 0.25;
  const auto found = coordinates.at<double>(Vec(0.25, y * h, 0), 0);
  const double top = y * y * (3 - 2 * y);
  EXPECT_NEAR(found[0].value[0], (1 - top) * 0.375, 1e-6);
  EXPECT_NEAR(found[0].value[2], top * 0.625, 1e-6);
  EXPECT_NEAR(found[1].value[0], -h * y * (1 - y) * (1 - y), 1e-6 * h + 1e-8);
}

TEST(goursat_coordinates, refuse_holes_by_name) {
  const std::vector<Vec> vertices{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0},
                                  {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}};
  std::vector<Face> faces;
  faces.reserve(8);
  for (int k = 0; k < 4; ++k) faces.push_back({{k, (k + 1) % 4, -1, -1}});
  for (int k = 0; k < 4; ++k) faces.push_back({{4 + k, 4 + (k + 1) % 4, -1, -1}});
  const Cage cage = Cage::make_polygon("frame", vertices, faces);
  for (const char* kind : {"biharmonic_goursat", "harmonic_goursat"}) {
    EXPECT_FALSE(accepts(coordinate_kind_named(kind), cage));
    try {
      coordinates_of(cage, kind);
      ADD_FAILURE() << "a hole was taken";
    } catch (const InputError& e) {
      const std::string what = e.what();
      for (const char* part : {"frame", kind, "holes"}) EXPECT_NE(what.find(part), std::string::npos) << what;
    }
  }
}

}  // namespace cageproof::solved::goursat
