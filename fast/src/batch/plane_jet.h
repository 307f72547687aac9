// SPDX-License-Identifier: MIT
// Functions of points in the plane with derivatives, a vector of points at a time.
#pragma once

#include "plane_kelvin.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// A function of the points with derivatives xx, xy, yy.
struct PlaneJet {
  Lanes value{}, gradient[2] = {}, hessian[3] = {};
};
template <int O>
PlaneJet product_of(const PlaneJet& a, const PlaneJet& b) {
  PlaneJet c;
  c.value = a.value * b.value;
  if constexpr (O >= 1)
    for (int i = 0; i < 2; ++i) c.gradient[i] = a.gradient[i] * b.value + a.value * b.gradient[i];
  if constexpr (O >= 2)
    for (int at = 0; at < 3; ++at) {
      const int i = kFirst[at], j = kSecond[at];
      c.hessian[at] = a.hessian[at] * b.value + a.gradient[i] * b.gradient[j] + a.gradient[j] * b.gradient[i] +
                      a.value * b.hessian[at];
    }
  return c;
}

template <int O>
PlaneJet sum_of(const PlaneJet& a, const PlaneJet& b) {
  PlaneJet c;
  c.value = a.value + b.value;
  if constexpr (O >= 1)
    for (int i = 0; i < 2; ++i) c.gradient[i] = a.gradient[i] + b.gradient[i];
  if constexpr (O >= 2)
    for (int i = 0; i < 3; ++i) c.hessian[i] = a.hessian[i] + b.hessian[i];
  return c;
}
template <int O>
PlaneJet scaled_jet(const PlaneJet& a, double factor) {
  PlaneJet c;
  c.value = factor * a.value;
  if constexpr (O >= 1)
    for (int i = 0; i < 2; ++i) c.gradient[i] = factor * a.gradient[i];
  if constexpr (O >= 2)
    for (int i = 0; i < 3; ++i) c.hessian[i] = factor * a.hessian[i];
  return c;
}
template <int O>
PlaneJet inverse_of(const PlaneJet& a) {
  PlaneJet c;
  c.value = 1 / a.value;
  if constexpr (O >= 1)
    for (int i = 0; i < 2; ++i) c.gradient[i] = -c.value * c.value * a.gradient[i];
  if constexpr (O >= 2)
    for (int at = 0; at < 3; ++at)
      c.hessian[at] = -c.value * (c.value * a.hessian[at] + 2 * c.gradient[kFirst[at]] * a.gradient[kSecond[at]]);
  return c;
}
/// A linear function with that gradient.
inline PlaneJet linear_jet(Lanes value, double dx, double dy) {
  PlaneJet a;
  a.value = value;
  a.gradient[0] = splat(dx);
  a.gradient[1] = splat(dy);
  return a;
}
/// Replaces the jet `to` by `from` for the points `mine`.
template <int O>
void take(Mask mine, const PlaneJet& from, PlaneJet& to) {
  to.value = select(mine, from.value, to.value);
  for (int i = 0; i < 2; ++i) to.gradient[i] = select(mine, from.gradient[i], to.gradient[i]);
  for (int i = 0; i < 3; ++i) to.hessian[i] = select(mine, from.hessian[i], to.hessian[i]);
}
/// A jet at some points, nothing at others.
template <int O>
PlaneJet kept(Mask mine, const PlaneJet& from) {
  PlaneJet jet;
  take<O>(mine, from, jet);
  return jet;
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
