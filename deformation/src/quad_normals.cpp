// SPDX-License-Identifier: MIT
#include "quad_normals.h"

#include "posed_range.h"
#include "stretched_squares.h"

#include "cageproof/core/numbers/gauss_legendre.h"
#include "cageproof/core/input_error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace cageproof::deformation {
namespace {

// A quad's sides, in a unit in which the largest number is one: what tangents are made of.
template <Scalar R>
struct Sides {
  Quad<R> along;  ///< from each corner to the next
  R unit = 0;

  explicit Sides(const Quad<R>& q) {
    for (int k = 0; k < 4; ++k) {
      along[k] = q[(k + 1) % 4] - q[k];
      unit = std::max<R>(unit, along[k].cwiseAbs().maxCoeff());
    }
    if (unit > 0)
      for (Vec3<R>& side : along) side /= unit;
  }
  Vec3<R> by_u(const R& v) const { return (1 - v) * along[0] - v * along[2]; }
  Vec3<R> by_v(const R& u) const { return u * along[1] - (1 - u) * along[3]; }
  Vec3<R> corner_normal(int k) const { return along[(k + 3) % 4].cross(along[k]); }
};

template <Scalar R>
R length(const Vec3<R>& v) {
  using std::sqrt;
  const R unit = v.cwiseAbs().maxCoeff();
  if (!(unit > 0)) return unit;
  const Vec3<R> of_unit_size = v / unit;
  return unit * sqrt(R(of_unit_size.dot(of_unit_size)));
}

// s |N| at a point, from the tangents of both quads and the lengths of their normals. No length is divided by.
template <Scalar R>
R stretched_area(Stretch stretch, const std::array<Vec3<R>, 2>& rest, const std::array<Vec3<R>, 2>& posed,
                 const R& area, const R& posed_area) {
  using std::sqrt;
  if (stretch == Stretch::Unit) return area;
  if (stretch == Stretch::Area) return sqrt(R(area * posed_area));
  const R squares = stretched_squares(rest, posed, area);
  return stretch == Stretch::Rms ? R(sqrt(R(squares / 2))) : R(sqrt(R(squares + 2 * area * posed_area)) / 2);
}

// The integrals of sigma, each with the corners' basis functions.
template <Scalar R>
struct Moments {
  std::array<R, 4> stretched, posed;
};

template <Scalar R>
Moments<R> moments_by(int points, Stretch stretch, const Sides<R>& rest, const Sides<R>& posed) {
  const GaussLegendre<R>& rule = gauss_legendre<R>(points);
  Moments<R> found;
  found.stretched.fill(R(0));
  found.posed.fill(R(0));
  for (int j = 0; j < points; ++j) {
    const R& v = rule.nodes[j];
    const Vec3<R> by_u = rest.by_u(v), posed_by_u = posed.by_u(v);
    for (int i = 0; i < points; ++i) {
      const R& u = rule.nodes[i];
      const Vec3<R> by_v = rest.by_v(u), posed_by_v = posed.by_v(u);
      const R area = length<R>(by_u.cross(by_v)), posed_area = length<R>(posed_by_u.cross(posed_by_v));
      const R weight = rule.weights[i] * rule.weights[j];
      const R stretched = weight * stretched_area<R>(stretch, {by_u, by_v}, {posed_by_u, posed_by_v}, area, posed_area);
      const R turned = weight * posed_area;
      const std::array<R, 4> basis{(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
      for (int k = 0; k < 4; ++k) {
        found.stretched[k] += basis[k] * stretched;
        found.posed[k] += basis[k] * turned;
      }
    }
  }
  return found;
}

// The largest change of any integral, over its size.
template <Scalar R>
R change(const Moments<R>& from, const Moments<R>& to) {
  using std::abs;
  R largest = 0;
  for (int k = 0; k < 4; ++k)
    for (const auto& [a, b] : {std::pair(from.stretched[k], to.stretched[k]), std::pair(from.posed[k], to.posed[k])})
      // Not converged where it is no number.
      if (const R relative = abs(R(a - b)) / b; !(relative <= largest)) largest = relative;
  return largest;
}

// Twice the points square the error, so that a change by the root of a rounding leaves less than a rounding.
template <Scalar R>
Moments<R> moments(Stretch stretch, const Sides<R>& rest, const Sides<R>& posed) {
  using std::sqrt;
  constexpr int fewest = 8, most = 128;
  const R enough = R(sqrt(unit_roundoff<R>())) / 8;
  Moments<R> found = moments_by(fewest, stretch, rest, posed);
  for (int points = 2 * fewest; points <= most; points *= 2) {
    const Moments<R> finer = moments_by(points, stretch, rest, posed);
    const bool is_done = !(change(found, finer) > enough);
    found = finer;
    if (is_done) break;
  }
  return found;
}

}  // namespace

template <Scalar R>
std::array<Vec3<R>, 4> quad_normals(Stretch stretch, const CageElements& rest, const std::vector<Vec3<R>>& vertices,
                                    std::size_t element) {
  const auto corners = rest.vertices_of(element), coordinates = rest.shares_of(element, Owner::Normal);
  Quad<R> from, to;
  for (int k = 0; k < 4; ++k) {
    from[k] = convert<R>(rest.vertices()[corners[k]]);
    to[k] = vertices[corners[k]];
  }
  const Sides<R> sides(from), posed(to);
  check_range(rest, element, posed.unit);
  std::array<Vec3<R>, 4> normals;
  bool has_area = false;
  for (int k = 0; k < 4; ++k) {
    normals[k] = posed.corner_normal(k);
    has_area = has_area || normals[k].cwiseAbs().maxCoeff() > 0;
  }
  if (!has_area && !takes_no_area(stretch))
    throw InputError(fmt::format("the posed quad {} (vertices {}) has no area, and so no normals", element,
                                 fmt::join(corners, ", ")));
  if (!has_area) {
    normals.fill(Vec3<R>::Zero());
    return normals;
  }
  const R ratio = posed.unit / sides.unit;
  const Moments<R> of = stretch == Stretch::Product ? Moments<R>() : moments<R>(stretch, sides, posed);
  for (int k = 0; k < 4; ++k) {
    // The coordinate has been multiplied with this number, and no other scalar's.
    normals[k] /= R(rest.area_element_of(coordinates[k], Owner::Normal)) / sides.unit / sides.unit;
    if (stretch == Stretch::Product) normals[k] *= ratio * ratio;
    else normals[k] *= of.stretched[k] / of.posed[k] * (stretch == Stretch::Unit ? R(1) : ratio);
  }
  return normals;
}

template std::array<Vec3<double>, 4> quad_normals<double>(Stretch, const CageElements&,
                                                          const std::vector<Vec3<double>>&, std::size_t);
template std::array<Vec3<Mp50>, 4> quad_normals<Mp50>(Stretch, const CageElements&, const std::vector<Vec3<Mp50>>&,
                                                      std::size_t);

}  // namespace cageproof::deformation
