// SPDX-License-Identifier: MIT
// Units of work are the same whoever takes them, few whatever the samples, and dealt out evenly.
#include "run/campaign.h"
#include "cageproof/validation/measurement.h"

#include <gtest/gtest.h>

#include <set>

namespace cageproof::validation {
namespace {

class Fake final : public Measurement {
 public:
  explicit Fake(int blocks) : blocks_(blocks) {}
  std::string name() const override { return "fake"; }
  int blocks() const override { return blocks_; }
  PartialResult measure(int block) const override {
    PartialResult gathered;
    gathered.rows[{}].without_truth = 1ULL << block;
    return gathered;
  }

 private:
  int blocks_;
};

std::vector<Unit> some_units() {
  Measurements measurements;
  for (int i = 0; i < 40; ++i) measurements.push_back(std::make_unique<Fake>(i % 3 == 0 ? 16 : 1));
  return units_of(measurements);
}

TEST(units, are_each_in_one_shard) {
  const std::vector<Unit> units = some_units();
  for (const int shards : {1, 2, 3, 6, 16, 17, 400}) {
    std::multiset<std::size_t> taken;
    for (int shard = 0; shard < shards; ++shard)
      for (const std::size_t unit : units_of_shard(units, shard, shards)) taken.insert(unit);
    ASSERT_EQ(taken.size(), units.size()) << shards;
    for (std::size_t unit = 0; unit < units.size(); ++unit) ASSERT_EQ(taken.count(unit), 1u) << shards;
  }
}

TEST(units, that_cost_most_are_shared_by_all_shards) {
  const std::vector<Unit> units = some_units();
  // Also where the number of shards divides the number of blocks.
  for (const int shards : {2, 3, 4, 8, 16})
    for (int shard = 0; shard < shards; ++shard) {
      int first_blocks = 0;
      for (const std::size_t unit : units_of_shard(units, shard, shards)) first_blocks += units[unit].block == 0;
      EXPECT_GE(first_blocks, 40 / shards) << shard << '/' << shards;
      EXPECT_LE(first_blocks, 40 / shards + 1) << shard << '/' << shards;
    }
}

TEST(units, add_up_once_each) {
  Measurements measurements;
  measurements.push_back(std::make_unique<Fake>(16));
  EXPECT_EQ(measure_all(measurements, 3).rows[{}].without_truth, (1ULL << 16) - 1);
}

// Counts those that exist.
class Counted final : public Measurement {
 public:
  Counted(int blocks, std::atomic<int>& alive) : blocks_(blocks), alive_(alive) { ++alive_; }
  ~Counted() override { --alive_; }
  std::string name() const override { return "counted"; }
  int blocks() const override { return blocks_; }
  PartialResult measure(int block) const override {
    PartialResult gathered;
    gathered.rows[{}].asked = 1ULL << block;
    return gathered;
  }

 private:
  int blocks_;
  std::atomic<int>& alive_;
};

TEST(units, let_go_of_a_measurement_when_its_last_block_is_done) {
  std::atomic<int> alive{0};
  Measurements measurements;
  for (const int blocks : {3, 1, 2}) measurements.push_back(std::make_unique<Counted>(blocks, alive));
  const std::vector<Unit> units = units_of(measurements);
  ASSERT_EQ(units.size(), 6u);
  // The last measurement's second block is another's to measure.
  UnitsOfWork work(std::move(measurements), units, {0, 1, 2, 3, 4});
  EXPECT_EQ(alive, 3);
  EXPECT_EQ(work.measure(2).rows[{}].asked, 4u);
  EXPECT_EQ(work.measure(0).rows[{}].asked, 1u);
  EXPECT_EQ(alive, 3);
  EXPECT_EQ(work.measure(1).rows[{}].asked, 2u);
  EXPECT_EQ(alive, 2);
  work.measure(4);
  EXPECT_EQ(alive, 1);
  EXPECT_EQ(work.name(3), "counted");
  work.measure(3);
  EXPECT_EQ(alive, 0);
}

TEST(units, that_nobody_measures_are_let_go_at_once) {
  std::atomic<int> alive{0};
  Measurements measurements;
  for (int i = 0; i < 3; ++i) measurements.push_back(std::make_unique<Counted>(1, alive));
  const std::vector<Unit> units = units_of(measurements);
  const UnitsOfWork work(std::move(measurements), units, {1});
  EXPECT_EQ(alive, 1);
}

TEST(units, are_few_whatever_the_samples) {
  CampaignOptions options;
  options.formulas = "triangle.solid_angle";
  options.regimes = "near-*";
  for (const int samples : {1, 17, 96, 1000, 100000, 100000000}) {
    options.samples = samples;
    for (const auto& measurement : element_measurements(options)) {
      EXPECT_GE(measurement->blocks(), 1);
      EXPECT_LE(measurement->blocks(), Measurement::most_blocks) << samples;
    }
  }
}

TEST(units, do_not_change_what_is_found) {
  CampaignOptions options;
  options.formulas = "triangle.solid_angle";
  options.regimes = "near-edge";
  options.samples = 40;
  options.enclosures = 0;
  const auto measurements = element_measurements(options);
  PartialResult forwards, backwards;
  for (int block = 0; block < measurements[0]->blocks(); ++block) forwards.merge(measurements[0]->measure(block));
  for (int block = measurements[0]->blocks(); block-- > 0;) backwards.merge(measurements[0]->measure(block));
  ASSERT_EQ(forwards.rows.size(), backwards.rows.size());
  EXPECT_GT(measurements[0]->blocks(), 2);
  for (const auto& [key, tally] : forwards.rows) {
    const Tally& other = backwards.rows.at(key);
    EXPECT_EQ(tally.errors.counts(), other.errors.counts());
    EXPECT_EQ(tally.errors.max(), other.errors.max());
    EXPECT_EQ(tally.max_relative, other.max_relative);
    EXPECT_EQ(tally.by_parameter, other.by_parameter);
    for (std::size_t i = 0; i < tally.worst.cases().size(); ++i)
      EXPECT_EQ(tally.worst.cases()[i].sample, other.worst.cases().at(i).sample);
  }
}

}  // namespace
}  // namespace cageproof::validation
