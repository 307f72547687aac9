// SPDX-License-Identifier: MIT
#include "cageproof/adaptive_qmvc/quad/mean_value/line_form/seen_quad.h"

#include "cageproof/adaptive_qmvc/quad/mean_value/line_form/quad_frame.h"
#include "cageproof/adaptive_qmvc/quad/mean_value/line_form/singular_pairs.h"

#include <algorithm>
#include <array>

namespace cageproof::adaptive_qmvc {
namespace {

// The frame about the point of line v that is nearest to eta.
LocalFrame<Mp800> frame_about(const QuadFrame<Mp800>& q, const Mp800& v) {
  const Vec3<Mp800> a = q.start(v), e = q.direction(v);
  const Mp800 length2 = e.dot(e);
  const Mp800 u = length2 > 0 ? std::clamp(Mp800(-a.dot(e) / length2), Mp800(0), Mp800(1)) : Mp800(0);
  return {q, u, v, Vec3<Mp800>(a + u * e)};
}

}  // namespace

SeenQuad see_in_800_digits(std::span<const Vec3<Mp200>> corners, const Vec3<Mp200>& point, double order,
                           double digits) {
  std::array<Vec3<Mp800>, 4> wide;
  for (int k = 0; k < 4; ++k) wide[k] = corners[k].cast<Mp800>();
  const auto q = quad_frame<Mp800>(wide, Vec3<Mp800>(point.cast<Mp800>()));
  OuterRules<Mp800> across;
  find_outer_rules(singular_pairs(*q), order, digits, static_cast<int>(3 * digits), across);
  SeenQuad seen{q->unit, {}, is_folded(*q)};
  for (const OuterRule<Mp800>& rule : across.rules) {
    const auto frame = rule.plain ? LocalFrame<Mp800>(*q) : frame_about(*q, std::clamp(rule.centre, rule.lo, rule.hi));
    const auto panels = across.panels_of(rule);
    seen.rules.push_back({LocalFrame<Mp200>(frame),
                          OuterRule<Mp200>(rule),
                          Mp200(rule.plain ? Mp800(0) : Mp800(rule.centre - frame.v0)),
                          {panels.begin(), panels.end()}});
  }
  return seen;
}

}  // namespace cageproof::adaptive_qmvc
