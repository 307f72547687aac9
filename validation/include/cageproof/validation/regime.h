// SPDX-License-Identifier: MIT
// Regimes: how a point sits to an element, with a parameter swept by decades.
#pragma once

#include "cageproof/core/random_stream.h"
#include "cageproof/validation/sample.h"

namespace cageproof::validation {

/// A regime makes samples; sample i is a pure function of (seed, formula, regime, i).
struct Regime {
  std::string_view name;
  std::string_view parameter_name;  ///< of the axis in pictures; empty where nothing is swept
  std::vector<double> parameters;   ///< what sample i mod size sweeps; empty where nothing is swept
  std::string_view description;
  /// Fills corners and point of an element of size one (longest edge), before any change of unit.
  void (*make)(ElementKind element, double parameter, RandomStream& random, Sample& sample);
  /// The same for a quad, planar, twisted or strongly twisted by turns, valid always.
  void (*make_quad)(double parameter, RandomStream& random, Sample& sample);
};

/// All regimes, in report order.
const std::vector<Regime>& regimes();

/// The regime of that name, or null.
const Regime* find_regime(std::string_view name);

/// Sample `index` of a regime for a formula.
Sample make_sample(const Formula& formula, const Regime& regime, std::uint64_t seed, std::uint64_t index);

}  // namespace cageproof::validation
