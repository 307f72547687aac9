/* SPDX-License-Identifier: MIT */
/* The interface of a library that `cageproof judge NAME=./libmine.so` judges: C99, no dependency, any language that can
 * export C functions. The library runs in a process of its own.
 * Element: corners in the order of docs/coordinates.md, three coordinates each (two in the plane, for segments), as the
 * points. Face normals follow the right hand rule; derivatives are with respect to the point.
 * Formulas are those of `cageproof list`: "triangle.single_layer", "triangle.double_layer", "segment.mean_value" ... */
#ifndef CAGEPROOF_JUDGE_H
#define CAGEPROOF_JUDGE_H

#include <stddef.h>

/* Version of this header. It grows when a function changes its meaning. */
#define CAGEPROOF_JUDGE_VERSION 1

/* What an evaluation returns: done, or "I do not have this" (the formula, the order, this input). A declined block is
 * counted and is no defect. Any other number is an error of the library, and a finding. */
#define CAGEPROOF_JUDGE_DONE 0
#define CAGEPROOF_JUDGE_DECLINED 1

#if defined(_WIN32)
#define CAGEPROOF_JUDGE_EXPORT __declspec(dllexport)
#else
#define CAGEPROOF_JUDGE_EXPORT __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Names are C's. NOLINTBEGIN(readability-identifier-naming) */

/* Required: returns CAGEPROOF_JUDGE_VERSION, so that a library that was built with another header is told apart. */
CAGEPROOF_JUDGE_EXPORT int cageproof_judge_version(void);

/* Optional: name and version of what is judged, in one line, for the certificate. The text stays the library's. */
CAGEPROOF_JUDGE_EXPORT const char* cageproof_judge_about(void);

/* A library is asked for elements (the next two functions), whole cages (the last two functions), or both.
 *
 * Elements: the highest derivative that the library gives of a formula: 0 value, 1 gradient, 2 Hessian; -1 where it
 * does not have the formula. */
CAGEPROOF_JUDGE_EXPORT int cageproof_judge_order(const char* formula);

/* One element and a block of points.
 *   formula          one that cageproof_judge_order has
 *   order            highest derivative wanted, at most what cageproof_judge_order said
 *   corners          [corner][coordinate]
 *   parameters       of the formula, as `cageproof list --json` orders them (a Poisson ratio ...); may be null if none
 *   points           [point][coordinate], `count` of them
 *   values           [point][component]; components are [corner][row][column] as far as the formula has them
 *   gradients        [point][component][i], derivative by coordinate i of the point; null where order < 1
 *   hessians         [point][component][i][j]; null where order < 2
 * Every number of the outputs is to be stored, whatever is there before. */
typedef struct cageproof_judge_block {
  const char* formula;
  int order;
  int dimension;    /* coordinates of a corner or point: 3, or 2 in the plane */
  int corner_count; /* 2 segment, 3 triangle, 4 quad */
  int parameter_count;
  int components; /* numbers of one value */
  size_t count;   /* points */
} cageproof_judge_block;

/* Elements, in double. Returns CAGEPROOF_JUDGE_DONE or CAGEPROOF_JUDGE_DECLINED. */
CAGEPROOF_JUDGE_EXPORT int cageproof_judge_double(const cageproof_judge_block* block, const double* corners,
                                                  const double* parameters, const double* points, double* values,
                                                  double* gradients, double* hessians);

/* Elements, optional: the same in float. */
CAGEPROOF_JUDGE_EXPORT int cageproof_judge_float(const cageproof_judge_block* block, const float* corners,
                                                 const float* parameters, const float* points, float* values,
                                                 float* gradients, float* hessians);

/* A cage of triangles and a block of points.
 *   kind         kind of coordinates, as "mean_value" or "green" of `cageproof list`
 *   vertices     [vertex][3]
 *   faces        [face][3], vertices counted from 0, counter-clockwise seen from outside
 *   points       [point][3]
 *   coordinates  [point][coordinate]: of all vertices, then, for kinds that have them (green), of all faces */
typedef struct cageproof_judge_cage {
  const char* kind;
  size_t vertex_count, face_count;
  size_t coordinates, count; /* of a point; points */
} cageproof_judge_cage;

/* Whole cages, in double. Returns CAGEPROOF_JUDGE_DONE or CAGEPROOF_JUDGE_DECLINED. */
CAGEPROOF_JUDGE_EXPORT int cageproof_judge_coordinates(const cageproof_judge_cage* cage, const double* vertices,
                                                       const int* faces, const double* points, double* coordinates);
/* Polygons in the plane, optional: [vertex][2], [segment][2], [point][2]; segments have the cage on their left. */
CAGEPROOF_JUDGE_EXPORT int cageproof_judge_plane_coordinates(const cageproof_judge_cage* cage, const double* vertices,
                                                             const int* segments, const double* points,
                                                             double* coordinates);

/* NOLINTEND(readability-identifier-naming) */

#ifdef __cplusplus
}
#endif
#endif
