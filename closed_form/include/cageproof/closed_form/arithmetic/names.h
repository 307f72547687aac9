// SPDX-License-Identifier: MIT
// The names of the numbers that forms are computed in beside scalars, for code that needs none of them itself.
#pragma once

namespace cageproof::closed_form {

struct DoubleDouble;
template <class T>
struct Tracked;

template <class T>
inline constexpr bool is_tracked = false;
template <class T>
inline constexpr bool is_tracked<Tracked<T>> = true;

}  // namespace cageproof::closed_form
