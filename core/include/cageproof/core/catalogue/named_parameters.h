// SPDX-License-Identifier: MIT
// Values of parameters from texts that users write: "nu=0.3", "nu=inf", "collocation=vertices".
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cageproof {

/// The words that messages have for the parameters' owner (a formula, kind or method) and for a parameter.
struct ParameterOwner {
  std::string_view name;
  std::string_view word = "parameter";  ///< or how users give one: "--parameter"
};

/// The parameters of a formula: numbers.
std::vector<KindParameter> parameters_of(const Formula& formula);

/// Names and the texts of their values as texts "name=value".
std::vector<std::string> parameter_texts(const std::vector<std::pair<std::string, std::string>>& given);

/// Values in the order of `known`; parameters not given take their defaults. \param given texts "name=value"
/// \throws InputError for a text of another form, a name that is unknown or given twice, and a value that is no number
/// or out of range
std::vector<double> parameter_values(const std::vector<std::string>& given, const std::vector<KindParameter>& known,
                                     const ParameterOwner& owner);

/// All combinations of values, where a text may have several, "nu=0,0.3,inf"; those of the last parameter change first.
/// \throws InputError as parameter_values, and for more than 10,000 of them
std::vector<std::vector<double>> parameter_sets(const std::vector<std::string>& given,
                                                const std::vector<KindParameter>& known, const ParameterOwner& owner);

}  // namespace cageproof
