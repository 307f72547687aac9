/* SPDX-License-Identifier: MIT */
/* Cageproof's C interface (C99): cage coordinates, deformers, potentials of single elements. Link `libcageproof.so`.
 *
 * Arrays are row-major and of double; every array comes with its size, in numbers (not bytes), which is checked.
 * Indices count from 0. Points and vertices have 3 numbers each, in the plane 2. Angles are in radians; lengths are in
 * the caller's unit.
 *
 * Functions that can fail return CAGEPROOF_OK or the code of an error, and cageproof_error() has its text: one line,
 * of the last call of the same thread. After an error, outputs are unspecified and handles unchanged. NULL is allowed
 * only where a comment says so. Several threads may use a handle at once, except in `cageproof_deformer_pose` and the
 * functions that free it.
 *
 * Handles are not checked, for speed. With CAGEPROOF_CHECK_HANDLES in the environment, and in debug builds of the
 * library, one that was freed or never made is an error; functions that free then do nothing but say so by
 * cageproof_error(). Each handle then keeps some memory after it was freed. */
#ifndef CAGEPROOF_C_H
#define CAGEPROOF_C_H

#include <stddef.h>
#include <stdint.h>

/* Names are C's. NOLINTBEGIN(readability-identifier-naming) */

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define CAGEPROOF_API __attribute__((visibility("default")))
#else
#define CAGEPROOF_API
#endif

/* Rises with every change that programs must be compiled again for. */
#define CAGEPROOF_ABI_VERSION 1
/* The loaded library's CAGEPROOF_ABI_VERSION; compare it with that of this header. */
CAGEPROOF_API int cageproof_abi_version(void);
/* "0.1.0" */
CAGEPROOF_API const char* cageproof_version(void);

enum {
  CAGEPROOF_OK = 0,
  CAGEPROOF_BAD_INPUT = 1, /* an argument is wrong: an array, a name, a cage */
  CAGEPROOF_NO_MEMORY = 2,
  CAGEPROOF_INTERNAL = 3 /* anything else */
};

/* The error text of this thread's last call that returned a code; "" after CAGEPROOF_OK. Valid until the thread's next
 * call. */
CAGEPROOF_API const char* cageproof_error(void);

/* Writes names, one per line. of: "kinds" of coordinates, "methods" of deformers, "formulas", built-in "cages", or a
 * formula's name for its evaluations, the recommended one first.
 * text: NULL, or room for `size` characters; needed: the number of characters, the final zero included. A text that
 * does not fit is an error. */
CAGEPROOF_API int cageproof_list(const char* of, char* text, size_t size, size_t* needed);

/* An option by name. Coordinates and deformers take "threads" (0: all cores), "evaluation", "triangulation" of quads
 * ("shortest" diagonal or "fan"), "flip_inward" ("1" reverses parts whose normals point inward) and
 * "allow_invalid_quads" ("0" or "1"); deformers also take "digits" (3 to 12, only "green"); formulas take "threads".
 * Any other name is a parameter of the kind, method or formula, such as "nu", "mu" or "pieces". Functions that take
 * other options say so. Unknown names are errors. */
typedef struct cageproof_option {
  const char* name;
  const char* value;
} cageproof_option;

/* ---- Cages ---- */

/* A mesh. The functions that make coordinates and deformers of it check it. */
typedef struct cageproof_cage cageproof_cage;

/* Makes a cage, which the caller frees. dimension: 3, or 2 for polygons. corners: vertex indices of all faces, one face
 * after another, counter-clockwise seen from outside. sizes: the number of corners of each face: 3 or 4, in the plane
 * 2. */
CAGEPROOF_API int cageproof_cage_make(int dimension, const double* vertices, size_t vertices_size,
                                      const int32_t* corners, size_t corners_size, const int32_t* sizes, size_t faces,
                                      cageproof_cage** cage);
/* Reads an OBJ file; faces of more than four corners are cut in triangles. */
CAGEPROOF_API int cageproof_cage_read(const char* file, cageproof_cage** cage);
/* Makes a built-in cage, such as "cube". */
CAGEPROOF_API int cageproof_cage_embedded(const char* name, cageproof_cage** cage);
/* Frees the cage. NULL is allowed, here and in all functions that free. Coordinates and deformers that were made of the
 * cage stay valid. */
