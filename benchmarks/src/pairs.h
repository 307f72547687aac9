// SPDX-License-Identifier: MIT
// The inputs that all evaluations of a formula are timed on.
#pragma once

#include "cageproof/core/catalogue/evaluation.h"

#include <vector>

namespace cageproof::benchmarks {

/// An element and a point.
struct Pair {
  std::vector<Vec3<double>> corners;
  Vec3<double> point = Vec3<double>::Zero();
};

/// How many pairs a formula is timed on.
inline constexpr int kPairCount = 200;

/// kPairCount pairs for elements of that kind, the same in every run: the longest side is one, the area (a segment's
/// length) at least 0.1, the point 0.5 to 1.5 sides from the centroid in any direction. Nothing is exactly degenerate:
/// closed forms take their usual branches, quadrature rules do their usual work.
std::vector<Pair> generic_pairs(ElementKind element);

}  // namespace cageproof::benchmarks
