// SPDX-License-Identifier: MIT
#include "numbered_name.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <optional>

namespace cageproof::cli {
namespace {

// A place for a number.
struct Mark {
  std::size_t length;  // of its text
  int digits;          // at least so many
};

// At the begin of the text.
std::optional<Mark> mark_of(std::string_view text) {
  if (text.starts_with("{n}")) return Mark{3, 1};
  if (text.size() < 7 || !text.starts_with("{n:0") || text.substr(5, 2) != "d}") return std::nullopt;
  if (text[4] < '1' || text[4] > '9') return std::nullopt;
  return Mark{7, text[4] - '0'};
}

}  // namespace

std::string numbered(const std::string& name, std::size_t number) {
  std::string found;
  for (std::size_t at = 0; at < name.size();) {
    if (const auto mark = mark_of(std::string_view(name).substr(at))) {
      found += fmt::format("{:0{}}", number, mark->digits);
      at += mark->length;
    } else {
      found += name[at++];
    }
  }
  return found;
}

bool has_mark(const std::string& name) {
  for (std::size_t at = 0; at < name.size(); ++at)
    if (mark_of(std::string_view(name).substr(at))) return true;
  return false;
}

void require_marks(const std::string& option, const std::string& name) {
  for (auto at = name.find("{n:"); at != std::string::npos; at = name.find("{n:", at + 1))
    if (!mark_of(std::string_view(name).substr(at)))
      throw InputError(fmt::format("{} {}: write {{n}} for the map's number, or {{n:03d}} for three digits, of 1 to 9",
                                   option, name));
}

}  // namespace cageproof::cli
