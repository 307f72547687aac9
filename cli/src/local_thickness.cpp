// SPDX-License-Identifier: MIT
#include "local_thickness.h"

#include "cageproof/core/input_error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cageproof::cli {

using namespace deformation;
namespace {

// What [W12] offsets its cage by.
constexpr double kInside = 1e-6;

using Tables = std::vector<CoordinateTable<double>>;

// Limits at a share of each edge; none of coordinates without limits.
std::optional<Tables> limits_on_edges(const CageCoordinates& coordinates, double share) {
  std::vector<Touching> middles;
  for (std::size_t e = 0; e < coordinates.elements().count(); ++e)
    middles.push_back({static_cast<int>(e), {1 - share, share, 0, 0}});
  try {
    return coordinates.limits_at<double>(middles, 1);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

Tables next_to_edges(const CageCoordinates& coordinates, double share) {
  const CageElements& elements = coordinates.elements();
  std::vector<Vec3<double>> points;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto ends = elements.corners(e);
    points.emplace_back((1 - share) * ends[0] + share * ends[1] -
                        kInside * (ends[1] - ends[0]).stableNorm() * elements.normals()[e]);
  }
  return coordinates.at<double>(points, 1);
}

}  // namespace

nlohmann::ordered_json local_thickness(const CageCoordinates& coordinates, const Posed<double>& map,
                                       const std::vector<Vec3<double>>& posed, int pieces) {
  const CageElements& elements = coordinates.elements();
  const int before_middle = pieces / 2;
  const double share = (before_middle + .5) / pieces;
  const std::optional<Tables> limits = limits_on_edges(coordinates, share);
  const Images<double> images = map.images(limits ? *limits : next_to_edges(coordinates, share), elements.count(), 1);
  nlohmann::ordered_json edges = nlohmann::ordered_json::array();
  double least = std::numeric_limits<double>::infinity(), largest = -least;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const double* const j = &images.tensors[1][4 * e];
    const Vec3<double>& n = elements.normals()[e];
    const auto ends = elements.vertices_of(e);
    const Vec3<double> along = posed[ends[1]] - posed[ends[0]];
    const double across = (along[1] * (j[0] * n[0] + j[1] * n[1]) - along[0] * (j[2] * n[0] + j[3] * n[1])) /
                          std::hypot(along[0], along[1]);
    edges.push_back(std::isfinite(across) ? nlohmann::ordered_json(across) : nullptr);
    if (!std::isfinite(across)) continue;
    least = std::min(least, across);
    largest = std::max(largest, across);
  }
  const bool any = least <= largest;
  return {{"where", share},
          {"from", limits ? "limit" : "1e-6 inside"},
          {"least", any ? nlohmann::ordered_json(least) : nullptr},
          {"largest", any ? nlohmann::ordered_json(largest) : nullptr},
          {"edges", std::move(edges)}};
}

}  // namespace cageproof::cli
