// SPDX-License-Identifier: MIT
// The solution of A w = r of smallest norm by Householder reflections: stable also where A is nearly singular, unlike
// the closed form.
#pragma once

#include "cageproof/core/geometry/element.h"

#include <array>
#include <cmath>
#include <limits>

namespace cageproof::adaptive_qmvc {

/// I - tau (1, v)(1, v)': acts on the rows from some row on, 1 standing for the first of them.
template <class R>
struct Reflection {
  std::array<R, 3> v{};
  int below = 0;  ///< entries of v
  R tau = R(0);

  /// The reflection that takes (x_0, ... x_below) to (first, 0, ...).
  static Reflection onto_first(const std::array<R, 4>& x, int below, R& first) {
    using std::sqrt;
    Reflection h;
    h.below = below;
    R rest = 0;
    for (int i = 1; i <= below; ++i) rest += x[i] * x[i];
    first = x[0];
    if (rest <= std::numeric_limits<R>::min()) return h;
    first = sqrt(R(x[0] * x[0] + rest));
    if (x[0] >= 0) first = -first;
    for (int i = 0; i < below; ++i) h.v[i] = x[i + 1] / (x[0] - first);
    h.tau = (first - x[0]) / first;
    return h;
  }

  void apply_to(R* x) const {
    if (tau == 0) return;
    R along = 0;
    for (int i = 0; i < below; ++i) along += v[i] * x[i + 1];
    along += x[0];
    x[0] -= tau * along;
    for (int i = 0; i < below; ++i) x[i + 1] -= (tau * v[i]) * along;
  }
};

/// The columns of A are the corners `p`. Not finite where A is singular. By loops of its own: Eigen's decompositions
/// take the compiler half of this room's time.
template <Scalar R>
std::array<R, 4> solution_by_reflections(const Quad<R>& p, const Vec3<R>& r) {
  // A' = Q U, U upper triangular: w = Q (U'^-1 r, 0).
  std::array<std::array<R, 4>, 3> column;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 4; ++i) column[k][i] = p[i][k];
  std::array<Reflection<R>, 3> reflection;
  for (int k = 0; k < 3; ++k) {
    std::array<R, 4> tail{};
    for (int i = k; i < 4; ++i) tail[i - k] = column[k][i];
    R diagonal;
    reflection[k] = Reflection<R>::onto_first(tail, 3 - k, diagonal);
    for (int j = k + 1; j < 3; ++j) reflection[k].apply_to(&column[j][k]);
    column[k][k] = diagonal;
  }
  std::array<R, 4> w{};
  for (int k = 0; k < 3; ++k) {
    w[k] = r[k];
    for (int j = 0; j < k; ++j) w[k] -= column[k][j] * w[j];
    w[k] /= column[k][k];
  }
  for (int k = 2; k >= 0; --k) reflection[k].apply_to(&w[k]);
  return w;
}

}  // namespace cageproof::adaptive_qmvc
