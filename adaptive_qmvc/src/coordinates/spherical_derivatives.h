// SPDX-License-Identifier: MIT
// A quad's spherical weights with derivatives, also where its mean vector nearly vanishes.
#pragma once

#include "coordinates/spherical_quad.h"

namespace cageproof::adaptive_qmvc {

/// The weights with derivatives in 200 digits; in the plane of a planar quad, off the quad, where weights are zero and
/// derivatives are not, as well. NaN derivatives where those do not exist: where the mean vector vanishes outside such
/// planes, or lies on an arc.
CornerWeights<SecondOrder<Mp200>> spherical_weights_in_200_digits(const Quad<double>& q, const Vec3<Mp200>& eta);

/// The weights with derivatives. Where much of the mean vector cancels, next to the quad's plane and far from it, they
/// are those in 200 digits, which are more accurate there than values alone in R.
template <Scalar R>
CornerWeights<SecondOrder<R>> spherical_weights(const Quad<double>& q, const Vec3<R>& eta) {
  // Second derivatives lose up to three times the digits that the mean vector loses.
  constexpr double kEnough = 0x1p-6;
  const Quad<R> corners{convert<R>(q[0]), convert<R>(q[1]), convert<R>(q[2]), convert<R>(q[3])};
  const SphericalQuad<SecondOrder<R>> plain(corners, eta);
  if (plain.remainder > kEnough) return plain.weights;
  const auto wide = spherical_weights_in_200_digits(q, convert<Mp200>(eta));
  CornerWeights<SecondOrder<R>> weights;
  for (std::size_t k = 0; k < 4; ++k) {
    weights[k].value = static_cast<R>(wide[k].value);
    for (std::size_t i = 0; i < 3; ++i) weights[k].gradient[i] = static_cast<R>(wide[k].gradient[i]);
    for (std::size_t i = 0; i < 6; ++i) weights[k].hessian[i] = static_cast<R>(wide[k].hessian[i]);
  }
  return weights;
}

}  // namespace cageproof::adaptive_qmvc
