// SPDX-License-Identifier: MIT
// The captions of panels of the plane.
#pragma once

#include "deformed_figure.h"

namespace cageproof::validation {

/// Findings about a panel beside its images; null where nothing asks for them.
struct PlaneFindings {
  const std::vector<Vec3<double>>* derivatives = nullptr;  ///< by x and by y, at all places of the plan's angles
  const std::vector<Vec3<double>>* compared = nullptr;     ///< images of the panel that this one is compared with
};

/// The points where a plan's changes of angles are measured.
std::vector<Vec3<double>> angle_points(const DeformedPlan& plan);

/// Adds what is measured of a map of the plane to its panel, and makes its note of it: area, how far its border misses
/// the posed cage, what is folded, changes of angles, the displacement of a part, the distance from another map.
/// \pre the panel has its images, its posed cage or none, and its area's ratio as the first of its measures
void add_plane_measures(const DeformedPlan& plan, const PanelPlan& shown, const PlaneFindings& found,
                        reports::FigurePanel& panel);

}  // namespace cageproof::validation
