// SPDX-License-Identifier: MIT
#include "turns.h"

#include "nearest_rotation.h"
#include "own_unit.h"

#include "cageproof/deformation/stretch.h"

#include <fmt/format.h>

namespace cageproof::deformation {
namespace {

// Up to the rounding of what it is found from.
template <Scalar R>
NearestRotation<R> rotation_nearest_to(const SpaceMatrix<R>& matrix) {
  return nearest_rotation<R>(matrix, 64 * unit_roundoff<R>());
}

// The rotation and stretch of all vertices (Umeyama 1991).
template <Scalar R>
std::pair<SpaceMatrix<R>, R> similarity(int d, const std::vector<Vec3<R>>& from, const std::vector<Vec3<R>>& posed,
                                        std::vector<std::string>& warnings) {
  Vec3<R> middle = Vec3<R>::Zero(), posed_middle = Vec3<R>::Zero();
  for (std::size_t v = 0; v < from.size(); ++v) middle += from[v], posed_middle += posed[v];
  middle /= R(static_cast<double>(from.size()));
  posed_middle /= R(static_cast<double>(from.size()));
  SpaceMatrix<R> h = SpaceMatrix<R>::Zero(d, d);
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

// The rotation of an element at a normal: the rotation factor of the map that takes its rest tangents and normal to the
// posed ones.
template <Scalar R>
SpaceMatrix<R> rotation_of(const CageElements& rest, const std::vector<Vec3<R>>& from,
                           const std::vector<Vec3<R>>& posed, const NormalPlace& at) {
  const int d = rest.dimension();
  const auto axes = [&](const std::vector<Vec3<R>>& vertices) {
    const std::array<Vec3<R>, 2> tangents = tangents_of(rest, vertices, at.element, at.corner);
    SpaceMatrix<R> found(d, d);
    for (int k = 0; k + 1 < d; ++k) found.col(k) = in<R>(d, tangents[k]);
    // In the plane the normal as long as the edge makes the map a similarity.
    found.col(d - 1) =
        in<R>(d, posed_normal(rest, vertices, at.element, at.corner)) * (d == 2 ? found.col(0).norm() : R(1));
    return found;
  };
  return rotation_nearest_to<R>(SpaceMatrix<R>(axes(posed) * SpaceSolver<R>(axes(from)).inverse())).rotation;
}

template <Scalar R>
Turns<R> global_turns(const CageElements& rest, const std::vector<Vec3<R>>& from, const std::vector<Vec3<R>>& posed,
                      std::vector<std::string>& warnings) {
  const auto [rotation, stretch] = similarity(rest.dimension(), from, posed, warnings);
  const std::size_t normals = rest.count(Owner::Normal);
  return {std::vector<SpaceMatrix<R>>(posed.size(), rotation), std::vector<SpaceMatrix<R>>(normals, rotation),
          std::vector<R>(normals, stretch)};
}

// \param least singular values up to that are rounding
template <Scalar R>
SpaceMatrix<R> rotation_or_warning(const SpaceMatrix<R>& matrix, const std::string& whose,
                                   std::vector<std::string>& warnings, const R& least = R(0)) {
  const NearestRotation<R> nearest = rotation_nearest_to<R>(matrix);
  if (!nearest.is_unique || nearest.signed_values[matrix.rows() - 2] <= least)
    warnings.push_back(fmt::format("the rotation of {} is not unique", whose));
  return nearest.rotation;
}

std::string name_of_vertex(std::size_t v) { return fmt::format("vertex {}", v); }

std::string name_of_place(const CageElements& rest, const NormalPlace& at) {
  if (rest.type(at.element).flat) return fmt::format("element {}", at.element);
  return fmt::format("element {} next to vertex {}", at.element, rest.vertices_of(at.element)[at.corner]);
}

template <Scalar R>
Turns<R> local_turns(const CageElements& rest, const std::vector<Vec3<R>>& from, const std::vector<Vec3<R>>& posed,
                     std::vector<R> stretches, std::vector<std::string>& warnings) {
  const int d = rest.dimension();
  Turns<R> found;
  found.stretches = std::move(stretches);
  found.of_vertices.assign(posed.size(), SpaceMatrix<R>::Zero(d, d));
  std::vector<R> around(posed.size(), R(0));
  for (const NormalPlace& at : normal_places(rest)) {
    found.of_normals.push_back(rotation_of(rest, from, posed, at));
    const R size = area_vector(rest, from, at).norm();
    for (const int v : rest.vertices_of(at.element))
      found.of_vertices[v] += size * found.of_normals.back(), around[v] += size;
  }
  for (std::size_t v = 0; v < posed.size(); ++v)
    found.of_vertices[v] =
        rotation_or_warning<R>(found.of_vertices[v], name_of_vertex(v), warnings, 64 * unit_roundoff<R>() * around[v]);
  return found;
}

}  // namespace

std::vector<NormalPlace> normal_places(const CageElements& elements) {
  std::vector<NormalPlace> places;
  places.reserve(elements.count(Owner::Normal));
  for (std::size_t e = 0; e < elements.count(); ++e)
    for (std::size_t k = 0; k < elements.shares_of(e, Owner::Normal).size(); ++k)
      places.push_back({e, static_cast<int>(k)});
  return places;
}

template <Scalar R>
Vec3<R> area_vector(const CageElements& rest, const std::vector<Vec3<R>>& vertices, const NormalPlace& place) {
  const auto corners = rest.vertices_of(place.element);
  const auto from_corner = [&](int k) -> Vec3<R> {
    return vertices[corners[(place.corner + k) % corners.size()]] - vertices[corners[place.corner]];
  };
  const Vec3<R> u = from_corner(1);
  if (corners.size() == 2) return {u[1], -u[0], R(0)};
  const Vec3<R> area = u.cross(from_corner(static_cast<int>(corners.size()) - 1));
  return area / R(corners.size() == 4 ? 4 : 2);
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
                                                  name_of_vertex(v), warnings, least);
  const std::vector<NormalPlace> places = normal_places(rest);
  for (std::size_t i = 0; i < places.size(); ++i) {
    local.of_normals[i] = rotation_or_warning<R>(other * global.of_normals[i] + share * local.of_normals[i],
                                                 name_of_place(rest, places[i]), warnings, least);
    local.stretches[i] = other * global.stretches[i] + share * local.stretches[i];
  }
  return local;
}

template <Scalar R>
std::vector<SpaceMatrix<R>> vertex_rotations(const CageElements& rest, const std::vector<Vec3<R>>& posed,
                                             std::vector<std::string>& warnings) {
  const R unit(unit_next_to(size_of(rest)));
  return local_turns<R>(rest, over(vertices_in<R>(rest), unit), over(posed, unit), {}, warnings).of_vertices;
}

#define CAGEPROOF_INSTANTIATE(R)                                                                               \
  template Vec3<R> area_vector<R>(const CageElements&, const std::vector<Vec3<R>>&, const NormalPlace&);       \
  template Turns<R> turns_of<R>(const CageElements&, const std::vector<Vec3<R>>&, const std::vector<Vec3<R>>&, \
                                const std::function<std::vector<R>()>&, double, std::vector<std::string>&);    \
  template std::vector<SpaceMatrix<R>> vertex_rotations<R>(const CageElements&, const std::vector<Vec3<R>>&,   \
                                                           std::vector<std::string>&);
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::deformation
