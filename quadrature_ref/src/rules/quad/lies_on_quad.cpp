// SPDX-License-Identifier: MIT
// Whether a point lies on a bilinear quad, exactly: with p_k = corner k - point, A = p_1 - p_0, B = p_3 - p_0 and
// W = p_0 - p_1 + p_2 - p_3, it does where p_0 + u A + v B + uv W = 0 for some u and v in [0, 1].
#include "../exact_vectors.h"
#include "inside_quad.h"

#include <algorithm>

namespace cageproof::quadrature_ref {
namespace {

using certified::Real, certified::WorkingBits;
using RealVector = ExactVector<Real>;

int sign_of(const Real& exact) {
  return arb_is_positive(exact.raw()) != 0 ? 1 : arb_is_negative(exact.raw()) != 0 ? -1 : 0;
}
bool vanishes(const RealVector& v) { return sign_of(v[0]) == 0 && sign_of(v[1]) == 0 && sign_of(v[2]) == 0; }
Real determinant(const RealVector& a, const RealVector& b, const RealVector& c) {
  return scalar_product(a, vector_product(b, c));
}
RealVector opposite(const RealVector& v) { return {-v[0], -v[1], -v[2]}; }

struct SeenQuad {
  std::array<RealVector, 4> p;
  RealVector a, b, w;
};

bool is_on_a_side(const SeenQuad& q) {
  for (int k = 0; k < 4; ++k) {
    const RealVector &from = q.p[k], &to = q.p[(k + 1) % 4];
    if (vanishes(vector_product(from, to)) && sign_of(scalar_product(from, to)) <= 0) return true;
  }
  return false;
}

// Whether part / whole is in [0, 1].
bool is_share(const Real& part, const Real& whole) {
  return sign_of(part) * sign_of(whole) >= 0 && sign_of(whole - part) * sign_of(whole) >= 0;
}

// Corners that no plane holds: u, v and uv are the solution of three linear equations.
bool is_on_twisted(const SeenQuad& q, const Real& whole) {
  const RealVector target = opposite(q.p[0]);
  const Real u = determinant(target, q.b, q.w), v = determinant(q.a, target, q.w), uv = determinant(q.a, q.b, target);
  return sign_of(uv * whole - u * v) == 0 && is_share(u, whole) && is_share(v, whole);
}

enum class Between { No, Yes, Unknown };

// Whether a number known to a ball is within (0, 1).
Between is_between(const Real& x) {
  const Real one(1);
  if (arb_is_positive(x.raw()) != 0 && arb_lt(x.raw(), one.raw()) != 0) return Between::Yes;
  return arb_is_negative(x.raw()) != 0 || arb_gt(x.raw(), one.raw()) != 0 ? Between::No : Between::Unknown;
}

// Whether the row at v holds the point between its ends.
Between is_on_row(const SeenQuad& q, const Real& v) {
  const Between of_v = is_between(v);
  if (of_v == Between::No) return of_v;
  RealVector start, along;
  for (int i = 0; i < 3; ++i) start[i] = q.p[0][i] + v * q.b[i], along[i] = q.a[i] + v * q.w[i];
  const Between of_u = is_between(-scalar_product(start, along) / scalar_product(along, along));
  return of_u == Between::Yes ? of_v : of_u;
}

// A point of the corners' plane that is on no side. The point is on the line of the row at v where
// (p_0 + v B) x (A + v W), along the normal, vanishes: a quadratic in v. Its roots, and where on their rows the point
// is, are balls of more and more bits; ends of rows are on sides, so that all but rows of no length are decided.
bool is_within_plane(const SeenQuad& q, const RealVector& normal) {
  constexpr slong most_bits = 1 << 16;
  Real square, linear, constant, discriminant;
  {
    const WorkingBits exact = WorkingBits::exact();
    square = scalar_product(normal, vector_product(q.b, q.w));
    linear = scalar_product(normal, vector_product(q.p[0], q.w)) + scalar_product(normal, vector_product(q.b, q.a));
    constant = scalar_product(normal, vector_product(q.p[0], q.a));
    discriminant = linear * linear - square * constant * 4;
  }
  // Where all three vanish, the point is on the lines of all rows; if it is on the quad, it is then also on a side.
  if (sign_of(discriminant) < 0 || (sign_of(square) == 0 && sign_of(linear) == 0)) return false;
  for (slong bits = 128; bits <= most_bits; bits *= 2) {
    const WorkingBits rounded(bits);
    std::array<Between, 2> rows{Between::No, Between::No};
    if (sign_of(square) == 0) {
      rows[0] = is_on_row(q, -constant / linear);
    } else {
      const Real root = sqrt(discriminant), twice = square * 2;
      rows = {is_on_row(q, (root - linear) / twice), is_on_row(q, -(root + linear) / twice)};
    }
    if (std::ranges::find(rows, Between::Yes) != rows.end()) return true;
    if (std::ranges::find(rows, Between::Unknown) == rows.end()) return false;
  }
  return false;
}

}  // namespace

bool lies_on_quad(const Query<Mp200>& query) {
  const auto is_double = [](const Vec3<Mp200>& x) {
    return cageproof::convert<Mp200>(cageproof::convert<double>(x)) == x && isfinite(x[0]) && isfinite(x[1]) &&
           isfinite(x[2]);
  };
  if (!std::ranges::all_of(query.corners, is_double) || !is_double(query.point)) return false;
  SeenQuad q;
  RealVector normal;
  {
    const WorkingBits exact = WorkingBits::exact();
    q.p = seen<Real, 4>(query.corners, query.point);
    q.a = minus(q.p[1], q.p[0]);
    q.b = minus(q.p[3], q.p[0]);
    for (int i = 0; i < 3; ++i) q.w[i] = q.p[0][i] - q.p[1][i] + q.p[2][i] - q.p[3][i];
    if (is_on_a_side(q)) return true;
    const Real whole = determinant(q.a, q.b, q.w);
    if (sign_of(whole) != 0) return is_on_twisted(q, whole);
    for (int k = 0; k < 4 && vanishes(normal); ++k)
      normal = vector_product(minus(q.p[(k + 1) % 4], q.p[k]), minus(q.p[(k + 3) % 4], q.p[k]));
    if (vanishes(normal) || sign_of(scalar_product(normal, q.p[0])) != 0) return false;
  }
  return is_within_plane(q, normal);
}

}  // namespace cageproof::quadrature_ref
