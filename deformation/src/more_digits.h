// SPDX-License-Identifier: MIT
// Cages whose systems double has too few digits for.
#pragma once

#include "cageproof/deformation/deformer.h"

namespace cageproof::deformation {

/// The method prepared in double, or, where the cage has an element so thin that derivatives of layers at samples lose
/// more than images may, in 50 digits, from which poses are rounded to double: the prepared report has the figure
/// "digits of systems" then. Where these would take too long it is in double, and a warning says so.
std::shared_ptr<const Deformer<double>> prepared_in_digits_enough(const DeformMethod& method, const Cage& cage,
                                                                  const DeformOptions& options);

}  // namespace cageproof::deformation
