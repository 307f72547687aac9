// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace cageproof::adaptive_qmvc {

template <class R>
using Basis = std::array<R, 4>;

/// The basis functions of corners 0..3 ([T18] Eq 3).
template <class R>
Basis<R> bilinear_basis(const R& u, const R& v) {
  return {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
}

}  // namespace cageproof::adaptive_qmvc
