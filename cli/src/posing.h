// SPDX-License-Identifier: MIT
// Maps of space that users describe, either by posed cages or by constraints.
#pragma once

#include "cageproof/core/cage/merged_vertices.h"
#include "cageproof/deformation/constrained.h"
#include "cageproof/deformation/deformer.h"

#include <optional>

namespace cageproof::cli {

/// A map, and the posed cage and parameters that define it.
struct DescribedMap {
  std::unique_ptr<const deformation::Posed<double>> map;
  std::string file;                         ///< that describes it
  std::vector<Vec3<double>> vertices;       ///< of the posed cage; empty where there is none
  std::vector<double> parameters;           ///< of the method
  deformation::DeformationReport prepared;  ///< for its parameters
};

/// Maps that share coordinates.
struct Posing {
  std::shared_ptr<const void> owner;  ///< of the coordinates
  const CageCoordinates* coordinates = nullptr;
  int max_order = 0;
  std::vector<DescribedMap> maps;
};

/// Files of a pose's data other than vertices (deformation::Pose), each for all poses: text with one line per element
/// or vertex, and as many numbers per line as the space has dimensions. Empty names for none.
struct DataFiles {
  std::string normal_derivatives, laplacians, laplacian_derivatives;
};

/// Posed cages, by file.
struct PosedFiles {
  const std::vector<std::string>& names;
  const std::optional<Merging>& merging;  ///< of the rest cage's file, whose poses are merged likewise
  double merge_distance;                  ///< by --merge
  bool strict;  ///< whether a posed cage whose faces are not the cage's is an error; else a warning on standard error
};

/// A map for each posed cage (a mesh, text, or the name of an embedded cage) with each set of parameters; all of one
/// posed cage come before those of the next.
/// \param options of all maps, except parameters; varied names the parameters in which the sets differ
/// \param parameters sets of them, at least one
/// \throws InputError naming the file of a pose that the method does not take, or the option that it does not, and for
/// sets that have no coordinates in common
Posing posed_by_cages(const deformation::DeformMethod& method, const Cage& cage, deformation::DeformOptions options,
                      const std::vector<std::vector<double>>& parameters, const PosedFiles& files,
                      const DataFiles& data);

/// One map, by constraints. \throws InputError naming the file
Posing posed_by_constraints(const deformation::ConstraintMethod& method, const Cage& cage,
                            const deformation::DeformOptions& options, const std::string& file,
                            const deformation::StepWatcher& watch);

}  // namespace cageproof::cli
