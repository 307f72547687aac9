// SPDX-License-Identifier: MIT
// Parts that the adaptive rules of flat elements share: the refinement, how far inside they move a point on the
// element, and what they state about their result.
#pragma once

#include "beyond_range.h"
#include "adaptive_limits.h"
#include "cageproof/quadrature_ref/kernel.h"

#include <algorithm>
#include <type_traits>

namespace cageproof::quadrature_ref {

/// float is computed in double, multiprecision in 50 digits.
template <Scalar R>
using AdaptiveScalar =
    std::conditional_t<std::same_as<R, float>, double, std::conditional_t<is_multiprecision<R>, Mp50, R>>;

/// How far inside a point on the element is moved where double's range must hold the kernel, in units of its clearance.
inline constexpr double kInward = 1e-16;

/// The factor by which a node's relative error grows because its coordinate is a length times sinh w. The rounding of w
/// changes a power `degree` of sinh w, relatively, by degree times w as much.
/// \param degree the integral's power of length
template <Scalar W>
W rounding_growth(const W& w, int degree) {
  using std::abs;
  return 1 + abs(w) * std::max(3, degree) / 24;
}

/// The share of the mass found that is added to the difference of two rules of at most fifteen points on an interval of
/// w that is too long for either. Integrands change by e^w and more, so most of one may lie between the last point and
/// the end, where both rules miss it.
template <Scalar W>
W unresolved(const W& length) {
  using std::exp;
  return length > 8 ? W(4 * exp(length / 64)) : W(0);
}

/// Whether sums are next to W's least number, in the frame's unit, so that nodes' shares have errors of that size and
/// no digits can be stated. Or whether heights are, which are a factor of kernels with x.n, and vanish in the element's
/// plane. \param height exact
template <Scalar W>
bool is_lost(const Formula& formula, const Mp200& height, const Result<W>& sums, int order) {
  if constexpr (is_multiprecision<W>) {
    return false;
  } else {
    const W least = std::ldexp(std::numeric_limits<W>::min(), 60);
    if (formula.vanishes_in_plane && height == 0) return false;
    if (formula.vanishes_in_plane && abs(height) < least) return true;
    for (int o = 0; o <= order; ++o)
      if (norm(sums.of(o)) < least) return true;
    return false;
  }
}

/// The integrals over one part of the element.
template <Scalar W>
struct PartSum {
  Result<W> sums{};
  std::array<W, 3> error{};  ///< an order: of the sums, norm-wise
  std::array<W, 3> mass{};   ///< an order: sum of the nodes' tensors in norm, which rounding is relative to
};

/// An integral over parts, and what is known of its error.
template <Scalar W>
class AdaptiveTotal {
 public:
  AdaptiveTotal(const Integrand& integrand, int order) : integrand_(integrand), order_(order) {}

  /// The parts' sum. Its `nodes` also counts those of parts that were divided since.
  const Result<W>& sums() const { return total_; }
  /// Bound of the relative error, norm-wise, the worst order's.
  const W& bound() const { return bound_; }

  /// Bisects parts until the bound meets the tolerance; false when it could not, or would spend more than
  /// kAdaptiveNodeLimit. \param parts each with a PartSum `part` \param nodes_a_part that integrating one spends, at
  /// most \param integrate sets a part's sums (with nodes), errors and masses \param halve makes a part its first half,
  /// and returns the second
  template <class Part, class Integrate, class Halve>
  bool refine(std::vector<Part>& parts, const W& tolerance, std::size_t nodes_a_part, Integrate integrate,
              Halve halve) {
    const auto spend = [&](Part& part) {
      integrate(part);
      nodes_ += part.part.sums.nodes;
    };
    for (Part& part : parts) spend(part);
    for (;;) {
      update(parts);
      if (bound_ <= tolerance) return true;
      if (hopeless(tolerance)) return false;
      const std::size_t count = parts.size();
      for (std::size_t i = 0; i < count; ++i) {
        if (!needs_split(parts[i].part, parts.size(), tolerance)) continue;
        if (nodes_ + 2 * nodes_a_part > kAdaptiveNodeLimit) return update(parts), false;
        Part half = halve(parts[i]);
        spend(parts[i]);
        spend(half);
        parts.push_back(std::move(half));
      }
      if (parts.size() == count) return false;  // the rest is rounding
    }
  }

 private:
  template <class Part>
  void update(const std::vector<Part>& parts) {
    using std::isfinite;
    integrand_.reset(total_, order_);
    bound_ = 0;
    for (int o = 0; o <= order_; ++o) {
      W mass = 0;
      error_[o] = 0;
      for (const Part& part : parts) {
        for (std::size_t k = 0; k < total_.of(o).size(); ++k) total_.of(o)[k] += part.part.sums.of(o)[k];
        error_[o] += part.part.error[o];
        mass += part.part.mass[o];
      }
      size_[o] = norm(total_.of(o));
      // A node's position has an error of a few roundings, its kernel about ten times as much.
      rounding_[o] = 64 * unit_roundoff<W>() * mass;
      if (mass == 0) continue;
      const W bound = (error_[o] + rounding_[o]) / size_[o];
      if (!(bound <= bound_)) bound_ = isfinite(bound) ? bound : std::numeric_limits<W>::infinity();
    }
    total_.nodes = nodes_;
  }

