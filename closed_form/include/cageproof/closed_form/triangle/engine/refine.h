// SPDX-License-Identifier: MIT
// The near form with a bound of its own error, in as many digits as that bound asks for.
#pragma once

#include "cageproof/closed_form/triangle/engine/point_moments.h"

namespace cageproof::closed_form::triangle {

/// A jet in double, and a bound of each order's relative error, norm-wise over all its entries.
template <int C>
struct BoundedJet {
  Jet<double, C> jet;
  std::array<double, 3> bound{0, 0, 0};

  double worst() const { return std::max({bound[0], bound[1], bound[2]}); }
};

/// The components rounded to double with their error bounds; orders from `limit` on are left out of the bounds.
template <class F, int O, class T>
BoundedJet<F::components> bounded(const Components<F, Tracked<T>, O>& from, const double& unit, int limit) {
  // Squares of what multiprecision holds may leave double's range.
  using Sum = std::conditional_t<is_multiprecision<T>, T, double>;
  const auto squared = [](const Sum& x) { return Sum(x * x); };
  Components<F, double, O> plain;
  std::array<Sum, 3> size{}, error{};
  for (int c = 0; c < F::components; ++c)
    for (int m = 0; m < Monomials<O>::count; ++m) {
      const auto& e = Monomials<O>::exponents[m];
      const int order = e[0] + e[1] + e[2], factor = derivative_factor<O>(m);
      const Tracked<T>& x = from[c].c[m];
      plain[c].c[m] = static_cast<double>(x.value);
      // A mixed derivative stands for two entries of the Hessian.
      const double weight = order == 2 && factor == 1 ? 2 : factor * factor;
      if constexpr (is_multiprecision<T>) {
        size[order] += weight * squared(x.value);
        Sum bound;
        mpfr_set_ld(bound.data(), x.error, MPFR_RNDU);
        error[order] += weight * squared(bound);
      } else {
        size[order] += weight * squared(plain[c].c[m]);
        error[order] += weight * squared(x.error);
      }
    }
  BoundedJet<F::components> result;
  result.jet = finish<F, O, double>(plain, unit, limit);
  for (int o = 0; o <= O && o < limit; ++o) {
    const double rounding = std::same_as<T, double> ? 0 : std::numeric_limits<double>::epsilon() / 2;
    using std::sqrt;
    result.bound[o] = rounding;
    if (error[o] != Sum(0)) result.bound[o] += roundoff_of<T>() * static_cast<double>(Sum(sqrt(error[o] / size[o])));
    if (!(result.bound[o] < 1)) result.bound[o] = 1;
  }
  return result;
}

/// A formula's parameters as exact tracked numbers.
template <class F, class T>
std::array<Tracked<T>, F::parameter_count> tracked_parameters(std::span<const double> parameters) {
  std::array<Tracked<T>, F::parameter_count> tracked;
  for (int i = 0; i < F::parameter_count; ++i) tracked[i] = Tracked<T>(parameters[i]);
  return tracked;
}

/// The near form in the arithmetic T, with its bound. \param limit the first order without a limit here
template <class F, class T, int O>
BoundedJet<F::components> tracked_near(PointMoments<double, O>& at, std::span<const double> parameters, int limit) {
  const auto tracked = tracked_parameters<F, T>(parameters);
  const auto& moments = at.template tracked<T>().template near<F>();
  return bounded<F, O, T>(composed<F, O, Tracked<T>>(moments, tracked), at.unit(), limit);
}

/// The far form in double, n points a side, with its bound.
template <class F, int O>
BoundedJet<F::components> tracked_far(const Frame<double>& frame, std::span<const double> parameters, int n) {
  const auto tracked = tracked_parameters<F, double>(parameters);
  const Frame<Tracked<double>> wide(frame);
  return bounded<F, O, double>(far_components<F, O, Tracked<double>>(wide, n, tracked), frame.unit, 3);
}

/// Gauss points on panels in double, with their bound.
template <class F, int O>
BoundedJet<F::components> tracked_on_panels(const Frame<double>& frame, std::span<const double> parameters,
                                            const Panels& panels) {
  const auto tracked = tracked_parameters<F, double>(parameters);
  const Frame<Tracked<double>> wide(frame);
  const PanelFormOf<F, Tracked<double>, O> moments(wide, panels);
  return bounded<F, O, double>(composed<F, O, Tracked<double>>(moments, tracked), frame.unit, 3);
}

/// The near form in double-double, then in 200 digits, until every order's bound is at most `tolerance`; geometry from
/// 200 digits. \param limit the first order without a limit here
template <class F, int O>
BoundedJet<F::components> refined(PointMoments<double, O>& at, std::span<const double> parameters, double tolerance,
                                  int limit) {
  const auto in_double_double = tracked_near<F, DoubleDouble>(at, parameters, limit);
  return in_double_double.worst() <= tolerance ? in_double_double : tracked_near<F, Mp200>(at, parameters, limit);
}

}  // namespace cageproof::closed_form::triangle
