// SPDX-License-Identifier: MIT
// The constants of elasticity that both of Kelvin's kernels share.
#pragma once

namespace cageproof::closed_form {

/// The shares of [T24] Eq 48's constants: 2b/a = 1/(2 (1 - nu)) and (a - 2b)/a = (1 - 2 nu)/(2 (1 - nu)), each without
/// cancellation; 0 and 1 in the limit of an infinite Poisson ratio.
template <class R>
struct KelvinShares {
  R bulk, shear;

  explicit KelvinShares(const R& nu) : bulk(0), shear(1) {
    if (nu == nu + R(1)) return;
    bulk = R(1) / (R(2) * (R(1) - nu));
    shear = (R(1) - R(2) * nu) * bulk;
  }
};

}  // namespace cageproof::closed_form
