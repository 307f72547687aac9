// SPDX-License-Identifier: MIT
// What formulas on one triangle share at one point: the frame, and every moment that more than one of them may ask for.
#pragma once

#include "cageproof/closed_form/triangle/engine/exact_frame.h"
#include "cageproof/closed_form/triangle/engine/on_points.h"

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

/// Gauss points on panels, each cut when a formula first asks for it: formulas that want as much share them.
template <int O>
class PanelMoments {
 public:
  PanelMoments(const Frame<double>& frame, const Triangle<double>& t, const Vec3<double>& eta)
      : frame_(frame), t_(t), eta_(eta) {}

  /// The panels for a formula's derivatives up to order O; empty where more than `points` points would be needed.
  const Panels& panels(const PanelsWanted& wanted) {
    for (auto& cut : cuts_) {
      if (!cut) return cut.emplace(wanted, cut_to_panels(frame_, t_, eta_, wanted)).panels;
      if (cut->wanted == wanted) return cut->panels;
    }
    return cuts_.back().emplace(wanted, cut_to_panels(frame_, t_, eta_, wanted)).panels;
  }
  /// The moments on these panels.
  template <class F>
  const PanelFormOf<F, double, O>& moments(const Panels& panels) {
    auto& forms = std::get<Forms<PanelFormOf<F, double, O>>>(forms_);
    for (auto& form : forms) {
      if (!form) return form.emplace(frame_, panels);
      if (form->sums().is_on(panels)) return *form;
    }
    return forms.back().emplace(frame_, panels);
  }

 private:
  struct Cut {
    PanelsWanted wanted;
    Panels panels;
    Cut(const PanelsWanted& w, Panels p) : wanted(w), panels(std::move(p)) {}
  };
  // Formulas differ by the steepest power of the distance, of which there are four, and by how many points they may
  // take, of which there are as many.
  static constexpr int kCuts = 16;
  template <class Form>
  using Forms = std::array<std::optional<Form>, kCuts>;

  const Frame<double>& frame_;
  const Triangle<double>& t_;
  const Vec3<double>& eta_;
  std::array<std::optional<Cut>, kCuts> cuts_;
  std::tuple<Forms<PanelForm<double, O, O>>, Forms<PanelForm<double, O + 1, O>>, Forms<PanelForm<double, O + 2, O + 1>>>
      forms_;
};

/// Near forms that carry a bound of their error, on the same geometry.
template <class T, int O>
class TrackedMoments {
 public:
  template <Scalar S>
  explicit TrackedMoments(const Frame<S>& frame) : frame_(frame), near_(frame_) {}
  explicit TrackedMoments(const Frame<Tracked<T>>& frame) : frame_(frame), near_(frame_) {}
  TrackedMoments(const TrackedMoments&) = delete;
  TrackedMoments& operator=(const TrackedMoments&) = delete;

  template <class F>
  const NearForm<F, Tracked<T>, O>& near() {
    return near_.template near<F>();
  }

 private:
  Frame<Tracked<T>> frame_;
  NearMoments<Tracked<T>, O> near_;
};

/// A triangle seen from a point, and all moments that formulas take there for derivatives up to order O. Lives on the
/// stack of one thread. The triangle and the point must outlive it.
template <Scalar R, int O>
class PointMoments {
 public:
  PointMoments(const Triangle<R>& t, const Vec3<R>& eta) : frame_(t, eta), moments_(frame_) {}
  PointMoments(const PointMoments&) = delete;
  PointMoments& operator=(const PointMoments&) = delete;

  const Frame<R>& frame() const { return frame_; }
  NearMoments<R, O>& moments() { return moments_; }
  /// ellipse_of the frame.
  double ellipse() {
    if (!ellipse_) ellipse_ = ellipse_of(frame_);
    return *ellipse_;
  }

 private:
  Frame<R> frame_;
  NearMoments<R, O> moments_;
  std::optional<double> ellipse_;
};

/// In double there are far forms besides, and near forms that bound their error: in double, and from 200 digits of
/// geometry in double-double and in 200 digits.
template <int O>
class PointMoments<double, O> {
 public:
  PointMoments(const Triangle<double>& t, const Vec3<double>& eta)
      : t_(t), eta_(eta), frame_(t, eta), moments_(frame_), on_panels_(frame_, t, eta) {}
  PointMoments(const PointMoments&) = delete;
  PointMoments& operator=(const PointMoments&) = delete;

  const Frame<double>& frame() const { return frame_; }
  NearMoments<double, O>& moments() { return moments_; }
  PanelMoments<O>& on_panels() { return on_panels_; }
  /// ellipse_of the frame.
  double ellipse() {
    if (!ellipse_) ellipse_ = ellipse_of(frame_);
    return *ellipse_;
  }
  /// The unit of tracked moments: the frame's, or one for what is extreme.
  double unit() const { return frame_.extreme ? 1 : frame_.unit; }
  /// The same triangle and point in multiprecision, for extreme ones.
  PointMoments<Mp200, O>& beyond() {
    if (!beyond_)
      beyond_.emplace(Triangle<Mp200>{convert<Mp200>(t_[0]), convert<Mp200>(t_[1]), convert<Mp200>(t_[2])},
                      convert<Mp200>(eta_));
    return *beyond_;
  }
  template <class T>
  TrackedMoments<T, O>& tracked() {
    auto& moments = std::get<std::optional<TrackedMoments<T, O>>>(tracked_);
    if (moments) return *moments;
    if constexpr (std::same_as<T, double>) return moments.emplace(frame_);
    if constexpr (std::same_as<T, DoubleDouble>)
      if (!frame_.extreme) {
        const Frame<Tracked<T>> wide(frame_, t_, eta_);
        if (heights_are_certain(wide)) return moments.emplace(wide);
      }
    return moments.emplace(exact());
  }

 private:
  // In the frame's unit, so that orders of magnitude are the same.
  const Frame<Mp200>& exact() {
    if (!exact_) {
      const Mp200 unit(this->unit());
      Triangle<Mp200> corners;
      for (int i = 0; i < 3; ++i) corners[i] = convert<Mp200>(t_[i]) / unit;
      exact_.emplace(corners, Vec3<Mp200>(convert<Mp200>(eta_) / unit));
    }
    return *exact_;
  }

  const Triangle<double>& t_;
  const Vec3<double>& eta_;
  Frame<double> frame_;
  NearMoments<double, O> moments_;
  PanelMoments<O> on_panels_;
  std::optional<double> ellipse_;
  std::optional<Frame<Mp200>> exact_;
  std::tuple<std::optional<TrackedMoments<double, O>>, std::optional<TrackedMoments<DoubleDouble, O>>,
             std::optional<TrackedMoments<Mp200, O>>>
      tracked_;
  std::optional<PointMoments<Mp200, O>> beyond_;
};

}  // namespace cageproof::closed_form::triangle
