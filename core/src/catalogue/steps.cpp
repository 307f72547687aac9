// SPDX-License-Identifier: MIT
#include "cageproof/core/catalogue/steps.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cageproof {
namespace {

struct Stated {
  std::string formula, pattern;
  RegisterSteps::Make make;
};

std::vector<Stated>& all_stated() {
  static std::vector<Stated> all;
  return all;
}

}  // namespace

StepFunctions steps_of(std::string_view formula, std::string_view evaluation) {
  std::vector<std::string> known;
  for (const Stated& stated : all_stated()) {
    if (stated.formula == formula)
      if (auto functions = stated.make(evaluation)) return *std::move(functions);
    known.push_back(fmt::format("{} of {}", stated.pattern, stated.formula));
  }
  throw InputError(
      fmt::format("{} of {} has no numbered steps; known: {}", evaluation, formula, fmt::join(known, ", ")));
}

RegisterSteps::RegisterSteps(std::string formula, std::string pattern, Make make) {
  all_stated().push_back({std::move(formula), std::move(pattern), std::move(make)});
}

}  // namespace cageproof
