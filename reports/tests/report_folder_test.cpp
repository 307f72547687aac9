// SPDX-License-Identifier: MIT
// What is on the disk when all goes well, and when it does not.
#include "cageproof/core/input_error.h"
#include "cageproof/reports/checked_file.h"
#include "sample_run.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <csignal>
#include <cstdlib>

namespace cageproof::reports {
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

// No file may grow beyond `bytes`: what a full disk looks like to a program, gnuplot included.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit now{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &now);
  }
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

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
  EXPECT_NE(refusal(mine).find("holds no report"), std::string::npos);
  write_file(mine / "summary.json", "{\"schema\": \"another\"}");
  EXPECT_NE(refusal(mine).find("holds no report"), std::string::npos);
  write_file(mine / "summary.json", "{\"schema\": \"cageproof-summary\"}");
  EXPECT_EQ(refusal(mine), "");
  write_file(mine / "thesis.tex", "years of work");
  EXPECT_NE(refusal(mine).find("'thesis.tex', which is no part of a report"), std::string::npos);
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

// What writing a report says when `gnuplot` is this shell script; nothing: when there is no gnuplot.
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
  const std::string message = message_of([&] { write_report(scratch.path() / "report", sample_run(1, 1)); });
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
  EXPECT_NE(message_with("exit 0\n").find("cannot read "), std::string::npos);
  // Each picture cut off after its signature.
  const std::string message = message_with(
      "sed -n \"s/^set output '\\(.*\\)'/\\1/p\" \"$2\" | while read f; do printf '\\211PNG\\r\\n\\032\\nIHDR' > "
      "\"$f\"; done\n");
  EXPECT_NE(message.find("the picture is not whole"), std::string::npos) << message;
}

}  // namespace
}  // namespace cageproof::reports
