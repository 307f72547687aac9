// SPDX-License-Identifier: MIT
// Closed forms whose moments are sums over Gauss points on panels; formulas at one point share these moments.
#pragma once

#include "cageproof/closed_form/triangle/engine/bounded.h"
#include "cageproof/fast/triangle/panel_form.h"

#include <tuple>

namespace cageproof::fast::triangle {

/// The moments that a formula takes from panels, for derivatives up to order O.
template <class F, class R, int O>
using PanelFormOf = PanelForm<R, O + F::extra, F::extra == 0 ? O : O + F::extra - 1>;

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
  // Formulas differ by the steepest power of the distance (four values) and by how many points they may take (four
  // values, too).
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

/// A closed form on panels in double, with its bound. \pre the point is not on the triangle's border
template <class F, int O>
BoundedJet<double, F::components> tracked_on_panels(const Frame<double>& frame, std::span<const double> parameters,
                                                    const Panels& panels) {
  const auto tracked = tracked_parameters<F, double>(parameters);
  const Frame<Tracked<double>> with_bounds(frame);
  const PanelFormOf<F, Tracked<double>, O> moments(with_bounds, panels);
  return bounded<F, O, double, double>(composed<F, O, Tracked<double>>(moments, tracked), frame.unit, 3,
                                       std::numeric_limits<double>::max());
}

}  // namespace cageproof::fast::triangle
