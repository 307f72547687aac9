/* SPDX-License-Identifier: MIT */
/* Cageproof's C interface (C99): cage coordinates, deformers, potentials of single elements. Link `libcageproof.so`.
 *
 * Arrays are row-major and of double; every array comes with its size, in numbers (not bytes), which is checked.
 * Indices count from 0. Points and vertices have 3 numbers each, in the plane 2. Angles are in radians; lengths are in
 * the caller's unit.
 *
 * Functions that can fail return CAGEPROOF_OK or the code of an error, and cageproof_error() has its text: one line,
 * of the last call of the same thread. After an error outputs are unspecified, and handles are unchanged. NULL is
 * allowed only where it is said. A handle may be used by several threads at once, except by `cageproof_deformer_pose`,
 * and by the functions that free it.
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

/* Rises with every change after which programs must be compiled anew. */
#define CAGEPROOF_ABI_VERSION 1
/* What the loaded library has: compare it with CAGEPROOF_ABI_VERSION. */
CAGEPROOF_API int cageproof_abi_version(void);
/* "0.1.0" */
CAGEPROOF_API const char* cageproof_version(void);

enum {
  CAGEPROOF_OK = 0,
  CAGEPROOF_BAD_INPUT = 1, /* what was given: an array, a name, a cage */
  CAGEPROOF_NO_MEMORY = 2,
  CAGEPROOF_INTERNAL = 3 /* anything else */
};

/* The text of the last call of this thread that returned a code; "" if that was CAGEPROOF_OK. Valid until the thread's
 * next call. */
CAGEPROOF_API const char* cageproof_error(void);

/* Names, one per line: of = "kinds" of coordinates, "methods" of deformers, "formulas", "cages" that come with the
 * library, or a formula's name: its evaluations, the recommended one first.
 * text: NULL, or room for `size` characters; needed: the characters of the text with its final zero. A text that does
 * not fit is an error. */
CAGEPROOF_API int cageproof_list(const char* of, char* text, size_t size, size_t* needed);

/* An option by name. Coordinates and deformers take "threads" (0: all cores), "evaluation", "triangulation" of quads
 * ("shortest" diagonal or "fan"), "flip_inward" ("0" or "1": turns parts whose normals point inward) and
 * "allow_invalid_quads" ("0" or "1"); deformers also "digits" (3 to 12, of "green"); formulas "threads". Any other name
 * is a parameter of the kind, method or formula: "nu", "mu", "pieces" ... Functions that take other options say so.
 * None is ignored: a name that means nothing is an error. */
typedef struct cageproof_option {
  const char* name;
  const char* value;
} cageproof_option;

/* ---- Cages ---- */

/* A mesh, which is checked where coordinates are made of it. */
typedef struct cageproof_cage cageproof_cage;

/* dimension: 3, or 2 for polygons. corners: the vertices of all faces one after another, counter-clockwise seen from
 * outside; sizes: how many each face has: 3 or 4, in the plane 2. The handle is the caller's to free. */
CAGEPROOF_API int cageproof_cage_make(int dimension, const double* vertices, size_t vertices_size,
                                      const int32_t* corners, size_t corners_size, const int32_t* sizes, size_t faces,
                                      cageproof_cage** cage);
/* From an OBJ file; faces of more than four corners are cut in triangles. */
CAGEPROOF_API int cageproof_cage_read(const char* file, cageproof_cage** cage);
/* One of the cages that come with the library: "cube" ... */
CAGEPROOF_API int cageproof_cage_embedded(const char* name, cageproof_cage** cage);
/* Frees it; NULL is allowed, here and in all functions that free. Nothing that was made of it needs it. */
CAGEPROOF_API void cageproof_cage_free(cageproof_cage* cage);
/* Refuses a cage that is not closed, not oriented or otherwise broken, naming the face or vertex. Options:
 * "flip_inward", "allow_invalid_quads". */
CAGEPROOF_API int cageproof_cage_check(const cageproof_cage* cage, const cageproof_option* options, size_t count);
/* Each of the pointers to results may be NULL. vertices, corners: numbers in these arrays. */
CAGEPROOF_API int cageproof_cage_sizes(const cageproof_cage* cage, int* dimension, size_t* vertices, size_t* corners,
                                       size_t* faces);
CAGEPROOF_API int cageproof_cage_copy(const cageproof_cage* cage, double* vertices, size_t vertices_size,
                                      int32_t* corners, size_t corners_size, int32_t* sizes, size_t faces);
/* What a file was read with (something was left out, or cut in triangles): NULL beyond the last. The cage's own. */
CAGEPROOF_API const char* cageproof_cage_warning(const cageproof_cage* cage, size_t index);

/* ---- Coordinates ---- */

typedef struct cageproof_coordinates cageproof_coordinates;

