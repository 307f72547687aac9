// SPDX-License-Identifier: MIT
// Posed normals of bilinear quads: against integrals by definition, and what they keep.
#include "quad_cases.h"
#include "quad_routes.h"

#include "cageproof/core/input_error.h"
#include "cageproof/deformation/stretch.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cageproof::deformation::test::quad_normals_test {
namespace {

constexpr std::array all_stretches{Stretch::Rms, Stretch::Mean, Stretch::Area, Stretch::Unit, Stretch::Product};

CageElements kept(const Cage& cage) { return {cage, true, Triangulation::Shortest}; }

// The largest difference of normals, over the largest.
double difference(const std::vector<Vec>& a, const std::vector<Vec>& b) {
  double worst = 0, largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    keep_larger(worst, (a[i] - b[i]).norm());
    keep_larger(largest, b[i].norm());
  }
  return a.size() == b.size() ? worst / largest : NAN;
}

std::vector<Vec> by_route(Stretch stretch, const Case& c) {
  const CageElements elements = kept(c.cage);
  std::vector<Vec> found;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const BilinearRoute rest(elements, c.cage.vertices(), e), posed(elements, c.posed, e);
    const auto normals = neumann_route(static_cast<StretchRoute>(stretch), rest, posed);
    for (std::size_t k = 0; k < normals.size(); ++k)
      found.push_back(convert<double>(Wide(normals[k] / (rest.is_quad() ? length_of(rest.corner_area(k)) : Mp50(1)))));
  }
  return found;
}

TEST(quad_normals, are_the_integrals_of_their_definition) {
  for (const Case& c : quad_cases())
    for (const Stretch stretch : all_stretches)
      EXPECT_LT(difference(stretched_normals(stretch, kept(c.cage), c.posed), by_route(stretch, c)), 5e-15)
          << c.name << static_cast<int>(stretch);
}

// The area vector nearly vanishes within the posed quad, and sixteen points a direction leave more than 1e-9.
TEST(quad_normals, converge_where_a_posed_quad_is_bent_far) {
  const Case c = integer_cube();
  const CageElements elements = kept(c.cage);
  std::vector<Vec> posed = c.cage.vertices();
  posed[7] = Vec(1.5, 1.5, 4.5);
  for (std::size_t e = 0; e < elements.count(); ++e) {
    if (std::ranges::count(elements.vertices_of(e), 7) == 0) continue;
    const BilinearRoute rest(elements, c.cage.vertices(), e), to(elements, posed, e);
    for (const Stretch stretch : {Stretch::Rms, Stretch::Area}) {
      const auto found = stretched_normals(stretch, elements, posed);
      const auto expected = neumann_route(static_cast<StretchRoute>(stretch), rest, to, 80);
      for (int k = 0; k < 4; ++k) {
        const Vec truth = convert<double>(expected[k]) / elements.area_element_of(4 * e + k, Owner::Normal);
        EXPECT_LT((found[4 * e + k] - truth).norm(), 1e-14 * truth.norm()) << e << ' ' << k;
      }
    }
  }
}

// In 50 digits the area element that the layers have been multiplied with is still that of double.
TEST(quad_normals, have_all_digits_in_50) {
  const Case c = twisted_cube();
  const CageElements elements = kept(c.cage);
  std::vector<Wide> posed;
  posed.reserve(c.posed.size());
  for (const Vec& v : c.posed) posed.push_back(convert<Mp50>(v));
  for (const Stretch stretch : {Stretch::Rms, Stretch::Area}) {
    const auto found = stretched_normals(stretch, elements, posed);
    const BilinearRoute rest(elements, c.cage.vertices(), 2), to(elements, c.posed, 2);
    const auto expected = neumann_route(static_cast<StretchRoute>(stretch), rest, to);
    for (int k = 0; k < 4; ++k) {
      const Wide off = found[8 + k] * Mp50(elements.area_element_of(8 + k, Owner::Normal)) - expected[k];
      EXPECT_LT(static_cast<double>(Mp50(length_of(off) / length_of(expected[k]))), 1e-33) << k;
    }
  }
}

