/* SPDX-License-Identifier: MIT
 * The zoo: small implementations, each with one defect that real ones have, and otherwise sound. C and C++ read this.
 */
#ifndef CAGEPROOF_JUDGE_ZOO_H
#define CAGEPROOF_JUDGE_ZOO_H

#include <stddef.h>

/* Names are C's. NOLINTBEGIN(readability-identifier-naming) */

/* One element and a block of points. Points and corners have three coordinates each, in the plane the third is zero. */
struct zoo_call {
  const char* formula;      /* the catalogue's name, such as "triangle.solid_angle" */
  const double* corners;    /* the element's corners, one after the other */
  const double* parameters; /* in the catalogue's order; null where the formula has none */
  const double* points;     /* count of them */
  size_t count;
  int order;         /* 0: values, 1: gradients too */
  double* values;    /* [point][component] */
  double* gradients; /* [point][component][i], i below the dimension of the space; null for order 0 */
};

/* A cage of triangles and a block of points: mean value coordinates. */
struct zoo_cage {
  const double* vertices; /* three numbers each */
  size_t vertex_count;
  const int* faces; /* three indices each, counter-clockwise seen from outside */
  size_t face_count;
  const double* points; /* three numbers each */
  size_t count;
  double* coordinates; /* [point][vertex] */
};

/* What a point on a face is given: three weights for its corners. */
typedef void (*zoo_on_face)(const double* corners, const double* point, const double* basis, double* weights);

#ifdef __cplusplus
extern "C" {
#endif

/* Numbers of a value; 0 for a formula that is not in the zoo. */
int zoo_components(const char* formula);
/* 2 for segments, 3 for triangles. */
int zoo_dimension(const char* formula);
/* The closed form in double, as one would write it, with stable branches. */
void zoo_sound(const struct zoo_call* call);
/* Mean value coordinates in a cage, sound except for points on faces, whose weights `on_face` gives; null: the right
 * ones. */
void zoo_mean_value(const struct zoo_cage* cage, zoo_on_face on_face);

/* NOLINTEND(readability-identifier-naming) */

#ifdef __cplusplus
}
#endif
#endif
