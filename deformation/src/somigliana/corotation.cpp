// SPDX-License-Identifier: MIT
#include "corotation.h"

#include "../own_unit.h"
#include "../turns.h"

#include "cageproof/core/input_error.h"
#include "cageproof/deformation/stretch.h"

#include <Eigen/Dense>

#include <fmt/format.h>

#include <cmath>

namespace cageproof::deformation {
namespace {

template <Scalar R>
using Column = Eigen::Matrix<R, Eigen::Dynamic, 1>;

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
  Turns<R> turns = turns_of<R>(rest, from, posed, local_stretches, options.blend, found.warnings);
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

template Corotation<double> corotation_of<double>(const CageElements&, const std::vector<Vec3<double>>&,
                                                  const CorotationOptions&);
template Corotation<Mp50> corotation_of<Mp50>(const CageElements&, const std::vector<Vec3<Mp50>>&,
                                              const CorotationOptions&);

}  // namespace cageproof::deformation
