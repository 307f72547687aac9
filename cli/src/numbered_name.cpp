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

// The name with a text in every place.
template <class F>
std::string filled(const std::string& name, const F& text_of) {
  std::string found;
  for (std::size_t at = 0; at < name.size();) {
    if (const auto mark = mark_of(std::string_view(name).substr(at))) {
      found += text_of(*mark);
      at += mark->length;
    } else {
      found += name[at++];
    }
  }
  return found;
}

}  // namespace

std::string numbered(const std::string& name, std::size_t number) {
  return filled(name, [number](const Mark& mark) { return fmt::format("{:0{}}", number, mark.digits); });
}

std::string without_marks(const std::string& name) {
  return filled(name, [](const Mark&) { return std::string(); });
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
