// SPDX-License-Identifier: MIT
// Maps of space that users describe: by posed cages, or by constraints.
#pragma once

#include "deformation.h"

#include "cageproof/deformation/constrained.h"

namespace cageproof::cli {

/// Maps and what they are made from.
struct Posing {
  std::shared_ptr<const void> owner;  ///< of the coordinates
  const CageCoordinates* coordinates = nullptr;
  int max_order = 0;
  deformation::DeformationReport prepared;
  Maps maps;
  std::vector<std::string> names;                   ///< of the files that describe the maps
  std::vector<std::vector<Vec3<double>>> vertices;  ///< posed cages; empty where a map has none
};

/// What poses may have beside vertices (deformation::Pose), each for all of them: text with as many numbers a line as
/// the space has dimensions, a line an element or vertex. Empty names for none.
struct DataFiles {
  std::string normal_derivatives, laplacians, laplacian_derivatives;
};

/// A map a posed cage: a mesh, text, or the name of an embedded cage.
/// \throws InputError naming the file of a pose that the method does not take, or the option that it does not
Posing posed_by_cages(const deformation::DeformMethod& method, const Cage& cage,
                      const deformation::DeformOptions& options, const std::vector<std::string>& files,
                      const DataFiles& data);

/// One map, by constraints. \throws InputError naming the file
Posing posed_by_constraints(const deformation::ConstraintMethod& method, const Cage& cage,
                            const deformation::DeformOptions& options, const std::string& file,
                            const deformation::StepWatcher& watch);

}  // namespace cageproof::cli
