// SPDX-License-Identifier: MIT
// [C23] Section 4 by another route, in 50 digits: rotations by quaternions, angles and frames in place of singular
// values, solid angles as spherical excesses, Eq 15 as a dense system, Eq 10 as it stands, without solving for x'.
#pragma once

#include "regularised_routes.h"

#include <Eigen/Eigenvalues>

namespace cageproof::deformation::test {

using Wide = Vec3<Mp50>;

inline Mp column(const Wide& v, int d) { return v.head(d); }

/// The rotation that maximises trace(R^T h): Horn's quaternion (1987) in space, an angle in the plane.
inline Mp rotation_along(const Mp& h) {
  if (h.rows() == 2) {
    const Mp50 cosine = h(0, 0) + h(1, 1), sine = h(1, 0) - h(0, 1), length = sqrt(Mp50(cosine * cosine + sine * sine));
    Mp r(2, 2);
    r << cosine / length, -sine / length, sine / length, cosine / length;
    return r;
  }
  Mp n(4, 4);
  n << h(0, 0) + h(1, 1) + h(2, 2), h(2, 1) - h(1, 2), h(0, 2) - h(2, 0), h(1, 0) - h(0, 1),  //
      h(2, 1) - h(1, 2), h(0, 0) - h(1, 1) - h(2, 2), h(1, 0) + h(0, 1), h(0, 2) + h(2, 0),   //
      h(0, 2) - h(2, 0), h(1, 0) + h(0, 1), h(1, 1) - h(0, 0) - h(2, 2), h(2, 1) + h(1, 2),   //
      h(1, 0) - h(0, 1), h(0, 2) + h(2, 0), h(2, 1) + h(1, 2), h(2, 2) - h(0, 0) - h(1, 1);
  const Mp q = Eigen::SelfAdjointEigenSolver<Mp>(n).eigenvectors().col(3);
  const Mp50 w = q(0), x = q(1), y = q(2), z = q(3);
  Mp r(3, 3);
  r << 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),   //
      2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y);
  return r;
}

/// A cage somewhere: measures, unit normals and spreads of its elements.
struct CageShape {
  const CageElements& rest;
  std::vector<Wide> vertices;

  int d() const { return rest.dimension(); }
  Wide corner(std::size_t e, int k) const { return vertices[rest.vertices_of(e)[k]]; }
  Wide edge(std::size_t e, int k) const { return corner(e, k) - corner(e, 0); }
  /// As long as the element's measure.
  Wide area(std::size_t e) const {
    const Wide u = edge(e, 1);
    if (d() == 2) return {u[1], -u[0], Mp50(0)};
    return Wide(u.cross(edge(e, 2))) / Mp50(2);
  }
  Mp50 measure(std::size_t e) const { return sqrt(Mp50(area(e).dot(area(e)))); }
  Wide normal(std::size_t e) const { return area(e) / measure(e); }
  /// Columns: along the first edge, across it within the triangle, and the normal.
  Mp frame(std::size_t e) const {
    const Wide along = edge(e, 1) / Mp50(sqrt(Mp50(edge(e, 1).dot(edge(e, 1)))));
    Mp found(d(), d());
    if (d() == 2) found << column(along, 2), column(normal(e), 2);
    else found << along, normal(e).cross(along), normal(e);
    return found;
  }
  Wide vertex_normal(int v) const {
    Wide sum = Wide::Zero();
    for (std::size_t e = 0; e < rest.count(); ++e)
      for (const int other : rest.vertices_of(e))
        if (other == v) sum += area(e);
    return sum / Mp50(sqrt(Mp50(sum.dot(sum))));
  }
  /// The angle from the first vertex normal to the second, or the spherical triangle's angles over two right ones.
  Mp50 spread(std::size_t e) const {
    const auto corners = rest.vertices_of(e);
    std::vector<Wide> n;
    for (const int v : corners) n.push_back(vertex_normal(v));
    if (d() == 2) {
      const Mp50 angle = acos(std::min(Mp50(n[0].dot(n[1])), Mp50(1)));
      return n[0][0] * n[1][1] < n[0][1] * n[1][0] ? Mp50(-angle) : angle;
    }
    const Mp50 triple = n[0].dot(n[1].cross(n[2]));
    if (abs(triple) < Mp50("1e-40")) return Mp50(0);
    Mp50 excess = -pi<Mp50>();
    for (int k = 0; k < 3; ++k) {
      const Wide &at = n[k], &one = n[(k + 1) % 3], &other = n[(k + 2) % 3];
      const Wide to_one = one - at.dot(one) * at, to_other = other - at.dot(other) * at;
      excess += acos(Mp50(to_one.dot(to_other) / sqrt(Mp50(to_one.dot(to_one) * to_other.dot(to_other)))));
    }
    return triple < 0 ? Mp50(-excess) : excess;
  }
};

/// What Eq 11 takes of a pose.
struct CorotationRoute {
  std::vector<Mp> of_vertices, of_elements;
  std::vector<Mp50> measures, stretches, tractions, balanced;  ///< s_j and s'_j
  std::vector<Mp> directions;                                  ///< m_j

