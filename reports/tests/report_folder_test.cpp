// SPDX-License-Identifier: MIT
// The folder's contents when all goes well, and when it does not.
#include "cageproof/core/input_error.h"
#include "cageproof/core/whole_file.h"
#include "cageproof/reports/checked_file.h"
#include "cageproof/reports/run_folder.h"
#include "sample_run.h"
#include "small_disk.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

namespace cageproof::reports::report_folder_test {
namespace {

namespace fs = std::filesystem;

template <class Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void write_report(const fs::path& out, const RunResult& run) {
  ReportWriter writer(out);
  RunResult with_field = run;
  with_field.fields.push_back(
      writer.write_image(sample_slice("slice", 8), "slice", "relative error", ColourScale::Log10));
  writer.write(with_field);
  writer.commit();
}

TEST(ReportFolder, IsNotThereBeforeCommit) {
  const ScratchFolder scratch;
  {
    ReportWriter writer(scratch.path() / "report");
    writer.write(sample_run(1, 1));
    EXPECT_FALSE(fs::exists(scratch.path() / "report"));
  }
  EXPECT_TRUE(scratch.is_empty());
}

TEST(ReportFolder, ReplacesAnEarlierReportAsAWhole) {
  const ScratchFolder scratch;
  const fs::path out = scratch.path() / "report";
  fs::create_directory(out);
  write_report(out / "", sample_run(2, 2));
  const auto first = files_below(out);
  EXPECT_TRUE(first.contains("pictures/triangle.double_layer.generic.truth.png"));
  {
    ReportWriter writer(out);
    writer.write(sample_run(1, 1));
    EXPECT_EQ(files_below(out), first);
  }
  EXPECT_EQ(files_below(out), first);
  write_report(out, sample_run(1, 1));
  EXPECT_FALSE(files_below(out).contains("pictures/triangle.double_layer.generic.truth.png"));
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.path()), fs::directory_iterator()), 1);
}

TEST(ReportFolder, ALinkStaysALink) {
  const ScratchFolder scratch;
  fs::create_directory(scratch.path() / "real");
  fs::create_directory_symlink(scratch.path() / "real", scratch.path() / "link");
  write_report(scratch.path() / "link", sample_run(1, 1));
  EXPECT_TRUE(fs::is_symlink(scratch.path() / "link"));
  EXPECT_TRUE(fs::exists(scratch.path() / "real" / "index.html"));
}

TEST(ReportFolder, RefusesWhatIsNotItsToReplace) {
  const ScratchFolder scratch;
  const auto refusal = [&](const fs::path& out) { return message_of([&] { ReportWriter writer(out); }); };
  EXPECT_NE(refusal(scratch.path() / "missing" / "report").find("missing does not exist"), std::string::npos);
  EXPECT_NE(refusal("").find("empty name"), std::string::npos);
  EXPECT_NE(refusal("/").find("root"), std::string::npos);
  // procfs lets nobody make folders.
  EXPECT_NE(refusal("/proc/cageproof-report").find("cannot write /proc/cageproof-report: "), std::string::npos);

  write_file(scratch.path() / "file", "mine");
  EXPECT_NE(refusal(scratch.path() / "file").find("is no folder"), std::string::npos);
  EXPECT_NE(refusal(scratch.path() / "file" / "report").find("cannot write"), std::string::npos);

  const fs::path mine = scratch.path() / "mine";
  fs::create_directories(mine / "pictures");
  EXPECT_NE(refusal(mine).find("does not hold a verification report"), std::string::npos);
  write_file(mine / "summary.json", "{\"schema\": \"another\"}");
  EXPECT_NE(refusal(mine).find("does not hold a verification report"), std::string::npos);
  write_file(mine / "summary.json", "{\"schema\": \"cageproof-summary\"}");
  EXPECT_EQ(refusal(mine), "");
  write_file(mine / "thesis.tex", "years of work");
  EXPECT_NE(refusal(mine).find("'thesis.tex', which is no part of a verification report"), std::string::npos);
  EXPECT_EQ(files_below(scratch.path()).size(), 3u);
}

