// SPDX-License-Identifier: MIT
// What a closed form does on the triangle itself, where derivatives, or even the value, may have no limit.
#pragma once

#include "cageproof/closed_form/triangle/engine/limits.h"
#include "cageproof/closed_form/triangle/engine/point_moments.h"

namespace cageproof::closed_form::triangle {

/// The first order without a limit, on the border: its entries without the logarithm of the distance that some have,
/// and with it, at a distance of one e-th.
template <class F, int O, Scalar R>
struct Logarithms {
  int order;
  Jet<R, F::components> without, with;
  R noise;  ///< what differs by rounding alone

  Logarithms(PointMoments<R, O>& at, std::span<const R> parameters, int limit)
      : order(limit),
        without(finish<F, O, R>(composed<F, O, R>(at.moments().template near<F>(), parameters), at.frame().unit, 3)),
        with(finish<F, O, R>(near_components<F, O>(at.frame(), parameters, R(1)), at.frame().unit, 3)) {
    using std::abs, std::max;
    R size = 0;
    for_each([&size](const R&, const R& moved) { size = max(size, R(abs(moved))); }, without, with);
    noise = 64 * unit_roundoff<R>() * size;
  }

  /// Calls it with each entry of that order of all jets.
  template <class Visit, class... Jets>
  void for_each(Visit&& visit, Jets&... jets) const {
    for (int c = 0; c < F::components; ++c) {
      if (order == 0) visit(jets.value[c]...);
      for (int i = 0; i < 3; ++i) {
        if (order == 1) visit(jets.gradient[c][i]...);
        for (int j = 0; order == 2 && j < 3; ++j) visit(jets.hessian[c](i, j)...);
      }
    }
  }

  /// Infinite, with the logarithm's sign, where an entry has one, else zero.
  Jet<R, F::components> infinities() const {
    using std::abs;
    Jet<R, F::components> signs = without;
    const auto sign = [this](R& x, const R& moved) {
      const R factor = moved - x;
      x = R(factor > 0 ? 1 : -1);
      x = abs(factor) > noise ? R(x * std::numeric_limits<R>::infinity()) : R(0);
    };
    for_each(sign, signs, with);
    return signs;
  }

  /// Whether an entry's logarithm, if it has one, is lost in rounding.
  bool is_doubtful() const {
    using std::abs;
    bool doubtful = false;
    const auto look = [&](const R& x, const R& moved) { doubtful = doubtful || !(abs(moved - x) > noise); };
    for_each(look, without, with);
    return doubtful;
  }
};

/// On the border, at the first order without a limit: where that diverges like minus the logarithm of the distance, its
/// entries become infinite with the sign of the logarithm's factor; entries without one keep the limit from inside
/// where there is one, else NaN. A factor may be as small as the tilt of a face against an axis: those that double
/// cannot tell from zero are taken from 200 digits, which call factors zero below 1e-198 of the largest.
template <class F, int O, Scalar R>
void set_infinities(PointMoments<R, O>& at, std::span<const R> parameters, int limit, Jet<R, F::components>& jet) {
  if constexpr (F::on_border != OnBorder::NoLimit && F::border_order <= O) {
    if (limit > O) return;
    const Logarithms<F, O, R> logarithms(at, parameters, limit);
    Jet<R, F::components> infinite = logarithms.infinities();
    if constexpr (std::same_as<R, double>)
      if (logarithms.is_doubtful()) {
        const auto wide = widened<F, double, Mp200>(parameters);
        infinite = narrowed<double>(Logarithms<F, O, Mp200>(at.beyond(), wide, limit).infinities());
      }
    const auto set = [](R& x, const R& without, const R& infinity) {
      if (infinity != 0) x = infinity;
      else if (F::on_border == OnBorder::Logarithm) x = without;
    };
    logarithms.for_each(set, jet, logarithms.without, infinite);
  }
}

}  // namespace cageproof::closed_form::triangle