/* Coordinates that belong together. Strings are the handle's own. */
typedef struct cageproof_block {
  const char* label;      /* "phi", "psi", "lambda" ... */
  const char* one_a;      /* "vertex", "element", "corner" (of elements, element by element), or "normal" */
  const char* reproduces; /* what it multiplies where a linear map is reproduced: "vertices", "turned vertices",
                             "normals" (times normal_factor), or "nothing" */
  size_t count;           /* coordinates */
  size_t rows, columns;   /* of each; 1 and 1 for numbers */
  size_t offset;          /* where its first number stands in a point's row of values */
  double normal_factor;
} cageproof_block;

CAGEPROOF_API int cageproof_coordinates_make(const cageproof_cage* cage, const char* kind,
                                             const cageproof_option* options, size_t count,
                                             cageproof_coordinates** coordinates);
CAGEPROOF_API void cageproof_coordinates_free(cageproof_coordinates* coordinates);
/* Each pointer to a result may be NULL. row: numbers per point of the values; with dimension^order times as many for
 * derivatives. max_order: the highest derivative there is. */
CAGEPROOF_API int cageproof_coordinates_sizes(const cageproof_coordinates* coordinates, int* dimension, int* max_order,
                                              size_t* row, size_t* blocks, size_t* elements);
CAGEPROOF_API int cageproof_coordinates_block(const cageproof_coordinates* coordinates, size_t index,
                                              cageproof_block* block);
/* The elements that coordinates belong to. corners: 4 per element, -1 beyond its last; faces: the cage's face that it
 * is or is part of; normals: `dimension` numbers, unit, outward. Each may be NULL, with size 0. */
CAGEPROOF_API int cageproof_coordinates_elements(const cageproof_coordinates* coordinates, int32_t* corners,
                                                 size_t corners_size, int32_t* faces, size_t faces_size,
                                                 double* normals, size_t normals_size);
/* Values [point][number], gradients [point][number][axis], Hessians [point][number][axis][axis]. Gradients and Hessians
 * may be NULL, with size 0; Hessians need gradients. On the cage: limits from inside; NaN for derivatives that do not
 * exist, and for points without coordinates. */
CAGEPROOF_API int cageproof_coordinates_evaluate(const cageproof_coordinates* coordinates, const double* points,
                                                 size_t points_size, double* values, size_t values_size,
                                                 double* gradients, size_t gradients_size, double* hessians,
                                                 size_t hessians_size);
/* Sums of coordinates times data, without keeping coordinates; of kinds whose coordinates are numbers. data:
 * [number][function]; sums: [point][function]. */
CAGEPROOF_API int cageproof_coordinates_apply(const cageproof_coordinates* coordinates, const double* points,
                                              size_t points_size, const double* data, size_t data_size, int functions,
                                              double* sums, size_t sums_size);

/* The derivative of values by the vertices of the cage, for points that stay where they are; of kind "green" alone, in
 * space and in the plane. jvp: times a change of the vertices (as many numbers as the cage has), the change of the
 * values; NaN on edges and vertices. vjp: the transposed derivative times weights of values, as many numbers as the
 * cage's vertices; the same bits with any number of threads. */
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
/* vertices: of the posed cage, in the rest cage's order. Not while another thread uses the deformer. */
CAGEPROOF_API int cageproof_deformer_pose(cageproof_deformer* deformer, const double* vertices, size_t vertices_size);
/* images: as many numbers as points have; jacobians: NULL with size 0, or [point][component][axis]. NaN for points
 * without image, such as those outside the cage by "green". */
CAGEPROOF_API int cageproof_deformer_images(const cageproof_deformer* deformer, const double* points,
                                            size_t points_size, double* images, size_t images_size, double* jacobians,
                                            size_t jacobians_size);
/* Keeps the points' coordinates. with_jacobians: 0, or 1 for images that may have Jacobians. */
CAGEPROOF_API int cageproof_deformer_bind(const cageproof_deformer* deformer, const double* points, size_t points_size,
                                          int with_jacobians, cageproof_bound** bound);
CAGEPROOF_API void cageproof_bound_free(cageproof_bound* bound);
/* Images of points that this deformer bound, the same numbers as those of the points themselves. */
CAGEPROOF_API int cageproof_bound_images(const cageproof_deformer* deformer, const cageproof_bound* bound,
                                         double* images, size_t images_size, double* jacobians, size_t jacobians_size);

/* The derivative J of images by the posed vertices, at the deformer's pose. No differences are taken: posed normals,
 * their lengths, and all that the method makes of the pose change with the vertices. Methods without derivatives are an
 * error that names those that have them, and so is a posed element without area or length whose normal has none.
 *
 * jvp: J times a change of the posed vertices (as many numbers as the pose), which is the change of the images; NaN for
 * points without image. */
CAGEPROOF_API int cageproof_deformer_jvp(const cageproof_deformer* deformer, const double* points, size_t points_size,
                                         const double* change, size_t change_size, double* images, size_t images_size);
