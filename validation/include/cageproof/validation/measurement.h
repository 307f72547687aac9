// SPDX-License-Identifier: MIT
// Measurements of a run, cut into units of work. A unit depends only on the run's options, so that it does not matter
// who measures it, when, or in which company.
#pragma once

#include "cageproof/core/results/partial_result.h"

#include <atomic>
#include <functional>
#include <memory>

namespace cageproof::validation {

/// Something to measure, in blocks. Immutable for those who use it; safe from any thread.
class Measurement {
 public:
  virtual ~Measurement() = default;
  /// The measurement's name; no other in the run has the same.
  virtual std::string name() const = 0;
  /// Into how many blocks it is cut: at least one, however many samples it takes at most about `most_blocks`, so that
  /// journals do not grow with samples.
  virtual int blocks() const = 0;
  /// Measures one of them. Results of different blocks merge to those of the whole.
  virtual PartialResult measure(int block) const = 0;
  /// Keys of all rows that it may fill, without measuring: those of its questions. Pictures fill none.
  virtual std::vector<RowKey> rows() const { return {}; }

  static constexpr int most_blocks = 16;
};

using Measurements = std::vector<std::unique_ptr<const Measurement>>;

/// One unit of work. Its number is its place in units_of().
struct Unit {
  std::size_t measurement;
  int block;
};

/// The units of all measurements, in their order.
std::vector<Unit> units_of(const Measurements& measurements);

/// The numbers of the units that a shard takes, in the order in which they are best begun: shards are disjoint, and
/// together all. First blocks, which hold the samples that costly checks take, are dealt out evenly, and so is every
/// measurement's rest; they also come first.
std::vector<std::size_t> units_of_shard(const std::vector<Unit>& units, int shard, int shards);

/// Measures units of work, and lets go of each measurement, with all that it prepared for its blocks, when the last of
/// its units that are to be measured is done. Safe from several threads.
class UnitsOfWork {
 public:
  /// \param open the numbers of the units that are to be measured, each once
  UnitsOfWork(Measurements measurements, std::vector<Unit> units, const std::vector<std::size_t>& open);
  /// Measurement::name() of a unit. \pre it is open and not measured yet
  std::string name(std::size_t unit) const { return measurements_[units_[unit].measurement]->name(); }
  int block(std::size_t unit) const { return units_[unit].block; }
  /// \pre it is open and not measured yet
  PartialResult measure(std::size_t unit);

 private:
  Measurements measurements_;
  std::vector<Unit> units_;
  std::vector<std::atomic<int>> left_;  // open units, by measurement
};

/// How many blocks `samples` are worth: one for each `few`, at least one, at most Measurement::most_blocks.
int block_count(std::size_t samples, std::size_t few);

/// Where block `block` of `blocks` begins in `samples`; it ends where the next begins.
std::size_t block_begin(std::size_t samples, int block, int blocks);

/// Measures all of them on `jobs` threads (0: all cores), in memory. \param progress called from any thread after each
/// unit
PartialResult measure_all(const Measurements& measurements, int jobs,
                          const std::function<void(std::size_t done, std::size_t all)>& progress = {});

}  // namespace cageproof::validation
