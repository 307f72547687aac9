// SPDX-License-Identifier: MIT
#include "cageproof/validation/coordinate_summary.h"

#include "cageproof/validation/cage_campaign.h"
#include "cageproof/validation/cage_errors.h"
#include "cageproof/validation/cage_points.h"
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

// The values of one point, from its row.
std::vector<Result<double>> blocks_of(const CageCoordinates& coordinates, std::span<const double> row,
                                      std::size_t per_block) {
  std::vector<Result<double>> blocks;
  for (const CoordinateBlock& block : coordinates.blocks()) {
    const std::size_t values = static_cast<std::size_t>(block.size) * block.entries();
    Result<double> result;
    result.value.assign(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(values));
    blocks.push_back(std::move(result));
    row = row.subspan(values * per_block);
  }
  return blocks;
}

void keep(Largest& largest, double value, std::size_t point) {
  // What is not a number is the largest, and of equals the first point.
  if (std::isnan(largest.value) && largest.point < point) return;
  if (value > largest.value || std::isnan(value) || (value == largest.value && point < largest.point))
    largest = {value, point};
}

void count(Counted& sum, const Counted& part) {
  if (part.points == 0) return;
  sum.first = sum.points == 0 ? part.first : std::min(sum.first, part.first);
  sum.points += part.points;
}

// What a point's row has among its derivatives.
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

}  // namespace

CoordinateSummary summary_of(const CageCoordinates& coordinates, const Cage& cage, Triangulation rule,
                             const std::vector<Vec3<double>>& points, std::span<const double> table, int jobs) {
  const CoordinateKind& kind = coordinates.kind();
  const CageLocator locator(cage, rule, kind.keeps_quads);
  const std::size_t columns = points.empty() ? 0 : table.size() / points.size();
  std::size_t values = 0;
  for (const CoordinateBlock& block : coordinates.blocks())
    values += static_cast<std::size_t>(block.size) * block.entries();
  const std::size_t per_block = values == 0 ? 1 : columns / values;
  CoordinateSummary sum;
  sum.points = points.size();
  sum.reproduces = reproduces_points(coordinates);
  const Box box = box_of(cage.vertices());
  const double largest = std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
  sum.far_off = largest / cage.size();
  sum.grain = (std::nextafter(largest, HUGE_VAL) - largest) / cage.size();
  std::mutex adding;
  for_each_parallel((points.size() + kTogether - 1) / kTogether, jobs, [&](std::size_t part) {
    CoordinateSummary mine;
    for (std::size_t p = part * kTogether; p < std::min(points.size(), (part + 1) * kTogether); ++p) {
      const bool on = !coordinates.elements().touching(points[p]).empty();
      const int winding = on ? 1 : locator.winding(points[p]);
      ++(on ? mine.on : winding == 0 ? mine.outside : mine.inside);
      const std::span<const double> row = table.subspan(p * columns, columns);
      const auto blocks = blocks_of(coordinates, row, per_block);
      bool nan = false, infinite = false;
      for (const Result<double>& block : blocks)
        for (const double x : block.value) nan = nan || std::isnan(x), infinite = infinite || std::isinf(x);
      if (nan) ++mine.missing;
      else if (infinite) ++mine.infinite;
      if (nan || infinite || (sum.reproduces && winding == 0 && !kind.normalised)) ++mine.unusable;
      const Flaws flaws = nan || infinite ? Flaws() : flaws_of_derivatives(coordinates, row, per_block);
      if (flaws.nan || flaws.infinite)
        count(on ? mine.derivatives_on : flaws.nan ? mine.derivatives_missing : mine.derivatives_infinite, {1, p});
      if (nan || infinite || !sum.reproduces) continue;
      const double expected = kind.normalised ? 1 : winding;
      const CageErrors errors = errors_of(coordinates, cage, blocks, points[p], expected, 0);
      if (!(errors.partition[0].relative <= kExactSum)) {
        ++mine.inexact;
        const Vec3<double> nearest = points[p].cwiseMax(box.low).cwiseMin(box.high);
        if ((points[p] - nearest).stableNorm() > cage.size()) ++mine.inexact_far;
      }
      // Other errors of kinds that are solved for are no rounding of places.
      const double misplaced = errors.reproduction[0].relative;
      if (!(misplaced <= kExactSum) && misplaced <= kRoundings * sum.grain && errors.partition[0].relative <= kExactSum)
        ++mine.misplaced;
      keep(mine.partition, errors.partition[0].relative, p);
      keep(mine.reproduction, errors.reproduction[0].relative, p);
    }
    const std::lock_guard lock(adding);
    add_part(sum, mine);
  });
  return sum;
}

}  // namespace cageproof::validation
