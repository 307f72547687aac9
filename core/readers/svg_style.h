// SPDX-License-Identifier: MIT
// Which elements of an SVG file are drawn: `display` and `visibility`, as attributes, style attributes and style sheets
// give them. All other properties are nobody's business here.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cageproof::svg {

/// "property: value", both in lower case; !important is kept apart.
struct Declaration {
  std::string property, value;
  bool important = false;
};

/// The declarations of a style attribute, or of what stands between a sheet's braces.
std::vector<Declaration> parse_declarations(std::string_view text);

/// An element as selectors see it.
struct Selected {
  std::string name, id, classes;
};

/// Style sheets, in the order of the document.
class StyleSheets {
 public:
  /// Adds one. Selectors are an element's name, `*`, .class, #id, these in one word, and lists of them. \throws Fault
  /// for other selectors and for rules with @, where they say what is drawn, or name one of `refused`
  void add(std::string_view text, const std::vector<std::string>& refused);

  /// Returns the property's value by the cascade: from the style attribute, else the rules, else `attribute`; or none.
  std::optional<std::string> value_of(const std::string& property, const Selected& element, std::string_view style,
                                      const std::optional<std::string>& attribute) const;

 private:
  struct Rule {
    std::string name;  // empty for any
    std::vector<std::string> ids, classes;
    std::vector<Declaration> declarations;  // at most four, of display and visibility
  };
  static std::optional<Rule> parse_selector(std::string_view text);
  static bool matches(const Rule& rule, const Selected& element, const std::set<std::string_view>& classes);

  std::vector<Rule> rules_;
};

}  // namespace cageproof::svg
