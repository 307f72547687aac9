/* SPDX-License-Identifier: MIT */
/* A program that answers each line by the same number and does not read it: its time is the protocol's. */
#include <stdio.h>

int main(void) {
  static char line[1 << 16];
  if (fgets(line, sizeof line, stdin) == NULL) return 0;
  puts("{\"formulas\":{\"triangle.single_layer\":0},\"float\":false}");
  fflush(stdout);
  while (fgets(line, sizeof line, stdin) != NULL) {
    puts("{\"value\":[0.06694790183441744]}");
    fflush(stdout);
  }
  return 0;
}
