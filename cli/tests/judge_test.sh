#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Foreign code is one more evaluation, and `judge` certifies it: examples that compile and are clean, a command that is this program itself, hostile code.
# Usage: judge_test.sh PATH_OF_CAGEPROOF FOLDER_OF_JUDGE
. "$(dirname "$0")/support.sh"
export CAGEPROOF_TRUTH_CACHE=off
folder=$2
point='"element":[[0,0],[1,0]],"point":[0.5,0.5]'

# Lines of eval name formula, order and scalar themselves; an option and a line must not contradict each other.
printf '%s\n' "{\"formula\":\"segment.winding_angle\",\"order\":1,$point}" '{"describe":true}' "{\"formula\":\"nonsense\",$point}" \
  "{\"formula\":\"segment.winding_angle\",\"order\":3,$point}" "{$point}" "{\"formula\":\"segment.winding_angle\",\"scalar\":\"float\",$point}" |
  "$cageproof" eval --evaluation plain >lines
[ $? -eq 2 ] || fail "bad lines are not exit 2"
grep -q '^{"value":\[1.57079632679[0-9]*\],"gradient":\[' lines || fail "a line with formula and order: $(cat lines)"
grep -q '^{"formulas":{.*"segment.winding_angle":2.*},"float":true,"about":"cageproof ' lines || fail "describe: $(cat lines)"
for text in "unknown formula 'nonsense'" '"order\\" must be 0, 1 or 2' 'Give --formula' '^{"value":\[1.5707964\]}'; do
  grep -q -- "$text" lines || fail "no $text in $(cat lines)"
done
echo "{\"formula\":\"segment.single_layer\",$point}" | "$cageproof" eval --formula segment.winding_angle --evaluation plain | grep -q '"error":.*--formula segment.winding_angle' ||
  fail "a line that contradicts --formula"

# Examples compile by the commands at their top, and are clean.
for language in c cpp; do
  "$cageproof" judge --template $language --out $language >/dev/null || fail "template $language"
  build=$(sed -n 's/^[ /*]*\(c[c+][c+ ].*-o libmine.so.*\)$/\1/p' $language/mine.$language)
  (cd $language && eval "$build" && "$cageproof" judge mine=./libmine.so --samples 40 --out certificate >verdict) || fail "the example in $language: $(cat $language/verdict)"
  grep -q '^mine: clean; 40 samples a regime, 1 formula$' $language/verdict || fail "verdict of $language: $(cat $language/verdict)"
done
"$cageproof" judge --template python >/dev/null && "$cageproof" judge mine=./mine.py --samples 40 >verdict || fail "the example in Python: $(cat verdict)"
refuses_to judge 'mine.py is there already' -- --template python
/usr/bin/python3 - c/certificate/certificate.json "$(sha256sum <c/libmine.so)" <<'END' || fail "certificate.json"
import json
import sys
c = json.load(open(sys.argv[1]))
assert c["schema"] == "cageproof-certificate" and c["verdict"] == "clean" and c["judged"]["about"] == "winding angle by the arctangent, 1.0"
assert c["judged"]["files"][0]["sha256"] == sys.argv[2].split()[0]
assert {row["regime"] for row in c["formulas"][0]["rows"]} >= {"generic", "near-face", "far", "scaled"}
END

# The example of one formula is wrong only on edges, as it says; others decline until the user's function is there.
example() {
  local language=$1 formula=$2 ending build
  rm -rf example
  "$cageproof" judge --template "$language" --formula "$formula" --out example >/dev/null || fail "template $language of $formula"
  ending=$(sed 's/python/py/' <<<"$language")
  grep -q "$formula" "example/mine.$ending" && ! grep -q '{{' "example/mine.$ending" || fail "template $language of $formula: $(cat "example/mine.$ending")"
  build=$(sed -n 's/^[ /*]*\(c[c+][c+ ].*-o libmine.so.*\)$/\1/p' "example/mine.$ending" | sed 's/-shared/-Wall -Wextra -Werror -shared/')
  what=./mine.py
  [ -z "$build" ] || what=./libmine.so
  (cd example && eval "$build" && "$cageproof" judge mine=$what --samples 20 --quiet) >stdout 2>stderr
}
for language in c cpp python; do
  example $language triangle.solid_angle
  [ "$(grep -c '^DEFECT' stdout)" -eq 1 ] && grep -q '^DEFECT wrong_values' stdout || fail "the solid angle in $language: $(cat stdout stderr)"
  example $language triangle.kelvin_traction
  [ $? -eq 2 ] && grep -q 'declined all inputs' stderr || fail "a frame in $language: $(cat stdout stderr)"
done
for kind in green inside spherical_mean_value; do
  rm -rf example
  "$cageproof" judge --template python-cage --kind $kind --out example >/dev/null || fail "template of $kind"
  "$cageproof" judge mine=example/mine_cage.py --kind $kind --samples 3 --quiet >stdout 2>stderr
  [ $? -eq 2 ] && grep -q 'declined all inputs' stderr || fail "a frame of $kind: $(cat stdout stderr)"
done
refuses_to judge 'whole cages, whose example is --template python-cage' -- --template c --kind mean_value
refuses_to judge "unknown formula 'triangle.nothing'" -- --template c --formula triangle.nothing --out nothing

# A certificate's input is a line that eval takes.
/usr/bin/python3 -c 'import json; print(json.dumps(json.load(open("c/certificate/certificate.json"))["formulas"][0]["rows"][0]["conditioned"]["input"]))' |
  "$cageproof" eval --formula segment.winding_angle --evaluation hybrid >/dev/null || fail "an input of the certificate"

