// SPDX-License-Identifier: MIT
#include "points_outside.h"

#include "cageproof/reports/worst_file.h"

#include <fmt/format.h>

#include <filesystem>

namespace cageproof::reports {

std::string points_outside_line(const RunResult& result) {
  const auto outside = result.settings.find(points_outside_setting);
  if (outside == result.settings.end()) return {};
  const auto file = [&](const char* setting) {
    const auto named = result.settings.find(setting);
    return named == result.settings.end() ? std::string() : std::filesystem::path(named->second).filename().string();
  };
  return fmt::format("{} points of {} are outside {}.", outside->second, file("points"), file("cage"));
}

}  // namespace cageproof::reports
