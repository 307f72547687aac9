/* SPDX-License-Identifier: MIT */
/* Vectors of three numbers, for the adapters. */
#ifndef CAGEPROOF_ADAPTERS_VECTORS_H
#define CAGEPROOF_ADAPTERS_VECTORS_H

#include <math.h>

static inline double dot(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static inline double length(const double* a) { return sqrt(dot(a, a)); }

static inline void minus(const double* a, const double* b, double* c) {
  for (int i = 0; i < 3; ++i) c[i] = a[i] - b[i];
}

static inline void cross(const double* a, const double* b, double* c) {
  for (int i = 0; i < 3; ++i) c[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

#endif
