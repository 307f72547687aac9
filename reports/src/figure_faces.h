// SPDX-License-Identifier: MIT
// Shaded faces of a panel.
#pragma once

#include "canvas.h"
#include "figure_layout.h"

namespace cageproof::reports {

inline constexpr Rgb kLightFace{0.99, 0.90, 0.70};

/// Twice the area of a face, along its normal.
Vec3<double> area_of(const std::vector<Vec3<double>>& vertices, const std::vector<int>& face);

/// Near faces hide far ones.
void draw_faces(const FigurePanel& panel, const FigureFrame& frame, const ViewAxes& axes, Canvas& canvas);

}  // namespace cageproof::reports