  CorotationRoute(const CageElements& rest, const std::vector<Vec>& posed, bool local, double nu, double gamma) {
    CageShape before{rest, {}}, after{rest, {}};
    for (const Vec& v : rest.vertices()) before.vertices.push_back(convert<Mp50>(v));
    for (const Vec& v : posed) after.vertices.push_back(convert<Mp50>(v));
    if (local) turn_each(before, after);
    else turn_all(before, after);
    const Mp50 ratio = std::isinf(nu) ? Mp50("-0.5") : Mp50(Mp50(nu) / (1 - 2 * Mp50(nu)));
    const int d = rest.dimension();
    for (std::size_t e = 0; e < rest.count(); ++e) {
      directions.push_back(of_elements[e] * column(before.normal(e), d));
      measures.push_back(before.measure(e));
      Mp50 beta = 0;
      if (gamma != 0) beta = after.spread(e) - before.spread(e);
      if (d == 2 && beta > pi<Mp50>()) beta -= 2 * pi<Mp50>();
      if (d == 2 && beta <= -pi<Mp50>()) beta += 2 * pi<Mp50>();
      const Mp50 eta = stretches[e] * exp(Mp50(Mp50(gamma) * beta / (d == 2 ? 2 : 4) / pi<Mp50>()));
      tractions.push_back(2 * (eta + ratio * (eta + (d - 1) * stretches[e])));
    }
    balance(d);
  }

 private:
  // The similarity of all vertices: the stretch that goes with a rotation is linear least squares.
  void turn_all(const CageShape& before, const CageShape& after) {
    const int d = before.d();
    const std::size_t n = before.vertices.size();
    Wide middle = Wide::Zero(), posed_middle = Wide::Zero();
    for (std::size_t v = 0; v < n; ++v)
      middle += before.vertices[v] / Mp50(n), posed_middle += after.vertices[v] / Mp50(n);
    Mp h = Mp::Zero(d, d);
    Mp50 size = 0;
    for (std::size_t v = 0; v < n; ++v) {
      const Mp from = column(before.vertices[v] - middle, d);
      h += column(after.vertices[v] - posed_middle, d) * from.transpose();
      size += from.squaredNorm();
    }
    const Mp rotation = rotation_along(h);
    of_vertices.assign(n, rotation);
    of_elements.assign(before.rest.count(), rotation);
    stretches.assign(before.rest.count(), Mp50(h.cwiseProduct(rotation).sum() / size));
  }

  // A map of the plane is a turn with a stretch, and the like of a mirrored vector: of positive determinant it
  // stretches by (sigma1 + sigma2)/2 and turns by the angle of the first.
  void turn_each(const CageShape& before, const CageShape& after) {
    const int d = before.d();
    of_vertices.assign(before.vertices.size(), Mp::Zero(d, d));
    for (std::size_t e = 0; e < before.rest.count(); ++e) {
      const Mp from = before.frame(e), to = after.frame(e);
      Mp turn = Mp::Identity(d, d);
      if (d == 2) {
        stretches.push_back(after.measure(e) / before.measure(e));
      } else {
        Mp edges(3, 2), posed_edges(3, 2);
        edges << before.edge(e, 1), before.edge(e, 2);
        posed_edges << after.edge(e, 1), after.edge(e, 2);
        const Mp flat = (from.transpose() * edges).topRows(2), posed_flat = (to.transpose() * posed_edges).topRows(2);
        const Mp map = posed_flat * Eigen::FullPivLU<Mp>(flat).inverse();
        const Mp50 cosine = (map(0, 0) + map(1, 1)) / 2, sine = (map(1, 0) - map(0, 1)) / 2;
        stretches.push_back(sqrt(Mp50(cosine * cosine + sine * sine)));
        turn(0, 0) = turn(1, 1) = cosine / stretches[e];
        turn(1, 0) = sine / stretches[e];
        turn(0, 1) = -turn(1, 0);
      }
      of_elements.push_back(to * turn * from.transpose());
      for (const int v : before.rest.vertices_of(e)) of_vertices[v] += before.measure(e) * of_elements[e];
    }
    for (Mp& sum : of_vertices) sum = rotation_along(sum);
  }

  // Least sum A_j (s'_j - s_j)^2 / 2 with sum A_j s'_j m_j = 0: its stationary point, multipliers included.
  void balance(int d) {
    const int m = static_cast<int>(measures.size());
    Mp matrix = Mp::Zero(m + d, m + d), right = Mp::Zero(m + d, 1);
    for (int e = 0; e < m; ++e) {
      matrix(e, e) = measures[e];
      matrix.block(e, m, 1, d) = measures[e] * directions[e].transpose();
      matrix.block(m, e, d, 1) = measures[e] * directions[e];
      right(e, 0) = measures[e] * tractions[e];
    }
    const Mp solution = Eigen::FullPivLU<Mp>(matrix).solve(right);
    for (int e = 0; e < m; ++e) balanced.push_back(solution(e, 0));
  }
};

}  // namespace cageproof::deformation::test
