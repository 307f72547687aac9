// SPDX-License-Identifier: MIT
#include "cageproof/deformation/sparse_weights.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace cageproof::deformation {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

// The most moments of a row that are kept: its sums over groups, two at most, and its product with the centres.
constexpr int kMostKept = 5;
using KeptMoments = std::array<double, kMostKept>;

// Solves a positive semidefinite system; directions in which it is singular get zero.
KeptMoments factors_solving(std::array<KeptMoments, kMostKept> matrix, KeptMoments right, int size) {
  std::array<bool, kMostKept> pivoted{};
  for (int k = 0; k < size; ++k) {
    int p = -1;
    for (int i = 0; i < size; ++i)
      if (!pivoted[i] && (p < 0 || matrix[i][i] > matrix[p][p])) p = i;
    if (!(matrix[p][p] > 1e-10 * matrix[0][0])) break;
    pivoted[p] = true;
    for (int i = 0; i < size; ++i) {
      if (i == p) continue;
      const double factor = matrix[i][p] / matrix[p][p];
      for (int j = 0; j < size; ++j) matrix[i][j] -= factor * matrix[p][j];
      right[i] -= factor * right[p];
    }
  }
  KeptMoments x{};
  for (int i = 0; i < size; ++i)
    if (pivoted[i]) x[i] = right[i] / matrix[i][i];
  return x;
}

}  // namespace

int bytes_of(WeightFormat format) {
  constexpr std::array bytes{8, 4, 2};
  return bytes[static_cast<std::size_t>(format)];
}

std::uint16_t half_bits(double value) {
  return Eigen::numext::bit_cast<std::uint16_t>(Eigen::half(static_cast<float>(value)));
}

double rounded_to(WeightFormat format, double value) {
  if (format == WeightFormat::Double) return value;
  const auto single = static_cast<float>(value);
  return format == WeightFormat::Float ? single : static_cast<float>(Eigen::half(single));
}

// A row while numbers of its weights are tried.
class SparseWeights::Trial {
 public:
  Trial(const SparseWeights& all, std::span<const double> weights)
      : all_(all),
        weights_(weights),
        groups_(static_cast<int>(all.middles_.size())),
        by_size_(weights.size()),
        largest_(all.middles_.size(), -1),
        stored_(weights.size()),
        dropped_(weights.size()) {
    std::iota(by_size_.begin(), by_size_.end(), 0);
    std::ranges::stable_sort(by_size_, std::greater(), [&](int column) { return std::abs(weights[column]); });
    for (const int column : by_size_)
      if (const int group = all.reaches_[column].group; group >= 0 && largest_[group] < 0) largest_[group] = column;
    find_droppable();
  }

  // How many weights may be dropped.
  std::size_t most() const { return droppable_.size(); }

  // Stores the row without so many weights; returns the bound.
  double without(std::size_t count) {
    std::ranges::fill(dropped_, 0);
    for (std::size_t i = 0; i < count; ++i) dropped_[droppable_[i]] = 1;
    const double with_centres = stored_keeping(groups_ + 3);
    if (count == 0) return with_centres;
    const std::vector<double> first = stored_;
    const double with_sums = stored_keeping(groups_);
    if (!(with_centres < with_sums)) return with_sums;
    stored_ = first;
    return with_centres;
  }

  const std::vector<double>& stored() const { return stored_; }
  double sum_change() const {
    double most = 0;
    for (const double change : sum_changes()) most = std::max(most, std::abs(change));
    return most;
  }

 private:
  // Columns whose weights may be dropped, those that cost least first: the weight, and what it does to others.
  void find_droppable() {
    std::vector<double> costs(weights_.size(), 0);
    droppable_.reserve(weights_.size());
    const double moved = groups_ > 0 ? all_.reaches_[largest_[0]].radius : 0;
    for (const int column : by_size_) {
      const auto& [centre, radius, group] = all_.reaches_[column];
      if (group >= 0 && largest_[group] == column) continue;
      const double length = group >= 0 ? 2 * radius : radius + moved * centre.norm() / all_.extent_;
      if (weights_[column] != 0) costs[column] = std::abs(weights_[column]) * length;
      droppable_.push_back(column);
    }
    std::ranges::stable_sort(droppable_, {}, [&](int column) { return costs[column]; });
  }

  // Moments of a weight of one, centres in units of their extent.
  KeptMoments moments_of(int column) const {
    const auto& [centre, radius, group] = all_.reaches_[column];
    KeptMoments moments{};
    if (group >= 0) moments[group] = 1;
    for (int axis = 0; axis < 3; ++axis) moments[groups_ + axis] = centre[axis] / all_.extent_;
    return moments;
  }