  bool needs_split(const PartSum<W>& part, std::size_t count, const W& tolerance) const {
    const W share = tolerance / (2 * static_cast<double>(count));
    for (int o = 0; o <= order_; ++o)
      if (error_[o] > tolerance * size_[o] / 2 && part.error[o] > share * size_[o]) return true;
    return false;
  }

  // Bisection does not reduce rounding. Returns true if rounding by itself breaks the tolerance, whatever the tensors
  // turn out to be.
  bool hopeless(const W& tolerance) const {
    for (int o = 0; o <= order_; ++o)
      if (!(rounding_[o] <= tolerance * (size_[o] + error_[o]))) return true;
    return false;
  }

  const Integrand& integrand_;
  int order_;
  Result<W> total_;
  std::array<W, 3> size_{}, error_{}, rounding_{};
  W bound_ = 0;
  std::size_t nodes_ = 0;
};

/// The outcome of a refinement.
struct AdaptiveOutcome {
  bool converged;
  double bound;  ///< of the relative error, norm-wise, the worst order's

  /// For a point on the element: compares with the sums from farther inside, to which the sums from nearer must be
  /// equal.
  template <Scalar W>
  void compare(const AdaptiveOutcome& at_farther, const Result<W>& farther, Result<W>& nearer, int order,
               double tolerance) {
    converged = at_farther.converged && converged;
    for (int o = 0; o <= order; ++o) bound = std::max(bound, relative_difference(farther.of(o), nearer.of(o)));
    converged = converged && bound <= tolerance;
    nearer.nodes += farther.nodes;
  }
};

/// Whether the sums' digits meet the tolerance also in the entries within R's range, where others leave it; the
/// outcome's bound is then theirs.
template <Scalar R, Scalar W>
bool meets_within_range(const Result<W>& sums, const Result<R>& result, int order, double tolerance,
                        AdaptiveOutcome& outcome) {
  const double digits = -std::log10(outcome.bound), wanted = -std::log10(tolerance);
  for (int o = 0; o <= order; ++o) {
    const EntrySpread spread = entry_spread(sums.of(o), result.of(o));
    if (!spread.leaves_range()) continue;
    const double left = spread.digits_left(digits);
    if (!(left >= wanted)) return false;
    if (left < digits) outcome.bound = std::max(outcome.bound, std::pow(10, -left));
  }
  return true;
}

/// Integrates off the element, or, where the point lies on it, from two distances inside, which must agree.
/// \param inside whether the point lies on the element (`yes`), and its `clearance` there
/// \param integrate_at (distance inside, sums) sets the sums and returns their AdaptiveOutcome
template <Scalar W, class Contact, class IntegrateAt>
AdaptiveOutcome integrate_off_or_inside(const Contact& inside, int order, double tolerance, IntegrateAt integrate_at,
                                        Result<W>& sums) {
  if (!inside.yes) return integrate_at(Mp200(0), sums);
  AdaptiveOutcome outcome = integrate_at(Mp200(inside.clearance * kInward), sums);
  Result<W> farther;
  const AdaptiveOutcome at_farther = integrate_at(Mp200(inside.clearance * kInward * 100), farther);
  outcome.compare(at_farther, farther, sums, order, tolerance);
  return outcome;
}

/// The digits to ask of the multiprecision evaluation in place of an adaptive one: two more than the tolerance, and at
/// least 12, which tell whether a limit exists.
inline double digits_beyond_tolerance(double tolerance) { return std::max(12., 2 - std::log10(tolerance)); }

/// Sets a result and its statement. Rounding the result to R is part of the error.
/// \param multiprecision sets the result by the multiprecision evaluation; called where some entries leave R's range
/// and the sums have too few digits for those within
template <Scalar R, Scalar W, class Multiprecision>
void set_outcome(const Integrand& integrand, int exponent, const Result<W>& sums, int order, double tolerance,
                 AdaptiveOutcome outcome, Multiprecision multiprecision, Result<R>& result) {
  finish(integrand, exponent, sums, result);
  result.nodes = sums.nodes;
  if (!meets_within_range(sums, result, order, tolerance, outcome)) {
    multiprecision();
    result.nodes += sums.nodes;
    outcome.bound = std::pow(10, -std::fmax(result.stated_digits, 0.));
    outcome.converged = outcome.bound <= tolerance;
  }
  result.converged = outcome.converged;
  const double bound = outcome.bound + static_cast<double>(unit_roundoff<R>());
  result.stated_digits = bound < 0.1 ? -std::log10(bound) : 0;
}

}  // namespace cageproof::quadrature_ref
