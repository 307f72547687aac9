// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/reports/figure_sheet.h"

#include <Eigen/Geometry>

namespace cageproof::reports {

/// An orthonormal frame of a view.
struct ViewAxes {
  Vec3<double> right, up, towards;
};
ViewAxes axes_of(const FigureView& view);

/// Pixels above each panel for its title and note.
inline constexpr double title_height = 38;

}  // namespace cageproof::reports
