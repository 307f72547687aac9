// SPDX-License-Identifier: MIT
// An element's own geometry against its definition: corners are small integers, basis functions sixteenths, so that
// points are exact.
#include "cageproof/core/geometry/element.h"

#include <gtest/gtest.h>

#include <vector>

namespace cageproof {
namespace {

using Point = Vec3<double>;
using Basis = std::array<double, 4>;

Point at(const std::vector<Point>& corners, const Basis& basis) {
  Point point = Point::Zero();
  for (std::size_t k = 0; k < corners.size(); ++k) point += basis[k] * corners[k];
  return point;
}

Basis bilinear(double u, double v) { return {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v}; }

void expect_contact(ElementKind kind, const std::vector<Point>& corners, const Basis& basis, Contact contact) {
  const ContactPoint found = type_of(kind).contact(corners, at(corners, basis));
  EXPECT_EQ(found.contact, contact) << at(corners, basis).transpose();
  for (int k = 0; k < 4; ++k) EXPECT_EQ(found.basis[k], basis[k]) << at(corners, basis).transpose() << ", corner " << k;
}

// Along either axis, upright across the first axis, far from the origin, and slanted either way.
const std::vector<std::vector<Point>> segments{{Point(-1, 2, 0), Point(3, 2, 0)},
                                               {Point(3, -1, 0), Point(3, 1, 0)},
                                               {Point(-5, 7, 0), Point(-5, -9, 0)},
                                               {Point(2, 3, 0), Point(4, 11, 0)},
                                               {Point(8, -3, 0), Point(-8, 1, 0)}};
const std::vector<std::vector<Point>> triangles{{Point(0, 0, 0), Point(4, 0, 0), Point(0, 4, 0)},
                                                {Point(1, 2, 3), Point(5, -1, 2), Point(-2, 3, 7)},
                                                {Point(-3, 8, 5), Point(-3, 1, 9), Point(-3, 2, -4)}};
// Planar, and twisted.
const std::vector<std::vector<Point>> quads{
    {Point(0, 0, 1), Point(4, 0, 1), Point(4, 4, 1), Point(0, 4, 1)},
    {Point(1, 2, 3), Point(6, 1, 2), Point(7, 6, 5), Point(0, 5, 4)},
    {Point(2, -1, 0), Point(2, 5, 1), Point(1, 6, 7), Point(3, 0, 6)},
};

TEST(element, contact_with_segments_is_the_combination_of_the_ends) {
  for (const auto& ends : segments) {
    for (const double share : {1 / 16., .25, .5, .875})
      expect_contact(ElementKind::Segment, ends, {1 - share, share, 0, 0}, Contact::Interior);
    expect_contact(ElementKind::Segment, ends, {1, 0, 0, 0}, Contact::Border);
    expect_contact(ElementKind::Segment, ends, {0, 1, 0, 0}, Contact::Border);
    for (const double beyond : {-.25, 1.25})
      EXPECT_EQ(type_of(ElementKind::Segment).contact(ends, at(ends, {1 - beyond, beyond, 0, 0})).contact,
                Contact::Off);
  }
}

TEST(element, contact_with_triangles_is_the_combination_of_the_corners) {
  for (const auto& corners : triangles) {
    expect_contact(ElementKind::Triangle, corners, {.25, .125, .625, 0}, Contact::Interior);
    expect_contact(ElementKind::Triangle, corners, {.5, .4375, .0625, 0}, Contact::Interior);
    expect_contact(ElementKind::Triangle, corners, {.25, 0, .75, 0}, Contact::Border);
    expect_contact(ElementKind::Triangle, corners, {.25, .75, 0, 0}, Contact::Border);
    expect_contact(ElementKind::Triangle, corners, {0, 0, 1, 0}, Contact::Border);
    for (const Basis& beside : {Basis{-.25, .5, .75, 0}, Basis{.5, -.25, .75, 0}, Basis{.5, .75, -.25, 0}})
      EXPECT_EQ(type_of(ElementKind::Triangle).contact(corners, at(corners, beside)).contact, Contact::Off);
  }
}

TEST(element, contact_with_quads_is_the_bilinear_combination_of_the_corners) {
  for (const auto& corners : quads) {
    expect_contact(ElementKind::Quad, corners, bilinear(.25, .5), Contact::Interior);
    expect_contact(ElementKind::Quad, corners, bilinear(.75, .125), Contact::Interior);
    expect_contact(ElementKind::Quad, corners, bilinear(0, .25), Contact::Border);
    expect_contact(ElementKind::Quad, corners, bilinear(.5, 1), Contact::Border);
    expect_contact(ElementKind::Quad, corners, bilinear(1, 1), Contact::Border);
  }
}

// All its corners but one lie on a line, and that one as near to it as doubles can say.
TEST(element, a_quad_has_an_area_however_small_it_is) {
  for (const double height : {1e-10, 1e-190, 1e-205, 1e-300, 5e-324}) {
    std::vector<Vec3<Mp200>> corners;
    for (const Point& c : {Point(height, 0, 0), Point(1, 1, 0), Point(2, 2, 0), Point(3, 3, 0)})
      corners.push_back(convert<Mp200>(c));
    EXPECT_FALSE(type_of(ElementKind::Quad).degenerate(corners)) << height;
    corners[0] = Vec3<Mp200>(Mp200(-4), Mp200(-4), Mp200(0));
    EXPECT_TRUE(type_of(ElementKind::Quad).degenerate(corners));
  }
}

TEST(element, extent_is_the_integral_of_the_normal) {
  for (const auto& s : segments) {
    const Point along = s[1] - s[0];
    EXPECT_EQ(type_of(ElementKind::Segment).extent(s), Point(along[1], -along[0], 0));
  }
  const auto twice_area = [](const Point& a, const Point& b, const Point& c) { return Point((b - a).cross(c - a)); };
  for (const auto& c : triangles) EXPECT_EQ(type_of(ElementKind::Triangle).extent(c), twice_area(c[0], c[1], c[2]));
  // Any surface with the quad's border has the same.
  for (const auto& q : quads)
    EXPECT_EQ(type_of(ElementKind::Quad).extent(q), twice_area(q[0], q[1], q[2]) + twice_area(q[0], q[2], q[3]));
}

TEST(element, normal_of_a_quad_is_that_of_its_two_tangents) {
  for (const auto& q : quads)
    for (const double u : {0., .25, 1.})
      for (const double v : {0., .5, 1.}) {
        // The surface is linear along either parameter, so that tangents are differences of points.
        const Point along_u = at(q, bilinear(1, v)) - at(q, bilinear(0, v)),
                    along_v = at(q, bilinear(u, 1)) - at(q, bilinear(u, 0));
        EXPECT_EQ(type_of(ElementKind::Quad).normal(q, bilinear(u, v)), along_u.cross(along_v)) << u << ' ' << v;
      }
}

}  // namespace
}  // namespace cageproof
