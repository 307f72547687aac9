// SPDX-License-Identifier: MIT
// The derivative of a pose's rotations and tractions by its vertices.
#pragma once

#include "../turn_slopes.h"
#include "corotation.h"

namespace cageproof::deformation {

/// The slope of corotation_of(), without bulging: gamma has no share here.
template <Scalar R>
class CorotationSlopes {
 public:
  /// Changes, or weights of these: rotations as rotation vectors, [theta]x R.
  struct Rows {
    std::vector<Vec3<R>> of_vertices, of_normals, tractions;
  };

  /// \throws InputError where a rotation is not unique, and for an element without area or length
  CorotationSlopes(const CageElements& rest, const std::vector<Vec3<R>>& posed, const CorotationOptions& options);

  Rows along(const std::vector<Vec3<R>>& change) const;
  /// Adds the transposed derivative times weights.
  void add_back(const Rows& weights, std::vector<Vec3<R>>& vertices) const;

 private:
  // A rotation's change is made of the global one's and the local one's.
  struct Blend {
    Mat3<R> of_global, of_local;
  };
  struct Traction {
    Vec3<R> normal;  // posed
    R area, stretch;
  };
  void make_local(const CageElements& rest, const std::vector<Vec3<R>>& from, const std::vector<Vec3<R>>& posed,
                  const R& unit);

  RowSlopes<R> global_turn_, global_stretch_;  // a row each; of the stretch its first number
  TurnSlopes<R> local_vertices_, local_normals_;
  RowSlopes<R> local_stretches_;
  std::vector<Blend> vertex_blends_, normal_blends_;
  R local_share_;
  R factor_;  // of stretches, in tractions
  std::vector<Traction> tractions_;
  bool balance_;
  Vec3<R> xi_ = Vec3<R>::Zero();  // Eq 15
  Mat3<R> sides_inverse_ = Mat3<R>::Zero();
};

}  // namespace cageproof::deformation
