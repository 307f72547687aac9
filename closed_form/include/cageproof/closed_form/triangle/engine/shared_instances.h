// SPDX-License-Identifier: MIT
// Declares the moments' instantiations, which `closed_form` compiles once for all formulas. Sources that link it
// include this next to a form, and compile none of them again.
#pragma once

#include "cageproof/closed_form/triangle/engine/closed_form.h"

// The degrees (N, M) that formulas ask for: 0 to 2 for their own derivatives, two more under second derivatives.
#define CAGEPROOF_FORMS(prefix, R)         \
  prefix template class EdgeForm<R, 0, 0>; \
  prefix template class EdgeForm<R, 1, 1>; \
  prefix template class EdgeForm<R, 2, 2>; \
  prefix template class EdgeForm<R, 2, 1>; \
  prefix template class EdgeForm<R, 3, 2>; \
  prefix template class EdgeForm<R, 4, 3>; \
  prefix template class EvenForm<R, 0>;    \
  prefix template class EvenForm<R, 1>;    \
  prefix template class EvenForm<R, 2>;

// With frames.
#define CAGEPROOF_MOMENTS(prefix, R) \
  CAGEPROOF_FORMS(prefix, R)         \
  prefix template struct Frame<R>;

namespace cageproof::closed_form::triangle {
CAGEPROOF_FORMS(extern, float)
CAGEPROOF_MOMENTS(extern, double)
CAGEPROOF_MOMENTS(extern, Tracked<double>)
CAGEPROOF_MOMENTS(extern, Tracked<DoubleDouble>)
CAGEPROOF_MOMENTS(extern, Tracked<Mp100>)
CAGEPROOF_MOMENTS(extern, Tracked<Mp200>)
CAGEPROOF_MOMENTS(extern, Tracked<Mp400>)
CAGEPROOF_MOMENTS(extern, Tracked<Mp2000>)
}  // namespace cageproof::closed_form::triangle
