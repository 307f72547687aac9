// SPDX-License-Identifier: MIT
#include "block_error.h"

#include "cageproof/validation/cage_points.h"
#include "cages/point_inside.h"
#include "sampling/generic_direction.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::validation {
namespace {

using Number = Mp50;
using Point = Vec3<Number>;
using Coordinates = std::vector<Result<Number>>;

constexpr double not_finite = std::numeric_limits<double>::infinity();

// One point's part of tables.
template <Scalar R>
std::vector<Result<R>> results_at(const std::vector<CoordinateTable<R>>& tables, std::size_t p, int order) {
  std::vector<Result<R>> results(tables.size());
  for (std::size_t b = 0; b < tables.size(); ++b)
    for (int o = 0; o <= order; ++o) {
      const auto from = tables[b].tensors[o].begin() + static_cast<std::ptrdiff_t>(p * tables[b].stride[o]);
      results[b].of(o).assign(from, from + static_cast<std::ptrdiff_t>(tables[b].stride[o]));
    }
  return results;
}

template <class Range>
Number norm_of(const Range& numbers) {
  Number squares = 0;
  for (const Number& x : numbers)
    if (isfinite(x)) squares += x * x;
  return sqrt(squares);
}

// The sum of the norms of each coordinate's derivatives.
Number sum_of_norms(const std::vector<Number>& numbers, std::size_t derivatives) {
  Number sum = 0;
  for (std::size_t i = 0; i < numbers.size(); i += derivatives)
    sum += norm_of(std::span(numbers).subspan(i, derivatives));
  return sum;
}

// Weights' derivatives summed over all of them.
std::vector<Number> totals_of(const std::vector<Number>& numbers, std::size_t derivatives) {
  std::vector<Number> totals(derivatives, Number(0));
  for (std::size_t i = 0; i < numbers.size(); ++i) totals[i % derivatives] += numbers[i];
  return totals;
}

// lambda = w/W and its derivatives, by the quotient rule.
Result<Number> quotients(const Result<Number>& w, std::size_t dim, int order) {
  const Number whole = totals_of(w.value, 1)[0];
  const std::vector<Number> slope = order >= 1 ? totals_of(w.gradient, dim) : std::vector<Number>();
  const std::vector<Number> bend = order >= 2 ? totals_of(w.hessian, dim * dim) : std::vector<Number>();
  Result<Number> lambda = w;
  for (std::size_t i = 0; i < w.value.size(); ++i) {
    lambda.value[i] = w.value[i] / whole;
    Number* const gradient = order >= 1 ? &lambda.gradient[dim * i] : nullptr;
    for (std::size_t a = 0; order >= 1 && a < dim; ++a)
      gradient[a] = (w.gradient[dim * i + a] - lambda.value[i] * slope[a]) / whole;
    for (std::size_t ab = 0; order >= 2 && ab < dim * dim; ++ab)
      lambda.hessian[dim * dim * i + ab] =
          (w.hessian[dim * dim * i + ab] - lambda.value[i] * bend[ab] - gradient[ab / dim] * slope[ab % dim] -
           gradient[ab % dim] * slope[ab / dim]) /
          whole;
  }
  return lambda;
}

// q_o of BlockTruth::moved.
std::array<Number, 3> quotient_roundings(const Result<Number>& w, const Result<Number>& lambda, std::size_t dim,
                                         int order) {
  const Number whole = abs(totals_of(w.value, 1)[0]);
  std::array<Number, 3> a{}, b{}, g{}, l{}, q{};
  for (int o = 0; o <= order; ++o) {
    const std::size_t derivatives = derivative_count(static_cast<int>(dim), o);
    a[o] = norm_of(w.of(o)) / whole;
    b[o] = sum_of_norms(w.of(o), derivatives) / whole;
    g[o] = norm_of(totals_of(w.of(o), derivatives)) / whole;
    l[o] = norm_of(lambda.of(o));
  }
  q[0] = l[0] * (b[0] - 1);
  if (order >= 1) q[1] = a[1] + l[0] * b[1] + l[1] * b[0] + l[0] * b[0] * g[1];
  if (order >= 2) q[2] = a[2] + l[0] * b[2] + 2 * l[1] * b[1] + l[2] * b[0] + l[0] * b[0] * g[2] + 2 * q[1] * g[1];
  return q;
}

// The derivative of a tensor along one axis, part of the tensor of the next order: its norm over the entries of the
// tensor that are finite in `seen`.
Number norm_along(const std::vector<Number>& next, const std::vector<Number>& seen, std::size_t dim, std::size_t axis) {
  Number squares = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const Number& x = next[dim * i + axis];
    if (isfinite(seen[i]) && isfinite(x)) squares += x * x;
  }
  return sqrt(squares);
}

Number norm_of_difference(const std::vector<Number>& x, const std::vector<Number>& y, const std::vector<Number>& seen) {
  Number squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (isfinite(seen[i])) squares += (x[i] - y[i]) * (x[i] - y[i]);
  return sqrt(squares);
}

// Norms over the entries whose truth is finite.
struct Compared {
  Number error = 0, truth = 0;
  bool any = false, wrong = false;
};

template <Scalar R>
Compared compared(const std::vector<R>& found, const std::vector<Number>& truth) {
  Compared c;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!isfinite(truth[i])) continue;
    c.any = true;
    const Number x(found[i]);
    if (!isfinite(x)) {
      c.wrong = true;
      continue;
    }
    c.error += (x - truth[i]) * (x - truth[i]);
    c.truth += truth[i] * truth[i];
  }
  c.error = sqrt(c.error);
  c.truth = sqrt(c.truth);
  return c;
}

