#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/build.sh PRESET [TARGET...]: installs missing packages, configures and builds. Writes only to standard error, in full only when something fails. Exit
# 0: built; 2: not.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
preset=$1
shift
build=$root/build/$preset

"$root/scripts/ensure_packages.sh"

# A file with Eigen in five scalars takes up to 2 GB to compile.
jobs_that_fit() {
  local cores megabytes
  cores=$(nproc 2>/dev/null || echo 1)
  megabytes=$(awk '/^MemAvailable:/ {print int($2 / 1024)}' /proc/meminfo 2>/dev/null || true)
  # A container may have less than the machine.
  local limit
  limit=$(cat /sys/fs/cgroup/memory.max 2>/dev/null || true)
  if [[ $limit =~ ^[0-9]+$ ]] && ((limit / 1048576 < ${megabytes:-0})); then megabytes=$((limit / 1048576)); fi
  local fit=$((${megabytes:-2048} / 2048))
  ((fit < cores)) || fit=$cores
  ((fit > 1)) || fit=1
  echo "$fit"
}

log=$(mktemp)
trap 'rm -f "$log"' EXIT
fail() {
  cat "$log" >&2
  printf '%s\n' "$1" >&2
  exit 2
}

# Clang takes two thirds of GCC's time, also with the address sanitizer, where its runtime is there. The thread sanitizer is GCC's, so that CI compiles the
# program with both. A folder keeps the compiler that it was first configured with; CC and CXX name others.
clang_serves() {
  case $preset in
    tsan) false ;;
    asan) [[ -e $(clang++-16 -print-file-name=libclang_rt.asan-x86_64.a 2>/dev/null) || -e $(clang++-16 -print-file-name=libclang_rt.asan.a 2>/dev/null) ]] ;;
  esac
}
if [[ -z ${CC-} && -z ${CXX-} ]] && command -v clang-16 >/dev/null && command -v clang++-16 >/dev/null && clang_serves; then
  export CC=clang-16 CXX=clang++-16
fi

# A new package may bring what an earlier, failed configuration did not find: always ask CMake, it is quick.
cmake -S "$root" --preset "$preset" >"$log" 2>&1 </dev/null || fail "Configuring preset $preset failed."

jobs=$(jobs_that_fit)
build_command=(cmake --build "$build" --parallel "$jobs")
if (($#)); then build_command+=(--target "$@"); fi
if [[ -t 2 ]]; then
  : >"$log"
  "${build_command[@]}" >&2 </dev/null || fail "Building preset $preset failed."
else
  # Where nobody watches, progress is noise.
  start=$SECONDS
  printf 'Building preset %s with %s job(s) ...\n' "$preset" "$jobs" >&2
  "${build_command[@]}" >"$log" 2>&1 </dev/null || fail "Building preset $preset failed."
  printf 'Built in %s s.\n' $((SECONDS - start)) >&2
fi
