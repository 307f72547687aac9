// SPDX-License-Identifier: MIT
// The moments' instantiations, compiled once for all formulas: who links `closed_form` includes this beside a form, and
// compiles none of them again.
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

// With frames from exact differences.
#define CAGEPROOF_MOMENTS(prefix, R) \
  CAGEPROOF_FORMS(prefix, R)         \
  prefix template struct Frame<R>;

// The far form in multiprecision, which every formula asks for.
#define CAGEPROOF_FAR_MOMENTS(prefix, R)                    \
  prefix template class HatMoments<R, 0, 0, SquareSums<R>>; \
  prefix template class HatMoments<R, 1, 1, SquareSums<R>>; \
  prefix template class HatMoments<R, 2, 2, SquareSums<R>>; \
  prefix template class HatMoments<R, 2, 1, SquareSums<R>>; \
  prefix template class HatMoments<R, 3, 2, SquareSums<R>>; \
  prefix template class HatMoments<R, 4, 3, SquareSums<R>>;

namespace cageproof::closed_form::triangle {
CAGEPROOF_FORMS(extern, float)
CAGEPROOF_MOMENTS(extern, double)
CAGEPROOF_MOMENTS(extern, Mp100)
CAGEPROOF_MOMENTS(extern, Mp200)
CAGEPROOF_FAR_MOMENTS(extern, Mp100)
CAGEPROOF_FAR_MOMENTS(extern, Mp200)
CAGEPROOF_MOMENTS(extern, Tracked<double>)
CAGEPROOF_MOMENTS(extern, Tracked<DoubleDouble>)
CAGEPROOF_MOMENTS(extern, Tracked<Mp200>)
}  // namespace cageproof::closed_form::triangle
