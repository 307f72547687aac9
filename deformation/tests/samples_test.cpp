// SPDX-License-Identifier: MIT
// Basis functions of elements' samples sum to one, and no corner is the first.
#include "layers/samples.h"
#include "settings.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cageproof::deformation::test {
namespace {

// Where a third of a face was seen from its first corner, faces that begin with another corner had other samples by a
// rounding, which densities of small faces enlarge: coordinates of `bevel-1e-5` changed by 393 of their roundings.
TEST(samples, are_the_same_whichever_corner_an_element_begins_with) {
  for (const Case& c : {cube(), pentagon()}) {
    const CageElements elements(c.cage, false, Triangulation::Shortest);
    std::vector<Face> turned = elements.all();
    for (std::size_t e = 0; e < turned.size(); ++e) {
      const auto corners = std::span(turned[e].vertices).first(elements.vertices_of(e).size());
      if (corners.size() == 3) std::ranges::rotate(corners, corners.begin() + static_cast<std::ptrdiff_t>(1 + e % 2));
    }
    const CageElements other(c.cage.with(c.cage.vertices(), turned), false, Triangulation::Fan);
    for (const int level : {0, 1, 2}) {
      const auto places = [&](const CageElements& of) {
        std::vector<std::pair<int, std::vector<std::pair<int, double>>>> found;
        for (const Touching& sample : samples_of(of, level)) {
          auto& [element, shares] = found.emplace_back(sample.element, std::vector<std::pair<int, double>>());
          const auto vertices = of.vertices_of(static_cast<std::size_t>(element));
          double left = 1;
          for (std::size_t k = 0; k < vertices.size(); ++k) {
            shares.emplace_back(vertices[k], sample.basis[k]);
            left -= sample.basis[k];
          }
          EXPECT_EQ(left, 0);
          std::ranges::sort(shares);
        }
        std::ranges::sort(found);
        return found;
      };
      EXPECT_EQ(places(elements), places(other)) << c.name << ' ' << level;
    }
  }
}

}  // namespace
}  // namespace cageproof::deformation::test
