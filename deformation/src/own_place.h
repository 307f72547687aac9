// SPDX-License-Identifier: MIT
// Frames of a pose's own, near its vertices, in which images are made.
#pragma once

#include "cageproof/deformation/deformer.h"

namespace cageproof::deformation {

/// A place next to points, from which their coordinates are less than twice their box's longest side: steps from there
/// to the points are doubles exactly. Zero for points that are as near to the origin, which stay as they are, and for
/// points that are not finite.
Vec3<double> own_place(const std::vector<Vec3<double>>& points);

/// A pose whose images and vertices are found so far from where they are.
template <Scalar R>
std::unique_ptr<const Posed<R>> shifted(std::unique_ptr<const Posed<R>> posed, const Vec3<double>& by, int dimension);

/// A pose that `shifted` has made, as it was given, and what is added to its images; others with zero.
std::pair<const Posed<double>*, Vec3<double>> without_shift(const Posed<double>& posed);

/// The deformer with poses taken to their own place, and images taken back. Images are sums of coordinates times data,
/// and coordinates are rounded: their roundings are multiplied with the posed vertices' coordinates, which far from the
/// origin are much larger than the cage. All methods commute with shifts of the pose, so that the map is the same.
template <Scalar R>
std::shared_ptr<const Deformer<R>> in_own_place(std::shared_ptr<const Deformer<R>> deformer);

}  // namespace cageproof::deformation
