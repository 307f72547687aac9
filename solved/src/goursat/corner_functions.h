// SPDX-License-Identifier: MIT
// Functions that behave as solutions do at one corner, and are smooth everywhere else in the polygon.
#pragma once

#include "corner_exponents.h"
#include "goursat_jet.h"

#include "dirichlet_solver.h"

namespace cageproof::solved::goursat {

/// Functions for a corner with the angle omega, in polar coordinates r and psi from its bisector.
///
/// Biharmonic: psi r cos psi and psi r sin psi, which with linear functions meet any linear values and constant normal
/// derivatives on both sides; and CornerExponent's solutions, which vanish there with their gradients. Harmonic: r^(k
/// pi/omega) sin(k pi (psi/omega + 1/2)), which vanish there; and where the sides are nearly in line Re and Im of
/// z log z, which with linear functions meet any linear values.
class CornerFunctions {
 public:
  /// \param terms exponents are taken up to terms pi/omega
  CornerFunctions(Equation equation, double angle, int terms);

  int size() const { return size_; }
  /// \param offset from the corner, in a frame whose real axis is the bisector
  /// \param angle of the offset, continuous in the polygon
  /// \param turn what plain offsets are multiplied with to lie in that frame
  template <class R>
  void put(const Complex<R>& offset, const R& angle, const Complex<R>& turn, RowWriter<R>& rows) const;

 private:
  template <class R>
  void put_biharmonic(const Complex<R>& z, const Complex<R>& log, const Complex<R>& turn, RowWriter<R>& rows) const;
  template <class R>
  void put_harmonic(const Complex<R>& z, const Complex<R>& log, const Complex<R>& turn, RowWriter<R>& rows) const;

  Equation equation_;
  double angle_;
  int terms_;
  std::vector<CornerExponent> exponents_;  // biharmonic
  bool with_logarithm_ = false;            // harmonic
  int size_;
};

}  // namespace cageproof::solved::goursat
