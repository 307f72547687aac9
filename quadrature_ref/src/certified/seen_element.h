// SPDX-License-Identifier: MIT
// An element as its point sees it, over which a kernel's terms are integrated.
#pragma once

#include "kernel_terms.h"

#include <optional>

namespace cageproof::quadrature_ref::certified {

/// The element's frame, and the integrals of powers and logarithms over the element.
class SeenElement {
 public:
  virtual ~SeenElement() = default;
  /// Coordinate i of axis `axis`; the last axis is the outward unit normal.
  virtual const Real& axis(int axis, int i) const = 0;
  /// x.n, the same all over the element.
  virtual const Real& height() const = 0;
  /// Whether the height is exactly zero.
  virtual bool in_plane() const = 0;
  /// The integral of x1^a x2^b r^(-q) and of the term's logarithm, weighted with a corner's hat function where one is
  /// named. \pre converges
  virtual Real moment(const Monomial& term, std::optional<int> corner) const = 0;
};

}  // namespace cageproof::quadrature_ref::certified
