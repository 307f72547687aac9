/* SPDX-License-Identifier: MIT */
/* Random calls of the C interface: null pointers, wrong sizes, numbers that are NaN, infinite, tiny or huge, on handles that
 * may be of broken cages, and with CAGEPROOF_CHECK_HANDLES in the environment on handles that were freed. Each gives a result or
 * an error with a text, and none crashes. Usage: hostile CALLS [SEED] */
#include <cageproof.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t state;
static unsigned below(unsigned count) {
  state ^= state << 13;
  state ^= state >> 7;
  state ^= state << 17;
  return (unsigned)((state >> 11) % count);
}

static double number(void) {
  static const double odd[] = {NAN, INFINITY, -INFINITY, 1e308, -1e308, 5e-324, 0, -0.0, 1e-160, 1e160, 1, 0.5};
  if (below(60) == 0) return odd[below(sizeof odd / sizeof *odd)];
  return below(3) == 0 ? (double)below(5) / 2 - 1 : (double)below(1000001) / 500000 - 1;
}

enum { kRoom = 600 };
static double in[4][kRoom], out[3][kRoom * 9];
static int32_t indices[kRoom], sizes[kRoom];
static double* numbers(int which) {
  if (below(25) == 0) return NULL;
  for (int i = 0; i < 60; ++i) in[which][below(6) == 0 ? below(kRoom) : below(24)] = number();
  return in[which];
}
static double* room(int which) { return below(25) == 0 ? NULL : out[which]; }
static size_t size(size_t right) { return below(8) == 0 ? below(kRoom) : right < kRoom * 9 ? right : 0; }

/* Handles that were freed, of any kind, which calls get now and then in place of their own. */
enum { kDead = 64 };
static void* dead[kDead];
static unsigned deaths = 0;
static int watched, is_dead = 0;
static long dead_used = 0;
static void* or_dead(void* handle) {
  if (!watched || deaths == 0 || below(20) != 0) return handle;
  is_dead = 1;
  return dead[below(deaths < kDead ? deaths : kDead)];
}

static long counts[4];
static int check(int code) {
  const char* text = cageproof_error();
  const int refused = code == CAGEPROOF_BAD_INPUT && strstr(text, "freed") != NULL;
  if (code < 0 || code > 2 || (code == CAGEPROOF_OK) != (text[0] == '\0') || strchr(text, '\n') != NULL || refused != is_dead) {
    printf("FAILED: code %d with the text '%s'%s\n", code, text, is_dead ? ", on a handle that was freed" : "");
    exit(1);
  }
  dead_used += is_dead;
  is_dead = 0;
  ++counts[code];
  return code;
}

/* Frees it, and now and then once more. */
static void end(void* handle, void (*free_it)(void*)) {
  free_it(handle);
  if (!watched || handle == NULL) return;
  dead[deaths++ % kDead] = handle;
  if (below(10) != 0) return;
  is_dead = 1;
  free_it(handle);
  check(CAGEPROOF_BAD_INPUT);
}
static void free_cage(void* handle) { cageproof_cage_free(handle); }
static void free_coordinates(void* handle) { cageproof_coordinates_free(handle); }
static void free_deformer(void* handle) { cageproof_deformer_free(handle); }
static void free_bound(void* handle) { cageproof_bound_free(handle); }
static void free_inside(void* handle) { cageproof_inside_free(handle); }

static const char* one_of(const char* const* names, unsigned count) { return below(30) == 0 ? (below(2) ? NULL : "nonsense") : names[below(count)]; }

