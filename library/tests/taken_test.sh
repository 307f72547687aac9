#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The sources in another project, by FetchContent and by add_subdirectory: it configures without what only the program needs, and gets no
# tests, install rules or flags. It is not built here, which takes as long as the project itself: --build does. Usage: taken_test.sh C_COMPILER CXX_COMPILER [--build]
set -u
c=$1 cxx=$2 build=${3-}
here=$(dirname "$(readlink -f "$0")") && root=$(readlink -f "$here/../..")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}
without=()
for package in VTK GTest CLI11 nlohmann_json LibXml2 LibArchive benchmark; do without+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON"); done
for by_fetch in ON OFF; do
  out=$work/$by_fetch
  cmake -G Ninja -S "$here/taken" -B "$out" -DCMAKE_BUILD_TYPE=Release -DCAGEPROOF_SOURCE="$root" -DBY_FETCH=$by_fetch -DCMAKE_C_COMPILER="$c" -DCMAKE_CXX_COMPILER="$cxx" \
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON "${without[@]}" >"$work/log" 2>&1 || { fail "configuring by fetch $by_fetch"; tail -n 30 "$work/log"; continue; }
  [ "$(cd "$out" && ctest -N | grep -c 'Test *#')" -eq 1 ] || fail "tests beside the project's own"
  grep -rl --include=cmake_install.cmake 'libcageproof\|cageproof\.h' "$out" | grep . && fail "rules to install the library"
  /usr/bin/python3 - "$out/compile_commands.json" <<'PY' || fail "flags of the project's own sources"
import json, sys
own = [c["command"] for c in json.load(open(sys.argv[1])) if c["file"].endswith("cpp_interface.cpp")]
library = [c["command"] for c in json.load(open(sys.argv[1])) if "/library/" in c["file"] and not c["file"].endswith("cpp_interface.cpp")]
assert len(own) == 1 and library, (own, len(library))
assert not any(word in own[0] for word in ("-Werror", "-Wall", "-ffp-contract", "-fno-", "eigen")), own
assert not any("-Werror" in c for c in library)
assert all("-ffp-contract=off" in c for c in library)
PY
  (cd "$out" && ninja -n taken archives >"$work/plan") || fail "targets that cannot be built"
  for object in "archives.dir$root/docs/examples/library.cpp.o" "taken.dir$root/library/tests/shared/cpp_interface.cpp.o"; do
    ninja -C "$out" "CMakeFiles/$object" >"$work/log" 2>&1 || { fail "$object does not compile"; tail -n 20 "$work/log"; }
  done
  grep -qE '_tests|gtest|vtk|quadrature_ref|reports' "$work/plan" && fail "builds more than the library"
done
if [ "$build" = --build ]; then
  cmake --build "$work/OFF" -j2 --target taken archives && "$work/OFF/taken" && "$work/OFF/archives" || fail "the built project"
fi
[ $failures -eq 0 ] && echo "another project gets the library and nothing else"
exit $failures