// Where quads are parallelograms, at rest and posed, their corners' normals are those of the triangles that they are
// split in, by all stretches.
TEST(quad_normals, of_parallelograms_are_those_of_triangles) {
  const Case c = integer_cube();
  Eigen::Matrix3d map;
  map << 1.3, .2, -.1, .05, .8, .3, -.2, .1, 1.1;
  std::vector<Vec> posed;
  for (const Vec& v : c.cage.vertices()) posed.emplace_back(map * v);
  const CageElements triangles(c.cage, false, Triangulation::Shortest);
  for (const Stretch stretch : all_stretches) {
    const std::vector<Vec> flat = stretched_normals(stretch, triangles, posed);
    std::vector<Vec> each;
    for (std::size_t t = 0; t < flat.size(); t += 2) each.insert(each.end(), 4, flat[t]);
    EXPECT_LT(difference(stretched_normals(stretch, kept(c.cage), posed), each), 2e-15) << static_cast<int>(stretch);
  }
}

TEST(quad_normals, turn_with_the_cage_and_stretch_with_it) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vec(1, 2, -.5).normalized()).toRotationMatrix();
  for (const Case& c : quad_cases()) {
    const CageElements elements = kept(c.cage);
    std::vector<Vec> turned, expected;
    for (const Vec& v : c.cage.vertices()) turned.emplace_back(1.5 * turn * v);
    for (std::size_t i = 0; i < elements.count(Owner::Normal); ++i)
      expected.emplace_back(turn * elements.normal_of(i, Owner::Normal));
    for (const Stretch stretch : all_stretches) {
      const double by = stretch == Stretch::Unit ? 1 : stretch == Stretch::Product ? 1.5 * 1.5 : 1.5;
      std::vector<Vec> found = stretched_normals(stretch, elements, turned);
      for (Vec& n : found) n /= by;
      EXPECT_LT(difference(found, expected), 4e-15) << c.name << static_cast<int>(stretch);
    }
  }
}

// Squares of areas would leave the range.
TEST(quad_normals, do_not_hang_on_the_unit_of_length) {
  const Case c = twisted_cube();
  const std::vector<Vec> here = stretched_normals(Stretch::Rms, kept(c.cage), c.posed);
  for (const double unit : {0x1p-500, 0x1p500}) {
    std::vector<Vec> rest = c.cage.vertices(), posed = c.posed;
    for (Vec& v : rest) v *= unit;
    for (Vec& v : posed) v *= unit;
    const Cage scaled = Cage::make("scaled", rest, c.cage.faces(), {});
    EXPECT_LT(difference(stretched_normals(Stretch::Rms, kept(scaled), posed), here), 1e-15) << unit;
  }
}

// A quad that folds over has a place without area, where the integrands have a kink.
TEST(quad_normals, of_a_posed_quad_that_folds_over_are_finite) {
  const Case c = integer_cube();
  std::vector<Vec> posed = c.cage.vertices();
  posed[7] = Vec(0.5, 0.5, 4);
  for (const Stretch stretch : all_stretches)
    for (const Vec& n : stretched_normals(stretch, kept(c.cage), posed)) EXPECT_TRUE(n.allFinite());
}

TEST(quad_normals, of_a_posed_quad_without_area_are_refused_by_its_name) {
  const Case c = mixed_cage();
  const CageElements elements = kept(c.cage);
  const auto corners = elements.vertices_of(2);
  std::vector<Vec> posed = c.posed;
  for (int k = 0; k < 4; ++k) posed[corners[k]] = Vec(1, 2, 3) + k * Vec(1, -2, 1);
  for (const Stretch stretch : all_stretches) {
    std::string said;
    try {
      stretched_normals(stretch, elements, posed);
    } catch (const InputError& error) {
      said = error.what();
    }
    const bool is_taken = stretch == Stretch::Area || stretch == Stretch::Product;
    EXPECT_EQ(said.find("the posed quad 2 (vertices ") != std::string::npos, !is_taken) << said;
    EXPECT_EQ(said.find("has no area") != std::string::npos, !is_taken) << said;
  }
}

}  // namespace
}  // namespace cageproof::deformation::test::quad_normals_test
