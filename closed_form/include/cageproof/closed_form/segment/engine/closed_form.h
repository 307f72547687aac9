// SPDX-License-Identifier: MIT
// The closed form of a segment formula, in the first arithmetic whose error bound is small enough.
#pragma once

#include "cageproof/closed_form/arithmetic/climb.h"
#include "cageproof/closed_form/segment/engine/bounded.h"
#include "cageproof/closed_form/segment/engine/kernel.h"
#include "cageproof/closed_form/segment/engine/tracked_frame.h"

#include <optional>
#include <tuple>

namespace cageproof::closed_form::segment {

/// A segment seen from a point in multiprecision, in numbers with bounds of their errors; formulas at a point share it.
class WideFrames {
 public:
  WideFrames(const Segment<Mp200>& s, const Vec3<Mp200>& eta) : s_(s), eta_(eta) {}

  /// \tparam T Mp100, Mp200, Mp400 or Mp2000
  template <class T>
  const Frame<Tracked<T>>& tracked() {
    auto& frame = std::get<std::optional<Frame<Tracked<T>>>>(frames_);
    if (frame) return *frame;
    using W = std::conditional_t<(std::numeric_limits<T>::digits10 > 200), T, Mp200>;
    const auto in = [](const Vec3<Mp200>& v) { return Vec3<W>(W(v[0]), W(v[1]), W(v[2])); };
    return frame.emplace(ExactSegmentIn<W>({in(s_[0]), in(s_[1])}, in(eta_)));
  }

 private:
  Segment<Mp200> s_;
  Vec3<Mp200> eta_;
  std::tuple<std::optional<Frame<Tracked<Mp100>>>, std::optional<Frame<Tracked<Mp200>>>,
             std::optional<Frame<Tracked<Mp400>>>, std::optional<Frame<Tracked<Mp2000>>>>
      frames_;
};

/// A segment and a point in doubles, seen in double and in multiprecision.
class PointFrames {
 public:
  PointFrames(const Segment<double>& s, const Vec3<double>& eta)
      : frame_(s, eta),
        is_in_range_(!leaves_range(s, eta, frame_)),
        wide_(Segment<Mp200>{convert<Mp200>(s[0]), convert<Mp200>(s[1])}, convert<Mp200>(eta)) {}

  /// Whether the frame in double has a bound of its error.
  bool is_in_range() const { return is_in_range_; }
  /// \tparam T double, \pre is_in_range(), or a type of WideFrames::tracked
  template <class T>
  const Frame<Tracked<T>>& tracked() {
    if constexpr (is_multiprecision<T>) {
      return wide_.tracked<T>();
    } else {
      if (!tracked_) tracked_.emplace(frame_);
      return *tracked_;
    }
  }

 private:
  Frame<double> frame_;
  bool is_in_range_;
  std::optional<Frame<Tracked<double>>> tracked_;
  WideFrames wide_;
};

/// The formula in the first arithmetic of the ladder whose bound is at most `tolerance`, else in the last.
template <class F, int O, class... T, class Frames, cageproof::Scalar S>
BoundedJet<S, F::components, 2> climbed(Ladder<T...> ladder, Frames& at, std::span<const S> parameters,
                                        bool finite_part, ErrorOf<S> tolerance,
                                        double largest = std::numeric_limits<double>::max()) {
  return climb(
      ladder,
      [&]<class In>() {
        return bounded<O, S, In>(jet_at<F, O>(at.template tracked<In>(), parameters, finite_part), largest);
      },
      [&](const auto& found) { return found.worst() <= tolerance; });
}

/// In double, at a point whose frames other formulas may share; the result does not depend on which do.
/// \param finite_part Batch::finite_part \param tolerance of the relative error of each order
/// \param largest finite number of the type that the result is narrowed to
/// \return value and derivatives up to order O with a bound of their error; NaN or infinite without a limit
template <class F, int O>
BoundedJet<double, F::components, 2> bounded_form(PointFrames& at, std::span<const double> parameters, bool finite_part,
                                                  double tolerance,
                                                  double largest = std::numeric_limits<double>::max()) {
  if (at.is_in_range())
    return climbed<F, O>(Ladder<double, Mp100, Mp200, Mp2000>(), at, parameters, finite_part, tolerance, largest);
  return climbed<F, O>(Ladder<Mp100, Mp200, Mp2000>(), at, parameters, finite_part, tolerance, largest);
}

/// In multiprecision: all of `digits` (50, 100 or 200) digits, unless more than 2000 would be needed for them.
template <class F, int O>
BoundedJet<Mp200, F::components, 2> bounded_form(WideFrames& at, std::span<const Mp200> parameters, bool finite_part,
                                                 int digits) {
  const ErrorOf<Mp200> tolerance = 2 * std::pow(10.0L, -digits);
  const auto in = [&](auto ladder) { return climbed<F, O>(ladder, at, parameters, finite_part, tolerance); };
  if (digits <= 50) return in(Ladder<Mp100, Mp200, Mp400, Mp2000>());
  if (digits <= 100) return in(Ladder<Mp200, Mp400, Mp2000>());
  return in(Ladder<Mp400, Mp2000>());
}

/// The closed form of a single formula at a single point. Units and limits: at the formula.
/// \param s ends, the outward normal to the right of s0 -> s1; third coordinates are ignored \param eta the point
/// \param parameters the formula's, in the catalogue's order
/// \return value and derivatives up to order O, in double to kTolerance, in multiprecision to all digits; float's are
/// double's, rounded; NaN or infinite without a limit
template <class F, int O, cageproof::Scalar R>
Jet<R, F::components, 2> closed_form(const Segment<R>& s, const Vec3<R>& eta, std::span<const R> parameters = {},
                                     bool finite_part = false) {
  using W = std::conditional_t<is_multiprecision<R>, Mp200, double>;
  const std::vector<W> wide(parameters.begin(), parameters.end());
  const std::span<const W> given(wide);
  const Segment<W> ends{convert<W>(s[0]), convert<W>(s[1])};
  if constexpr (is_multiprecision<R>) {
    WideFrames at(ends, convert<W>(eta));
    return narrowed<R>(bounded_form<F, O>(at, given, finite_part, std::numeric_limits<R>::digits10).jet);
  } else {
    PointFrames at(ends, convert<W>(eta));
    return narrowed<R>(bounded_form<F, O>(at, given, finite_part, kTolerance, std::numeric_limits<R>::max()).jet);
  }
}

/// The closed form in double, every order to kAccurateTolerance relative to its norm, also where the problem itself is
/// ill-posed, with the bound of the error.
template <class F, int O>
BoundedJet<double, F::components, 2> accurate(const Segment<double>& s, const Vec3<double>& eta,
                                              std::span<const double> parameters = {}, bool finite_part = false,
                                              double largest = std::numeric_limits<double>::max()) {
  PointFrames at(s, eta);
  return bounded_form<F, O>(at, parameters, finite_part, kAccurateTolerance, largest);
}

}  // namespace cageproof::closed_form::segment
