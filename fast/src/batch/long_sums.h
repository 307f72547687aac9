// SPDX-License-Identifier: MIT
// The same sums at a single point in 200 digits, for signs that double-doubles do not decide.
#pragma once

#include "geometry.h"

#include <vector>

namespace cageproof::closed_form::batch {

/// Adds the parts of faces that one point sees from very near, each rounded once.
/// \param faces their numbers \param on the one within which the point lies, exactly: the limit from inside is taken;
/// -1 for none \param beta 1/(2 (1 - nu)) \param columns [column] of one point, `stride` numbers apart \return false,
/// without adding, where even 200 digits do not decide
bool add_in_long(const Geometry& geometry, Layers layers, int order, const std::vector<int>& faces, int on,
                 const double* point, const Mp200& beta, const Columns& layout, double* columns, int stride);

}  // namespace cageproof::closed_form::batch
