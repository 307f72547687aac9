// SPDX-License-Identifier: MIT
#include "cageproof/validation/measurement.h"

#include "cageproof/core/parallel.h"

#include <algorithm>
#include <mutex>
#include <numeric>

namespace cageproof::validation {
namespace {

// Any mixing would do (this is splitmix64's); it must stay as it is while shards of one run may come from different
// builds.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

}  // namespace

std::vector<Unit> units_of(const Measurements& measurements) {
  std::vector<Unit> units;
  for (std::size_t m = 0; m < measurements.size(); ++m)
    for (int block = 0; block < measurements[m]->blocks(); ++block) units.push_back({m, block});
  return units;
}

std::vector<std::size_t> units_of_shard(const std::vector<Unit>& units, int shard, int shards) {
  std::vector<std::size_t> order(units.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // Neighbours in the catalogue cost alike, and lists have lengths that shards may divide: shuffled, no shard gets all
  // of a kind.
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(units[i].block, mixed(units[i].measurement)); });
  std::vector<std::size_t> dealt;
  for (std::size_t i = shard; i < order.size(); i += shards) dealt.push_back(order[i]);
  return dealt;
}

UnitsOfWork::UnitsOfWork(Measurements measurements, std::vector<Unit> units, const std::vector<std::size_t>& open)
    : measurements_(std::move(measurements)), units_(std::move(units)), left_(measurements_.size()) {
  for (const std::size_t unit : open) ++left_[units_[unit].measurement];
  for (std::size_t m = 0; m < left_.size(); ++m)
    if (left_[m] == 0) measurements_[m].reset();
}

PartialResult UnitsOfWork::measure(std::size_t unit) {
  const auto [measurement, block] = units_[unit];
  PartialResult found = measurements_[measurement]->measure(block);
  if (--left_[measurement] == 0) measurements_[measurement].reset();
  return found;
}

int block_count(std::size_t samples, std::size_t few) {
  return static_cast<int>(std::clamp<std::size_t>(samples / few, 1, Measurement::most_blocks));
}

std::size_t block_begin(std::size_t samples, int block, int blocks) {
  return samples * static_cast<std::size_t>(block) / static_cast<std::size_t>(blocks);
}

PartialResult measure_all(const Measurements& measurements, int jobs,
                          const std::function<void(std::size_t done, std::size_t all)>& progress) {
  const std::vector<Unit> units = units_of(measurements);
  const std::vector<std::size_t> order = units_of_shard(units, 0, 1);
  PartialResult all;
  std::mutex mutex;
  std::size_t done = 0;
  for_each_parallel(order.size(), jobs, [&](std::size_t i) {
    const Unit& unit = units[order[i]];
    PartialResult found = measurements[unit.measurement]->measure(unit.block);
    const std::scoped_lock lock(mutex);
    all.merge(std::move(found));
    if (progress) progress(++done, order.size());
  });
  return all;
}

}  // namespace cageproof::validation
