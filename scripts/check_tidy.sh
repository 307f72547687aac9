#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/check_tidy.sh [BASE]: clang-tidy over the C++ sources that commits since BASE changed, the last ones first, for at most six minutes; says which it did
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
git rev-parse --verify --quiet "$base^{commit}" >/dev/null || {
  echo "$base is no commit" >&2
  exit 2
}
mapfile -t files < <(git log --format= --name-only --diff-filter=d "$base..HEAD" -- '*.cpp' | awk '!seen[$0]++' | while read -r file; do
  # What is compiled for other processors, or against the installed library, has no command here.
  [[ ! -f $file || $file == scripts/* || $file == docs/* || $file == */tests/consumer/* ]] || printf '%s\n' "$file"
done)
((${#files[@]})) || {
  echo "clang-tidy: no source was changed by the commits since $base"
  exit 0
}

# Commands of single files: no unity build, no precompiled headers.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake -S . -B "$work/commands" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_COMPILER=clang-16 -DCMAKE_CXX_COMPILER=clang++-16 \
  -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >"$work/log" 2>&1 || {
  cat "$work/log" >&2
  exit 2
}
: >"$work/clean"
: >"$work/found"
# shellcheck disable=SC2016  # expanded by the inner shell
printf '%s\n' "${files[@]}" | timeout 360 xargs -P "$(nproc)" -n 1 bash -c \
  'if "$0" --quiet -p "$1/commands" "$2" 2>/dev/null; then echo "$2" >>"$1/clean"; else echo "$2" >>"$1/found"; fi' "$tidy" "$work" || true
mapfile -t missed < <(printf '%s\n' "${files[@]}" | grep --invert-match --line-regexp --fixed-strings --file="$work/clean" --file="$work/found" || true)
printf 'clang-tidy: %s of %s changed sources are clean, %s are not, %s were not reached\n' \
  "$(wc -l <"$work/clean")" "${#files[@]}" "$(wc -l <"$work/found")" "${#missed[@]}"
((${#missed[@]} == 0)) || printf '  not reached: %s\n' "${missed[@]}"
[[ ! -s $work/found ]] || exit 1