CAGEPROOF_API void cageproof_cage_free(cageproof_cage* cage);
/* Returns an error, which names the face or vertex, for a cage that is not closed, not oriented or otherwise broken.
 * Options: "flip_inward", "allow_invalid_quads". */
CAGEPROOF_API int cageproof_cage_check(const cageproof_cage* cage, const cageproof_option* options, size_t count);
/* Gives the sizes for cageproof_cage_copy. Each pointer to a result may be NULL. vertices, corners: numbers in these
 * arrays. */
CAGEPROOF_API int cageproof_cage_sizes(const cageproof_cage* cage, int* dimension, size_t* vertices, size_t* corners,
                                       size_t* faces);
CAGEPROOF_API int cageproof_cage_copy(const cageproof_cage* cage, double* vertices, size_t vertices_size,
                                      int32_t* corners, size_t corners_size, int32_t* sizes, size_t faces);
/* Returns a warning about the cage's file (parts left out, faces cut in triangles), or NULL beyond the last. The cage
 * owns the text. */
CAGEPROOF_API const char* cageproof_cage_warning(const cageproof_cage* cage, size_t index);

/* ---- Coordinates ---- */

typedef struct cageproof_coordinates cageproof_coordinates;

/* A block of coordinates, such as the phi of all vertices. The handle owns the strings. */
typedef struct cageproof_block {
  const char* label; /* "phi", "psi", "lambda" ... */
  const char* one_a; /* what a coordinate belongs to: "vertex", "element", "corner" (element by element), "normal" */
  const char* reproduces; /* the data that it multiplies to reproduce a linear map: "vertices", "turned vertices",
                             "normals" (times normal_factor), or "nothing" */
  size_t count;           /* number of coordinates */
  size_t rows, columns;   /* shape of each coordinate; 1 and 1 for numbers */
  size_t offset;          /* position of the first number in a point's row of values */
  double normal_factor;
} cageproof_block;

CAGEPROOF_API int cageproof_coordinates_make(const cageproof_cage* cage, const char* kind,
                                             const cageproof_option* options, size_t count,
                                             cageproof_coordinates** coordinates);
CAGEPROOF_API void cageproof_coordinates_free(cageproof_coordinates* coordinates);
/* Each pointer to a result may be NULL. row: numbers per point of the values; derivatives have dimension^order times as
 * many. max_order: the highest order of derivatives that exists. */
CAGEPROOF_API int cageproof_coordinates_sizes(const cageproof_coordinates* coordinates, int* dimension, int* max_order,
                                              size_t* row, size_t* blocks, size_t* elements);
CAGEPROOF_API int cageproof_coordinates_block(const cageproof_coordinates* coordinates, size_t index,
                                              cageproof_block* block);
/* Gives the elements that coordinates belong to. corners: 4 per element, -1 beyond its last; faces: the cage's face
 * that the element is, or is a part of; normals: unit and outward, `dimension` numbers each. Each array may be NULL,
 * with size 0. */
CAGEPROOF_API int cageproof_coordinates_elements(const cageproof_coordinates* coordinates, int32_t* corners,
                                                 size_t corners_size, int32_t* faces, size_t faces_size,
                                                 double* normals, size_t normals_size);
/* Computes values [point][number], gradients [point][number][axis] and Hessians [point][number][axis][axis]. Gradients
 * and Hessians may be NULL, with size 0; Hessians need gradients. On the cage, results are limits from inside.
 * Derivatives that do not exist, and values at points without coordinates, are NaN. */
CAGEPROOF_API int cageproof_coordinates_evaluate(const cageproof_coordinates* coordinates, const double* points,
                                                 size_t points_size, double* values, size_t values_size,
                                                 double* gradients, size_t gradients_size, double* hessians,
                                                 size_t hessians_size);
/* Computes sums of coordinates times data, without keeping coordinates; only for kinds whose coordinates are numbers.
 * data: [number][function]; sums: [point][function]. */
