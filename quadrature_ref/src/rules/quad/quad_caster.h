// SPDX-License-Identifier: MIT
// The product rule on a cell of a quad's frame.
#pragma once

#include "polar_quad_frame.h"
#include "../gauss_nodes.h"

namespace cageproof::quadrature_ref {

/// A rectangle in (w, tau) of a sector, in fractions of the ranges [0, asinh(1/delta)] and [tau, tau + tau_length].
struct QuadCell {
  int sector = 0;
  double delta = 1;
  double t_lo = 0, t_hi = 1, w_lo = 0, w_hi = 1;
};

/// Points along both directions of a cell.
struct QuadPoints {
  int t, w;
  bool enough = true;  ///< false where the digits asked for need more than the largest rule has
};

/// Feeds a kernel with the points of cells.
template <Scalar W>
class QuadCaster {
 public:
  /// Keeps references to all it is given.
  QuadCaster(const PolarQuadFrame<W>& frame, const Integrand& integrand, const KernelTask<W>& task)
      : frame_(frame),
        integrand_(integrand),
        kernel_(integrand.kernel<W>()),
        task_(task),
        log_unit_(log_of_unit<W>(frame.exponent)) {}

  /// Adds the product Gauss-Legendre rule on a cell.
  void add_cell(const QuadCell& cell, QuadPoints points, Result<W>& sums);
  /// For each derivative order, log10 of the largest |integrand| times the cell's extent, from 3 x 3 samples.
  std::array<double, 3> log10_mass(const QuadCell& cell);
  /// How many times as large as a cell's positions and normals the terms are that they are summed from, by 3 x 3
  /// samples: of quads whose opposite sides differ much in length, away from c, they cancel.
  double cancellation(const QuadCell& cell);

 private:
  struct Radius {
    W rho, square, weight;
  };
  /// The radius at a fraction of the range of w, and rho drho per unit of the cell's fraction.
  Radius radius(const QuadCell& cell, const W& w_range, const W& fraction) const;
  void aim(const QuadSector<W>& sector, const QuadCell& cell, const W& fraction);
  void set_node(const Radius& radius, const W& weight, Node<W>& node) const;

  const PolarQuadFrame<W>& frame_;
  const Integrand& integrand_;
  const Kernel<W>& kernel_;
  KernelTask<W> task_;
  W log_unit_;
  W du_, dv_, duv_, ray_weight_;
  Vec3<W> direction_, bend_;
  std::vector<Node<W>> nodes_;
};

}  // namespace cageproof::quadrature_ref
