// SPDX-License-Identifier: MIT
// Vectors of the space in any arithmetic V.
#pragma once

#include <array>

namespace cageproof::closed_form::batch {

/// A vector of the space.
template <class V>
struct Three {
  std::array<V, 3> c;
  V& operator[](int i) { return c.data()[i]; }
  const V& operator[](int i) const { return c.data()[i]; }
};

template <class V>
V dot(const Three<V>& a, const Three<V>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class V, class T>
V dot(const T (&constant)[3], const Three<V>& v) {
  return v[0] * constant[0] + v[1] * constant[1] + v[2] * constant[2];
}
template <class V>
Three<V> cross(const Three<V>& a, const Three<V>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace cageproof::closed_form::batch