CAGEPROOF_API int cageproof_coordinates_apply(const cageproof_coordinates* coordinates, const double* points,
                                              size_t points_size, const double* data, size_t data_size, int functions,
                                              double* sums, size_t sums_size);

/* Multiply with the derivative of values by the cage's vertices, for points that stay where they are; only for the kind
 * "green", in space and in the plane. jvp: the derivative times a change of the vertices gives the change of the
 * values; NaN on edges and vertices. vjp: the transposed derivative times weights of the values gives one number per
 * number of the cage's vertices. Threads do not change the result. */
CAGEPROOF_API int cageproof_coordinates_jvp(const cageproof_coordinates* coordinates, const double* points,
                                            size_t points_size, const double* change, size_t change_size,
                                            double* values, size_t values_size);
CAGEPROOF_API int cageproof_coordinates_vjp(const cageproof_coordinates* coordinates, const double* points,
                                            size_t points_size, const double* weights, size_t weights_size,
                                            double* vertices, size_t vertices_size);

/* ---- Deformers ---- */

typedef struct cageproof_deformer cageproof_deformer;
/* Points whose coordinates are kept for many poses. */
typedef struct cageproof_bound cageproof_bound;

CAGEPROOF_API int cageproof_deformer_make(const cageproof_cage* rest, const char* method,
                                          const cageproof_option* options, size_t count, cageproof_deformer** deformer);
CAGEPROOF_API void cageproof_deformer_free(cageproof_deformer* deformer);
/* Sets the pose. vertices: those of the posed cage, in the rest cage's order. No other thread may use the deformer
 * meanwhile. */
CAGEPROOF_API int cageproof_deformer_pose(cageproof_deformer* deformer, const double* vertices, size_t vertices_size);
/* Computes images of points. images: as many numbers as points have; jacobians: NULL with size 0, or
 * [point][component][axis]. NaN for points without image, such as those outside the cage with "green". */
CAGEPROOF_API int cageproof_deformer_images(const cageproof_deformer* deformer, const double* points,
                                            size_t points_size, double* images, size_t images_size, double* jacobians,
                                            size_t jacobians_size);
/* Computes and keeps the points' coordinates. with_jacobians: 1 if images may have Jacobians, otherwise 0. */
CAGEPROOF_API int cageproof_deformer_bind(const cageproof_deformer* deformer, const double* points, size_t points_size,
                                          int with_jacobians, cageproof_bound** bound);
CAGEPROOF_API void cageproof_bound_free(cageproof_bound* bound);
/* Computes images of points that this deformer bound: the same numbers as for the points themselves. */
CAGEPROOF_API int cageproof_bound_images(const cageproof_deformer* deformer, const cageproof_bound* bound,
                                         double* images, size_t images_size, double* jacobians, size_t jacobians_size);

/* Multiply with J, the derivative of images by the posed vertices at the deformer's pose. J takes no differences, and
 * accounts for posed normals, their lengths, and all else that the method makes of the pose. It is an error if the
 * method has no derivative (the text names methods that have one), or if a posed element without area or length has a
 * normal without derivative.
 *
 * jvp: J times a change of the posed vertices gives the change of the images; NaN for points without image. */
CAGEPROOF_API int cageproof_deformer_jvp(const cageproof_deformer* deformer, const double* points, size_t points_size,
                                         const double* change, size_t change_size, double* images, size_t images_size);
CAGEPROOF_API int cageproof_bound_jvp(const cageproof_deformer* deformer, const cageproof_bound* bound,
                                      const double* change, size_t change_size, double* images, size_t images_size);
/* vjp: the transposed J times weights of the images; from a function's derivatives by the images it makes those by the
 * posed vertices. Weights of points without image must be zero. Threads do not change the result. */
CAGEPROOF_API int cageproof_deformer_vjp(const cageproof_deformer* deformer, const double* points, size_t points_size,
                                         const double* weights, size_t weights_size, double* vertices,
                                         size_t vertices_size);
CAGEPROOF_API int cageproof_bound_vjp(const cageproof_deformer* deformer, const cageproof_bound* bound,
                                      const double* weights, size_t weights_size, double* vertices,
                                      size_t vertices_size);

/* ---- Inside ---- */

typedef struct cageproof_inside cageproof_inside;

