// SPDX-License-Identifier: MIT
// The two evaluations of a triangle formula that we stand behind.
#pragma once

#include "cageproof/closed_form/triangle/engine/border.h"
#include "cageproof/closed_form/triangle/engine/refine.h"

namespace cageproof::closed_form::triangle {

/// 128 units of double: half of what is promised, since running bounds are themselves rounded.
inline constexpr double kAccurateTolerance = 128 * 0x1p-53;
/// Below this height over the longest edge the edge form in double may cancel more than is promised, and is asked for
/// its error bound.
inline constexpr double kThinShape = 0.4;
/// Bounds of running errors exceed what happens ten times over and more; results of the fast form that have one are
/// kept below this.
inline constexpr double kFastTolerance = 1000 * 0x1p-53;

/// What a result of `accurate` is good for.
template <int C>
using AccurateJet = BoundedJet<C>;

/// The points a side of the far form in multiprecision, where it takes over.
template <class F, int O, Scalar R>
std::optional<int> multiprecision_far_points(PointMoments<R, O>& at) {
  return far_points_for<F, O>(at.ellipse(), static_cast<double>(unit_roundoff<R>()), kMultiprecisionLimit);
}

/// On thin triangles, panels of up to so many Gauss points are quicker than the near form and its bound.
inline constexpr int kThinPoints = 3000;
/// Where the near form in double has lost too much, panels of up to so many are quicker than more digits.
inline constexpr int kMostPoints = 12000;

/// What closed_form asks of panels first.
template <class F, int O>
PanelsWanted panels_wanted(const Frame<double>& f, int points = 0) {
  constexpr int kPoints = F::far_limit * F::far_limit;
  if (points == 0) points = f.shape() < kThinShape ? std::max(kPoints, kThinPoints) : kPoints;
  return {std::abs(F::far_power) + O + F::extra, points};
}

/// Gauss points on panels, or nothing where more points would be needed; where the sums cancel more than is
/// promised, the near form in more digits. \pre the point is not on the triangle's border
template <class F, int O>
std::optional<Jet<double, F::components>> on_panels(PointMoments<double, O>& at, std::span<const double> parameters,
                                                    const PanelsWanted& wanted) {
  const Panels& panels = at.on_panels().panels(wanted);
  if (panels.empty()) return std::nullopt;
  if constexpr (F::cancels_far && O > 0) {
    auto result = tracked_on_panels<F, O>(at.frame(), parameters, panels);
    if (result.worst() > kFastTolerance) result = refined<F>(at, parameters, kAccurateTolerance, 3);
    return result.jet;
  } else {
    const auto& moments = at.on_panels().template moments<F>(panels);
    return finish<F, O, double>(composed<F, O, double>(moments, parameters), at.frame().unit, 3);
  }
}

/// The fast one, at a point whose moments other formulas may share; the result does not depend on which do. In double:
/// Gauss points on panels, where a few will do, else the near form; on thin triangles, and for formulas that cancel
/// nearby, more points or digits where its own error bound says so; at extreme points what 200
/// digits say. In multiprecision: the near form, up to where it has lost half its digits. \param finite_part
/// Batch::finite_part
template <class F, int O, Scalar R>
Jet<R, F::components> closed_form(PointMoments<R, O>& at, std::span<const R> parameters, bool finite_part) {
  const Frame<R>& f = at.frame();
  if constexpr (std::same_as<R, double>)
    if (f.extreme) {
      const auto wide = widened<F, double, Mp200>(parameters);
      return narrowed<double>(closed_form<F, O, Mp200>(at.beyond(), wide, finite_part));
    }
  int limit = first_divergent<F>(f);
  if (limit == 0 && finite_part) limit = 1;
  if constexpr (F::diverges_on_triangle)
    if (limit < 3) return diverging_weights<F, O, R>(f);
  if constexpr (std::same_as<R, double>) {
    if (limit == 3)
      if (const auto jet = on_panels<F>(at, parameters, panels_wanted<F, O>(f))) return *jet;
    if (F::cancels_nearby || f.shape() < kThinShape) {
      auto result = tracked_near<F, double>(at, parameters, limit);
      if (result.worst() > kFastTolerance) {
        if (limit == 3)
          if (const auto jet = on_panels<F>(at, parameters, panels_wanted<F, O>(f, kMostPoints))) return *jet;
        result = refined<F>(at, parameters, kAccurateTolerance, limit);
      }
      set_infinities<F, O>(at, parameters, limit, result.jet);
      return result.jet;
    }
  } else if (limit == 3) {
    if (const auto n = multiprecision_far_points<F, O>(at))
      return finish<F, O, R>(far_components<F, O, R>(f, *n, parameters), f.unit, limit);
  }
  Jet<R, F::components> jet =
      finish<F, O, R>(composed<F, O, R>(at.moments().template near<F>(), parameters), f.unit, limit);
  set_infinities<F, O>(at, parameters, limit, jet);
  return jet;
}

/// The fast one of a single formula at a single point. Units and limits: at the formula.
/// \param t corners, counter-clockwise seen from outside \param eta the point \param parameters F::parameter_count of
/// them \return value and derivatives up to order O; NaN where a derivative has no limit
template <class F, int O, Scalar R>
Jet<R, F::components> closed_form(const Triangle<R>& t, const Vec3<R>& eta, std::span<const R> parameters,
                                  bool finite_part = false) {
  using W = Working<R>;
  if constexpr (!std::same_as<R, W>) {
    const Triangle<W> wide{convert<W>(t[0]), convert<W>(t[1]), convert<W>(t[2])};
    return narrowed<R>(closed_form<F, O, W>(wide, convert<W>(eta), widened<F>(parameters), finite_part));
  } else {
    PointMoments<R, O> at(t, eta);
    return closed_form<F, O, R>(at, parameters, finite_part);
  }
}

/// `accurate` at an extreme point: the closed form in 200 digits, with its bound. The far form cancels nothing.
template <class F, int O>
AccurateJet<F::components> accurate_beyond(PointMoments<double, O>& at, std::span<const double> parameters,
                                           bool finite_part) {
  PointMoments<Mp200, O>& wide = at.beyond();
  int limit = first_divergent<F>(wide.frame());
  if (limit == 0 && finite_part) limit = 1;
  AccurateJet<F::components> result;
  result.jet = narrowed<double>(closed_form<F, O, Mp200>(wide, widened<F, double, Mp200>(parameters), finite_part));
  if (F::diverges_on_triangle && limit < 3) return result;
  if (limit == 3 && multiprecision_far_points<F, O>(wide)) result.bound.fill(unit_roundoff<double>());
  else result.bound = tracked_near<F, Mp200>(at, parameters, limit).bound;
  return result;
}

/// The careful one, in double: every order to kAccurateTolerance relative to its norm, also where the problem itself is
/// ill-posed, with a bound of the error that the arithmetic carries along. Arguments as closed_form's.
template <class F, int O>
AccurateJet<F::components> accurate(const Triangle<double>& t, const Vec3<double>& eta,
                                    std::span<const double> parameters, bool finite_part = false) {
  PointMoments<double, O> at(t, eta);
  const Frame<double>& f = at.frame();
  if (f.extreme) return accurate_beyond<F, O>(at, parameters, finite_part);
  int limit = first_divergent<F>(f);
  if (limit == 0 && finite_part) limit = 1;
  if constexpr (F::diverges_on_triangle)
    if (limit < 3) return {diverging_weights<F, O, double>(f)};
  const auto n = limit == 3 ? far_points_for<F, O>(at.ellipse(), kFarTolerance) : std::nullopt;
  auto result = n ? tracked_far<F, O>(f, parameters, *n) : tracked_near<F, double>(at, parameters, limit);
  if (result.worst() > kAccurateTolerance) result = refined<F>(at, parameters, kAccurateTolerance, limit);
  set_infinities<F, O>(at, parameters, limit, result.jet);
  return result;
}

}  // namespace cageproof::closed_form::triangle
