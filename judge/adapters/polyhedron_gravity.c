/* SPDX-License-Identifier: MIT */
/* The single layer of a triangle in the terms of R. Werner and D. Scheeres, "Exterior gravitation of a polyhedron",
 * Celestial Mechanics and Dynamical Astronomy 65 (1997): the logarithm ln((a + b + e)/(a + b - e)) of each edge, and the
 * solid angle of the face. For `cageproof judge` (docs/judged.md). */
#include "cageproof_judge.h"
#include "vectors.h"

#include <string.h>

static const double kPi = 3.14159265358979323846;

int cageproof_judge_version(void) { return CAGEPROOF_JUDGE_VERSION; }
const char* cageproof_judge_about(void) { return "a face of Werner and Scheeres 1997"; }
int cageproof_judge_order(const char* formula) { return strcmp(formula, "triangle.single_layer") == 0 ? 1 : -1; }

static void single_layer(const double* corners, const double* point, double* value, double* gradient) {
  double d[3][3], r[3], normal[3], side[3], other[3], across[3], outward[3];
  for (int k = 0; k < 3; ++k) {
    minus(corners + 3 * k, point, d[k]);
    r[k] = length(d[k]);
  }
  minus(d[1], d[0], side);
  minus(d[2], d[0], other);
  cross(side, other, normal);
  const double area2 = length(normal);
  for (int i = 0; i < 3; ++i) normal[i] /= area2;
  cross(d[1], d[2], across);
  const double omega = 2 * atan2(dot(d[0], across), r[0] * r[1] * r[2] + dot(d[0], d[1]) * r[2] +
                                                        dot(d[1], d[2]) * r[0] + dot(d[2], d[0]) * r[1]);
  double sum = -dot(normal, d[0]) * omega, slope[3];
  for (int i = 0; i < 3; ++i) slope[i] = normal[i] * omega;
  for (int k = 0; k < 3; ++k) {
    const int to = (k + 1) % 3;
    minus(d[to], d[k], side);
    const double e = length(side), logarithm = log((r[k] + r[to] + e) / (r[k] + r[to] - e));
    cross(side, normal, outward);
    for (int i = 0; i < 3; ++i) outward[i] /= e;
    sum += dot(outward, d[k]) * logarithm;
    for (int i = 0; i < 3; ++i) slope[i] -= outward[i] * logarithm;
  }
  *value = sum / (4 * kPi);
  for (int i = 0; gradient != NULL && i < 3; ++i) gradient[i] = slope[i] / (4 * kPi);
}

int cageproof_judge_double(const cageproof_judge_block* block, const double* corners, const double* parameters,
                           const double* points, double* values, double* gradients, double* hessians) {
  (void)parameters, (void)hessians;
  for (size_t p = 0; p < block->count; ++p)
    single_layer(corners, points + 3 * p, values + p, gradients != NULL ? gradients + 3 * p : NULL);
  return CAGEPROOF_JUDGE_DONE;
}
