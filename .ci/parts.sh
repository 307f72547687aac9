# shellcheck shell=bash
# SPDX-License-Identifier: MIT
# Sourced by .ci/run and .ci/nightly: parts that all run, whatever fails before them, and what is said at the end.
logs=$(mktemp -d)
trap 'rm -rf "$logs"' EXIT
failed=()
took=''
table=''

# part NAME COMMAND...: runs it; keeps its name and its errors where it fails. Its time is said as the next part begins, so that the last part's output is the last.
part() {
  local name=$1 start=$SECONDS verdict=passed
  shift
  printf '%s== %s: %s\n' "$took" "$name" "$*"
  "$@" </dev/null 2>&1 | tee "$logs/part" || {
    verdict=FAILED
    failed+=("$name")
    { grep -m 12 -E 'error:|Failure|FAILED|BROKEN' "$logs/part" || tail -n 5 "$logs/part"; } | cut -c 1-300 >"$logs/failed-${#failed[@]}"
  }
  took="== $name took $((SECONDS - start)) s"$'\n'
  table+=$(printf '%-40s %6s s  %s' "$name" "$((SECONDS - start))" "$verdict")$'\n'
  # A part says so where something took the place of what it should have used, and CTest which tests it skipped.
  local noted
  while read -r noted; do table+="  $noted"$'\n'; done < <(grep -E '^Instead: |^\s+[0-9]+ - .* \(Skipped\)' "$logs/part")
}

# Says the failures again at the end, because the end is read first. \param 1 `table`: first a line per part, with its time and verdict
finish() {
  local i
  [[ ${1-} != table ]] || printf '%s%s' "$took" "$table"
  ((${#failed[@]})) || exit 0
  for i in "${!failed[@]}"; do
    printf 'Failed: %s\n' "${failed[i]}"
    cat "$logs/failed-$((i + 1))"
  done
  exit 1
}
