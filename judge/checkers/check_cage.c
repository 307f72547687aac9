/* SPDX-License-Identifier: MIT
 * Checks coordinates of a whole cage against vectors of `cageproof vectors --kinds`: KIND.CAGE.txt. Plain C99; needs no
 * library but C's, and vector_checks.h beside it.
 *
 *     cc -std=c99 -O1 check_cage.c -lm -o check_cage
 *     ./check_cage vectors/mean_value.cube.txt [BOUND]
 *
 * Replace `coordinates`, KIND and QUADS. Exit 0: all vectors within BOUND units (64); 1: not all; 2: the file cannot be read. */
#include "vector_checks.h"

#define KIND "mean_value" /* of your function */
#define QUADS 0           /* whether its cages have quads */

enum { most_vertices = 256, most_faces = 512, most_coordinates = 1024, most_blocks = 8, longest_line = 1 << 17 };

struct cage {
  int dimension, corners, vertices, faces;
  double vertex[3 * most_vertices]; /* [vertex][dimension] */
  int face[4 * most_faces]; /* [face][corners]: 3, in the plane 2, with quads 4, where a triangle's last one is -1 */
};

/* The product of three exact differences of corners and the point, in all orders with their signs: six times a volume,
 * or in the plane, twice an area. */
static double determinant(const struct difference d[3][3], int dimension) {
  struct sum s = {{0}, 0};
  for (int i = 0; i < dimension; ++i) {
    if (dimension == 2) {
      add_two(&s, d[0][i], d[1][1 - i], i == 0 ? 1 : -1);
    } else {
      add_three(&s, d[0][i], d[1][(i + 1) % 3], d[2][(i + 2) % 3], 1);
      add_three(&s, d[0][i], d[1][(i + 2) % 3], d[2][(i + 1) % 3], -1);
    }
  }
  return total(&s);
}

