// SPDX-License-Identifier: MIT
#include "cageproof/reports/shown_names.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace cageproof::reports {
namespace {

// Empty for a folder, "folder/".
std::string last_part(const std::string& name) { return std::filesystem::path(name).filename().string(); }

}  // namespace

ShownNames::ShownNames(const std::vector<std::string>& names) {
  const std::set<std::string> distinct_names(names.begin(), names.end());
  for (const std::string& name : distinct_names) {
    const std::string last = last_part(name);
    if (last.empty() || last == name) continue;
    const bool alone = std::ranges::count(distinct_names, last, last_part) == 1;
    if (alone) shown_.emplace_back(name, last);
  }
  std::ranges::stable_sort(shown_, std::ranges::greater(), [](const auto& pair) { return pair.first.size(); });
}

std::string ShownNames::of(const std::string& name) const {
  const auto found = std::ranges::find(shown_, name, &std::pair<std::string, std::string>::first);
  return found == shown_.end() ? name : found->second;
}

std::string ShownNames::in(std::string_view text) const {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const auto found =
        std::ranges::find_if(shown_, [&](const auto& pair) { return text.substr(i).starts_with(pair.first); });
    if (found == shown_.end()) {
      result += text[i++];
    } else {
      result += found->second;
      i += found->first.size();
    }
  }
  return result;
}

}  // namespace cageproof::reports
