// SPDX-License-Identifier: MIT
#include "polar_cells.h"

#include <numbers>

namespace cageproof::quadrature_ref {
namespace {

// Fewer points would not even see that an integrand is larger than modelled.
constexpr int kFewestInCell = 3;

// Zeros of r as a function of w: i pi/2 for a ray square to the line of sight, asinh(-1) for a ray along it.
const Singularities kRadialSingularities{{0, std::numbers::pi / 2}, {-0.8813735870195430, 0}};

// asinh(a/distance cosh v), from the quotient's logarithm.
double radial_end(double log_quotient, double v) {
  const double log_cosh = std::abs(v) + std::log1p(std::exp(-2 * std::abs(v))) - std::numbers::ln2;
  return asinh_of_exp(log_quotient + log_cosh);
}

// Cells of the panel [t_lo, t_hi] of an edge, for w from w_start to the edge.
void add_edge_cells(const PolarCell& panel, double v0, double log_quotient, double w_start, const PanelDesign& design,
                    std::vector<PolarCell>& cells) {
  const double v_lo = v0 + panel.t_lo, v_hi = v0 + panel.t_hi;
  const double least = radial_end(log_quotient, std::clamp(0.0, v_lo, v_hi));
  const double most = std::max(radial_end(log_quotient, v_lo), radial_end(log_quotient, v_hi));
  static thread_local std::vector<double> ends;
  set_panel_ends(w_start, std::max(most, w_start), kRadialSingularities, design, ends);
  std::size_t fixed = 0;
  while (fixed + 2 < ends.size() && ends[fixed + 1] <= least) {
    PolarCell cell = panel;
    cell.w_lo = ends[fixed];
    cell.w_hi = ends[fixed + 1];
    cells.push_back(cell);
    ++fixed;
  }
  const double from = ends[fixed], to = ends.back();
  const auto fits = [&](int parts) {
    for (int i = 0; i < parts; ++i)
      if (nodes_for(from + (to - from) * i / parts, from + (to - from) * (i + 1) / parts, kRadialSingularities,
                    design.digits) > design.nodes)
        return false;
    return true;
  };
  int parts = 1;
  while (parts < 64 && !fits(parts)) ++parts;
  for (int i = 0; i < parts; ++i) {
    PolarCell cell = panel;
    cell.w_lo = from;
    cell.w_hi = to;
    cell.reaches_edge = true;
    cell.lower = static_cast<double>(i) / parts;
    cell.upper = static_cast<double>(i + 1) / parts;
    cells.push_back(cell);
  }
}

}  // namespace

double disc_end(const PolarFrame<Mp200>& frame) {
  if (!frame.interior || frame.edges.size() != 3) return 0;
  double end = std::numeric_limits<double>::infinity();
  for (const auto& edge : frame.edges) end = std::min(end, asinh_of_exp(log_magnitude(Mp200(edge.a / frame.distance))));
  return end * (1 - 1e-12);  // inside all edges also after rounding
}

void set_polar_cells(const PolarFrame<Mp200>& frame, const PanelDesign& design, std::vector<PolarCell>& cells) {
  static thread_local std::vector<double> ends;
  cells.clear();
  const double disc = disc_end(frame);
  if (disc > 0) {
    set_panel_ends(0, disc, kRadialSingularities, design, ends);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      PolarCell& ring = cells.emplace_back();
      ring.edge = -1;
      ring.w_lo = ends[i];
      ring.w_hi = ends[i + 1];
    }
  }
  for (std::size_t k = 0; k < frame.edges.size(); ++k) {
    const PolarEdge<Mp200>& edge = frame.edges[k];
    set_panel_ends(0, static_cast<double>(edge.v_length), edge.singular, design, ends);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      PolarCell panel;
      panel.edge = static_cast<int>(k);
      panel.t_lo = ends[i];
      panel.t_hi = ends[i + 1];
      panel.last = i + 2 == ends.size();
      add_edge_cells(panel, static_cast<double>(edge.v0), log_magnitude(Mp200(edge.a / frame.distance)), disc, design,
                     cells);
    }
  }
}

CellPoints points_for(const PolarFrame<Mp200>& frame, const PolarCell& cell, double digits) {
  const double length = cell.w_hi - cell.w_lo;
  const double lo = cell.reaches_edge ? cell.w_lo + cell.lower * length : cell.w_lo;
  const double hi = cell.reaches_edge ? cell.w_lo + cell.upper * length : cell.w_hi;
  const int w = std::max(kFewestInCell, nodes_for(lo, hi, kRadialSingularities, digits));
  if (cell.edge < 0) return {kRingDirections, w};
  const int t = nodes_for(cell.t_lo, cell.t_hi, frame.edges[cell.edge].singular, digits);
  return {std::max(kFewestInCell, t), w};
}

}  // namespace cageproof::quadrature_ref
