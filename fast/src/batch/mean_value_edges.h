// SPDX-License-Identifier: MIT
// Integrals over one edge that mean value coordinates and their derivatives are made of, a vector of points at a time.
//
// An edge of length L is seen under the angle t; its line is at the distance D, its ends at r0 and r1, at s0 and s1
// along it. With q = L/(r0 r1), c = cos t = (D2 + s0 s1)/(r0 r1) and s = sin t = D q,
//   C3 = (t - s c)/s^3,  C5 = (3 (t - s c)/8 - s^3 c/4)/s^5,
//   int r^-2 = q (c + s2 C3),  int r^-4 = q2/L + C3 q3/2,  int r^-6 = q4 (L2 + D2 + s0 s1)/L3 + C5 q5.
// C5 is a polynomial of s2 where t is small, so that nothing is divided by D: points on the edge's line beyond its ends
// are like others.
#pragma once

#include "cageproof/closed_form/batch/lanes.h"

#include "seen_vertex.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// The part that one edge's integrals have in common.
struct Chord {
  Lanes q, c, square;  ///< q, cos t, s2
  Lanes c3, c5;
  Lanes cube, fifth;  ///< C3 q3/2 and C5 q5
};

/// \param over 1/(r0 r1) \param distance D \param cosine D2 + s0 s1
inline Chord chord_of(double length, Lanes distance, Lanes cosine, Lanes over) {
  Chord chord;
  chord.q = length * over;
  chord.c = cosine * over;
  const Lanes sine = distance * chord.q;
  const Lanes x = chord.square = sine * sine, x2 = x * x, x4 = x2 * x2;
  // The polynomial through C5 at Chebyshev's points of 0 <= s2 <= 1/4, which leaves 7e-17 of it.
  chord.c5 =
      (((0.2 + 0.07142857142855619 * x) + (0.04166666667006989 + 0.02840909061149304 * x) * x2) +
       ((0.021033667320704403 + 0.016405888413390666 * x) + (0.01327595675621231 + 0.010954233927230543 * x) * x2) *
           x4) +
      (((0.00989732968080362 + 0.005211433227594654 * x) + (0.016858943457613036 - 0.014481023531119205 * x) * x2) +
       0.027931651359011038 * x4) *
          (x4 * x4);
  const Mask wide = (x > splat(0.25)) | (chord.c < Lanes{});
  if (any(wide)) {
    const Lanes product = sine * chord.c;
    const Lanes c5 = (0.375 * (angle_of(sine, chord.c) - product) - 0.25 * x * product) / (x2 * sine);
    chord.c5 = select(wide, c5, chord.c5);
  }
  chord.c3 = (2 / 3.) * chord.c + (8 / 3.) * x * chord.c5;
  const Lanes q2 = chord.q * chord.q;
  chord.cube = 0.5 * chord.c3 * (q2 * chord.q);
  chord.fifth = chord.c5 * (q2 * q2 * chord.q);
  return chord;
}

/// Integrals over an edge, in its table's direction; hat functions are those of its ends, along it. In brackets the
/// derivatives that take them.
struct MeanValueEdge {
  Lanes square, ends;  ///< D2, s0 s1
  Lanes k2, k4;        ///< int r^-2, int r^-4
  Lanes hat[2];        ///< int hat r^-4
  Lanes k6;            ///< int r^-6 (second)
  Lanes slope[2];      ///< derivative of int hat r^-4 along the edge (second)
  Lanes sixth[2];      ///< int hat r^-6 (second)
  Mask near;           ///< the point is so near to the edge that its faces need more digits
};

/// An edge's line as the points see it, from the edge's nearer end: further ones would leave their own rounding.
struct SeenLine {
  Lanes distance, s0, s1;  ///< D, and where the ends are along it
};
inline SeenLine seen_line(const EdgeTable<double>& e, const SeenVertex& from, const SeenVertex& to) {
  const Mask first = from.r < to.r;
  Three<Lanes> near, normal;
  for (int i = 0; i < 3; ++i) near[i] = select(first, from.x[i], to.x[i]);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    normal[i] = near[k] * e.u[j] - near[j] * e.u[k];
  }
  const Lanes s = dot(e.u, near);
  return {root(dot(normal, normal)), select(first, s, s - e.length), select(first, s + e.length, s)};
}

