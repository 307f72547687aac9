// SPDX-License-Identifier: MIT
#include "cageproof/core/geometry/box.h"
#include "mirror_symmetry.h"

#include <algorithm>
#include <set>

namespace cageproof::validation {
namespace {

// From the smallest vertex on, so that it does not matter at which corner a face begins.
std::vector<int> from_smallest(std::vector<int> corners) {
  std::ranges::rotate(corners, std::ranges::min_element(corners));
  return corners;
}

}  // namespace

std::optional<MirrorSymmetry> mirror_symmetry(const std::vector<Vec3<double>>& vertices, int axis) {
  const auto [low, high] = box_of(vertices);
  MirrorSymmetry mirror{axis, low[axis] / 2 + high[axis] / 2, {}};
  const double rounding = 0x1p-50 * std::max((high - low).maxCoeff(), high.cwiseMax(-low).maxCoeff());
  mirror.vertex.reserve(vertices.size());
  for (const Vec3<double>& v : vertices) {
    const Vec3<double> image = mirror(v);
    const auto found = std::ranges::find_if(
        vertices, [&](const Vec3<double>& w) { return (w - image).cwiseAbs().maxCoeff() <= rounding; });
    if (found == vertices.end()) return std::nullopt;
    mirror.vertex.push_back(static_cast<int>(found - vertices.begin()));
  }
  return mirror;
}

bool keeps(const MirrorSymmetry& mirror, const CageElements& elements) {
  std::set<std::vector<int>> known;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto corners = elements.vertices_of(e);
    known.insert(from_smallest({corners.begin(), corners.end()}));
  }
  for (std::size_t e = 0; e < elements.count(); ++e) {
    std::vector<int> image;
    image.reserve(4);
    for (const int v : elements.vertices_of(e)) image.push_back(mirror.vertex[v]);
    std::ranges::reverse(image);
    if (!known.contains(from_smallest(std::move(image)))) return false;
  }
  return true;
}

std::vector<Vec3<double>> made_symmetric(const MirrorSymmetry& mirror, const std::vector<Vec3<double>>& vertices) {
  std::vector<Vec3<double>> found;
  found.reserve(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v)
    found.push_back((vertices[v] + mirror(vertices[mirror.vertex[v]])) / 2);
  return found;
}

}  // namespace cageproof::validation
