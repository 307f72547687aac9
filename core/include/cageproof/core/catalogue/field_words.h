// SPDX-License-Identifier: MIT
// Words of the field that people try, and the names that the same things have here.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cageproof {

/// A word of the field, with this project's names for it, or the reason why there is none.
struct FieldWord {
  std::string_view word;  ///< in lower case, with hyphens: "mean-value"
  /// Names of kinds, methods, evaluations and commands, and of formulas without their element: "solid_angle".
  std::vector<std::string_view> here = {};
  std::string_view missing = {};  ///< where `here` is empty: what it is, and what comes near
};

/// All of them, by word.
std::span<const FieldWord> field_words();

/// The entry of a word, whatever its case, with underscores or blanks for hyphens, with "-coordinates" or "-weights"
/// behind it, or with an element before it ("triangle.winding"). Null where there is none.
const FieldWord* find_field_word(std::string_view word);

/// The addition to an error for an unknown name that is a word of the field: "; it is called 'mean_value' here", or
/// that it is something else here, or missing. Empty without an entry. \param what is asked for: "deformer"
/// \param known the names that would do; empty: all
std::string called_here(std::string_view what, std::string_view word, const std::vector<std::string_view>& known);

}  // namespace cageproof
