/* SPDX-License-Identifier: MIT */
/* The single layer of a triangle in the terms of R. Graglia, "On the numerical integration of the linear shape functions
 * times the 3-D Green's function or its gradient on a plane triangle", IEEE Transactions on Antennas and Propagation 41
 * (1993): for each edge i the coordinates s- and s+ of its ends along it from the foot of the point, the distance t0 of
 * its line in the plane, the distance R0 of its line in space, the logarithm f2 and the angle beta. The logarithm has no
 * value on an edge, where it is multiplied by t0 = 0. Codes leave the term out below a distance, here R0 < 1e-8. For
 * `cageproof judge` (docs/judged.md). */
#include "cageproof_judge.h"
#include "vectors.h"

#include <string.h>

static const double kEpsilon = 1e-8, kPi = 3.14159265358979323846;

int cageproof_judge_version(void) { return CAGEPROOF_JUDGE_VERSION; }
const char* cageproof_judge_about(void) { return "Graglia 1993, terms of edges nearer than 1e-8 left out"; }
int cageproof_judge_order(const char* formula) { return strcmp(formula, "triangle.single_layer") == 0 ? 0 : -1; }

/* The triangle in its plane: corners (0, 0), (l3, 0), (u3, v3); the point (u0, v0) at the height w0. */
struct local {
  double l3, u3, v3, u0, v0, w0;
};

static struct local local_of(const double* corners, const double* point) {
  double u[3], to_third[3], to_point[3], v[3], w[3];
  minus(corners + 3, corners, u);
  minus(corners + 6, corners, to_third);
  minus(point, corners, to_point);
  struct local x = {length(u), 0, 0, 0, 0, 0};
  for (int i = 0; i < 3; ++i) u[i] /= x.l3;
  cross(u, to_third, w);
  const double height = length(w);
  for (int i = 0; i < 3; ++i) w[i] /= height;
  cross(w, u, v);
  x.u3 = dot(u, to_third), x.v3 = dot(v, to_third);
  x.u0 = dot(u, to_point), x.v0 = dot(v, to_point), x.w0 = dot(w, to_point);
  return x;
}

static double single_layer(const double* corners, const double* point) {
  const struct local x = local_of(corners, point);
  /* Edge i is opposite corner i. */
  const double l1 = hypot(x.l3 - x.u3, x.v3), l2 = hypot(x.u3, x.v3);
  const double minus_s[3] = {-((x.l3 - x.u0) * (x.l3 - x.u3) + x.v0 * x.v3) / l1,
                             -(x.u3 * (x.u3 - x.u0) + x.v3 * (x.v3 - x.v0)) / l2, -x.u0};
  const double plus_s[3] = {((x.u3 - x.u0) * (x.u3 - x.l3) + x.v3 * (x.v3 - x.v0)) / l1,
                            (x.u0 * x.u3 + x.v0 * x.v3) / l2, x.l3 - x.u0};
  const double t0[3] = {(x.v0 * (x.u3 - x.l3) + x.v3 * (x.l3 - x.u0)) / l1, (x.u0 * x.v3 - x.v0 * x.u3) / l2, x.v0};
  const double w = fabs(x.w0);
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double r0 = hypot(t0[i], w);
    if (r0 < kEpsilon) continue;
    const double minus_r = hypot(r0, minus_s[i]), plus_r = hypot(r0, plus_s[i]);
    const double f2 = log((plus_r + plus_s[i]) / (minus_r + minus_s[i]));
    const double beta = atan(t0[i] * plus_s[i] / (r0 * r0 + w * plus_r)) -
                        atan(t0[i] * minus_s[i] / (r0 * r0 + w * minus_r));
    sum += t0[i] * f2 - w * beta;
  }
  return sum / (4 * kPi);
}

int cageproof_judge_double(const cageproof_judge_block* block, const double* corners, const double* parameters,
                           const double* points, double* values, double* gradients, double* hessians) {
  (void)parameters, (void)gradients, (void)hessians;
  for (size_t p = 0; p < block->count; ++p) values[p] = single_layer(corners, points + 3 * p);
  return CAGEPROOF_JUDGE_DONE;
}
