// SPDX-License-Identifier: MIT
#include "progress.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/numbers/scalar_text.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace cageproof::cli {
namespace {

bool& quiet() {
  static bool whether = false;
  return whether;
}

// Not the formatting library's, which throws where standard error takes no more, here in any thread.
void write(const std::string& text) { std::fputs(text.c_str(), stderr); }

double seconds_between_lines() {
  const char* text = std::getenv("CAGEPROOF_PROGRESS");
  if (text == nullptr || *text == '\0') return 60;
  const auto seconds = parse_scalar<double>(text);
  if (!seconds || !(*seconds >= 0))
    throw InputError(fmt::format("CAGEPROOF_PROGRESS: '{}' is no number of seconds, 0 or more", text));
  return *seconds;
}

// Time that has passed.
std::string elapsed_text(double seconds) {
  return seconds < 120 ? fmt::format("{:.0f} s", std::floor(seconds))
                       : fmt::format("{:.0f} min", std::floor(seconds / 60));
}

// Time that is left.
std::string duration_text(double seconds) {
  if (seconds < 60) return fmt::format("{:.0f} s", std::ceil(seconds));
  if (seconds < 5400) return fmt::format("{:.0f} min", std::ceil(seconds / 60));
  return fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

void add_quiet(Command command) {
  command.flag("--quiet", quiet(), "neither progress nor remarks on standard error; warnings and errors stay");
}

void remark(const std::string& text) {
  if (!quiet()) write(text + '\n');
}

Progress::Progress() : terminal_(isatty(STDERR_FILENO) != 0), between_(seconds_between_lines()) {}

Progress::~Progress() {
  {
    const std::scoped_lock lock(mutex_);
    ended_ = true;
  }
  changed_.notify_all();
  if (watcher_.joinable()) watcher_.join();
}

// Units of work may take minutes, and so may what is prepared before the first: lines come by the clock.
void Progress::watch() {
  std::unique_lock lock(mutex_);
  while (!ended_) {
    // The time is limited because clocks count only so far.
    const auto due = last_ + std::chrono::duration_cast<Clock::duration>(std::min(between_, Seconds(1e8)));
    if (Clock::now() < due) {
      changed_.wait_until(lock, due);
      continue;
    }
    last_ = Clock::now();
    if (const std::string text = state(last_); !text.empty()) write(text + '\n');
  }
}

// Progress of the stage, and the piece of work in progress that has taken longest.
std::string Progress::state(Clock::time_point now) const {
  std::string text = stage_.empty() ? "" : fmt::format("{} {} %{}", stage_, percent_, left(done_, all_, now));
  const auto longest = std::ranges::min_element(doing_, {}, [](const auto& one) { return one.second.since; });
  if (longest == doing_.end()) return text;
  const auto& [what, since] = longest->second;
  return fmt::format("{}{}{} for {}", text, text.empty() ? "" : ": ", what, elapsed_text(Seconds(now - since).count()));
}

void Progress::doing(const std::string& what) {
  // Lines as often as something ends need no clock.
  if (quiet() || terminal_ || between_.count() == 0) return;
  const std::scoped_lock lock(mutex_);
  if (what.empty()) doing_.erase(std::this_thread::get_id());
  else doing_[std::this_thread::get_id()] = {what, Clock::now()};
  if (!watcher_.joinable()) watcher_ = std::thread([this] { watch(); });
}

bool Progress::is_time_for_line(Clock::time_point now) {
  if (now - last_ < between_) return false;
  last_ = now;
  return true;
}

// The estimate uses only work since the stage began; earlier work says nothing about it.
std::string Progress::left(std::size_t done, std::size_t all, Clock::time_point now) const {
  const double passed = Seconds(now - start_).count();
  if (done <= first_ || done >= all || passed < 1) return "";
  const double each = passed / static_cast<double>(done - first_);
  return fmt::format(", about {} left", duration_text(each * static_cast<double>(all - done)));
}

void Progress::operator()(const std::string& stage, std::size_t done, std::size_t all) {
  if (quiet()) return;
  const std::scoped_lock lock(mutex_);
  const auto now = Clock::now();
  const std::size_t percent = all == 0 ? 100 : 100 * done / all;
  const bool begins = stage != stage_;
  if (begins) {
    stage_ = stage;
    first_ = done;
    start_ = now;
  }
  done_ = done;
  all_ = all;
  if (!terminal_) {
    percent_ = percent;
    if (is_time_for_line(now)) write(fmt::format("{} {} %{}\n", stage, percent, left(done, all, now)));
    return;
  }
  if (!begins && percent == percent_ && now - last_ < std::chrono::seconds(1)) return;
  percent_ = percent;
  last_ = now;
  write(fmt::format("\r\033[K{} {} %{}", stage, percent, left(done, all, now)));
}

void Progress::operator()(const std::string& event) {
  if (quiet()) return;
  const std::scoped_lock lock(mutex_);
  if (terminal_ || is_time_for_line(Clock::now())) write(event + '\n');
}

void Progress::clear() const {
  if (terminal_ && !quiet()) write("\r\033[K");
}

void Progress::say(const std::string& text) const {
  if (terminal_ && !quiet()) write(text + '\n');
}

}  // namespace cageproof::cli
