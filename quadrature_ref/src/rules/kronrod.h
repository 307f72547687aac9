// SPDX-License-Identifier: MIT
// A Gauss-Kronrod rule, whose embedded rule tells its error.
#pragma once

#include "cageproof/core/numbers/mp_number.h"
#include "cageproof/core/numbers/scalar.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>

namespace cageproof::quadrature_ref {

/// The 15-point Gauss-Kronrod rule on [0, 1] with the embedded 7-point Gauss rule's weights (zero at the other nodes).
template <Scalar W>
struct KronrodRule {
  std::array<W, 15> nodes, weights, gauss_weights;
};

template <Scalar W>
const KronrodRule<W>& kronrod_rule() {
  using Real = BoostReal<W>;
  using Kronrod = boost::math::quadrature::gauss_kronrod<typename Real::Number, 15>;
  using Gauss = boost::math::quadrature::gauss<typename Real::Number, 7>;
  static const KronrodRule<W> rule = [] {
    KronrodRule<W> r;
    for (int k = 0; k < 8; ++k)  // abscissas from the centre outwards; the even ones are Gauss nodes
      for (const int side : {-1, 1}) {
        const int i = 7 + side * k;
        r.nodes[i] = (1 + side * Real::from(Kronrod::abscissa()[k])) / 2;
        r.weights[i] = Real::from(Kronrod::weights()[k]) / 2;
        r.gauss_weights[i] = k % 2 == 0 ? W(Real::from(Gauss::weights()[k / 2]) / 2) : W(0);
      }
    return r;
  }();
  return rule;
}

}  // namespace cageproof::quadrature_ref