TEST(ReportFolder, IsCheckedAgainBeforeItIsReplaced) {
  const ScratchFolder scratch;
  const fs::path out = scratch.path() / "report";
  const std::string message = message_of([&] {
    ReportWriter writer(out);
    writer.write(sample_run(1, 1));
    fs::create_directory(out);
    write_file(out / "thesis.tex", "years of work");
    writer.commit();
  });
  EXPECT_NE(message.find("thesis.tex"), std::string::npos);
  EXPECT_EQ(files_below(scratch.path()).size(), 1u);
}

TEST(ReportFolder, AFullDiskLeavesTheEarlierReport) {
  const ScratchFolder scratch;
  const fs::path out = scratch.path() / "report";
  write_report(out, sample_run(1, 2));
  const auto whole = files_below(out);
  write_report(out, sample_run(1, 1));
  const auto before = files_below(out);
  int failures = 0;
  for (rlim_t bytes = 256;; bytes = bytes * 3 / 2) {
    std::string message;
    {
      const SmallDisk disk(bytes);
      message = message_of([&] { write_report(out, sample_run(1, 2)); });
    }
    if (message.empty()) break;
    ++failures;
    EXPECT_TRUE(message.starts_with("cannot write ") || message.starts_with("cannot draw ")) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    ASSERT_EQ(files_below(scratch.path()).size(), before.size()) << message;
    ASSERT_EQ(files_below(out), before) << message;
  }
  EXPECT_GT(failures, 8);
  EXPECT_EQ(files_below(out), whole);
}

void write_field(const fs::path& out) {
  ReportWriter writer(out, ReportWriter::Kind::Field);
  RunResult run;
  run.fields.push_back(writer.write_image(sample_slice("slice", 8), "slice", "relative error", ColourScale::Log10));
  writer.write(run);
  writer.commit();
}

JournalHeader header(int shard = 0, int shards = 1) {
  JournalHeader h;
  h.version = "0.1.0";
  h.units = h.shard_units = 2;
  h.shard = shard;
  h.shards = shards;
  return h;
}

TEST(ReportFolder, OfOneKindIsNotReplacedByAnother) {
  const ScratchFolder scratch;
  const fs::path report = scratch.path() / "report", field = scratch.path() / "field", shard = scratch.path() / "shard";
  write_report(report, sample_run(1, 1));
  write_field(field);
  begin_run(shard, header(1, 4), {});
  const auto before = files_below(scratch.path());
  EXPECT_NE(message_of([&] {
              write_field(report);
            }).find("the folder holds a verification report, which an error field does not replace"),
            std::string::npos);
  EXPECT_NE(message_of([&] {
              write_report(field, sample_run(1, 1));
            }).find("the folder holds an error field, which a verification report does not"),
            std::string::npos);
  EXPECT_NE(message_of([&] { begin_run(field, header(), {}); }).find("holds an error field"), std::string::npos);
  EXPECT_NE(message_of([&] { write_report(shard, sample_run(1, 1)); }).find("holds a shard of a run"),
            std::string::npos);
  EXPECT_NE(message_of([&] { begin_run(shard, header(), {}); }).find("holds a shard of a run"), std::string::npos);
  EXPECT_NE(message_of([&] { begin_run(shard, header(2, 4), {}); }).find("holds shard 1/4, which shard 2/4"),
            std::string::npos);
  EXPECT_NE(message_of([&] { begin_run(report, header(2, 4), {}); }).find("holds a verification report"),
            std::string::npos);
  EXPECT_EQ(files_below(scratch.path()), before);
  begin_run(shard, header(1, 4), {});
  write_field(field);
  write_report(report, sample_run(1, 1));
}

