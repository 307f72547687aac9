// SPDX-License-Identifier: MIT
#include "polar_quad_frame.h"

namespace cageproof::quadrature_ref {

PolarQuadFrame<Mp200> polar_quad_frame(const QuadFrame<Mp200>& q, const Mp200& u, const Mp200& v) {
  PolarQuadFrame<Mp200> frame;
  frame.at = expand(q, u, v);
  frame.distance = length(frame.at.base);
  frame.exponent = q.exponent;
  constexpr std::array<std::array<int, 2>, 4> corner{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  for (int k = 0; k < 4; ++k) {
    const auto& from = corner[k];
    const auto& to = corner[(k + 1) % 4];
    QuadSector<Mp200> s;
    s.step_u = to[0] - from[0];
    s.step_v = to[1] - from[1];
    const Mp200 start_u = from[0] - u, start_v = from[1] - v;
    s.jacobian = start_u * s.step_v - start_v * s.step_u;
    if (!(s.jacobian > 0)) continue;
    // The edge in directions, not the quad's edge, which is another line where opposite sides differ: next to c, where
    // integrands are largest, only the directions matter.
    s.edge = frame.at.along_u * s.step_u + frame.at.along_v * s.step_v;
    const Vec3<Mp200> to_start = frame.at.along_u * start_u + frame.at.along_v * start_v;
    const Mp200 square = dot(s.edge, s.edge);
    Mp200 foot = 0, eps = 4;
    if (square > 0) {
      foot = -dot(to_start, s.edge) / square;
      eps = length(Vec3<Mp200>(to_start + s.edge * foot)) / sqrt(square);
      // Near a foot far beyond the edge's ends there are no points to concentrate, and its sinh would only cancel.
      const Mp200 beyond = foot < 0 ? Mp200(-foot) : foot > 1 ? Mp200(foot - 1) : Mp200(0);
      if (beyond > 1) {
        foot = foot < 0 ? Mp200(-1) : Mp200(2);
        eps = std::max<Mp200>(eps, 1);
      }
      eps = std::min<Mp200>(eps, 4);
    }
    if (!(eps > 0)) eps = s.jacobian;  // all directions along one line: a quad that is flat at c
    s.eps = eps;
    s.du = start_u + foot * s.step_u;
    s.dv = start_v + foot * s.step_v;
    s.to_edge = frame.at.along_u * s.du + frame.at.along_v * s.dv;
    s.tau = inverse_sinh(Mp200(-foot / eps));
    s.tau_length = inverse_sinh(Mp200((1 - foot) / eps)) - s.tau;
    frame.sectors.push_back(std::move(s));
  }
  return frame;
}

}  // namespace cageproof::quadrature_ref
