// SPDX-License-Identifier: MIT
#include "cageproof/core/geometry/quad_geometry.h"

#include "cageproof/core/geometry/orientation.h"
#include "exact_signs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof {
namespace {

using exact::Exact3;
using exact::Rational;
using exact::Surd;
using Vec = Vec3<double>;
constexpr double kU = std::numeric_limits<double>::epsilon() / 2;

bool finite(const Quad<double>& q) {
  return std::ranges::all_of(q, [](const Vec& v) { return v.allFinite(); });
}

// Normals of the triangles at the corners, n_i = e_(i-1) x e_i: the projection along n_j turns at corner i by n_i .
// n_j. A sign is decided in double where the filter proves it, else exactly.
class CornerNormals {
 public:
  explicit CornerNormals(const Quad<double>& q) : q_(q) {
    for (int i = 0; i < 4; ++i) edges_[i] = q[(i + 1) % 4] - q[i];
    for (const Vec& e : edges_) largest_ = std::max(largest_, e.cwiseAbs().maxCoeff());
    for (int i = 0; i < 4; ++i) normals_[i] = edges_[(i + 3) % 4].cross(edges_[i]);
    // Powers up to the fourth neither overflow nor sink into subnormal numbers that matter.
    filtered_ = largest_ > 1e-60 && largest_ < 1e60;
  }

  /// Whether the three corners around corner i lie on a line.
  bool vanishes(int i) {
    // Three roundings a product, one of the difference: at most 8 u M^2 to first order.
    if (filtered_ && normals_[i].cwiseAbs().maxCoeff() > 10 * kU * largest_ * largest_) return false;
    return exact::is_zero(exact_normal(i));
  }

  /// The sign of n_i . n_j.
  int sign_of_dot(int i, int j) {
    const double dot = normals_[i].dot(normals_[j]);
    // Components of at most 2 M^2 are right to 8 u M^2: each of three products errs by 36 u M^4, their sum by 24 u M^4.
    const double bound = 160 * kU * largest_ * largest_ * largest_ * largest_;
    if (filtered_ && std::abs(dot) > bound) return dot > 0 ? 1 : -1;
    return exact::sign(exact::dot(exact_normal(i), exact_normal(j)));
  }

 private:
  const Exact3& exact_normal(int i) {
    if (!exact_[i]) {
      const Exact3 before = exact::from(q_[(i + 3) % 4]), at = exact::from(q_[i]), after = exact::from(q_[(i + 1) % 4]);
      exact_[i] = exact::cross(exact::minus(at, before), exact::minus(after, at));
    }
    return *exact_[i];
  }

