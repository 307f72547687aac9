// SPDX-License-Identifier: MIT
// All figures of embedded cages, one function per paper.
#pragma once

#include "deformed_figure.h"

namespace cageproof::validation {

/// The view in which bars along z are shown.
inline const reports::FigureView bar_view{{0.45, -1, 0.35}, {0, 0, 1}};

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
/// [T18] Figure 5: quads that are valid, and others.
std::unique_ptr<const PaperFigure> valid_quads_figure();
/// [T18] Figures 8 and 9: the projection to a quad, and the samples around it.
std::unique_ptr<const PaperFigure> projection_figure();
/// [T18] Figure 4: quads in triangles.
std::unique_ptr<const PaperFigure> tessellation_figure();
/// [T18] Figure 7: the norm correction.
std::unique_ptr<const PaperFigure> norm_correction_figure();
/// [T18] Figure 10: a cage of bent quads.
std::unique_ptr<const PaperFigure> twisted_box_figure();
/// [T18] Figure 15: spherical mean value coordinates.
std::unique_ptr<const PaperFigure> spherical_figure();
/// [T18] Figures 13 and 14: a cage of triangles and quads.
std::unique_ptr<const PaperFigure> triquad_figure();
/// [T18] Figures 16 and 17: negative coordinates, and others.
std::unique_ptr<const PaperFigure> fork_figure();
/// [T24] Figures 3, 4 and 5: weights of positions, constructions, and alignment.
std::unique_ptr<const PaperFigure> biharmonic_choices_figure();
/// [T24] Figure 6: maps of least energy.
std::unique_ptr<const PaperFigure> variational_figure();
/// [T24] Figure 8: quadrature next to the cage.
std::unique_ptr<const PaperFigure> spikes_figure();
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
/// [C23] Figures 4 and 7 in space: a bent bar.
std::unique_ptr<const PaperFigure> bar_variants_figure();
/// [C23] Figure 10: a hexagon and an L.
std::unique_ptr<const PaperFigure> hexagon_figure();
std::unique_ptr<const PaperFigure> l_figure();

}  // namespace cageproof::validation
