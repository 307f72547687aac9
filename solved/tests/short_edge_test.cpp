// SPDX-License-Identifier: MIT
// Polygons with one edge that is much shorter than the others.
#include "support.h"

#include <gtest/gtest.h>

namespace cageproof::solved::test {
namespace {

// An ordinary hexagon whose third edge is t long.
Cage with_short_edge(double t) { return polygon({{0, 0}, {1, 0}, {1.3, .8}, {1.3, .8 + t}, {.6, 1.2}, {-.2, .7}}); }

// The largest difference from 50 digits of a block's derivatives, over their norm.
double relative_error(const CageCoordinates& coordinates, const Vec& point) {
  const auto found = coordinates.at<double>(point, 2);
  const auto exact = coordinates.at<Mp50>(convert<Mp50>(point), 2);
  double worst = 0;
  for (std::size_t b = 0; b < found.size(); ++b)
    for (int o = 0; o <= 2; ++o) {
      double error = 0, size = 0;
      for (std::size_t i = 0; i < found[b].of(o).size(); ++i) {
        error = std::hypot(error, static_cast<double>(Mp50(Mp50(found[b].of(o)[i]) - exact[b].of(o)[i])));
        size = std::hypot(size, found[b].of(o)[i]);
      }
      worst = std::max(worst, error / size);
    }
  return worst;
}

// In the frame of the whole polygon, whose vertices are rounded to parts of its diameter, an edge that is a millionth
// of it has ten digits, and derivatives next to it as few.
TEST(short_edge, keeps_the_digits_of_its_length) {
  for (const double t : {1e-3, 1e-6, 1e-12})
    for (const char* kind : {"harmonic", "triharmonic_boundary", "elastic"}) {
      const CageCoordinates c = coordinates(with_short_edge(t), kind);
      for (const Vec& p : {Vec(1.2455758717861956, 0.827043014360713, 0), Vec(.5, .5, 0)})
        EXPECT_LT(relative_error(c, p), 1e-12) << kind << ' ' << t;
    }
}

// Densities are solved in 50 digits, and are so large that they leave 2e-10 where they are rounded to double.
TEST(short_edge, costs_affine_maps_nothing) {
  const double t = 1e-8;
  const CageCoordinates c =
      coordinates(polygon({{0, 0}, {1, 0}, {1, 1 - t}, {1 - t, 1}, {0, 1}}), "biharmonic_boundary");
  for (const Vec& p : {Vec(.5, .5, 0), Vec(.9, .9, 0), Vec(.2, .6, 0)}) EXPECT_LT(affine_errors(c, p, 0)[0], 1e-13);
}

// A piece of such an edge pulls as little as it is short, which is no reason to leave its traction out.
TEST(short_edge, counts_as_much_as_others) {
  for (const double t : {1e-3, 1e-8, 1e-12, 1e-14}) {
    const SolvedSystem system = coordinates(with_short_edge(t), "elastic").solved().front();
    EXPECT_FALSE(system.is_singular()) << t << ": rank " << system.rank << " of " << system.columns;
    EXPECT_LT(system.condition, 1e4) << t;
  }
}

}  // namespace
}  // namespace cageproof::solved::test
