// SPDX-License-Identifier: MIT
#include "quad/engine/seen_quad.h"

#include "quad/engine/quad_frame.h"
#include "quad/engine/singular_pairs.h"

#include <algorithm>
#include <array>

namespace cageproof::adaptive_qmvc {
namespace {

// The frame about the point of line v that is nearest to eta.
template <class W>
LocalFrame<W> frame_about(const QuadFrame<W>& q, const W& v) {
  const Vec3<W> a = q.start(v), e = q.direction(v);
  const W length2 = e.dot(e);
  const W u = length2 > W(0) ? std::clamp(W(-a.dot(e) / length2), W(0), W(1)) : W(0);
  return {q, u, v, Vec3<W>(a + u * e)};
}

}  // namespace

template <class W>
SeenQuad see_frame(const QuadFrame<W>& q, const SingularPairs<W>& singular, double order, double digits) {
  OuterRules<W> across;
  find_outer_rules(singular, order, digits, static_cast<int>(3 * digits), across, false);
  SeenQuad seen{QuadFrame<Mp200>(q), {}, is_folded(q)};
  for (const OuterRule<W>& rule : across.rules) {
    const auto frame = rule.plain ? LocalFrame<W>(q) : frame_about(q, W(std::clamp(rule.centre, rule.lo, rule.hi)));
    const auto panels = across.panels_of(rule);
    seen.rules.push_back({LocalFrame<Mp200>(frame),
                          OuterRule<Mp200>(rule),
                          Mp200(rule.plain ? W(0) : W(rule.centre - frame.v0)),
                          {panels.begin(), panels.end()}});
  }
  return seen;
}

template <class W>
SeenQuad see_in_digits(const std::array<Vec3<W>, 4>& corners, const Vec3<W>& point, double order, double digits) {
  const auto q = quad_frame<W>(corners, point);
  return see_frame(*q, singular_pairs(*q), order, digits);
}

#define CAGEPROOF_SEE(W)                                                                        \
  template SeenQuad see_frame<W>(const QuadFrame<W>&, const SingularPairs<W>&, double, double); \
  template SeenQuad see_in_digits<W>(const std::array<Vec3<W>, 4>&, const Vec3<W>&, double, double);
CAGEPROOF_SEE(Mp50)
CAGEPROOF_SEE(Mp100)
CAGEPROOF_SEE(Mp200)
CAGEPROOF_SEE(Mp800)
#undef CAGEPROOF_SEE

SeenQuad see_in_800_digits(std::span<const Vec3<Mp200>> corners, const Vec3<Mp200>& point, double order,
                           double digits) {
  std::array<Vec3<Mp800>, 4> wide;
  for (int k = 0; k < 4; ++k) wide[k] = corners[k].cast<Mp800>();
  return see_in_digits<Mp800>(wide, Vec3<Mp800>(point.cast<Mp800>()), order, digits);
}

}  // namespace cageproof::adaptive_qmvc
