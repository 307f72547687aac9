/* SPDX-License-Identifier: MIT */
/* A library that computes sevens, until the x of a point is 0.5: then it does what the environment says. */
#include "cageproof_judge.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int cageproof_judge_version(void) { return CAGEPROOF_JUDGE_VERSION; }
const char* cageproof_judge_about(void) { return "hostile 1.0"; }
int cageproof_judge_order(const char* formula) { return strcmp(formula, "triangle.single_layer") == 0 ? 0 : -1; }

static void* volatile taken;

static void leave_children(void) {
  for (int i = 0; i < 8; ++i)
    if (fork() == 0) {
      setsid();
      if (fork() == 0) sleep(1000);
      sleep(1000);
    }
}

static int do_it(const char* what, const double* points, double* values, size_t count) {
  if (strcmp(what, "crash") == 0) raise(SIGSEGV);
  if (strcmp(what, "exit") == 0) exit(3);
  if (strcmp(what, "decline") == 0) return CAGEPROOF_JUDGE_DECLINED;
  if (strcmp(what, "code") == 0) return 17;
  if (strcmp(what, "hang") == 0)
    for (;;) pause();
  if (strcmp(what, "memory") == 0)
    for (;;) taken = memset(malloc(1 << 24), 1, 1 << 24);
  if (strcmp(what, "kill group") == 0) kill(-getpgid(getppid()), SIGKILL);
  if (strcmp(what, "kill own group") == 0) kill(0, SIGKILL);
  if (strcmp(what, "stop parent") == 0) kill(getppid(), SIGSTOP);
  if (strcmp(what, "fork without end") == 0)
    for (;;) fork();
  if (strcmp(what, "fork") == 0) leave_children();
  if (strcmp(what, "fork and crash") == 0) {
    leave_children();
    abort();
  }
  if (strcmp(what, "print") == 0) puts("hello");
  if (strcmp(what, "print without end") == 0)
    for (;;) puts("0123456789012345678901234567890123456789012345678901234567890123456789");
  if (strcmp(what, "answer pipe") == 0) fprintf(stderr, "%d", (int)write(6, "garbage!", 8));
  if (strcmp(what, "close all") == 0)
    for (int fd = 0; fd < 64; ++fd) close(fd);
  if (strcmp(what, "read beyond") == 0) values[0] = points[3 * count];
  if (strcmp(what, "write beyond") == 0) values[count] = 7;
  if (strcmp(what, "short") == 0) return CAGEPROOF_JUDGE_DONE;
  if (strcmp(what, "change input") == 0) ((double*)points)[0] = 2;
  for (size_t i = 0; i < count; ++i) values[i] = 7;
  return CAGEPROOF_JUDGE_DONE;
}

int cageproof_judge_double(const cageproof_judge_block* block, const double* corners, const double* parameters,
                           const double* points, double* values, double* gradients, double* hessians) {
  const char* const what = getenv("HOSTILE");
  (void)corners, (void)parameters, (void)gradients, (void)hessians;
  return do_it(what != NULL && points[0] == 0.5 ? what : "", points, values, block->count);
}
