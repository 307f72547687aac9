// SPDX-License-Identifier: MIT
// All figures of embedded cages, one function per paper.
#pragma once

#include "deformed_figure.h"

namespace cageproof::validation {

/// Panels of [T24]'s deformers, of mean value coordinates and of [C23]'s, after one at rest: for any cage in space.
std::vector<PanelPlan> comparison_panels(const std::vector<Vec3<double>>& posed);

/// Panels of [C23]'s deformer, with nu by columns and gamma by rows. The first column shows mean value and Green
/// coordinates at rest. \param variant "global" or "local"
std::vector<PanelPlan> elastic_panels(const std::vector<Vec3<double>>& posed, const std::string& variant);

/// The text that says how to read such figures.
std::string comparison_text();
std::string elastic_text(const std::string& variant);

/// [T24] Figures 1, 2, 3 and 5: a bar bent and twisted.
std::unique_ptr<const PaperFigure> bar_figure();
/// [C23] Figures 1, 2 and 5: a cube pressed flat.
std::unique_ptr<const PaperFigure> pressed_figure();
/// [T18] Figures 1 and 12: quads against their triangulation, in a symmetric pose; deformers with normals, too, and by
/// either diagonals.
std::unique_ptr<const PaperFigure> symmetry_figure();
/// [W12] Figures 1 and 5: a bar of the plane bent.
std::unique_ptr<const PaperFigure> plane_bar_figure();
/// [C23] Figure 3: kernels in the plane.
std::unique_ptr<const PaperFigure> kernel_figure();
/// [W12] Figure 2: trousers with one leg lifted.
std::unique_ptr<const PaperFigure> trousers_figure();
/// [W12] Figures 4 and 8: a square by several normal derivatives, and made a rhombus.
std::unique_ptr<const PaperFigure> square_figure();
/// [W12] Figure 6: a star with turned tips.
std::unique_ptr<const PaperFigure> star_figure();
/// [W12] Figure 7: an animal whose neck is shortened, drawn out and bent by points that are held.
std::unique_ptr<const PaperFigure> neck_figure();
/// [W12] Figure 10: a square of two triangles made an L.
std::unique_ptr<const PaperFigure> seam_figure();
/// [C23] Figure 4: variants on a star with lifted arms.
std::unique_ptr<const PaperFigure> star_variants_figure();
/// [C23] Figure 7: Poisson's ratio up to infinity in the plane.
std::unique_ptr<const PaperFigure> infinite_ratio_figure();
/// [C23] Figure 10: a hexagon and an L.
std::unique_ptr<const PaperFigure> hexagon_figure();
std::unique_ptr<const PaperFigure> l_figure();

}  // namespace cageproof::validation
