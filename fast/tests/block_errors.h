// SPDX-License-Identifier: MIT
// The error of a whole block of coordinates, for tests of whole evaluations.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/numbers/random_stream.h"

#include <array>
#include <cmath>
#include <vector>

namespace cageproof::block_errors {

using Point = Vec3<double>;

inline CageCoordinates coordinates_of(const Cage& cage, std::string_view kind, const std::string& evaluation) {
  return {cage, coordinate_kind_named(kind), CoordinateOptions{.evaluation = evaluation}};
}

template <class Number>
double norm_of(const std::vector<Number>& values) {
  Number squares = 0;
  for (const Number& x : values) squares += x * x;
  return static_cast<double>(Number(sqrt(squares)));
}

// The sum over the point's coordinates of the norms of derivatives by them, which come last.
template <class Number>
double slope_of(const std::vector<Number>& derivatives, std::size_t dimension) {
  double sum = 0;
  for (std::size_t k = 0; k < dimension; ++k) {
    std::vector<Number> along;
    for (std::size_t i = k; i < derivatives.size(); i += dimension) along.push_back(derivatives[i]);
    sum += norm_of(along);
  }
  return sum;
}

// The largest block error over blocks and orders, in units of u, as docs/errors.md defines it, with the point for the
// only input: |f - truth| over |truth| + size sum_k |d truth/d x_k|; of Hessians over |truth| alone, or, as the
// promise has it, with a difference of Hessians along a direction that is like no other point's. Number: of the truth.
enum class OfHessians { Alone, WithSlope };

// On the cage, over entries that have a truth; the slope is taken at a point next to it, inside.
inline double block_error_on(const CageCoordinates& found, const CageCoordinates& reference, double size,
                             const Point& point, const Vec3<Mp50>& inside, int order) {
  const auto f = found.at<double>(point, order);
  const auto truth = reference.at<Mp50>(convert<Mp50>(point), order);
  const Mp50 step("1e-25");
  Vec3<Mp50> moved = inside;
  for (int i = 0; i < found.dimension(); ++i) moved[i] += step * std::array{0.48, 0.64, 0.6}[i];
  const auto here = reference.at<Mp50>(inside, order), beside = reference.at<Mp50>(moved, order);
  double worst = 0;
  for (std::size_t b = 0; b < f.size(); ++b)
    for (int o = 0; o <= order; ++o) {
      std::vector<Mp50> difference, whole, change;
      for (std::size_t i = 0; i < f[b].of(o).size(); ++i) {
        if (!isfinite(truth[b].of(o)[i])) continue;
        difference.push_back(Mp50(f[b].of(o)[i]) - truth[b].of(o)[i]);
        whole.push_back(truth[b].of(o)[i]);
        change.push_back((beside[b].of(o)[i] - here[b].of(o)[i]) / step);
      }
      if (whole.empty()) continue;
      const double error = norm_of(difference) / (unit_roundoff<double>() * (norm_of(whole) + size * norm_of(change)));
      if (!std::isnan(worst) && !(error <= worst)) worst = error;
    }
  return worst;
}

// The truth for coordinates up to an order: derivatives up to one order more, and, for the slope of Hessians, the truth
// a step beside the point.
template <class Number>
struct BlockTruth {
  using Blocks = decltype(std::declval<const CageCoordinates&>().at<Number>(Vec3<Number>(), 0));
  Number step{"1e-20"};
  Blocks here, beside;
};

template <class Number = Mp50>
BlockTruth<Number> block_truth(const CageCoordinates& reference, const Point& point, int order, OfHessians unit) {
  BlockTruth<Number> truth;
  truth.here = reference.at<Number>(convert<Number>(point), std::min(order + 1, 2));
  if (order < 2 || unit == OfHessians::Alone) return truth;
  Vec3<Number> moved = convert<Number>(point);
  for (int i = 0; i < 3; ++i) moved[i] += truth.step * std::array{0.48, 0.64, 0.6}[i];
  truth.beside = reference.at<Number>(moved, 2);
  return truth;
}

// order: at most the one that the truth was made for.
template <class Number>
double block_error(const CageCoordinates& found, const BlockTruth<Number>& truth, double size, const Point& point,
                   int order) {
  const auto f = found.at<double>(point, order);
  const auto& [step, here, beside] = truth;
  double worst = 0;
  for (std::size_t b = 0; b < f.size(); ++b)
    for (int o = 0; o <= order; ++o) {
      std::vector<Number> difference;
      for (std::size_t i = 0; i < f[b].of(o).size(); ++i)
        difference.push_back(Number(f[b].of(o)[i]) - here[b].of(o)[i]);
      // On the cage some derivatives do not exist.
      const std::size_t dimension = o < 2 ? here[b].of(o + 1).size() / here[b].of(o).size() : 1;
      double slope = o < 2 ? slope_of(here[b].of(o + 1), dimension) : 0;
      if (o == 2 && !beside.empty()) {
        std::vector<Number> change;
        change.reserve(f[b].of(2).size());
        for (std::size_t i = 0; i < f[b].of(2).size(); ++i)
          change.push_back((beside[b].of(2)[i] - here[b].of(2)[i]) / step);
        slope = norm_of(change);
      }
      const double scale = norm_of(here[b].of(o)) + (std::isfinite(slope) ? size * slope : 0);
      const double error = norm_of(difference) / (unit_roundoff<double>() * scale);
      if (!std::isnan(worst) && !(error <= worst)) worst = error;  // what is no number stays
    }
  return worst;
}

template <class Number = Mp50>
double block_error(const CageCoordinates& found, const CageCoordinates& reference, double size, const Point& point,
                   int order, OfHessians unit = OfHessians::Alone) {
  return block_error(found, block_truth<Number>(reference, point, order, unit), size, point, order);
}

// A random direction with that many coordinates.
inline Point direction(RandomStream& random, int dimension = 3) {
  Point v = Point::Zero();
  do
    for (int c = 0; c < dimension; ++c) v[c] = random.uniform(-1, 1);
  while (v.norm() > 1 || v.norm() < 0.1);
  return v.normalized();
}

}  // namespace cageproof::block_errors
