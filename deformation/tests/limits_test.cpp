// SPDX-License-Identifier: MIT
// Limits of layers at points within elements, against layers next to them in many digits.
#include "support.h"
#include "thinned.h"

#include "cageproof/core/input_error.h"

#include <gtest/gtest.h>

namespace cageproof::deformation::test {
namespace {

// A point 1e-25 inside of where the basis functions say.
Vec3<Mp50> next_to(const CageElements& elements, const Touching& place) {
  Vec3<Mp50> point = Vec3<Mp50>::Zero();
  const auto corners = elements.corners(place.element);
  for (std::size_t k = 0; k < corners.size(); ++k) point += Mp50(place.basis[k]) * convert<Mp50>(corners[k]);
  Vec3<Mp50> normal;
  const Vec3<Mp50> u = convert<Mp50>(corners[1]) - convert<Mp50>(corners[0]);
  if (corners.size() == 2) normal = {u[1], -u[0], Mp50(0)};
  else normal = u.cross(Vec3<Mp50>(convert<Mp50>(corners[2]) - convert<Mp50>(corners[0])));
  return point - Mp50("1e-25") / Mp50(sqrt(Mp50(normal.dot(normal)))) * normal;
}

TEST(limits, are_those_of_points_next_to_slanted_elements) {
  for (const Case& c : {bar(), pentagon()}) {
    Cage posed = c.cage.dimension() == 3 ? Cage::make("posed", c.posed, c.cage.faces(), {})
                                         : Cage::make_polygon("posed", c.posed, c.cage.faces(), {});
    for (const char* kind : {"green", "biharmonic", "regularised_1_3", "regularised_1_2", "regularised_weber",
                             "harmonic", "biharmonic_boundary"}) {
      if (!exists_on(coordinate_kind_named(kind), posed)) continue;
      // Their system in 50 digits takes half a minute.
      if (kind == std::string_view("harmonic") && posed.dimension() == 3 && test_stride() > 1) continue;
      const CageCoordinates coordinates(posed, coordinate_kind_named(kind), CoordinateOptions{});
      std::vector<Touching> places;
      for (int e = 0; e < static_cast<int>(coordinates.elements().count()); e += 3)
        places.push_back(posed.dimension() == 3 ? Touching{e, {0.4375, 0.3125, 0.25, 0}}
                                                // off the edges of harmonic pieces
                                                : Touching{e, {0.625, 0.375, 0, 0}});
      const auto limits = coordinates.limits_at<double>(places, 2);
      const auto exact = coordinates.limits_at<Mp50>(places, 2);
      for (std::size_t p = 0; p < places.size(); ++p) {
        const auto near = coordinates.at<Mp50>(next_to(coordinates.elements(), places[p]), 2);
        for (std::size_t b = 0; b < near.size(); ++b)
          for (int o = 0; o <= 2; ++o)
            for (std::size_t i = 0; i < near[b].of(o).size(); ++i) {
              const auto truth = static_cast<double>(near[b].of(o)[i]);
              const std::size_t at = p * limits[b].stride[o] + i;
              EXPECT_NEAR(limits[b].tensors[o][at], truth, 1e-12 * (1 + std::abs(truth))) << kind << ' ' << o;
              EXPECT_NEAR(static_cast<double>(exact[b].tensors[o][at]), truth, 1e-15 * (1 + std::abs(truth)))
                  << kind << ' ' << o;
            }
      }
    }
  }
}

TEST(limits, are_not_there_for_matrices_and_normalised_coordinates) {
  const Case c = cube();
  const std::vector<Touching> places{{0, {0.5, 0.25, 0.25, 0}}};
  for (const char* kind : {"somigliana", "mean_value"}) {
    const CageCoordinates coordinates(c.cage, coordinate_kind_named(kind), CoordinateOptions{});
    EXPECT_THROW(coordinates.limits_at<double>(places, 0), InputError) << kind;
  }
}

}  // namespace
}  // namespace cageproof::deformation::test