TEST(ReportFolder, OfARunThatDiedHoldsItsJournalAndCanBeReplaced) {
  const ScratchFolder scratch;
  const fs::path out = scratch.path() / "report";
  const fs::path journal = begin_run(out, header(), {});
  EXPECT_EQ(journal, fs::canonical(out) / "journal");
  EXPECT_EQ(files_below(scratch.path()).size(), 1u);
  begin_run(out, header(), {});
  write_report(out, sample_run(1, 1));
  // The earlier report stays until there is a new one.
  begin_run(out, header(), {});
  EXPECT_TRUE(fs::exists(out / "index.html"));
  // Its verdict is not where that of the new one will be.
  for (const char* name : {"summary.json.gz", "summary.md"}) {
    EXPECT_FALSE(fs::exists(out / name)) << name;
    EXPECT_TRUE(fs::exists(out / fmt::format("earlier.{}", name))) << name;
  }
  begin_run(out, header(), {});
  EXPECT_TRUE(fs::exists(out / "earlier.summary.json.gz"));
  EXPECT_EQ(read_journal(journal_in(out)).units_done(), 0u);
  write_report(out, sample_run(1, 1));
  EXPECT_TRUE(fs::exists(out / "summary.json.gz"));
  EXPECT_FALSE(fs::exists(out / "earlier.summary.json.gz"));
  begin_run(out, header(), {});
  const JournalWriter somebody_writes(journal);
  EXPECT_NE(message_of([&] { begin_run(out, header(), {}); }).find("another process is writing to it"),
            std::string::npos);
  EXPECT_NE(message_of([&] { journal_in(scratch.path()); }).find("there is no journal"), std::string::npos);
}

// The number of a process that is gone.
pid_t gone() {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  return child;
}

TEST(ReportFolder, RemovesWhatKilledProcessesLeftAndNothingElse) {
  const ScratchFolder scratch;
  char host[256] = "";
  ::gethostname(host, sizeof host - 1);
  const pid_t dead = gone();
  const std::vector<std::string> stale{fmt::format(".report.partial-{}-0@{}", dead, host),
                                       fmt::format(".report.partial-{}-1", dead)},
      kept{fmt::format(".report.partial-{}-0@{}", ::getpid(), host),
           fmt::format(".report.partial-{}-0@elsewhere", dead), fmt::format(".other.partial-{}-0@{}", dead, host),
           ".report.partial-mine", ".report.partial-"};
  for (const auto* names : {&stale, &kept})
    for (const std::string& name : *names) {
      fs::create_directories(scratch.path() / name / "fields");
      write_file(scratch.path() / name / "summary.json", "{}");
    }
  write_report(scratch.path() / "report", sample_run(1, 1));
  for (const std::string& name : stale) EXPECT_FALSE(fs::exists(scratch.path() / name)) << name;
  for (const std::string& name : kept) EXPECT_TRUE(fs::exists(scratch.path() / name / "summary.json")) << name;
}

TEST(ReportFolder, MovedAsideByAKilledProcessComesBack) {
  const ScratchFolder scratch;
  const fs::path out = scratch.path() / "report";
  begin_run(out, header(), {});
  const pid_t dead = gone();
  // Where folders cannot be exchanged, a process may die between the two steps.
  fs::rename(out, scratch.path() / fmt::format(".report.partial-{}-0.earlier", dead));
  fs::create_directory(scratch.path() / fmt::format(".report.partial-{}-0", dead));
  EXPECT_EQ(read_journal(journal_in(out)).header, header());
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.path()), fs::directory_iterator()), 1);
}

TEST(CheckedFile, RemovesWhatKilledProcessesLeft) {
  const ScratchFolder scratch;
  const fs::path stale = scratch.path() / fmt::format(".cases.jsonl.partial-{}", gone());
  write_file(stale, "half");
  replace_file(scratch.path() / "cases.jsonl", "whole");
  EXPECT_FALSE(fs::exists(stale));
  EXPECT_EQ(read_file(scratch.path() / "cases.jsonl"), "whole");
}

