// SPDX-License-Identifier: MIT
// The triangle's forms in Counted numbers, by the engine's own templates. Here are the parts that these have only for
// double: the source of the geometry, and the series.
#pragma once

#include "cageproof/closed_form/explain.h"
#include "cageproof/closed_form/triangle/engine/evaluate.h"
#include "cageproof/closed_form/triangle/engine/exact_frame.h"

namespace cageproof::closed_form::triangle {

/// Frames are computed in double-double and exact integers, which must not be counted: each of their numbers is one
/// operation, whose exact outcome is the geometry's.
template <>
template <>
Frame<Counted>::Frame(const Frame<double>& other);

/// Tracked numbers take atanh where double takes its series; counted ones take either. \return what was set before
bool follow_tracked(bool tracked);
template <>
Counted atanh_excess<Counted>(const Counted& z);

/// The frame in double, each number with its error against the frame of the same triangle and point in 200 digits.
Frame<Counted> counted_frame(const Frame<double>& frame, const Triangle<double>& t, const Vec3<double>& eta);

/// A formula's parameters, as exact numbers.
template <class F>
std::array<Counted, F::parameter_count> counted_parameters(std::span<const double> parameters) {
  std::array<Counted, F::parameter_count> counted;
  for (int i = 0; i < F::parameter_count; ++i) counted[i] = parameters[i];
  return counted;
}

/// The numbers of the tensor of order O, in units of the frame, each entry from its component and monomial.
template <class F, int O>
std::vector<Counted> entries_of(const Components<F, Counted, O>& components) {
  constexpr std::size_t size = O == 0 ? 1 : O == 1 ? 3 : 9;
  std::vector<Counted> entries;
  entries.reserve(size * F::components);
  for (std::size_t i = 0; i < size * F::components; ++i) {
    std::array<int, 3> exponents{};
    if (O >= 1) ++exponents[i % 3];
    if (O >= 2) ++exponents[i / 3 % 3];
    const int m = Monomials<O>::place(exponents);
    entries.push_back(components[i / size].c[m] * derivative_factor<O>(m));
  }
  return entries;
}

}  // namespace cageproof::closed_form::triangle
