// SPDX-License-Identifier: MIT
// Weights divided by their sum, with derivatives.
#pragma once

#include "cageproof/core/numbers/linear.h"

#include <array>
#include <cstddef>

namespace cageproof {

/// The index of the largest of n coordinates that are above 1/2; n where none is.
template <Scalar R>
std::size_t leading(const R* lambda, std::size_t n) {
  std::size_t lead = n;
  R most = R(0.5);
  for (std::size_t i = 0; i < n; ++i)
    if (lambda[i] > most) most = lambda[i], lead = i;
  return lead;
}

/// lambda = w / W with W = sum of w, and its derivatives by the quotient rule, in place. Next to a vertex that rule
/// cancels for the vertex's own coordinate, which is almost one: its derivatives are minus the sum of all others'.
/// \param w value, gradient and Hessian of n weights, the last index the fastest; orders above `order` are not touched
template <Scalar R>
void normalise(const std::array<R*, 3>& w, std::size_t n, std::size_t dim, int order) {
  R sum = 0;
  Vec3<R> gradient = Vec3<R>::Zero();
  Mat3<R> hessian = Mat3<R>::Zero();
  for (std::size_t i = 0; i < n; ++i) {
    sum += w[0][i];
    for (std::size_t a = 0; order >= 1 && a < dim; ++a) gradient[a] += w[1][dim * i + a];
    for (std::size_t a = 0; order >= 2 && a < dim * dim; ++a) hessian(a / dim, a % dim) += w[2][dim * dim * i + a];
  }
  for (std::size_t i = 0; i < n; ++i) {
    w[0][i] /= sum;
    for (std::size_t a = 0; order >= 1 && a < dim; ++a)
      w[1][dim * i + a] = (w[1][dim * i + a] - w[0][i] * gradient[a]) / sum;
    for (std::size_t a = 0; order >= 2 && a < dim; ++a)
      for (std::size_t b = 0; b < dim; ++b) {
        R& h = w[2][dim * dim * i + dim * a + b];
        h = (h - w[0][i] * hessian(a, b) - w[1][dim * i + a] * gradient[b] - w[1][dim * i + b] * gradient[a]) / sum;
      }
  }
  const std::size_t lead = leading(w[0], n);
  if (lead == n) return;
  for (int o = 1; o <= order; ++o) {
    const std::size_t derivatives = o == 1 ? dim : dim * dim;
    for (std::size_t a = 0; a < derivatives; ++a) {
      R others = 0;
      for (std::size_t i = 0; i < n; ++i)
        if (i != lead) others += w[o][derivatives * i + a];
      w[o][derivatives * lead + a] = -others;
    }
  }
}

}  // namespace cageproof
