// SPDX-License-Identifier: MIT
// Rows of coordinates with few, short weights, and a proof of how far that moves a point.
#pragma once

#include "cageproof/deformation/pose_reach.h"

#include <cstdint>
#include <span>
#include <vector>

namespace cageproof::deformation {

/// Formats that weights are stored in: IEEE's formats of 8, 4 and 2 bytes.
enum class WeightFormat { Double, Float, Half };

/// Bytes of a weight.
int bytes_of(WeightFormat format);

/// The bits of IEEE's half precision nearest to a number, by way of its nearest float; infinite beyond 65504.
std::uint16_t half_bits(double value);
/// The number that the format has for another one.
double rounded_to(WeightFormat format, double value);

/// The weights of one point that are kept.
struct SparseRow {
  std::vector<int> columns;     ///< rising, at least one
  std::vector<double> weights;  ///< of the columns, each a number of the format
  double bound;                 ///< how far the point is moved at most, in the cage's unit of length
  double sum_change;            ///< the largest change of the sum of a group's weights (PoseReach)
  bool finite = true;           ///< whether the row was; of others one NaN is kept, and bound and change are zero
};

/// Drops weights of rows, and rounds the rest. A group's largest weight is kept. What is dropped of a group goes to its
/// kept weights, in proportion to them and, where that has the lower bound, with a share that is linear in their
/// centres, so that what the row makes of all centres stays, too. What rounding takes goes on from the largest to the
/// smallest, as far as they can have it without a change of sign. So translations of the cage stay translations. With
/// the change d_i of each weight, a point moves by
///     |sum d_i q_i| <= |sum d_i centre_i| + sum |d_i| radius_i
/// over all q_i within reach: the bound, of which all roundings here are part. It is attained where reaches are balls.
/// Not in it: roundings of whoever multiplies rows with a pose.
class SparseWeights {
 public:
  /// \param reaches one per column, pose_reach(), with one or two groups \param tolerance how far a point may be moved,
  /// in the unit of length
  SparseWeights(std::vector<PoseReach> reaches, double tolerance, WeightFormat format);

  /// As many of the least weights are dropped as a bisection finds to keep the bound below the tolerance; none where
  /// rounding by itself exceeds it: then the bound does. \pre as many numbers as reaches. Safe from any thread.
  SparseRow row(std::span<const double> weights) const;

  std::size_t columns() const { return reaches_.size(); }
  double tolerance() const { return tolerance_; }
  WeightFormat format() const { return format_; }

 private:
  class Trial;
  std::vector<PoseReach> reaches_;     // centres as seen from the middle of their group
  std::vector<Vec3<double>> middles_;  // of groups
  double extent_ = 0;                  // the farthest centre from its middle
  double tolerance_;
  WeightFormat format_;
};

}  // namespace cageproof::deformation
