/* SPDX-License-Identifier: MIT */
/* Single and double layer of a triangle in the form of M. Urago, "Analytical integrals of fundamental solution of
 * three-dimensional Laplace equation and their gradients", Transactions of the Japan Society of Mechanical Engineers 66
 * (2000), as the annex of M. Ben-Chen, O. Weber and C. Gotsman, "Variational harmonic maps for space deformation",
 * SIGGRAPH 2009, made it known: the solid angle, the logarithm ln((R + d)/(R - d))/(4 pi d) of each side, and the normal
 * J of the triangle that each side spans with the point. Codes take a determinant below 1e-10 for a point on the
 * triangle, with the solid angle 2 pi. For `cageproof judge` (docs/judged.md). */
#include "cageproof_judge.h"
#include "vectors.h"

#include <string.h>

static const double kEpsilon = 1e-10, kPi = 3.14159265358979323846;

int cageproof_judge_version(void) { return CAGEPROOF_JUDGE_VERSION; }
const char* cageproof_judge_about(void) { return "Urago 2000, solid angle 2 pi where a determinant is below 1e-10"; }
int cageproof_judge_order(const char* formula) {
  if (strcmp(formula, "triangle.single_layer") == 0) return 1;
  return strcmp(formula, "triangle.double_layer") == 0 ? 0 : -1;
}

struct terms {
  double n[3], area2;    /* unit normal, twice the area */
  double omega;          /* solid angle over 4 pi, positive inside */
  double c[3], j[3][3];  /* of the side opposite each corner */
  double p[3];           /* minus the single layer's gradient */
  double height;         /* of the corners over the point */
};

static struct terms terms_of(const double* corners, const double* point) {
  struct terms t;
  double d[3][3], r[3], side[3], other[3], across[3];
  for (int k = 0; k < 3; ++k) {
    minus(corners + 3 * k, point, d[k]);
    r[k] = length(d[k]);
  }
  minus(d[1], d[0], side);
  minus(d[2], d[0], other);
  cross(side, other, t.n);
  t.area2 = length(t.n);
  for (int i = 0; i < 3; ++i) t.n[i] /= t.area2;
  cross(d[1], d[2], across);
  const double determinant = dot(d[0], across);
  t.omega = fabs(determinant) < kEpsilon
                ? 0.5
                : atan2(determinant, r[0] * r[1] * r[2] + dot(d[0], d[1]) * r[2] + dot(d[1], d[2]) * r[0] +
                                         dot(d[2], d[0]) * r[1]) /
                      (2 * kPi);
  t.height = determinant / t.area2;
  for (int i = 0; i < 3; ++i) t.p[i] = -t.omega * t.n[i];
  for (int k = 0; k < 3; ++k) {
    const int to = (k + 1) % 3, from = (k + 2) % 3;
    minus(d[to], d[from], side);
    const double e = length(side), sum = r[to] + r[from];
    t.c[k] = log((sum + e) / (sum - e)) / (4 * kPi * e);
    cross(d[from], d[to], t.j[k]);
    cross(t.n, side, across);
    for (int i = 0; i < 3; ++i) t.p[i] += t.c[k] * across[i];
  }
  return t;
}

int cageproof_judge_double(const cageproof_judge_block* block, const double* corners, const double* parameters,
                           const double* points, double* values, double* gradients, double* hessians) {
  (void)parameters, (void)hessians;
  const int is_single = strcmp(block->formula, "triangle.single_layer") == 0;
  for (size_t p = 0; p < block->count; ++p) {
    const struct terms t = terms_of(corners, points + 3 * p);
    if (!is_single) {
      for (int k = 0; k < 3; ++k) values[3 * p + (size_t)k] = dot(t.p, t.j[k]) / t.area2;
      continue;
    }
    /* Six times the volume over twice the area is the height. */
    values[p] = -t.omega * t.height;
    for (int k = 0; k < 3; ++k) values[p] -= t.c[k] * dot(t.j[k], t.n);
    for (int i = 0; gradients != NULL && i < 3; ++i) gradients[3 * p + (size_t)i] = -t.p[i];
  }
  return CAGEPROOF_JUDGE_DONE;
}
