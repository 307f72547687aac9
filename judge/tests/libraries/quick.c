/* SPDX-License-Identifier: MIT */
/* A library that computes nothing: its time is that of reaching it. */
#include "cageproof_judge.h"

#include <string.h>

int cageproof_judge_version(void) { return CAGEPROOF_JUDGE_VERSION; }
int cageproof_judge_order(const char* formula) { return strcmp(formula, "triangle.single_layer") == 0 ? 0 : -1; }

int cageproof_judge_double(const cageproof_judge_block* block, const double* corners, const double* parameters,
                           const double* points, double* values, double* gradients, double* hessians) {
  (void)corners, (void)parameters, (void)points, (void)gradients, (void)hessians;
  for (size_t p = 0; p < block->count; ++p) values[p] = 0.0625;
  return CAGEPROOF_JUDGE_DONE;
}
