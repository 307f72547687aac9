// SPDX-License-Identifier: MIT
// A triangle as its point sees it: corners relative to the point, in a unit of length close to its extent.
#pragma once

#include "cageproof/quadrature_ref/kernel.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cageproof::quadrature_ref {

template <Scalar R>
struct LocalTriangle {
  std::array<Vec3<R>, 3> corners;  ///< v_k - eta
  std::array<Vec3<R>, 3> edges;    ///< v_{k+1} - v_k
  Vec3<R> normal;                  ///< unit, outward
  R height;                        ///< x . normal of every x on the triangle
  R twice_area;
  int exponent = 0;  ///< lengths are in units of 2^exponent
};

template <Scalar R>
R dot(const Vec3<R>& a, const Vec3<R>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <Scalar R>
R length(const Vec3<R>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

template <Scalar R>
Vec3<R> scaled(const Vec3<R>& a, int exponent) {
  using std::ldexp;
  return {ldexp(a[0], exponent), ldexp(a[1], exponent), ldexp(a[2], exponent)};
}

/// Nothing for a triangle without area or an input that is not finite.
template <Scalar R>
std::optional<LocalTriangle<R>> local_triangle(const Query<R>& query) {
  using std::abs, std::frexp, std::isfinite;
  LocalTriangle<R> t;
  R extent = 0;
  for (int k = 0; k < 3; ++k) {
    t.corners[k] = query.corners[k] - query.point;
    t.edges[k] = query.corners[(k + 1) % 3] - query.corners[k];
    for (int i = 0; i < 3; ++i) {
      if (!isfinite(t.corners[k][i]) || !isfinite(t.edges[k][i])) return std::nullopt;
      extent = std::max<R>(extent, abs(t.corners[k][i]));
    }
  }
  frexp(extent, &t.exponent);
  for (int k = 0; k < 3; ++k) {
    t.corners[k] = scaled(t.corners[k], -t.exponent);
    t.edges[k] = scaled(t.edges[k], -t.exponent);
  }
  const Vec3<R> area_vector = t.edges[0].cross(t.edges[1]);
  t.twice_area = length(area_vector);
  if (!(t.twice_area > 0)) return std::nullopt;
  for (int i = 0; i < 3; ++i) t.normal[i] = area_vector[i] / t.twice_area;
  // The nearest corner gives the height with the smallest rounding error; dividing last keeps an exact zero.
  const auto nearest = std::ranges::min_element(t.corners, {}, [](const Vec3<R>& p) { return dot(p, p); });
  t.height = dot(*nearest, area_vector) / t.twice_area;
  return t;
}

template <Scalar To, Scalar From>
LocalTriangle<To> convert(const LocalTriangle<From>& from) {
  LocalTriangle<To> to;
  for (int k = 0; k < 3; ++k) {
    to.corners[k] = cageproof::convert<To>(from.corners[k]);
    to.edges[k] = cageproof::convert<To>(from.edges[k]);
  }
  to.normal = cageproof::convert<To>(from.normal);
  to.height = static_cast<To>(from.height);
  to.twice_area = static_cast<To>(from.twice_area);
  to.exponent = from.exponent;
  return to;
}

/// The query in another scalar, with its own storage.
template <Scalar To>
struct ConvertedQuery {
  template <Scalar From>
  explicit ConvertedQuery(const Query<From>& from) {
    for (const Vec3<From>& corner : from.corners) corners.push_back(cageproof::convert<To>(corner));
    for (const From& parameter : from.parameters) parameters.push_back(static_cast<To>(parameter));
    query = {corners, cageproof::convert<To>(from.point), from.order, parameters};
  }
  ConvertedQuery(const ConvertedQuery&) = delete;
  ConvertedQuery& operator=(const ConvertedQuery&) = delete;

  std::vector<Vec3<To>> corners;
  std::vector<To> parameters;
  Query<To> query;
};

/// Sets `result` to the tensors of `sums`, made symmetric and scaled back from units of 2^exponent.
template <Scalar R, Scalar W>
void finish(const Formula& formula, int exponent, const Result<W>& sums, Result<R>& result) {
  using std::ldexp;
  for (int order = 0; order <= 2; ++order)
    for (std::size_t i = 0; i < sums.of(order).size(); ++i)
      result.of(order)[i] = static_cast<R>(ldexp(sums.of(order)[i], exponent * (formula.degree - order)));
  fill_symmetric(result, formula.dim());
}

/// What a rule answers where nothing can be computed.
template <Scalar R>
void fill_not_a_number(Result<R>& result) {
  for (int order = 0; order <= 2; ++order) std::ranges::fill(result.of(order), std::numeric_limits<R>::quiet_NaN());
  result.converged = false;
}

}  // namespace cageproof::quadrature_ref
