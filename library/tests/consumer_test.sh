#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The library as a user meets it: installed in a folder of its own, which is then moved, found by CMake and by pkg-config, included and run.
# Usage: consumer_test.sh BUILD_FOLDER COMPILER [FLAGS]
set -u
build=$1 compiler=$2 flags=${3-}
here=$(dirname "$(readlink -f "$0")") && root=$(readlink -f "$here/../..")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}
run() { "$@" >"$work/log" 2>&1 || { fail "$*"; tail -n 30 "$work/log"; }; }

run cmake --install "$build" --prefix "$work/first"
[ -x "$work/first/bin/cageproof" ] || fail "no program"
# The folder may lie anywhere, and says nothing of where it was made.
mv "$work/first" "$work/prefix"
grep -rlI -e "$root" -e "$build" -e "$work/first" "$work/prefix" && fail "a path of the machine that it was built on"

# The header: nothing but the standard library, and quick.
cat >"$work/include.cpp" <<'CPP'
#include <cageproof/cageproof.h>
int main() {}
CPP
"$compiler" -std=c++20 -I "$work/prefix/include" -M "$work/include.cpp" >"$work/dependencies" || fail "the header by itself"
grep -iE 'eigen|boost|mpfr|gmp|flint|cgal|fmt|vtk' "$work/dependencies" && fail "the header brings other libraries"
[ "$(grep -o 'include/cageproof/[a-z_/]*\.h' "$work/dependencies" | sort -u | wc -l)" -le 2 ] || fail "the header brings others of the project"
run "$compiler" -std=c++20 $flags -O2 -I "$work/prefix/include" -c "$here/consumer/consumer.cpp" -o "$work/consumer.o"
# The time is the processor's, because other programs may be at work on the machine.
TIMEFORMAT='%U %S'
seconds=$({ time "$compiler" -std=c++20 -O2 -I "$work/prefix/include" -c "$root/docs/examples/library.cpp" -o "$work/example.o" >&2; } 2>&1 | tail -n 1)
echo "a program that includes it compiles in ${seconds% *} s"
awk '{exit !($1 + $2 < 5)}' <<<"$seconds" || fail "compiling takes $seconds s"

run cmake -S "$here/consumer" -B "$work/consumer" -DCMAKE_PREFIX_PATH="$work/prefix" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="$flags" \
  -DCMAKE_BUILD_TYPE=Release -DEXAMPLE="$root/docs/examples/library.cpp"
run cmake --build "$work/consumer"
run "$work/consumer/consumer"
run "$work/consumer/closed_form"
run "$work/consumer/c_interface"

# The same by pkg-config.
export PKG_CONFIG_PATH=$work/prefix/lib/pkgconfig:$work/prefix/lib64/pkgconfig
pc_flags=$(pkg-config --cflags --libs cageproof) || fail "pkg-config: $(pkg-config --print-errors cageproof 2>&1)"
# shellcheck disable=SC2086
run "$compiler" -std=c++20 $flags "$work/consumer.o" $pc_flags -o "$work/by_pkg_config"
run "$work/by_pkg_config"
# shellcheck disable=SC2046
run "$compiler" -x c++ -std=c++20 $flags "$here/shared/cpp_interface.cpp" -x none $(pkg-config --cflags --libs cageproof-c) -o "$work/shared_by_pkg_config"
LD_LIBRARY_PATH=$(pkg-config --variable=libdir cageproof-c) run "$work/shared_by_pkg_config"

# The program in docs/library.md is the one that was run, with its output.
page=$root/docs/library.md
awk '/^```$/ && inside {exit} inside {print} /^```cpp$/ {inside = 1}' "$page" | cmp - "$root/docs/examples/library.cpp" || fail "docs/library.md shows another program than docs/examples/library.cpp"
"$work/consumer/example" >"$work/shown" || fail "the example"
sed -n '/^    phi sum to/,/^    the first point/s/^    //p' "$page" | cmp - "$work/shown" || fail "docs/library.md shows another output"

[ $failures -eq 0 ] && echo "the installed library does what it says"
exit $failures
