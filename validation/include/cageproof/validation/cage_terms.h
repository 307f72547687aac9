// SPDX-License-Identifier: MIT
// The terms of cage coordinates as sums, in which their rounding is counted.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

#include <limits>

namespace cageproof::validation {

/// Sizes of the terms of sums over a cage's elements, by derivative order. A sum of terms that are each off by a few
/// roundings u is off by a few u times their size: where they cancel, as those of the two sides of a thin wall do, by
/// more than a few roundings of the result.
///
/// For normalised coordinates lambda = w/W the terms are those of the quotient rule: t_0 = a_0, t_1 = a_1 + t_0 g_1,
/// t_2 = a_2 + t_0 g_2 + 2 t_1 g_1. Here a_o is the sum of the norms of the weights' derivatives of order o, and g_o
/// the norm of those of W, both over |W|. In blocks, the coordinates' derivatives times the roundings of W and its
/// derivatives are terms as well; the sums over all coordinates are known, and have no such terms. Kinds that are not
/// sums have their coordinates as terms, unless they say which (CageCoordinates::terms_at).
///
/// Evaluations of whole coordinates are promised in units of what rounding the cage in its own frame costs: for them
/// values and gradients count the cage's size times the sum of the derivatives along the axes as well, as block errors
/// do.
struct TermSizes {
  std::array<double, 3> ones{};       ///< of the sum of all coordinates
  std::array<double, 3> positions{};  ///< of the sum of all coordinates times positions, or normals
  /// By block, norm-wise over its coordinates, of each coordinate by itself.
  std::vector<std::array<double, 3>> blocks;
};

/// An error as it is promised, and as a reader counts digits. NaN: not asked there, or no truth.
struct CageError {
  /// In roundings of the terms: over u times the size of the terms that the sums are made of (TermSizes).
  double roundings = std::numeric_limits<double>::quiet_NaN();
  double relative = std::numeric_limits<double>::quiet_NaN();
};

/// The Euclidean norm.
double length_of(std::span<const double> values);

/// A cage's coordinates, asked for the terms of their sums. Safe from any thread.
class CageTerms {
 public:
  /// The terms are those of the recommended evaluation.
  /// \param judged the evaluation that is counted in them
  CageTerms(const Cage& cage, const CoordinateKind& kind, Triangulation rule, std::string_view judged = {});
  /// \param coordinates those of the cage by recommended evaluations
  CageTerms(const Cage& cage, CageCoordinates coordinates, std::string_view judged = {});
  /// \pre the point lies off the cage, or the kind is no sum; order <= CageCoordinates::max_order()
  TermSizes at(const Vec3<double>& point, int order) const;

 private:
  struct Sums;
  Sums sums_of_terms(const Vec3<double>& point, int order) const;
  Sums sums_of_coordinates(const Vec3<double>& point, int order) const;
  double weight_of(std::size_t block, int coordinate) const;
  TermSizes sizes_of_terms(const Vec3<double>& point, int order) const;
  void add_moved_point(const Vec3<double>& point, int order, TermSizes& sizes) const;

  double moved_;  // by how much the point is moved: the cage's size, or not at all
  CageCoordinates coordinates_;
  std::vector<double> parameters_;
  /// By kind of element, one per block.
  std::array<std::vector<Evaluation>, element_kinds.size()> evaluations_;
};

}  // namespace cageproof::validation
