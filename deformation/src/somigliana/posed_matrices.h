// SPDX-License-Identifier: MIT
// Places that coordinates of 3 x 3 matrices make of a pose, without derivatives.
#pragma once

#include "../in_space.h"

#include <span>
#include <vector>

namespace cageproof::deformation {

/// x' = T^-1 y, T = sum R_i T_i R_i^t, y = sum R_i T_i u_i + sum R_j K_j w_j, in space ([C23] Eq 11).
class PosedMatrices {
 public:
  /// The data that a block of coordinates multiplies: R, and u or w.
  struct Data {
    const std::vector<SpaceMatrix<double>>& rotations;
    const std::vector<SpaceVector<double>>& turned;
  };

  PosedMatrices() = default;
  PosedMatrices(const Data& vertices, const Data& tractions);

  /// \param of_vertices, of_tractions a point's matrices T_i and K_j, [coordinate][row][column]
  Vec3<double> image(std::span<const double> of_vertices, std::span<const double> of_tractions) const;

 private:
  struct Block {
    std::vector<Mat3<double>> rotations;
    std::vector<Vec3<double>> turned;
    std::vector<double> thrice;  // of `turned`, each three times: a factor for each entry of a matrix
  };
  static Block block_of(const Data& data);

  Block vertices_, tractions_;
  bool is_one_rotation_ = false;  // for all: then it comes out of the sums
};

}  // namespace cageproof::deformation
