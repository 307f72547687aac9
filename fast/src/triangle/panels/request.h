// SPDX-License-Identifier: MIT
// The request to sums over Gauss points, which are compiled once for each instruction set. The library's other headers
// must not be included there, because their inline functions must not be compiled for one set only.
#pragma once

namespace cageproof::fast::triangle {

/// The most coefficients of a Taylor polynomial: those of degree four in three variables.
inline constexpr int kMostCoefficients = 35, kHighestDegree = 4;

/// The points of a collapsed product rule on the unit square, filled up to whole vectors with points of no weight.
struct PanelRule {
  const double* u;
  const double* v;
  const double* weight;  ///< of both directions and the collapsed corner
  int count;             ///< a multiple of eight
};

/// The sums over one panel, a triangle with corners a, a + side, a + side + base as the point sees them: the three
/// affine weights times r^power, as Taylor polynomials in a displacement of the point.
struct PanelRequest {
  PanelRule rule;
  double a[3], side[3], base[3];
  double hat[3][3];  ///< of each weight, at each of the panel's corners
  double area2;
  int power, degree;
  double* sums;   ///< [3][kMostCoefficients], added to
  double* sizes;  ///< [3][kHighestDegree + 1] or nullptr: the same sums of r^(power - k), added to
};

using PanelSum = void (*)(const PanelRequest&);
extern const PanelSum panel_sum_plain, panel_sum_avx2, panel_sum_avx512;

}  // namespace cageproof::fast::triangle