/* Prepares inside tests. any_mesh: 0 for a cage, which is checked, and whose answers are exact; 1 for any faces in
 * space, also open, overlapping or inconsistently oriented. Options: "triangulation", "flip_inward", "keep_quads" ("1"
 * keeps quads as bilinear surfaces). */
CAGEPROOF_API int cageproof_inside_make(const cageproof_cage* cage, int any_mesh, const cageproof_option* options,
                                        size_t count, cageproof_inside** inside);
CAGEPROOF_API void cageproof_inside_free(cageproof_inside* inside);
/* Gives one number per point in each array; each array may be NULL, with size 0. places: 1 inside, 0 exactly on the
 * surface, -1 outside. faces: the first face that the point is on, or -1. windings: the winding number of the surface
 * around the point, NaN on the surface. bounds: the largest error of that, 0 for cages and closed meshes. With
 * any_mesh, points are inside if the winding number is above 1/2 or below -1/2. threads: 0 for all cores. */
CAGEPROOF_API int cageproof_inside_points(const cageproof_inside* inside, const double* points, size_t points_size,
                                          int threads, int32_t* places, size_t places_size, int32_t* faces,
                                          size_t faces_size, double* windings, size_t windings_size, double* bounds,
                                          size_t bounds_size);

/* ---- Potentials of elements ---- */

/* The shape of a formula's input and result. The result for an element and a point has `tensors` of rows x columns. */
typedef struct cageproof_formula {
  int dimension;     /* of space: 2 or 3 */
  int corners;       /* of an element: 2 segment, 3 triangle, 4 bilinear quad */
  int tensors;       /* 1, or `corners` */
  int rows, columns; /* 1 and 1 for numbers, `dimension` for matrices */
} cageproof_formula;
CAGEPROOF_API int cageproof_formula_of(const char* formula, cageproof_formula* shape);

/* The limit that points on an element get. On edges and corners of an element, and for derivatives on it, only
 * CAGEPROOF_INSIDE exists; the others are NaN. */
enum { CAGEPROOF_INSIDE = 0, CAGEPROOF_OUTSIDE = 1, CAGEPROOF_MEAN = 2 };

/* What to compute. evaluation: NULL for the recommended one. Options: "threads", and the formula's parameters. */
typedef struct cageproof_request {
  const char* formula;    /* "triangle.double_layer" ... */
  const char* evaluation; /* "hybrid", "closed_form", "accurate" ...; or NULL. "batched": values of all pairs, or their
                             sums, of single, double and biharmonic layers on triangles and segments, many times as
                             quickly. Digits are then those of the largest value at a point, in the list's own size. */
  const cageproof_option* options;
  size_t option_count;
  int order; /* 0: values; 1: also gradients; 2: also Hessians; each needs its output array */
  int side;  /* CAGEPROOF_INSIDE ... */
} cageproof_request;

/* Arrays for values, gradients and Hessians by the point; NULL with size 0 for those above the order. */
typedef struct cageproof_tensors {
  double* data[3];
  size_t size[3];
} cageproof_tensors;

/* Computes one result per pair: elements [n][corner][axis] and points [n][axis], or one element with n points, or n
 * elements with one point. Results: [n][tensor][row][column]; derivatives add [axis] at the end. */
CAGEPROOF_API int cageproof_evaluate(const cageproof_request* request, const double* elements, size_t elements_size,
                                     const double* points, size_t points_size, const cageproof_tensors* results);
/* Computes all pairs: [point][element][tensor][row][column]; derivatives add [axis] at the end. */
CAGEPROOF_API int cageproof_potentials(const cageproof_request* request, const double* elements, size_t elements_size,
                                       const double* points, size_t points_size, const cageproof_tensors* results);
/* Computes sums over elements of tensors times densities, without keeping pairs. densities:
 * [element][tensor][column][set]; results: [point][row][set]; derivatives add [axis] at the end. */
CAGEPROOF_API int cageproof_potentials_apply(const cageproof_request* request, const double* elements,
                                             size_t elements_size, const double* densities, size_t densities_size,
                                             int sets, const double* points, size_t points_size,
                                             const cageproof_tensors* results);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming) */

#endif