/// A face's height, outward, and those of its edges over the projection, each from its nearest corner.
struct SeenHeights {
  Lanes d, h[3];
};
/// \param height of fine_heights
inline SeenHeights seen_heights(const FaceTable<double>& face, const SeenVertex* const (&corner)[3], Lanes height) {
  SeenHeights seen;
  seen.d = height;
  for (int e = 0; e < 3; ++e) {
    const SeenVertex &a = *corner[e], &b = *corner[(e + 1) % 3];
    seen.h[e] = select(a.r < b.r, dot(face.nu[e], a.x), dot(face.nu[e], b.x));
  }
  return seen;
}

/// Distances from an edge's line beside the edge, over its length, below which its faces need more digits.
inline constexpr double kBesideEdge = 0x1p-7;

template <int O>
MeanValueEdge mean_value_edge(const EdgeTable<double>& e, const SeenVertex& a, const SeenVertex& b) {
  MeanValueEdge edge;
  const Lanes r0 = a.r, r1 = b.r;
  const auto [distance, s0, s1] = seen_line(e, a, b);
  const Lanes over = 1 / (r0 * r1), over2 = over * over;
  edge.square = distance * distance;
  edge.ends = s0 * s1;
  edge.near = (edge.ends < Lanes{}) & (distance < splat(kBesideEdge * e.length));
  const Chord chord = chord_of(e.length, distance, edge.square + edge.ends, over);
  edge.k2 = chord.q * (chord.c + chord.square * chord.c3);
  const Lanes half = 0.5 * e.length * over2, from = s0 * e.over, to = s1 * e.over;
  edge.k4 = half + half + chord.cube;
  edge.hat[0] = half + to * chord.cube;
  edge.hat[1] = half - from * chord.cube;
  if constexpr (O >= 2) {
    const double square = e.length * e.length;
    const Lanes over4 = over2 * over2 * e.length, rise = (s0 + s1) * e.length * over2, step = chord.cube * e.over;
    edge.k6 = over4 * (edge.square + edge.ends + square) + chord.fifth;
    edge.slope[0] = rise / (r0 * r0) - step;
    edge.slope[1] = rise / (r1 * r1) + step;
    edge.sixth[0] = 0.5 * over4 * (r1 * r1 + 0.5 * square) + to * chord.fifth;
    edge.sixth[1] = 0.5 * over4 * (r0 * r0 + 0.5 * square) - from * chord.fifth;
  }
  return edge;
}

/// int 1/(r2 rho2) and int 1/(r4 rho2) over an edge, rho the distance from the point's projection to the face's plane:
/// integrals over 0 <= t <= 1 of int r^-4 and of 2 t int r^-6, where the height's square is t times its own. Gauss
/// points are enough where the edge is further than three heights away.
struct InPlane {
  Lanes fourth{}, sixth{};
};
template <int O>
InPlane in_plane(double length, const MeanValueEdge& e, Lanes h, Lanes height) {
  constexpr int points = 6;
  constexpr double at[points] = {0.033765242898423989, 0.16939530676686774, 0.38069040695840156,
                                 0.61930959304159849,  0.83060469323313224, 0.96623475710157603};
  constexpr double weight[points] = {0.085662246189585178, 0.18038078652406930, 0.23395696728634552,
                                     0.23395696728634552,  0.18038078652406930, 0.085662246189585178};
  InPlane sum;
  const Lanes h2 = h * h, d2 = height * height;
  const double square = length * length;
  for (int i = 0; i < points; ++i) {
    const Lanes d = h2 + at[i] * d2, cosine = d + e.ends;
    const Lanes over = 1 / root(cosine * cosine + square * d), over2 = over * over;
    const Chord chord = chord_of(length, root(d), cosine, over);
    sum.fourth += weight[i] * (length * over2 + chord.cube);
    if constexpr (O >= 2)
      sum.sixth += (2 * at[i] * weight[i]) * (length * over2 * over2 * (cosine + square) + chord.fifth);
  }
  return sum;
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
