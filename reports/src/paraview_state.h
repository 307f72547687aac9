// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/reports/field_scene.h"

namespace cageproof::reports {

/// Files of a scene that its state refers to, by name without folder.
struct SceneFiles {
  std::string image, cage, mesh;  ///< mesh: empty for none
};

/// A state of ParaView (5.11 and later): one view per evaluation, side by side, with three slices of the volume, the
/// cage's edges, and the mesh in grey with the measured vertices as points; one scale of colours, linked cameras. Names
/// of files are relative: ParaView finds them from the folder that they lie in.
std::string paraview_state(const FieldScene& scene, const SceneFiles& files);

}  // namespace cageproof::reports
