// SPDX-License-Identifier: MIT
// How biharmonic functions behave at a corner whose sides are clamped.
#pragma once

#include <complex>
#include <vector>

namespace cageproof::solved::goursat {

/// A solution r^(mu + 1) F(psi) of the biharmonic equation in a wedge, psi the angle from its bisector, that vanishes
/// with its gradient on both sides: F = outer C((mu + 1) psi) + inner C((mu - 1) psi), C the sine for odd ones, else
/// the cosine. Of a complex mu the real and the imaginary part are two solutions, which are those of its conjugate too.
struct CornerExponent {
  std::complex<double> mu;
  bool odd;
  std::complex<double> outer, inner;  ///< of unit length together

  bool is_real() const { return mu.imag() == 0; }
};

/// The exponents with 0 < Re mu < largest and Im mu >= 0, by rising real parts: the zeros of sin(mu angle) + mu
/// sin(angle) (even) and sin(mu angle) - mu sin(angle) (odd), without mu = 1, which belongs to a rotation. Zeros closer
/// to each other than 1e-7 of their size count once; they occur only next to 0.8128 pi and other angles where two meet.
/// (Williams 1952)
/// \param angle of the wedge, in (0, 2 pi]
std::vector<CornerExponent> clamped_exponents(double angle, double largest);

}  // namespace cageproof::solved::goursat
