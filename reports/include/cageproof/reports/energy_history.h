// SPDX-License-Identifier: MIT
// Energies of an iteration, step by step, as a person sees them.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace cageproof::reports {

/// A header, then one line per value: its number, from 1 on, and the value in full precision.
std::string energies_csv(std::span<const double> energies);

/// The bytes of a PNG: energies over their numbers, on a logarithmic axis; zeros are not drawn.
/// \throws InputError when gnuplot is missing or fails
std::string energies_png(std::span<const double> energies, std::string_view title);

}  // namespace cageproof::reports
