// SPDX-License-Identifier: MIT
#include "cageproof/core/coordinates/rest_derivative.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace cageproof {
namespace {

// Made when first asked for, so that derivatives may be added from any file before main.
std::list<RestDerivative>& known() {
  static std::list<RestDerivative> instance;
  return instance;
}

}  // namespace

RegisterRestDerivative::RegisterRestDerivative(RestDerivative derivative) { known().push_back(derivative); }

const RestDerivative* find_rest_derivative(const CoordinateKind& kind) {
  const auto found = std::ranges::find(known(), kind.name, &RestDerivative::kind);
  return found == known().end() ? nullptr : &*found;
}

const RestDerivative& rest_derivative_of(const CoordinateKind& kind) {
  if (const RestDerivative* found = find_rest_derivative(kind)) return *found;
  std::vector<std::string_view> names;
  for (const RestDerivative& derivative : known()) names.push_back(derivative.kind);
  std::ranges::sort(names);
  throw InputError(
      fmt::format("{}: coordinates have no derivatives by the rest cage's vertices yet; those of {} have, in space and "
                  "in the plane",
                  kind.name, fmt::join(names, ", ")));
}

}  // namespace cageproof
