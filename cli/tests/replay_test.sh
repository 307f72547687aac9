#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A stored case is run again as it was stored, or refused: its cage, its members and its words.
# Usage: replay_test.sh PATH_OF_CAGEPROOF
. "$(dirname "$0")/support.sh"
export CAGEPROOF_TRUTH_CACHE=off

tetrahedron=('v 0 0 0' 'v 1 0 0' 'v 0 1 0' 'v 0 0 1' 'f 1 3 2' 'f 1 2 4' 'f 2 3 4' 'f 1 4 3')
mkdir -p project/runs elsewhere
printf '%s\n' "${tetrahedron[@]}" >project/own.obj
(cd project && "$cageproof" verify --suite quick --formulas triangle.double_layer --regimes far --cage own.obj --out runs/report >/dev/null) || fail "verify"
packed=project/runs/report/worst/cage.own.obj.jsonl.gz
zcat "$packed" | grep '"regime":"own.obj"' | head -n 1 >project/runs/report/one.jsonl
replays() { "$cageproof" replay "$@" >stdout 2>stderr || fail "replay $*: $(cat stderr)"; }

# The cage is looked for from here, and from the report's folder and those above it.
(cd project && "$cageproof" replay runs/report/one.jsonl >/dev/null) || fail "replay from the folder of the run"
replays "$packed"
replays "${packed%.gz}"
grep -q ' 0 changed since stored$' stdout || fail "figures of a cage that is found from elsewhere: $(tail -n 2 stdout)"
cp -r project/runs/report elsewhere/report
refuses_to replay one.jsonl:1 "own.obj: no such file; looked for own.obj, " "$work/elsewhere/report/own.obj" "$work/elsewhere/own.obj" -- elsewhere/report/one.jsonl
cp project/own.obj elsewhere/report/own.obj
replays elsewhere/report/one.jsonl

# A cage that has changed is not the stored one; another of its name in the current folder is passed over.
sed 's/^v 1 0 0$/v 1.5 0 0/' project/own.obj >own.obj
replays project/runs/report/one.jsonl
cp own.obj elsewhere/report/own.obj
refuses_to replay one.jsonl:1 "own.obj, $work/elsewhere/report/own.obj: the cage has changed since the case was stored" -- elsewhere/report/one.jsonl
# Files of earlier programs do not state the cage's contents.
sed 's/,"cage_content":"[^"]*"//' elsewhere/report/one.jsonl >elsewhere/report/older.jsonl
cmp -s elsewhere/report/one.jsonl elsewhere/report/older.jsonl && fail "no content of the cage is stored"
replays elsewhere/report/older.jsonl

# Members and their values.
cd project || exit 2
changed() { sed "$1" runs/report/one.jsonl >changed.jsonl; }
changed 's/"frame":/"fram":/; t; s/{/{"fram":{"unit":1,"shift":[0,0,0]},/'
refuses_to replay changed.jsonl:1 'unknown key "fram"; did you mean "frame"? known: kind, evaluation' -- changed.jsonl
changed 's/"unit":"[^"]*"/"unit":"metres"/'
refuses_to replay changed.jsonl:1 "unknown unit 'metres'" "are in '" -- changed.jsonl
changed 's/"triangulation":"shortest"/"triangulation":"fann"/'
refuses_to replay changed.jsonl:1 "unknown triangulation 'fann'" "'fan'" -- changed.jsonl
changed 's/"place":"[^"]*"/"place":"insid"/'
refuses_to replay changed.jsonl:1 "unknown place 'insid'" "known: " inside -- changed.jsonl
zcat runs/report/worst/triangle.double_layer.jsonl.gz | head -n 1 >element.jsonl
replays element.jsonl
sed 's/"place":""/"place":"inside"/' element.jsonl >changed.jsonl
refuses_to replay changed.jsonl:1 "unknown place 'inside'" -- changed.jsonl
sed 's/"unit":"[^"]*"/"unit":"metres"/' element.jsonl >changed.jsonl
refuses_to replay changed.jsonl:1 "unknown unit 'metres'" -- changed.jsonl
cd ..

[ $failures -eq 0 ] && echo "stored cases run as they were stored"
exit $failures