  const Quad<double>& q_;
  std::array<Vec, 4> edges_, normals_;
  std::array<std::optional<Exact3>, 4> exact_;
  double largest_ = 0;
  bool filtered_ = false;
};

// The t in [0, 1] for which from + t (to - from) is the point; nothing off the segment.
std::optional<double> on_segment(const Exact3& from, const Exact3& to, const Exact3& point) {
  const Exact3 along = exact::minus(to, from), to_point = exact::minus(point, from);
  const Exact3 off = exact::cross(along, to_point);
  if (!exact::is_zero(off)) return std::nullopt;
  const Rational length = exact::dot(along, along), part = exact::dot(along, to_point);
  if (length == 0) return exact::is_zero(to_point) ? std::optional(0.0) : std::nullopt;
  if (part < 0 || part > length) return std::nullopt;
  return exact::rounded(Rational(part / length));
}

std::optional<BilinearPoint> on_border(const std::array<Exact3, 4>& q, const Exact3& point) {
  for (int i = 0; i < 4; ++i) {
    const auto t = on_segment(q[i], q[(i + 1) % 4], point);
    if (!t) continue;
    const std::array<std::array<double, 2>, 4> at{{{*t, 0}, {1, *t}, {1 - *t, 1}, {0, 1 - *t}}};
    BilinearPoint found{at[i][0], at[i][1], {}};
    found.basis[i] = 1 - *t;
    found.basis[(i + 1) % 4] = *t;
    return found;
  }
  return std::nullopt;
}

// The normal of a plane quad, any length; nothing if all corners lie on a line.
std::optional<Exact3> normal_of(const std::array<Exact3, 4>& q) {
  for (int i = 0; i < 4; ++i) {
    const Exact3 n = exact::cross(exact::minus(q[i], q[(i + 3) % 4]), exact::minus(q[(i + 1) % 4], q[i]));
    if (!exact::is_zero(n)) return n;
  }
  return std::nullopt;
}

// A point of the quad's plane. Rows run from P = a + v f along w = e + v g; the point, at the origin, lies on the row's
// line where P x w = 0, a quadratic in v (whose roots Eq 19 of [T18] writes down for convex quads). Either root may do
// for quads that are not convex.
std::optional<BilinearPoint> on_plane_quad(const std::array<Exact3, 4>& q, const Exact3& point) {
  if (const auto found = on_border(q, point)) return found;
  const auto normal = normal_of(q);
  if (!normal || exact::dot(*normal, exact::minus(point, q[0])) != 0) return std::nullopt;
  const int axis = (*normal)[0] != 0 ? 0 : (*normal)[1] != 0 ? 1 : 2;
  const int x = (axis + 1) % 3, y = (axis + 2) % 3;  // two coordinates tell points of the plane apart
  using Exact2 = std::array<Rational, 2>;
  const auto flat = [&](const Exact3& p) { return Exact2{p[x], p[y]}; };
  const auto cross = [](const Exact2& p, const Exact2& r) { return Rational(p[0] * r[1] - p[1] * r[0]); };
  const Exact3 e3 = exact::minus(q[1], q[0]);
  const Exact2 a = flat(exact::minus(q[0], point)), e = flat(e3), f = flat(exact::minus(q[3], q[0]));
  const Exact2 g = flat(exact::minus(exact::minus(q[2], q[3]), e3));
  const Rational square = cross(f, g), linear = cross(a, g) + cross(f, e), constant = cross(a, e);
  for (const Surd& v : exact::quadratic_roots(square, linear, constant)) {
    if (v.sign() < 0 || v.plus(Rational(-1)).sign() > 0) continue;
    for (int c = 0; c < 2; ++c) {
      const Surd along = v.times(g[c]).plus(e[c]), from = v.times(f[c]).plus(a[c]);
      const int way = along.sign();
      if (way == 0) continue;
      // 0 <= -from/along <= 1
      if (from.sign() * way > 0 || from.plus(along).sign() * way < 0) break;
      const Mp200 s = v.value(), r = -from.value() / along.value();
      const auto number = [](const Mp200& m) { return std::clamp(static_cast<double>(m), 0.0, 1.0); };
      return BilinearPoint{
          number(r), number(s), {number((1 - r) * (1 - s)), number(r * (1 - s)), number(r * s), number((1 - r) * s)}};
    }
  }
  return std::nullopt;
}

// The kernel of Eq 17 ([T18] Eq 26, any scale): the point's barycentric coordinates in the tetrahedron of the corners.
// They are bilinear basis functions where all have one sign and k_0 k_2 = k_1 k_3.
template <class R, class V>
std::array<R, 4> kernel(const std::array<V, 4>& a) {
  const auto det = [&](int i, int j, int k) {
    return R(a[i][0] * (a[j][1] * a[k][2] - a[j][2] * a[k][1]) + a[i][1] * (a[j][2] * a[k][0] - a[j][0] * a[k][2]) +
             a[i][2] * (a[j][0] * a[k][1] - a[j][1] * a[k][0]));
  };
  return {det(1, 2, 3), -det(0, 2, 3), det(0, 1, 3), -det(0, 1, 2)};
}

// Whether rounded arithmetic proves that the point is off the quad.
template <class R>
bool surely_off(const Quad<R>& q, const Vec3<R>& point) {
  using std::abs;
  Quad<R> a;
  R largest = R(0);
  for (int i = 0; i < 4; ++i) {
    a[i] = q[i] - point;
    largest = std::max<R>(largest, a[i].cwiseAbs().maxCoeff());
  }
  if (!(largest > R(1e-40) && largest < R(1e40))) return false;
  const auto k = kernel<R>(a);
  // A determinant, at most 6 M^3, is wrong by 48 u M^3; the difference of two products of them by 1300 u M^6.
  const R unit = std::numeric_limits<R>::epsilon() / 2, cube = largest * largest * largest, bound = 50 * unit * cube;
  const auto [least, most] = std::ranges::minmax(k);
  return (least < -bound && most > bound) || abs(R(k[0] * k[2] - k[1] * k[3])) > 1400 * unit * cube * cube;
}

std::optional<BilinearPoint> on_twisted_quad(const std::array<Exact3, 4>& q, const Exact3& point) {
  std::array<Exact3, 4> a;
  for (int i = 0; i < 4; ++i) a[i] = exact::minus(q[i], point);
  std::array<Rational, 4> k = kernel<Rational>(a);
  const Rational sum = k[0] + k[1] + k[2] + k[3];
  for (Rational& x : k) x /= sum;
  if (*std::ranges::min_element(k) < 0 || k[0] * k[2] != k[1] * k[3]) return std::nullopt;
  return BilinearPoint{exact::rounded(k[1] + k[2]),
                       exact::rounded(k[2] + k[3]),
                       {exact::rounded(k[0]), exact::rounded(k[1]), exact::rounded(k[2]), exact::rounded(k[3])}};
}

}  // namespace

