// SPDX-License-Identifier: MIT
// Regimes: how a point sits to an element, with a parameter swept by decades.
#pragma once

#include "cageproof/core/numbers/random_stream.h"
#include "cageproof/validation/sample.h"

namespace cageproof::validation {

/// A way to place a point. How it samples each kind of element is in the table of src/element/element_sampling.h;
/// sample i is a pure function of (seed, formula, regime, i).
struct Regime {
  std::string_view name;
  std::string_view parameter_name;  ///< of the axis in pictures; empty where nothing is swept
  std::vector<double> parameters;   ///< what sample i mod size sweeps; empty where nothing is swept
  std::string_view description;
};

/// The name of rows about the hulls of twisted quads (check hull_jump), which are no samples of a regime.
inline constexpr std::string_view hull_regime = "hull";

/// All regimes, in report order.
const std::vector<Regime>& regimes();

/// The regime of that name, or null.
const Regime* find_regime(std::string_view name);

/// Whether such samples exist for a kind of element: nothing is thin in the plane, and a segment's line is its plane.
bool exists_for(const Regime& regime, ElementKind element);

/// Sample `index` of a regime for a formula. \throws InputError where the regime does not exist for the formula's
/// element
Sample make_sample(const Formula& formula, const Regime& regime, std::uint64_t seed, std::uint64_t index);

}  // namespace cageproof::validation
