// SPDX-License-Identifier: MIT
// The error of whole coordinates at one point, in what rounding the cage in its own frame costs them.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/validation/cage_points.h"
#include "cageproof/validation/cage_terms.h"

#include <memory>
#include <optional>

namespace cageproof::validation {

/// All coordinates at one point in 50 digits, one entry per block, and what their errors are counted in.
struct BlockTruth {
  std::vector<Result<Mp50>> blocks;
  /// By block and order: size times the sum, over the coordinates x_k of the point, of |d truth/d x_k|, `size` the
  /// cage's diagonal; of Hessians size times the derivative along one direction that is like no other point's, which is
  /// at most that sum.
  ///
  /// For normalised coordinates lambda = w/W it includes the cost of one rounding of each weight's derivatives, by the
  /// quotient rule. With a_o, l_o, g_o the norms of the derivatives of order o of w over |W|, of lambda, and of W over
  /// |W|, and b_o the sum of the vertices' norms (a_o is the root of the sum of their squares):
  ///   q_0 = l_0 (b_0 - 1),  q_1 = a_1 + l_0 b_1 + l_1 b_0 + l_0 b_0 g_1,
  ///   q_2 = a_2 + l_0 b_2 + 2 l_1 b_1 + l_2 b_0 + l_0 b_0 g_2 + 2 q_1 g_1.
  /// q_0 is zero where all weights are positive. Far outside their sum cancels by the distance in sizes, and a rounding
  /// of any corner of the cage costs as much, though none is within a face's size of the point.
  std::vector<std::array<Mp50, 3>> moved;
  int order = 0;
};

/// The truth of a kind of coordinates in a cage: sums of the formulas' recommended evaluations in 50 digits, whose
/// agreement with the defining integrals other checks prove. Safe from any thread.
class BlockTruths {
 public:
  /// \pre the kind is a sum over elements \throws InputError as CageCoordinates
  BlockTruths(const Cage& cage, const CoordinateKind& kind, Triangulation rule);

  /// On the cage the limits from inside; derivatives that do not exist are not finite there, and what moving the point
  /// costs the finite ones is taken 1e-11 of the size inside, nothing where no such point is found. Third
  /// derivatives are differences of Hessians.
  /// \return nothing where evaluations in 50 and in 100 digits differ by more than a thousandth of a unit
  std::optional<BlockTruth> at(const Vec3<double>& point, int order) const;

 private:
  /// \param limits on the cage, the truth itself, which the point is next to; empty elsewhere
  BlockTruth truth_near(const Vec3<Mp50>& point, double distance, int order, std::vector<Result<Mp50>> limits) const;
  BlockTruth truth_on(const Vec3<double>& point, int order) const;
  bool agrees(const BlockTruth& truth, const Vec3<double>& point) const;

  double size_;
  bool normalised_;
  Cage cage_;
  /// The kind before it is divided by its sum.
  std::shared_ptr<const CoordinateKind> summed_kind_;
  CageCoordinates reference_, sums_;
  CageLocator locator_;
};

/// By order up to truth.order, of the worst block: `roundings` is |f - truth| / (u (|truth| + moved)), `relative`
/// |f - truth| / |truth|, norm-wise over the entries of a block that have a finite truth. Infinite where one of these
/// is not finite in `found`; NaN for orders that have no finite truth.
std::array<CageError, 3> block_errors(const std::vector<Result<double>>& found, const BlockTruth& truth);

}  // namespace cageproof::validation
