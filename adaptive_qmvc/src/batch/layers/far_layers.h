// SPDX-License-Identifier: MIT
// Layers of one quad, a vector of points at a time: Gauss-Legendre across its lines, along which they are elementary.
#pragma once

#include "line_moments.h"

namespace cageproof::adaptive_qmvc::batch::CAGEPROOF_SIMD {

/// Lines of a quad, one after the other in each array.
struct LayerLines {
  static constexpr int most = kMostLines;
  double step[3][most];                          ///< from line 0's start to this one's
  double side[3][most];                          ///< from its start to its end
  double direction[3][most];                     ///< of length one
  double length[most], over[most];               ///< and one over it
  double twice[most], half[most], square[most];  ///< of the length
  double twist[most];                            ///< of N.x: what v adds to its slope
  double left[most], right[most];                ///< weights times 1 - v and v, of integrals over lengths
  double left_w[most], right_w[most];            ///< and of those times a length from the middle
};

inline void store(double* to, const Lanes& x) { __builtin_memcpy(to, &x, sizeof x); }

inline void find_layer_lines(const QuadTable& quad, const Rule& across, LayerLines& lines) {
  // Rules have room for a last vector that is not full.
  for (int j = 0; j < across.count; j += kLanes) {
    const Lanes v = load(across.node + j), weight = load(across.moment[0] + j);
    Lanes side[3], square{};
    for (int i = 0; i < 3; ++i) {
      side[i] = quad.e[i] + v * quad.w[i];
      square += side[i] * side[i];
    }
    const Lanes length = root(square), over = 1 / length;
    for (int i = 0; i < 3; ++i) {
      store(lines.step[i] + j, v * quad.b[i]);
      store(lines.side[i] + j, side[i]);
      store(lines.direction[i] + j, side[i] * over);
    }
    store(lines.length + j, length);
    store(lines.over + j, over);
    store(lines.twice + j, 2 * length);
    store(lines.half + j, 0.5 * length);
    store(lines.square + j, length * length);
    store(lines.twist + j, v * quad.twist);
    const Lanes left = (1 - v) * weight * over, right = v * weight * over;
    store(lines.left + j, left);
    store(lines.right + j, right);
    store(lines.left_w + j, left * over);
    store(lines.right_w + j, right * over);
  }
}

/// Integrals along a line: of f and w f, for f = 1/r and N.x/r^3, w the length from the middle; and, where they are
/// wanted, for f = r and N.x/r.
struct LineLayers {
  Lanes single, single_w, twofold, twofold_w;
  Lanes growing, growing_w, steady, steady_w;
};

/// A line from `start` on, with N.x = g + w slope.
struct SeenLine {
  Three start;
  Lanes g, slope;
};

/// Integrals over lines that may end or pass next to points.
struct CloseLines {
  static constexpr int at_once = 1;
  template <int N, bool Biharmonic>
  void find(const LayerLines& lines, int j, const SeenLine* seen, LineLayers* to) const {
    const Three& start = seen->start;
    const Lanes x = splat(lines.direction[0][j]), y = splat(lines.direction[1][j]), z = splat(lines.direction[2][j]);
    const Three area{start.y * z - start.z * y, start.z * x - start.x * z, start.x * y - start.y * x};
    const Lanes length = splat(lines.length[j]), t0 = x * start.x + y * start.y + z * start.z;
    GrowingMoments growing{};
    const LineMoments m =
        moments_about(t0 + 0.5 * length, t0, t0 + length, dot(area, area), length, Biharmonic ? &growing : nullptr);
    *to = {m.inverse,
           m.step,
           seen->g * m.cube + seen->slope * m.c1,
           seen->g * m.c1 + seen->slope * m.c2,
           growing.r,
           growing.step_r,
           seen->g * m.inverse + seen->slope * m.step,
           seen->g * m.step + seen->slope * growing.step2};
  }
};

/// Integrals over lines whose ends' distances sum up to at least a twentieth more than the length: the difference of
/// their squares loses about a digit. Two lines run at once, because the instructions of one wait for each other and
/// processors look ahead no further than a line.
struct DistantLines {
  static constexpr int at_once = 2;
  template <int N, bool Biharmonic>
  void find(const LayerLines& lines, int j, const SeenLine* seen, LineLayers* to) const {
    Lanes middle[N], square0[N], square1[N], p0[N], p1[N], sum[N], y2[N], cube[N];
    Logarithm log[N];
    for (int i = 0; i < N; ++i) {
      const Three& x = seen[i].start;
      const Three end{x.x + lines.side[0][j + i], x.y + lines.side[1][j + i], x.z + lines.side[2][j + i]};
      square0[i] = dot(x, x);
      square1[i] = dot(end, end);
    }
    for (int i = 0; i < N; ++i) p0[i] = reciprocal_root(square0[i]), p1[i] = reciprocal_root(square1[i]);
    for (int i = 0; i < N; ++i) sum[i] = square0[i] * p0[i] + square1[i] * p1[i];
    for (int i = 0; i < N; ++i) {
      const Lanes sum2 = sum[i] * sum[i], left = sum2 - lines.square[j + i], over = 1 / (sum2 * left);
      y2[i] = lines.square[j + i] * (left * over);
      cube[i] = (sum[i] * (p0[i] * p1[i])) * (lines.twice[j + i] * (sum2 * over));
    }
    for (int i = 0; i < N; ++i) {
      const double length = lines.length[j + i];
      log[i] = logarithm(sum[i] + length, sum[i] - length, splat(length), sum[i], y2[i] * (sum[i] * lines.over[j + i]));
    }
    for (int i = 0; i < N; ++i) {
      const Three& x = seen[i].start;
      middle[i] = lines.direction[0][j + i] * x.x + lines.direction[1][j + i] * x.y + lines.direction[2][j + i] * x.z +
                  lines.half[j + i];
      // As about_middle, with what both integrals of N.x have in common.
      const Lanes q = middle[i] * y2[i], twofold = cube[i] * (seen[i].g - seen[i].slope * q);
      to[i].single = log[i].whole;
      to[i].single_w = -middle[i] * log[i].rest;
      to[i].twofold = twofold;
      to[i].twofold_w = seen[i].slope * log[i].rest - q * twofold;
      if constexpr (Biharmonic) {
        const Lanes height2 = (1 - y2[i]) * (0.25 * (sum[i] * sum[i]) - middle[i] * middle[i]);
        const GrowingMoments growing = growing_about_middle(log[i], y2[i] * (sum[i] * lines.over[j + i]), sum[i],
                                                            splat(lines.length[j + i]), middle[i], height2);
        to[i].growing = growing.r;
        to[i].growing_w = growing.step_r;
        to[i].steady = seen[i].g * to[i].single + seen[i].slope * to[i].single_w;
        to[i].steady_w = seen[i].g * to[i].single_w + seen[i].slope * growing.step2;
      }
    }
  }
};

/// N.(origin - eta), rounded once: from afar the plane that the origin lies in may pass the point.
inline Lanes height_over(const QuadTable& quad, const Lanes (&point)[3]) {
  Lanes high{}, low{};
  for (int i = 0; i < 3; ++i) {
    // The difference and what rounding leaves of it; its first 26 bits, and the others.
    const Lanes origin = splat(quad.origin[i]), x = origin - point[i], back = x - origin;
    const Lanes error = (origin - (x - back)) - (point[i] + back);
    const Lanes first = (Lanes)((Mask)x & ~((INT64_C(1) << 27) - 1)), others = x - first;
    const Lanes product = quad.n_high[i] * first, sum = high + product, part = sum - high;
    low +=
        ((high - (sum - part)) + (product - part)) + quad.n_high[i] * others + quad.n_rest[i] * x + quad.n[i] * error;
    high = sum;
  }
  return high + low;
}

/// Rules of no more lines are for points so far away.
inline constexpr int kLinesFromAfar = 6;

/// From sums of f and w f over length on the left, w f and f on the right: u = 1/2 + w/length.
inline void to_corners(Lanes (&s)[4]) {
  const Lanes left = 0.5 * s[0], right = 0.5 * s[3];
  s[0] = left - s[1];
  s[1] = left + s[1];
  s[3] = right - s[2];
  s[2] = right + s[2];
}

/// Sums over lines of f and w f, for one f.
struct CornerSums {
  Lanes of[4] = {};  // of f and w f on the left, of w f and f on the right

