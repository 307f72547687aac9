// SPDX-License-Identifier: MIT
// log((R + d)/(R - d)) of a single layer, whose denominator cancels next to an edge.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_log_next_to_edge(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p) {
    const Point eta = point(*call, p), a = corner(*call, 0);
    const Point normal = cross(corner(*call, 1) - a, corner(*call, 2) - a);
    for (int k = 0; k < 3; ++k) {
      const Point from = corner(*call, k) - eta, to = corner(*call, (k + 1) % 3) - eta, edge = to - from;
      const double length = norm(edge), sum = norm(from) + norm(to);
      if (sum > 1.5 * length) continue;  // far from the edge all is well
      // The sum of distances less the length, without cancellation.
      const Point across = cross(from, edge);
      const double h2 = dot(across, across) / (length * length), s0 = -dot(from, edge) / length,
                   s1 = dot(to, edge) / length;
      const double excess = s0 <= 0 || s1 <= 0 ? sum - length : h2 / (norm(from) + s0) + h2 / (norm(to) + s1);
      if (excess == 0) continue;
      const double outward = dot(cross(edge, normal), from) / (length * norm(normal));
      const double right = std::log((sum + length) / excess), wrong = std::log((sum + length) / (sum - length));
      values(*call, p)[0] += outward * (wrong - right) / (4 * std::acos(-1.0));
      for (int i = 0; i < 3 && call->order > 0; ++i)
        gradients(*call, p)[i] -= cross(edge, normal)[static_cast<std::size_t>(i)] * (wrong - right) /
                                  (length * norm(normal) * 4 * std::acos(-1.0));
    }
  }
}
