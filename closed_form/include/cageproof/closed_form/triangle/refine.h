// SPDX-License-Identifier: MIT
// The edge form with a bound of its own error, in as many digits as that bound asks for.
#pragma once

#include "cageproof/closed_form/triangle/evaluate.h"

namespace cageproof::closed_form {

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
  Components<F, double, O> plain;
  std::array<double, 3> size{}, error{};
  for (int c = 0; c < F::components; ++c)
    for (int m = 0; m < Monomials<O>::count; ++m) {
      const auto& e = Monomials<O>::exponents[m];
      const int order = e[0] + e[1] + e[2], factor = derivative_factor<O>(m);
      const Tracked<T>& x = from[c].c[m];
      plain[c].c[m] = static_cast<double>(x.value);
      // A mixed derivative stands for two entries of the Hessian.
      const double weight = order == 2 && factor == 1 ? 2 : factor * factor;
      size[order] += weight * plain[c].c[m] * plain[c].c[m];
      error[order] += weight * x.error * x.error;
    }
  BoundedJet<F::components> result;
  result.jet = finish<F, O, double>(plain, unit, limit);
  for (int o = 0; o <= O && o < limit; ++o) {
    const double rounding = std::same_as<T, double> ? 0 : std::numeric_limits<double>::epsilon() / 2;
    result.bound[o] = error[o] == 0 ? rounding : roundoff_of<T>() * std::sqrt(error[o] / size[o]) + rounding;
    if (!(result.bound[o] < 1)) result.bound[o] = 1;
  }
  return result;
}

/// Parameters as exact tracked numbers.
template <class T>
std::vector<Tracked<T>> tracked_parameters(std::span<const double> parameters) {
  return {parameters.begin(), parameters.end()};
}

/// The edge form in double, with its bound. \param limit the first order without a limit here
template <class F, int O>
BoundedJet<F::components> tracked_in_double(const Frame<double>& frame, std::span<const double> parameters, int limit) {
  const auto tracked = tracked_parameters<double>(parameters);
  return bounded<F, O, double>(near_components<F, O>(Frame<Tracked<double>>(frame), std::span<const Tracked<double>>(tracked)),
                               frame.unit, limit);
}

/// The far form in double, n points a side, with its bound.
template <class F, int O>
BoundedJet<F::components> tracked_far(const Frame<double>& frame, std::span<const double> parameters, int n) {
  const auto tracked = tracked_parameters<double>(parameters);
  const Frame<Tracked<double>> wide(frame);
  return bounded<F, O, double>(far_components<F, O>(wide, n, std::span<const Tracked<double>>(tracked)), frame.unit, 3);
}

/// The edge form in pairs of doubles, then in 200 digits, until every order's bound is at most `tolerance`; geometry from 200 digits.
/// \param unit of the frame in double, a power of two \param limit the first order without a limit here
template <class F, int O>
BoundedJet<F::components> refined(const Triangle<double>& t, const Vec3<double>& eta, std::span<const double> parameters,
                                  double unit, double tolerance, int limit) {
  Triangle<Mp200> corners;
  for (int i = 0; i < 3; ++i) corners[i] = convert<Mp200>(t[i]) / Mp200(unit);
  const Frame<Mp200> frame(corners, Vec3<Mp200>(convert<Mp200>(eta) / Mp200(unit)));
  const auto run = [&]<class T>() {
    const auto tracked = tracked_parameters<T>(parameters);
    return bounded<F, O, T>(near_components<F, O>(Frame<Tracked<T>>(frame), std::span<const Tracked<T>>(tracked)), unit, limit);
  };
  const BoundedJet<F::components> pairs = run.template operator()<TwoDoubles>();
  return pairs.worst() <= tolerance ? pairs : run.template operator()<Mp200>();
}

}  // namespace cageproof::closed_form
