// SPDX-License-Identifier: MIT
// Points whose coordinates are small against what they are sums of, as outside thin limbs of a cage, for one
// instruction set: all their faces need more digits.
#pragma once

#include "cageproof/closed_form/batch/lanes.h"

#include "edge_terms.h"
#include "near_faces.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// Limits of a measure (the root of a sum of squares over faces) relative to the rounding that is allowed. On the
/// tests' cages, embedded and real, within and around them, roundings of a double layer's values are at most half of
/// their measure, Kelvin's and phibar's three times theirs, and those of phibar's gradients and Hessians five times.
inline constexpr double kOfNorm = 64, kOfKelvinNorm = 18, kOfDistance = 26, kOfSlope = 13;
/// The measure of gradients, times this and over the size of the cage, is that of Hessians.
inline constexpr double kOfBend = 4;

/// Measures of one face that is added in double, or sums of the squares of all faces' measures.
struct Measures {
  Lanes thin{};         ///< as kThin says
  Lanes of_layer{};     ///< of the double layer's values
  Lanes of_distance{};  ///< of the biharmonic double layer's values; of its derivatives it is `thin`

  /// For harmonic layers `thin` and `of_layer` are the same.
  template <Layers L>
  void add_squares(const Measures& m, Mask but) {
    of_layer += select(but, Lanes{}, m.of_layer * m.of_layer);
    if constexpr (L != Layers::Harmonic) thin += select(but, Lanes{}, m.thin * m.thin);
    else thin = of_layer;
    if constexpr (L == Layers::Biharmonic) of_distance += select(but, Lanes{}, m.of_distance * m.of_distance);
  }
  template <Layers L>
  Mask exceeds(const Measures& limits) const {
    if constexpr (L == Layers::Harmonic)
      return of_layer > select(limits.thin < limits.of_layer, limits.thin, limits.of_layer);
    const Mask beyond = (thin > limits.thin) | (of_layer > limits.of_layer);
    if constexpr (L != Layers::Biharmonic) return beyond;
    return beyond | (of_distance > limits.of_distance);
  }
};

/// Sums of squares of faces whose measure is at most each of some limits.
struct SquaresBelow {
  static constexpr int count = 10;
  static constexpr double limits[count] = {32, 24, 18, 14, 10, 7.5, 5.6, 4.2, 3.2, 2.4};
  Lanes of[count] = {};

  void add(Lanes measure, Mask but) {
    const Lanes square = select(but, Lanes{}, measure * measure);
    for (int i = 0; i < count; ++i) of[i] += select(measure > limits[i], Lanes{}, square);
  }
};

/// The measures of its faces that a block keeps.
struct MeasuredBlock {
  SquaresBelow thin_below;  ///< of `thin`, where derivatives are asked
  Measures squares;         ///< summed over the faces that are added in double
  Measures limits;          ///< beyond which faces are not
  Lanes faces;              ///< how many faces were near
  Mask between;             ///< whether there are rules, not quick ones, for some of them
  Small rules;              ///< how many rules are taken
  Mask lowered;             ///< whether limits are
};

/// Lets `points` take all rules.
inline void take_all_rules(MeasuredBlock& measured, Mask points) {
  for (int i = 0; i < kLanes; ++i)
    if (points[i] != 0) measured.rules[i] = kFarRules;
}

/// The norm of an order's columns of a double layer; each vertex has `each` of them.
inline Lanes norm_of(const Block& block, int order, int b, int each) {
  const auto* const from = reinterpret_cast<const Lanes*>(block.columns) + block.layout.first[order][b];
  Lanes sum{};
  for (int i = 0; i < each * block.cage->vertices; ++i) sum += from[i] * from[i];
  return root(sum);
}

/// Lowers `limit` for points whose sum of squares exceeds most^2, so that the sum no longer does. \return these points
inline Mask lower(Lanes& limit, Lanes squares, Lanes most, Lanes faces) {
  const Lanes square = most * most;
  const Mask lowered = squares > square;
  const Lanes evenly = root(square / faces);
  limit = select(lowered & (evenly < limit), evenly, limit);
  return lowered;
}

/// Lowers `limit` in the same way, to the largest sufficient limit that `below` knows.
inline Mask lower(Lanes& limit, const SquaresBelow& below, Lanes squares, Lanes most, Lanes faces) {
  const Lanes square = most * most;
  const Mask lowered = squares > square;
  if (!any(lowered)) return lowered;
  Lanes found = root(square / faces);
  for (int i = SquaresBelow::count - 1; i >= 0; --i)
    found = select((below.of[i] <= square) & (found < SquaresBelow::limits[i]), splat(SquaresBelow::limits[i]), found);
  limit = select(lowered & (found < limit), found, limit);
  return lowered;
}

/// Lowers the limits of points whose roundings are too large against the coordinates' norm, and that of the next
/// derivatives times the cage's size. Derivatives that are not computed are estimated. The Laplacian of phibar is phi,
/// by which its Hessian is at least phi/sqrt(3) and its third derivatives phi's gradient over sqrt(3); its gradient is
/// about the geometric mean of phibar and phi, in thin limbs as well.
template <Layers L, int O>
Mask lower_limits(const Block& block, MeasuredBlock& measured) {
  const Lanes faces = select(measured.faces > 1, measured.faces, splat(1));
  const Measures& squares = measured.squares;
  Measures& limits = measured.limits;
  const Lanes phi = norm_of(block, 0, 0, L == Layers::Kelvin ? 9 : 1);
  Mask found = lower(limits.of_layer, squares.of_layer, (L == Layers::Kelvin ? kOfKelvinNorm : kOfNorm) * phi, faces);
  if constexpr (L == Layers::Biharmonic) {
    // In the scale of the sums, where phi counts twice.
    constexpr double of_laplacian = 2 * 0.57735;
    const double size = block.cage->size;
    const Lanes phibar = norm_of(block, 0, 2, 1);
    Lanes gradient;
    if constexpr (O == 0) gradient = 0.5 * root((phi + phi) * phibar);
    else gradient = norm_of(block, 1, 2, 3);
    found |= lower(limits.of_distance, squares.of_distance, kOfDistance * (phibar + size * gradient), faces);
    if constexpr (O >= 1) {
      const Lanes most = kOfSlope * (gradient + (of_laplacian * size) * phi);
      found |= lower(limits.thin, measured.thin_below, squares.thin, most, faces);
    }
    if constexpr (O >= 2) {
      const Lanes bend = norm_of(block, 2, 2, 6) + (of_laplacian * size) * norm_of(block, 1, 0, 3);
      found |= lower(limits.thin, measured.thin_below, squares.thin, (kOfSlope * size / kOfBend) * bend, faces);
    }
  }
  return found;
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