static double dot(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
static double length(const double* a) { return hypot(hypot(a[0], a[1]), a[2]); }

/* Each component is exact before it is rounded. */
static void cross(const struct difference* u, const struct difference* v, double* out) {
  for (int i = 0; i < 3; ++i) {
    struct sum s = {{0}, 0};
    add_two(&s, u[(i + 1) % 3], v[(i + 2) % 3], 1);
    add_two(&s, u[(i + 2) % 3], v[(i + 1) % 3], -1);
    out[i] = total(&s);
  }
}

static double inner(const struct difference* u, const struct difference* v, int dimension) {
  struct sum s = {{0}, 0};
  for (int i = 0; i < dimension; ++i) add_two(&s, u[i], v[i], 1);
  return total(&s);
}

/* A face's weights. Returns whether the point is on it. */
static int of_triangle(const struct difference d[3][3], double w[3]) {
  double n[3][3], across[3] = {0, 0, 0}, mean[3] = {0, 0, 0}, area[3], all = 0;
  const double det = determinant(d, 3);
  for (int k = 0; k < 3; ++k) {
    cross(d[(k + 1) % 3], d[(k + 2) % 3], n[k]);
    for (int i = 0; i < 3; ++i) across[i] += n[k][i];
    w[k] = 0;
  }
  if (det == 0) {
    for (int k = 0; k < 3; ++k) all += area[k] = dot(n[k], across);
    if (area[0] < 0 || area[1] < 0 || area[2] < 0) return 0;
    for (int k = 0; k < 3; ++k) w[k] = area[k] / all;
    return 1;
  }
  for (int k = 0; k < 3; ++k) {
    const double angle = atan2(length(n[k]), inner(d[(k + 1) % 3], d[(k + 2) % 3], 3));
    for (int i = 0; i < 3; ++i) mean[i] += angle * n[k][i] / length(n[k]);
  }
  for (int k = 0; k < 3; ++k) w[k] = dot(n[k], mean) / det;
  return 0;
}

static int of_segment(const struct difference d[3][3], double w[3]) {
  const double area = determinant(d, 2), along = inner(d[0], d[1], 2);
  const double a = hypot(d[0][0].high, d[0][1].high), b = hypot(d[1][0].high, d[1][1].high);
  w[0] = w[1] = 0;
  if (area == 0) {
    if (along > 0) return 0;
    w[0] = b / (a + b), w[1] = a / (a + b);
    return 1;
  }
  const double tangent = along < 0 ? (a * b - along) / area : area / (a * b + along);
  w[0] = tangent / a, w[1] = tangent / b;
  return 0;
}

/* Yours. Here: mean value coordinates, one per vertex. \param found all coordinates, block by block */
static void coordinates(const struct cage* cage, const double* point, double* found) {
  const int dimension = cage->dimension;
  double sum = 0;
  for (int v = 0; v < cage->vertices; ++v) found[v] = 0;
  for (int f = 0; f < cage->faces; ++f) {
    const int* const face = cage->face + cage->corners * f;
    struct difference d[3][3];
    double w[3];
    for (int k = 0; k < dimension; ++k)
      for (int i = 0; i < dimension; ++i) d[k][i] = minus(cage->vertex[dimension * face[k] + i], point[i]);
    const int is_on = dimension == 2 ? of_segment((const struct difference(*)[3])d, w)
                                     : of_triangle((const struct difference(*)[3])d, w);
    for (int v = 0; is_on && v < cage->vertices; ++v) found[v] = 0;
    for (int k = 0; k < dimension; ++k) found[face[k]] += w[k];
    if (is_on) break;
  }
  for (int v = 0; v < cage->vertices; ++v) sum += found[v];
  for (int v = 0; v < cage->vertices; ++v) found[v] /= sum;
}

static int fail(const char* file, const char* why) {
  fprintf(stderr, "check_cage: cannot read vectors: %s: %s; usage: check_cage KIND.CAGE.txt [BOUND]\n", file, why);
  return 2;
}

/* Reads the cage and the sizes of blocks. \return why it cannot; null where it can */
static const char* read_cage(FILE* file, char* line, struct cage* cage, int* vectors, int sizes[], int* blocks) {
  char name[128];
  int used = 0, size = 0, all = 0;
  double number = 0;
  if (!fgets(line, longest_line, file) ||
      sscanf(line, "%127s %d %d %d %d %d%n", name, vectors, &cage->dimension, &cage->corners, &cage->vertices, &cage->faces,
             &used) != 6)
    return "line 1 is not KIND.CAGE VECTORS DIMENSION CORNERS VERTICES FACES SIZES";
  if (strncmp(name, KIND ".", sizeof KIND) != 0) return "it is not of KIND, which the function is of";
  for (char* at = line + used; sscanf(at, "%d%n", &size, &used) == 1; at += used) {
    if (*blocks == most_blocks || size < 1 || size > most_coordinates) return "line 1 has too many coordinates";
    all += sizes[(*blocks)++] = size;
  }
  if (*vectors < 1 || *blocks < 1 || all > most_coordinates || cage->dimension < 2 || cage->dimension > 3 ||
      (cage->corners != cage->dimension && !(QUADS && cage->corners == 4)) || cage->vertices < 1 || cage->vertices > most_vertices || cage->faces < 1 || cage->faces > most_faces)
    return "line 1 has no vectors, too large a cage, or quads";
  const int numbers = cage->dimension * cage->vertices, corners = cage->corners * cage->faces;
  if (!fgets(line, longest_line, file) || strncmp(line, "vertices ", 9) != 0 ||
      !read_numbers(line + 9, numbers, cage->vertex))
    return "line 2 has not as many vertices as line 1 says";
  char* at = fgets(line, longest_line, file) && strncmp(line, "faces ", 6) == 0 ? line + 6 : NULL;
  for (int i = 0; i < corners; ++i) {
    at = at ? read_numbers(at, 1, &number) : NULL;
    if (!at || number < (i % 4 == 3 && cage->corners == 4 ? -1 : 0) || number >= cage->vertices) return "line 3 has not as many faces as line 1 says";
    cage->face[i] = (int)number;
  }
  return NULL;
}

/* The largest error of a block. */
static double error_of(const double* found, const double* truth, const double* denominators, const int* sizes,
                       int blocks) {
  double worst = 0;
  for (int b = 0, i = 0; b < blocks; ++b) {
    double square = 0;
    for (const int end = i + sizes[b]; i < end; ++i) {
      const double off = ((found[i] - truth[2 * i]) - truth[2 * i + 1]) / denominators[b] / 0x1p-53;
      square += off * off;
    }
    if (!isfinite(square)) return HUGE_VAL;
    worst = fmax(worst, sqrt(square));
  }
  return worst;
}

int main(int argc, char** argv) {
  static char line[longest_line];
  static struct tally tallies[most_flags];
  static struct cage cage;
  static double truth[2 * most_coordinates], found[most_coordinates];
  int vectors = 0, sizes[most_blocks], blocks = 0, passed = 0, worst_vector = -1, all = 0;
  double worst = -1;
  if (argc < 2) return fail("no file", "none was named");
  char* rest = NULL;
  const double bound = argc > 2 ? strtod(argv[2], &rest) : 64;
  if (rest && (rest == argv[2] || *rest)) return fail(argv[1], "BOUND is not a number");
  if (!(bound > 0 && bound < HUGE_VAL)) return fail(argv[1], "BOUND is not a positive number");
  FILE* file = fopen(argv[1], "r");
  if (!file) return fail(argv[1], strerror(errno));
  const char* const why = read_cage(file, line, &cage, &vectors, sizes, &blocks);
  if (why) return fail(argv[1], why);
  for (int b = 0; b < blocks; ++b) all += sizes[b];
  for (int v = 0; v < vectors; ++v) {
    double point[3], denominators[most_blocks];
    if (!fgets(line, sizeof line, file)) return fail(argv[1], "it ends before its last vector");
    char* const numbers = strchr(line, ' ');
    char* end = numbers ? read_numbers(numbers, cage.dimension, point) : NULL;
    if (end) end = read_numbers(end, 2 * all, truth);
    if (end) end = read_numbers(end, blocks, denominators);
    if (!end || strcmp(end, "\n") != 0) return fail(argv[1], "a line has not as many finite numbers as line 1 says");
    for (int b = 0; b < blocks; ++b)
      if (!(denominators[b] > 0)) return fail(argv[1], "a denominator is not positive");
    coordinates(&cage, point, found);
    const double error = error_of(found, truth, denominators, sizes, blocks);
    const int passes = error <= bound;
    *numbers = 0;
    for (char* flag = strtok(line, ","); flag; flag = strtok(NULL, ",")) count(tallies, flag, passes);
    passed += passes;
    if (error <= worst) continue;
    worst = error;
    worst_vector = v;
  }
  if (fgets(line, sizeof line, file)) return fail(argv[1], "it goes on after its last vector");
  fclose(file);
  for (int i = 0; i < most_flags && tallies[i].asked > 0; ++i)
    printf("%s: %d of %d within %g units\n", tallies[i].flag, tallies[i].passed, tallies[i].asked, bound);
  printf("all: %d of %d within %g units\n", passed, vectors, bound);
  printf("worst: %.3g units, vector %d\n", worst, worst_vector);
  return passed == vectors ? 0 : 1;
}
