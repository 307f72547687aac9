// SPDX-License-Identifier: MIT
// The papers' figures made again: what deformers do to meshes, side by side. Figures are for reading, and promise
// nothing.
#pragma once

#include "cageproof/reports/figure_sheet.h"
#include "cageproof/validation/measurement.h"

#include <filesystem>
#include <map>

namespace cageproof::validation {

/// Images of points, by the panel that shows them.
using FigureFindings = std::map<std::string, MeshField>;

/// One or several figures of one cage and mesh. Immutable; safe from any thread.
class PaperFigure {
 public:
  virtual ~PaperFigure() = default;
  /// Unlike that of any other.
  virtual std::string name() const = 0;
  /// Into how many parts its work is cut: panels of one part share coordinates.
  virtual int parts() const = 0;
  /// Findings for the panels of a part; different parts have different keys, which begin with `figure/`. \param jobs
  /// threads; 0: all cores; the findings are the same for any
  virtual FigureFindings part(int part, int jobs) const = 0;
  /// Whether the findings for all of its panels are there.
  virtual bool is_in(const FigureFindings& found) const = 0;
  /// \pre is_in(found)
  virtual std::vector<reports::FigureSheet> sheets(const FigureFindings& found) const = 0;
};
using PaperFigures = std::vector<std::unique_ptr<const PaperFigure>>;

/// Figures of cages made in code. They compare deformers on a bar ([T24]), Poisson's ratio, bulging, variants and
/// kernels ([C23]), quads with their triangulation ([T18]), and maps of polygons ([W12]).
PaperFigures embedded_figures();

/// Figures of a folder's files NAME_Cage.obj, NAME_Cage_Deformed.obj and NAME.obj, for each NAME: deformers compared,
/// on cages with quads also with their triangulation, Poisson's ratio and bulging. Meshes are thinned, and their
/// vertices outside the cage are left out.
/// \throws InputError naming the folder or file that is missing or bad, and a posed cage with another number of
/// vertices
PaperFigures figures_of_data(const std::filesystem::path& folder);

/// Computes figures. \param said called before each with its name
std::vector<reports::FigureSheet> figure_sheets(const PaperFigures& figures, int jobs,
                                                const std::function<void(const std::string&)>& said = {});

/// The work of embedded figures as parts of a run: their findings are its meshes. \param all or only the first few,
/// which show all methods
Measurements figure_measurements(bool all);

/// The embedded figures that a run has computed; none of a run that was asked for none.
std::vector<reports::FigureSheet> sheets_of_run(const FigureFindings& meshes);

}  // namespace cageproof::validation
