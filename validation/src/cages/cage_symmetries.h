// SPDX-License-Identifier: MIT
// Properties of cage coordinates under a change of the cage that changes them in a known way.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/validation/cage_terms.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cageproof::validation {

/// A cage, what its coordinates are summed over as a cage of its own, and that cage scaled, turned, with its corners
/// permuted (where an element is the same from its next corner on), and subdivided.
class CageSymmetries {
 public:
  CageSymmetries(const Cage& cage, const CoordinateKind& kind, const std::string& evaluation, Triangulation rule);
  /// \param base the cage's coordinates by that evaluation \param terms those that they are judged by
  CageSymmetries(const Cage& cage, const std::string& evaluation, CageCoordinates base, CageTerms terms);

  /// The checks that errors_at() answers of coordinates, without preparing any.
  static std::vector<std::string> checks_of(const CageCoordinates& coordinates);

  /// By check (cage_scaling, cage_rigid_motion, cage_corner_permutation, cage_subdivision for sums over faces): the
  /// largest difference over the blocks, in roundings of the block's terms, with those that a logarithm adds in another
  /// unit, and relative to the block's norm. \pre the point lies off the cage
  std::map<std::string, CageError> errors_at(const Vec3<double>& point) const;

  /// Relative difference between the derivatives of order 1 and 2 along a direction and central differences in 100
  /// digits, for the worst block. \pre as errors_at
  std::array<double, 3> differences_at(const Vec3<double>& point) const;

 private:
  /// A coordinate of the base, and how much of a variant's is part of it.
  struct Share {
    int coordinate;
    double weight;
  };
  /// Shares of a variant's coordinates in those of the base, by owner: vertex, element, corner or normal.
  using Shares = std::array<std::vector<std::vector<Share>>, 4>;
  struct Variant {
    std::string check;
    CageCoordinates coordinates;
    Shares shares;
    double unit = 1;
    bool turned = false;
    /// The cage that it is a variant of, where that is not the base.
    std::optional<CageCoordinates> of = {};
  };
  /// The base's elements, in four or two parts each.
  struct Subdivision {
    std::vector<Vec3<double>> vertices;
    std::vector<Face> elements;
    Shares shares;
  };
  Variant variant(std::string check, const Cage& cage, const CoordinateKind& kind, const std::string& evaluation) const;
  static Subdivision subdivision(const CageElements& elements);
  static void add_normals_of_part(const CageElements& elements, std::size_t element, const ElementPart& part,
                                  std::vector<std::vector<Share>>& all);
  std::vector<double> folded(const Variant& v, std::size_t block, const Result<double>& found,
                             const Vec3<double>& point) const;

  /// Terms that another unit of length adds to coordinates whose kernels have the logarithm of the distance, over the
  /// unit's power, and the size of these terms. Both are laid out as coordinates are; empty for other kinds.
  struct Added {
    std::vector<double> value, size;
  };
  Added added(const Variant& v, std::size_t block, const Vec3<double>& point) const;

  double size_;
  CageCoordinates base_;
  CageTerms terms_;
  std::vector<Variant> variants_;
};

}  // namespace cageproof::validation
