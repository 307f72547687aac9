// SPDX-License-Identifier: MIT
// Images of points as a table.
#pragma once

#include "coordinate_table.h"

#include "cageproof/deformation/deformer.h"

namespace cageproof::cli {

/// Columns `x`, `y`, `z`, then `x_dx` ..., one row per point. \param order highest derivative that the images have
CoordinateColumns image_columns(const deformation::Images<double>& images, int dimension, int order);

}  // namespace cageproof::cli
