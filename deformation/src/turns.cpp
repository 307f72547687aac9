// SPDX-License-Identifier: MIT
#include "turns.h"

#include "nearest_rotation.h"
#include "own_unit.h"

#include "cageproof/deformation/stretch.h"

#include <Eigen/Dense>

#include <fmt/format.h>

namespace cageproof::deformation {
namespace {

// Up to the rounding of what it is found from.
template <Scalar R>
NearestRotation<R> rotation_nearest_to(const Matrix<R>& matrix) {
  return nearest_rotation<R>(matrix, 64 * unit_roundoff<R>());
}

// The rotation and stretch of all vertices (Umeyama 1991).
template <Scalar R>
std::pair<Matrix<R>, R> similarity(int d, const std::vector<Vec3<R>>& from, const std::vector<Vec3<R>>& posed,
                                   std::vector<std::string>& warnings) {
  Vec3<R> middle = Vec3<R>::Zero(), posed_middle = Vec3<R>::Zero();
  for (std::size_t v = 0; v < from.size(); ++v) middle += from[v], posed_middle += posed[v];
  middle /= R(static_cast<double>(from.size()));
  posed_middle /= R(static_cast<double>(from.size()));
  Matrix<R> h = Matrix<R>::Zero(d, d);
  R size = 0;
  for (std::size_t v = 0; v < from.size(); ++v) {
    const Vec3<R> step = from[v] - middle;
    h += in<R>(d, posed[v] - posed_middle) * in<R>(d, step).transpose();
    size += step.dot(step);
  }
  const NearestRotation<R> nearest = rotation_nearest_to<R>(h);
  if (!nearest.is_unique) warnings.emplace_back("the rotation of all vertices is not unique");
  return {nearest.rotation, R(nearest.signed_values.sum() / size)};
}

// Of one element: the rotation factor of the map that takes its rest edges to the posed ones and its normal to the
// posed one.
template <Scalar R>
Matrix<R> rotation_of(const CageElements& rest, const std::vector<Vec3<R>>& from, const std::vector<Vec3<R>>& posed,
                      std::size_t e) {
  const int d = rest.dimension();
  const auto corners = rest.vertices_of(e);
  const auto axes = [&](const std::vector<Vec3<R>>& vertices) {
    Matrix<R> found(d, d);
    for (int k = 0; k + 1 < d; ++k) found.col(k) = in<R>(d, vertices[corners[k + 1]] - vertices[corners[0]]);
    // In the plane the normal as long as the edge makes the map a similarity.
    found.col(d - 1) = in<R>(d, posed_normal(rest, vertices, e)) * (d == 2 ? found.col(0).norm() : R(1));
    return found;
  };
  return rotation_nearest_to<R>(Matrix<R>(axes(posed) * axes(from).inverse())).rotation;
}

template <Scalar R>
Turns<R> global_turns(const CageElements& rest, const std::vector<Vec3<R>>& from, const std::vector<Vec3<R>>& posed,
                      std::vector<std::string>& warnings) {
  const auto [rotation, stretch] = similarity(rest.dimension(), from, posed, warnings);
  return {std::vector<Matrix<R>>(posed.size(), rotation), std::vector<Matrix<R>>(rest.count(), rotation),
          std::vector<R>(rest.count(), stretch)};
}

// \param least singular values up to that are rounding
template <Scalar R>
Matrix<R> rotation_or_warning(const Matrix<R>& matrix, std::string_view what, std::size_t index,
                              std::vector<std::string>& warnings, const R& least = R(0)) {
  const NearestRotation<R> nearest = rotation_nearest_to<R>(matrix);
  if (!nearest.is_unique || nearest.signed_values[matrix.rows() - 2] <= least)
    warnings.push_back(fmt::format("the rotation of {} {} is not unique", what, index));
  return nearest.rotation;
}

template <Scalar R>
Turns<R> local_turns(const CageElements& rest, const std::vector<Vec3<R>>& from, const std::vector<Vec3<R>>& posed,
                     std::vector<R> stretches, std::vector<std::string>& warnings) {
  const int d = rest.dimension();
  Turns<R> found;
  found.stretches = std::move(stretches);
  found.of_vertices.assign(posed.size(), Matrix<R>::Zero(d, d));
  std::vector<R> around(posed.size(), R(0));
  for (std::size_t e = 0; e < rest.count(); ++e) {
    found.of_elements.push_back(rotation_of(rest, from, posed, e));
    const R size = measure(rest, from, e);
    for (const int v : rest.vertices_of(e)) found.of_vertices[v] += size * found.of_elements[e], around[v] += size;
  }
  for (std::size_t v = 0; v < posed.size(); ++v)
    found.of_vertices[v] =
        rotation_or_warning<R>(found.of_vertices[v], "vertex", v, warnings, 64 * unit_roundoff<R>() * around[v]);
  return found;
}

}  // namespace

template <Scalar R>
R measure(const CageElements& rest, const std::vector<Vec3<R>>& vertices, std::size_t element) {
  using std::sqrt;
  const auto corners = rest.vertices_of(element);
  const Vec3<R> u = vertices[corners[1]] - vertices[corners[0]];
  if (corners.size() == 2) return sqrt(R(u.dot(u)));
  const Vec3<R> area = u.cross(Vec3<R>(vertices[corners[2]] - vertices[corners[0]]));
  return sqrt(R(area.dot(area))) / 2;
}

// Stretches are averaged as numbers; rotations as matrices, whose nearest rotation is taken, as around vertices.
template <Scalar R>
Turns<R> turns_of(const CageElements& rest, const std::vector<Vec3<R>>& from, const std::vector<Vec3<R>>& posed,
                  const std::function<std::vector<R>()>& stretches, double blend, std::vector<std::string>& warnings) {
  if (blend == 0) return global_turns(rest, from, posed, warnings);
  Turns<R> local = local_turns<R>(rest, from, posed, stretches(), warnings);
  if (blend == 1) return local;
  const Turns<R> global = global_turns(rest, from, posed, warnings);
  const R share(blend), other = 1 - share, least = 64 * unit_roundoff<R>();
  for (std::size_t v = 0; v < posed.size(); ++v)
    local.of_vertices[v] = rotation_or_warning<R>(other * global.of_vertices[v] + share * local.of_vertices[v],
                                                  "vertex", v, warnings, least);
  for (std::size_t e = 0; e < rest.count(); ++e) {
    local.of_elements[e] = rotation_or_warning<R>(other * global.of_elements[e] + share * local.of_elements[e],
                                                  "element", e, warnings, least);
    local.stretches[e] = other * global.stretches[e] + share * local.stretches[e];
  }
  return local;
}

template <Scalar R>
std::vector<Matrix<R>> vertex_rotations(const CageElements& rest, const std::vector<Vec3<R>>& posed,
                                        std::vector<std::string>& warnings) {
  const R unit(unit_next_to(size_of(rest)));
  return local_turns<R>(rest, over(vertices_in<R>(rest), unit), over(posed, unit), {}, warnings).of_vertices;
}

#define CAGEPROOF_INSTANTIATE(R)                                                                               \
  template R measure<R>(const CageElements&, const std::vector<Vec3<R>>&, std::size_t);                        \
  template Turns<R> turns_of<R>(const CageElements&, const std::vector<Vec3<R>>&, const std::vector<Vec3<R>>&, \
                                const std::function<std::vector<R>()>&, double, std::vector<std::string>&);    \
  template std::vector<Matrix<R>> vertex_rotations<R>(const CageElements&, const std::vector<Vec3<R>>&,        \
                                                      std::vector<std::string>&);
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::deformation