int main(int argc, char** argv) {
  static const char* const kinds[] = {"green", "mean_value", "quad_mean_value", "somigliana", "biharmonic", "spherical_mean_value", "quad_green"};
  static const char* const methods[] = {"green", "mean_value", "biharmonic_1_3", "somigliana"};
  static const char* const formulas[] = {"triangle.single_layer", "triangle.double_layer", "triangle.kelvin_traction", "quad.solid_angle",
                                         "quad.mean_value", "segment.single_layer", "triangle.biharmonic_double_layer"};
  static const char* const keys[] = {"threads", "nu", "evaluation", "triangulation", "digits", "flip_inward", "allow_invalid_quads", "keep_quads"};
  static const char* const values[] = {"1", "0", "0.3", "closed_form", "fan", "-1", "6", ""};
  const long calls = argc > 1 ? atol(argv[1]) : 20000;
  state = argc > 2 ? strtoull(argv[2], NULL, 10) : 88172645463325252u;
  watched = getenv("CAGEPROOF_CHECK_HANDLES") != NULL;
  for (long call = 0; call < calls; ++call) {
    cageproof_cage* cage = NULL;
    cageproof_option options[2];
    const size_t count = below(3);
    for (int i = 0; i < 2; ++i) {
      options[i].name = one_of(keys, 8);
      options[i].value = one_of(values, 8);
    }
    if (below(2)) {
      for (int i = 0; i < 40; ++i) indices[i] = below(30) == 0 ? (int32_t)(below(9) * 1000000007u) : (int32_t)below(8);
      for (int i = 0; i < 12; ++i) sizes[i] = below(30) == 0 ? -3 : 3 + (int32_t)below(2);
      check(cageproof_cage_make(below(9) == 0 ? (int)below(5) : 3, numbers(0), size(24), indices, size(12 * 3), below(30) ? sizes : NULL, size(12), &cage));
    } else {
      static const char* const cages[] = {"cube", "twisted-bar", "l-block", "tetrahedron", "square"};
      check(cageproof_cage_embedded(one_of(cages, 5), &cage));
    }
    const double* points = numbers(1);
    const size_t at = size(3 * below(8));
    if (below(3) == 0) {
      cageproof_coordinates* made = NULL;
      size_t row = 0;
      if (check(cageproof_coordinates_make(or_dead(cage), one_of(kinds, 7), options, count, &made)) == CAGEPROOF_OK) {
        check(cageproof_coordinates_sizes(or_dead(made), NULL, NULL, &row, NULL, NULL));
        const int order = (int)below(2);
        check(cageproof_coordinates_evaluate(or_dead(made), points, at, room(0), size(at / 3 * row), order ? room(1) : NULL, order ? size(at * row) : 0, NULL, 0));
        check(cageproof_coordinates_apply(or_dead(made), points, at, numbers(2), size(row), (int)below(3), room(2), size(at / 3)));
        check(cageproof_coordinates_jvp(or_dead(made), points, at, numbers(2), size(24), room(0), size(at / 3 * row)));
        check(cageproof_coordinates_vjp(or_dead(made), points, at, out[0], size(at / 3 * row), room(1), size(24)));
      }
      end(made, free_coordinates);
    } else if (below(2)) {
      cageproof_deformer* made = NULL;
      cageproof_bound* bound = NULL;
      if (check(cageproof_deformer_make(or_dead(cage), one_of(methods, 4), options, count, &made)) == CAGEPROOF_OK) {
        check(cageproof_deformer_pose(or_dead(made), numbers(3), size(24)));
        check(cageproof_deformer_images(or_dead(made), points, at, room(0), size(at), NULL, 0));
        check(cageproof_deformer_jvp(or_dead(made), points, at, numbers(2), size(24), room(0), size(at)));
        check(cageproof_deformer_vjp(or_dead(made), points, at, numbers(2), size(at), room(0), size(24)));
        if (check(cageproof_deformer_bind(or_dead(made), points, at, (int)below(2), &bound)) == CAGEPROOF_OK) {
          check(cageproof_bound_images(made, or_dead(bound), room(0), size(at), room(1), size(3 * at)));
          check(cageproof_bound_jvp(made, or_dead(bound), numbers(2), size(24), room(0), size(at)));
          check(cageproof_bound_vjp(made, or_dead(bound), numbers(2), size(at), room(0), size(24)));
        }
      }
      end(bound, free_bound);
      end(made, free_deformer);
    } else {
      cageproof_inside* made = NULL;
      if (check(cageproof_inside_make(or_dead(cage), (int)below(2), options, count, &made)) == CAGEPROOF_OK)
        check(cageproof_inside_points(or_dead(made), points, at, (int)below(3) - (below(20) == 0), sizes + 100, size(at / 3), NULL, 0, room(0), size(at / 3), NULL, 0));
      end(made, free_inside);
    }
    end(cage, free_cage);
    cageproof_formula shape;
    cageproof_request request = {one_of(formulas, 7), below(3) ? NULL : "closed_form", options, below(4) == 0 ? count : 0, (int)below(4) - (below(20) == 0), (int)below(4)};
    if (check(cageproof_formula_of(request.formula, &shape)) == CAGEPROOF_OK) {
      const size_t elements = 1 + below(2), corners = (size_t)(shape.corners * shape.dimension), asked = 1 + below(3);
      const size_t numbers_of = (size_t)(shape.tensors * shape.rows * shape.columns) * elements * asked;
      cageproof_tensors to;
      for (int o = 0; o < 3; ++o) {
        to.data[o] = room(o);
        to.size[o] = o <= request.order ? size(numbers_of * (o == 0 ? 1 : o == 1 ? (size_t)shape.dimension : (size_t)(shape.dimension * shape.dimension))) : 0;
      }
      const size_t of_points = size(asked * (size_t)shape.dimension);
      check(cageproof_potentials(&request, numbers(0), size(elements * corners), points, of_points, &to));
      check(cageproof_evaluate(&request, in[0], size(corners), points, of_points, &to));
      check(cageproof_potentials_apply(&request, in[0], size(elements * corners), in[2], size(elements * (size_t)(shape.tensors * shape.columns)), (int)below(3), points, of_points, &to));
    }
  }
  printf("%ld results and %ld errors (%ld on freed handles), no crash\n", counts[0], counts[1] + counts[2], dead_used);
  if (watched && dead_used < calls / 20) return 1;
  return counts[0] > calls / 2 && counts[1] > calls / 2 ? 0 : 1;
}
