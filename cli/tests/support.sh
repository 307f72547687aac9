# shellcheck shell=bash
# SPDX-License-Identifier: MIT
# Sourced by tests whose first argument is the path of cageproof: makes a working folder, removed at the end, and checks refusals.
set -u
cageproof=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 2
failures=0
# Lines of progress would be messages where a machine is slow.
export CAGEPROOF_PROGRESS=1e9

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# refuses_to COMMAND WORDS... -- ARGUMENTS...: exit 2, one line on standard error that holds every word, no file written.
refuses_to() {
  local command=$1 words=() word before
  shift
  while [ "$1" != -- ]; do words+=("$1"); shift; done
  shift
  rm -f stdout stderr
  before=$(ls -AR)
  "$cageproof" "$command" "$@" >stdout 2>stderr </dev/null
  local code=$?
  [ $code -eq 2 ] || fail "exit $code, not 2: $*"
  [ "$(wc -l <stderr)" -eq 1 ] || fail "not one line: $* : $(cat stderr)"
  for word in "${words[@]}"; do grep -qF -- "$word" stderr || fail "no '$word' in: $(cat stderr)"; done
  rm -f stdout stderr
  [ "$(ls -AR)" = "$before" ] || fail "left something behind: $*"
}
