/* SPDX-License-Identifier: MIT
 * The checkers of test vectors in C share exact sums of doubles, counts by defect, reading numbers. */
#ifndef CAGEPROOF_VECTOR_CHECKS_H
#define CAGEPROOF_VECTOR_CHECKS_H

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { most_flags = 64, most_terms = 256 };

/* An exact sum of doubles: terms that do not overlap, the smallest first (Shewchuk 1997, grow-expansion). */
struct sum {
  double terms[most_terms];
  int count;
};

static void add(struct sum* s, double x) {
  for (int i = 0; i < s->count; ++i) {
    const double y = s->terms[i], high = x + y, part = high - x;
    s->terms[i] = (x - (high - part)) + (y - part);
    x = high;
  }
  s->terms[s->count++] = x;
}

static void add_product(struct sum* s, double a, double b) {
  const double high = a * b;
  add(s, fma(a, b, -high));
  add(s, high);
}

static double total(const struct sum* s) {
  double x = 0;
  for (int i = 0; i < s->count; ++i) x += s->terms[i];
  return x;
}

/* An exact difference of two doubles: high + low. */
struct difference {
  double high, low;
};

static struct difference minus(double a, double b) {
  const double high = a - b, part = high - a;
  const struct difference d = {high, (a - (high - part)) + (-b - part)};
  return d;
}

static void add_two(struct sum* s, struct difference a, struct difference b, double sign) {
  add_product(s, sign * a.high, b.high);
  add_product(s, sign * a.high, b.low);
  add_product(s, sign * a.low, b.high);
  add_product(s, sign * a.low, b.low);
}

static void add_three(struct sum* s, struct difference a, struct difference b, struct difference c, double sign) {
  struct sum ab = {{0}, 0};
  add_two(&ab, a, b, sign);
  for (int i = 0; i < ab.count; ++i) {
    add_product(s, ab.terms[i], c.high);
    add_product(s, ab.terms[i], c.low);
  }
}

struct tally {
  char flag[64];
  int passed, asked;
};

static void count(struct tally* tallies, const char* flag, int passes) {
  int i = 0;
  while (i < most_flags - 1 && tallies[i].asked > 0 && strcmp(tallies[i].flag, flag) != 0) ++i;
  strncpy(tallies[i].flag, flag, sizeof tallies[i].flag - 1);
  tallies[i].passed += passes;
  ++tallies[i].asked;
}

/* Reads `count` finite numbers. \return the text behind them; null where one is missing */
static char* read_numbers(char* text, int count, double* to) {
  for (int i = 0; i < count && text; ++i) {
    char* end = text;
    to[i] = strtod(text, &end);
    text = end == text || !isfinite(to[i]) ? NULL : end;
  }
  return text;
}

#endif
