// SPDX-License-Identifier: MIT
// Vectors of balls.
#pragma once

#include "../exact_input.h"

namespace cageproof::quadrature_ref::certified {

inline Real dot(const Vector& a, const Vector& b) {
  Real sum = a[0] * b[0];
  add_product(sum, a[1], b[1]);
  add_product(sum, a[2], b[2]);
  return sum;
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector moved(const Vector& a, const Real& by, const Vector& along) {
  return {a[0] + by * along[0], a[1] + by * along[1], a[2] + by * along[2]};
}

}  // namespace cageproof::quadrature_ref::certified
