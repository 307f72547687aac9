// SPDX-License-Identifier: MIT
// How a quad's frame is cut into cells, and how many points each needs, from the complex zeros of r^2.
#pragma once

#include "quad_caster.h"

namespace cageproof::quadrature_ref {

/// A cell, with the numbers that decide its rules.
struct PlannedCell {
  QuadCell cell;
  double half_t = 0, half_w = 0;        ///< half the cell's lengths in tau and w
  double ellipse_t = 0, ellipse_w = 0;  ///< sum of semi-axes of the largest Bernstein ellipse without a zero of r^2
};

/// Cells on which rules for `digits` digits cost least, none longer than `longest` in tau or w. Once there are `most`,
/// no cell is cut any more, and a cell may need more points than the largest rule has.
std::vector<PlannedCell> quad_cells(const PolarQuadFrame<Mp50>& frame, double digits, double longest,
                                    std::size_t most = 4000);

/// Points for `digits` digits relative to the cell's largest integrand.
/// \param step large rules have a multiple of so many points, since each rule is computed once a precision
QuadPoints points_for(const PlannedCell& cell, double digits, int step = 4);

}  // namespace cageproof::quadrature_ref
