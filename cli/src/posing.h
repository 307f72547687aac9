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

/// A map a posed cage: a mesh, text, or the name of an embedded cage.
/// \throws InputError naming the file of a pose that the method does not take
Posing posed_by_cages(const deformation::DeformMethod& method, const Cage& cage,
                      const deformation::DeformOptions& options, const std::vector<std::string>& files);

/// One map, by constraints. \throws InputError naming the file
Posing posed_by_constraints(const deformation::ConstraintMethod& method, const Cage& cage,
                            const deformation::DeformOptions& options, const std::string& file,
                            const deformation::StepWatcher& watch);

}  // namespace cageproof::cli
