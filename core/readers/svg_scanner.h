// SPDX-License-Identifier: MIT
// The characters of an SVG attribute, taken number by number.
#pragma once

#include "svg_text.h"

namespace cageproof::svg {

class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_(text) {}

  /// Passes over blanks; true at the end.
  bool at_end();
  /// The next character that is no blank. \pre not at_end()
  char peek() {
    at_end();
    return rest_.front();
  }
  void skip() { rest_.remove_prefix(1); }
  /// Passes over that character, if it is next.
  bool take(char expected);
  /// The letters that are next.
  std::string_view take_word();
  /// Passes over blanks, and over one comma.
  void separate();
  /// Whether a number comes next.
  bool has_number();
  /// The number that comes next: a sign, digits, a point and an exponent, each as far as they are there, so that
  /// "1e-3.5-2" is 1e-3, .5 and -2. Exact. \throws Fault where none is, or one beyond the range of double
  Rational number();
  /// Returns the rest of the text for messages: quoted, at most 20 characters.
  std::string shown() const;

 private:
  std::size_t digits_from(std::size_t begin) const;
  std::string_view rest_;
};

}  // namespace cageproof::svg