  // Factors that restore the first `size` moments without the dropped weights: each kept weight grows by itself times
  // the product of the factors with its moments.
  KeptMoments correction(int size) const {
    std::array<KeptMoments, kMostKept> matrix{};
    KeptMoments missing{};
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      const int column = static_cast<int>(i);
      if (!dropped_[i] && all_.reaches_[i].group < 0) continue;
      const KeptMoments moments = moments_of(column);
      for (int k = 0; k < size; ++k) {
        if (dropped_[i]) missing[k] += weights_[i] * moments[k];
        else
          for (int l = 0; l < size; ++l) matrix[k][l] += std::abs(weights_[i]) * moments[k] * moments[l];
      }
    }
    return factors_solving(matrix, missing, size);
  }

  double stored_keeping(int size) {
    const bool whole = std::ranges::none_of(dropped_, [](char is) { return is != 0; });
    const KeptMoments factors = whole ? KeptMoments{} : correction(size);
    const auto target = [&](int column) {
      double more = 0;
      const KeptMoments moments = moments_of(column);
      for (int k = 0; k < size; ++k) more += factors[k] * moments[k];
      return weights_[column] + std::abs(weights_[column]) * more;
    };
    // The difference that each group's sum still has.
    std::array<double, kMostKept> carried{};
    if (!whole)
      for (const int column : by_size_)
        if (const int group = all_.reaches_[column].group; group >= 0)
          carried[group] += dropped_[column] ? weights_[column] : weights_[column] - target(column);
    for (const int column : by_size_) {
      const int group = all_.reaches_[column].group;
      const double own = weights_[column];
      double& stored = stored_[column];
      if (dropped_[column] || own == 0) {
        stored = 0;
      } else if (group < 0) {
        stored = rounded_to(all_.format_, own);
      } else {
        const double wanted = whole ? own : target(column);
        stored = rounded_to(all_.format_, wanted + carried[group]);
        if (std::signbit(stored) != std::signbit(own)) stored = 0;
        carried[group] += wanted - stored;
      }
    }
    return bound();
  }

  std::vector<double> sum_changes() const {
    std::vector<double> changes(all_.middles_.size(), 0);
    for (std::size_t i = 0; i < weights_.size(); ++i)
      if (const int group = all_.reaches_[i].group; group >= 0) changes[group] += stored_[i] - weights_[i];
    return changes;
  }

  // The bound of the weights that are stored, however they were chosen.
  double bound() const {
    Vec3<double> centre = Vec3<double>::Zero();
    double reached = 0, rounding = 0;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      const double change = stored_[i] - weights_[i];
      if (change == 0) continue;
      const auto& [place, radius, group] = all_.reaches_[i];
      centre += change * place;
      reached += std::abs(change) * radius;
      rounding += std::abs(change) * (place.norm() + (group < 0 ? 0 : all_.middles_[group].norm()));
    }
    const std::vector<double> changes = sum_changes();
    for (std::size_t group = 0; group < changes.size(); ++group) centre += changes[group] * all_.middles_[group];
    const double unit = kEpsilon * static_cast<double>(weights_.size() + 8);
    const double bound = (1 + 2 * unit) * (centre.norm() + reached) + 2 * unit * rounding;
    return std::isnan(bound) ? std::numeric_limits<double>::infinity() : bound;
  }

  const SparseWeights& all_;
  std::span<const double> weights_;
  int groups_;
  std::vector<int> by_size_, largest_, droppable_;
  std::vector<double> stored_;  // zero where dropped
  std::vector<char> dropped_;
};

SparseWeights::SparseWeights(std::vector<PoseReach> reaches, double tolerance, WeightFormat format)
    : reaches_(std::move(reaches)), tolerance_(tolerance), format_(format) {
  std::vector<int> counts;
  for (const PoseReach& reach : reaches_) {
    if (reach.group < 0) continue;
    middles_.resize(std::max<std::size_t>(middles_.size(), reach.group + 1), Vec3<double>::Zero());
    counts.resize(middles_.size());
    // A running mean stays in range.
    middles_[reach.group] += (reach.centre - middles_[reach.group]) / ++counts[reach.group];
  }
  for (PoseReach& reach : reaches_) {
    if (reach.group < 0) continue;
    reach.centre -= middles_[reach.group];
    extent_ = std::max(extent_, reach.centre.norm());
  }
  if (!(extent_ > 0)) extent_ = 1;
}

SparseRow SparseWeights::row(std::span<const double> weights) const {
  if (!std::ranges::all_of(weights, [](double w) { return std::isfinite(w); }))
    return {{0}, {std::numeric_limits<double>::quiet_NaN()}, 0, 0, false};
  Trial trial(*this, weights);
  std::size_t dropped = 0, beyond = trial.most() + 1;
  while (dropped + 1 < beyond) {
    const std::size_t middle = dropped + (beyond - dropped) / 2;
    (trial.without(middle) <= tolerance_ ? dropped : beyond) = middle;
  }
  SparseRow row{{}, {}, trial.without(dropped), trial.sum_change()};
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (trial.stored()[i] != 0) {
      row.columns.push_back(static_cast<int>(i));
      row.weights.push_back(trial.stored()[i]);
    }
  if (row.columns.empty()) {
    row.columns = {0};
    row.weights = {0};
  }
  return row;
}

}  // namespace cageproof::deformation
