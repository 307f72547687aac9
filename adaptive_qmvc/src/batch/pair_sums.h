// SPDX-License-Identifier: MIT
// Mean value weights of one quad by the line form, a vector of points at a time ([T18] Eq 11).
//
// Along the line v the squared distance is l ((u - foot)^2 + k2) with l its squared length, whose terms do not cancel,
// and N.x is linear. F_j, the integrals of u^j/((u - foot)^2 + k2)^2, are taken by Gauss-Legendre, or, close to the
// line, from its angle; the integral across the lines by Gauss-Legendre.
#pragma once

#include "space_lanes.h"

namespace cageproof::adaptive_qmvc::batch::CAGEPROOF_SIMD {

using lanes::angle_of;

/// One line of a quad.
struct Line {
  double step[3];      ///< from line 0 to this one's start
  double e[3];         ///< its direction
  double over;         ///< one over its squared length
  double v;            ///< its place
  double left, right;  ///< its weight times 1 - v and v, over the fourth power of its length
};

inline void find_lines(const QuadTable& quad, const Rule& across, Line* line) {
  for (int j = 0; j < across.count; ++j) {
    const double v = across.node[j];
    double square = 0;
    for (int i = 0; i < 3; ++i) {
      line[j].step[i] = v * quad.b[i];
      line[j].e[i] = quad.e[i] + v * quad.w[i];
      square += line[j].e[i] * line[j].e[i];
    }
    line[j].over = 1 / square;
    line[j].v = v;
    const double weight = across.moment[0][j] * line[j].over * line[j].over;
    line[j].left = (1 - v) * weight;
    line[j].right = v * weight;
  }
}

/// The integrals of u^j/((u - foot)^2 + k2)^2.
struct Moments {
  Lanes f0, f1, f2;
};

inline Moments moments_by_nodes(const Lanes& foot, const Lanes& k2, const Rule& along) {
  Moments m{};
  // Nodes by twos, which share a division.
  for (int i = 0; i < along.count; i += 2) {
    const Lanes t0 = along.node[i] - foot, t1 = along.node[i + 1] - foot;
    const Lanes r0 = k2 + t0 * t0, r1 = k2 + t1 * t1;
    const Lanes both = 1 / (r0 * r1);
    const Lanes i0 = r1 * both, i1 = r0 * both;
    const Lanes p0 = i0 * i0, p1 = i1 * i1;
    m.f0 += along.moment[0][i] * p0 + along.moment[0][i + 1] * p1;
    m.f1 += along.moment[1][i] * p0 + along.moment[1][i + 1] * p1;
    m.f2 += along.moment[2][i] * p0 + along.moment[2][i + 1] * p1;
  }
  return m;
}

/// int_0^1 x^2/(1 + y x^2)^2 dx for 0 <= y <= 1/3, by Chebyshev's polynomial.
inline Lanes first_remainder(const Lanes& y) {
  const double c[] = {0.3333333333333333,  -0.3999999999999909,  0.42857142856939173, -0.44444444426314855,
                      0.45454544606682906, -0.4615382218332075,  0.4666622226489544,  -0.4705313958196827,
                      0.4731662516268496,  -0.4727607847865892,  0.46158810931176264, -0.4203183097353883,
                      0.32451555341722865, -0.18017501469813796, 0.05152274281692483};
  constexpr int count = sizeof c / sizeof *c;
  Lanes sum = splat(c[count - 1]);
  for (int i = count - 2; i >= 0; --i) sum = sum * y + c[i];
  return sum;
}

/// As moments_about_foot (line_moments.h) does: positive terms, from the angle that the line is seen under, or where
/// the foot is beyond an end from what its arc tangent leaves after a term.
inline Moments elementary_moments(const Lanes& foot, const Lanes& k2) {
  const Lanes t0 = -foot, t1 = 1 - foot;
  const Lanes product = t0 * t1, d = k2 + product;
  const Lanes r0 = k2 + t0 * t0, r1 = k2 + t1 * t1;
  const Lanes both = 1 / (r0 * r1);
  const Lanes k = root(k2);
  const Lanes angle = angle_of(k, d);
  const Mask within = product <= k2;
  // int 1/(t^2 + k2) and int 1/(t^2 + k2)^2.
  const Lanes first_within = angle / k;
  const Lanes second_within = (first_within + (k2 - product) * both) / (2 * k2);
  const Lanes over = 1 / d;
  const Lanes y = k2 * over * over;
  const Mask small = y <= 1 / 3.;
  const Lanes e = 1 / (1 + y);
  const Lanes zeroth = select(small, Lanes{}, angle / (k * over));
  const Lanes h1 = select(small, first_remainder(select(small, y, Lanes{})), (zeroth - e) / (2 * y));
  const Lanes h0 = e + 2 * y * h1;
  const Lanes m_first = select(within, first_within, h0 * over);
  const Lanes m0 = select(within, second_within, both + h1 * (over * over * over));
  const Lanes m1 = (t0 + t1) * both / 2;
  const Lanes m2 = (m_first - (k2 - product) * both) / 2;
  return {m0, m1 + foot * m0, m2 + foot * (2 * m1 + foot * m0)};
}

/// \param moments of (foot, k2)
template <class MomentsOf>
void add_pairs(const Pairs& pairs, MomentsOf moments) {
  const QuadTable& quad = *pairs.quad;
  const Chunk& chunk = *pairs.chunk;
  Line lines[kMostLines];
  find_lines(quad, *pairs.across, lines);
  for (int first = 0; first < pairs.count; first += kLanes) {
    // A vector that is not full goes on with its last point.
    int at[kLanes];
    for (int i = 0; i < kLanes; ++i) at[i] = pairs.point[first + i < pairs.count ? first + i : pairs.count - 1];
    const Three a{quad.origin[0] - gather(chunk.at, at), quad.origin[1] - gather(chunk.at + chunk.stride, at),
                  quad.origin[2] - gather(chunk.at + 2 * chunk.stride, at)};
    // N.x = g00 + v g01 + u (g10 + v twist)
    const Lanes g00 = dot(quad.n, a), g01 = dot(quad.n_v, a), g10 = dot(quad.n_u, a);
    Lanes weight[4] = {};
    for (int j = 0; j < pairs.across->count; ++j) {
      const Line& line = lines[j];
      const Three start{a.x + line.step[0], a.y + line.step[1], a.z + line.step[2]};
      const Three area{start.y * line.e[2] - start.z * line.e[1], start.z * line.e[0] - start.x * line.e[2],
                       start.x * line.e[1] - start.y * line.e[0]};
      const Lanes foot = -dot(line.e, start) * line.over;
      const Lanes k2 = dot(area, area) * (line.over * line.over);
      const Moments f = moments(foot, k2);
      const Lanes g0 = g00 + line.v * g01, g1 = g10 + line.v * quad.twist;
      const Lanes all = g0 * f.f0 + g1 * f.f1, far = g0 * f.f1 + g1 * f.f2, near = all - far;
      weight[0] += line.left * near;
      weight[1] += line.left * far;
      weight[2] += line.right * far;
      weight[3] += line.right * near;
    }
    for (int i = 0; i < kLanes && first + i < pairs.count; ++i)
      for (int k = 0; k < 4; ++k) chunk.sums[quad.vertex[k] * static_cast<long>(chunk.stride) + at[i]] += weight[k][i];
  }
}

inline void add_by_nodes(const Pairs& pairs) {
  add_pairs(pairs, [&](const Lanes& foot, const Lanes& k2) { return moments_by_nodes(foot, k2, *pairs.along); });
}
inline void add_elementary(const Pairs& pairs) {
  add_pairs(pairs, [](const Lanes& foot, const Lanes& k2) { return elementary_moments(foot, k2); });
}

}  // namespace cageproof::adaptive_qmvc::batch::CAGEPROOF_SIMD
