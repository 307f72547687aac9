// SPDX-License-Identifier: MIT
#include "cageproof/validation/coordinate_summary.h"

#include "row_residuals.h"

#include "cageproof/core/cage/winding_numbers.h"
#include "cageproof/core/geometry/box.h"
#include "cageproof/core/parallel.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <span>

namespace cageproof::validation {
namespace {

// Beyond this a sum of coordinates is a warning.
constexpr double kExactSum = 1e-8;

// As many roundings of places, and fewer, explain a point that is not given back.
constexpr double kRoundings = 64;

// Points that are looked at together.
constexpr std::size_t kTogether = 64;

void keep(Largest& largest, double value, std::size_t point) {
  // A NaN is the largest; among equal values the first point counts.
  if (std::isnan(largest.value) && largest.point < point) return;
  if (value > largest.value || std::isnan(value) || (value == largest.value && point < largest.point))
    largest = {value, point};
}

void count(Counted& sum, const Counted& part) {
  if (part.points == 0) return;
  sum.first = sum.points == 0 ? part.first : std::min(sum.first, part.first);
  sum.points += part.points;
}

// Flaws among the derivatives in one point's row.
struct Flaws {
  bool nan = false, infinite = false;
};

Flaws flaws_of_derivatives(const CageCoordinates& coordinates, std::span<const double> row, std::size_t per_block) {
  Flaws flaws;
  for (const CoordinateBlock& block : coordinates.blocks()) {
    const std::size_t values = static_cast<std::size_t>(block.size) * block.entries();
    for (const double x : row.subspan(values, values * (per_block - 1))) {
      flaws.nan = flaws.nan || std::isnan(x);
      flaws.infinite = flaws.infinite || std::isinf(x);
    }
    row = row.subspan(values * per_block);
  }
  return flaws;
}

void add_part(CoordinateSummary& sum, const CoordinateSummary& part) {
  sum.inside += part.inside;
  sum.on += part.on;
  sum.outside += part.outside;
  sum.missing += part.missing;
  sum.infinite += part.infinite;
  sum.unusable += part.unusable;
  sum.inexact += part.inexact;
  sum.inexact_far += part.inexact_far;
  sum.misplaced += part.misplaced;
  count(sum.derivatives_on, part.derivatives_on);
  count(sum.derivatives_missing, part.derivatives_missing);
  count(sum.derivatives_infinite, part.derivatives_infinite);
  keep(sum.partition, part.partition.value, part.partition.point);
  keep(sum.reproduction, part.reproduction.value, part.reproduction.point);
}

bool reproduces_points(const CageCoordinates& coordinates) {
  return std::ranges::any_of(coordinates.blocks(),
                             [](const CoordinateBlock& b) { return b.reproduces != Reproduces::Nothing; });
}

// Numbers of a point's values, in all blocks.
std::size_t values_of(const CageCoordinates& coordinates) {
  std::size_t values = 0;
  for (const CoordinateBlock& block : coordinates.blocks())
    values += static_cast<std::size_t>(block.size) * block.entries();
  return values;
}

// The count of numbers of a value and its derivatives.
std::size_t numbers_up_to(int order, int dimension) {
  std::size_t numbers = 0;
  for (int o = 0; o <= order; ++o) numbers += derivative_count(dimension, o);
  return numbers;
}

}  // namespace

class SummaryMaker::State {
 public:
  State(const CageCoordinates& coordinates, const Cage& cage, int order)
      : coordinates_(coordinates),
        size_(cage.size()),
        box_(box_of(cage.vertices())),
        per_value_(numbers_up_to(order, coordinates.dimension())),
        columns_(values_of(coordinates) * per_value_),
        windings_(coordinates.elements()),
        residuals_(coordinates, cage, per_value_) {
    all_.reproduces = reproduces_points(coordinates);
    const double largest = std::max(box_.low.cwiseAbs().maxCoeff(), box_.high.cwiseAbs().maxCoeff());
    all_.far_off = largest / size_;
    all_.grain = (std::nextafter(largest, HUGE_VAL) - largest) / size_;
  }

