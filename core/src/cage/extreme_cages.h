// SPDX-License-Identifier: MIT
// Cages with lengths far from each other.
#pragma once

#include "surface.h"

namespace cageproof {

/// A cage by its name, of a family that has a parameter.
struct ExtremeCage {
  std::string name;
  Surface (*make_of)(double parameter);
  double parameter;

  Surface make() const { return make_of(parameter); }
};

/// All of them, in report order.
const std::vector<ExtremeCage>& extreme_cages();

}  // namespace cageproof
