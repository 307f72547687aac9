// SPDX-License-Identifier: MIT
// A program that is nothing but a host.
#include "cageproof/judge/host.h"

int main(int argc, char** argv) {
  return cageproof::judge::is_host(argc, argv) ? cageproof::judge::run_host(argc, argv) : 2;
}
