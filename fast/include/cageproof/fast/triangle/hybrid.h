// SPDX-License-Identifier: MIT
// The quickest evaluation of a triangle formula that keeps its promise: the closed form in double nearby, Gauss points
// on panels far away and where the closed form cancels.
#pragma once

#include "cageproof/closed_form/triangle/engine/closed_form.h"
#include "cageproof/fast/triangle/on_points.h"

namespace cageproof::fast::triangle {

using closed_form::Jet;
using closed_form::kTolerance;

/// Below this height over the longest edge the edge form in double may cancel more than is promised, and is asked for
/// its error bound.
inline constexpr double kThinShape = 0.4;
/// On thin triangles, panels of up to so many Gauss points are quicker than the near form and its bound.
inline constexpr int kThinPoints = 3000;
/// Where the near form in double has lost too much, panels of up to so many are quicker than more digits.
inline constexpr int kMostPoints = 12000;

/// A triangle seen from a point, and the moments of formulas there for derivatives up to order O. The triangle and the
/// point must outlive it.
template <int O>
class HybridMoments {
 public:
  HybridMoments(const Triangle<double>& t, const Vec3<double>& eta)
      : algebra_(t, eta), near_(algebra_.frame()), on_panels_(algebra_.frame(), t, eta) {}
  HybridMoments(const HybridMoments&) = delete;
  HybridMoments& operator=(const HybridMoments&) = delete;

  const Frame<double>& frame() const { return algebra_.frame(); }
  PointMoments<O>& algebra() { return algebra_; }
  NearMoments<double, O>& near() { return near_; }
  PanelMoments<O>& on_panels() { return on_panels_; }

 private:
  PointMoments<O> algebra_;
  NearMoments<double, O> near_;
  PanelMoments<O> on_panels_;
};

/// The panels to ask for: the steepest power of the distance, and the most Gauss points; 0 points: as many as for the
/// first request.
template <class F, int O>
PanelsWanted panels_wanted(const Frame<double>& f, int points = 0) {
  constexpr int kPoints = F::far_limit * F::far_limit;
  if (points == 0) points = f.shape() < kThinShape ? std::max(kPoints, kThinPoints) : kPoints;
  return {std::abs(F::far_power) + O + F::extra, points};
}

/// How the formula is computed at a point.
enum class Route {
  ClosedForm,  ///< in more digits: double loses too much there, or the input is extreme
  Border,      ///< the closed form, too: the point is on the border, where it has limits
  Near,        ///< the near form in double
  Tracked,     ///< the same, within the bound of its error
  Panels,      ///< Gauss points
};

/// A result, or none where the closed form with more digits is to be taken.
template <class F>
struct Hybrid {
  Route route;
  std::optional<Jet<double, F::components>> jet = {};

  explicit Hybrid(Route taken = Route::ClosedForm) : route(taken) {}
  Hybrid(Route taken, const Jet<double, F::components>& result) : route(taken), jet(result) {}
  /// A result with a bound, where that is at most `tolerance`, relative to each tensor.
  Hybrid(Route taken, const BoundedJet<double, F::components>& result, double tolerance = kTolerance) : Hybrid() {
    if (result.worst() <= tolerance) *this = {taken, result.jet};
  }
};

/// A result from Gauss points. \pre panels are not empty
template <class F, int O>
Hybrid<F> from_panels(HybridMoments<O>& at, const Panels& panels, std::span<const double> parameters) {
  const Frame<double>& f = at.frame();
  if constexpr (F::cancels_far && O > 0) return {Route::Panels, tracked_on_panels<F, O>(f, parameters, panels)};
  else
    return {Route::Panels,
            finish<F, O, double>(composed<F, O, double>(at.on_panels().template moments<F>(panels), parameters), f.unit,
                                 3)};
}

/// The size of a formula's terms in its derivatives of an order, 0 for values, in the longest edge's units, next to
/// points where they add up to zero; 0 where none vanish.
template <class F>
constexpr double size_of_terms(int order) {
  if constexpr (requires { F::terms_of_value; })
    if (order == 0) return F::terms_of_value;
  if constexpr (requires { F::terms_of_gradient; })
    if (order == 1) return F::terms_of_gradient;
  if constexpr (requires { F::terms_of_hessian; })
    if (order == 2) return F::terms_of_hessian;
  return 0;
}

/// Whether values or derivatives, in the frame's units, are much smaller than their terms: next to a zero.
template <class F, int O>
bool is_small(const Components<F, double, O>& components) {
  for (int order = 0; order <= O; ++order) {
    if (size_of_terms<F>(order) == 0) continue;
    double largest = 0;
    for (const auto& polynomial : components)
      for (int m = 0; m < Monomials<O>::count; ++m)
        if (const auto& e = Monomials<O>::exponents[m]; e[0] + e[1] + e[2] == order)
          largest = std::max(largest, std::abs(polynomial.c[m]));
    if (largest < size_of_terms<F>(order) / 32) return true;
  }
  return false;
}

/// In double, at a point whose moments other formulas may share; the result does not depend on which do.
template <class F, int O>
Hybrid<F> hybrid(HybridMoments<O>& at, std::span<const double> parameters) {
  const Frame<double>& f = at.frame();
  if (f.extreme) return Hybrid<F>();
  if (closed_form::triangle::first_divergent<F>(f) < 3) return Hybrid<F>(Route::Border);
  const Panels& few = at.on_panels().panels(panels_wanted<F, O>(f));
  if (!few.empty()) return from_panels<F>(at, few, parameters);
  double tolerance = kTolerance;
  if (!F::cancels_nearby && f.shape() >= kThinShape) {
    const auto components = composed<F, O, double>(at.near().template near<F>(), parameters);
    if (!is_small<F, O>(components)) return {Route::Near, finish<F, O, double>(components, f.unit, 3)};
    // Small values of two faces whose large ones cancel are what a cage's sum is made of: a thin cage needs their
    // digits.
    tolerance = closed_form::kAccurateTolerance;
  }
  constexpr double largest = std::numeric_limits<double>::max();
  Hybrid<F> near{Route::Tracked,
                 closed_form::triangle::tracked_near<F, double, O>(at.algebra(), parameters, 3, largest), tolerance};
  if (near.jet) return near;
  const Panels& many = at.on_panels().panels(panels_wanted<F, O>(f, kMostPoints));
  return many.empty() ? Hybrid<F>() : from_panels<F>(at, many, parameters);
}

}  // namespace cageproof::fast::triangle
