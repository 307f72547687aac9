# shellcheck shell=bash
# SPDX-License-Identifier: MIT
# Sourced by .ci/run and .ci/nightly: parts that all run, whatever fails before them, and what is said at the end.
logs=$(mktemp -d)
trap 'rm -rf "$logs"' EXIT
failed=()

# part NAME COMMAND...: runs it; keeps its name and its errors where it fails.
part() {
  local name=$1 start=$SECONDS
  shift
  printf '== %s: %s\n' "$name" "$*"
  "$@" </dev/null 2>&1 | tee "$logs/part" || {
    failed+=("$name")
    { grep -m 12 -E 'error:|Failure|FAILED|BROKEN' "$logs/part" || tail -n 5 "$logs/part"; } | cut -c 1-300 >"$logs/failed-${#failed[@]}"
  }
  printf '== %s took %s s\n' "$name" $((SECONDS - start))
}

# Says the failures again at the end, because the end is read first.
finish() {
  local i
  ((${#failed[@]})) || exit 0
  for i in "${!failed[@]}"; do
    printf 'Failed: %s\n' "${failed[i]}"
    cat "$logs/failed-$((i + 1))"
  done
  exit 1
}
