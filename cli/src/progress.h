// SPDX-License-Identifier: MIT
// How far a command is, and remarks, on standard error: for those who wait. --quiet says neither.
#pragma once

#include "command_line.h"

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace cageproof::cli {

/// Adds --quiet, for the run of the program.
void add_quiet(Command command);

/// A line on standard error that is no warning; none with --quiet.
void remark(const std::string& text);

/// One line on a terminal's standard error, rewritten, with the time that is left; elsewhere one line per minute, or
/// per as many seconds as CAGEPROOF_PROGRESS says. From any thread.
class Progress {
 public:
  /// \throws InputError where CAGEPROOF_PROGRESS is no number of seconds
  Progress();

  /// \param stage what is being done \param done how much of `all` of it
  void operator()(const std::string& stage, std::size_t done, std::size_t all);
  /// What is done now, of an amount that is not known: each time on a terminal, elsewhere as often as lines may come.
  void operator()(const std::string& event);
  void clear() const;
  /// What those at a terminal are told when it is done.
  void say(const std::string& text) const;

 private:
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;

  bool is_time_for_line(Clock::time_point now);
  std::string left(std::size_t done, std::size_t all, Clock::time_point now) const;

  bool terminal_;
  Seconds between_;  // lines, where there is no terminal
  std::mutex mutex_;
  Clock::time_point start_ = Clock::now(), last_ = start_;
  std::string stage_;
  std::size_t first_ = 0, percent_ = 0;
};

}  // namespace cageproof::cli
