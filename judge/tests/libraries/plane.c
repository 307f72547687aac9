/* SPDX-License-Identifier: MIT */
/* A library that only has polygons in the plane: mean value coordinates, as Floater 2003 has them. The environment names
 * what it does wrong: "threshold" all over, "read beyond" at points whose x is 0.5. */
#include "cageproof_judge.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int cageproof_judge_version(void) { return CAGEPROOF_JUDGE_VERSION; }

static void mean_value(const cageproof_judge_cage* cage, const double* vertices, const int* segments,
                       const double* point, double threshold, double* weights) {
  memset(weights, 0, cage->coordinates * sizeof *weights);
  for (size_t s = 0; s < cage->face_count; ++s) {
    const int from = segments[2 * s], to = segments[2 * s + 1];
    const double* const end[2] = {vertices + 2 * from, vertices + 2 * to};
    const double a[2] = {end[0][0] - point[0], end[0][1] - point[1]};
    const double b[2] = {end[1][0] - point[0], end[1][1] - point[1]};
    const double to_a = hypot(a[0], a[1]), to_b = hypot(b[0], b[1]), inner = a[0] * b[0] + a[1] * b[1];
    const double* const nearer = to_a < to_b ? a : b;
    const double area = nearer[0] * (b[1] - a[1]) - nearer[1] * (b[0] - a[0]);
    if (fabs(area) <= threshold) {
      if (inner > 0) continue;
      memset(weights, 0, cage->coordinates * sizeof *weights);
      weights[from] = to_b / (to_a + to_b);
      weights[to] = to_a / (to_a + to_b);
      return;
    }
    const double tangent = inner < 0 ? (to_a * to_b - inner) / area : area / (to_a * to_b + inner);
    weights[from] += tangent / to_a;
    weights[to] += tangent / to_b;
  }
  double sum = 0;
  for (size_t i = 0; i < cage->coordinates; ++i) sum += weights[i];
  for (size_t i = 0; i < cage->coordinates; ++i) weights[i] /= sum;
}

int cageproof_judge_plane_coordinates(const cageproof_judge_cage* cage, const double* vertices, const int* segments,
                                      const double* points, double* coordinates) {
  const char* const what = getenv("HOSTILE") != NULL ? getenv("HOSTILE") : "";
  if (strcmp(cage->kind, "mean_value") != 0) return CAGEPROOF_JUDGE_DECLINED;
  for (size_t p = 0; p < cage->count; ++p)
    mean_value(cage, vertices, segments, points + 2 * p, strcmp(what, "threshold") == 0 ? 1e-8 : 0,
               coordinates + p * cage->coordinates);
  if (points[0] == 0.5 && strcmp(what, "read beyond") == 0) coordinates[0] = segments[2 * cage->face_count];
  return CAGEPROOF_JUDGE_DONE;
}
