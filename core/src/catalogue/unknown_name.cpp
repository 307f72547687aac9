// SPDX-License-Identifier: MIT
#include "cageproof/core/catalogue/unknown_name.h"

#include "cageproof/core/catalogue/field_words.h"
#include "cageproof/core/catalogue/name_pattern.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <string>

namespace cageproof {
namespace {

// More of them no one reads in an error.
constexpr std::size_t few = 12;

bool same_letter(char a, char b) {
  const auto plain = [](char c) { return c == '_' ? '-' : std::tolower(static_cast<unsigned char>(c)); };
  return plain(a) == plain(b);
}

// Letters to insert, leave out, change, or exchange with the next one (Damerau and Levenshtein).
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + !same_letter(a[i - 1], b[j - 1])});
      if (i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) && same_letter(a[i - 2], b[j - 1]))
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    std::swap(before, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

std::string_view nearest(std::string_view name, const std::vector<std::string_view>& known, auto part) {
  std::string_view best;
  // A third of the letters: with more, any word would be near any other.
  std::size_t least = std::max<std::size_t>(1, name.size() / 3) + 1;
  for (const std::string_view one : known)
    if (const std::size_t off = distance(name, part(one)); off < least && off < part(one).size()) {
      least = off;
      best = one;
    }
  return best;
}

}  // namespace

std::string_view nearest_name(std::string_view name, const std::vector<std::string_view>& known) {
  const auto whole = nearest(name, known, [](std::string_view one) { return one; });
  if (!whole.empty()) return whole;
  return nearest(name, known, [](std::string_view one) { return one.substr(one.rfind('.') + 1); });
}

InputError unknown_single_name(std::string_view what, std::string_view name,
                               const std::vector<std::string_view>& known) {
  const bool list = name.find(',') != std::string_view::npos;
  if (!is_glob(name) && !list) return unknown_name(what, name, known);
  return InputError(
      fmt::format("unknown {} '{}': one name is asked for here, no {}", what, name, list ? "list" : "glob"));
}

namespace {

std::map<std::string, std::string, std::less<>>& ranges() {
  static std::map<std::string, std::string, std::less<>> stated;
  return stated;
}

// The letters before a pattern's placeholder, and after it: "gauss-" of "gauss-<N>", "-unguarded" of
// "riemann-<n>-unguarded".
std::string_view stem_of(std::string_view pattern) { return pattern.substr(0, pattern.find('<')); }
std::string_view suffix_of(std::string_view pattern) {
  return pattern.substr(std::min(pattern.find('>'), pattern.size() - 1) + 1);
}

}  // namespace

std::string_view family_of_number(std::string_view name) {
  std::string_view found;
  for (const auto& [pattern, range] : ranges()) {
    const std::string_view stem = stem_of(pattern), suffix = suffix_of(pattern);
    if (stem.size() == pattern.size() || !name.starts_with(stem) || !name.ends_with(suffix)) continue;
    if (name.size() < stem.size() + suffix.size() || stem.size() <= stem_of(found).size()) continue;
    const std::string_view number = name.substr(stem.size(), name.size() - stem.size() - suffix.size());
    if (number.find_first_not_of("0123456789+-.eE") == std::string_view::npos) found = pattern;
  }
  return found;
}

InputError unknown_name(std::string_view what, std::string_view name, const std::vector<std::string_view>& known) {
  std::string text =
      is_glob(name) ? fmt::format("no {} matches '{}'", what, name) : fmt::format("unknown {} '{}'", what, name);
  // Members of a family differ only in their numbers, so none is a better guess than another.
  if (const std::string_view family = family_of_number(name); !family.empty()) {
    std::vector<std::string_view> same;
    for (const std::string_view one : known)
      if (family_of_number(one) == family && std::ranges::find(same, one) == same.end()) same.push_back(one);
    if (!same.empty())
      return InputError(fmt::format("{}: of {}, {}, verification runs {}", text, family, range_of_pattern(family),
                                    fmt::join(same, ", ")));
  }
  // The field's own word says more than a name with almost the same letters.
  std::string meant = called_here(what, name, known);
  if (const std::string_view near = nearest_name(name, known); meant.empty() && !near.empty())
    meant = fmt::format("; did you mean '{}'?", near);
  text += meant;
  if (known.empty() || known.size() > few) text += meant.empty() ? "; see `cageproof list`" : " (see `cageproof list`)";
  else text += fmt::format(fmt::runtime(meant.empty() ? "; known: {}" : " (known: {})"), fmt::join(known, ", "));
  return InputError(text);
}

void state_range(std::string_view pattern, std::string_view range) {
  if (!range.empty()) ranges().insert_or_assign(std::string(pattern), std::string(range));
}

std::string_view range_of_pattern(std::string_view pattern) {
  const auto found = ranges().find(pattern);
  return found == ranges().end() ? std::string_view() : found->second;
}

}  // namespace cageproof