  void add(std::size_t first, std::span<const Vec3<double>> points, std::span<const double> rows) {
    CoordinateSummary mine;
    for (std::size_t p = 0; p < points.size(); ++p)
      add_point(mine, first + p, points[p], rows.subspan(p * columns_, columns_));
    const std::lock_guard lock(adding_);
    all_.points += points.size();
    add_part(all_, mine);
  }

  CoordinateSummary summary() const { return all_; }

 private:
  void add_point(CoordinateSummary& mine, std::size_t number, const Vec3<double>& point,
                 std::span<const double> row) const {
    const CoordinateKind& kind = coordinates_.kind();
    const std::optional<int> around = windings_.around(point);
    const bool on = !around.has_value();
    const int winding = around.value_or(1);
    ++(on ? mine.on : winding == 0 ? mine.outside : mine.inside);
    const Residuals found = residuals_.of(row, point, kind.normalised ? 1 : winding);
    if (found.has_nan) ++mine.missing;
    else if (found.has_infinity) ++mine.infinite;
    const bool finite = !found.has_nan && !found.has_infinity;
    if (!finite || (all_.reproduces && winding == 0 && !kind.normalised)) ++mine.unusable;
    const Flaws flaws = finite ? flaws_of_derivatives(coordinates_, row, per_value_) : Flaws();
    if (flaws.nan || flaws.infinite)
      count(on ? mine.derivatives_on : flaws.nan ? mine.derivatives_missing : mine.derivatives_infinite, {1, number});
    if (!finite || !all_.reproduces) return;
    if (!(found.partition <= kExactSum)) {
      ++mine.inexact;
      const Vec3<double> nearest = point.cwiseMax(box_.low).cwiseMin(box_.high);
      if ((point - nearest).stableNorm() > size_) ++mine.inexact_far;
    }
    // Other errors of kinds that are solved for are no rounding of places.
    if (!(found.reproduction <= kExactSum) && found.reproduction <= kRoundings * all_.grain &&
        found.partition <= kExactSum)
      ++mine.misplaced;
    keep(mine.partition, found.partition, number);
    keep(mine.reproduction, found.reproduction, number);
  }

  const CageCoordinates& coordinates_;
  double size_;
  Box box_;
  std::size_t per_value_, columns_;
  WindingNumbers windings_;
  RowResiduals residuals_;
  std::mutex adding_;
  CoordinateSummary all_;
};

SummaryMaker::SummaryMaker(const CageCoordinates& coordinates, const Cage& cage, int order)
    : state_(std::make_unique<State>(coordinates, cage, order)) {}
SummaryMaker::~SummaryMaker() = default;

void SummaryMaker::add(std::size_t first, std::span<const Vec3<double>> points, std::span<const double> rows) {
  state_->add(first, points, rows);
}

CoordinateSummary SummaryMaker::summary() const { return state_->summary(); }

CoordinateSummary summary_of(const CageCoordinates& coordinates, const Cage& cage,
                             const std::vector<Vec3<double>>& points, std::span<const double> table, int jobs) {
  const std::size_t columns = points.empty() ? 0 : table.size() / points.size();
  int order = 0;
  while (order < 2 && values_of(coordinates) * numbers_up_to(order, coordinates.dimension()) < columns) ++order;
  SummaryMaker maker(coordinates, cage, order);
  for_each_parallel((points.size() + kTogether - 1) / kTogether, jobs, [&](std::size_t part) {
    const std::size_t first = part * kTogether, here = std::min(kTogether, points.size() - first);
    maker.add(first, std::span(points).subspan(first, here), table.subspan(first * columns, here * columns));
  });
  return maker.summary();
}

}  // namespace cageproof::validation
