// SPDX-License-Identifier: MIT
// One input of a campaign.
#pragma once

#include "cageproof/core/evaluation.h"

#include <vector>

namespace cageproof::validation {

/// An element and a point, in doubles taken exactly.
struct Sample {
  std::vector<Vec3<double>> corners;
  Vec3<double> point = Vec3<double>::Zero();
  std::vector<double> parameters;  ///< in the order of Formula::parameters
  double parameter = 0;            ///< the regime's parameter: distance, aspect, unit ...; 0 where there is none
  std::uint64_t index = 0;
};

/// The sample as a query's arrays in another scalar; owns what the query points to.
template <Scalar R>
class QueryOf {
 public:
  QueryOf(const Sample& sample, int order) : point_(convert<R>(sample.point)), order_(order) {
    for (const auto& corner : sample.corners) corners_.push_back(convert<R>(corner));
    for (const double p : sample.parameters) parameters_.push_back(static_cast<R>(p));
  }
  /// Valid while this object lives.
  Query<R> query() const { return {corners_, point_, order_, parameters_}; }
  /// Coordinate k of the input: the corners' coordinates, then the point's.
  R& coordinate(int k) {
    const int corner = k / 3;
    return corner < static_cast<int>(corners_.size()) ? corners_[corner][k % 3] : point_[k % 3];
  }
  int coordinate_count() const { return 3 * (static_cast<int>(corners_.size()) + 1); }

 private:
  std::vector<Vec3<R>> corners_;
  Vec3<R> point_;
  std::vector<R> parameters_;
  int order_;
};

/// Evaluates at a sample.
template <Scalar R>
Result<R> evaluate(const Evaluation& evaluation, const Sample& sample, int order) {
  const QueryOf<R> input(sample, order);
  Result<R> result;
  evaluation(input.query(), result);
  return result;
}

/// The sample rounded to what `scalar` can hold (float; the others hold every double).
Sample rounded_to(ScalarKind scalar, Sample sample);

}  // namespace cageproof::validation
