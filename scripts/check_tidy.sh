#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/check_tidy.sh [--minutes N] [--all | BASE]: clang-tidy over the C++ files that commits since BASE changed, the last ones first; --all: over all sources.
# A header is checked with a source that includes it; moves, and changes of only #include lines, comments and names of namespaces, are not looked at. BASE: the branch's start off origin/main; on origin/main itself, ten commits back.
# --minutes: stops then, and fails when it did not reach all files. Exit 0: all were looked at, nothing found; 1: something was found, or a file not reached;
# 2: it cannot run.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
tidy=$(command -v clang-tidy-16) || {
  echo "clang-tidy-16 is missing: scripts/ensure_packages.sh installs it" >&2
  exit 2
}
limit=0 base='' all=''
while (($#)); do
  case $1 in
    --minutes) limit=${2?--minutes takes a number}m && shift ;;
    --all) all=yes ;;
    *) base=$1 ;;
  esac
  shift
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Sources compiled for other processors, by tests, or against the installed library, have no command here.
has_command() { [[ -f $1 && $1 != scripts/* && $1 != docs/* && $1 != judge/adapters/* && $1 != */tests/consumer/* && $1 != */tests/shared/* && $1 != */tests/without_mpfr/* ]]; }

# The source that a changed file is checked with: itself, or for a header the source of its name, or any that includes it.
source_of() {
  local file=$1
  if [[ $file == *.h ]]; then
    local name included
    name=$(basename "$file" .h)
    included=${file##*/include/}
    [[ $included != "$file" ]] || included=$(basename "$file")
    file=$(git ls-files -- "*/$name.cpp" | head -n 1)
    if [[ -z $file ]] || ! grep -q "$included\"" "$file"; then file=$(git grep -l -F "$included\"" -- '*.cpp' ':!scripts' ':!docs' | head -n 1 || true); fi
    # Headers that only other headers include are checked with these.
    if [[ -z $file ]]; then
      local header
      header=$(git grep -l -F "$included\"" -- '*.h' | head -n 1 || true)
      [[ -n $header && ${2-0} -lt 8 ]] || return 0
      source_of "$header" $((${2-0} + 1))
      return
    fi
  fi
  if has_command "$file"; then printf '%s\n' "$file"; fi
}

# cageproof.hpp has no source here that includes it: users compile it.
sources=('*.cpp' '*.h')
if [[ -n $all ]]; then
  since='the first commit'
  changed=$(git ls-files -- "${sources[@]}")
else
  if [[ -z $base ]]; then
    base=$(git merge-base HEAD origin/main 2>/dev/null || true)
    if [[ -z $base || $base == $(git rev-parse HEAD) ]]; then base=$(git rev-list --first-parent -n 11 HEAD | tail -n 1); fi
  fi
  git rev-parse --verify --quiet "$base^{commit}" >/dev/null || {
    echo "$base is no commit" >&2
    exit 2
  }
  since=$base
  # Files that were moved, or of which only #include lines, comments and names of namespaces changed, are the same code.
  git diff --find-renames -l5000 --unified=0 "$base" HEAD -- "${sources[@]}" |
    awk '/^\+\+\+ / {file = substr($0, 7); next} /^--- / {next} /^[-+]/ && (!/^[-+][ \t]*(#include .*|\/\/.*|(\}  \/\/ )?namespace [A-Za-z0-9_:]*( \{)?)?$/ || /NOLINT/) && !seen[file]++ {print file}' >"$work/code"
  # The last changes first; then what only a merge changed, which `git log` does not list.
  changed=$({ git log --format= --name-only --diff-filter=d "$base..HEAD" -- "${sources[@]}" && git diff --name-only --diff-filter=d "$base" HEAD -- "${sources[@]}"; } |
    awk '!seen[$0]++' | grep -Fxf "$work/code" || true)
fi
# Headers that no source includes, and that are neither stand-ins of tests nor for programs in C.
for file in $changed; do
  [[ -f $file ]] || continue
  source=$(source_of "$file")
  if [[ -n $source ]]; then printf '%s\n' "$source" >>"$work/sources"
  elif [[ $file == *.h && $file != scripts/* && $file != docs/* && $file != judge/checkers/* && $file != */tests/* ]]; then printf '%s\n' "$file" >>"$work/homeless"; fi
done
touch "$work/sources" "$work/homeless"
mapfile -t files < <(awk '!seen[$0]++' "$work/sources")
mapfile -t homeless <"$work/homeless"
((${#files[@]} + ${#homeless[@]})) || {
  echo "clang-tidy: no C++ file was changed by the commits since $since"
  exit 0
}

# Sources are read several at once, without precompiled headers.
cmake -S . -B "$work/commands" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_COMPILER=clang-16 -DCMAKE_CXX_COMPILER=clang++-16 \
  -DCMAKE_UNITY_BUILD=ON -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >"$work/log" 2>&1 || {
  cat "$work/log" >&2
  exit 2
}
# Some are included by sources that CMake writes only, themselves or by other headers. What nothing includes, nothing checks.
written_source_of() {
  local source includer
  source=$(grep -rlF --include=*.cpp "$(basename "$1")\"" "$work/commands" | head -n 1 || true)
  if [[ -z $source && ${2-0} -lt 8 ]]; then
    for includer in $(git grep -l -F "$(basename "$1")\"" -- '*.h' || true); do
      [[ -n $source ]] || source=$(written_source_of "$includer" $((${2-0} + 1)))
    done
  fi
  printf '%s' "$source"
}
for header in "${homeless[@]}"; do
  source=$(written_source_of "$header")
  [[ -n $source ]] || {
    printf '  error: no source includes it, and nothing checked it: %s\n' "$header"
    exit 1
  }
  files+=("$source")
done
: >"$work/clean"
: >"$work/found"
/usr/bin/python3 scripts/tidy_units.py "$work/commands" "$work/units" "${files[@]}" >"$work/list"
# check UNITS UNIT FILE...: an include of a source is the units' own. What is found in several is looked for in each by itself, which may name things as another
# one does.
check() {
  local units=$1 unit=$2 file alone
  shift 2
  if "$tidy" --quiet --config-file=.clang-tidy --checks=-bugprone-suspicious-include -p "$units" "$unit" >"$unit.said" 2>/dev/null; then
    printf '%s\n' "$@" >>"$work/clean"
  elif (($# == 1)); then
    cat "$unit.said"
    printf '%s\n' "$1" >>"$work/found"
  else
    for file in "$@"; do
      alone=$(mktemp -d "$work/alone.XXXXXX")
      /usr/bin/python3 scripts/tidy_units.py "$work/commands" "$alone/units" "$file" >/dev/null
      check "$alone/units" "$alone/units/0.cpp" "$file"
    done
  fi
}
export -f check
export work tidy
# shellcheck disable=SC2016  # expanded by the inner shell
timeout "$limit" xargs -P "$(nproc)" -L 1 bash -c 'check "$work/units" "$@"' check <"$work/list" || true
mapfile -t missed < <(printf '%s\n' "${files[@]}" | grep --invert-match --line-regexp --fixed-strings --file="$work/clean" --file="$work/found" || true)
printf 'clang-tidy: %s of %s sources are clean, %s are not, %s were not reached\n' \
  "$(wc -l <"$work/clean")" "${#files[@]}" "$(wc -l <"$work/found")" "${#missed[@]}"
((${#missed[@]} == 0)) || printf '  error: not reached: %s\n' "${missed[@]}"
[[ ! -s $work/found ]] && ((${#missed[@]} == 0))
