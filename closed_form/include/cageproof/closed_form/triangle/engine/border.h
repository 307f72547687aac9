// SPDX-License-Identifier: MIT
// Results of a closed form on the triangle's border, where derivatives, or even the value, may have no limit.
#pragma once

#include "cageproof/closed_form/triangle/engine/limits.h"
#include "cageproof/closed_form/triangle/engine/point_moments.h"

namespace cageproof::closed_form::triangle {

/// On the border, the first order without a limit. `without` and `with` have its entries with EdgeForm's `border_log` 0
/// and 1; an entry's difference is the factor of its logarithm of the distance, if it has one.
template <class F, int O, Scalar S>
struct Logarithms {
  int order;
  Jet<S, F::components> without, with;
  S noise;  ///< differences up to this are rounding

  /// \tparam T the arithmetic, with S's digits
  template <class T, class Moments>
  static Logarithms in(Moments& at, std::span<const S> parameters, int limit) {
    const auto tracked = tracked_parameters<F, T>(parameters);
    auto& moments = at.template tracked<T>();
    const auto jet = [&](const Components<F, Tracked<T>, O>& components) {
      return bounded<F, O, S, T>(components, S(at.unit()), 3, std::numeric_limits<double>::infinity()).jet;
    };
    return {limit, jet(composed<F, O, Tracked<T>>(moments.template near<F>(), tracked)),
            jet(near_components<F, O, Tracked<T>>(moments.frame(), tracked, Tracked<T>(1)))};
  }

  Logarithms(int limit, const Jet<S, F::components>& finite, const Jet<S, F::components>& moved)
      : order(limit), without(finite), with(moved) {
    using std::abs, std::max;
    S size = 0;
    for_each([&size](const S&, const S& x) { size = max(size, S(abs(x))); }, without, with);
    noise = 64 * unit_roundoff<S>() * size;
  }

  /// Calls `visit` for each entry of that order, with the entry of each jet.
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

  /// Returns infinities with the logarithm's sign for entries that have one, and zero for others.
  Jet<S, F::components> infinities() const {
    using std::abs;
    Jet<S, F::components> signs = without;
    const auto sign = [this](S& x, const S& moved) {
      const S factor = moved - x;
      x = S(factor > 0 ? 1 : -1);
      x = abs(factor) > noise ? S(x * std::numeric_limits<S>::infinity()) : S(0);
    };
    for_each(sign, signs, with);
    return signs;
  }

  /// Whether rounding may hide the logarithm of an entry.
  bool is_doubtful() const {
    using std::abs;
    bool doubtful = false;
    const auto look = [&](const S& x, const S& moved) { doubtful = doubtful || !(abs(moved - x) > noise); };
    for_each(look, without, with);
    return doubtful;
  }
};

/// Sets the entries of the first order without a limit, on the border. Entries that diverge like minus the logarithm of
/// the distance become infinite with the sign of its factor; others are the limit from inside where there is one, else
/// NaN. A factor may be as small as the tilt of a face against an axis, so factors that double cannot tell from zero
/// are computed in 200 digits, where factors below about 1e-198 of the largest count as zero.
template <class F, int O, Scalar S, class Moments>
void set_infinities(Moments& at, std::span<const S> parameters, int limit, Jet<S, F::components>& jet) {
  if constexpr (F::on_border != OnBorder::NoLimit && F::border_order <= O) {
    if (limit > O) return;
    using T = std::conditional_t<is_multiprecision<S>, Mp200, double>;
    const auto logarithms = Logarithms<F, O, S>::template in<T>(at, parameters, limit);
    Jet<S, F::components> infinite = logarithms.infinities();
    if constexpr (std::same_as<S, double>)
      if (logarithms.is_doubtful()) {
        const auto wide = widened<F, double, Mp200>(parameters);
        const std::span<const Mp200> given(wide);
        infinite = narrowed<double>(Logarithms<F, O, Mp200>::template in<Mp200>(at.wide(), given, limit).infinities());
      }
    const auto set = [](S& x, const S& without, const S& infinity) {
      if (infinity != 0) x = infinity;
      else if (F::on_border == OnBorder::Logarithm) x = without;
    };
    logarithms.for_each(set, jet, logarithms.without, infinite);
  }
}

}  // namespace cageproof::closed_form::triangle
