// SPDX-License-Identifier: MIT
// Gauss points for triangles that are far away for their size. Plain arrays, as the tables of cages are.
#pragma once

namespace cageproof::closed_form::batch {

/// The most points of a rule, and to how many arrays are filled up with points of no weight.
inline constexpr int kMostNodes = 110, kPaddedNodes = 112;
/// Monomials of two variables up to the fifth degree.
inline constexpr int kMostMonomials = 21;

/// A rule for triangles with positive weights and points inside, which integrates all polynomials up to its degree.
struct FarRule {
  int degree, nodes;               ///< of polynomials; of points
  double along[2][kPaddedNodes];   ///< a point less corner 0, over the edges from there to corners 1 and 2
  double weight[kPaddedNodes][4];  ///< hat functions times weights, and weights, whose sum is one
  /// Weights times monomials of `along`: 1, a, b, aa, ab, bb, aaa, aab ...
  double monomial[kPaddedNodes][kMostMonomials];
  /// By the order of derivatives: how many times further than its corners the point must be from the triangle's
  /// centroid. Then errors of hat functions times p^k/r^(2k + 3), k being that order, and of Kelvin's p^(k+2)/r^(2k +
  /// 5) are at most 2^-48 of their absolute values' integral. Mean values' p^k/r^(2k + 4) take the next order's.
  double least[4];
};

/// Gauss-Legendre points of an edge, from 0 to 1, for edges of far faces.
struct LineRule {
  static constexpr int nodes = 10;
  double along[nodes], weight[nodes];
};

/// The first are quicker than closed forms or no less exact; the rest, products of Gauss-Legendre rules, are for faces
/// that would be summed in double-doubles.
inline constexpr int kQuickRules = 7, kFarRules = 9;

/// kFarRules rules, in the order of rising degrees.
const FarRule* far_rules();
const LineRule* line_rule();

}  // namespace cageproof::closed_form::batch
