// SPDX-License-Identifier: MIT
// Calls of an implementation with memory of ours around its inputs and outputs, which shows what it touches.
#pragma once

#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/validation/sample.h"

#include <vector>

namespace cageproof::judge {

/// One element and some points, as a caller has them.
struct Block {
  std::vector<Vec3<double>> corners, points;
  std::vector<double> parameters;
};

/// A block of one point.
inline Block block_of(const validation::Sample& sample) { return {sample.corners, {sample.point}, sample.parameters}; }

/// Buffers that stay where they are from call to call, with numbers before and behind.
class Desk {
 public:
  /// \param order highest derivative that is asked for
  Desk(const Evaluation& theirs, int order) : theirs_(&theirs), order_(order) {}

  /// Values of all points, then gradients.
  /// \param output what the output holds before the call \param beyond what lies behind the inputs
  std::vector<double> ask(const Block& block, double output = 0, double beyond = 0);
  /// Whether the last call changed what lies before or behind its outputs.
  bool wrote_past() const { return wrote_past_; }

 private:
  const Evaluation* theirs_;
  int order_;
  bool wrote_past_ = false;
  std::vector<Vec3<double>> corners_, points_;
  std::vector<double> parameters_;
};

/// Whether two answers are the same numbers, up to `tolerance` of the largest; NaN equals NaN.
bool same(const std::vector<double>& a, const std::vector<double>& b, double tolerance = 0);

}  // namespace cageproof::judge
