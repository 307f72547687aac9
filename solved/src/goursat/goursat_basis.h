// SPDX-License-Identifier: MIT
// The functions that solutions in a polygon are combined from.
#pragma once

#include "corner_functions.h"
#include "orthogonal_polynomials.h"
#include "polygon_frame.h"

namespace cageproof::solved::goursat {

/// Harmonic: Re and Im of polynomials. Biharmonic: these, and Re and Im of the conjugate of z times polynomials. And
/// each corner's functions.
class GoursatBasis {
 public:
  /// \param terms of the corners' functions \param points of the boundary, in the frame
  GoursatBasis(std::shared_ptr<const PolygonFrame> frame, Equation equation, int degree, int terms,
               std::span<const std::complex<double>> points);

  int size() const { return size_; }
  const PolygonFrame& frame() const { return *frame_; }
  /// All functions with derivatives up to `order`, in the frame's unit.
  /// \param rows 1, 3 or 6 rows of size() numbers: RowWriter
  template <class R>
  void rows_at(const SeenPoint<R>& point, int order, R* rows) const;

 private:
  std::shared_ptr<const PolygonFrame> frame_;
  Equation equation_;
  OrthogonalPolynomials polynomials_;
  std::vector<CornerFunctions> corners_;
  int size_;
};

/// Numbers of values and derivatives up to an order, of which second ones in both orders are one.
constexpr int rows_of_order(int order) { return order == 0 ? 1 : order == 1 ? 3 : 6; }

}  // namespace cageproof::solved::goursat
