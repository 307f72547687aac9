// SPDX-License-Identifier: MIT
// Quads and points whose coordinates have exponents so far apart that differences of them, and the squares of
// distances, need more digits or a wider range than the scalars that weights are computed in.
#pragma once

#include "quad/engine/local_frame.h"
#include "quad/engine/outer_rule.h"

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace cageproof::adaptive_qmvc {

/// The exponents of the largest coordinate and of the smallest that is not zero.
struct Exponents {
  int largest = std::numeric_limits<int>::min(), smallest = std::numeric_limits<int>::max();
  bool finite = true;

  /// Whether a coordinate is so small beside another that a difference in twice the digits may lose it.
  bool are_distant() const { return largest > smallest && largest - smallest > 100; }
  /// Whether lengths, or their reciprocals, leave doubles' range.
  bool are_extreme() const { return largest > 1000 || (largest < -900 && largest >= smallest); }
};

template <class R>
Exponents exponents_of(std::span<const Vec3<R>> corners, const Vec3<R>& point) {
  using std::abs, std::ilogb, std::isfinite;
  R largest = R(0), smallest = std::numeric_limits<R>::infinity();
  Exponents exponents;
  const auto add = [&](const Vec3<R>& p) {
    for (int i = 0; i < 3; ++i) {
      const R size = abs(p[i]);
      if (!isfinite(size)) exponents.finite = false;
      if (size > largest) largest = size;
      if (size > R(0) && size < smallest) smallest = size;
    }
  };
  for (const Vec3<R>& corner : corners) add(corner);
  add(point);
  if (!exponents.finite || !(largest > R(0))) return exponents;
  exponents.largest = ilogb(largest);
  exponents.smallest = ilogb(smallest);
  return exponents;
}

/// A rule across the lines, and the frame that its lines are taken in.
struct SeenRule {
  LocalFrame<Mp200> frame;
  OuterRule<Mp200> rule;
  Mp200 centre;  ///< the rule's, as a step from the frame's line
  std::vector<Panel> panels;
};

/// The quad as the point sees it, and the rules that cover it together.
struct SeenQuad {
  QuadFrame<Mp200> frame;
  std::vector<SeenRule> rules;
  bool folded = false;  ///< see is_folded()
};

/// The rules for `digits` digits of an integrand with singularities of that order. What is small next to the point is
/// computed in 800 digits and rounded once. \pre coordinates are finite and, exactly or not, doubles
SeenQuad see_in_800_digits(std::span<const Vec3<Mp200>> corners, const Vec3<Mp200>& point, double order, double digits);

/// The same in as many digits as W has, for coordinates that need no more: differences are taken in those.
template <class W>
SeenQuad see_in_digits(const std::array<Vec3<W>, 4>& corners, const Vec3<W>& point, double order, double digits);

/// The same from a frame and its singularities.
template <class W>
SeenQuad see_frame(const QuadFrame<W>& q, const SingularPairs<W>& singular, double order, double digits);

#define CAGEPROOF_SEE(W)                                                                               \
  extern template SeenQuad see_frame<W>(const QuadFrame<W>&, const SingularPairs<W>&, double, double); \
  extern template SeenQuad see_in_digits<W>(const std::array<Vec3<W>, 4>&, const Vec3<W>&, double, double);
CAGEPROOF_SEE(Mp50)
CAGEPROOF_SEE(Mp100)
CAGEPROOF_SEE(Mp200)
CAGEPROOF_SEE(Mp800)
#undef CAGEPROOF_SEE

}  // namespace cageproof::adaptive_qmvc
