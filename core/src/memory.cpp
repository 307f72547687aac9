// SPDX-License-Identifier: MIT
#include "cageproof/core/memory.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>

namespace cageproof {
namespace {

// The limit of this process's container; the largest number where it has none, or none that can be read.
std::uint64_t container_limit() {
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
  for (const char* file : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"})
    // "max" is no number, and leaves it.
    if (std::uint64_t limit = 0; std::ifstream(file) >> limit && limit > 0) least = std::min(least, limit);
  return least;
}

}  // namespace

std::uint64_t usable_memory() {
  const auto pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGESIZE);
  std::uint64_t bytes = std::numeric_limits<std::uint64_t>::max();
  if (pages > 0 && page > 0) bytes = static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page);
  struct rlimit limit {};
  if (::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    bytes = std::min<std::uint64_t>(bytes, limit.rlim_cur);
  return std::min(bytes, container_limit());
}

std::string size_text(double bytes) {
  constexpr std::array units{"bytes", "KB", "MB", "GB", "TB", "PB", "EB"};
  std::size_t unit = 0;
  while (unit + 1 < units.size() && bytes >= 999.5) {
    bytes /= 1000;
    ++unit;
  }
  const int decimals = unit == 0 || bytes >= 99.95 ? 0 : bytes >= 9.995 ? 1 : 2;
  return fmt::format("{:.{}f} {}", bytes, decimals, units[unit]);
}

void require_memory(double bytes, std::string_view what, std::string_view advice) {
  const double half = static_cast<double>(usable_memory()) / 2;
  if (bytes <= half) return;
  throw InputError(fmt::format("{} takes {}, more than half of the memory, {}; {}", what, size_text(bytes),
                               size_text(half), advice));
}

}  // namespace cageproof
