#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# extension_test.sh PROGRAM: a program with two more formulas (cli/tests/extension), which no list of names knows. One has a row, a kernel and a closed form;
# the other only a row and a kernel. Both must be found by every command.
set -uo pipefail

cageproof=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
  printf 'FAILED: %s\n' "$1"
  exit 1
}

"$cageproof" list >"$work/list" || fail list
for formula in triangle.my_potential triangle.inverse_square; do
  grep -q "^$formula\$" "$work/list" || fail "list does not show $formula"
done
grep -A2 '^triangle.my_potential$' "$work/list" | grep -q 'hybrid accurate adaptive closed_form gauss.*plain' || fail "my_potential's evaluations: $(cat "$work/list")"
grep -A2 '^triangle.inverse_square$' "$work/list" | grep -q 'closed_form' && fail 'inverse_square has a closed form from nowhere'

# int 1/r over the unit right triangle seen from its corner at the right angle: sqrt(2) log(1 + sqrt(2)).
corner='{"element":[[0,0,0],[1,0,0],[0,1,0]],"point":[0,0,0]}'
value=$(printf '%s\n' "$corner" | "$cageproof" eval --formula triangle.my_potential --evaluation closed_form) || fail 'eval my_potential'
printf '%s' "$value" | grep -q '"value":\[1.24645048' || fail "my_potential at a corner: $value"
# int 1/r^2 far above the triangle is its area over the distance squared.
far='{"element":[[0,0,0],[1,0,0],[0,1,0]],"point":[0,0,1000]}'
value=$(printf '%s\n' "$far" | "$cageproof" eval --formula triangle.inverse_square --evaluation multiprecision --scalar mp50) || fail 'eval inverse_square'
printf '%s' "$value" | grep -q '4.9999983' || fail "inverse_square far away: $value"

for formula in triangle.my_potential triangle.inverse_square; do
  "$cageproof" verify --formulas "$formula" --suite quick --samples 14 --regimes 'near-*' --out "$work/$formula" >"$work/stdout" 2>&1 ||
    fail "verify $formula: $(tail -5 "$work/stdout")"
  grep -q "$formula" "$work/$formula/index.html" || fail "$formula is not on the page"
  zgrep -q "$formula" "$work/$formula/results.csv.gz" || fail "$formula is not in the results"
  "$cageproof" bench --formula "$formula" --regime generic --evaluations gauss-8 --samples 4 --csv >"$work/bench" 2>&1 || fail "bench $formula: $(cat "$work/bench")"
done
zgrep -q ',kept,' "$work/triangle.my_potential/results.csv.gz" || fail 'no promise of my_potential is kept'
zgrep 'triangle.my_potential,closed_form,double,near-edge,truth' "$work/triangle.my_potential/results.csv.gz" | grep -q kept || fail 'the closed form of my_potential is not judged'
zgrep 'triangle.inverse_square,gauss-8,double,near-edge,truth' "$work/triangle.inverse_square/results.csv.gz" >/dev/null || fail 'inverse_square is not measured against its integral'
zgrep -q 'inverse_square: no recommended evaluation' "$work/triangle.inverse_square/summary.json.gz" || fail 'nothing says that the integral is the truth'
echo passed
