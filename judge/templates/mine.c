/* SPDX-License-Identifier: MIT */
/* A library for `cageproof judge`: the angle that a segment of the plane is seen under. Replace the formula by yours.
 *
 *   cc -O2 -shared -fPIC -I. mine.c -o libmine.so -lm
 *   cageproof judge mine=./libmine.so
 */
#include "cageproof_judge.h"

#include <math.h>
#include <string.h>

int cageproof_judge_version(void) { return CAGEPROOF_JUDGE_VERSION; }

const char* cageproof_judge_about(void) { return "winding angle by the arctangent, 1.0"; }

/* The highest derivative that is given: 0 is the value, -1 says that the formula is not there. */
int cageproof_judge_order(const char* formula) { return strcmp(formula, "segment.winding_angle") == 0 ? 0 : -1; }

/* atan2(a x b, a . b) of the ends as the point sees them (K. Hormann and A. Agathos, "The point in polygon problem for
 * arbitrary polygons", Comput. Geom. 20 (2001), Section 2). a x b is the nearer end times the segment itself, which loses
 * nothing far away or near an end. There is no threshold. At an end it is a right angle, half of what the inside sees on the
 * segment. */
static double winding_angle(const double* corners, const double* point) {
  const double a[2] = {corners[0] - point[0], corners[1] - point[1]};
  const double b[2] = {corners[2] - point[0], corners[3] - point[1]};
  const double side[2] = {corners[2] - corners[0], corners[3] - corners[1]};
  const double* const nearer = hypot(a[0], a[1]) < hypot(b[0], b[1]) ? a : b;
  if (nearer[0] == 0 && nearer[1] == 0) return acos(0);
  return atan2(nearer[0] * side[1] - nearer[1] * side[0], a[0] * b[0] + a[1] * b[1]);
}

int cageproof_judge_double(const cageproof_judge_block* block, const double* corners, const double* parameters,
                           const double* points, double* values, double* gradients, double* hessians) {
  (void)parameters, (void)gradients, (void)hessians;
  for (size_t p = 0; p < block->count; ++p) values[p] = winding_angle(corners, points + 2 * p);
  return CAGEPROOF_JUDGE_DONE;
}
