// SPDX-License-Identifier: MIT
// Poses that deformers are judged with: maps of space, which some of them keep, and one that is no such map.
#pragma once

#include "cageproof/core/cage/cage.h"

#include <Eigen/Core>

#include <array>
#include <string_view>
#include <vector>

namespace cageproof::validation {

/// A map of space x -> linear x + shift that a cage is posed by, and the check that asks whether deformers keep it.
struct SpaceMap {
  std::string_view check, pose;
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  Vec3<double> shift = Vec3<double>::Zero();  ///< in cage sizes

  /// With more digits than double, so that in a cage far from the origin a map's own roundings are not taken for
  /// those of whoever keeps it.
  template <class R = long double>
  Vec3<R> exactly(const Vec3<double>& x, double size) const {
    Vec3<R> found;
    for (int c = 0; c < 3; ++c) {
      found[c] = R(size) * R(shift[c]);
      for (int j = 0; j < 3; ++j) found[c] += R(linear(c, j)) * R(x[j]);
    }
    return found;
  }
  /// Rounded once.
  Vec3<double> operator()(const Vec3<double>& x, double size) const { return exactly(x, size).cast<double>(); }
};

/// Identity, shift and rotation (keeps_rigid), scale 1.5 (keeps_scale), the last axis reversed (keeps_mirror), and a
/// general linear map (keeps_linear), in a space of that dimension.
std::vector<SpaceMap> space_maps(int dimension);

/// Shifts by a thousand and by a million sizes (keeps_offset), of a cage that is not posed.
std::array<SpaceMap, 2> offsets(int dimension);

/// The largest absolute coordinate of all points.
double largest_coordinate(const std::vector<Vec3<double>>& points);

/// The cage's vertices under a map.
std::vector<Vec3<double>> posed_by(const SpaceMap& map, const Cage& cage);

/// The name of the pose that is no map of space.
inline constexpr std::string_view bent_pose = "bent";

/// The names of the same pose made symmetric across each axis.
inline constexpr std::array<std::string_view, 3> symmetric_poses{"symmetric in x", "symmetric in y", "symmetric in z"};

/// Each vertex moved by itself, by up to a twentieth of the cage's size along each axis: a function of the cage's name
/// and the vertex's number.
std::vector<Vec3<double>> bent(const Cage& cage);

}  // namespace cageproof::validation
