// SPDX-License-Identifier: MIT
// The densities L' and D' that [T24] gives biharmonic layers for posed vertices V' and normal derivatives N', from the
// printed sums of squares by their normal equations: Eq 24 for (1,3), D.1 for (1,2), Eq 63-65 for Weber's.
#pragma once

#include "cage_samples.h"

namespace cageproof::second_routes {

/// Conditions on the function on the cage.
enum class Required { ValuesAndLaplacians, ValuesAndSlopes, ValuesByLaplacians };

struct DensityMethod {
  Required required;
  int level;     ///< times that elements are split for samples
  Wide gamma_d;  ///< of ValuesAndLaplacians: the weight of values
};

/// (L'; D') as a linear map of (V'; N'): one column per vertex, then per element. \param layers of kind biharmonic
Table<Wide> densities_by_data(const CageCoordinates& layers, const DensityMethod& method);

}  // namespace cageproof::second_routes
