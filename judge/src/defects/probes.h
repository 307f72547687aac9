// SPDX-License-Identifier: MIT
// The inputs that defects are looked for on, with their truths.
#pragma once

#include "cageproof/validation/truth.h"

#include <optional>
#include <string_view>

namespace cageproof::judge {

/// An input, its truth, and what the plain closed form loses there.
struct Probe {
  std::string_view regime;
  validation::Sample sample;
  validation::Truth truth;
  /// Conditioned errors of `plain` for orders 0 and 1: 0 where there is none, infinite where double's arithmetic does
  /// not tell the point from one on the element.
  std::array<double, 2> plain{};
};

/// Makes probes of one formula.
class Prober {
 public:
  /// \param order highest derivative \throws InputError where the formula has no truth
  Prober(const Formula& formula, int order);
  const Formula& formula() const { return *formula_; }
  int order() const { return order_; }
  Probe at(const validation::Sample& sample, std::string_view regime = {}) const;
  /// The same input in a unit of length of 2^-k.
  Probe scaled(const Probe& probe, int k) const;

 private:
  void measure_plain(Probe& probe) const;
  const Formula* formula_;
  int order_;
  validation::TruthSource source_;
  std::optional<Evaluation> plain_;
};

/// Some two hundred probes of all regimes that exist for the formula. Made once a process and formula.
/// \param presets parameters at their presets
const std::vector<Probe>& probes_of(const Prober& prober, std::uint64_t seed, bool presets);

/// Conditioned error of a result in units of u; infinite where it is not finite and the truth is.
double error_of(const Result<double>& found, const Probe& probe, int order);

/// The largest error that is no defect: 2^14 units, or 64 times what the plain closed form loses. Infinite where plain
/// is.
double limit_of(const Probe& probe, int order);

/// Where a point lies to an element, in sizes of the element, as double's arithmetic sees it: what lies within a few
/// roundings of the element's plane, edges or corners counts as on them.
struct Place {
  Contact contact = Contact::Off;
  bool at_vertex = false;
  bool in_plane = false;    ///< in the plane, or on a segment's line
  bool exactly_off = true;  ///< whether it is not exactly on the element
  /// Whether exact arithmetic sees it elsewhere than double's does: off the plane, an edge or a corner by a rounding.
  bool ambiguous = false;
  double size = 1;                             ///< longest edge
  double height = 0;                           ///< distance from the plane, in sizes
  double distance = 0;                         ///< from the nearest corner, in sizes
  double line = 0;                             ///< from the nearest edge's line, in sizes
  double edge = 0;                             ///< from the nearest edge, in sizes
  double aspect = 1;                           ///< twice the area over the squared size; 1 for segments
  double rounding = 0;                         ///< an ulp of the largest coordinate
  Vec3<double> normal = Vec3<double>::Zero();  ///< unit
  Vec3<double> foot = Vec3<double>::Zero();    ///< the point's foot in the plane
  std::array<double, 4> basis{};  ///< the corners' basis functions at the foot; of quads on the element alone
};
Place place_of(ElementKind element, const validation::Sample& sample);

}  // namespace cageproof::judge
