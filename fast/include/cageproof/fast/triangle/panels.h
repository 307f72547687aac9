// SPDX-License-Identifier: MIT
// A triangle cut into panels that are far from the point for their size, and sums over Gauss points on these.
#pragma once

#include "cageproof/closed_form/triangle/engine/exact_frame.h"

#include <boost/container/small_vector.hpp>

namespace cageproof::fast::triangle {

using namespace closed_form;
using namespace closed_form::triangle;

/// A triangle within the element, in the frame's unit, and how many Gauss points are taken on it: `across` along its
/// two longer edges, from the corner that they have in common, and `along` the shortest.
struct Panel {
  Vec3<double> corner, side, base;  ///< corners are at corner, corner + side, corner + side + base, seen from the point
  double hat[3][3];                 ///< hat functions, each at the panel's corners
  double area2;
  int across, along;
};

using Panels = boost::container::small_vector<Panel, 4>;

/// A request for sums of hat functions times r^power and derivatives up to `degree`: errors of at most kFarTolerance of
/// the sum of sizes, with at most `points` points.
struct PanelsWanted {
  int steepness;  ///< |power| + degree: each power of 1/r, and each derivative, asks for more points
  int points;

  bool operator==(const PanelsWanted&) const = default;
};

/// Cuts the triangle at the middles of longest edges, until Gauss points on each panel reach the accuracy wanted.
/// Corners are rounded from double-doubles, so that a panel next to the point is placed as exactly as one far away.
/// \return none where more points would be needed
Panels cut_to_panels(const Frame<double>& frame, const Triangle<double>& t, const Vec3<double>& eta,
                     const PanelsWanted& wanted);

/// int Gamma_k r^power of each corner k, as Taylor polynomials in a displacement of the point.
struct PanelSums {
  static constexpr int kDegree = 4, kCoefficients = 35;
  double sums[3][kCoefficients] = {};
  double sizes[3][kDegree + 1] = {};  ///< where asked for: int Gamma_k r^(power - j), what errors are relative to
};

/// \param power 1, -1, -3 or -4 \param degree at most 4
void sum_panels(const Panels& panels, int power, int degree, bool sized, PanelSums& to);

}  // namespace cageproof::fast::triangle
