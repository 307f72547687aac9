// SPDX-License-Identifier: MIT
// Forward declarations of the number types, beside scalars, that forms are computed in.
#pragma once

#include "cageproof/core/numbers/mp_names.h"

namespace cageproof::closed_form {

struct DoubleDouble;
template <class T>
struct Tracked;

template <class T>
inline constexpr bool is_tracked = false;
template <class T>
inline constexpr bool is_tracked<Tracked<T>> = true;

/// Whether a quotient takes as long as several products.
template <class R>
inline constexpr bool divides_slowly = false;
template <unsigned Digits>
inline constexpr bool divides_slowly<Tracked<Mp<Digits>>> = true;

}  // namespace cageproof::closed_form
