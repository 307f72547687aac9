/* SPDX-License-Identifier: MIT */
/* A library that only has whole cages: mean value coordinates, as Ju et al. 2005 have them. The environment names what
 * it does wrong: "threshold" all over, anything else at points whose x is 0.5. */
#include "cageproof_judge.h"

#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

int cageproof_judge_version(void) { return CAGEPROOF_JUDGE_VERSION; }

static void minus(const double* a, const double* b, double* c) {
  for (int i = 0; i < 3; ++i) c[i] = a[i] - b[i];
}

static double dot(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void cross(const double* a, const double* b, double* c) {
  for (int i = 0; i < 3; ++i) c[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* Adds a face's weights, or sets those of a point on it. Returns whether it is on it. */
static int add_face(const double* const corner[3], const double* point, double threshold, double weight[3]) {
  double d[3][3], n[3][3], mean[3] = {0, 0, 0}, across[3], side[3], other[3], area[3];
  for (int k = 0; k < 3; ++k) minus(corner[k], point, d[k]);
  for (int k = 0; k < 3; ++k) {
    minus(d[(k + 2) % 3], d[(k + 1) % 3], side);
    cross(d[(k + 1) % 3], side, n[k]);
  }
  const double det = dot(d[0], n[0]);
  minus(d[1], d[0], side);
  minus(d[2], d[0], other);
  cross(side, other, across);
  for (int k = 0; k < 3; ++k) area[k] = dot(n[k], across);
  for (int k = 0; k < 3; ++k) weight[k] = 0;
  if (fabs(det) <= threshold) {
    if (area[0] < 0 || area[1] < 0 || area[2] < 0) return 0;
    for (int k = 0; k < 3; ++k) weight[k] = area[k] / (area[0] + area[1] + area[2]);
    return 1;
  }
  for (int k = 0; k < 3; ++k) {
    const double length = sqrt(dot(n[k], n[k])), angle = atan2(length, dot(d[(k + 1) % 3], d[(k + 2) % 3]));
    for (int i = 0; i < 3; ++i) mean[i] += angle * n[k][i] / length;
  }
  for (int k = 0; k < 3; ++k) weight[k] = dot(n[k], mean) / det;
  return 0;
}

static void mean_value(const cageproof_judge_cage* cage, const double* vertices, const int* faces, const double* point,
                       double threshold, double* weights) {
  memset(weights, 0, cage->coordinates * sizeof *weights);
  for (size_t f = 0; f < cage->face_count; ++f) {
    const double* const corner[3] = {vertices + 3 * faces[3 * f], vertices + 3 * faces[3 * f + 1],
                                     vertices + 3 * faces[3 * f + 2]};
    double weight[3];
    const int is_on = add_face(corner, point, threshold, weight);
    if (is_on) memset(weights, 0, cage->coordinates * sizeof *weights);
    for (int k = 0; k < 3; ++k) weights[faces[3 * f + (size_t)k]] += weight[k];
    if (is_on) break;
  }
  double sum = 0;
  for (size_t i = 0; i < cage->coordinates; ++i) sum += weights[i];
  for (size_t i = 0; i < cage->coordinates; ++i) weights[i] /= sum;
}

int cageproof_judge_coordinates(const cageproof_judge_cage* cage, const double* vertices, const int* faces,
                                const double* points, double* coordinates) {
  const char* const what = getenv("HOSTILE") != NULL ? getenv("HOSTILE") : "";
  if (strcmp(cage->kind, "mean_value") != 0) return CAGEPROOF_JUDGE_DECLINED;
  for (size_t p = 0; p < cage->count; ++p)
    mean_value(cage, vertices, faces, points + 3 * p, strcmp(what, "threshold") == 0 ? 1e-8 : 0,
               coordinates + p * cage->coordinates);
  if (points[0] != 0.5) return CAGEPROOF_JUDGE_DONE;
  if (strcmp(what, "crash") == 0) raise(SIGSEGV);
  if (strcmp(what, "decline") == 0) return CAGEPROOF_JUDGE_DECLINED;
  if (strcmp(what, "read beyond") == 0) coordinates[0] = faces[3 * cage->face_count];
  if (strcmp(what, "write beyond") == 0) coordinates[cage->count * cage->coordinates] = 7;
  if (strcmp(what, "change input") == 0) ((int*)faces)[0] = 7;
  if (strcmp(what, "short") == 0) memcpy(coordinates, &(unsigned long long){0x7ff8c0ffee15bad5}, sizeof(double));
  return CAGEPROOF_JUDGE_DONE;
}
