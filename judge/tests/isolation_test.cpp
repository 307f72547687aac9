// SPDX-License-Identifier: MIT
// Harm that foreign code does to its process is found, and nothing else is lost.
#include "cageproof/core/input_error.h"
#include "cageproof/judge/foreign_code.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

namespace cageproof::judge {
namespace {

const Formula& formula() { return formula_named("triangle.single_layer"); }

// Only code that hangs is to run out of time, on a busy machine, too.
constexpr double kAmple = 60, kBrief = 2;

Limits limits(double seconds = kAmple) {
  Limits found;
  found.seconds = seconds;
  found.host = {JUDGE_TEST_HOST};
  found.memory = 1ULL << 28U;
  found.written = 1ULL << 20U;
  return found;
}

// Nine elements with one point each; the fifth has the x that hostile code waits for.
std::vector<Asked> nine() {
  std::vector<Asked> asked;
  asked.reserve(9);
  for (int i = 0; i < 9; ++i)
    asked.push_back({{0, 0, 0, 1, 0, 0, 0, 1, 0}, {}, {i == 4 ? 0.5 : 0.125 * i + 0.0625, 0.25, 1}, 1});
  return asked;
}

int processes() {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc"))
    if (std::isdigit(static_cast<unsigned char>(entry.path().filename().string()[0])) != 0) {
      std::ifstream file(entry.path() / "cmdline");
      std::string text;
      std::getline(file, text, '\0');
      count += text.find("judge_test_host") != std::string::npos || text.find("hostile") != std::string::npos;
    }
  return count;
}

struct Found {
  std::vector<Answer> answers;
  std::vector<Incident> incidents;
  double seconds = 0;
  std::string code;
};

Found judged(const std::string& what, double seconds) {
  const auto start = std::chrono::steady_clock::now();
  // Other tests' code may still run in this program.
  const int before = processes();
  Found found;
  found.code = what;
  {
    ForeignCode code(what, limits(seconds));
    found.answers = code.ask({&formula(), 0, false}, nine());
    code.finish();
    found.incidents = code.incidents();
  }
  found.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  // A killed process may be seen until the system has buried it.
  for (int i = 0; i < 50 && processes() != before; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_EQ(processes(), before) << what;
  return found;
}

Found library_that(const std::string& what, double seconds = kAmple) {
  setenv("HOSTILE", what.c_str(), 1);
  Found found = judged(JUDGED_LIBRARIES "/hostile.so", seconds);
  found.code = what;
  unsetenv("HOSTILE");
  return found;
}

Found program_that(const std::string& what, double seconds = kAmple) {
  return judged(JUDGED_PROGRAMS "/hostile.py '" + what + "'", seconds);
}

// All but the fifth are there.
void expect_only_fifth(const Found& found, Answer::Status status, const std::string& kind, const std::string& part) {
  for (std::size_t i = 0; i < found.answers.size(); ++i) {
    EXPECT_EQ(found.answers[i].status, i == 4 ? status : Answer::Status::Given) << i << kind;
    if (i != 4 && found.answers[i].status == Answer::Status::Given)
      EXPECT_EQ(found.answers[i].tensors[0], std::vector<double>{7});
  }
  if (kind.empty()) {
    EXPECT_TRUE(found.incidents.empty()) << found.incidents[0].text;
    return;
  }
  ASSERT_EQ(found.incidents.size(), 1U) << kind;
  EXPECT_EQ(found.incidents[0].kind, kind) << found.code;
  EXPECT_NE(found.incidents[0].text.find(part), std::string::npos) << found.incidents[0].text;
  EXPECT_NE(found.incidents[0].input.find("\"point\":[\"0x1p-1\","), std::string::npos) << found.incidents[0].input;
}

TEST(isolation, library_that_behaves_is_asked_in_blocks) {
  const Found found = library_that("nothing");
  ASSERT_EQ(found.answers.size(), 9U);
  EXPECT_EQ(found.answers[4].tensors[0], std::vector<double>{7});
  EXPECT_TRUE(found.incidents.empty());
}

TEST(isolation, library_that_dies_loses_one_input) {
  using enum Answer::Status;
  expect_only_fifth(library_that("crash"), Failed, "crash", "signal 11");
  expect_only_fifth(library_that("exit"), Failed, "exit", "code 3");
  expect_only_fifth(library_that("memory"), Failed, "crash", "signal 11");
  expect_only_fifth(library_that("kill own group"), Failed, "crash", "signal 9");
  expect_only_fifth(library_that("fork and crash"), Failed, "crash", "signal 6");
  expect_only_fifth(library_that("print without end"), Failed, "output", "more than 1 MB");
  expect_only_fifth(library_that("answer pipe"), Failed, "garbage", "none of its own");
}

TEST(isolation, library_that_hangs_is_ended_in_time) {
  const Found found = library_that("hang", kBrief);
  expect_only_fifth(found, Answer::Status::Failed, "hang", "2 s");
  EXPECT_LT(found.seconds, 4 * kBrief);
}

TEST(isolation, library_that_kills_its_parents_group_is_named) {
  // Its own process may or may not come to the end of the block before the system ends it.
  const Found found = library_that("kill group");
  ASSERT_FALSE(found.incidents.empty());
  EXPECT_TRUE(found.incidents[0].kind.starts_with("killed others")) << found.incidents[0].kind;
  EXPECT_EQ(found.answers[3].status, Answer::Status::Given);
  EXPECT_EQ(found.answers[8].status, Answer::Status::Given);
}

TEST(isolation, library_that_stops_its_parent_leaves_nothing) {
  expect_only_fifth(library_that("stop parent"), Answer::Status::Given, "", "");
}

// The limit of tasks is not for root, whom nothing stops.
TEST(isolation, library_that_forks_without_end_is_ended) {
  if (getuid() == 0) GTEST_SKIP() << "root has no limit of processes";
  const Found found = library_that("fork without end");
  EXPECT_EQ(found.answers[4].status, Answer::Status::Failed);
  EXPECT_EQ(found.answers[5].status, Answer::Status::Given);
}

TEST(isolation, library_that_closes_all_its_files_is_named) {
  expect_only_fifth(library_that("close all"), Answer::Status::Failed, "crash", "closed a file");
}

TEST(isolation, library_that_declines_is_no_incident) {
  expect_only_fifth(library_that("decline"), Answer::Status::Declined, "", "");
}

TEST(isolation, library_that_leaves_memory_is_told_which) {
  using enum Answer::Status;
  expect_only_fifth(library_that("read beyond"), Failed, "crash", "beyond the end of `points`");
  expect_only_fifth(library_that("write beyond"), Failed, "crash", "beyond the end of `values`");
}

TEST(isolation, library_whose_answer_is_wrong_in_form_is_told) {
  using enum Answer::Status;
  expect_only_fifth(library_that("code"), Failed, "error code", "17");
  expect_only_fifth(library_that("short"), Given, "short answer", "unset");
  expect_only_fifth(library_that("change input"), Given, "changed input", "corners or points");
}

TEST(isolation, library_that_prints_or_forks_is_told_afterwards) {
  const Found printed = library_that("print");
  ASSERT_EQ(printed.incidents.size(), 1U);
  EXPECT_EQ(printed.incidents[0].kind, "standard output");
  const Found forked = library_that("fork");
  ASSERT_EQ(forked.incidents.size(), 1U);
  EXPECT_EQ(forked.incidents[0].kind, "left processes");
  EXPECT_NE(forked.incidents[0].text.find("processes running"), std::string::npos) << forked.incidents[0].text;
}

TEST(isolation, program_that_dies_or_answers_garbage_loses_one_input) {
  using enum Answer::Status;
  expect_only_fifth(program_that("crash"), Failed, "crash", "signal 11");
  expect_only_fifth(program_that("raise"), Failed, "exit", "ValueError: no such point");
  expect_only_fifth(program_that("exit"), Failed, "exit", "code 0");
  expect_only_fifth(program_that("garbage"), Failed, "garbage", "no JSON object: what?");
  expect_only_fifth(program_that("short"), Failed, "short answer", "0 numbers instead of 1");
  expect_only_fifth(program_that("endless line"), Failed, "garbage", "more than 1048576 bytes");
  expect_only_fifth(program_that("nested"), Failed, "garbage", "no number");
  expect_only_fifth(program_that("decline"), Declined, "", "");
}

TEST(isolation, program_that_hangs_is_ended_in_time) {
  const Found found = program_that("hang", kBrief);
  expect_only_fifth(found, Answer::Status::Failed, "hang", "flush");
  EXPECT_LT(found.seconds, 4 * kBrief);
}

TEST(isolation, program_whose_bytes_are_no_lines_is_ended_in_time) {
  for (const char* const what : {"blank lines", "drip"}) {
    const Found found = program_that(what, kBrief);
    expect_only_fifth(found, Answer::Status::Failed, "hang", "2 s");
    EXPECT_LT(found.seconds, 4 * kBrief) << what;
  }
}

TEST(isolation, program_writes_numbers_as_text_too) {
  const Found found = program_that("nan");
  ASSERT_EQ(found.answers[4].tensors[0].size(), 1U);
  EXPECT_TRUE(std::isnan(found.answers[4].tensors[0][0]));
  EXPECT_EQ(program_that("hexadecimal").answers[4].tensors[0], std::vector<double>{7});
}

TEST(isolation, program_that_answers_twice_is_found) {
  ForeignCode code(JUDGED_PROGRAMS "/hostile.py twice", limits());
  EXPECT_EQ(code.about(), "hostile 2.0");
  code.ask({&formula(), 0, false}, nine());
  code.ask({&formula(), 0, false}, nine());
  code.finish();
  // By the next block, or at the end.
  ASSERT_FALSE(code.incidents().empty());
  EXPECT_TRUE(code.incidents()[0].kind.starts_with("garbage")) << code.incidents()[0].kind;
  EXPECT_NE(code.incidents()[0].text.find("more lines"), std::string::npos) << code.incidents()[0].text;
}

TEST(isolation, program_that_forks_leaves_nothing) {
  const Found found = program_that("fork");
  ASSERT_EQ(found.incidents.size(), 1U);
  EXPECT_EQ(found.incidents[0].kind, "left processes");
}

TEST(isolation, what_always_hangs_is_given_up) {
  setenv("HOSTILE", "hang", 1);
  ForeignCode code(JUDGED_LIBRARIES "/hostile.so", limits(1));
  std::vector<Asked> asked = nine();
  for (Asked& one : asked) one.points[0] = 0.5;
  for (const Answer& answer : code.ask({&formula(), 0, false}, asked)) EXPECT_EQ(answer.status, Answer::Status::Failed);
  unsetenv("HOSTILE");
  EXPECT_EQ(code.skipped(), 6U);
}

TEST(isolation, what_cannot_be_started_says_why) {
  const auto message = [](const std::string& what) -> std::string {
    try {
      const ForeignCode code(what, limits());
      return "";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_NE(message("./nothing.so").find("no such file"), std::string::npos);
  EXPECT_NE(message("/bin/no_such_program").find("not found"), std::string::npos) << message("/bin/no_such_program");
  EXPECT_NE(message("true").find("exited with code 0"), std::string::npos) << message("true");
}

}  // namespace
}  // namespace cageproof::judge
