#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/check_tidy.sh [BASE]: clang-tidy over the C++ sources that differ from BASE, those changed last first, for at most eight minutes; says which it did
# not reach. BASE: the branch's start off origin/main; on origin/main itself, ten commits back. Exit 0: nothing found; 1: something; 2: it cannot run.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
tidy=$(command -v clang-tidy-16) || {
  echo "clang-tidy-16 is missing: scripts/ensure_packages.sh installs it" >&2
  exit 2
}
base=${1-}
if [[ -z $base ]]; then
  base=$(git merge-base HEAD origin/main 2>/dev/null || true)
  if [[ -z $base || $base == $(git rev-parse HEAD) ]]; then base=$(git rev-list --first-parent -n 11 HEAD | tail -n 1); fi
fi
mapfile -t files < <(git log --format= --name-only --diff-filter=d "$base..HEAD" -- '*.cpp' | awk '!seen[$0]++' | while read -r file; do
  [[ ! -f $file ]] || printf '%s\n' "$file"
done)
((${#files[@]})) || exit 0

# Commands of single files: no unity build, no precompiled headers.
commands=$(mktemp -d)
done=$(mktemp)
trap 'rm -rf "$commands" "$done"' EXIT
cmake -S . -B "$commands" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_COMPILER=clang-16 -DCMAKE_CXX_COMPILER=clang++-16 \
  -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >"$done" 2>&1 || {
  cat "$done" >&2
  exit 2
}
: >"$done"
status=0
# shellcheck disable=SC2016  # expanded by the inner shell
printf '%s\n' "${files[@]}" | timeout 480 xargs -P "$(nproc)" -n 1 bash -c '"$0" --quiet -p "$1" "$3" 2>/dev/null && echo "$3" >>"$2"' \
  "$tidy" "$commands" "$done" || status=$?
reached=$(sort -u "$done" | wc -l)
echo "clang-tidy: $reached of ${#files[@]} changed sources are clean"
case $status in
  0) ;;
  124) echo "Not reached in eight minutes, or not clean:" && printf '%s\n' "${files[@]}" | grep --invert-match --line-regexp --fixed-strings --file="$done" || true ;;
  *) exit 1 ;;
esac
