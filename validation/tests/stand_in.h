// SPDX-License-Identifier: MIT
// Evaluations of whole coordinates that are right or wrong in a known way, to be judged in place of the program's own.
#pragma once

#include "cageproof/core/coordinates/whole_evaluation.h"

#include <algorithm>
#include <map>
#include <mutex>

namespace cageproof::validation {

/// Facts of a point that a fault may use.
struct FaultyPoint {
  const CageElements& elements;
  const Vec3<double>& point;
  int order;
  std::size_t together;  ///< how many points are computed at once
};

/// How a stand-in goes wrong: changes all blocks at one point. Null for the right one.
using Fault = void (*)(const FaultyPoint& at, std::vector<Result<double>>& blocks);

/// Sums in multiprecision, rounded once, with a fault; calls itself "batched", as promises know it.
class StandIn final : public BesideSums {
 public:
  StandIn(std::shared_ptr<const CageElements> elements, std::shared_ptr<const PreparedCoordinates> summed, Fault fault)
      : BesideSums(summed, elements->dimension()),
        elements_(std::move(elements)),
        summed_(std::move(summed)),
        fault_(fault) {}
  std::string evaluation() const override { return "batched"; }
  using BesideSums::fill;
  void fill(std::span<const Vec3<double>> points, int order, std::span<CoordinateTable<double>> tables) const override {
    for (std::size_t p = 0; p < points.size(); ++p) {
      std::vector<Result<double>> found = rounded(points[p], order, tables);
      if (fault_ != nullptr) fault_({*elements_, points[p], order, points.size()}, found);
      for (std::size_t b = 0; b < tables.size(); ++b)
        for (int o = 0; o <= order; ++o)
          std::ranges::copy(found[b].of(o),
                            tables[b].tensors[o].begin() + static_cast<std::ptrdiff_t>(p * tables[b].stride[o]));
    }
  }

 private:
  // Remembered, since blocks ask for the same points together with the one that matters.
  std::vector<Result<double>> rounded(const Vec3<double>& point, int order,
                                      std::span<const CoordinateTable<double>> like) const {
    const std::scoped_lock lock(mutex_);
    std::vector<Result<double>>& found = known_[{point[0], point[1], point[2], static_cast<double>(order)}];
    if (!found.empty()) return found;
    std::vector<CoordinateTable<Mp100>> wide(like.size());
    for (std::size_t b = 0; b < like.size(); ++b)
      for (int o = 0; o <= order; ++o) {
        wide[b].stride[o] = like[b].stride[o];
        wide[b].tensors[o].assign(like[b].stride[o], Mp100(0));
      }
    const Vec3<Mp100> exact = convert<Mp100>(point);
    summed_->fill(std::span(&exact, 1), order, wide);
    found.resize(like.size());
    for (std::size_t b = 0; b < like.size(); ++b)
      for (int o = 0; o <= order; ++o)
        for (const Mp100& x : wide[b].tensors[o]) found[b].of(o).push_back(static_cast<double>(x));
    return found;
  }

  mutable std::mutex mutex_;
  mutable std::map<std::array<double, 4>, std::vector<Result<double>>> known_;
  std::shared_ptr<const CageElements> elements_;
  std::shared_ptr<const PreparedCoordinates> summed_;
  Fault fault_;
};

/// Registers one that goes wrong in that way.
template <Fault Wrong>
WholeEvaluation stand_in(std::string_view name) {
  return {
      .name = name,
      .description = "for tests",
      .role = Role::Foreign,
      .exists = [](const CoordinateKind& kind, const Cage&) { return kind.is_sum(); },
      .prepare = [](const CoordinateKind&, std::shared_ptr<const CageElements> elements, const CoordinateOptions&,
                    std::shared_ptr<const PreparedCoordinates> summed) -> std::shared_ptr<const PreparedCoordinates> {
        return std::make_shared<StandIn>(std::move(elements), std::move(summed), Wrong);
      }};
}

}  // namespace cageproof::validation