  void add(const LayerLines& lines, int j, const Lanes& f, const Lanes& f_w) {
    of[0] += lines.left[j] * f;
    of[1] += lines.left_w[j] * f_w;
    of[2] += lines.right_w[j] * f_w;
    of[3] += lines.right[j] * f;
  }
};

/// \param layers of a line
template <bool Biharmonic, class Layers>
void add_layers_of(const LayerPairs& to, const Layers& layers) {
  const Pairs& pairs = to.pairs;
  const QuadTable& quad = *pairs.quad;
  const Chunk& chunk = *pairs.chunk;
  alignas(64) LayerLines lines;  // Also aligns the frame, whose vectors would cross the lines of caches.
  find_layer_lines(quad, *pairs.across, lines);
  for (int first = 0; first < pairs.count; first += kLanes) {
    // A vector that is not full goes on with its last point.
    int at[kLanes];
    for (int i = 0; i < kLanes; ++i) at[i] = pairs.point[first + i < pairs.count ? first + i : pairs.count - 1];
    const Lanes point[3] = {gather(chunk.at, at), gather(chunk.at + chunk.stride, at),
                            gather(chunk.at + 2 * chunk.stride, at)};
    const Three a{quad.origin[0] - point[0], quad.origin[1] - point[1], quad.origin[2] - point[2]};
    // N.x at the middle of line v is g0 + v g1, and grows by g10 + v twist a line.
    const Lanes g10 = dot(quad.n_u, a), g1 = dot(quad.n_v, a) + 0.5 * quad.twist;
    const Lanes g0 = (pairs.across->count <= kLinesFromAfar ? height_over(quad, point) : dot(quad.n, a)) + 0.5 * g10;
    CornerSums single, twofold, growing, steady;
    const auto add = [&]<int N>(int j) {
      SeenLine seen[N];
      LineLayers f[N];
      for (int i = 0; i < N; ++i)
        seen[i] = {{a.x + lines.step[0][j + i], a.y + lines.step[1][j + i], a.z + lines.step[2][j + i]},
                   g0 + pairs.across->node[j + i] * g1,
                   (g10 + lines.twist[j + i]) * lines.over[j + i]};
      layers.template find<N, Biharmonic>(lines, j, seen, f);
      for (int i = 0; i < N; ++i) {
        single.add(lines, j + i, f[i].single, f[i].single_w);
        twofold.add(lines, j + i, f[i].twofold, f[i].twofold_w);
        if constexpr (Biharmonic) {
          growing.add(lines, j + i, f[i].growing, f[i].growing_w);
          steady.add(lines, j + i, f[i].steady, f[i].steady_w);
        }
      }
    };
    int j = 0;
    for (; j + Layers::at_once <= pairs.across->count; j += Layers::at_once)
      add.template operator()<Layers::at_once>(j);
    for (; j < pairs.across->count; ++j) add.template operator()<1>(j);
    const int count = pairs.count - first < kLanes ? pairs.count - first : kLanes;
    const auto put = [&](const LayerColumns& columns, CornerSums& of_vertices, CornerSums& of_corners) {
      to_corners(of_vertices.of);
      to_corners(of_corners.of);
      for (int k = 0; k < 4; ++k) {
        double* const column = columns.double_layer + quad.vertex[k] * static_cast<long>(chunk.stride);
        double* const corner = columns.single_layer + to.corner[k];
        for (int i = 0; i < count; ++i) {
          column[at[i]] += of_vertices.of[k][i];
          corner[4 * at[i]] = of_corners.of[k][i];
        }
      }
    };
    put(to.harmonic, twofold, single);
    if constexpr (Biharmonic) put(to.biharmonic, steady, growing);
  }
}

}  // namespace cageproof::adaptive_qmvc::batch::CAGEPROOF_SIMD
