// SPDX-License-Identifier: MIT
// The closed form of a triangle formula, in the first arithmetic whose error bound is small enough.
#pragma once

#include "cageproof/closed_form/arithmetic/climb.h"
#include "cageproof/closed_form/triangle/engine/border.h"

namespace cageproof::closed_form::triangle {

/// The near form in the first arithmetic of the ladder whose bound is at most `tolerance`, else in the last. Orders
/// without a limit are NaN or infinite (border.h, diverging_weights). \param frame in any type, with exact zeros
/// \param largest as of bounded()
template <class F, int O, class... T, class R, class Moments, Scalar S>
BoundedJet<S, F::components> climbed(Ladder<T...> ladder, const Frame<R>& frame, Moments& at,
                                     std::span<const S> parameters, bool finite_part, ErrorOf<S> tolerance,
                                     double largest = std::numeric_limits<double>::infinity()) {
  int limit = first_divergent<F>(frame);
  if (limit == 0 && finite_part) limit = 1;
  if constexpr (F::diverges_on_triangle)
    if (limit < 3) return {diverging_weights<F, O, S>(frame)};
  auto result = climb(
      ladder, [&]<class In>() { return tracked_near<F, In, O>(at, parameters, limit, largest); },
      [&](const auto& found) { return found.worst() <= tolerance; });
  set_infinities<F, O>(at, parameters, limit, result.jet);
  return result;
}

/// The ladder of results in double, after the arithmetics given. Next to entries that leave double's range, and far
/// from triangles that are as small as doubles can be, forms cancel by more than 400 digits.
template <class... Narrower>
using DoublesLadder = Ladder<Narrower..., Mp200, Mp400, Mp2000>;

/// In double, at a point whose moments other formulas may share; the result does not depend on which do.
/// \param finite_part Batch::finite_part \param tolerance of the relative error of each order
/// \param largest finite number of the type that the result is narrowed to
/// \return value and derivatives up to order O with a bound of their error; NaN or infinite without a limit
template <class F, int O>
BoundedJet<double, F::components> bounded_form(PointMoments<O>& at, std::span<const double> parameters,
                                               bool finite_part, double tolerance,
                                               double largest = std::numeric_limits<double>::max()) {
  if (at.frame().extreme) {
    const auto wide = widened<F, double, Mp200>(parameters);
    return rounded(climbed<F, O>(DoublesLadder<>(), at.wide().template tracked<Mp200>().frame(), at.wide(),
                                 std::span<const Mp200>(wide), finite_part, tolerance, largest));
  }
  return climbed<F, O>(DoublesLadder<double, DoubleDouble>(), at.frame(), at, parameters, finite_part, tolerance,
                       largest);
}

/// In multiprecision: all of `digits` (50, 100 or 200) digits, unless more than 2000 would be needed for them.
template <class F, int O>
BoundedJet<Mp200, F::components> bounded_form(WideMoments<O>& at, std::span<const Mp200> parameters, bool finite_part,
                                              int digits) {
  // One unit of the last digit for rounding the result, and one for the bound of the wider arithmetic.
  const ErrorOf<Mp200> tolerance = 2 * std::pow(10.0L, -digits);
  const auto in = [&](auto ladder) {
    return climbed<F, O>(ladder, at.template tracked<Mp200>().frame(), at, parameters, finite_part, tolerance);
  };
  if (digits <= 50) return in(Ladder<Mp100, Mp200, Mp400, Mp2000>());
  if (digits <= 100) return in(Ladder<Mp200, Mp400, Mp2000>());
  return in(Ladder<Mp400, Mp2000>());
}

/// The closed form of a single formula at a single point. Units and limits: at the formula.
/// \param t corners, counter-clockwise seen from outside \param eta the point \param parameters F::parameter_count of
/// them \return value and derivatives up to order O, in double to kTolerance, in multiprecision to all digits; float's
/// are double's, rounded; NaN or infinite without a limit
template <class F, int O, Scalar R>
Jet<R, F::components> closed_form(const Triangle<R>& t, const Vec3<R>& eta, std::span<const R> parameters,
                                  bool finite_part = false) {
  using W = std::conditional_t<is_multiprecision<R>, Mp200, double>;
  const Triangle<W> corners{convert<W>(t[0]), convert<W>(t[1]), convert<W>(t[2])};
  const Vec3<W> point = convert<W>(eta);
  const auto wide = widened<F, R, W>(parameters);
  const std::span<const W> given(wide);
  if constexpr (is_multiprecision<R>) {
    WideMoments<O> at(corners, point);
    return narrowed<R>(bounded_form<F, O>(at, given, finite_part, std::numeric_limits<R>::digits10).jet);
  } else {
    PointMoments<O> at(corners, point);
    return narrowed<R>(bounded_form<F, O>(at, given, finite_part, kTolerance, std::numeric_limits<R>::max()).jet);
  }
}

/// The closed form in double, every order to kAccurateTolerance relative to its norm, also where the problem itself is
/// ill-posed, with the bound of the error.
template <class F, int O>
BoundedJet<double, F::components> accurate(const Triangle<double>& t, const Vec3<double>& eta,
                                           std::span<const double> parameters, bool finite_part = false) {
  PointMoments<O> at(t, eta);
  return bounded_form<F, O>(at, parameters, finite_part, kAccurateTolerance);
}

}  // namespace cageproof::closed_form::triangle