std::optional<std::string> invalid_because(const Quad<double>& q) {
  if (!finite(q)) return "a coordinate is not finite";
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      if (q[i] == q[j]) return fmt::format("its corners {} and {} coincide", i, j);
  CornerNormals normals(q);
  const auto around = [](int i) { return fmt::format("corners {}, {} and {}", (i + 3) % 4, i, (i + 1) % 4); };
  for (int i = 0; i < 4; ++i)
    if (normals.vanishes(i)) return fmt::format("its {} lie on a line", around(i));
  // Four turns to the same side make a convex quad; two successive ones to either side, one that crosses itself.
  std::array<std::array<int, 4>, 4> turns;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) turns[i][j] = i == j ? 1 : j < i ? turns[j][i] : normals.sign_of_dot(i, j);
  for (int i = 0; i < 4; ++i)
    if (turns[i][0] * turns[i][2] < 0 && turns[i][1] * turns[i][3] < 0)
      return fmt::format("it crosses itself (a bow-tie), seen along the normal of its {}", around(i));
  for (int i = 0; i < 4; ++i)
    if (std::ranges::min(turns[i]) <= 0)
      return fmt::format("it folds over: it is not convex, seen along the normal of its {}", around(i));
  return std::nullopt;
}

bool is_planar(const Quad<double>& q) { return finite(q) && side_of_plane({q[0], q[1], q[2]}, q[3]) == 0; }

namespace {

// Whether a point is outside the box of the corners, or off the quad by the filter.
template <class R>
bool is_off(const Quad<R>& q, const Vec3<R>& point) {
  for (int c = 0; c < 3; ++c) {
    const auto [low, high] = std::minmax({q[0][c], q[1][c], q[2][c], q[3][c]});
    if (point[c] < low || point[c] > high) return true;
  }
  return surely_off(q, point);
}

std::optional<BilinearPoint> on_exact_quad(const std::array<Exact3, 4>& q, const Exact3& point) {
  const Exact3 normal = exact::cross(exact::minus(q[1], q[0]), exact::minus(q[2], q[0]));
  const bool planar = exact::dot(normal, exact::minus(q[3], q[0])) == 0;
  return planar ? on_plane_quad(q, point) : on_twisted_quad(q, point);
}

// Rationals of such numbers are small enough to compute with.
bool has_exact_numbers(const Vec3<Mp200>& v) {
  constexpr int kMost = 1 << 14;
  return std::ranges::all_of(v, [](const Mp200& x) { return x == 0 || (isfinite(x) && std::abs(ilogb(x)) < kMost); });
}

}  // namespace

std::optional<BilinearPoint> on_quad(const Quad<double>& q, const Vec& point) {
  if (!finite(q) || !point.allFinite() || is_off(q, point)) return std::nullopt;
  return on_exact_quad({exact::from(q[0]), exact::from(q[1]), exact::from(q[2]), exact::from(q[3])},
                       exact::from(point));
}

std::optional<BilinearPoint> on_quad(const Quad<Mp200>& q, const Vec3<Mp200>& point) {
  if (!std::ranges::all_of(q, has_exact_numbers) || !has_exact_numbers(point) || is_off(q, point)) return std::nullopt;
  return on_exact_quad({exact::from(q[0]), exact::from(q[1]), exact::from(q[2]), exact::from(q[3])},
                       exact::from(point));
}

namespace {

// The answer from the kernel k of Eq 17, which tells whether the point is within the tetrahedron, and on which side of
// the quad.
template <class R>
SeenTriangles seen_by(const std::array<R, 4>& k) {
  if (std::ranges::any_of(k, [](const R& x) { return x == R(0); })) return SeenTriangles::Coplanar;
  const bool positive = k[0] > R(0);
  const bool within = std::ranges::all_of(k, [&](const R& x) { return (x > R(0)) == positive; });
  return within && k[1] * k[3] < k[0] * k[2] ? SeenTriangles::Diagonal13 : SeenTriangles::Diagonal02;
}

}  // namespace

SeenTriangles seen_triangles(const Quad<double>& q, const Vec& point) {
  if (!finite(q) || !point.allFinite()) return SeenTriangles::Coplanar;
  Quad<double> near;
  double largest = 0;
  for (int i = 0; i < 4; ++i) {
    near[i] = q[i] - point;
    largest = std::max(largest, near[i].cwiseAbs().maxCoeff());
  }
  if (largest > 1e-40 && largest < 1e40) {
    // The bounds of surely_off().
    const auto k = kernel<double>(near);
    const double cube = largest * largest * largest, bound = 50 * kU * cube;
    const bool no_zero = std::ranges::all_of(k, [&](double x) { return std::abs(x) > bound; });
    const bool within = (k[0] > 0) == (k[1] > 0) && (k[1] > 0) == (k[2] > 0) && (k[2] > 0) == (k[3] > 0);
    if (no_zero && (!within || std::abs(k[0] * k[2] - k[1] * k[3]) > 1400 * kU * cube * cube))
      return seen_by<double>(k);
  }
  std::array<Exact3, 4> a;
  const Exact3 eta = exact::from(point);
  for (int i = 0; i < 4; ++i) a[i] = exact::minus(exact::from(q[i]), eta);
  return seen_by<Rational>(kernel<Rational>(a));
}

SeenTriangles seen_triangles(const Quad<Mp200>& q, const Vec3<Mp200>& point) {
  std::array<Vec3<Mp200>, 4> a;
  for (int i = 0; i < 4; ++i) a[i] = q[i] - point;
  return seen_by<Mp200>(kernel<Mp200>(a));
}

}  // namespace cageproof
