/* SPDX-License-Identifier: MIT
 * Checks one function against vectors of `cageproof vectors`: the values of FORMULA.txt. Plain C99; needs no library but C's, and vector_checks.h
 * beside it.
 *
 *     cc -std=c99 -O1 check.c -lm -o check
 *     ./check vectors/triangle.solid_angle.txt [BOUND]
 *
 * Replace `function`, and FORMULA. Exit 0: all vectors within BOUND conditioned units (64); 1: not all; 2: the file cannot be read. */
#include "vector_checks.h"

#define FORMULA "triangle.solid_angle" /* of your function */

enum { most_numbers = 64, longest_line = 8192 };

static void cross(struct difference u[3], struct difference v[3], double* out) {
  for (int i = 0; i < 3; ++i) {
    struct sum s = {{0}, 0};
    add_two(&s, u[(i + 1) % 3], v[(i + 2) % 3], 1);
    add_two(&s, u[(i + 2) % 3], v[(i + 1) % 3], -1);
    out[i] = total(&s);
  }
}

static double dot(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static double length(const double* a) { return hypot(hypot(a[0], a[1]), a[2]); }

/* The share of its plane that a triangle fills around the origin: the limit from inside on it, zero beside it. */
static double angle_in_plane(struct difference e[3][3]) {
  struct difference side[2][3];
  double normal[3], angles = 0;
  int counted = 0;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 2; ++k) {
      /* Rounding does not matter here: only the normal's direction does. */
      const struct difference d = {(e[k + 1][i].high - e[0][i].high) + (e[k + 1][i].low - e[0][i].low), 0};
      side[k][i] = d;
    }
  cross(side[0], side[1], normal);
  for (int k = 0; k < 3; ++k) {
    struct difference *u = e[k], *v = e[(k + 1) % 3];
    double turn[3];
    cross(u, v, turn);
    /* An edge that the point lies on has the plane on one of its sides only. */
    if (turn[0] == 0 && turn[1] == 0 && turn[2] == 0) continue;
    struct sum along = {{0}, 0};
    for (int i = 0; i < 3; ++i) add_two(&along, u[i], v[i], 1);
    angles += copysign(atan2(length(turn), total(&along)), dot(turn, normal));
    ++counted;
  }
  return counted == 1 || angles > 1 ? angles : 0;
}

/* Yours. Here: the value of triangle.solid_angle. \param inputs the corners, the point, the parameters, in this order
 * \param value all its numbers, in the catalogue's order */
static void function(const double* inputs, double* value) {
  struct difference e[3][3];
  double corner[3][3], size = 0, scaled[9 + 3];
  for (int k = 0; k < 9; ++k) size = fmax(size, fabs(inputs[k] - inputs[9 + k % 3]));
  /* A power of two takes the unit of length away without rounding. */
  const int exponent = -ilogb(size);
  for (int k = 0; k < 12; ++k) scaled[k] = ldexp(inputs[k], exponent);
  for (int k = 0; k < 9; ++k) {
    e[k / 3][k % 3] = minus(scaled[k], scaled[9 + k % 3]);
    corner[k / 3][k % 3] = e[k / 3][k % 3].high;
  }
  /* The determinant of exact differences: in doubles it cancels far away and on slivers. */
  struct sum volume = {{0}, 0};
  for (int i = 0; i < 3; ++i) {
    add_three(&volume, e[1][(i + 1) % 3], e[2][(i + 2) % 3], e[0][i], 1);
    add_three(&volume, e[1][(i + 2) % 3], e[2][(i + 1) % 3], e[0][i], -1);
  }
  const double determinant = total(&volume);
  if (determinant == 0) {
    value[0] = angle_in_plane(e);
    return;
  }
  const double a = length(corner[0]), b = length(corner[1]), c = length(corner[2]);
  value[0] = 2 * atan2(determinant, a * b * c + dot(corner[0], corner[1]) * c + dot(corner[1], corner[2]) * a +
                                        dot(corner[2], corner[0]) * b);
}

static int fail(const char* file, const char* why) {
  fprintf(stderr, "check: cannot read vectors: %s: %s; usage: check FORMULA.txt [BOUND]\n", file, why);
  return 2;
}

int main(int argc, char** argv) {
  static char line[longest_line], worst_line[longest_line];
  static struct tally tallies[most_flags];
  char name[128];
  int vectors = 0, inputs = 0, components = 0, passed = 0, worst_vector = -1;
  double worst = -1;
  if (argc < 2) return fail("no file", "none was named");
  char* rest = NULL;
  const double bound = argc > 2 ? strtod(argv[2], &rest) : 64;
  if (rest && (rest == argv[2] || *rest)) return fail(argv[1], "BOUND is not a number");
  if (!(bound > 0 && bound < HUGE_VAL)) return fail(argv[1], "BOUND is not a positive number");
  FILE* file = fopen(argv[1], "r");
  if (!file) return fail(argv[1], strerror(errno));
  if (!fgets(line, sizeof line, file) || sscanf(line, "%127s %d %d %d", name, &vectors, &inputs, &components) != 4)
    return fail(argv[1], "line 1 is not FORMULA VECTORS INPUTS NUMBERS");
  if (vectors < 1 || inputs < 1 || components < 1 || inputs > most_numbers || components > most_numbers)
    return fail(argv[1], "line 1 has no vectors, or too many numbers");
  if (strcmp(name, FORMULA) != 0) return fail(argv[1], "it is not of FORMULA, which the function is of");
  for (int v = 0; v < vectors; ++v) {
    double in[most_numbers], truth[2 * most_numbers], found[most_numbers], denominator, square = 0;
    if (!fgets(line, sizeof line, file)) return fail(argv[1], "it ends before its last vector");
    char* numbers = strchr(line, ' ');
    char* end = numbers ? read_numbers(numbers, inputs, in) : NULL;
    char* const inputs_end = end;
    if (end) end = read_numbers(end, 2 * components, truth);
    if (end) end = read_numbers(end, 1, &denominator);
    if (!end || strcmp(end, "\n") != 0) return fail(argv[1], "a line has not as many finite numbers as line 1 says");
    function(in, found);
    for (int i = 0; i < components; ++i) {
      const double off = ((found[i] - truth[2 * i]) - truth[2 * i + 1]) / denominator / 0x1p-53;
      square += found[i] == truth[2 * i] && truth[2 * i + 1] == 0 ? 0 : off * off;
    }
    const double error = isfinite(square) ? sqrt(square) : HUGE_VAL;
    const int passes = error <= bound;
    *numbers = 0;
    for (char* flag = strtok(line, ","); flag; flag = strtok(NULL, ",")) count(tallies, flag, passes);
    passed += passes;
    if (error > worst) {
      worst = error;
      worst_vector = v;
      *inputs_end = 0;
      strcpy(worst_line, numbers + 1);
    }
  }
  if (fgets(line, sizeof line, file)) return fail(argv[1], "it goes on after its last vector");
  fclose(file);
  for (int i = 0; i < most_flags && tallies[i].asked > 0; ++i)
    printf("%s: %d of %d within %g units\n", tallies[i].flag, tallies[i].passed, tallies[i].asked, bound);
  printf("all: %d of %d within %g units\n", passed, vectors, bound);
  printf("worst: %.3g units, vector %d: %s\n", worst, worst_vector, worst_line);
  return passed == vectors ? 0 : 1;
}
