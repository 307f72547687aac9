// SPDX-License-Identifier: MIT
#include "extended.h"

namespace cageproof::deformation {

Extended::Extended(const CageCoordinates& coordinates)
    : elements_(coordinates.elements()),
      normal_factor_(coordinates.blocks()[1].normal_factor),
      nearest_(coordinates.elements()) {}

double Extended::add_to(std::vector<CoordinateTable<double>>& tables, std::size_t p, const Vec3<double>& point,
                        int order) const {
  const int d = elements_.dimension();
  const auto [element, place, distance] = nearest_.of(point);
  const auto corners = elements_.corners(element);
  const Vec3<double>&normal = elements_.normals()[element], from = point - corners[0];
  const auto add = [&](std::size_t block, int coordinate, double value, const Vec3<double>& gradient) {
    CoordinateTable<double>& table = tables[block];
    table.tensors[0][p * table.stride[0] + coordinate] += value;
    for (int axis = 0; axis < d && order > 0; ++axis)
      table.tensors[1][p * table.stride[1] + static_cast<std::size_t>(coordinate * d + axis)] += gradient[axis];
  };
  const auto vertices = elements_.vertices_of(element);
  // The affine weights of all corners except the first, as functions of the point, and their sum.
  double others = 0;
  Vec3<double> gradient_of_others = Vec3<double>::Zero();
  for (std::size_t k = 1; k < corners.size(); ++k) {
    const Vec3<double> side = corners[k] - corners[0];
    Vec3<double> gradient = side / side.squaredNorm();
    if (corners.size() == 3) {
      // One at the corner, zero on the other side.
      const Vec3<double> across = normal.cross(corners[3 - k] - corners[0]);
      gradient = across / across.dot(side);
    }
    const double weight = gradient.dot(from);
    add(0, vertices[k], weight, gradient);
    others += weight;
    gradient_of_others += gradient;
  }
  add(0, vertices[0], 1 - others, -gradient_of_others);
  add(1, static_cast<int>(element), normal.dot(from) / normal_factor_, normal / normal_factor_);
  return distance;
}

}  // namespace cageproof::deformation
