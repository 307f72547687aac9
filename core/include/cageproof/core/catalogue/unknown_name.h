// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/core/input_error.h"

#include <string>
#include <string_view>
#include <vector>

namespace cageproof {

/// The one of `known` that somebody who wrote `name` may have meant: a few letters off, or the same behind its dot
/// ("solid_angle": "triangle.solid_angle"). Empty where none is near.
std::string_view nearest_name(std::string_view name, const std::vector<std::string_view>& known);

/// The error to throw for an unknown name: "unknown check 'x'; see `cageproof list`". It proposes a name that may have
/// been meant, "did you mean 'y'?", or names all where they are few: "unknown scalar 'x'; known: float, double".
/// \param what is named: "formula" \param known all possible names; empty: the message only refers to the catalogue
InputError unknown_name(std::string_view what, std::string_view name, const std::vector<std::string_view>& known = {});

/// The error for an unknown name where exactly one name is asked for, no glob or list. \param what, known as above
InputError unknown_single_name(std::string_view what, std::string_view name,
                               const std::vector<std::string_view>& known);

/// All names that a formula's evaluations have: the members that verification runs, patterns of families, aliases; each
/// once.
std::vector<std::string_view> evaluation_names(std::string_view formula);

/// The end of a message where a formula has no evaluation of that name: the numbers that rules of such a name take, or
/// the name that may have been meant.
std::string why_no_evaluation(std::string_view formula, std::string_view name);

/// The end of that message for any subject with evaluations. \param subject its name in messages \param formulas whose
/// evaluations it has \param more names of evaluations that it has in addition
std::string why_no_evaluation(std::string_view subject, const std::vector<std::string_view>& formulas,
                              std::string_view name, const std::vector<std::string_view>& more);

/// The pattern with a stated range that a name with a number belongs to, whatever the number: "gauss-999" to
/// "gauss-<N>". Empty where there is none.
std::string_view family_of_number(std::string_view name);

/// States what stands for the placeholder in a pattern of evaluations' names: "gauss-<N>", "N from 1 to 256".
void state_range(std::string_view pattern, std::string_view range);
/// The range that was stated; empty if none was.
std::string_view range_of_pattern(std::string_view pattern);

}  // namespace cageproof
