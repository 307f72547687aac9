// SPDX-License-Identifier: MIT
// The paper's scheme and what it is without its norm correction, or without our guard: the names of each.
#pragma once

#include "../../counted_family.h"
#include "quad/mean_value/riemann/riemann.h"

#include <array>

namespace cageproof::adaptive_qmvc {

struct SchemeVariant {
  const char* suffix;  ///< after `riemann-<n>`
  NormCorrection correction;
  const char* description;
};

inline constexpr std::array<SchemeVariant, 3> kSchemeVariants{
    {{"", NormCorrection::Guarded,
      "the paper's scheme: Riemann sum of (2n + 1)^2 samples about the projection; in double, from 4096 sizes on, its "
      "linear system is solved in 50 digits"},
     {"-uncorrected", NormCorrection::None,
      "riemann-<n> without the norm correction of Eq 24 ([T18] Figure 7): its error next to twisted quads is the "
      "sum's"},
     {"-unguarded", NormCorrection::AsPrinted,
      "riemann-<n> with Eq 24 as printed: unbounded around its poles, the extended diagonals of every quad"}}};

inline PoleGuard guard_of(const SchemeVariant& variant) {
  PoleGuard guard;
  guard.correction = variant.correction;
  return guard;
}

}  // namespace cageproof::adaptive_qmvc
