// SPDX-License-Identifier: MIT
// One input of a campaign.
#pragma once

#include "cageproof/core/catalogue/evaluation.h"

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
  /// A vertex's coordinate: vertices are the corners, then the point. Elements in the plane have two that may change.
  R& coordinate(int vertex, int axis) { return vertex < point_vertex() ? corners_[vertex][axis] : point_[axis]; }
  /// The point's number among the vertices, which are one more.
  int point_vertex() const { return static_cast<int>(corners_.size()); }

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

/// Whether all coordinates are finite. A sample that rounds to infinity in a narrow scalar is not an input of any
/// formula, and is given neither to evaluations nor to exact predicates.
bool is_finite(const Sample& sample);

}  // namespace cageproof::validation
