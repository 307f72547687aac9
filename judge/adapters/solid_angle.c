/* SPDX-License-Identifier: MIT */
/* The solid angle of A. Van Oosterom and J. Strackee, "The solid angle of a plane triangle", IEEE Transactions on
 * Biomedical Engineering 30 (1983), with the two-argument arctangent, for `cageproof judge` (docs/judged.md). */
#include "cageproof_judge.h"
#include "vectors.h"

#include <string.h>

int cageproof_judge_version(void) { return CAGEPROOF_JUDGE_VERSION; }
const char* cageproof_judge_about(void) { return "Van Oosterom and Strackee 1983"; }
int cageproof_judge_order(const char* formula) { return strcmp(formula, "triangle.solid_angle") == 0 ? 0 : -1; }

int cageproof_judge_double(const cageproof_judge_block* block, const double* corners, const double* parameters,
                           const double* points, double* values, double* gradients, double* hessians) {
  (void)parameters, (void)gradients, (void)hessians;
  for (size_t p = 0; p < block->count; ++p) {
    double d[3][3], r[3], across[3];
    for (int k = 0; k < 3; ++k) {
      minus(corners + 3 * k, points + 3 * p, d[k]);
      r[k] = length(d[k]);
    }
    cross(d[1], d[2], across);
    values[p] = 2 * atan2(dot(d[0], across), r[0] * r[1] * r[2] + dot(d[0], d[1]) * r[2] + dot(d[1], d[2]) * r[0] +
                                                 dot(d[2], d[0]) * r[1]);
  }
  return CAGEPROOF_JUDGE_DONE;
}
