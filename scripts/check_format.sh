#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/check_format.sh [--fix]: whether every C++ file is as .clang-format has it (Debian 12's clang-format, version 14). Exit 0: all are; 1: some are
# not, each named; 2: clang-format is missing, or failed itself.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
command -v clang-format >/dev/null || {
  echo "clang-format is missing: scripts/ensure_packages.sh installs it" >&2
  exit 2
}
mapfile -t files < <(git ls-files '*.cpp' '*.h' '*.hpp')
((${#files[@]})) || exit 2
if [[ ${1-} == --fix ]]; then exec clang-format -i "${files[@]}"; fi
log=$(mktemp)
trap 'rm -f "$log"' EXIT
# Unformatted files are warnings, with which clang-format exits with 0: another code says that it could not look.
clang-format --dry-run --ferror-limit=1 "${files[@]}" >"$log" 2>&1 || {
  head -n 5 "$log" >&2
  echo "clang-format failed: whether the files are formatted is not known" >&2
  exit 2
}
found=$(grep -oE '^[^: ]+\.(cpp|hpp|h)' "$log" | sort -u || true)
[[ -z $found ]] || {
  printf '%s\n' "$found" "These are not formatted; scripts/check_format.sh --fix formats them."
  exit 1
}
