// SPDX-License-Identifier: MIT
#include "slice_outline.h"

namespace cageproof::reports {
namespace {

using Segments = std::vector<std::array<Vec3<double>, 2>>;

void cut_triangle(const std::array<Vec3<double>, 3>& corners, int axis, double value, Segments& found) {
  std::vector<Vec3<double>> ends;
  for (int k = 0; k < 3; ++k) {
    const Vec3<double>&a = corners[k], &b = corners[(k + 1) % 3];
    const double from = a[axis] - value, to = b[axis] - value;
    // A corner in the plane belongs to the side above it, so that every crossing counts once.
    if ((from < 0) != (to < 0)) ends.emplace_back(a + (b - a) * (from / (from - to)));
  }
  if (ends.size() == 2) found.push_back({ends[0], ends[1]});
}

// So fine that a picture does not show the difference from the curve.
constexpr int kSteps = 8;

void cut_quad(const std::array<Vec3<double>, 4>& c, int axis, double value, Segments& found) {
  const auto at = [&](int i, int j) -> Vec3<double> {
    const double u = 1.0 * i / kSteps, v = 1.0 * j / kSteps;
    return (1 - u) * (1 - v) * c[0] + u * (1 - v) * c[1] + u * v * c[2] + (1 - u) * v * c[3];
  };
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      cut_triangle({at(i, j), at(i + 1, j), at(i + 1, j + 1)}, axis, value, found);
      cut_triangle({at(i, j), at(i + 1, j + 1), at(i, j + 1)}, axis, value, found);
    }
}

}  // namespace

std::vector<std::array<Vec3<double>, 2>> outline_in_plane(const MeshField& surface, int axis, double value) {
  Segments found;
  for (const std::vector<int>& face : surface.faces) {
    const auto corner = [&](std::size_t k) { return surface.vertices[face[k % face.size()]]; };
    bool flat = true;
    for (std::size_t k = 0; k < face.size(); ++k) flat = flat && corner(k)[axis] == value;
    if (flat) {
      for (std::size_t k = 0; k + 1 < face.size() + (face.size() > 2); ++k) found.push_back({corner(k), corner(k + 1)});
    } else if (face.size() == 4) {
      cut_quad({corner(0), corner(1), corner(2), corner(3)}, axis, value, found);
    } else {
      for (std::size_t k = 1; k + 1 < face.size(); ++k)
        cut_triangle({corner(0), corner(k), corner(k + 1)}, axis, value, found);
    }
  }
  return found;
}

}  // namespace cageproof::reports
