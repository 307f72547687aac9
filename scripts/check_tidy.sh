#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/check_tidy.sh [BASE]: clang-tidy over the C++ sources that differ from BASE (default HEAD~1), with the release build's commands. Ends after ten
# minutes with what it has. Exit 0: nothing found; 1: something; 2: no clang-tidy, or no build.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
tidy=$(command -v clang-tidy-16 || command -v clang-tidy) || { echo "no clang-tidy" >&2; exit 2; }
commands=build/release/compile_commands.json
[[ -f $commands ]] || { echo "no $commands: build first" >&2; exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# clang cannot read GCC's precompiled headers, nor all of its warnings.
sed -E 's/-Winvalid-pch//; s/-include [^ ]*cmake_pch\.hxx//; s/-Wno-stringop-overflow|-Wno-restrict//g' "$commands" >"$work/compile_commands.json"
mapfile -t files < <(git diff --name-only --diff-filter=d "${1-HEAD~1}" -- '*.cpp')
((${#files[@]})) || exit 0
printf '%s\n' "${files[@]}" | timeout 600 xargs -P "$(nproc)" -n 1 "$tidy" --quiet -p "$work" || exit 1
