// SPDX-License-Identifier: MIT
// The two evaluations of a triangle formula that we stand behind.
#pragma once

#include "cageproof/closed_form/triangle/refine.h"

namespace cageproof::closed_form {

/// The fast one. In double: far away a few Gauss points, else the edge form; on slivers, where that cancels, the edge form in more digits
/// (mean value: wherever its own error bound says so). In float: the same in double, rounded. In multiprecision: the edge form alone.
template <class F, int O, Scalar R>
Jet<R, F::components> closed_form(const Triangle<R>& t, const Vec3<R>& eta, std::span<const R> parameters,
                                  bool finite_part = false);

/// What a result of `accurate` is good for.
template <int C>
using AccurateJet = BoundedJet<C>;

/// The careful one, in double: every order to `accurate_tolerance` relative to its norm, also where the problem itself is ill-posed, with
/// a bound of the error that the arithmetic carries along.
template <class F, int O>
AccurateJet<F::components> accurate(const Triangle<double>& t, const Vec3<double>& eta, std::span<const double> parameters,
                                    bool finite_part = false);

/// 128 units of double: half of what is promised, since running bounds are themselves rounded.
inline constexpr double accurate_tolerance = 128 * 0x1p-53;
/// What the far form may be wrong by: a quarter of a rounding.
inline constexpr double far_tolerance = 0x1p-55;
/// Below this height over the longest edge the edge form in double may cancel more than is promised, and is asked for its error bound.
inline constexpr double thin_shape = 0.4;
/// Bounds of running errors exceed what happens ten times over and more; results of the fast form that have one are kept below this.
inline constexpr double fast_tolerance = 1000 * 0x1p-53;

template <class F, int O, Scalar R>
Jet<R, F::components> closed_form(const Triangle<R>& t, const Vec3<R>& eta, std::span<const R> parameters, bool finite_part) {
  if constexpr (std::same_as<R, float>) {
    const Triangle<double> wide{convert<double>(t[0]), convert<double>(t[1]), convert<double>(t[2])};
    const std::vector<double> p(parameters.begin(), parameters.end());
    return narrowed<float>(closed_form<F, O, double>(wide, convert<double>(eta), p, finite_part));
  } else {
    const Frame<R> f(t, eta);
    int limit = first_divergent<F>(f);
    if (limit == 0 && finite_part) limit = 1;
    if constexpr (std::same_as<F, MeanValue>)
      if (limit < 3) return diverging_weights<F, O, R>(f);
    if constexpr (std::same_as<R, double>) {
      if (limit == 3)
        if (const auto n = far_points_for<F, O>(f, far_tolerance))
          return finish<F, O, R>(far_components<F, O>(f, *n, parameters), f.unit, limit);
      if (std::same_as<F, MeanValue> || f.shape() < thin_shape) {
        auto result = tracked_in_double<F, O>(f, parameters, limit);
        if (result.worst() > fast_tolerance) result = refined<F, O>(t, eta, parameters, f.unit, accurate_tolerance, limit);
        set_infinities<F, O>(f, parameters, limit, result.jet);
        return result.jet;
      }
    }
    Jet<R, F::components> jet = finish<F, O, R>(near_components<F, O>(f, parameters), f.unit, limit);
    set_infinities<F, O>(f, parameters, limit, jet);
    return jet;
  }
}

template <class F, int O>
AccurateJet<F::components> accurate(const Triangle<double>& t, const Vec3<double>& eta, std::span<const double> parameters,
                                    bool finite_part) {
  const Frame<double> f(t, eta);
  int limit = first_divergent<F>(f);
  if (limit == 0 && finite_part) limit = 1;
  if constexpr (std::same_as<F, MeanValue>)
    if (limit < 3) return {diverging_weights<F, O, double>(f)};
  const auto n = limit == 3 ? far_points_for<F, O>(f, far_tolerance) : std::nullopt;
  auto result = n ? tracked_far<F, O>(f, parameters, *n) : tracked_in_double<F, O>(f, parameters, limit);
  if (result.worst() > accurate_tolerance) result = refined<F, O>(t, eta, parameters, f.unit, accurate_tolerance, limit);
  set_infinities<F, O>(f, parameters, limit, result.jet);
  return result;
}

}  // namespace cageproof::closed_form
