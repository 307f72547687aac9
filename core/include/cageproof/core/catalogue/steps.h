// SPDX-License-Identifier: MIT
// Numbered equations on the way to a value: what an evaluation computes before its result, by name and equation.
#pragma once

#include "cageproof/core/catalogue/batch.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace cageproof {

/// A quantity that an evaluation computes for one point.
template <Scalar R>
struct Step {
  std::string name;       ///< the paper's, in letters: "kappa"
  std::string source;     ///< the equation that defines it: "[T18] Eq 26"
  int length = 0;         ///< its unit is this power of the unit of length
  std::vector<R> values;  ///< in the unit of the query's coordinates; not finite where it does not exist
};

/// The steps of a value at one point, in the order in which they are computed.
template <Scalar R>
using StepFunction = std::function<std::vector<Step<R>>(const Query<R>&)>;

/// A StepFunction per scalar. Each is set.
struct StepFunctions {
  std::tuple<StepFunction<float>, StepFunction<double>, StepFunction<Mp50>, StepFunction<Mp100>, StepFunction<Mp200>>
      by_scalar;

  template <Scalar R>
  StepFunction<R>& of() {
    return std::get<StepFunction<R>>(by_scalar);
  }
  template <Scalar R>
  const StepFunction<R>& of() const {
    return std::get<StepFunction<R>>(by_scalar);
  }
};

/// The steps of an evaluation. \throws InputError where it states none, naming those that do
StepFunctions steps_of(std::string_view formula, std::string_view evaluation);

/// States steps at program start. \param pattern as EvaluationFamily::pattern, for messages \param make gives the steps
/// of an evaluation of that name, or nothing when the name is not of this family
struct RegisterSteps {
  using Make = std::function<std::optional<StepFunctions>(std::string_view evaluation)>;
  RegisterSteps(std::string formula, std::string pattern, Make make);
};

}  // namespace cageproof
