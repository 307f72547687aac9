// SPDX-License-Identifier: MIT
#include "closest_point.h"

namespace cageproof::quadrature_ref {
namespace {

constexpr int kGrid = 16;

struct Start {
  double square;
  double u, v;
};

template <Scalar R>
QuadFrame<R> converted(const QuadFrame<Mp200>& q) {
  QuadFrame<R> to;
  for (int k = 0; k < 4; ++k) {
    to.corners[k] = cageproof::convert<R>(q.corners[k]);
    to.edges[k] = cageproof::convert<R>(q.edges[k]);
  }
  to.twist = cageproof::convert<R>(q.twist);
  return to;
}

// Local minima of the squared distance on a grid, the best ones first.
std::vector<Start> grid_minima(const QuadFrame<Mp200>& q) {
  const QuadFrame<double> rough = converted<double>(q);
  std::array<std::array<double, kGrid + 1>, kGrid + 1> square;
  for (int i = 0; i <= kGrid; ++i)
    for (int j = 0; j <= kGrid; ++j) {
      const Vec3<double> x = rough.at(static_cast<double>(i) / kGrid, static_cast<double>(j) / kGrid);
      square[i][j] = dot(x, x);
    }
  std::vector<Start> starts;
  for (int i = 0; i <= kGrid; ++i)
    for (int j = 0; j <= kGrid; ++j) {
      bool least = true;
      for (int k = std::max(0, i - 1); k <= std::min(kGrid, i + 1); ++k)
        for (int l = std::max(0, j - 1); l <= std::min(kGrid, j + 1); ++l)
          least = least && square[i][j] <= square[k][l];
      if (least) starts.push_back({square[i][j], static_cast<double>(i) / kGrid, static_cast<double>(j) / kGrid});
    }
  std::ranges::sort(starts, {}, &Start::square);
  if (starts.size() > 6) starts.resize(6);
  return starts;
}

template <Scalar R>
R clamped(const R& x) {
  return x < 0 ? R(0) : x > 1 ? R(1) : x;
}

// Damped Newton steps on |x|^2 / 2, clipped to the square, until they no longer matter.
template <Scalar R>
void descend(const QuadFrame<R>& q, R& u, R& v, int steps) {
  R damping = 0;
  Vec3<R> x = q.at(u, v);
  R square = dot(x, x);
  for (int step = 0; step < steps && square > 0; ++step) {
    const Vec3<R> along_u = q.along_u(v), along_v = q.along_v(u);
    const R gradient_u = dot(x, along_u), gradient_v = dot(x, along_v);
    const R uu = dot(along_u, along_u) * (1 + damping), vv = dot(along_v, along_v) * (1 + damping);
    const R uv = dot(along_u, along_v) + dot(x, q.twist);
    const R determinant = uu * vv - uv * uv;
    if (!(determinant > 0)) {
      damping = damping == 0 ? R(1) / 8 : R(damping * 4);
      continue;
    }
    const R next_u = clamped(R(u - (vv * gradient_u - uv * gradient_v) / determinant));
    const R next_v = clamped(R(v - (uu * gradient_v - uv * gradient_u) / determinant));
    const Vec3<R> next = q.at(next_u, next_v);
    const R next_square = dot(next, next);
    if (!(next_square < square)) {
      if (next_u == u && next_v == v) return;
      damping = damping == 0 ? R(1) / 8 : R(damping * 4);
      if (damping > 1000000) return;
      continue;
    }
    u = next_u;
    v = next_v;
    x = next;
    square = next_square;
    damping = damping < R(1) / 100 ? R(0) : R(damping / 8);
  }
}

}  // namespace

ClosestPoint closest_point(const QuadFrame<Mp200>& q) {
  std::optional<ClosestPoint> best;
  const auto consider = [&](const Mp200& u, const Mp200& v) {
    const Vec3<Mp200> x = expand(q, u, v).base;
    const Mp200 square = dot(x, x);
    if (!best || square < best->square) best = ClosestPoint{u, v, square};
  };
  for (int k = 0; k < 4; ++k) {
    const Mp200 squared_length = dot(q.edges[k], q.edges[k]);
    const Mp200 t = squared_length > 0 ? clamped(Mp200(-dot(q.corners[k], q.edges[k]) / squared_length)) : Mp200(0);
    if (k == 0) consider(t, 0);
    else if (k == 1) consider(1, t);
    else if (k == 2) consider(1 - t, 1);
    else consider(0, 1 - t);
  }
  const QuadFrame<Mp50> rough = converted<Mp50>(q);
  for (const Start& start : grid_minima(q)) {
    Mp50 u = start.u, v = start.v;
    descend(rough, u, v, 60);
    Mp200 exact_u(u), exact_v(v);
    // On the border the edges' nearest points are exact already.
    if (!(u > 0 && u < 1 && v > 0 && v < 1)) continue;
    descend(q, exact_u, exact_v, 6);
    consider(exact_u, exact_v);
  }
  return *best;
}

bool is_on_quad(const QuadFrame<Mp200>& q, const ClosestPoint& c) {
  Mp200 extent = 0;
  for (const Vec3<Mp200>& edge : q.edges) extent = std::max<Mp200>(extent, dot(edge, edge));
  return c.square < extent * pow(Mp200(10), -240);
}

}  // namespace cageproof::quadrature_ref
