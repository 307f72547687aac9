// SPDX-License-Identifier: MIT
#include "cageproof/core/results/partial_result.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unordered_set>

namespace cageproof {
namespace {

// Everything that a tally holds, as text with all bits.
std::string print(const Tally& tally) {
  std::string text = tally.unit;
  const auto add = [&](double x) {
    text += ' ';
    text += std::to_string(std::bit_cast<std::uint64_t>(x));
  };
  for (const std::uint64_t count : tally.errors.counts()) add(static_cast<double>(count));
  for (const double x :
       {tally.errors.max(), static_cast<double>(tally.errors.nonfinite()), static_cast<double>(tally.asked),
        static_cast<double>(tally.without_truth), static_cast<double>(tally.unreached),
        static_cast<double>(tally.declined), tally.max_relative, tally.total_loss})
    add(x);
  for (const double x : tally.by_parameter) add(x);
  for (const WorstCase& c : tally.worst.cases()) {
    add(c.error);
    add(static_cast<double>(c.sample));
    add(c.point[0]);
  }
  return text;
}

Tally one(int i) {
  Tally tally;
  tally.unit = "conditioned";
  // Several samples have equal errors and numbers: only the inputs tell them apart.
  const double error = i % 7 == 3 ? HUGE_VAL : (i % 4) * 1.5;
  tally.add(error, i * 0.25, i % 3, [&](double e) {
    return WorstCase{e, 0, static_cast<std::uint64_t>(i % 3), {}, Vec3<double>(-i, 0, 0), {}};
  });
  tally.add_to_curve(i % 5, 5, error);
  tally.without_truth = i % 2;
  tally.declined = i % 3;
  tally.unreached = i % 4;
  tally.asked = i + 1;
  tally.total_loss = i % 5 == 0 ? -1 : i % 7;
  return tally;
}

TEST(tally, merges_in_any_order_to_the_same) {
  std::vector<int> order(12);
  for (int i = 0; i < 12; ++i) order[i] = i;
  std::string expected;
  for (int attempt = 0; attempt < 60; ++attempt) {
    std::ranges::rotate(order, order.begin() + 1 + attempt % 11);
    std::swap(order[attempt % 12], order[(attempt * 5 + 1) % 12]);
    Tally left, right;
    for (int k = 0; k < 12; ++k) (k < attempt % 13 ? left : right).merge(one(order[k]));
    left.merge(right);
    if (expected.empty()) expected = print(left);
    EXPECT_EQ(left.without_truth, 6u);
    EXPECT_EQ(left.declined, 12u);
    EXPECT_EQ(left.unreached, 18u);
    EXPECT_EQ(left.asked, 78u);
    EXPECT_EQ(left.total_loss, 6);
    ASSERT_EQ(print(left), expected) << attempt;
  }
}

TEST(tally, of_nothing_has_no_part_in_a_merge) {
  Tally tally = one(3);
  const std::string before = print(tally);
  tally.merge(Tally());
  EXPECT_EQ(print(tally), before);
  EXPECT_TRUE(Tally().empty());
  Tally declined;
  declined.declined = 1;
  EXPECT_FALSE(declined.empty());
}

TEST(tally, in_another_unit_does_not_merge) {
  Tally a = one(1), b = one(2);
  b.unit = "relative";
  EXPECT_THROW(a.merge(b), std::invalid_argument);
}

TEST(tally, counts_what_is_not_a_number_as_infinite) {
  Tally tally;
  tally.add(NAN, 0, 1, [](double e) {
    WorstCase worst;
    worst.error = e;
    return worst;
  });
  EXPECT_EQ(tally.errors.nonfinite(), 1u);
  EXPECT_TRUE(std::isinf(tally.worst.cases().at(0).error));
}

TEST(error_histogram, is_restored_from_its_counts_or_refused) {
  ErrorHistogram errors;
  for (const double e : {0.0, 1e-9, 2.5, 1e30, HUGE_VAL}) errors.add(e);
  const auto again = ErrorHistogram::restored(errors.counts(), errors.nonfinite(), errors.max());
  EXPECT_EQ(again.counts(), errors.counts());
  EXPECT_EQ(again.count(), 5u);
  EXPECT_EQ(again.p999(), errors.p999());
  EXPECT_THROW(ErrorHistogram::restored(errors.counts(), 3, HUGE_VAL), std::invalid_argument);
  EXPECT_THROW(ErrorHistogram::restored(errors.counts(), 1, 2.0), std::invalid_argument);
  EXPECT_THROW(ErrorHistogram::restored(errors.counts(), 0, NAN), std::invalid_argument);
  EXPECT_THROW(ErrorHistogram::restored({}, 0, 1), std::invalid_argument);
}

TEST(row_key, is_ordered_and_hashed_by_every_member) {
  const RowKey key{RowKey::Section::Element, "a", "b", "c", "d", "e", "f", 1};
  std::vector<RowKey> keys(9, key);
  keys[1].section = RowKey::Section::Cage;
  for (int i = 2; i < 8; ++i)
    *std::array{&keys[i].subject, &keys[i].evaluation, &keys[i].scalar,
                &keys[i].setting, &keys[i].check,      &keys[i].place}[i - 2] += "x";
  keys[8].order = 2;
  EXPECT_EQ(std::unordered_set<RowKey>(keys.begin(), keys.end()).size(), 9u);
  for (int i = 1; i < 9; ++i) EXPECT_LT(keys[0], keys[i]) << i;
}

TEST(row_key, sections_have_names_of_their_own) {
  std::vector<std::string_view> names;
  names.reserve(sections.size());
  for (const RowKey::Section section : sections) names.push_back(name_of(section));
  EXPECT_EQ(names, (std::vector<std::string_view>{"element", "cage", "deformer"}));
}

FieldPart part(std::size_t first, std::vector<double> values) {
  FieldPart p;
  p.samples = 6;
  p.first = first;
  p.image.name = "field";
  p.image.arrays = {{"error", "1", 1, std::move(values)}};
  return p;
}

PartialResult with(FieldPart p) {
  PartialResult gathered;
  gathered.fields.emplace(std::pair(4, p.first), std::move(p));
  return gathered;
}

TEST(partial_results, make_fields_whole_whoever_merged_which_parts) {
  PartialResult left = with(part(2, {2, 3})), right = with(part(4, {4, 5}));
  right.merge(with(part(0, {0, 1})));
  left.merge(right);
  EXPECT_EQ(whole_fields(left).at(4).image.arrays[0].values, (std::vector<double>{0, 1, 2, 3, 4, 5}));
  const auto half = whole_fields(right).at(4).image.arrays[0].values;
  EXPECT_TRUE(std::isnan(half.at(3)));
  EXPECT_EQ(half.at(4), 4);
}

TEST(partial_results, refuse_parts_that_do_not_fit) {
  PartialResult gathered = with(part(0, {0}));
  gathered.merge(with(part(5, {5, 6})));
  EXPECT_THROW(whole_fields(gathered), std::invalid_argument);
}

TEST(partial_results, drop_no_worst_case_that_could_count) {
  const RowKey key;
  PartialResult dropped, kept;
  for (int i = 0; i < 40; ++i) {
    PartialResult found;
    for (int k = 0; k < 3; ++k) found.rows[key].merge(one(5 * i + k));
    kept.merge(found);
    const std::size_t before = found.rows[key].worst.cases().size();
    found.drop_unwanted(dropped);
    if (i > 20) {
      EXPECT_LT(found.rows[key].worst.cases().size(), before) << "of what is found late little counts";
    }
    dropped.merge(found);
  }
  EXPECT_EQ(print(dropped.rows[key]), print(kept.rows[key]));
}

}  // namespace
}  // namespace cageproof
