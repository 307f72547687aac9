// SPDX-License-Identifier: MIT
// How far a command is, for those who wait at a terminal.
#pragma once

#include <fmt/format.h>

#include <unistd.h>

#include <cstddef>
#include <cstdio>
#include <mutex>
#include <string>

namespace cageproof::cli {

/// One line on a terminal's standard error, rewritten; nothing elsewhere. From any thread.
class Progress {
 public:
  /// \param stage what is being done \param done how much of `all` of it
  void operator()(const std::string& stage, std::size_t done, std::size_t all) {
    if (!terminal_) return;
    const std::scoped_lock lock(mutex_);
    const std::size_t percent = all == 0 ? 100 : 100 * done / all;
    if (stage == stage_ && percent == percent_) return;
    stage_ = stage;
    percent_ = percent;
    fmt::print(stderr, "\r\033[K{} {} %", stage, percent);
  }
  void clear() const {
    if (terminal_) fmt::print(stderr, "\r\033[K");
  }
  void say(const std::string& text) const {
    if (terminal_) fmt::print(stderr, "{}\n", text);
  }

 private:
  bool terminal_ = isatty(STDERR_FILENO) != 0;
  std::mutex mutex_;
  std::string stage_;
  std::size_t percent_ = 0;
};

}  // namespace cageproof::cli