CAGEPROOF_API int cageproof_bound_jvp(const cageproof_deformer* deformer, const cageproof_bound* bound,
                                      const double* change, size_t change_size, double* images, size_t images_size);
/* vjp: the transposed J times weights of images: from a function's derivatives by the images to those by the posed
 * vertices. Weights of points without image must be zero. The same bits with any number of threads. */
CAGEPROOF_API int cageproof_deformer_vjp(const cageproof_deformer* deformer, const double* points, size_t points_size,
                                         const double* weights, size_t weights_size, double* vertices,
                                         size_t vertices_size);
CAGEPROOF_API int cageproof_bound_vjp(const cageproof_deformer* deformer, const cageproof_bound* bound,
                                      const double* weights, size_t weights_size, double* vertices,
                                      size_t vertices_size);

/* ---- Inside ---- */

typedef struct cageproof_inside cageproof_inside;

/* any_mesh: 0 for a cage, which is checked, and whose answers are exact; 1 for any faces in space: open, turned over,
 * overlapping. Options: "triangulation", "flip_inward", "keep_quads" ("0" or "1": quads stay bilinear surfaces). */
CAGEPROOF_API int cageproof_inside_make(const cageproof_cage* cage, int any_mesh, const cageproof_option* options,
                                        size_t count, cageproof_inside** inside);
CAGEPROOF_API void cageproof_inside_free(cageproof_inside* inside);
/* One number per point in each array; each array may be NULL, with size 0. places: 1 inside, 0 on the surface, exactly,
 * -1 outside. faces: the first face that the point is on, or -1. windings: how often the surface winds around the
 * point, NaN on it; bounds: what that is off at most, 0 for cages and closed meshes. Of meshes inside is where they
 * wind by more than 1/2, of either sign. threads: 0 for all cores. */
CAGEPROOF_API int cageproof_inside_points(const cageproof_inside* inside, const double* points, size_t points_size,
                                          int threads, int32_t* places, size_t places_size, int32_t* faces,
                                          size_t faces_size, double* windings, size_t windings_size, double* bounds,
                                          size_t bounds_size);

/* ---- Potentials of elements ---- */

/* What a formula takes and gives per element and point: `tensors` (one, or one per corner) of rows x columns. */
typedef struct cageproof_formula {
  int dimension;     /* of space: 2 or 3 */
  int corners;       /* of an element: 2 segment, 3 triangle, 4 bilinear quad */
  int tensors;       /* 1, or `corners` */
  int rows, columns; /* 1 and 1 for numbers, `dimension` for matrices */
} cageproof_formula;
CAGEPROOF_API int cageproof_formula_of(const char* formula, cageproof_formula* shape);

/* Which limit points on an element get. Edges and corners of an element have only CAGEPROOF_INSIDE, and derivatives on
 * it too: others are NaN there. */
enum { CAGEPROOF_INSIDE = 0, CAGEPROOF_OUTSIDE = 1, CAGEPROOF_MEAN = 2 };

/* What is computed. evaluation: NULL for the recommended one. Options: "threads", and the formula's parameters. */
typedef struct cageproof_request {
  const char* formula;    /* "triangle.double_layer" ... */
  const char* evaluation; /* "hybrid", "closed_form", "accurate" ...; or NULL. "batched": values of all pairs, or their
                             sums, of single, double and biharmonic layers on triangles and segments, many times as
                             quickly. Digits are then those of the largest value at a point, in the list's own size. */
  const cageproof_option* options;
  size_t option_count;
  int order; /* 0 values, 1 and gradients, 2 and Hessians: as many of the output arrays are needed */
  int side;  /* CAGEPROOF_INSIDE ... */
} cageproof_request;

/* Where results go: values, gradients and Hessians by the point; NULL with size 0 for those that are not asked for. */
typedef struct cageproof_tensors {
  double* data[3];
  size_t size[3];
} cageproof_tensors;

/* One result per pair of an element and a point: elements [n][corner][axis], points [n][axis]; one element or one point
 * goes with all of the other. Results: [n][tensor][row][column], derivatives [axis] behind. */
CAGEPROOF_API int cageproof_evaluate(const cageproof_request* request, const double* elements, size_t elements_size,
                                     const double* points, size_t points_size, const cageproof_tensors* results);
/* All pairs: [point][element][tensor][row][column], derivatives behind. */
CAGEPROOF_API int cageproof_potentials(const cageproof_request* request, const double* elements, size_t elements_size,
                                       const double* points, size_t points_size, const cageproof_tensors* results);
/* Sums over elements of tensors times densities, without keeping pairs. densities: [element][tensor][column][set];
 * results: [point][row][set], derivatives behind. */
CAGEPROOF_API int cageproof_potentials_apply(const cageproof_request* request, const double* elements,
                                             size_t elements_size, const double* densities, size_t densities_size,
                                             int sets, const double* points, size_t points_size,
                                             const cageproof_tensors* results);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming) */

#endif
