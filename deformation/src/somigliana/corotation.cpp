// SPDX-License-Identifier: MIT
#include "corotation.h"

#include "../own_unit.h"

#include "../nearest_rotation.h"

#include "cageproof/core/input_error.h"
#include "cageproof/deformation/stretch.h"

#include <Eigen/Dense>

#include <fmt/format.h>

#include <cmath>

namespace cageproof::deformation {
namespace {

template <Scalar R>
using Column = Eigen::Matrix<R, Eigen::Dynamic, 1>;

template <Scalar R>
Column<R> in(int d, const Vec3<R>& v) {
  return v.head(d);
}

// Up to the rounding of what it is found from.
template <Scalar R>
NearestRotation<R> rotation_nearest_to(const Matrix<R>& matrix) {
  return nearest_rotation<R>(matrix, 64 * unit_roundoff<R>());
}

template <Scalar R>
std::vector<Vec3<R>> over(std::vector<Vec3<R>> points, const R& unit) {
  for (Vec3<R>& p : points) p /= unit;
  return points;
}

template <Scalar R>
R measure(const CageElements& rest, const std::vector<Vec3<R>>& vertices, std::size_t element) {
  using std::sqrt;
  const auto corners = rest.vertices_of(element);
  const Vec3<R> u = vertices[corners[1]] - vertices[corners[0]];
  if (corners.size() == 2) return sqrt(R(u.dot(u)));
  const Vec3<R> area = u.cross(Vec3<R>(vertices[corners[2]] - vertices[corners[0]]));
  return sqrt(R(area.dot(area))) / 2;
}

// How much the vertex normals of each element spread: the angle between the two, or the solid angle of the three;
// positive where the cage is convex.
template <Scalar R>
std::vector<R> spreads(const CageElements& rest, const std::vector<Vec3<R>>& vertices) {
  using std::atan2, std::sqrt;
  std::vector<Vec3<R>> of_vertices(vertices.size(), Vec3<R>::Zero());
  std::vector<R> around(vertices.size(), R(0));
  for (std::size_t e = 0; e < rest.count(); ++e) {
    const R size = measure(rest, vertices, e);
    const Vec3<R> weighted = size * posed_normal(rest, vertices, e);
    for (const int v : rest.vertices_of(e)) of_vertices[v] += weighted, around[v] += size;
  }
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const R length = sqrt(R(of_vertices[v].dot(of_vertices[v])));
    if (!(length > 64 * unit_roundoff<R>() * around[v]))
      throw InputError(fmt::format("the normals around vertex {} add up to nothing: it has no spread", v));
    of_vertices[v] /= length;
  }
  std::vector<R> found;
  found.reserve(rest.count());
  for (std::size_t e = 0; e < rest.count(); ++e) {
    const auto corners = rest.vertices_of(e);
    const Vec3<R>&a = of_vertices[corners[0]], &b = of_vertices[corners[1]];
    if (corners.size() == 2) {
      found.push_back(atan2(R(a[0] * b[1] - a[1] * b[0]), R(a.dot(b))));
      continue;
    }
    const Vec3<R>& c = of_vertices[corners[2]];
    found.push_back(2 * atan2(R(a.dot(b.cross(c))), R(1 + a.dot(b) + b.dot(c) + c.dot(a))));
  }
  return found;
}

template <Scalar R>
R wrapped(R angle) {
  const R turn = 2 * pi<R>();
  while (angle > turn / 2) angle -= turn;
  while (angle <= -turn / 2) angle += turn;
  return angle;
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

// Of vertices and elements, and the stretches of elements.
template <Scalar R>
struct Turns {
  std::vector<Matrix<R>> of_vertices, of_elements;
  std::vector<R> stretches;
};

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

// Stretches are averaged as numbers; rotations as matrices, whose nearest rotation is taken, as around vertices.
template <Scalar R>
Turns<R> turns_of(const CageElements& rest, const std::vector<Vec3<R>>& from, const std::vector<Vec3<R>>& posed,
                  const auto& stretches, double blend, std::vector<std::string>& warnings) {
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

}  // namespace

template <Scalar R>
Corotation<R> corotation_of(const CageElements& rest, const std::vector<Vec3<R>>& given,
                            const CorotationOptions& options) {
  using std::exp;
  const int d = rest.dimension();
  // Rotations, tractions and their balance do not depend on the unit of length; squares of areas leave the range in
  // the user's.
  const R unit(unit_next_to(size_of(rest)));
  const std::vector<Vec3<R>> from = over(vertices_in<R>(rest), unit), posed = over(given, unit);
  const auto local_stretches = [&] {
    std::vector<R> found;
    found.reserve(rest.count());
    for (std::size_t e = 0; e < rest.count(); ++e) found.push_back(stretch_of(Stretch::Mean, rest, given, e));
    return found;
  };
  Corotation<R> found;
  Turns<R> turns = turns_of(rest, from, posed, local_stretches, options.blend, found.warnings);
  found.of_vertices = std::move(turns.of_vertices);
  found.of_elements = std::move(turns.of_elements);
  const std::vector<R>& stretches = turns.stretches;
  std::vector<R> bulges(rest.count(), R(0));
  if (options.gamma != 0) {
    const std::vector<R> before = spreads(rest, from), after = spreads(rest, posed);
    for (std::size_t e = 0; e < rest.count(); ++e)
      bulges[e] = d == 2 ? wrapped(R(after[e] - before[e])) : R(after[e] - before[e]);
  }
  // nu/(1 - 2 nu), -1/2 in the limit.
  const R volume = std::isinf(options.nu) ? R(-0.5) : R(R(options.nu) / (1 - 2 * R(options.nu)));
  Matrix<R> sides = Matrix<R>::Zero(d, d);
  Column<R> uneven = Column<R>::Zero(d);
  std::vector<Column<R>> normals;
  for (std::size_t e = 0; e < rest.count(); ++e) {
    const Column<R> m = found.of_elements[e] * in<R>(d, posed_normal(rest, from, e));
    const R eta = stretches[e] * R(exp(R(R(options.gamma) * bulges[e] / ((d == 2 ? 2 : 4) * pi<R>()))));
    const R s = 2 * (eta + volume * (eta + (d - 1) * stretches[e]));
    const R area = measure(rest, from, e);
    sides += area * m * m.transpose();
    uneven += area * s * m;
    normals.push_back(m);
    Vec3<R> traction = Vec3<R>::Zero();
    traction.head(d) = s * m;
    found.tractions.push_back(traction);
  }
  if (!options.balance) return found;
  // Eq 15: what the tractions leave over is taken back from each along its normal.
  Eigen::CompleteOrthogonalDecomposition<Matrix<R>> solver;
  solver.setThreshold(R(1e-13));
  solver.compute(sides);
  const Column<R> xi = solver.solve(uneven);
  for (std::size_t e = 0; e < rest.count(); ++e) found.tractions[e].head(d) -= normals[e] * normals[e].dot(xi);
  return found;
}

template <Scalar R>
std::vector<Matrix<R>> vertex_rotations(const CageElements& rest, const std::vector<Vec3<R>>& posed,
                                        std::vector<std::string>& warnings) {
  const R unit(unit_next_to(size_of(rest)));
  return local_turns<R>(rest, over(vertices_in<R>(rest), unit), over(posed, unit), {}, warnings).of_vertices;
}

template std::vector<Matrix<double>> vertex_rotations<double>(const CageElements&, const std::vector<Vec3<double>>&,
                                                              std::vector<std::string>&);
template std::vector<Matrix<Mp50>> vertex_rotations<Mp50>(const CageElements&, const std::vector<Vec3<Mp50>>&,
                                                          std::vector<std::string>&);
template Corotation<double> corotation_of<double>(const CageElements&, const std::vector<Vec3<double>>&,
                                                  const CorotationOptions&);
template Corotation<Mp50> corotation_of<Mp50>(const CageElements&, const std::vector<Vec3<Mp50>>&,
                                              const CorotationOptions&);

}  // namespace cageproof::deformation
