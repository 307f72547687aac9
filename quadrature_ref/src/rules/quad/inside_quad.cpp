// SPDX-License-Identifier: MIT
#include "inside_quad.h"

#include <algorithm>

namespace cageproof::quadrature_ref {

OnQuad inside_quad(const QuadFrame<Mp200>& q, const ClosestPoint& c) {
  OnQuad on;
  on.u = c.u;
  on.v = c.v;
  if (!is_on_quad(q, c)) return on;
  // Newton's method may miss a point of a side by a rounding.
  const Mp200 rounding = pow(Mp200(10), -120);
  for (Mp200* parameter : {&on.u, &on.v})
    for (const int end : {0, 1})
      if (abs(*parameter - end) < rounding) *parameter = end;
  on.border = on.u == 0 || on.u == 1 || on.v == 0 || on.v == 1;
  Mp200 extent = 0;
  for (const Vec3<Mp200>& edge : q.edges) extent = std::max<Mp200>(extent, length(edge));
  on.clearance = extent;
  for (int k = 0; k < 4; ++k) {
    const Mp200 square = dot(q.edges[k], q.edges[k]);
    Mp200 t = square > 0 ? Mp200(-dot(q.corners[k], q.edges[k]) / square) : Mp200(0);
    t = t < 0 ? Mp200(0) : t > 1 ? Mp200(1) : t;
    const Mp200 distance = length(Vec3<Mp200>(q.corners[k] + t * q.edges[k]));
    if (distance > extent * rounding) on.clearance = std::min<Mp200>(on.clearance, distance);
  }
  const Vec3<Mp200> normal = expand(q, on.u, on.v).normal;
  const Mp200 size = length(normal);
  on.yes = size > extent * extent * rounding;
  if (on.yes) on.inward = -normal / size;
  return on;
}

QuadFrame<Mp200> seen_from_inside(const QuadFrame<Mp200>& q, const OnQuad& on, const Mp200& distance) {
  QuadFrame<Mp200> seen = q;
  const Vec3<Mp200> step = on.inward * distance;
  for (int k = 0; k < 4; ++k) {
    seen.corners[k] -= step;
    seen.heights[k] -= dot(step, Vec3<Mp200>(q.edges[(k + 3) % 4].cross(q.edges[k])));
  }
  return seen;
}

}  // namespace cageproof::quadrature_ref
