// SPDX-License-Identifier: MIT
#include "corotation.h"

#include "../own_unit.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/numbers/least_squares.h"
#include "cageproof/deformation/stretch.h"

#include <fmt/format.h>

#include <cmath>

namespace cageproof::deformation {
namespace {

// Half the solid angle of three unit vectors.
template <Scalar R>
R half_angle(const Vec3<R>& a, const Vec3<R>& b, const Vec3<R>& c) {
  using std::atan2;
  return atan2(R(a.dot(b.cross(c))), R(1 + a.dot(b) + b.dot(c) + c.dot(a)));
}

// The sum of the normals around each vertex, of unit length.
template <Scalar R>
std::vector<Vec3<R>> vertex_normals(const CageElements& rest, const std::vector<Vec3<R>>& vertices) {
  using std::sqrt;
  std::vector<Vec3<R>> found(vertices.size(), Vec3<R>::Zero());
  std::vector<R> around(vertices.size(), R(0));
  for (std::size_t e = 0; e < rest.count(); ++e) {
    Vec3<R> weighted = Vec3<R>::Zero();
    R size = 0;
    for (std::size_t k = 0; k < rest.shares_of(e, Owner::Normal).size(); ++k) {
      const Vec3<R> area = area_vector(rest, vertices, {e, static_cast<int>(k)});
      weighted += area;
      size += area.norm();
    }
    // Refuses an element without area by its name.
    if (!(size > 0)) posed_normal(rest, vertices, e);
    for (const int v : rest.vertices_of(e)) found[v] += weighted, around[v] += size;
  }
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const R length = sqrt(R(found[v].dot(found[v])));
    if (!(length > 64 * unit_roundoff<R>() * around[v]))
      throw InputError(fmt::format("the normals around vertex {} add up to nothing: it has no spread", v));
    found[v] /= length;
  }
  return found;
}

// How much the vertex normals of each element spread: the angle between the two, or the solid angle of the three or
// four; positive where the cage is convex. That of four does not hang on the diagonal that it is cut along.
template <Scalar R>
std::vector<R> spreads(const CageElements& rest, const std::vector<Vec3<R>>& vertices) {
  using std::atan2;
  const std::vector<Vec3<R>> of_vertices = vertex_normals(rest, vertices);
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
    R half = half_angle(a, b, c);
    if (corners.size() == 4) half += half_angle(a, c, of_vertices[corners[3]]);
    found.push_back(2 * half);
  }
  return found;
}

}  // namespace

// A quad's coordinate has been multiplied with its area element in
// double, which is divided by here, so that it cancels in any scalar.
template <Scalar R>
Vec3<R> rest_normal(const CageElements& rest, const std::vector<Vec3<R>>& from, const R& unit, const NormalPlace& at,
                    std::size_t coordinate) {
  if (rest.type(at.element).flat) return posed_normal(rest, from, at.element);
  return 4 * area_vector(rest, from, at) / R(R(rest.area_element_of(coordinate, Owner::Normal)) / unit / unit);
}

template <Scalar R>
R volume_factor(double nu) {
  return std::isinf(nu) ? R(-0.5) : R(R(nu) / (1 - 2 * R(nu)));
}

namespace {

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
  const std::vector<NormalPlace> places = normal_places(rest);
  const auto local_stretches = [&] {
    std::vector<R> found;
    found.reserve(places.size());
    for (const NormalPlace& at : places) found.push_back(stretch_of(Stretch::Mean, rest, given, at.element, at.corner));
    return found;
  };
  Corotation<R> found;
  Turns<R> turns = turns_of<R>(rest, from, posed, local_stretches, options.blend, found.warnings);
  found.of_vertices = std::move(turns.of_vertices);
  found.of_normals = std::move(turns.of_normals);
  const std::vector<R>& stretches = turns.stretches;
  std::vector<R> bulges(rest.count(), R(0));
  if (options.gamma != 0) {
    const std::vector<R> before = spreads(rest, from), after = spreads(rest, posed);
    for (std::size_t e = 0; e < rest.count(); ++e)
      bulges[e] = d == 2 ? wrapped(R(after[e] - before[e])) : R(after[e] - before[e]);
  }
  const R volume = volume_factor<R>(options.nu);
  SpaceMatrix<R> sides = SpaceMatrix<R>::Zero(d, d);
  SpaceVector<R> uneven = SpaceVector<R>::Zero(d);
  std::vector<SpaceVector<R>> normals;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const SpaceVector<R> m = found.of_normals[i] * in<R>(d, rest_normal(rest, from, unit, places[i], i));
    const R bulge = bulges[places[i].element];
    const R eta = stretches[i] * R(exp(R(R(options.gamma) * bulge / ((d == 2 ? 2 : 4) * pi<R>()))));
    const R s = 2 * (eta + volume * (eta + (d - 1) * stretches[i]));
    const R area = area_vector(rest, from, places[i]).norm();
    sides += area * m * m.transpose();
    uneven += area * s * m;
    normals.push_back(m);
    Vec3<R> traction = Vec3<R>::Zero();
    traction.head(d) = s * m;
    found.tractions.push_back(traction);
  }
  // Where a rotation is not finite, images are not, either.
  if (!options.balance || !sides.allFinite()) return found;
  // Eq 15: what the tractions leave over is taken back from each along its normal.
  const SpaceVector<R> xi = LeastSquares<R>(sides).solve(uneven);
  for (std::size_t i = 0; i < places.size(); ++i) found.tractions[i].head(d) -= normals[i] * normals[i].dot(xi);
  return found;
}

template Vec3<double> rest_normal<double>(const CageElements&, const std::vector<Vec3<double>>&, const double&,
                                          const NormalPlace&, std::size_t);
template Vec3<Mp50> rest_normal<Mp50>(const CageElements&, const std::vector<Vec3<Mp50>>&, const Mp50&,
                                      const NormalPlace&, std::size_t);
template double volume_factor<double>(double);
template Mp50 volume_factor<Mp50>(double);
template Corotation<double> corotation_of<double>(const CageElements&, const std::vector<Vec3<double>>&,
                                                  const CorotationOptions&);
template Corotation<Mp50> corotation_of<Mp50>(const CageElements&, const std::vector<Vec3<Mp50>>&,
                                              const CorotationOptions&);

}  // namespace cageproof::deformation
