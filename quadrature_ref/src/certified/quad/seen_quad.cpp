// SPDX-License-Identifier: MIT
#include "seen_quad.h"

#include "ball_vectors.h"

namespace cageproof::quadrature_ref::certified {

template <Scalar R>
std::optional<SeenQuad> seen_quad(const Query<R>& query) {
  const auto input = exact_input<4>(query);
  if (!input) return std::nullopt;
  const ExactInput<4>& at = *input;
  const WorkingBits exact = WorkingBits::exact();
  SeenQuad q;
  q.starts = {minus(at[0], at[4]), minus(at[1], at[4])};
  q.across = {minus(at[3], at[0]), minus(at[2], at[1])};
  const std::array<Vector, 2> lines{minus(at[1], at[0]), minus(at[2], at[3])};  // v = 0 and v = 1
  bool area = false;
  q.flat = true;
  for (int u = 0; u < 2; ++u)
    for (int v = 0; v < 2; ++v) {
      const Vector normal = cross(lines[v], q.across[u]);
      q.heights[u][v] = dot(normal, moved(q.starts[u], Real(v), q.across[u]));
      area = area || !normal[0].is_zero() || !normal[1].is_zero() || !normal[2].is_zero();
      q.flat = q.flat && q.heights[u][v].is_zero();
    }
  if (!area) return std::nullopt;
  return q;
}

template std::optional<SeenQuad> seen_quad<float>(const Query<float>&);
template std::optional<SeenQuad> seen_quad<double>(const Query<double>&);
template std::optional<SeenQuad> seen_quad<Mp50>(const Query<Mp50>&);
template std::optional<SeenQuad> seen_quad<Mp100>(const Query<Mp100>&);
template std::optional<SeenQuad> seen_quad<Mp200>(const Query<Mp200>&);

QuadStretch stretch_of(const SeenQuad& quad, const Real& middle, const Real& half) {
  const WorkingBits exact = WorkingBits::exact();
  QuadStretch s{middle, half, {}, {}, {}};
  for (int u = 0; u < 2; ++u) {
    s.ends[u] = moved(quad.starts[u], middle, quad.across[u]);
    s.slopes[u] = quad.heights[u][1] - quad.heights[u][0];
    s.heights[u] = quad.heights[u][0] + middle * s.slopes[u];
  }
  return s;
}

}  // namespace cageproof::quadrature_ref::certified
