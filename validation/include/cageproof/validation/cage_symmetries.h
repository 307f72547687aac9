// SPDX-License-Identifier: MIT
// Properties of cage coordinates under a change of the cage that changes them in a known way.
#pragma once

#include "cageproof/core/coordinates.h"

#include <map>

namespace cageproof::validation {

/// A cage, what its coordinates are summed over as a cage of its own, and that cage scaled, turned, with its corners permuted, and subdivided.
class CageSymmetries {
 public:
  CageSymmetries(const Cage& cage, const CoordinateKind& kind, const std::string& evaluation, Triangulation rule);

  /// By check (cage_scaling, cage_rigid_motion, cage_corner_permutation, cage_subdivision for sums over faces): the largest difference over the blocks,
  /// relative to the block's norm. \pre the point lies off the cage
  std::map<std::string, double> errors_at(const Vec3<double>& point) const;

  /// Derivatives of order 1 and 2 against central differences in 100 digits, relative, of the worst block. \pre as errors_at
  std::array<double, 3> differences_at(const Vec3<double>& point) const;

 private:
  struct Variant {
    std::string check;
    CageCoordinates coordinates;
    /// For each of its vertices, whose coordinate a part of this one's is; for each element, whose part it is.
    std::vector<std::vector<int>> vertex_parts;
    std::vector<int> element_of;
    double unit;
    bool turned;
  };
  Variant variant(std::string check, const std::string& name, const std::vector<Vec3<double>>& vertices,
                         const std::vector<Face>& faces, const CoordinateKind& kind, const std::string& evaluation) const;

  double size_;
  bool allow_invalid_quads_;
  CageCoordinates base_;
  std::vector<Variant> variants_;
};

}  // namespace cageproof::validation
