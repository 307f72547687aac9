#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Gates fail where they cannot look: a formatter that fails, a program that does not run, a file that clang-tidy did not reach.
set -u
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

# expect CODE WORD COMMAND...
expect() {
  local code=$1 word=$2
  shift 2
  "$@" >"$work/said" 2>&1 </dev/null
  local got=$?
  if [ $got -ne "$code" ] || { [ -n "$word" ] && ! grep -qF -- "$word" "$work/said"; }; then
    echo "FAILED: exit $got, not $code, or no '$word': $* : $(head -n 5 "$work/said")"
    failures=$((failures + 1))
  fi
}

# Where ParaView's Python package has removed libvtk9-dev, ensure_packages.sh names the conflict and installs nothing. Stand-ins for dpkg-query and apt-get
# say what is installed and record that nothing was asked for.
mkdir -p "$work/bin"
printf '#!/bin/sh\nshift 2\nfor name; do case " $MISSING " in *" $name "*) ;; *) echo "$name installed" ;; esac; done\n' >"$work/bin/dpkg-query"
printf '#!/bin/sh\necho "apt-get $*" >>"%s/installed"\n' "$work" >"$work/bin/apt-get"
printf '#!/bin/sh\nwhile [ "${1#-}" != "$1" ]; do shift; done\nexec "$@"\n' >"$work/bin/sudo"
chmod +x "$work"/bin/*
ensure() { MISSING=$1 PATH="$work/bin:$PATH" "$root/scripts/ensure_packages.sh"; }
expect 2 'python3-paraview is installed' ensure 'libvtk9-dev python3-vtk9'
expect 2 'apt-get install -y --no-install-recommends libvtk9-dev python3-vtk9 python3-paraview-' ensure 'libvtk9-dev python3-vtk9'
if [ -e "$work/installed" ]; then
  echo "FAILED: packages were installed over python3-paraview: $(cat "$work/installed")"
  failures=$((failures + 1))
fi
expect 0 'Installed.' ensure 'libvtk9-dev python3-vtk9 python3-paraview'

# A project of one header and one source, with the gates' scripts.
mkdir -p "$work/project/scripts" "$work/project/core/src"
cd "$work/project" || exit 2
cp "$root/scripts/check_format.sh" "$root/scripts/check_tidy.sh" "$root/scripts/tidy_units.py" scripts
cp "$root/.clang-format" .clang-format
printf 'int one();\n' >core/src/one.h
printf '#include "one.h"\n\nint one() { return 1; }\n' >core/src/one.cpp
printf 'cmake_minimum_required(VERSION 3.25)\nproject(one CXX)\nset(CMAKE_EXPORT_COMPILE_COMMANDS ON)\nadd_library(one core/src/one.cpp)\n' >CMakeLists.txt
printf 'Checks: "-*,modernize-use-nullptr"\nWarningsAsErrors: "*"\nHeaderFilterRegex: "core/"\n' >.clang-tidy
git init -q .
commit() { git add -A && git -c user.name=test -c user.email=test@example.org commit -qm "$1"; }
commit first

expect 0 '' scripts/check_format.sh
printf 'int  two ( );\n' >core/src/two.h
commit unformatted
expect 1 core/src/two.h scripts/check_format.sh
git rm -q core/src/two.h && commit formatted
echo 'NoSuchKey: 1' >>.clang-format
expect 2 'clang-format failed' scripts/check_format.sh
git checkout -q .clang-format

# A commit of only a header is checked through a source that includes it.
if command -v clang-tidy-16 >/dev/null; then
  printf 'int one();\ninline char* none() { return 0; }\n' >core/src/one.h
  commit header
  expect 1 '0 of 1 sources are clean, 1 are not' scripts/check_tidy.sh HEAD~1
  expect 1 '1 were not reached' scripts/check_tidy.sh --minutes 0.00001 HEAD~1
  printf 'int one();\ninline char* none() { return nullptr; }\n' >core/src/one.h
  commit mended
  expect 0 '1 of 1 sources are clean' scripts/check_tidy.sh HEAD~1
  printf 'inline char* lost() { return 0; }\n' >core/src/lost.h
  commit homeless
  expect 1 'no source includes it, and nothing checked it: core/src/lost.h' scripts/check_tidy.sh HEAD~1
  git rm -q core/src/lost.h && commit found
  # A comment is no code, unless it speaks to clang-tidy.
  printf '// None.\nint one();\ninline char* none() { return nullptr; }\n' >core/src/one.h
  commit commented
  expect 0 'no C++ file was changed' scripts/check_tidy.sh HEAD~1
  printf 'int one();\ninline char* none() { return 0; }  // NOLINT\n' >core/src/one.h
  commit silenced
  expect 0 '1 of 1 sources are clean' scripts/check_tidy.sh HEAD~1
  printf 'int one();\ninline char* none() { return nullptr; }\n' >core/src/one.h
  commit spoken
  # Nor is the name of a namespace.
  printf 'namespace one {\nint one();\n}  // namespace one\n' >core/src/named.h
  printf '#include "named.h"\n' >core/src/named.cpp
  commit named
  sed -i 's/namespace one/namespace another::one/' core/src/named.h
  commit renamed
  expect 0 'no C++ file was changed' scripts/check_tidy.sh HEAD~1
  git rm -q core/src/named.h core/src/named.cpp
  commit unnamed
  # A move is the same code; a move and a changed line are not.
  git mv core/src/one.h core/src/first.h
  sed -i 's/one.h/first.h/' core/src/one.cpp
  commit moved
  expect 0 'no C++ file was changed' scripts/check_tidy.sh HEAD~1
  printf 'int one();\ninline char* none() { return 0; }\n' >core/src/first.h
  commit broken
  expect 1 '0 of 1 sources are clean, 1 are not' scripts/check_tidy.sh HEAD~2
  # check_tidy.sh also looks at changes that only a merge makes.
  base=$(git rev-parse HEAD)
  git checkout -q -b side HEAD~1 && printf '// Side.\n' >core/src/side.h && commit side
  git checkout -q - && git -c user.name=test -c user.email=test@example.org merge -q --no-commit side >/dev/null 2>&1
  printf 'int one();\ninline char* none() { return 0; }\ninline char* more() { return 0; }\n' >core/src/first.h
  commit merged
  expect 1 '0 of 1 sources are clean, 1 are not' scripts/check_tidy.sh "$base"
  git rm -q core/src/side.h && commit sideless
  # Sources that are read at once: a finding names its own.
  printf '#include "first.h"\n\nint one() { return 2; }\n' >core/src/one.cpp
  printf 'int one();\n' >core/src/first.h
  printf 'int two();\nint two() {\n  const char* none = 0;\n  return none == nullptr;\n}\n' >core/src/two.cpp
  sed -i 's,core/src/one.cpp,core/src/one.cpp core/src/two.cpp,' CMakeLists.txt
  commit two
  expect 1 'core/src/two.cpp:3' scripts/check_tidy.sh HEAD~1
  sed -i 's/ = 0/ = nullptr/' core/src/two.cpp
  commit 'two mended'
  expect 0 '2 of 2 sources are clean' scripts/check_tidy.sh HEAD~2
fi

# A build without ninja's records tells nothing of included files.
if command -v ninja >/dev/null; then
  mkdir "$work/build"
  printf 'rule c\n  command = touch $out\nbuild closed_form/closed_form.o: c\nbuild cageproof: c closed_form/closed_form.o\n' >"$work/build/build.ninja"
  expect 2 'no valid record' "$root/scripts/check_rooms" "$work/build"
  # A project whose objects are made of records only.
  cp "$root/scripts/check_rooms" scripts
  mkdir -p closed_form/src quadrature_ref/src quadrature_ref/include validation/second_routes core/include core/readers
  record() {
    printf 'rule c\n  command = echo "$out: $includes" >$out.d; touch $out\n  depfile = $out.d\n  deps = gcc\n'
    printf 'build closed_form/closed_form.o: c\n  includes = %s\n' "$1"
    printf 'build quadrature_ref/quadrature_ref.o: c\nbuild validation/second_routes.o: c\n'
    printf 'build cageproof: c closed_form/closed_form.o quadrature_ref/quadrature_ref.o validation/second_routes.o\n'
  }
  rooms() {
    record "$1" >"$work/build/build.ninja"
    ninja -C "$work/build" cageproof >/dev/null && scripts/check_rooms "$work/build"
  }
  boost=/usr/include/boost/math/quadrature/gauss.hpp
  expect 0 'has no rule' rooms ''
  expect 1 "closed_form.o includes $boost" rooms "$boost"
  printf '#include <boost/math/quadrature/gauss.hpp>\n' >closed_form/src/unused.h
  expect 1 "closed_form/src/unused.h includes $boost" rooms ''
  rm closed_form/src/unused.h
  printf 'auto on = type_of(kind).contact(corners, point);\n' >quadrature_ref/src/on.cpp
  expect 1 'quadrature_ref/src/on.cpp:1' rooms ''
  printf 'bool none = row.degenerate(corners);\n' >quadrature_ref/src/on.cpp
  expect 1 'quadrature_ref/src/on.cpp:1' rooms ''
  rm quadrature_ref/src/on.cpp
fi

expect 2 'names no formula' "$root/scripts/hunt_all" 10 "$work/hunt" /bin/false
expect 2 'names no formula' "$root/scripts/hunt_all" 10 "$work/hunt" /bin/true
# A hunt must say what it found, and say the same as its exit code.
hunter() {
  printf '#!/bin/sh\n[ "$1" = list ] && { echo segment.a; echo triangle.a; echo quad.a; exit 0; }\necho "%s"\nexit %s\n' "$1" "$2" >"$work/hunter"
  chmod +x "$work/hunter"
  rm -rf "$work/hunt"
}
hunter '' 0 && expect 2 'names no broken promise' "$root/scripts/hunt_all" 10 "$work/hunt" "$work/hunter"
hunter 'a promise is broken' 1 && expect 2 'exit code 1 and names no broken promise' "$root/scripts/hunt_all" 10 "$work/hunt" "$work/hunter"
hunter 'a, promised 64: BROKEN' 0 && expect 2 'exit code 0 and names a broken promise' "$root/scripts/hunt_all" 10 "$work/hunt" "$work/hunter"
hunter 'a, promised 64: BROKEN' 1 && expect 1 'BROKEN' "$root/scripts/hunt_all" 10 "$work/hunt" "$work/hunter"
hunter 'a, promised 64: kept' 0 && expect 0 'kept' "$root/scripts/hunt_all" 10 "$work/hunt" "$work/hunter"

# Parts of a nightly run end in a table; what took the place of something else and what was skipped is said there.
mkdir "$work/skips"
printf 'add_test(lacking sh -c "exit 77")\nset_tests_properties(lacking PROPERTIES SKIP_RETURN_CODE 77)\n' >"$work/skips/CTestTestfile.cmake"
cat >"$work/parts" <<END
set -uo pipefail
source "$root/.ci/parts.sh"
part good echo 'Instead: another cage'
part skips ctest --test-dir "$work/skips"
part bad false
finish table
END
expect 1 '  Instead: another cage' bash "$work/parts"
grep -qx '  Instead: another cage' "$work/said" && grep -qxE 'bad +[0-9]+ s  FAILED' "$work/said" && grep -qx '  1 - lacking (Skipped)' "$work/said" || {
  echo "FAILED: the table's lines run together: $(cat "$work/said")"
  failures=$((failures + 1))
}
expect 1 'Failed: bad' bash "$work/parts"

[ $failures -eq 0 ] && echo 'Gates fail where they cannot look.'
exit $((failures > 0))
