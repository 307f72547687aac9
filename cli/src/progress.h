// SPDX-License-Identifier: MIT
// Progress of a command, and remarks, on standard error for users who wait. --quiet switches both off.
#pragma once

#include "command_line.h"

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <thread>

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
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// \param stage what is being done \param done how much of `all` of it
  void operator()(const std::string& stage, std::size_t done, std::size_t all);
  /// Shows the present event, of unknown amount: always on a terminal, elsewhere as often as lines may come.
  void operator()(const std::string& event);
  /// Says what the calling thread does from now on; empty when it has ended that. Where there is no terminal, and no
  /// other line comes for the time between lines, a line names what has taken longest.
  void doing(const std::string& what);
  void clear() const;
  /// Says something at the end, only on a terminal.
  void say(const std::string& text) const;

 private:
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;

  struct Doing {
    std::string what;
    Clock::time_point since;
  };

  void watch();
  std::string state(Clock::time_point now) const;
  bool is_time_for_line(Clock::time_point now);
  std::string left(std::size_t done, std::size_t all, Clock::time_point now) const;

  bool terminal_;
  Seconds between_;  // lines, where there is no terminal
  std::mutex mutex_;
  Clock::time_point start_ = Clock::now(), last_ = start_;
  std::string stage_;
  std::size_t first_ = 0, percent_ = 0, done_ = 0, all_ = 0;
  std::map<std::thread::id, Doing> doing_;
  bool ended_ = false;
  std::condition_variable changed_;
  std::thread watcher_;
};

}  // namespace cageproof::cli
