/* SPDX-License-Identifier: MIT */
/* Mean value coordinates by the pseudocode of T. Ju, S. Schaefer and J. Warren, "Mean value coordinates for closed
 * triangular meshes", SIGGRAPH 2005, Figure 4, for `cageproof judge --kind mean_value` (docs/judged.md). The paper
 * leaves epsilon open; 1e-8 is what people take. */
#include "cageproof_judge.h"
#include "vectors.h"

#include <string.h>

static const double kEpsilon = 1e-8, kPi = 3.14159265358979323846;

int cageproof_judge_version(void) { return CAGEPROOF_JUDGE_VERSION; }
const char* cageproof_judge_about(void) { return "Ju et al. 2005, Figure 4, epsilon 1e-8"; }

enum { added, skipped, on_face };

static int face_weights(const double u[3][3], const double d[3], double w[3]) {
  double theta[3], c[3], s[3], chord[3], across[3], h = 0;
  for (int i = 0; i < 3; ++i) {
    minus(u[(i + 1) % 3], u[(i + 2) % 3], chord);
    theta[i] = 2 * asin(fmin(1, length(chord) / 2));
    h += theta[i] / 2;
  }
  if (kPi - h < kEpsilon) {
    for (int i = 0; i < 3; ++i) w[i] = sin(theta[i]) * d[(i + 1) % 3] * d[(i + 2) % 3];
    return on_face;
  }
  cross(u[1], u[2], across);
  const double sign = dot(u[0], across) < 0 ? -1 : 1;
  for (int i = 0; i < 3; ++i) {
    c[i] = 2 * sin(h) * sin(h - theta[i]) / (sin(theta[(i + 1) % 3]) * sin(theta[(i + 2) % 3])) - 1;
    s[i] = sign * sqrt(fmax(0, 1 - c[i] * c[i]));
  }
  for (int i = 0; i < 3; ++i)
    if (fabs(s[i]) <= kEpsilon) return skipped;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    w[i] = (theta[i] - c[j] * theta[k] - c[k] * theta[j]) / (d[i] * sin(theta[j]) * s[k]);
  }
  return added;
}

static void coordinates_at(const cageproof_judge_cage* cage, const double* vertices, const int* faces,
                           const double* point, double* weights) {
  memset(weights, 0, cage->coordinates * sizeof *weights);
  for (size_t f = 0; f < cage->face_count; ++f) {
    double u[3][3], d[3], w[3];
    for (int k = 0; k < 3; ++k) {
      minus(vertices + 3 * faces[3 * f + (size_t)k], point, u[k]);
      d[k] = length(u[k]);
      if (d[k] < kEpsilon) {
        memset(weights, 0, cage->coordinates * sizeof *weights);
        weights[faces[3 * f + (size_t)k]] = 1;
        return;
      }
      for (int i = 0; i < 3; ++i) u[k][i] /= d[k];
    }
    const int found = face_weights((const double(*)[3])u, d, w);
    if (found == skipped) continue;
    if (found == on_face) memset(weights, 0, cage->coordinates * sizeof *weights);
    for (int k = 0; k < 3; ++k) weights[faces[3 * f + (size_t)k]] += w[k];
    if (found == on_face) break;
  }
  double sum = 0;
  for (size_t i = 0; i < cage->coordinates; ++i) sum += weights[i];
  for (size_t i = 0; i < cage->coordinates; ++i) weights[i] /= sum;
}

int cageproof_judge_coordinates(const cageproof_judge_cage* cage, const double* vertices, const int* faces,
                                const double* points, double* coordinates) {
  if (strcmp(cage->kind, "mean_value") != 0) return CAGEPROOF_JUDGE_DECLINED;
  for (size_t p = 0; p < cage->count; ++p)
    coordinates_at(cage, vertices, faces, points + 3 * p, coordinates + p * cage->coordinates);
  return CAGEPROOF_JUDGE_DONE;
}
