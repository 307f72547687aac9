// SPDX-License-Identifier: MIT
// How somebody else's numbers mean the same as ours: a factor, an order of corners, a sign of derivatives.
#pragma once

#include "cageproof/core/catalogue/evaluation.h"

#include <optional>
#include <string>
#include <vector>

namespace cageproof::judge {

/// The map from a formula of the catalogue to the numbers of an implementation. It never depends on the sample.
struct Convention {
  std::string formula;      ///< of the catalogue: which one the implementation computes, whatever it was registered for
  std::string sentence;     ///< "yours is ours times -1/(4 pi)"; "yours is ours" where nothing differs
  double factor = 1;        ///< theirs = factor times the parameters' powers times ours
  std::vector<int> powers;  ///< one a parameter of the formula: mu^power, and (1 - nu)^power
  std::vector<int> corners;       ///< their tensor k belongs to our corner corners[k]; empty where the order is ours
  bool reversed = false;          ///< corners run the other way round, so that normals point inward
  bool transposed = false;        ///< rows and columns of matrices are swapped
  bool normalised = false;        ///< the corners' values are divided by their sum
  int derivative_sign = 1;        ///< -1: derivatives are by the element's position instead of the point's
  bool derivative_first = false;  ///< gradients are stored [i][component] instead of [component][i]
  bool gradient_known = false;    ///< the gradient fits; false where there is none, or none that fits
  bool from_afar = false;         ///< it fits at eight sizes from the element, and not next to it

  /// Whether theirs and ours are the same numbers.
  bool is_ours(std::string_view registered_for) const;
};

/// Solves for the convention on generic samples, and where none fits there, eight sizes away: all samples must agree to
/// 1e-9. \return nothing where no convention fits all samples
/// \param presets parameters stay at their presets instead of being drawn
/// \pre theirs supports double
std::optional<Convention> find_convention(const Evaluation& theirs, std::uint64_t seed, bool presets = false);

/// An evaluation of `convention.formula` in our convention, which asks theirs; in double, to order 1 at most. The sum
/// that normalised values lack is taken from the closed form.
Evaluation in_our_convention(const Evaluation& theirs, const Convention& convention);

/// "-1/(4 pi)", "2", "3/(8 pi)": a rational with few factors times a power of pi, within a relative distance; empty for
/// other numbers.
std::string name_of_constant(double x, double within = 1e-9);

}  // namespace cageproof::judge
