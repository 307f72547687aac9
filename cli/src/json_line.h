// SPDX-License-Identifier: MIT
// Lines of `eval`'s input, with numbers kept as text so that no scalar loses digits, and what answers a bad one.
#pragma once

#include "cageproof/core/catalogue/evaluation.h"

#include <functional>
#include <optional>
#include <string>

namespace cageproof::cli {

/// An element, a point and parameters, each number as it was written.
struct QueryText {
  std::vector<std::array<std::string, 3>> corners;
  std::array<std::string, 3> point;
  std::vector<std::string> parameters;  ///< in the order of Formula::parameters, presets filled in
};

/// Members of a line that stand in place of options; empty where they are missing.
struct LineOptions {
  std::string formula, scalar;
  std::optional<int> order;
};

/// Reads {"element":[[x,y,z],...],"point":[x,y,z],"parameters":{...}}; numbers may be JSON numbers or decimal or
/// hexadecimal strings. Points of 2D elements have two numbers. \throws InputError with the reason, without the line's
/// number
QueryText parse_query(const std::string& line, const Formula& formula);

/// The same of a line that may also have the members "formula", "order" and "scalar".
/// \param formula_for called with these before the input is read; the formula stays \throws InputError as formula_for
QueryText parse_query(const std::string& line, const std::function<const Formula&(const LineOptions&)>& formula_for);

/// Whether a line is {"describe":true}, which asks a program for its formulas.
bool asks_for_description(const std::string& line);

/// The same of an element and a point that are given as options.
/// \throws InputError naming the option that is no JSON, or as parse_query
QueryText parse_members(const std::string& element, const std::string& point, const Formula& formula);

/// {"error":message,"line":line}; bytes that are not UTF-8 are replaced. \param line counted from 1
std::string error_line(const std::string& message, std::size_t line);

}  // namespace cageproof::cli
