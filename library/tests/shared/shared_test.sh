#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The shared library as others meet it: one header in C99 or C++, one library to link, no other names in it.
# Usage: shared_test.sh LIBRARY C_COMPILER CXX_COMPILER; CAGEPROOF_CALLS: how many more hostile calls, beside 1,500
set -u
library=$1 c=$2 cxx=$3
here=$(dirname "$(readlink -f "$0")") && include=$(readlink -f "$here/../../include")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# Names: those that the header declares, and no others.
nm --dynamic --defined-only "$library" | awk '$2 != "A" {sub(/@.*/, "", $3); print $3}' | sort >"$work/exported"
grep -oE '\bcageproof_[a-z_]+\(' "$include/cageproof.h" | tr -d '(' | sort -u >"$work/declared"
diff "$work/declared" "$work/exported" || fail "the library exports other names than the header declares"
readelf -d "$library" | grep -q 'SONAME.*libcageproof\.so\.[0-9]' || fail "no SONAME"
# Libraries that a machine without development packages must have.
readelf -d "$library" | grep -oE 'NEEDED.*\[.*\]' | grep -vE 'lib(fmt|nlopt|mpfr|gmp|tbb|m|stdc\+\+|gcc_s|c|asan|ubsan|tsan)\.so|ld-linux' && fail "links more than docs/library.md says"

"$c" -std=c99 -Wall -Wextra -pedantic -Werror -I "$include" "$here/c_interface.c" "$library" -lm -Wl,-rpath,"$(dirname "$library")" -o "$work/c" &&
  "$work/c" || fail "the C interface from C99"
"$c" -std=c99 -O1 -Wall -Wextra -pedantic -Werror -I "$include" "$here/hostile.c" "$library" -lm -Wl,-rpath,"$(dirname "$library")" -o "$work/hostile" &&
  CAGEPROOF_CHECK_HANDLES=1 "$work/hostile" 1500 || fail "hostile calls"
# Handles that are checked keep memory after they were freed, which many calls would run out of.
[[ -z ${CAGEPROOF_CALLS-} ]] || "$work/hostile" "$CAGEPROOF_CALLS" 41 || fail "more hostile calls"
"$cxx" -std=c++20 -Wall -Wextra -pedantic -Werror -I "$include" "$here/cpp_interface.cpp" "$library" -Wl,-rpath,"$(dirname "$library")" -o "$work/cpp" &&
  "$work/cpp" || fail "the C++ header"
# Both faces of the library in one source.
echo '#include <cageproof.hpp>
#include <cageproof/cageproof.h>
int main() {}' | "$cxx" -std=c++20 -Wall -Wextra -Werror -I "$include" -I "$include/../../core/include" -x c++ -fsyntax-only - || fail "both headers in one source"
strip -o "$work/stripped" "$library" && echo "stripped: $(stat -c %s "$work/stripped") bytes"
[ $failures -eq 0 ] && echo "the shared library does what it says"
exit $failures
