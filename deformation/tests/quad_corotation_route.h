// SPDX-License-Identifier: MIT
// [C23] Section 4 on quads that are kept, by another route, in 50 digits: one facet per triangle and per quad's corner.
#pragma once

#include "quad_routes.h"
#include "somigliana_routes.h"

namespace cageproof::deformation::test {

/// Where a traction is: tangents there, at rest and posed, and what the traction multiplies.
struct Facet {
  std::size_t element;
  std::array<Wide, 2> rest, posed;
  Wide area;    ///< vector, of the rest element, weighted with the corner's basis function
  Wide normal;  ///< that the coordinate multiplies: of unit length
};

/// The columns along the first tangent, across it, and the normal.
inline Mp frame_of(const std::array<Wide, 2>& tangents) {
  const Wide along = tangents[0] / length_of(tangents[0]);
  const Wide normal = tangents[0].cross(tangents[1]);
  Mp found(3, 3);
  found << along, (normal / length_of(normal)).cross(along), normal / length_of(normal);
  return found;
}

inline std::vector<Facet> facets_of(const CageElements& elements, const std::vector<Vec>& posed_vertices) {
  std::vector<Facet> all;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const BilinearRoute rest(elements, elements.vertices(), e), posed(elements, posed_vertices, e);
    if (!rest.is_quad()) {
      const Wide area = rest.corner_area(0) / Mp50(2);
      all.push_back(
          {e, {rest.by_u(0), rest.by_v(0)}, {posed.by_u(0), posed.by_v(0)}, area, Wide(area / length_of(area))});
      continue;
    }
    for (int k = 0; k < 4; ++k) {
      // Means over the quad, weighted with the basis function.
      std::array<Wide, 2> at_rest{Wide::Zero(), Wide::Zero()}, in_pose = at_rest;
      sum_over(rest, 3, [&](const Mp50& u, const Mp50& v, const Mp50& weight) {
        const Mp50 share = 4 * weight * rest.basis(u, v)[k];
        at_rest[0] += share * rest.by_u(v), at_rest[1] += share * rest.by_v(u);
        in_pose[0] += share * posed.by_u(v), in_pose[1] += share * posed.by_v(u);
      });
      const Wide area = rest.corner_area(k);
      all.push_back({e, at_rest, in_pose, Wide(area / Mp50(4)), Wide(area / length_of(area))});
    }
  }
  return all;
}

/// The solid angle of the vertex normals of each element: the angles of the spherical polygon, less those of a flat
/// one.
inline std::vector<Mp50> spreads_route(const CageElements& elements, const std::vector<Vec>& vertices) {
  std::vector<Wide> normals(vertices.size(), Wide::Zero());
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const BilinearRoute shape(elements, vertices, e);
    Wide area = Wide::Zero();
    sum_over(shape, 3, [&](const Mp50& u, const Mp50& v, const Mp50& weight) { area += weight * shape.area(u, v); });
    for (const int v : elements.vertices_of(e)) normals[v] += area;
  }
  for (Wide& n : normals) n /= length_of(n);
  std::vector<Mp50> found;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto corners = elements.vertices_of(e);
    const int n = static_cast<int>(corners.size());
    Mp50 excess = -(n - 2) * pi<Mp50>();
    for (int k = 0; k < n; ++k) {
      const Wide &at = normals[corners[k]], &next = normals[corners[(k + 1) % n]],
                 &before = normals[corners[(k + n - 1) % n]];
      const Wide to_next = next - at.dot(next) * at, to_before = before - at.dot(before) * at;
      Mp50 angle = atan2(Mp50(at.dot(to_next.cross(to_before))), Mp50(to_next.dot(to_before)));
      if (angle < 0) angle += 2 * pi<Mp50>();
      excess += angle;
    }
    found.push_back(excess);
  }
  return found;
}

/// What Eq 11 takes of a pose: rotations, and balanced tractions s'_j m_j.
struct QuadCorotationRoute {
  std::vector<Facet> facets;
  std::vector<Mp> of_vertices, of_facets, tractions;

  QuadCorotationRoute(const CageElements& elements, const std::vector<Vec>& posed, bool local, double nu, double gamma)
      : facets(facets_of(elements, posed)) {
    const std::size_t n = posed.size();
    std::vector<Mp50> stretches;
    of_vertices.assign(n, Mp::Zero(3, 3));
    for (const Facet& f : facets) {
      const Mp map = flat(f.posed[0], f.posed[1]) * Eigen::FullPivLU<Mp>(flat(f.rest[0], f.rest[1])).inverse();
      const Mp50 cosine = (map(0, 0) + map(1, 1)) / 2, sine = (map(1, 0) - map(0, 1)) / 2,
                 mean = sqrt(Mp50(cosine * cosine + sine * sine));
      Mp turn = Mp::Identity(3, 3);
      turn.topLeftCorner(2, 2) << cosine / mean, -sine / mean, sine / mean, cosine / mean;
      stretches.push_back(mean);
      of_facets.push_back(frame_of(f.posed) * turn * frame_of(f.rest).transpose());
      for (const int v : elements.vertices_of(f.element)) of_vertices[v] += length_of(f.area) * of_facets.back();
    }
    for (Mp& sum : of_vertices) sum = rotation_along(sum);
    if (!local) {
      Wide middle = Wide::Zero(), posed_middle = Wide::Zero();
      for (std::size_t v = 0; v < n; ++v) {
        middle += convert<Mp50>(elements.vertices()[v]) / Mp50(n);
        posed_middle += convert<Mp50>(posed[v]) / Mp50(n);
      }
      Mp h = Mp::Zero(3, 3);
      Mp50 size = 0;
      for (std::size_t v = 0; v < n; ++v) {
        const Wide from = convert<Mp50>(elements.vertices()[v]) - middle;
        h += Wide(convert<Mp50>(posed[v]) - posed_middle) * from.transpose();
        size += from.dot(from);
      }
      const Mp rotation = rotation_along(h);
      of_vertices.assign(n, rotation);
      of_facets.assign(facets.size(), rotation);
      stretches.assign(facets.size(), Mp50(h.cwiseProduct(rotation).sum() / size));
    }
    const Mp50 ratio = Mp50(nu) / (1 - 2 * Mp50(nu));
    const auto before = spreads_route(elements, elements.vertices()), after = spreads_route(elements, posed);
    Mp sides = Mp::Zero(3, 3), uneven = Mp::Zero(3, 1);
    std::vector<Mp> directions;
    std::vector<Mp50> sizes;
    for (std::size_t i = 0; i < facets.size(); ++i) {
      const Mp50 bulge = Mp50(gamma) * (after[facets[i].element] - before[facets[i].element]) / (4 * pi<Mp50>());
      const Mp50 eta = stretches[i] * exp(bulge);
      sizes.push_back(2 * (eta + ratio * (eta + 2 * stretches[i])));
      directions.push_back(of_facets[i] * facets[i].normal);
      sides += length_of(facets[i].area) * directions[i] * directions[i].transpose();
      uneven += length_of(facets[i].area) * sizes[i] * directions[i];
    }
    const Mp xi = Eigen::FullPivLU<Mp>(sides).solve(uneven);
    for (std::size_t i = 0; i < facets.size(); ++i)
      tractions.push_back((sizes[i] - Mp50((directions[i].transpose() * xi)(0, 0))) * directions[i]);
  }
};

}  // namespace cageproof::deformation::test
