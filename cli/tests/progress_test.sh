#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Progress, remarks and --quiet.
# Usage: progress_test.sh PATH_OF_CAGEPROOF
. "$(dirname "$0")/support.sh"
export CAGEPROOF_TRUTH_CACHE=off
unset CAGEPROOF_PROGRESS

run_verify() { "$cageproof" verify --formulas segment.winding_angle --samples 20 --out report "$@" >stdout 2>stderr || fail "verify $*: $(cat stderr)"; }

# A short run that nobody watches writes no line of progress; one that may write any number writes whole lines.
run_verify
grep -q measuring stderr && fail "progress within seconds: $(cat stderr)"
CAGEPROOF_PROGRESS=0 run_verify
grep -Eqx 'measuring [0-9]+ %(, about [0-9.]+ (s|min|h) left)?' stderr || fail "no line of progress: $(cat stderr)"
grep -Evx 'measuring [0-9]+ %(, about [0-9.]+ (s|min|h) left)?' stderr >other && fail "beside progress: $(cat other)"
grep -q $'\r' stderr && fail 'a line is rewritten where there is no terminal'
CAGEPROOF_PROGRESS=0 run_verify --quiet
[ ! -s stderr ] || fail "verify --quiet says: $(cat stderr)"
CAGEPROOF_PROGRESS=1h "$cageproof" verify --formulas segment.winding_angle --samples 2 --out refused >stdout 2>stderr
[ $? -eq 2 ] && grep -q "CAGEPROOF_PROGRESS: '1h' is no number of seconds" stderr || fail "CAGEPROOF_PROGRESS=1h: $(cat stderr)"
CAGEPROOF_PROGRESS=-1 "$cageproof" verify --formulas segment.winding_angle --samples 2 --out refused >stdout 2>stderr
[ $? -eq 2 ] || fail "CAGEPROOF_PROGRESS=-1: $(cat stderr)"

# Lines come by the clock, also before the first unit of work has ended, and name the work in progress.
CAGEPROOF_PROGRESS=0.1 "$cageproof" verify --cage cube --evaluations batched --out report >stdout 2>stderr || fail "verify --cage cube: $(cat stderr)"
grep -Eq '^(measuring [0-9]+ %.*: )?[a-z].* for [0-9]+ s$' stderr || fail "no line names what is done: $(cat stderr)"
CAGEPROOF_PROGRESS=0.1 "$cageproof" verify --quiet --cage cube --evaluations batched --out report >stdout 2>stderr || fail 'verify --quiet --cage cube'
[ ! -s stderr ] || fail "verify --quiet --cage says: $(cat stderr)"

# On a terminal one line is rewritten.
if command -v script >/dev/null; then
  script -qec "'$cageproof' verify --formulas segment.winding_angle --samples 20 --out report" /dev/null >typed </dev/null || fail 'verify at a terminal'
  grep -q $'\r.*measuring 100 %' typed || fail 'no progress at a terminal'
  grep -q 'measured in' typed || fail 'a terminal is not told how long it took'
  script -qec "'$cageproof' verify --quiet --formulas segment.winding_angle --samples 20 --out report" /dev/null >typed </dev/null || fail 'verify --quiet at a terminal'
  grep -Eq 'measuring|measured' typed && fail 'verify --quiet shows progress at a terminal'
  script -qec "'$cageproof' hunt --formula triangle.solid_angle --evaluation gauss-4 --budget 200" /dev/null >typed </dev/null
  grep -q 'gauss-4 truth order 0 from' typed || fail 'hunt says nothing at a terminal'
fi
CAGEPROOF_PROGRESS=0 "$cageproof" hunt --formula triangle.solid_angle --evaluation gauss-4 --budget 200 >stdout 2>stderr || fail hunt
grep -q 'gauss-4 truth order 0 from' stderr || fail 'hunt says nothing'
CAGEPROOF_PROGRESS=0 "$cageproof" hunt --quiet --formula triangle.solid_angle --evaluation gauss-4 --budget 200 >quiet 2>stderr || fail 'hunt --quiet'
[ ! -s stderr ] && cmp -s stdout quiet || fail "hunt --quiet: $(cat stderr)"

# Results are the same; warnings and errors stay.
printf '0.1 0.2\n9 9\n' >points.csv
"$cageproof" coordinates --cage square --points points.csv --kind harmonic >a.csv 2>stderr || fail coordinates
grep -q '^solved ' stderr && grep -q ' inside, ' stderr || fail "coordinates: $(cat stderr)"
"$cageproof" coordinates --quiet --cage square --points points.csv --kind harmonic >b.csv 2>stderr || fail 'coordinates --quiet'
cmp -s a.csv b.csv || fail 'coordinates --quiet writes other numbers'
grep -v '^warning: ' stderr >other && fail "coordinates --quiet says: $(cat other)"
"$cageproof" coordinates --cage square --points points.csv --kind green >a.csv 2>stderr || fail 'coordinates outside'
grep '^warning: ' stderr >warnings || fail "no warning of a point outside: $(cat stderr)"
"$cageproof" coordinates --quiet --cage square --points points.csv --kind green >b.csv 2>stderr || fail 'coordinates --quiet outside'
cmp -s warnings stderr || fail "coordinates --quiet does not say just the warnings: $(cat stderr)"
refuses_to coordinates 'unknown kind' -- --quiet --cage square --points points.csv --kind nothing

[ $failures -eq 0 ] && echo "progress, remarks and --quiet are as they say"
exit $failures
