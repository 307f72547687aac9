// SPDX-License-Identifier: MIT
#include "cageproof/validation/stored_cases.h"

#include "cageproof/core/input_error.h"
#include "cageproof/reports/worst_file.h"
#include "cageproof/validation/hunt.h"

#include <gtest/gtest.h>

namespace cageproof::validation {
namespace {

reports::WorstLine stored_line() {
  reports::WorstLine line;
  line.subject = "triangle.single_layer";
  line.evaluation = "closed_form";
  line.scalar = "double";
  line.setting = hunted_regime;
  line.check = "truth";
  line.unit = "conditioned";
  line.worst.error = 1e9;  // what is stored must not be believed
  line.worst.corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  line.worst.point = {0.25, 0.25, 0.5};
  return line;
}

std::string message_of(const std::string& text, const std::string& formulas = "*") {
  try {
    replay_stored(text, "cases.jsonl", formulas, "*", 2);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(stored_cases, are_measured_afresh_and_judged) {
  reports::WorstLine line = stored_line();
  std::string text = reports::worst_line(line) + "\n";
  line.worst.point = {2, 3, 4};
  text += reports::worst_line(line) + "\n";
  line.order = line.worst.asked = 1;
  text += reports::worst_line(line) + "\n";
  const auto rows = replay_stored(text, "cases.jsonl", "*", "*", 2);
  // Two orders of the algebra, and of the evaluation that commands take.
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_TRUE(std::ranges::any_of(
      rows, [](const ResultRow& row) { return row.evaluation == "hybrid" && row.samples == 2 && row.bound; }));
  EXPECT_EQ(rows[0].samples, 2U);
  EXPECT_EQ(rows[0].setting, hunted_regime);
  EXPECT_LT(rows[0].max, 64);
  EXPECT_EQ(rows[0].worst.front().error, rows[0].max);
  ASSERT_TRUE(rows[0].bound);
  EXPECT_EQ(rows[0].verdict, Verdict::Kept);
  EXPECT_EQ(rows[1].order, 1);
  EXPECT_TRUE(replay_stored(text, "cases.jsonl", "*solid*", "*", 2).empty());
  EXPECT_TRUE(replay_stored(text, "cases.jsonl", "*", "accurate", 2).empty());
}

TEST(stored_cases, that_can_no_longer_be_run_are_named_by_their_line) {
  const std::string good = reports::worst_line(stored_line()) + "\n";
  const auto complaint = [&](auto change) {
    reports::WorstLine line = stored_line();
    change(line);
    return message_of(good + "\n" + reports::worst_line(line) + "\n");
  };
  const auto expect = [](const std::string& message, const std::string& reason) {
    EXPECT_TRUE(message.starts_with("cases.jsonl:3: ")) << message;
    EXPECT_NE(message.find(reason), std::string::npos) << message;
  };
  expect(complaint([](auto& line) { line.evaluation = "gone"; }), "has no evaluation 'gone'");
  expect(complaint([](auto& line) { line.subject = "triangle.gone"; }), "unknown formula 'triangle.gone'");
  expect(complaint([](auto& line) { line.check = "gone"; }), "unknown check 'gone'");
  expect(complaint([](auto& line) { line.scalar = "half"; }), "unknown scalar 'half'");
  expect(complaint([](auto& line) { line.worst.corners.pop_back(); }), "not an input of");
  expect(complaint([](auto& line) { line.section = ResultRow::Section::Cage; }), "a case of a cage");
  expect(message_of(good + "\n{\"formula\":"), "malformed JSON");
  // Though it is left out today.
  EXPECT_NE(message_of(good + "\n" + good + "{}", "*solid*"), "");
  reports::WorstLine gone = stored_line();
  gone.evaluation = "gone";
  EXPECT_NE(message_of(reports::worst_line(gone), "*solid*"), "");
}

TEST(stored_cases, of_the_program_can_be_run_and_keep_their_promises) {
  for (const ResultRow& row : replay_stored(stored_worst_cases(), stored_cases_file, "*", "*", 0)) {
    EXPECT_NE(row.verdict, Verdict::Broken)
        << row.subject << ' ' << row.evaluation << ' ' << row.check << ' ' << row.order << ' ' << row.max;
    EXPECT_EQ(row.without_truth, 0U) << row.subject << ' ' << row.evaluation << ' ' << row.check << ' ' << row.order;
  }
}

TEST(stored_cases, say_where_their_inputs_come_from) {
  const auto lines = reports::parse_worst(stored_worst_cases(), stored_cases_file);
  ASSERT_FALSE(lines.empty());
  for (const reports::WorstLine& line : lines) {
    RowKey row = line;
    row.setting = hunted_regime;
    EXPECT_NE(origin_of(row, line.worst).find(stored_cases_file), std::string::npos) << line.number;
    EXPECT_NE(origin_of(row, line.worst).find(line.flags.back()), std::string::npos) << line.number;
  }
  EXPECT_EQ(origin_of(lines[0], WorstCase{}), "");
}

}  // namespace
}  // namespace cageproof::validation
