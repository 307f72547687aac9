// SPDX-License-Identifier: MIT
#include "cageproof/core/catalogue/name_pattern.h"

#include "cageproof/core/catalogue/unknown_name.h"

#include <fmt/format.h>

#include <fnmatch.h>

#include <algorithm>

namespace cageproof {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// Calls with each part between commas until it says true; whether it did.
template <class Found>
bool any_part(std::string_view pattern, Found found) {
  for (;;) {
    const auto comma = pattern.find(',');
    if (found(trimmed(pattern.substr(0, comma)))) return true;
    if (comma == std::string_view::npos) return false;
    pattern.remove_prefix(comma + 1);
  }
}

bool matches_one(std::string_view glob, std::string_view text) {
  return fnmatch(std::string(glob).c_str(), std::string(text).c_str(), 0) == 0;
}

}  // namespace

bool matches(std::string_view pattern, std::string_view text) {
  return any_part(pattern, [&](std::string_view part) { return matches_one(part, text); });
}

std::vector<std::string> names_in(std::string_view pattern) {
  std::vector<std::string> names;
  any_part(pattern, [&](std::string_view part) {
    if (part.empty())
      throw InputError(fmt::format(
          "'{}' is no list of names: write names or globs with commas between, such as near-*,far", pattern));
    names.emplace_back(part);
    return false;
  });
  return names;
}

bool is_glob(std::string_view name) { return name.find_first_of("*?[") != std::string_view::npos; }

void require_known(std::string_view what, std::string_view pattern, const std::vector<std::string_view>& known) {
  for (const std::string& name : names_in(pattern)) {
    const bool found = std::ranges::any_of(known, [&](std::string_view one) { return matches_one(name, one); });
    if (!found) throw unknown_name(what, name, known);
  }
}

}  // namespace cageproof