# A promise of its own, kept and broken.
promised() { "$cageproof" judge mine=c/libmine.so --samples 20 --regimes generic,far --promise "$@" >stdout 2>stderr; }
promised 1e-12 || fail "a promise that is kept: $(cat stdout)"
promised 1e-18 --measure conditioned
[ $? -eq 1 ] && grep -q 'conditioned error at most 1e-18: BROKEN in 2 rows' stdout || fail "a promise that is broken: $(cat stdout)"

# This program as a command has its own figures, digit for digit.
"$cageproof" verify --judge mine="'$cageproof' eval --evaluation plain" --formulas segment.winding_angle --regimes generic,near-line --evaluations mine,plain \
  --samples 20 --out report >stdout 2>stderr || fail "verify --judge: $(cat stdout stderr)"
/usr/bin/python3 - <<'END' || fail "a command's figures are not those of the program itself"
import gzip
import json
rows = json.load(gzip.open("report/summary.json.gz"))["rows"]
facts = lambda evaluation: {(r["regime"], r["order"]): (r["samples"], r["max"], r["median"], r["max_relative"], r["histogram"]) for r in rows
                            if r["evaluation"] == evaluation and r["check"] == "truth" and r["scalar"] == "double"}
mine, plain = facts("mine"), facts("plain")
assert len(mine) == 6 and mine == plain, (mine, plain)
assert {r["role"] for r in rows if r["evaluation"] == "mine"} == {"foreign"}
END

# The other commands have it too.
"$cageproof" bench --judge mine=c/libmine.so --formula segment.winding_angle --evaluations mine,plain --samples 4 --timed 64 --seconds 0 | grep -q '^generic  *mine ' || fail "bench --judge"
"$cageproof" hunt --judge mine=c/libmine.so --formula segment.winding_angle --evaluation mine --budget 50 --regime generic --out worst.jsonl --quiet >/dev/null || fail "hunt --judge"
"$cageproof" replay --judge mine=c/libmine.so worst.jsonl | grep -q ' 0 changed since stored$' || fail "replay --judge"
"$cageproof" field --judge mine=c/libmine.so --formula segment.winding_angle --evaluation mine --resolution 8 --out field >/dev/null || fail "field --judge"

# A convention is found and taken into account, and a defect is named with an input that proves it.
"$cageproof" judge mine="$folder/tests/programs/threshold.py" --samples 20 --regimes generic,near-face --out threshold >stdout 2>stderr
[ $? -eq 1 ] || fail "a threshold is a defect: $(cat stdout stderr)"
grep -q 'yours is ours times 1/(4 pi)' stdout || fail "a factor is recognised: $(cat stdout)"
grep -q '^DEFECT absolute_threshold, triangle.solid_angle, order 0: ' stdout || fail "a threshold is named: $(cat stdout)"
grep -q '^  generic  *value  *20 .* 1[45]\.[0-9] ' stdout || fail "errors are those in our convention: $(cat stdout)"
grep -q 'absolute_threshold' threshold/certificate.md || fail "the defect in the certificate"

# Exit codes: 1 for defects, 2 for code that cannot be judged.
"$cageproof" judge mine="$folder/tests/programs/hostile.py crash" --samples 20 --regimes generic >stdout 2>stderr
[ $? -eq 1 ] && grep -q '^DEFECT wrong_values, triangle.single_layer, order 0: ' stdout || fail "sevens: $(cat stdout stderr)"
refuses_to judge 'nothing.so' 'no such file' -- mine=./nothing.so --out nowhere
refuses_to judge 'no_such_program' 'not found' -- mine=./no_such_program
refuses_to judge 'does not say which formulas' -- mine='while read -r line; do echo "{\"error\":1}"; done'
refuses_to judge "no formula of 'triangle.*'" -- mine=c/libmine.so --formula 'triangle.*'
refuses_to judge NAME=WHAT -- mine
refuses_to judge 'no regime of' -- mine=c/libmine.so --regimes sliver
refuses_to judge closed_form 'another name' -- closed_form=c/libmine.so
refuses_to verify 'nothing.so' -- --judge mine=./nothing.so --formulas segment.winding_angle --out report

# A program that hangs at every input ends in time, and leaves nothing running.
/usr/bin/python3 - >hangs.py <<'END'
print('import sys, time\nsys.stdin.readline()\nprint(\'{"formulas":{"segment.winding_angle":0}}\', flush=True)\ntime.sleep(1000)')
END
timeout 60 "$cageproof" judge mine='/usr/bin/python3 hangs.py' --samples 10 --seconds 0.3 >stdout 2>stderr
[ $? -eq 1 ] && grep -q '^DEFECT hang' stdout && grep -q 'inputs were not asked' stdout || fail "a program that hangs: $(cat stdout stderr)"
! pgrep -f "hangs.py" >/dev/null || fail "a program that hangs still runs"

# A command that is killed takes the foreign code with it.
"$cageproof" judge mine='/usr/bin/python3 hangs.py' --samples 10 --seconds 100 >stdout 2>stderr &
for _ in $(seq 100); do pgrep -f "hangs.py" >/dev/null && break; sleep 0.1; done
kill -KILL $!
wait $! 2>/dev/null
for _ in $(seq 100); do pgrep -f "hangs.py" >/dev/null || break; sleep 0.1; done
! pgrep -f "hangs.py" >/dev/null || fail "foreign code outlives a command that was killed"

[ "$failures" -eq 0 ] || exit 1
echo "judge: ok"
