// SPDX-License-Identifier: MIT
// Fields that are opened together: errors of several evaluations on one scale of colours, around the cage they belong
// to.
#pragma once

#include "cageproof/core/results/run_result.h"

#include <string>
#include <vector>

namespace cageproof::reports {

/// Errors of several evaluations around a cage or element, and maybe on a mesh.
struct FieldScene {
  std::string title;
  std::string explanation;            ///< a sentence: what is compared with what
  std::vector<std::string> compared;  ///< arrays of image and mesh, one per evaluation, "gauss-8: relative error"
  ImageField image;
  MeshField cage;  ///< vertices and faces, without arrays
  MeshField mesh;  ///< without vertices: there is none
};

/// The name of a compared array in a picture: the part before the colon.
inline std::string short_name(const std::string& array) { return array.substr(0, array.find(": ")); }

/// The decades that all compared fields are shown between: from 1e-17 to one, at which no digit is right.
inline constexpr int kSceneLow = -17, kSceneHigh = 0;

}  // namespace cageproof::reports