double over(const Number& error, const Number& size) {
  if (error == 0) return 0;
  return size == 0 ? not_finite : static_cast<double>(Number(error / size));
}

}  // namespace

BlockTruths::BlockTruths(const Cage& cage, const CoordinateKind& kind, Triangulation rule)
    : size_(cage.size()),
      normalised_(kind.normalised),
      cage_(cage),
      summed_kind_([&] {
        auto summed = std::make_shared<CoordinateKind>(kind);
        summed->normalised = false;
        return summed;
      }()),
      reference_(cage, kind, CoordinateOptions{.triangulation = rule}),
      sums_(cage, *summed_kind_, CoordinateOptions{.triangulation = rule}),
      locator_(cage, rule, kind.keeps_quads) {}

std::optional<BlockTruth> BlockTruths::at(const Vec3<double>& point, int order) const {
  const bool on = !reference_.elements().touching(point).empty();
  // No nearer than rounding can tell: locators compute in double.
  const auto distance = [&] { return std::max(locator_.distance(point), 1e-17 * size_); };
  BlockTruth truth = on ? truth_on(point, order) : truth_near(convert<Number>(point), distance(), order, {});
  if (!agrees(truth, point)) return std::nullopt;
  return truth;
}

BlockTruth BlockTruths::truth_near(const Point& point, double distance, int order, Coordinates limits) const {
  const auto dim = static_cast<std::size_t>(reference_.dimension());
  // With 50 digits, a difference over 1e-20 of the distance to the cage leaves thirty digits. With the smallest
  // distance, 1e-17, it leaves thirteen digits of the point's own coordinates.
  const Number step = Number(distance) * Number("1e-20");
  std::vector<Point> points{point};
  if (order >= 2)
    points.emplace_back(point + step * generic_direction<Number>(convert<double>(point), static_cast<int>(dim)));
  // A higher order than asked, where the formulas have it, gives the derivative of the results.
  const int taken = std::min(order + 1, 2);
  const auto tables = sums_.at<Number>(points, taken);
  std::vector<Coordinates> at;
  at.reserve(points.size());
  for (std::size_t p = 0; p < points.size(); ++p) at.push_back(results_at(tables, p, taken));
  std::vector<std::array<Number, 3>> quotient(at[0].size());
  if (normalised_) {
    const Result<Number> weights = at[0][0];
    for (Coordinates& of_point : at) of_point[0] = quotients(of_point[0], dim, taken);
    quotient[0] = quotient_roundings(weights, at[0][0], dim, taken);
  }
  BlockTruth truth{{}, {}, order};
  for (std::size_t b = 0; b < at[0].size(); ++b) {
    const Result<Number>& seen = limits.empty() ? at[0][b] : limits[b];
    auto& moved = truth.moved.emplace_back(quotient[b]);
    for (int o = 0; o <= std::min(order, 1); ++o)
      for (std::size_t k = 0; k < dim; ++k)
        moved[o] += Number(size_) * norm_along(at[0][b].of(o + 1), seen.of(o), dim, k);
    if (order >= 2)
      moved[2] += Number(size_) * norm_of_difference(at[1][b].hessian, at[0][b].hessian, seen.hessian) / step;
  }
  truth.blocks = limits.empty() ? std::move(at[0]) : std::move(limits);
  return truth;
}

BlockTruth BlockTruths::truth_on(const Vec3<double>& point, int order) const {
  const auto inside = point_inside(reference_, cage_, locator_, point, reference_.elements().touching(point));
  Coordinates limits = reference_.at<Number>(convert<Number>(point), order);
  if (inside) return truth_near(convert<Number>(*inside), inside_step * size_, order, std::move(limits));
  BlockTruth truth{std::move(limits), {}, order};
  truth.moved.resize(truth.blocks.size());
  return truth;
}

bool BlockTruths::agrees(const BlockTruth& truth, const Vec3<double>& point) const {
  const auto more = reference_.at<Mp100>(convert<Mp100>(point), truth.order);
  for (std::size_t b = 0; b < more.size(); ++b)
    for (int o = 0; o <= truth.order; ++o) {
      const Compared c = compared(more[b].of(o), truth.blocks[b].of(o));
      const Number unit = Number(unit_roundoff<double>()) * (c.truth + truth.moved[b][o]);
      if (c.wrong || 1000 * c.error > unit) return false;
    }
  return true;
}

std::array<CageError, 3> block_errors(const std::vector<Result<double>>& found, const BlockTruth& truth) {
  std::array<CageError, 3> worst;
  for (int o = 0; o <= truth.order; ++o)
    for (std::size_t b = 0; b < found.size(); ++b) {
      const Compared c = compared(found[b].of(o), truth.blocks[b].of(o));
      if (!c.any) continue;
      const Number unit = Number(unit_roundoff<double>()) * (c.truth + truth.moved[b][o]);
      const double error = c.wrong ? not_finite : over(c.error, unit);
      const double relative = c.wrong ? not_finite : over(c.error, c.truth);
      if (!(worst[o].roundings >= error)) worst[o].roundings = error;
      if (!(worst[o].relative >= relative)) worst[o].relative = relative;
    }
  return worst;
}

}  // namespace cageproof::validation
