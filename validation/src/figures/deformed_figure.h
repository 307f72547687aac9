// SPDX-License-Identifier: MIT
// Figures of one mesh in one cage, under several poses and methods.
#pragma once

#include "figure_shapes.h"

#include "cageproof/validation/paper_figures.h"
#include "cageproof/deformation/constrained.h"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cageproof::validation {

/// A panel: the mesh under one method and pose. Without a method it is at rest.
struct PanelPlan {
  std::string title;
  std::string file;  ///< of its data, without extension; unlike that of any other panel of its figure
  std::string method = {};
  /// Parameters that are not at their defaults: name and value, as on the command line.
  std::vector<std::pair<std::string, std::string>> parameters = {};
  std::vector<Vec3<double>> posed = {};       ///< the cage's vertices
  deformation::Constraints constraints = {};  ///< of methods that take them instead of a posed cage
  /// One for each edge, in place of the method's own; empty for those.
  std::vector<Vec3<double>> normal_derivatives = {};
  bool shows_diagonals = false;  ///< whether the cage's quads are drawn as triangles
  /// In place of the figure's; with other vertices only where constraints replace the posed cage. Null for the
  /// figure's.
  std::shared_ptr<const Cage> cage = nullptr;
  std::string evaluation = {};  ///< of the coordinates' formulas; empty for the recommended one
  /// File of the panel, of the same sheet, that this one is compared with: how far images are from its own is measured.
  std::string compared_with = {};
  /// The step of those vertices of the cage that are moved, if all are moved by one step. Then their coordinates' sum
  /// is measured, and faces where it is negative are dark.
  std::optional<Vec3<double>> step = {};
};

/// A figure: some panels.
struct SheetPlan {
  std::string name, heading, source, text;
  int columns;
  std::vector<PanelPlan> panels;
  reports::FigureView view = {};
};

/// Points of the plane where changes of angles are measured, and where these are, in words.
struct AnglePlaces {
  std::string where;
  std::vector<Vec3<double>> points;
};

/// Figures of one cage and mesh.
struct DeformedPlan {
  std::string name;
  std::shared_ptr<const Cage> cage;
  TonedMesh mesh;
  std::vector<SheetPlan> sheets;
  /// Whether cage, poses and mesh are symmetric in x, so that images should be: how far they are not is measured.
  bool is_symmetric = false;
  /// Whether the sharpest turn between neighbouring faces that a map adds is measured.
  bool measures_turns = false;
  std::vector<AnglePlaces> angles = {};  ///< of cages of the plane
  /// A part of the mesh whose displacement is measured, by its vertices, with its name; nothing where there is none.
  std::string watched = {};
  std::vector<int> watched_vertices = {};
};

/// \throws InputError for a method or parameter that does not exist
/// \throws std::invalid_argument for a panel compared with one that its sheet does not have
std::unique_ptr<const PaperFigure> deformed_figure(DeformedPlan plan);

}  // namespace cageproof::validation
