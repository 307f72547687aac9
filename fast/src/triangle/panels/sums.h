// SPDX-License-Identifier: MIT
// Sums over Gauss points, a vector of points at a time.
#pragma once

#include "cageproof/closed_form/batch/lanes.h"

#include "request.h"

namespace cageproof::fast::triangle::CAGEPROOF_SIMD {

using closed_form::batch::CAGEPROOF_SIMD::kLanes;
using closed_form::batch::CAGEPROOF_SIMD::Lanes;
using closed_form::batch::CAGEPROOF_SIMD::splat;

/// Where monomials of three variables are in a polynomial (Monomials, in arithmetic/taylor.h, has the same order).
struct Places {
  int raised[kMostCoefficients][3] = {};

  static constexpr int first(int k) { return k * (k + 1) * (k + 2) / 6; }
  constexpr Places() {
    int at = 0;
    for (int k = 0; k <= kHighestDegree; ++k)
      for (int x = k; x >= 0; --x)
        for (int y = k - x; y >= 0; --y, ++at) {
          const int z = k - x - y;
          const int same = first(k + 1) + (y + z) * (y + z + 1) / 2 + z;
          raised[at][0] = same;
          raised[at][1] = first(k + 1) + (y + z + 1) * (y + z + 2) / 2 + z;
          raised[at][2] = first(k + 1) + (y + z + 1) * (y + z + 2) / 2 + z + 1;
        }
  }
};
inline constexpr Places kPlaces;

inline Lanes load(const double* from) {
  Lanes x;
  __builtin_memcpy(&x, from, sizeof x);
  return x;
}

inline double sum_of(Lanes a) {
  double sum = 0;
  for (int i = 0; i < kLanes; ++i) sum += a[i];
  return sum;
}

/// r^P times `value`, from r^2 = 1/q: k r^2 f_k = (2k - 2 - P)(x.delta) f_{k-1} + (P - k + 2) delta^2 f_{k-2},
/// Gegenbauer's recurrence.
template <int P, int D>
void expand(const Lanes (&x)[3], Lanes q, Lanes (&c)[Places::first(D + 1)]) {
  for (int m = 1; m < Places::first(D + 1); ++m) c[m] = Lanes{};
  for (int k = 1; k <= D; ++k) {
    const Lanes slope = q * (static_cast<double>(2 * k - 2 - P) / k);
    const Lanes along[3] = {slope * x[0], slope * x[1], slope * x[2]};
    for (int m = Places::first(k - 1); m < Places::first(k); ++m)
      for (int i = 0; i < 3; ++i) c[kPlaces.raised[m][i]] += along[i] * c[m];
    if (k < 2) continue;
    const Lanes across = q * (static_cast<double>(P - k + 2) / k);
    for (int m = Places::first(k - 2); m < Places::first(k - 1); ++m)
      for (int i = 0; i < 3; ++i) c[kPlaces.raised[kPlaces.raised[m][i]][i]] += across * c[m];
  }
}

template <int P, int D, bool Sized>
void sum_panel(const PanelRequest& panel) {
  constexpr int count = Places::first(D + 1), sizes = Sized ? D + 1 : 0;
  // Sums of sums round less.
  constexpr int block = 16 * kLanes;
  const PanelRule& rule = panel.rule;
  for (int first = 0; first < rule.count; first += block) {
    const int last = first + block < rule.count ? first + block : rule.count;
    Lanes sum[3][count + sizes] = {};
    for (int i = first; i < last; i += kLanes) {
      const Lanes u = load(rule.u + i), v = load(rule.v + i);
      Lanes x[3];
      for (int c = 0; c < 3; ++c) x[c] = panel.a[c] + u * (panel.side[c] + v * panel.base[c]);
      const Lanes r2 = x[0] * x[0] + x[1] * x[1] + x[2] * x[2], q = 1.0 / r2;
      Lanes c[count];
      c[0] = load(rule.weight + i) * panel.area2;
      if constexpr (P == -4) {
        c[0] *= q * q;
      } else {
        const Lanes r = closed_form::batch::root(r2);
        c[0] *= P == 1 ? r : P == -1 ? r * q : r * q * q;
      }
      Lanes size[D + 1];
      if constexpr (Sized) {
        // r^-1 by the same root: sizes need few digits.
        const Lanes inverse = closed_form::batch::root(q);
        size[0] = c[0];
        for (int k = 1; k <= D; ++k) size[k] = size[k - 1] * inverse;
      }
      expand<P, D>(x, q, c);
      const Lanes w = u * v, hats[3] = {1.0 - u, u - w, w};
      for (int k = 0; k < 3; ++k) {
        const Lanes hat = hats[0] * panel.hat[k][0] + hats[1] * panel.hat[k][1] + hats[2] * panel.hat[k][2];
        for (int m = 0; m < count; ++m) sum[k][m] += hat * c[m];
        if constexpr (Sized)
          for (int m = 0; m <= D; ++m) sum[k][count + m] += hat * size[m];
      }
    }
    for (int k = 0; k < 3; ++k) {
      for (int m = 0; m < count; ++m) panel.sums[k * kMostCoefficients + m] += sum_of(sum[k][m]);
      if constexpr (Sized)
        for (int m = 0; m <= D; ++m) panel.sizes[k * (kHighestDegree + 1) + m] += sum_of(sum[k][count + m]);
    }
  }
}

template <int P>
void sum_of_power(const PanelRequest& panel) {
  const auto take = [&]<int D> {
    panel.sizes == nullptr ? sum_panel<P, D, false>(panel) : sum_panel<P, D, true>(panel);
  };
  switch (panel.degree) {
    case 0: return take.template operator()<0>();
    case 1: return take.template operator()<1>();
    case 2: return take.template operator()<2>();
    case 3: return take.template operator()<3>();
    default: return take.template operator()<4>();
  }
}

inline void sum_panel(const PanelRequest& panel) {
  switch (panel.power) {
    case 1: return sum_of_power<1>(panel);
    case -1: return sum_of_power<-1>(panel);
    case -3: return sum_of_power<-3>(panel);
    default: return sum_of_power<-4>(panel);
  }
}

}  // namespace cageproof::fast::triangle::CAGEPROOF_SIMD
