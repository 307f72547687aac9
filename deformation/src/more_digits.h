// SPDX-License-Identifier: MIT
// Cages whose systems double has too few digits for.
#pragma once

#include "cageproof/deformation/deformer.h"

namespace cageproof::deformation {

/// The method prepared in double, or, where the cage is so thin that derivatives of layers at samples (in the plane
/// what is solved from values, too) lose more than images may, in 50 digits, from which poses are rounded to double:
/// the prepared report has the figure "digits of systems" then, and poses warn where their vertices' own roundings move
/// images by more than 1e-12 of the posed cage's size. Where 50 digits would take too long it is in double, and a
/// warning says so.
std::shared_ptr<const Deformer<double>> prepared_in_digits_enough(const DeformMethod& method, const Cage& cage,
                                                                  const DeformOptions& options);

/// Whether systems of the elements can be solved in 50 digits in half a minute. \param level how often elements are
/// split into samples
bool can_have_50_digits(const CageElements& elements, int level);

/// Whether layers at samples, or their derivatives where a construction takes them, lose so much on the elements that
/// systems made of them are to be solved in 50 digits, and can be.
bool wants_50_digits(const CageElements& elements, int level, bool takes_derivatives);

}  // namespace cageproof::deformation
