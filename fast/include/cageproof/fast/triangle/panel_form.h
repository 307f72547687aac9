// SPDX-License-Identifier: MIT
// The moments of formulas by Gauss points on panels, where closed forms cancel.
#pragma once

#include "cageproof/fast/triangle/far_form.h"
#include "cageproof/fast/triangle/panels.h"

namespace cageproof::fast::triangle {

/// The error bound of a coefficient of degree k in a sum of r^p, in roundings of the sum of r^(p - k): each degree
/// adds two products to the eight or so roundings of a term, terms add up in blocks, and the polynomials of r^p have
/// coefficients up to those of (1 - x - y - z)^p for p < 0.
inline double panel_roundings(int p, int k) {
  double coefficient = 1;
  for (int i = 0; i < k; ++i) coefficient *= static_cast<double>(std::abs(p) + i) / (i + 1) * std::sqrt(3.);
  return (32 + 8 * k) * coefficient;
}

/// Sums over the Gauss points of panels, which must not be empty and must outlive this.
template <class R>
class PanelHats {
 public:
  explicit PanelHats(const Panels& panels) : panels_(panels) {}

  bool is_on(const Panels& panels) const { return &panels == &panels_; }

  template <int p, int D>
  std::array<Taylor<R, D>, 3> hats(const Frame<R>& frame) const {
    if constexpr (std::same_as<R, double> || is_tracked<R>) return by_vectors<p, D>();
    else return one_by_one<p, D>(frame);
  }

 private:
  template <int p, int D>
  std::array<Taylor<R, D>, 3> by_vectors() const {
    constexpr bool is_sized = is_tracked<R>;
    PanelSums sums;
    sum_panels(panels_, p, D, is_sized, sums);
    std::array<Taylor<R, D>, 3> hats;
    for (int k = 0; k < 3; ++k)
      for (int degree = 0; degree <= D; ++degree)
        for (int m = Monomials<D>::first(degree); m < Monomials<D>::first(degree + 1); ++m)
          if constexpr (is_sized) hats[k].c[m] = R(sums.sums[k][m], panel_roundings(p, degree) * sums.sizes[k][degree]);
          else hats[k].c[m] = sums.sums[k][m];
    return hats;
  }
  // The sums point by point, for numbers that track their errors and have no vector form.
  template <int p, int D>
  std::array<Taylor<R, D>, 3> one_by_one(const Frame<R>& frame) const {
    std::array<Taylor<R, D>, 3> hats;
    for (const Panel& panel : panels_) {
      std::array<Vec3<R>, 3> corner;
      for (int j = 0; j < 3; ++j)
        for (int c = 0; c < 3; ++c) {
          corner[j][c] = R(0);
          for (int k = 0; k < 3; ++k) corner[j][c] += R(panel.hat[k][j]) * frame.p[k][c];
        }
      Vec3<R> side, base;
      for (int c = 0; c < 3; ++c) {
        side[c] = corner[1][c] - corner[0][c];
        base[c] = corner[2][c] - corner[1][c];
      }
      const auto weights =
          collapsed_sums<p, D>(corner[0], side, base, R(panel.area2 / frame.area2.value) * frame.area2,
                               gauss_legendre<double>(panel.across), gauss_legendre<double>(panel.along));
      for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j) hats[k].add(R(panel.hat[k][j]), weights[j]);
    }
    return hats;
  }

  const Panels& panels_;
};

/// HatMoments over panels, in double or with a bound of their error.
template <class R, int N, int M>
using PanelForm = HatMoments<R, N, M, PanelHats<R>>;

}  // namespace cageproof::fast::triangle
