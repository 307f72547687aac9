// SPDX-License-Identifier: MIT
// Bilinear quads by their definitions, in 50 digits: points, tangents, stretches by singular values, and integrals by
// plain sums.
#pragma once

#include "regularised_routes.h"

#include "cageproof/core/numbers/gauss_legendre.h"

#include <Eigen/Eigenvalues>

#include <functional>

namespace cageproof::deformation::test {

using Wide = Vec3<Mp50>;

inline Mp50 length_of(const Wide& v) { return sqrt(Mp50(v.dot(v))); }

/// A quad's, or a triangle's as a quad whose last two corners are one.
struct BilinearRoute {
  std::vector<Wide> q;

  BilinearRoute(const CageElements& elements, const std::vector<Vec>& vertices, std::size_t e) {
    for (const int v : elements.vertices_of(e)) q.push_back(convert<Mp50>(vertices[v]));
  }
  bool is_quad() const { return q.size() == 4; }
  /// Basis functions of the corners: bilinear ones, or hat functions at u, v (1 - u).
  std::vector<Mp50> basis(const Mp50& u, const Mp50& v) const {
    if (is_quad()) return {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
    return {(1 - u) * (1 - v), u, v * (1 - u)};
  }
  Wide point(const Mp50& u, const Mp50& v) const {
    Wide sum = Wide::Zero();
    const auto b = basis(u, v);
    for (std::size_t k = 0; k < q.size(); ++k) sum += b[k] * q[k];
    return sum;
  }
  Wide by_u(const Mp50& v) const {
    return is_quad() ? Wide((1 - v) * (q[1] - q[0]) + v * (q[2] - q[3])) : Wide(q[1] - q[0]);
  }
  Wide by_v(const Mp50& u) const {
    return is_quad() ? Wide((1 - u) * (q[3] - q[0]) + u * (q[2] - q[1])) : Wide(q[2] - q[0]);
  }
  Wide area(const Mp50& u, const Mp50& v) const { return by_u(v).cross(by_v(u)); }
  Wide corner_area(std::size_t k) const {
    const std::size_t n = q.size();
    return (q[(k + 1) % n] - q[k]).cross(q[(k + n - 1) % n] - q[k]);
  }
};

/// Sums over [0, 1]^2; of triangles with the area element 1 - u of their coordinates.
inline void sum_over(const BilinearRoute& of, int points,
                     const std::function<void(const Mp50& u, const Mp50& v, const Mp50& weight)>& add) {
  const GaussLegendre<Mp50>& rule = gauss_legendre<Mp50>(points);
  for (int i = 0; i < points; ++i)
    for (int j = 0; j < points; ++j)
      add(rule.nodes[i], rule.nodes[j],
          rule.weights[i] * rule.weights[j] * (of.is_quad() ? Mp50(1) : Mp50(1 - rule.nodes[i])));
}

/// Coordinates of tangents in an orthonormal frame of their plane, as columns.
inline Mp flat(const Wide& a, const Wide& b) {
  const Wide along = a / length_of(a);
  const Wide across = b - along.dot(b) * along;
  Mp found(2, 2);
  found << along.dot(a), along.dot(b), 0, length_of(across);
  return found;
}

enum StretchRoute { kRms, kMean, kArea, kUnit, kProduct };

/// By the singular values of the map from the rest tangents to the posed ones.
inline Mp50 stretch_route(StretchRoute which, const Mp& rest, const Mp& posed) {
  const Mp map = posed * Eigen::FullPivLU<Mp>(rest).inverse();
  const Mp squares = Eigen::SelfAdjointEigenSolver<Mp>(Mp(map.transpose() * map)).eigenvalues();
  const Mp50 s1 = sqrt(squares(1, 0)), s2 = sqrt(squares(0, 0));
  switch (which) {
    case kRms: return sqrt(Mp50((s1 * s1 + s2 * s2) / 2));
    case kMean: return (s1 + s2) / 2;
    case kArea: return sqrt(Mp50(s1 * s2));
    case kUnit: return 1;
    case kProduct: break;
  }
  return s1 * s2;
}

/// The factors of the layers, without area elements: sigma_k N'_k for a quad's corners, s n' for a triangle.
inline std::vector<Wide> neumann_route(StretchRoute which, const BilinearRoute& rest, const BilinearRoute& posed,
                                       int points = 40) {
  const auto stretch_at = [&](const Mp50& u, const Mp50& v) {
    return stretch_route(which, flat(rest.by_u(v), rest.by_v(u)), flat(posed.by_u(v), posed.by_v(u)));
  };
  if (!rest.is_quad()) {
    const Wide area = posed.area(0, 0);
    return {Wide(stretch_at(0, 0) / length_of(area) * area)};
  }
  std::vector<Mp50> stretched(4), turned(4);
  sum_over(rest, points, [&](const Mp50& u, const Mp50& v, const Mp50& weight) {
    const auto basis = rest.basis(u, v);
    const Mp50 area = weight * stretch_at(u, v) * length_of(rest.area(u, v)),
               posed_area = weight * length_of(posed.area(u, v));
    for (int k = 0; k < 4; ++k) stretched[k] += basis[k] * area, turned[k] += basis[k] * posed_area;
  });
  std::vector<Wide> found;
  for (int k = 0; k < 4; ++k) found.emplace_back(stretched[k] / turned[k] * posed.corner_area(k));
  return found;
}

}  // namespace cageproof::deformation::test
