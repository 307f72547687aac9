// SPDX-License-Identifier: MIT
#include "svg_style.h"

#include "cage/mesh_files.h"
#include "svg_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <tuple>

namespace cageproof::svg {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\n\r\f";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

// The next place of one of the characters `any` outside of quotes and parentheses, or the end.
std::size_t find_outside(std::string_view text, std::string_view any, std::size_t from = 0) {
  char quote = 0;
  int depth = 0;
  for (std::size_t k = from; k < text.size(); ++k) {
    const char c = text[k];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '(') {
      ++depth;
    } else if (c == ')') {
      --depth;
    } else if (depth <= 0 && any.find(c) != any.npos) {
      return k;
    }
  }
  return text.size();
}

// The parts between such characters.
std::vector<std::string_view> split(std::string_view text, std::string_view at) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = find_outside(text, at, begin);
    parts.push_back(trimmed(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return parts;
}

// Without comments, and the marks of XML's that old sheets stand in.
std::string without_comments(std::string_view text) {
  std::string clean;
  while (!text.empty()) {
    const std::size_t begin = std::min(text.find("/*"), text.size());
    clean += text.substr(0, begin);
    text.remove_prefix(begin);
    const std::size_t end = text.find("*/", std::min<std::size_t>(2, text.size()));
    text.remove_prefix(end == text.npos ? text.size() : end + 2);
    clean += ' ';
  }
  std::string unmarked;
  for (std::string_view rest = clean; !rest.empty();) {
    const bool opens = rest.starts_with("<!--"), closes = rest.starts_with("-->");
    if (!opens && !closes) unmarked += rest.front();
    rest.remove_prefix(opens ? 4 : closes ? 3 : 1);
  }
  return unmarked;
}

bool says_what_is_drawn(const Declaration& d) { return d.property == "display" || d.property == "visibility"; }

// The declarations of `display` and `visibility`, without those that a later one of the same weight replaces.
std::vector<Declaration> last_of_drawn(const std::vector<Declaration>& all) {
  std::vector<Declaration> last;
  for (const Declaration& d : all) {
    if (!says_what_is_drawn(d)) continue;
    std::erase_if(last, [&](const Declaration& e) { return e.property == d.property && e.important == d.important; });
    last.push_back(d);
  }
  return last;
}

// The brace that closes the one at `open`, or the end.
std::size_t closing(std::string_view text, std::size_t open) {
  int depth = 0;
  for (std::size_t k = open; k < text.size(); k = find_outside(text, "{}", k + 1)) {
    depth += text[k] == '{' ? 1 : -1;
    if (depth == 0) return k;
  }
  return text.size();
}

}  // namespace

std::vector<Declaration> parse_declarations(std::string_view text) {
  const std::string clean = without_comments(text);
  std::vector<Declaration> found;
  for (const std::string_view part : split(clean, ";{}")) {
    const std::size_t colon = part.find(':');
    if (colon == part.npos) continue;
    Declaration d{in_lower_case(trimmed(part.substr(0, colon))), in_lower_case(trimmed(part.substr(colon + 1)))};
    if (const std::size_t mark = d.value.find('!'); mark != d.value.npos) {
      d.important = true;
      d.value = trimmed(std::string_view(d.value).substr(0, mark));
    }
    found.push_back(std::move(d));
  }
  return found;
}

std::optional<StyleSheets::Rule> StyleSheets::parse_selector(std::string_view text) {
  Rule rule;
  const auto is_part = [](char c) {
    const auto u = static_cast<unsigned char>(c);
    return std::isalnum(u) != 0 || c == '-' || c == '_' || u >= 0x80;
  };
  for (std::size_t begin = 0; begin < text.size();) {
    const char kind = text[begin];
    const bool marked = kind == '.' || kind == '#';
    if (kind == '*' && begin == 0) {
      ++begin;
      continue;
    }
    const std::size_t from = begin + (marked ? 1 : 0);
    std::size_t end = from;
    while (end < text.size() && is_part(text[end])) ++end;
    if (end == from || (!marked && begin > 0)) return std::nullopt;
    const std::string word(text.substr(from, end - from));
    if (!marked) rule.name = word;
    else (kind == '.' ? rule.classes : rule.ids).push_back(word);
    begin = end;
  }
  return text.empty() ? std::nullopt : std::optional(rule);
}

bool StyleSheets::matches(const Rule& rule, const Selected& element, const std::set<std::string_view>& classes) {
  const auto has_class = [&](const std::string& name) { return classes.contains(name); };
  return (rule.name.empty() || rule.name == element.name) && std::ranges::all_of(rule.classes, has_class) &&
         std::ranges::all_of(rule.ids, [&](const std::string& id) { return id == element.id; });
}

void StyleSheets::add(std::string_view text, const std::vector<std::string>& refused) {
  const std::string sheet = without_comments(text);
  std::string_view rest = trimmed(sheet);
  while (!rest.empty()) {
    const std::size_t open = find_outside(rest, "{;");
    const std::string_view head = trimmed(rest.substr(0, open));
    if (open == rest.size() || rest[open] == ';') {  // @import, @charset
      rest = trimmed(rest.substr(std::min(open + 1, rest.size())));
      continue;
    }
    const std::size_t close = closing(rest, open);
    const auto declarations = parse_declarations(rest.substr(open + 1, close - open - 1));
    rest = trimmed(rest.substr(std::min(close + 1, rest.size())));
    for (const Declaration& d : declarations)
      if (std::ranges::find(refused, d.property) != refused.end())
        throw Fault{fmt::format("a style with {} is not read; write it as an attribute", d.property)};
    const std::vector<Declaration> drawn = last_of_drawn(declarations);
    if (drawn.empty()) continue;
    for (const std::string_view selector : split(head, ",")) {
      std::optional<Rule> rule = parse_selector(selector);
      if (!rule)
        throw Fault{
            fmt::format("{} for {}: of selectors, element, .class, #id and lists of them are read; write {} as "
                        "an attribute of the elements",
                        drawn.front().property, mesh_files::shown(selector), drawn.front().property)};
      // Each is compared with each element.
      constexpr std::size_t most = 1000;
      if (rules_.size() == most)
        throw Fault{fmt::format("more than {} selectors with {}; write it as an attribute of the elements", most,
                                drawn.front().property)};
      rule->declarations = drawn;
      rules_.push_back(std::move(*rule));
    }
  }
}

std::optional<std::string> StyleSheets::value_of(const std::string& property, const Selected& element,
                                                 std::string_view style,
                                                 const std::optional<std::string>& attribute) const {
  using Weight = std::tuple<bool, bool, std::size_t, std::size_t, bool>;  // the later one of equals wins
  std::optional<std::string> value;
  Weight heaviest{};
  if (attribute) value = in_lower_case(trimmed(*attribute));
  const auto take = [&](const Declaration& d, const Weight& weight) {
    if (d.property != property || weight < heaviest) return;
    value = d.value;
    heaviest = weight;
  };
  std::set<std::string_view> classes;
  if (!rules_.empty())
    for (const std::string_view name : split(element.classes, " \t\n\r\f")) classes.insert(name);
  for (const Rule& rule : rules_)
    if (matches(rule, element, classes))
      for (const Declaration& d : rule.declarations)
        take(d, {d.important, false, rule.ids.size(), rule.classes.size(), !rule.name.empty()});
  for (const Declaration& d : parse_declarations(style)) take(d, {d.important, true, 0, 0, false});
  return value;
}

}  // namespace cageproof::svg
