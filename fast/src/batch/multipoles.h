// SPDX-License-Identifier: MIT
// Expansions of clusters of faces in solid harmonics, for one instruction set.
//
// With R_l^m = r^l P_l^m(cos t) e^(i m f)/(l + m)! and S_l^m = (l - m)! P_l^m(cos t) e^(i m f)/r^(l + 1), without
// (-1)^m, 1/|x - y| = sum of R_l^m(y) conj(S_l^m(x)) over l and |m| <= l (Dehnen 2014, Appendix A). Lengths are in
// radii of the cluster, from its centre.
#pragma once

#include "cageproof/closed_form/batch/lanes.h"

#include "cluster_kernels.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// A cluster's functions at a block of points.
inline void sum_far_cluster(const FarCluster& cluster) {
  constexpr int sets = kMomentSets;
  const auto* const point = reinterpret_cast<const Lanes*>(cluster.points);
  const Lanes x = (point[0] - cluster.centre[0]) * cluster.over, y = (point[1] - cluster.centre[1]) * cluster.over,
              z = (point[2] - cluster.centre[2]) * cluster.over;
  const Lanes square = x * x + y * y + z * z, u = 1 / square, xu = x * u, yu = y * u;
  Lanes rise[kMostMomentOrder + 1];  // (2 l + 1) z/r^2
  for (int l = 0; l <= cluster.order; ++l) rise[l] = (2 * l + 1) * (z * u);
  Lanes sum[sets];
  Lanes first = root(u), re = splat(1), im{};  // first: (2 m - 1)!!/r; re + i im: ((x + i y)/r^2)^m
  {
    const double* moment = cluster.moments;
    Lanes before{}, here = first;
    for (Lanes& s : sum) s = Lanes{};
    for (int l = 0; l <= cluster.order; ++l, moment += sets) {
      for (int s = 0; s < sets; ++s) sum[s] += moment[s] * here;
      const Lanes next = rise[l] * here - static_cast<double>(l * l) * (u * before);
      before = here;
      here = next;
    }
  }
  const double* moments = cluster.moments + sets * (cluster.stored + 1);
  for (int m = 1; m <= cluster.order; ++m) {
    first *= 2 * m - 1;
    const Lanes turned = re * xu - im * yu;
    im = re * yu + im * xu;
    re = turned;
    Lanes real[sets], imaginary[sets];
    for (int s = 0; s < sets; ++s) real[s] = imaginary[s] = Lanes{};
    Lanes before{}, here = first;
    const double* moment = moments;
    for (int l = m; l <= cluster.order; ++l, moment += 2 * sets) {
      for (int s = 0; s < sets; ++s) {
        real[s] += moment[s] * here;
        imaginary[s] += moment[sets + s] * here;
      }
      const Lanes next = rise[l] * here - static_cast<double>(l * l - m * m) * (u * before);
      before = here;
      here = next;
    }
    for (int s = 0; s < sets; ++s) sum[s] += real[s] * re + imaginary[s] * im;
    moments += 2 * sets * (cluster.stored + 1 - m);
  }
  auto* const to = reinterpret_cast<Lanes*>(cluster.sums);
  for (int s = 0; s < sets; ++s) to[s] = sum[s];
}

/// Adds sources to moments that lie as [l (l + 1)/2 + m][real, imaginary][set][lanes]: degree by degree, so that no
/// more than three degrees of R_l^m are kept, each [m][real, imaginary][block].
inline void add_moments(const MomentSources& sources) {
  constexpr int sets = kMomentSets, blocks = kMomentBlocks;
  const auto* const place = reinterpret_cast<const Lanes*>(sources.places);
  const auto* const n = reinterpret_cast<const Lanes*>(sources.normals);
  const auto* const charge = reinterpret_cast<const Lanes*>(sources.charges);
  const auto* const dipole = reinterpret_cast<const Lanes*>(sources.dipoles);
  using Harmonic = Lanes[2][blocks];
  auto* const rows = static_cast<Harmonic*>(sources.scratch);
  const int stride = sources.order + 1;
  Lanes square[blocks];
  for (int b = 0; b < blocks; ++b)
    square[b] =
        place[b] * place[b] + place[blocks + b] * place[blocks + b] + place[2 * blocks + b] * place[2 * blocks + b];
  auto* to = reinterpret_cast<Lanes*>(sources.sums);
  for (int l = 0; l <= sources.order; ++l) {
    Harmonic* const here = rows + l % 3 * stride;
    const Harmonic* const below = rows + (l + 2) % 3 * stride;
    const Harmonic* const far_below = rows + (l + 1) % 3 * stride;
    for (int m = 0; m <= l; ++m)
      for (int b = 0; b < blocks; ++b) {
        const Lanes x = place[b], y = place[blocks + b], z = place[2 * blocks + b];
        if (l == 0) {
          here[0][0][b] = splat(1);
          here[0][1][b] = Lanes{};
        } else if (m == l) {
          const double half = 0.5 / m;
          here[m][0][b] = half * (x * below[m - 1][0][b] - y * below[m - 1][1][b]);
          here[m][1][b] = half * (x * below[m - 1][1][b] + y * below[m - 1][0][b]);
        } else if (m == l - 1) {
          for (int i = 0; i < 2; ++i) here[m][i][b] = z * below[m][i][b];
        } else {
          const double over = 1. / (l * l - m * m), twice = (2 * l - 1) * over;
          for (int i = 0; i < 2; ++i)
            here[m][i][b] = twice * (z * below[m][i][b]) - over * (square[b] * far_below[m][i][b]);
        }
      }
    for (int m = 0; m <= l; ++m, to += 2 * sets) {
      Lanes sum[2][sets];
      for (int s = 0; s < sets; ++s) {
        sum[0][s] = to[s];
        sum[1][s] = to[sets + s];
      }
      for (int b = 0; b < blocks; ++b) {
        // n grad R, from d/dz R_l^m = R_(l-1)^m and (d/dx -+ i d/dy) R_l^m = +- R_(l-1)^(m -+ 1).
        const Lanes nx = n[b], ny = n[blocks + b];
        Lanes re{}, im{};
        if (m + 1 < l) {
          const double twice = m == 0 ? -1 : -0.5;
          re = twice * (nx * below[m + 1][0][b] + ny * below[m + 1][1][b]);
          if (m > 0) im = -0.5 * (nx * below[m + 1][1][b] - ny * below[m + 1][0][b]);
        }
        if (m > 0) {
          re += 0.5 * (nx * below[m - 1][0][b] - ny * below[m - 1][1][b]);
          im += 0.5 * (nx * below[m - 1][1][b] + ny * below[m - 1][0][b]);
        }
        if (m < l) {
          re += n[2 * blocks + b] * below[m][0][b];
          im += n[2 * blocks + b] * below[m][1][b];
        }
        for (int s = 0; s < sets; ++s) {
          const Lanes c = charge[s * blocks + b], d = dipole[s * blocks + b];
          sum[0][s] += c * here[m][0][b] + d * re;
          sum[1][s] += c * here[m][1][b] + d * im;
        }
      }
      for (int s = 0; s < sets; ++s) {
        to[s] = sum[0][s];
        to[sets + s] = sum[1][s];
      }
    }
  }
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
