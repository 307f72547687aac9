// SPDX-License-Identifier: MIT
// The triangle cut into cells of polar coordinates, on each of which the integrand is smooth; and the product rule on a
// cell.
//
// Radius tau = distance sinh w. Where c is off the edges, the largest disc around it is a cell of its own: on circles r
// is constant and the integrand a trigonometric polynomial, which the trapezoidal rule integrates exactly.
#pragma once

#include "../finish.h"
#include "../gauss_nodes.h"
#include "polar_frame.h"

namespace cageproof::quadrature_ref {

/// A range of directions, t = v - v0 in [t_lo, t_hi], and of radii, tau = distance sinh w: w between fixed ends, or
/// between fractions of the way from w_lo to the edge.
struct PolarCell {
  int edge = 0;  ///< -1: a ring of the disc, all directions
  double t_lo = 0, t_hi = 0;
  bool last = false;          ///< t_hi stands for the edge's v_length, at full precision
  double w_lo = 0, w_hi = 0;  ///< w_hi: at most, for a cell that ends at the edge
  bool reaches_edge = false;  ///< w from w_lo + lower (W - w_lo) to w_lo + upper (W - w_lo), W(v) at the edge
  double lower = 0, upper = 1;
};

/// Points along both directions of a cell.
struct CellPoints {
  int t, w;
};

/// The number of directions on a ring, which is exact for trigonometric polynomials of degree 11. Hessians with hat
/// functions have degree 3, Hessians of elastic tensors 5.
inline constexpr int kRingDirections = 12;

/// w at the largest disc around c; 0 where c is on an edge.
double disc_end(const PolarFrame<Mp200>& frame);

/// Sets `cells` to those of a frame, panels designed as `design` says.
void set_polar_cells(const PolarFrame<Mp200>& frame, const PanelDesign& design, std::vector<PolarCell>& cells);

/// Points for `digits` digits relative to the cell's largest integrand.
CellPoints points_for(const PolarFrame<Mp200>& frame, const PolarCell& cell, double digits);

/// A point of a ray: its radius, and its weight for the area element tau dtau.
template <Scalar W>
struct RadialPoint {
  W tau, weight;
};

/// Walks rays of a frame and feeds a kernel with the points on them.
template <Scalar W>
class RayCaster {
 public:
  /// Keeps references to all it is given.
  RayCaster(const PolarFrame<W>& frame, const Integrand& integrand, const KernelTask<W>& task)
      : frame_(frame), integrand_(integrand), kernel_(integrand.kernel<W>()), task_(task) {}

  /// Turns to the direction t of an edge; the angle's element is dt / cosh_v. Returns w at the edge.
  W aim(const PolarEdge<W>& edge, const W& t, W& cosh_v);
  /// Turns to an angle in the plane.
  void aim_around(const W& angle);
  /// Adds the points on the ray, their weights times `weight`.
  void cast(std::span<const RadialPoint<W>> points, const W& weight, Result<W>& sums);

  /// Adds the product rule on a cell.
  void add_cell(const PolarCell& cell, CellPoints points, Result<W>& sums);
  /// For each derivative order, log10 of the largest |integrand| times the cell's extent, from 3 x 3 samples.
  std::array<double, 3> log10_mass(const PolarCell& cell);

 private:
  W t_length(const PolarCell& cell) const;

  const PolarFrame<W>& frame_;
  const Integrand& integrand_;
  const Kernel<W>& kernel_;
  KernelTask<W> task_;
  Vec3<W> direction_;
  std::array<W, 3> slope_;
};

}  // namespace cageproof::quadrature_ref
