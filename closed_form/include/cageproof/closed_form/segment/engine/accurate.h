// SPDX-License-Identifier: MIT
// The evaluation of a segment formula that states its error, and reaches its digits whatever cancels.
#pragma once

#include "cageproof/closed_form/segment/engine/closed_form.h"
#include "cageproof/closed_form/segment/engine/tracked_frame.h"

namespace cageproof::closed_form::segment {

/// 128 units of double: half of what is promised, since running bounds are themselves rounded.
inline constexpr double kAccurateTolerance = 128 * 0x1p-53;

/// A jet in double, and a bound of each order's relative error, norm-wise over its finite entries; zero where all of
/// them are exact.
template <int C>
struct BoundedJet {
  Jet<double, C, 2> jet;
  std::array<double, 3> bound{0, 0, 0};

  double worst() const { return std::max({bound[0], bound[1], bound[2]}); }
};

/// Calls it with each entry of an order of all jets.
template <int C, class Visit, class... R>
void for_each_entry(int order, Visit&& visit, const Jet<R, C, 2>&... jets) {
  for (int c = 0; c < C; ++c) {
    if (order == 0) visit(jets.value[c]...);
    for (int i = 0; i < 2; ++i) {
      if (order == 1) visit(jets.gradient[c][i]...);
      for (int j = 0; order == 2 && j < 2; ++j) visit(jets.hessian[c](i, j)...);
    }
  }
}

/// An error over a size that may both be zero; nothing is stated, one, where it is not below one.
inline double as_bound(double error, double size) {
  if (error == 0) return 0;
  const double bound = error / size;
  return bound < 1 ? bound : 1;
}

/// A tracked jet rounded, with its bound. \param factor that bounds are multiplied with
template <int O, int C>
BoundedJet<C> bounded(const Jet<Tracked<double>, C, 2>& from, double factor) {
  BoundedJet<C> result;
  for (int c = 0; c < C; ++c) {
    result.jet.value[c] = from.value[c].value;
    for (int i = 0; i < 2; ++i) {
      result.jet.gradient[c][i] = from.gradient[c][i].value;
      for (int j = 0; j < 2; ++j) result.jet.hessian[c](i, j) = from.hessian[c](i, j).value;
    }
  }
  for (int o = 0; o <= O; ++o) {
    double size = 0, error = 0;
    for_each_entry(
        o,
        [&](const Tracked<double>& x) {
          size = std::hypot(size, x.value);
          error = std::hypot(error, x.error);
        },
        from);
    result.bound[o] = as_bound(factor * unit_roundoff<double>() * error, size);
  }
  return result;
}

/// In 200 digits, rounded. They are as good as what 100 digits are off by, twice as many digits before that: all but
/// where a hundred have cancelled.
template <class F, int O>
BoundedJet<F::components> confirmed(const Segment<double>& s, const Vec3<double>& eta,
                                    std::span<const double> parameters, bool finite_part) {
  const auto in = [&]<class R>(R) {
    const FarFrame<R> frame({convert<R>(s[0]), convert<R>(s[1])}, convert<R>(eta));
    return jet_at<F, O>(frame, parameters, finite_part);
  };
  const auto wide = in(Mp200());
  const auto narrow = in(Mp100());
  BoundedJet<F::components> result;
  result.jet = narrowed<double>(wide);
  for (int o = 0; o <= O; ++o) {
    Mp200 size = 0, error = 0;
    bool same_kind = true;
    for_each_entry(
        o,
        [&](const Mp200& x, const Mp100& y) {
          same_kind = same_kind && isfinite(x) == isfinite(y);
          if (!isfinite(x) || !isfinite(y)) return;
          const Mp200 off = x - Mp200(y);
          size += x * x;
          error += off * off;
        },
        wide, narrow);
    // A rounding of the result, and as much for denormal entries beside normal ones.
    if (!same_kind) result.bound[o] = 1;
    else if (size != 0) result.bound[o] = as_bound(static_cast<double>(Mp200(sqrt(Mp200(error / size)))) + 0x1p-52, 1);
    else result.bound[o] = error == 0 ? 0 : 1;
  }
  return result;
}

/// A single formula at a single point: every order to kAccurateTolerance relative to its norm, also where the problem
/// itself is ill-posed, with a bound of the error. In double, which carries the bound along; where that is too large,
/// or numbers leave double's range, in 200 digits. Arguments as closed_form's. \param finite_part Batch::finite_part
template <class F, int O>
BoundedJet<F::components> accurate(const Segment<double>& s, const Vec3<double>& eta,
                                   std::span<const double> parameters = {}, bool finite_part = false) {
  const FarFrame<double> frame(s, eta);
  if (!leaves_range(s, eta, frame)) {
    const FarFrame<Tracked<double>> tracked(frame);
    // Gauss points are as many as make their rule good to a quarter of a rounding of the terms, each of which has been
    // rounded at least once in the bound: where terms cancel, both grow.
    auto result = bounded<O>(jet_at<F, O>(tracked, parameters, finite_part), frame.is_for_sums() ? 1.25 : 1);
    if (result.worst() <= kAccurateTolerance) return result;
  }
  return confirmed<F, O>(s, eta, parameters, finite_part);
}

}  // namespace cageproof::closed_form::segment
