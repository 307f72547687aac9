// SPDX-License-Identifier: MIT
// Cages whose parts share an edge or a vertex: as the same surface with vertices of their own for each part.
#include "cageproof/core/cage/cage.h"
#include "cageproof/core/coordinates/whole_evaluation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace cageproof {
namespace {

// Cubes of quads with those low corners; vertices in one place are one, or each cube has its own.
struct Cubes {
  std::vector<Vec3<double>> vertices;
  std::vector<Face> faces;

  Cubes(const std::vector<Vec3<double>>& lows, bool joined) {
    for (const Vec3<double>& low : lows) {
      const auto first = static_cast<std::ptrdiff_t>(joined ? 0 : vertices.size());
      const auto vertex = [&](const Vec3<double>& at) {
        auto found = std::find(vertices.begin() + first, vertices.end(), at);
        if (found == vertices.end()) found = vertices.insert(vertices.end(), at);
        return static_cast<int>(found - vertices.begin());
      };
      for (const auto& face :
           {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
        Face& added = faces.emplace_back();
        for (int k = 0; k < 4; ++k)
          added.vertices[k] = vertex(low + Vec3<double>(face[k] & 1, (face[k] >> 1) & 1, face[k] >> 2));
      }
    }
  }
};

TEST(MeetingParts, have_the_coordinates_of_parts_apart) {
  const std::vector<Vec3<double>> points{{.3, .2, .6}, {1.7, 1.25, .4}, {.5, .5, .999}, {1.001, .999, .5}, {3, -1, 2}};
  for (const Vec3<double>& second : {Vec3<double>(1, 1, 0), Vec3<double>(1, 1, 1)}) {
    const Cubes joined({Vec3<double>::Zero(), second}, true), apart({Vec3<double>::Zero(), second}, false);
    ASSERT_LT(joined.vertices.size(), apart.vertices.size());
    const Cage one = Cage::make("joined", joined.vertices, joined.faces),
               two = Cage::make("apart", apart.vertices, apart.faces);
    for (const std::string_view kind : {"green", "mean_value", "biharmonic", "somigliana"})
      for (const std::string_view evaluation : {std::string_view("batched"), std::string_view("closed_form")}) {
        const CageCoordinates in_one(one, coordinate_kind_named(kind), evaluation, Triangulation::Shortest),
            in_two(two, coordinate_kind_named(kind), evaluation, Triangulation::Shortest);
        const auto found = in_one.at<double>(points, 1), expected = in_two.at<double>(points, 1);
        for (std::size_t b = 0; b < found.size(); ++b) {
          const CoordinateBlock& block = in_one.blocks()[b];
          for (int order = 0; order <= 1; ++order) {
            const std::size_t width = found[b].stride[order] / static_cast<std::size_t>(block.size);
            for (std::size_t p = 0; p < points.size(); ++p) {
              // The sum over vertices in one place.
              std::vector<double> sums(found[b].stride[order], 0);
              for (std::size_t i = 0; i < expected[b].stride[order]; ++i) {
                std::size_t coordinate = i / width;
                if (block.owner == Owner::Vertex)
                  coordinate = static_cast<std::size_t>(std::ranges::find(joined.vertices, apart.vertices[coordinate]) -
                                                        joined.vertices.begin());
                sums[coordinate * width + i % width] += expected[b].tensors[order][p * expected[b].stride[order] + i];
              }
              for (std::size_t i = 0; i < sums.size(); ++i)
                EXPECT_NEAR(found[b].tensors[order][p * found[b].stride[order] + i], sums[i],
                            1e-11 * (1 + std::abs(sums[i])))
                    << kind << ' ' << evaluation << " block " << b << " order " << order << " point " << p;
            }
          }
        }
      }
  }
}

}  // namespace
}  // namespace cageproof
