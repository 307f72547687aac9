/* SPDX-License-Identifier: MIT */
/* Asks calls that Python asked (write_calls.py) from C, and compares results to the bit. Usage: calls FILE */
#include <cageproof.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { kMost = 1 << 16 };

typedef struct numbers {
  size_t size;
  double* data;
} numbers;

static numbers given, points, expected, found;

static int read(FILE* file, numbers* to) {
  char word[64];
  if (fscanf(file, "%zu", &to->size) != 1 || to->size > kMost) return 0;
  for (size_t i = 0; i < to->size; ++i) {
    if (fscanf(file, "%63s", word) != 1) return 0;
    to->data[i] = strtod(word, NULL);
  }
  return 1;
}

/* Where values end and derivatives begin. */
static size_t values(int order, size_t dimension) { return expected.size / (order == 0 ? 1 : 1 + dimension); }

static int evaluate(const char* name, int order) {
  cageproof_formula shape;
  const cageproof_request request = {name, NULL, NULL, 0, order, CAGEPROOF_INSIDE};
  cageproof_tensors to = {{found.data, NULL, NULL}, {0, 0, 0}};
  if (cageproof_formula_of(name, &shape) != CAGEPROOF_OK) return 0;
  to.size[0] = values(order, (size_t)shape.dimension);
  if (order == 1) {
    to.data[1] = found.data + to.size[0];
    to.size[1] = expected.size - to.size[0];
  }
  return cageproof_evaluate(&request, given.data, given.size, points.data, points.size, &to) == CAGEPROOF_OK;
}

static int coordinates(const char* name, const cageproof_cage* cage, int order) {
  cageproof_coordinates* made = NULL;
  const size_t first = values(order, 3);
  const int good = cageproof_coordinates_make(cage, name, NULL, 0, &made) == CAGEPROOF_OK &&
                   cageproof_coordinates_evaluate(made, points.data, points.size, found.data, first, order ? found.data + first : NULL,
                                                  expected.size - first, NULL, 0) == CAGEPROOF_OK;
  cageproof_coordinates_free(made);
  return good;
}

static int images(const char* name, const cageproof_cage* cage, int order) {
  cageproof_deformer* made = NULL;
  const size_t first = values(order, 3);
  const int good = cageproof_deformer_make(cage, name, NULL, 0, &made) == CAGEPROOF_OK &&
                   cageproof_deformer_pose(made, given.data, given.size) == CAGEPROOF_OK &&
                   cageproof_deformer_images(made, points.data, points.size, found.data, first, order ? found.data + first : NULL,
                                             expected.size - first) == CAGEPROOF_OK;
  cageproof_deformer_free(made);
  return good;
}

static int places(const cageproof_cage* cage) {
  static int32_t place[kMost], face[kMost];
  cageproof_inside* made = NULL;
  const size_t count = points.size / 3;
  const int good = cageproof_inside_make(cage, 0, NULL, 0, &made) == CAGEPROOF_OK &&
                   cageproof_inside_points(made, points.data, points.size, 0, place, count, face, count, found.data + 2 * count, count,
                                           NULL, 0) == CAGEPROOF_OK;
  for (size_t i = 0; good && i < count; ++i) {
    found.data[i] = place[i];
    found.data[count + i] = face[i];
  }
  cageproof_inside_free(made);
  return good;
}

int main(int argc, char** argv) {
  char what[16], name[64], of[32];
  int order;
  long calls = 0, results = 0;
  FILE* file = argc > 1 ? fopen(argv[1], "r") : NULL;
  numbers* const all[4] = {&given, &points, &expected, &found};
  for (int i = 0; i < 4; ++i) all[i]->data = malloc(kMost * sizeof(double));
  if (file == NULL) return 2;
  while (fscanf(file, "%15s %63s %31s %d", what, name, of, &order) == 4) {
    cageproof_cage* cage = NULL;
    int good = read(file, &given) && read(file, &points) && read(file, &expected);
    if (good && of[0] != '-') good = cageproof_cage_embedded(of, &cage) == CAGEPROOF_OK;
    if (good)
      good = strcmp(what, "evaluate") == 0      ? evaluate(name, order)
             : strcmp(what, "coordinates") == 0 ? coordinates(name, cage, order)
             : strcmp(what, "images") == 0      ? images(name, cage, order)
                                                : places(cage);
    cageproof_cage_free(cage);
    ++calls;
    for (size_t i = 0; good && i < expected.size; ++i, ++results)
      good = memcmp(&found.data[i], &expected.data[i], sizeof(double)) == 0 ||
             (found.data[i] != found.data[i] && expected.data[i] != expected.data[i]);
    if (!good) {
      printf("FAILED: line %ld, %s %s %s: not the bits that Python got (%s)\n", calls, what, name, of, cageproof_error());
      return 1;
    }
  }
  printf("C: %ld calls, %ld numbers, the bits that Python got\n", calls, results);
  return calls == 2000 ? 0 : 1;
}
