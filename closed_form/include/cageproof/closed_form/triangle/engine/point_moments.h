// SPDX-License-Identifier: MIT
// The frame and the moments that formulas on one triangle share at one point, in each arithmetic that one of them
// climbs to.
#pragma once

#include "cageproof/closed_form/triangle/engine/bounded.h"
#include "cageproof/closed_form/triangle/engine/exact_frame.h"

#include <memory>
#include <optional>
#include <tuple>

namespace cageproof::closed_form::triangle {

/// The near forms in one arithmetic, each made when a formula first asks for it. The frame must outlive them.
template <class R, int O>
class NearMoments {
 public:
  explicit NearMoments(const Frame<R>& frame) : frame_(frame) {}

  template <class F>
  const NearForm<F, R, O>& near() {
    auto& form = std::get<std::optional<NearForm<F, R, O>>>(forms_);
    if (!form) form.emplace(frame_);
    return *form;
  }

 private:
  const Frame<R>& frame_;
  // For formulas with no, one and two extra derivatives, and for even powers.
  std::tuple<std::optional<EdgeForm<R, O, O>>, std::optional<EdgeForm<R, O + 1, O>>,
             std::optional<EdgeForm<R, O + 2, O + 1>>, std::optional<EvenForm<R, O>>>
      forms_;
};

/// A frame whose numbers know their errors, and its near forms.
template <class T, int O>
class TrackedMoments {
 public:
  template <class From>
  explicit TrackedMoments(const From& geometry) : frame_(geometry), near_(frame_) {}
  TrackedMoments(const TrackedMoments&) = delete;
  TrackedMoments& operator=(const TrackedMoments&) = delete;

  const Frame<Tracked<T>>& frame() const { return frame_; }
  template <class F>
  const NearForm<F, Tracked<T>, O>& near() {
    return near_.template near<F>();
  }

 private:
  Frame<Tracked<T>> frame_;
  NearMoments<Tracked<T>, O> near_;
};

/// A triangle seen from a point in multiprecision, and the moments of formulas there for derivatives up to order O,
/// with bounds of their errors. Lives on the stack of one thread.
template <int O>
class WideMoments {
 public:
  WideMoments(const Triangle<Mp200>& t, const Vec3<Mp200>& eta) : t_(t), eta_(eta) {}
  WideMoments(const WideMoments&) = delete;
  WideMoments& operator=(const WideMoments&) = delete;

  /// \tparam T Mp100, Mp200, Mp400 or Mp2000
  template <class T>
  TrackedMoments<T, O>& tracked() {
    if constexpr (std::same_as<T, Mp2000>) {
      if (!widest_) widest_ = std::make_unique<TrackedMoments<Mp2000, O>>(exact_in<Mp2000>());
      return *widest_;
    } else {
      auto& moments = std::get<std::optional<TrackedMoments<T, O>>>(tracked_);
      if (moments) return *moments;
      if constexpr (std::same_as<T, Mp400>) return moments.emplace(exact_in<Mp400>());
      if (!exact_) exact_.emplace(t_, eta_);
      return moments.emplace(*exact_);
    }
  }
  /// The unit of the moments: the caller's lengths are theirs times this.
  Mp200 unit() const { return 1; }

 private:
  template <class W>
  ExactTriangleIn<W> exact_in() const {
    const auto wider = [](const Vec3<Mp200>& v) { return Vec3<W>(W(v[0]), W(v[1]), W(v[2])); };
    return ExactTriangleIn<W>({wider(t_[0]), wider(t_[1]), wider(t_[2])}, wider(eta_));
  }

  Triangle<Mp200> t_;
  Vec3<Mp200> eta_;
  std::optional<ExactTriangle> exact_;
  std::tuple<std::optional<TrackedMoments<Mp100, O>>, std::optional<TrackedMoments<Mp200, O>>,
             std::optional<TrackedMoments<Mp400, O>>>
      tracked_;
  // Too large for the stack.
  std::unique_ptr<TrackedMoments<Mp2000, O>> widest_;
};

/// A triangle and a point in doubles, and the moments there in double, double-double and multiprecision. The triangle
/// and the point must outlive it.
template <int O>
class PointMoments {
 public:
  PointMoments(const Triangle<double>& t, const Vec3<double>& eta) : t_(t), eta_(eta), frame_(t, eta) {}
  PointMoments(const PointMoments&) = delete;
  PointMoments& operator=(const PointMoments&) = delete;

  const Frame<double>& frame() const { return frame_; }
  /// The unit of tracked moments in every arithmetic: the caller's lengths are theirs times this. Frame::unit of those
  /// in multiprecision is 1, since wide() has divided the coordinates.
  double unit() const { return frame_.extreme ? 1 : frame_.unit; }
  WideMoments<O>& wide() {
    if (!wide_) {
      const Mp200 unit(this->unit());
      Triangle<Mp200> corners;
      for (int i = 0; i < 3; ++i) corners[i] = convert<Mp200>(t_[i]) / unit;
      wide_.emplace(corners, Vec3<Mp200>(convert<Mp200>(eta_) / unit));
    }
    return *wide_;
  }
  /// \tparam T double, DoubleDouble, or a type of WideMoments::tracked
  template <class T>
  TrackedMoments<T, O>& tracked() {
    if constexpr (is_multiprecision<T>) {
      return wide().template tracked<T>();
    } else {
      auto& moments = std::get<std::optional<TrackedMoments<T, O>>>(tracked_);
      if (moments) return *moments;
      if constexpr (std::same_as<T, DoubleDouble>) {
        if (!frame_.extreme) {
          const Frame<Tracked<T>> from_doubles(frame_, t_, eta_);
          if (heights_are_certain(from_doubles)) return moments.emplace(from_doubles);
        }
        return moments.emplace(wide().template tracked<Mp200>().frame());
      } else {
        return moments.emplace(frame_);
      }
    }
  }

 private:
  const Triangle<double>& t_;
  const Vec3<double>& eta_;
  Frame<double> frame_;
  std::tuple<std::optional<TrackedMoments<double, O>>, std::optional<TrackedMoments<DoubleDouble, O>>> tracked_;
  std::optional<WideMoments<O>> wide_;
};

/// The near form in the arithmetic T, with its bound. \param at PointMoments, or WideMoments for multiprecision
/// \param limit the first order without a limit here \param largest as of bounded()
template <class F, class T, int O, class Moments, Scalar S>
BoundedJet<S, F::components> tracked_near(Moments& at, std::span<const S> parameters, int limit, double largest) {
  const auto tracked = tracked_parameters<F, T>(parameters);
  const auto& moments = at.template tracked<T>().template near<F>();
  return bounded<F, O, S, T>(composed<F, O, Tracked<T>>(moments, tracked), S(at.unit()), limit, largest);
}

}  // namespace cageproof::closed_form::triangle
