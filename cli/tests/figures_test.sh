#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The papers' figures from the command line, and how that is refused. Usage: figures_test.sh PATH_OF_CAGEPROOF
# shellcheck source=support.sh
source "$(dirname "$(readlink -f "$0")")/support.sh"

# refuses WORDS... -- ARGUMENTS of figures...
refuses() { refuses_to figures "$@"; }

"$cageproof" figures --out one --jobs 1 >lines </dev/null || fail "embedded figures"
"$cageproof" figures --out two --jobs 2 >/dev/null </dev/null || fail "with two threads"
diff -r one two >/dev/null || fail "threads change bytes"
names=(t24-bend t24-twist c23-global c23-local c23-kernels t18-symmetry quads-kept w12-bar w12-legs w12-same-square w12-rhombus w12-star
  w12-neck w12-seam c23-star c23-infinite-ratio c23-bar c23-infinite-ratio-bar c23-hexagon c23-l
  t24-gamma t24-alignment t24-variational t24-spikes
  t18-valid-quads t18-projection t18-tessellation t18-norm-correction t18-twisted-box t18-spherical t18-triquad t18-positive)
for name in "${names[@]}"; do
  [ -s "one/figures/$name.png" ] || fail "no $name.png"
  grep -q "^one/figures/$name.png: " lines || fail "$name is not printed"
done
[ "$(ls one)" = figures ] || fail "more than figures/: $(ls one)"
pictures=$(find one -name '*.png' | wc -l) panels=$(find one -name '*.vtp' | wc -l)
[ "$pictures" -eq "${#names[@]}" ] || fail "$pictures pictures"
[ "$(grep -c '"data": "figures/.*\.vtp"' one/figures/figures.json)" -eq "$panels" ] || fail "figures.json does not name all $panels data"
[ "$(find one/figures -type f | wc -l)" -eq $((pictures + panels + 1)) ] || fail "other files: $(ls one/figures)"
grep -q '"asymmetry over cage size"' one/figures/figures.json || fail "no asymmetry"
# The written data can be read again.
"$cageproof" deform --cage cube --posed cube --points one/figures/t18-symmetry.rest.taper.vtp --method mean_value --out again.obj >/dev/null || fail "data are not read again"

mkdir mine data && echo dear >mine/letter.txt
refuses "letter.txt" -- --out mine
refuses "missing" -- --out missing/out
refuses "nowhere" -- --data nowhere --out out
refuses "_Cage.obj" -- --data data --out out
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n' >data/X_Cage.obj
refuses "X_Cage_Deformed.obj" -- --data data --out out
cp data/X_Cage.obj data/X_Cage_Deformed.obj
refuses "X.obj" -- --data data --out out
# The disk is full in the middle of it.
before=$(ls -A)
(trap '' XFSZ; ulimit -f 20; "$cageproof" figures --out out --jobs 1 >/dev/null 2>stderr </dev/null)
[ $? -eq 2 ] || fail "a full disk is not exit 2: $(cat stderr)"
grep -q 'cannot write' stderr || fail "a full disk: $(cat stderr)"
rm -f stderr
[ "$(ls -A)" = "$before" ] || fail "a full disk leaves something: $(ls -A)"

[ $failures -eq 0 ] && echo "all passed"
exit $((failures > 0))
