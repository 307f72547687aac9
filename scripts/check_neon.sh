#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/check_neon.sh: whether the sources on vectors of points compile for AArch64, under the options that CMake gives them there; and, under
# qemu, whether the functions that they take of vectors are as exact as they should be. Exit 0: so it is; 1: not; 2: it cannot run.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cxx=aarch64-linux-gnu-g++
command -v "$cxx" >/dev/null || {
  echo "$cxx is missing: scripts/ensure_packages.sh arm" >&2
  exit 2
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The libraries are this machine's: only their headers are read, and nothing is linked with them.
cmake -S "$root" -B "$work" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 \
  -DCMAKE_C_COMPILER="${cxx%g++}gcc" -DCMAKE_CXX_COMPILER="$cxx" -DCMAKE_TRY_COMPILE_TARGET_TYPE=STATIC_LIBRARY \
  -DCMAKE_LIBRARY_ARCHITECTURE="$(g++ -print-multiarch)" -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >"$work/log" 2>&1 || {
  cat "$work/log" >&2
  exit 2
}
cd "$work"
if grep -o -m 1 -- '-m\(avx[^ ]*\|fma\) .*' compile_commands.json; then
  echo "options of other processors" >&2
  exit 1
fi
mapfile -t objects < <(ninja -t targets all |
  grep -oE '^[^:]*/((fast|careful|sums|pairs)_(plain|avx2|avx512)|batch/dispatch|gauss_kernels|yardstick_avx2)\.cpp\.o')
((${#objects[@]} >= 16)) || {
  echo "the sources on vectors are not where they were: ${objects[*]}" >&2
  exit 2
}
ninja "${objects[@]}" >log || {
  cat log >&2
  exit 1
}
echo "AArch64: ${#objects[@]} sources compile"

# Compiles the arithmetic test as the sums in double are compiled, or as those in double-doubles.
build_as() {
  local object command
  for object in "${objects[@]}"; do [[ $object != */$1_plain.cpp.o ]] || break; done
  command=$(ninja -t commands "$object" | tail -n 1)
  eval "${command%% -MD *} ${*:2} -static '$root/scripts/neon/arithmetic.cpp' -o $1"
}
build_as fast
build_as careful -DCAGEPROOF_PAIRS
qemu=$(command -v qemu-aarch64-static || command -v qemu-aarch64) || {
  echo "not run: qemu-aarch64 is missing (scripts/ensure_packages.sh arm)"
  exit 0
}
for kind in fast careful; do
  echo "$kind:"
  "$qemu" "./$kind" || exit 1
done
