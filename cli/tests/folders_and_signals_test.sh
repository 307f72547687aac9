#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# No command replaces files of others, and no signal leaves half of anything. Usage: folders_and_signals_test.sh PATH_OF_CAGEPROOF
. "$(dirname "$0")/support.sh"

# Everything in a folder, with contents.
state_of() { (cd "$1" && find . -type f -print0 | sort -z | xargs -0 sha256sum; find . -printf '%p %y %l\n' | sort); }
names_in() { (cd "$1" && find . -type f | sort); }
# A field's files, and the contents of those without times and command lines.
field_in() { (names_in "$1" && cd "$1" && sha256sum fields/* results.csv.gz worst.jsonl); }
verify() { "$cageproof" verify --suite quick --formulas segment.winding_angle --regimes far "$@"; }
field() { "$cageproof" field --formula triangle.single_layer --evaluation gauss-4 --resolution 4 "$@"; }
bench() { "$cageproof" bench --formula segment.winding_angle --regime far --evaluations closed_form --samples 1 --seconds 0 "$@"; }
figures() { "$cageproof" figures "$@"; }

# keeps WORD FOLDER COMMAND...: refuses with that word, and leaves the folder as it was.
keeps() {
  local word=$1 folder=$2 before
  shift 2
  before=$(state_of "$folder")
  "$@" >stdout 2>stderr
  [ $? -eq 2 ] || fail "not refused: $* ($folder)"
  [ "$(wc -l <stderr)" -eq 1 ] && grep -qF -- "$word" stderr || fail "no '$word' of $*: $(cat stderr)"
  [ "$(state_of "$folder")" = "$before" ] || fail "$* changed $folder"
  [ -z "$(find . -maxdepth 1 -name '.*.partial-*')" ] || fail "$* left $(ls -A)"
}

verify --out report >/dev/null || fail verify
verify --shard 0/2 --out shard >/dev/null || fail shard
field --out field >/dev/null || fail field
bench --out bench >/dev/null || fail bench
mkdir -p begun && cp report/journal begun/
mkdir -p own/fields own/pictures && echo mine >own/fields/a.vti
mkdir -p named && echo '{"schema":"other"}' >named/summary.json
mkdir -p 'of a user' && cp -r report/. 'of a user' && echo notes >'of a user/notes.txt'

# Folders of other kinds.
for folder in report shard begun bench; do keeps 'does not replace' $folder field --out $folder; done
for folder in report shard begun field; do keeps 'does not replace' $folder bench --out $folder; done
for folder in report shard begun field bench; do keeps 'does not replace' $folder figures --out $folder; done
for folder in shard field bench; do keeps 'does not replace' $folder verify --out $folder; done
keeps 'does not replace' report verify --shard 0/2 --out report
keeps 'shard 0/2' shard verify --shard 1/2 --out shard
verify --shard 1/2 --out other >/dev/null || fail 'the other shard'
keeps 'does not replace' field "$cageproof" merge shard other --out field
# Folders of no kind, and of a kind with something of somebody's in it.
for command in verify field bench figures; do
  for folder in own named; do keeps "$folder" $folder $command --out $folder; done
  [ $command = verify ] && word=notes.txt || word='does not replace'
  keeps "$word" 'of a user' $command --out 'of a user'
done
for place in fields/mine.vti pictures/mine.png fields/deeper/mine.vti mine.txt; do
  rm -rf mixed && cp -r report mixed && mkdir -p "mixed/$(dirname $place)" && echo mine >mixed/$place
  keeps "'${place%%/mine.*}" mixed "$cageproof" report mixed
  [ $place = mine.txt ] || grep -qF 'did not write' stderr || fail "$place: $(cat stderr)"
done
cp -r field linked && ln -s ../own linked/fields/own
keeps fields/own linked field --out linked
rm -rf linked && cp -r report linked && rm -r linked/fields && ln -s ../own linked/fields
keeps fields linked "$cageproof" report linked
# A run that begins in a folder that holds more must not either.
rm -rf mixed && cp -r report mixed && echo mine >mixed/fields/mine.vti
keeps mine mixed verify --out mixed
# Files and links in the way, folders that are not there or cannot be written.
echo mine >plain
for command in verify field bench figures; do
  $command --out plain >stdout 2>stderr && fail "$command over a file"
  [ "$(cat plain)" = mine ] || fail "$command replaces a file"
  $command --out nowhere/out >stdout 2>stderr && fail "$command in no folder"
  grep -qF nowhere stderr || fail "$command in no folder: $(cat stderr)"
done
ln -s own link && keeps own own field --out link
ln -s nothing dangling
field --out dangling >stdout 2>stderr && [ ! -d nothing ] && fail 'a field nowhere'
[ -L dangling ] || fail 'a link is replaced'
grep -qF 'a link to nothing, which does not exist' stderr || fail "a link to nothing: $(cat stderr)"
# A file's link stays and is followed, if need be to a file that is not there yet; a pipe is written to.
printf '0.1 0.1 0.1\n' >linked_point.txt
coordinates() { "$cageproof" coordinates --cage cube --points linked_point.txt --kind green "$@"; }
mkdir elsewhere && ln -s elsewhere/table.csv table.csv && coordinates --out table.csv 2>/dev/null || fail 'coordinates through a link'
[ -L table.csv ] && [ -s elsewhere/table.csv ] && [ -s table.json ] || fail 'a link to a file is replaced'
"$cageproof" man --out /dev/stdout | cat | grep -q '^.TH CAGEPROOF' || fail 'a manual on standard output'
{ echo before; "$cageproof" man --out /dev/stdout; echo behind; } >log
[ "$(sed -n 1p log; tail -n 1 log)" = $'before\nbehind' ] && grep -q '^.TH CAGEPROOF' log || fail 'a manual amid a log'
[ -z "$(find elsewhere -name '.*.partial-*')" ] || fail 'left beside what a link leads to'
ln -s round.csv round.csv
coordinates --out round.csv >stdout 2>stderr && fail 'a link to itself'
[ -L round.csv ] && grep -q 'Too many levels' stderr || fail "a link to itself: $(cat stderr)"
ln -s same.csv same.json
coordinates --out same.csv >stdout 2>stderr && fail 'two results in one file'
[ ! -e same.csv ] && grep -q 'same file' stderr || fail "two results in one file: $(cat stderr)"
# A folder that is replaced never holds the input.
mkdir holds && cp linked_point.txt holds/points.txt
for command in bench verify; do
  $command --out holds --points holds/points.txt >stdout 2>stderr && fail "$command over its points"
done
"$cageproof" field --kind green --cage cube --compare gauss-4,closed_form --resolution 2 --points holds/points.txt \
  --out ./holds/ >stdout 2>stderr && fail 'field over its points'
grep -q 'which --points reads' stderr && [ -s holds/points.txt ] || fail "field over its points: $(cat stderr)"
mkfifo pipe.jsonl
timeout 20 "$cageproof" hunt --formula triangle.solid_angle --budget 10 --out pipe.jsonl >stdout 2>stderr
[ $? -eq 2 ] && grep -q 'not a file of worst cases, to which others can be added' stderr || fail "hunt into a pipe: $(cat stderr)"
mkdir folder.obj
"$cageproof" deform --cage cube --posed cube --points linked_point.txt --method green --out folder.obj >stdout 2>stderr && fail 'deform into a folder'
grep -q 'cannot write folder.obj' stderr || fail "deform into a folder: $(cat stderr)"
"$cageproof" list nonsense 2>/dev/full
[ $? -eq 2 ] || fail 'a full standard error'
coordinates --out nowhere/table.csv >stdout 2>stderr && fail 'coordinates in no folder'
timeout 60 "$cageproof" hunt --formula triangle.solid_angle --budget 1000000000 --out nowhere/worst.jsonl >>stdout 2>>stderr && fail 'hunt in no folder'
[ "$(grep -c 'folder nowhere does not exist' stderr)" -eq 2 ] || fail "files in no folder: $(cat stderr)"
"$cageproof" list >/dev/full 2>stderr && fail 'a full disk'
grep -q 'cannot write to standard output: No space left on device' stderr || fail "a full disk: $(cat stderr)"
"$cageproof" coordinates --cage cube --points cube --kind green --out report >stdout 2>stderr && fail 'coordinates over a folder'
mkdir a.csv
printf '0.1 0.1 0.1\n' >point.txt
"$cageproof" coordinates --cage cube --points point.txt --kind green --out a.csv >stdout 2>stderr && fail 'coordinates over a folder'
[ -d a.csv ] || fail 'a folder is replaced by a file'

# A command replaces its own earlier output.
for n in 1 2; do
  verify --out report >/dev/null || fail "verify again $n"
  "$cageproof" report report >/dev/null || fail "report again $n"
  field --out field >/dev/null || fail "field again $n"
  bench --out bench >/dev/null || fail "bench again $n"
done
ln -s field to_field && field --out to_field >/dev/null || fail 'field through a link'
[ -L to_field ] && [ -e field/summary.json.gz ] || fail 'a link to a field is replaced'
verify --out begun >/dev/null || fail 'verify over a run that was begun'
# As versions without a list left it.
rm report/.cageproof-files && "$cageproof" report report >/dev/null || fail 'report over one without a list'
[ -e report/.cageproof-files ] || fail 'no list'

# Signals: their exit code, nothing aside, earlier files unchanged, and a run that can be resumed.
# A hundred units in a second or two, whatever they measure: the run is made anew seventeen times.
options=(--suite quick --formulas segment.single_layer,segment.winding_angle --evaluations closed_form,hybrid --cage square --samples 40)
"$cageproof" verify "${options[@]}" --out whole >/dev/null || fail 'a whole run'
mkdir scratch && export TMPDIR=$work/scratch
number=0 drawn=0 stopped=0
for signal in INT TERM HUP; do
  # At some times, as soon as something was measured, and while the report is drawn.
  for delay in 0.1 0.6 measured drawn; do
    number=$((number + 1))
    rm -rf run
    # A shell starts background jobs with SIGINT ignored; this does not.
    /usr/bin/python3 -c 'import os, signal, sys; signal.signal(signal.SIGINT, signal.SIG_DFL); os.execv(sys.argv[1], sys.argv[1:])' \
      "$cageproof" verify "${options[@]}" --out run >out.txt 2>err.txt &
    process=$!
    if [ $delay = drawn ]; then
      while kill -0 $process 2>/dev/null && [ -z "$(find . -maxdepth 1 -name '.run.partial-*')" ]; do sleep 0.01; done
      sleep 0.0$((number % 10))
    elif [ $delay = measured ]; then
      # The journal begins with the run's options, and grows with its findings.
      begun=0
      while kill -0 $process 2>/dev/null; do
        size=$(stat -c %s run/journal 2>/dev/null || echo 0)
        [ $begun -eq 0 ] && begun=$size
        [ "$size" -gt "$begun" ] && break
        sleep 0.01
      done
    else
      sleep $delay
    fi
    kill -$signal $process 2>/dev/null
    wait $process 2>/dev/null
    code=$?
    case $signal in INT) expected=130 ;; TERM) expected=143 ;; HUP) expected=129 ;; esac
    [ $delay = drawn ] && [ $code -eq $expected ] && drawn=$((drawn + 1))
    [ $code -eq $expected ] || [ $code -eq 0 ] || fail "SIG$signal after $delay s: exit $code, not $expected: $(cat err.txt)"
    [ -z "$(find . -name '.*.partial-*')" ] || fail "SIG$signal after $delay s leaves $(find . -name '.*.partial-*')"
    [ ! -s err.txt ] || fail "SIG$signal complains: $(cat err.txt)"
    if [ $code -eq $expected ] && [ -e run ]; then
      # A signal between the report's last rename and the exit finds a whole report; any earlier one only the journal.
      [ "$(ls -A run)" = journal ] || [ "$(names_in run)" = "$(names_in whole)" ] || fail "SIG$signal leaves $(ls -A run)"
      if [ "$(ls -A run)" = journal ]; then
        # The run may have measured everything already; then it compares equal.
        if "$cageproof" compare whole run >/dev/null 2>warning.txt; then
          [ ! -s warning.txt ] || fail "compare finds a stopped run whole: $(cat warning.txt)"
        else
          stopped=$((stopped + 1))
          grep -q '^warning: run: the run is not finished, [0-9]* of .*verify --resume run' warning.txt || fail "compare says nothing of a stopped run: $(cat warning.txt)"
        fi
      fi
      "$cageproof" verify --resume run >/dev/null || fail "resume after SIG$signal"
      "$cageproof" compare whole run >/dev/null || fail "another result after SIG$signal"
    fi
  done
done
[ $stopped -gt 0 ] || fail 'no signal came while the run measured'
[ $drawn -gt 0 ] || fail 'no signal came while the report was drawn'
# An earlier report stays as it was, whenever the signal comes.
before=$(state_of field)
field_of_somigliana=(field --kind somigliana --cage cube --evaluation gauss-8 --resolution 12)
"$cageproof" "${field_of_somigliana[@]}" --out whole_field >/dev/null || fail 'a whole field'
for delay in 0.02 0.05 0.1 0.13 0.16 0.19 0.22 0.25 0.28 0.31 0.35 0.4; do
  "$cageproof" "${field_of_somigliana[@]}" --out slow >/dev/null 2>&1 &
  process=$!
  sleep $delay
  kill -TERM $process 2>/dev/null
  wait $process
  code=$?
  [ $code -eq 143 ] || [ $code -eq 0 ] || fail "SIGTERM of field: $code"
  # A field appears by one rename, so that it is whole, whatever the exit code.
  [ ! -e slow ] || [ "$(field_in slow 2>&1)" = "$(field_in whole_field)" ] || fail "half a field: $(ls -A slow)"
  rm -rf slow
  [ -z "$(find . -name '.*.partial-*')" ] || fail "field leaves $(find . -name '.*.partial-*')"
done
[ "$(state_of field)" = "$before" ] || fail 'an earlier field changed'
# nohup's signal is ignored.
(trap '' HUP; exec "$cageproof" verify "${options[@]}" --out quiet >/dev/null 2>&1) &
process=$!
sleep 0.5
kill -HUP $process
wait $process || fail 'an ignored SIGHUP ends a run'
# Nobody reads: the program ends by the signal, without a word and with nothing aside.
set -o pipefail
"$cageproof" list 2>stderr | head -n 1 >/dev/null
"$cageproof" bench --formula segment.winding_angle --regime '*' --samples 1 --seconds 0 --out piped 2>>stderr | true
# The line that names written files is not about the pipe.
sed -i '/^written to piped: /d' stderr
[ ! -s stderr ] || fail "a closed pipe: $(cat stderr)"
[ -z "$(find . -name '.*.partial-*')" ] || fail "a closed pipe leaves $(find . -name '.*.partial-*')"

# The next start removes the files of killed processes; those of living processes stay.
"$cageproof" field --kind somigliana --cage cube --evaluation gauss-8 --resolution 200 --out killed >/dev/null 2>&1 &
process=$!
for _ in $(seq 100); do [ -n "$(find . -name '.killed.partial-*')" ] && break; sleep 0.05; done
living=$(find . -name '.killed.partial-*')
field --out killed >/dev/null || fail 'field beside a living one'
[ -n "$living" ] && [ -e "$living" ] || fail 'what a living process writes is removed'
kill -KILL $process
wait $process 2>/dev/null
[ -e "$living" ] || fail 'SIGKILL left nothing to remove'
field --out killed >/dev/null || fail 'field after a killed one'
[ -z "$(find . -name '.killed.partial-*')" ] || fail "leftovers stay: $(find . -name '.killed.partial-*')"
[ -z "$(ls -A scratch)" ] || fail "left in TMPDIR: $(ls -A scratch)"

[ $failures -eq 0 ] && echo "nothing is replaced or left that should not be"
exit $failures
