// SPDX-License-Identifier: MIT
// Where a limit must exist: known of a sample before anything is evaluated.
#pragma once

#include "cageproof/validation/sample.h"

#include <array>

namespace cageproof::validation {

/// Whether a sample is an input of the formula. Doubles rounded to float may not be: they may be infinite, leave an
/// element no length or area, or make a quad invalid (core's invalid_because: corners that coincide, a bow-tie).
bool is_input(const Formula& formula, const Sample& sample);

/// By derivative order, whether formula and derivatives must have a limit at a sample: off the element all of them;
/// within it all (from inside), but of formulas that diverge there none; on its border those of an order below the
/// formula's degree. There a kernel's integral behaves like r^degree, times a logarithm at most, so that lower
/// derivatives vanish with the distance to it and higher ones may diverge or depend on the direction. None where the
/// sample is not an input.
std::array<bool, 3> limits_that_must_exist(const Formula& formula, const Sample& sample);

}  // namespace cageproof::validation
