// SPDX-License-Identifier: MIT
// Normals of bilinear quads, differentiated under the integrals.
#include "normal_slopes.h"
#include "quad_normals.h"
#include "stretch_slopes.h"

#include "cageproof/core/numbers/gauss_legendre.h"

#include <algorithm>
#include <cmath>

namespace cageproof::deformation {
namespace {

// A quad over the largest number of its sides: tangents, and what each corner weighs in them.
template <Scalar R>
struct SlopedQuad {
  Quad<R> along;
  R unit = 0;

  explicit SlopedQuad(const Quad<R>& q) {
    for (int k = 0; k < 4; ++k) {
      along[k] = q[(k + 1) % 4] - q[k];
      unit = std::max<R>(unit, along[k].cwiseAbs().maxCoeff());
    }
    if (unit > 0)
      for (Vec3<R>& side : along) side /= unit;
  }
  std::array<Vec3<R>, 2> tangents(const R& u, const R& v) const {
    return {Vec3<R>((1 - v) * along[0] - v * along[2]), Vec3<R>(u * along[1] - (1 - u) * along[3])};
  }
  static std::array<std::array<R, 4>, 2> weights(const R& u, const R& v) {
    return {{{R(v - 1), R(1 - v), v, R(-v)}, {R(u - 1), R(-u), u, R(1 - u)}}};
  }
};

// An integral, and its gradients by the posed corners.
template <Scalar R>
struct ByCorners {
  R value = 0;
  std::array<Vec3<R>, 4> slopes;
  ByCorners() { slopes.fill(Vec3<R>::Zero()); }
};

// The integrals of s |N| and |N'|, each with the corners' basis functions.
template <Scalar R>
struct SlopedMoments {
  std::array<ByCorners<R>, 4> stretched, posed;
};

template <Scalar R>
SlopedMoments<R> sloped_moments_by(int points, Stretch stretch, const SlopedQuad<R>& rest, const SlopedQuad<R>& posed) {
  using std::sqrt;
  const GaussLegendre<R>& rule = gauss_legendre<R>(points);
  SlopedMoments<R> found;
  for (int j = 0; j < points; ++j)
    for (int i = 0; i < points; ++i) {
      const R &u = rule.nodes[i], &v = rule.nodes[j];
      const std::array<Vec3<R>, 2> from = rest.tangents(u, v), to = posed.tangents(u, v);
      const Vec3<R> across = from[0].cross(from[1]);
      const BySides<R> turned = area_slopes(to);
      const BySides<R> stretched = stretched_area_slopes(stretch, from, to, R(sqrt(R(across.dot(across)))), turned);
      const auto corner = SlopedQuad<R>::weights(u, v);
      const std::array<R, 4> basis{(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
      const auto add = [&](const BySides<R>& integrand, std::array<ByCorners<R>, 4>& integrals) {
        for (int k = 0; k < 4; ++k) {
          const R weight = rule.weights[i] * rule.weights[j] * basis[k];
          integrals[k].value += weight * integrand.value;
          for (int c = 0; c < 4; ++c)
            integrals[k].slopes[c] +=
                weight * (corner[0][c] * integrand.slopes[0] + corner[1][c] * integrand.slopes[1]);
        }
      };
      add(stretched, found.stretched);
      add(turned, found.posed);
    }
  return found;
}

// The largest change of a gradient's number over the largest number.
template <Scalar R>
R change_of_slopes(const SlopedMoments<R>& a, const SlopedMoments<R>& b) {
  R change = 0, largest = 0;
  const auto compare = [&](const std::array<ByCorners<R>, 4>& from, const std::array<ByCorners<R>, 4>& to) {
    for (int k = 0; k < 4; ++k)
      for (int c = 0; c < 4; ++c) {
        largest = std::max<R>(largest, to[k].slopes[c].cwiseAbs().maxCoeff());
        if (const R step = (from[k].slopes[c] - to[k].slopes[c]).cwiseAbs().maxCoeff(); !(step <= change))
          change = step;
      }
  };
  compare(a.stretched, b.stretched);
  compare(a.posed, b.posed);
  return change / largest;
}

template <Scalar R>
SlopedMoments<R> sloped_moments(Stretch stretch, const SlopedQuad<R>& rest, const SlopedQuad<R>& posed) {
  using std::sqrt;
  constexpr int fewest = 8, most = 128;
  // Twice the points square the error.
  const R enough = R(sqrt(unit_roundoff<R>())) / 8;
  SlopedMoments<R> found = sloped_moments_by(fewest, stretch, rest, posed);
  for (int points = 2 * fewest; points <= most; points *= 2) {
    SlopedMoments<R> finer = sloped_moments_by(points, stretch, rest, posed);
    const bool is_done = !(change_of_slopes(found, finer) > enough);
    found = std::move(finer);
    if (is_done) break;
  }
  return found;
}

}  // namespace

template <Scalar R>
void add_quad_normal_slopes(Stretch stretch, const CageElements& rest, const std::vector<Vec3<R>>& vertices,
                            std::size_t element, std::size_t row, RowSlopes<R>& slopes) {
  const auto corners = rest.vertices_of(element), coordinates = rest.shares_of(element, Owner::Normal);
  Quad<R> from, to;
  for (int k = 0; k < 4; ++k) {
    from[k] = convert<R>(rest.vertices()[corners[k]]);
    to[k] = vertices[corners[k]];
  }
  const SlopedQuad<R> sides(from), posed(to);
  const bool is_product = stretch == Stretch::Product;
  const SlopedMoments<R> of = is_product ? SlopedMoments<R>() : sloped_moments<R>(stretch, sides, posed);
  for (int k = 0; k < 4; ++k) {
    // sigma N'/|N|, with N' = along(k - 1) x along(k), sigma a quotient of integrals or one.
    const Vec3<R>&before = posed.along[(k + 3) % 4], &after = posed.along[k], normal = before.cross(after);
    const R area = R(rest.area_element_of(coordinates[k], Owner::Normal)) / sides.unit / sides.unit;
    // In the users' unit: N'/|N| is of degree two, and the quotient of degree -1, or -2 for Unit.
    const R over = (is_product                 ? R(posed.unit / sides.unit / sides.unit)
                    : stretch == Stretch::Unit ? R(1 / posed.unit)
                                               : R(1 / sides.unit)) /
                   area;
    const R sigma = is_product ? R(1) : R(of.stretched[k].value / of.posed[k].value);
    std::array<Mat3<R>, 4> found;
    found.fill(Mat3<R>::Zero());
    for (int c = 0; c < 3; ++c) {
      Vec3<R> axis = Vec3<R>::Zero();
      axis[c] = 1;
      // Corner k - 1 begins the side before, corner k ends it and begins the side after, corner k + 1 ends that.
      const Vec3<R> by_before = axis.cross(after), by_after = before.cross(axis);
      found[(k + 3) % 4].col(c) -= sigma * by_before;
      found[k].col(c) += sigma * (by_before - by_after);
      found[(k + 1) % 4].col(c) += sigma * by_after;
    }
    for (int c = 0; c < 4; ++c) {
      if (!is_product)
        found[c] +=
            normal * ((of.stretched[k].slopes[c] - sigma * of.posed[k].slopes[c]) / of.posed[k].value).transpose();
      if (!found[c].allFinite()) refuse_slope(rest, element);
      slopes.parts.push_back({row + static_cast<std::size_t>(k), corners[c], Mat3<R>(over * found[c])});
    }
  }
}

template void add_quad_normal_slopes<double>(Stretch, const CageElements&, const std::vector<Vec3<double>>&,
                                             std::size_t, std::size_t, RowSlopes<double>&);
template void add_quad_normal_slopes<Mp50>(Stretch, const CageElements&, const std::vector<Vec3<Mp50>>&, std::size_t,
                                           std::size_t, RowSlopes<Mp50>&);

}  // namespace cageproof::deformation