// The message of a report's writer when `gnuplot` is this shell script; nothing: when there is no gnuplot.
std::string message_with(const std::string& script) {
  const ScratchFolder scratch;
  const fs::path tools = scratch.path() / "tools";
  fs::create_directory(tools);
  if (!script.empty()) {
    write_file(tools / "gnuplot", "#!/bin/sh\n" + script);
    fs::permissions(tools / "gnuplot", fs::perms::owner_all);
  }
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", script.empty() ? tools.c_str() : (tools.string() + ":" + path).c_str(), 1);
  std::string message = message_of([&] { write_report(scratch.path() / "report", sample_run(1, 1)); });
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.path()), fs::directory_iterator()), 1) << "more than tools/";
  return message;
}

TEST(ReportFolder, WithoutGnuplotThereIsNoReport) {
  EXPECT_NE(message_with("").find("install gnuplot-nox"), std::string::npos);
}

TEST(ReportFolder, WhatGnuplotSaysIsReported) {
  EXPECT_EQ(message_with("echo 'first' >&2\necho 'unknown terminal pngcairo' >&2\nexit 1\n"),
            "cannot draw pictures: gnuplot failed: unknown terminal pngcairo");
  EXPECT_NE(message_with("kill -9 $$\n").find("cannot draw pictures: gnuplot died"), std::string::npos);
}

TEST(ReportFolder, HalfPicturesAreNoticed) {
  EXPECT_NE(message_with("exit 0\n").find("the picture is not whole"), std::string::npos);
  // Each picture cut off after its signature.
  const std::string message = message_with(
      "sed -n \"s/^set output '\\(.*\\)'/\\1/p\" \"$2\" | while read f; do printf '\\211PNG\\r\\n\\032\\nIHDR' > "
      "\"$f\"; done\n");
  EXPECT_NE(message.find("the picture is not whole"), std::string::npos) << message;
}

// Gnuplot ends at a picture that it refuses: the others, and all that was measured, are there.
TEST(ReportFolder, APictureThatGnuplotRefusesIsToldAndLosesNothingElse) {
  const ScratchFolder scratch;
  const fs::path tools = scratch.path() / "tools", out = scratch.path() / "report";
  fs::create_directory(tools);
  const std::string path = std::getenv("PATH");
  write_file(tools / "gnuplot",
             "#!/bin/sh\nif grep -q 'label 1 .a refused slice' \"$2\"; then echo 'too flat' >&2; exit 1; fi\n"
             "PATH='" +
                 path + "' exec gnuplot \"$@\"\n");
  fs::permissions(tools / "gnuplot", fs::perms::owner_all);
  RunResult run = sample_run(1, 1);
  ReportWriter writer(out);
  for (const std::string title : {"a refused slice", "another slice"})
    run.fields.push_back(writer.write_image(sample_slice(title, 9), title, "relative error", ColourScale::Log10));
  ::setenv("PATH", (tools.string() + ":" + path).c_str(), 1);
  const std::vector<std::string> undrawn = writer.write(run);
  ::setenv("PATH", path.c_str(), 1);
  writer.commit();
  ASSERT_EQ(undrawn.size(), 1u);
  EXPECT_EQ(undrawn[0].find(run.fields[0].picture + ": gnuplot failed: too flat"), 0u) << undrawn[0];
  for (const FieldEntry& field : run.fields) EXPECT_GT(fs::file_size(out / field.picture), 500u) << field.title;
  EXPECT_NE(read_file(out / "summary.md").find("gnuplot failed: too flat"), std::string::npos);
  EXPECT_NE(read_file(out / "index.html").find("gnuplot failed: too flat"), std::string::npos);
}

}  // namespace
}  // namespace cageproof::reports::report_folder_test
