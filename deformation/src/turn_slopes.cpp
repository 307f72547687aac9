// SPDX-License-Identifier: MIT
#include "turn_slopes.h"

#include "rotation_slope.h"
#include "stretch_slopes.h"

#include "cageproof/deformation/stretch.h"

#include <fmt/format.h>

namespace cageproof::deformation {
namespace {

// Tangents and normal as columns; in the plane the edge, the same turned by a quarter, and the axis across.
template <Scalar R>
Mat3<R> axes_of(const CageElements& rest, const std::vector<Vec3<R>>& vertices, const NormalPlace& at) {
  const std::array<Vec3<R>, 2> tangents = tangents_of(rest, vertices, at.element, at.corner);
  Mat3<R> found;
  found.col(0) = tangents[0];
  if (rest.dimension() == 2) {
    found.col(1) = Vec3<R>(tangents[0][1], -tangents[0][0], R(0));
    found.col(2) = Vec3<R>(R(0), R(0), R(1));
  } else {
    found.col(1) = tangents[1];
    found.col(2) = posed_normal(rest, vertices, at.element, at.corner);
  }
  return found;
}

}  // namespace

template <Scalar R>
TurnSlopes<R> normal_turn_slopes(const CageElements& rest, const std::vector<Vec3<R>>& from,
                                 const std::vector<Vec3<R>>& posed) {
  const int d = rest.dimension();
  TurnSlopes<R> found;
  for (const NormalPlace& at : normal_places(rest)) {
    const auto corners = rest.vertices_of(at.element);
    const Mat3<R> to = axes_of(rest, posed, at);
    const Mat3<R> back = Eigen::PartialPivLU<Mat3<R>>(axes_of(rest, from, at)).solve(Mat3<R>::Identity());
    const RotationSlope<R> rotation(d, Mat3<R>(to * back), fmt::format("element {}", at.element));
    found.rotations.push_back(rotation.rotation());
    const std::array<Mat3<R>, 2> of_normal =
        d == 3 ? unit_normal_slopes(std::array<Vec3<R>, 2>{to.col(0), to.col(1)}) : std::array<Mat3<R>, 2>();
    const auto weights = tangent_weights<R>(corners.size(), at.corner);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      Mat3<R> slope = Mat3<R>::Zero();
      for (int c = 0; c < d; ++c) {
        Mat3<R> change = Mat3<R>::Zero();
        change(c, 0) = weights[k][0];
        if (d == 2) {
          change(0, 1) = c == 1 ? weights[k][0] : R(0);
          change(1, 1) = c == 0 ? R(-weights[k][0]) : R(0);
        } else {
          change(c, 1) = weights[k][1];
          change.col(2) = weights[k][0] * of_normal[0].col(c) + weights[k][1] * of_normal[1].col(c);
        }
        slope.col(c) = rotation.of(Mat3<R>(change * back));
      }
      found.slopes.parts.push_back({found.rotations.size() - 1, corners[k], slope});
    }
  }
  found.slopes.rows = found.rotations.size();
  return found;
}

template <Scalar R>
TurnSlopes<R> vertex_turn_slopes(const CageElements& rest, const std::vector<Vec3<R>>& from,
                                 const TurnSlopes<R>& of_normals) {
  const std::vector<NormalPlace> places = normal_places(rest);
  std::vector<Mat3<R>> sums(from.size(), Mat3<R>::Zero());
  std::vector<R> sizes;
  for (std::size_t i = 0; i < places.size(); ++i) {
    sizes.push_back(area_vector(rest, from, places[i]).norm());
    for (const int v : rest.vertices_of(places[i].element)) sums[v] += sizes[i] * of_normals.rotations[i];
  }
  std::vector<RotationSlope<R>> nearest;
  TurnSlopes<R> found;
  for (std::size_t v = 0; v < sums.size(); ++v) {
    nearest.emplace_back(rest.dimension(), sums[v], fmt::format("vertex {}", v));
    found.rotations.push_back(nearest[v].rotation());
  }
  found.slopes.rows = sums.size();
  for (const auto& [row, vertex, slope] : of_normals.slopes.parts)
    for (const int v : rest.vertices_of(places[row].element)) {
      Mat3<R> of_vertex;
      for (int c = 0; c < 3; ++c)
        of_vertex.col(c) =
            nearest[v].of(Mat3<R>(sizes[row] * cross_matrix(Vec3<R>(slope.col(c))) * of_normals.rotations[row]));
      found.slopes.parts.push_back({static_cast<std::size_t>(v), vertex, of_vertex});
    }
  return found;
}

#define CAGEPROOF_INSTANTIATE(R)                                                                 \
  template TurnSlopes<R> normal_turn_slopes<R>(const CageElements&, const std::vector<Vec3<R>>&, \
                                               const std::vector<Vec3<R>>&);                     \
  template TurnSlopes<R> vertex_turn_slopes<R>(const CageElements&, const std::vector<Vec3<R>>&, const TurnSlopes<R>&);
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::deformation
