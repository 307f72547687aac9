#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# closed_form/README.md, "You can use one formula without the rest of the project": its program, with the files of its list and no others, built by its commands,
# prints what stands there. Every file of the list is needed.
# Usage: one_header_test.sh COMPILER
set -u
compiler=$1
here=$(dirname "$(readlink -f "$0")") && root=$(readlink -f "$here/../..")
page=$root/closed_form/README.md
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# block LANGUAGE N: the page's Nth block of a language.
block() { awk -v start="\`\`\`$1" -v wanted="$2" '/^```$/ {within = 0} within {print} $0 == start && ++seen == wanted {within = 1}' "$page"; }
block text 1 >"$work/list"
block sh 1 >"$work/commands"
block text 2 >"$work/prints"
if ! grep -q . "$work/list" || ! grep -q . "$work/commands" || ! grep -q . "$work/prints"; then
  echo "FAILED: closed_form/README.md has no list of files, no commands or nothing that is printed"
  exit 1
fi

# The commands say c++.
mkdir "$work/bin" "$work/alone"
# Without optimisation, which has no part in what is tested and takes most of the time.
printf '#!/bin/sh\nexec "%s" "$@" -O0\n' "$compiler" >"$work/bin/c++"
chmod +x "$work/bin/c++"
export PATH="$work/bin:$PATH"

cd "$work/alone" || exit 2
while read -r file; do
  mkdir -p "$(dirname "$file")"
  cp "$root/$file" "$file" || fail "$file is on the list, and not in the project"
done <"$work/list"
block cpp 1 >one_form.cpp
[ "$(wc -l <one_form.cpp)" -le 10 ] || fail "the program has more than ten lines"

if bash -e "$work/commands" >"$work/log" 2>&1; then
  ./one_form >"$work/printed"
  diff "$work/prints" "$work/printed" || fail "the program prints something else"
else
  head -n 20 "$work/log"
  echo "FAILED: the files of the list do not build"
  exit 1
fi

# The compiler reads exactly those files of the project that the page lists.
sed 's/ -o one_form//; s/ orientation.o//; s/ -l[a-z]*//g; s/ -c / /; s/^c++ /c++ -MM /' "$work/commands" >"$work/reading"
readers() { bash -e "$work/reading" 2>/dev/null; }
readers | tr ' ' '\n' | grep -E '^(core|closed_form)/' | sort -u | diff <(sort "$work/list") - || fail "the list has a file that nothing reads"
# Nothing is found elsewhere.
while read -r file; do
  mv "$file" "$work/taken"
  readers >/dev/null && fail "without $file the program builds as well"
  mv "$work/taken" "$file"
done < <(grep -E 'exact_signs.h|climb.h|scalar_names.h' "$work/list")

[ $failures -eq 0 ] && echo "One header builds with the files of its list."
exit $((failures > 0))
