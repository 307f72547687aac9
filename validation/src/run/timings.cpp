// SPDX-License-Identifier: MIT
#include "run/timings.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <functional>

namespace cageproof::validation {

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Timings::Timings(std::filesystem::path path) : path_(std::move(path)) {
  if (path_.empty()) return;
  file_.open(path_);
  require(file_.is_open());
}

void Timings::require(bool written) const {
  if (!written)
    throw InputError(
        fmt::format("{}: cannot be written; name a file in a folder that you may write to", path_.string()));
}

void Timings::add(std::string measurement, int block, double seconds) {
  if (path_.empty()) return;
  const std::scoped_lock lock(mutex_);
  units_.push_back({std::move(measurement), block, seconds});
}

void Timings::write() {
  if (path_.empty()) return;
  std::ranges::sort(units_, std::greater{}, &UnitTime::seconds);
  file_ << "seconds,measurement,block\n";
  for (const UnitTime& unit : units_)
    file_ << fmt::format("{:.4f},\"{}\",{}\n", unit.seconds, unit.measurement, unit.block);
  require(static_cast<bool>(file_.flush()));
}

}  // namespace cageproof::validation
