// SPDX-License-Identifier: MIT
// A closed form of segment.single_layer with its first derivatives, written only for tests of the checks in the
// plane.
#pragma once

#include "cageproof/core/catalogue/evaluation.h"

namespace cageproof::validation::test {

/// int -ln r/(2 pi), and its gradient. Off the segment's line only.
template <Scalar R>
void plane_single_layer(const Query<R>& query, Result<R>& result) {
  using std::atan, std::log, std::sqrt;
  result.reset(1, 2, query.order);
  const Vec3<R> along = query.corners[1] - query.corners[0];
  const R length = sqrt(along.dot(along));
  const Vec3<R> t = along / length, n(t[1], -t[0], R(0));
  const Vec3<R> from = query.corners[0] - query.point, to = query.corners[1] - query.point;
  const R a = from.dot(t), b = to.dot(t), h = from.dot(n);
  const auto primitive = [&](const R& x) { return R(x * log(R(x * x + h * h)) / 2 - x + h * atan(R(x / h))); };
  const R scale = 1 / (2 * pi<R>());
  result.value[0] = -scale * (primitive(b) - primitive(a));
  if (query.order < 1) return;
  const R g_along = scale * log(R((b * b + h * h) / (a * a + h * h))) / 2,
          g_across = scale * (atan(R(b / h)) - atan(R(a / h)));
  for (int c = 0; c < 2; ++c) result.gradient[c] = g_along * t[c] + g_across * n[c];
}

/// The form as an evaluation, in all scalars.
inline Evaluation plane_form() {
  Evaluation form("segment.single_layer", "test_form",
                  {.description = "for tests", .role = Role::Foreign, .max_order = 1});
  for (const ScalarKind kind : scalar_kinds)
    with_scalar(kind, [&]<Scalar R>() { form.set_point<R>(plane_single_layer<R>); });
  return form;
}

}  // namespace cageproof::validation::test
