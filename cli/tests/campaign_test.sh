#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs that are killed, resumed, cut in shards and merged give the report of an undisturbed run: identical bytes, except the environment.
# Usage: campaign_test.sh PATH_OF_CAGEPROOF kills|ranks
set -u
# Lines of progress would be messages where a machine is slow.
export CAGEPROOF_PROGRESS=1e9
cageproof=$1
part=$2
work=$(mktemp -d)
trap 'kill -KILL $(jobs -p) 2>/dev/null; rm -rf "$work"' EXIT
cd "$work" || exit 2
failures=0

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# A small cage and few samples: all kinds of work, quickly.
cat >octahedron.obj <<'OBJ'
v 1 0 0
v -1 0 0
v 0 1 0
v 0 -1 0
v 0 0 1
v 0 0 -1
f 1 3 5
f 3 2 5
f 2 4 5
f 4 1 5
f 3 1 6
f 2 3 6
f 4 2 6
f 1 4 6
OBJ
options=(--suite quick --formulas triangle.double_layer --regimes 'near-*' --samples 16 --enclosures 0 --cage octahedron.obj)

# A report's file without the parts that may differ.
without_environment() {
  case $1 in
    */summary.json.gz) zcat "$1" | sed 's/"environment":{.*},"notes":/"notes":/' ;;
    */summary.md) sed '/^## Environment$/,$d' "$1" ;;
    *.html) sed '/^<section class="environment">$/,/^<\/section>$/d' "$1" ;;
    */journal) zcat "$1" | sed '1s/"environment":{.*$//' ;;
    *) cat "$1" ;;
  esac
}

# same A B: both folders hold the same files with the same bytes.
same() {
  diff <(cd "$1" && find . -type f | sort) <(cd "$2" && find . -type f | sort) || fail "$1 and $2 hold different files"
  local file files=0
  while read -r file; do
    files=$((files + 1))
    cmp -s <(without_environment "$1/$file") <(without_environment "$2/$file") || fail "$file differs between $1 and $2"
  done < <(cd "$1" && find . -type f)
  [ $files -gt 15 ] || fail "$1 is no report"
}

# refuses WORDS... -- COMMAND...: exit 2 and one line on standard error that holds every word.
refuses() {
  local words=() word
  while [ "$1" != -- ]; do words+=("$1"); shift; done
  shift
  "$@" >/dev/null 2>stderr </dev/null
  local code=$?
  [ $code -eq 2 ] || fail "exit $code, not 2: $*"
  [ "$(wc -l <stderr)" -eq 1 ] || fail "not one line: $* : $(cat stderr)"
  for word in "${words[@]}"; do grep -qF -- "$word" stderr || fail "no '$word' in: $(cat stderr)"; done
}

lines() { { wc -l <"$1"; } 2>/dev/null || echo 0; }

# wait_for_lines JOURNAL N: until that many units are in it; fails after a minute.
wait_for_lines() {
  local tries=0
  until [ "$(lines "$1")" -ge "$2" ]; do
    sleep 0.02
    tries=$((tries + 1))
    [ $tries -lt 3000 ] || { fail "no work in $1"; return 1; }
  done
}

"$cageproof" verify "${options[@]}" --out alone >alone.txt || fail "a run left alone: $(cat alone.txt)"

# Each field says which run it is of.
for fact in kind evaluation version seed suite; do
  for field in alone/fields/octahedron*; do
    case $field in *.cage.vtp | *.pvsm) continue ;; esac
    grep -q "<Array type=\"String\" Name=\"${fact}s*\"" "$field" || fail "$field does not say its $fact"
  done
done

kills() {
  # Killed after a while, again and again, until a process lives to the end.
  local rounds=0 command
  while [ $rounds -lt 40 ]; do
    command=("$cageproof" verify --resume killed --jobs $((1 + rounds % 3)))
    [ -e killed/journal ] || command=("$cageproof" verify "${options[@]}" --out killed)
    "${command[@]}" >killed.txt 2>&1 &
    local process=$!
    # Before the first unit, among them, and while the report is drawn.
    case $rounds in
      0) wait_for_lines killed/journal 1 ;;
      1) wait_for_lines killed/journal 4 ;;
      *) sleep 0.$((RANDOM % 90 + 10)) ;;
    esac
    [ $rounds -lt 8 ] && kill -KILL $process 2>/dev/null
    wait $process 2>/dev/null
    local code=$?
    rounds=$((rounds + 1))
    [ $code -eq 137 ] || break
    # Killed between its last rename and its end: the report is whole, and equals its copy, which says that it is drawn anew.
    if [ -e killed/summary.json.gz ]; then
      same alone killed
      cp -r killed drawn
      "$cageproof" report drawn >killed.txt
      code=$?
      break
    fi
    [ "$(ls -A killed)" = journal ] || fail "a run that died leaves $(ls -A killed)"
  done
  [ "$code" -eq 0 ] || fail "a resumed run ends with $code: $(cat killed.txt)"
  [ $rounds -gt 3 ] || fail "killed $rounds times only"
  same alone killed
  # The last run removes the files of runs that died while they drew.
  [ -z "$(find . -maxdepth 1 -name '.killed*')" ] || fail "left aside: $(ls -A)"
  diff <(head -n 1 alone.txt) <(head -n 1 killed.txt) || fail "another verdict"

  # A torn line is dropped; a finished journal gives the same report again, environment included.
  mkdir torn
  "$cageproof" verify "${options[@]}" --out torn >/dev/null &
  wait_for_lines torn/journal 6
  kill -KILL $!
  wait $! 2>/dev/null
  head -c -30 torn/journal >cut && cp cut torn/journal
  "$cageproof" verify --resume torn >/dev/null || fail "a torn line"
  same alone torn
  cp -r torn again
  "$cageproof" report again >again.txt || fail "report"
  diff -r torn again || fail "report of a finished journal is another"
  "$cageproof" compare alone again >/dev/null || fail "compare: the same run differs"

  # Rows have the roles of their evaluations, which the report does not look up.
  zcat alone/journal | grep -q '"hybrid",.*"role":"recommended"' || fail "the journal has no roles"

  # Resuming is refused with other options, shards or parts.
  cp -r alone resumed
  refuses 'samples 16, now 17' 'seed 1, now 9' -- "$cageproof" verify --resume resumed --samples 17 --seed 9
  refuses 'formulas triangle.double_layer, now triangle.*' -- "$cageproof" verify --resume resumed --formulas 'triangle.*'
  refuses 'number of shards 1, now 2' -- "$cageproof" verify --resume resumed --shard 0/2
  refuses resume out -- "$cageproof" verify --resume resumed --out resumed
  refuses nowhere 'no journal' -- "$cageproof" verify --resume nowhere
  refuses 'no journal' -- "$cageproof" verify --resume .
  zcat alone/journal | sed '1s/"version":"[^"]*"/"version":"0.0.9"/' >resumed/journal
  refuses 'version 0.0.9, now' -- "$cageproof" verify --resume resumed
  cp -r alone moved
  sed -i.bak 's/^v 1 0 0$/v 1 0 0.5/' octahedron.obj
  refuses "the cage's content" -- "$cageproof" verify --resume moved
  mv octahedron.obj.bak octahedron.obj

  # One figure that differs, and names that changed.
  zcat alone/summary.json.gz | sed 's/"without_truth":0/"without_truth":5/' >other.json
  "$cageproof" compare alone other.json >compared.txt
  [ $? -eq 1 ] || fail "compare does not exit with 1"
  grep -q 'differs: row: element triangle.double_layer.* without_truth 0 -> 5' compared.txt || fail "compare: $(tail -n 3 compared.txt)"
  # Other settings are named, whichever way is compared; the same are not mentioned.
  zcat alone/summary.json.gz | sed 's/"seed":[0-9]*/"seed":99/; s/"samples":"[0-9]*"/"samples":"7"/' >seeded.json
  for tolerance in '' '--tolerance 2x'; do
    # shellcheck disable=SC2086
    "$cageproof" compare alone seeded.json $tolerance >/dev/null 2>said
    grep -q 'other settings (samples [0-9]* -> 7; seed [0-9]* -> 99)' said || fail "compare does not name settings: $(cat said)"
  done
  "$cageproof" compare alone other.json 2>&1 >/dev/null | grep settings && fail "compare names settings that are the same"
  zcat alone/summary.json.gz | sed 's/"check":"truth"/"check":"verity"/g' >renamed.json
  "$cageproof" compare alone renamed.json >/dev/null && fail "compare finds a new name equal"
  echo '{"truth": "verity"}' >names.json
  "$cageproof" compare alone renamed.json --names names.json >compared.txt || fail "compare --names: $(tail -n 3 compared.txt)"
  "$cageproof" compare alone killed/journal >/dev/null || fail "compare with a journal"
  refuses bad.json -- "$cageproof" compare alone bad.json
}

ranks() {
  # Four ranks of one run. One is killed in the middle, without the others' knowing.
  cat >rank.sh <<'SH'
echo $$ >pid$OMPI_COMM_WORLD_RANK
exec "$@" --jobs 1 --shard $OMPI_COMM_WORLD_RANK/$OMPI_COMM_WORLD_SIZE --out part$OMPI_COMM_WORLD_RANK
SH
  mpirun --allow-run-as-root --oversubscribe --enable-recovery -n 4 bash rank.sh "$cageproof" verify "${options[@]}" >ranks.txt 2>&1 &
  local launcher=$!
  wait_for_lines part2/journal 4
  kill -KILL "$(cat pid2)" || fail "rank 2 was not there to be killed"
  wait $launcher
  [ -n "$(ls part2)" ] && [ "$(ls part2)" = journal ] || fail "part2 holds $(ls part2)"
  refuses 'part2: shard 2/4 is not finished' '--resume part2' -- "$cageproof" merge part0 part1 part2 part3 --out merged
  # Where the launcher ended the other ranks too, they go on as well.
  for rank in 0 1 2 3; do
    "$cageproof" verify --resume part$rank --jobs 2 >resumed.txt || fail "rank $rank: $(cat resumed.txt)"
    grep -q "shard $rank/4: all .* units" resumed.txt || fail "rank $rank: $(cat resumed.txt)"
  done
  "$cageproof" merge part3 part0 part2 part1 --out merged >merged.txt 2>stderr || fail "merge: $(cat merged.txt stderr)"
  [ ! -s stderr ] || fail "merge complains: $(cat stderr)"
  same alone merged
  diff <(head -n 1 alone.txt) <(head -n 1 merged.txt) || fail "another verdict"

  refuses 'missing: shard 1/4, 3/4' -- "$cageproof" merge part0 part2 --out other
  refuses 'part0 and part0 are both shard 0/4' -- "$cageproof" merge part0 part1 part0 part2 part3 --out other
  refuses 'part0: shard 0/4 of a run' -- "$cageproof" report part0
  refuses 'shard 0/4, now 1/4' -- "$cageproof" verify --resume part0 --shard 1/4
  refuses 'holds a shard of a run' -- "$cageproof" merge part0 part1 part2 part3 --out part0
  refuses 'holds a shard of a run' -- "$cageproof" verify "${options[@]}" --out part0
  refuses 'holds shard 0/4' -- "$cageproof" verify "${options[@]}" --shard 1/4 --out part0
  refuses 'I/N' -- "$cageproof" verify "${options[@]}" --shard 4/4 --out other
  refuses 'I/N' -- "$cageproof" verify "${options[@]}" --shard 1 --out other
  [ ! -e other ] || fail "left something behind"
  sed '1s/"seed":"1"/"seed":"2"/' part1/journal >changed && mkdir other && mv changed other/journal
  refuses 'part0 and other are of different runs: seed 1, now 2' -- "$cageproof" merge part0 other part2 part3 --out merged2

  # A shard from a processor with other logarithms; glibc's tunables stand in for it.
  export GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2
  "$cageproof" verify "${options[@]}" --shard 1/4 --out plain >/dev/null || fail "a shard without FMA"
  unset GLIBC_TUNABLES
  picked() { grep -o '"elementary functions":"[^"]*"' "$1/journal"; }
  if [ "$(picked plain)" = "$(picked part1)" ]; then
    echo "this processor has one variant of the elementary functions only: nothing to tell apart"
  else
    "$cageproof" merge part0 plain part2 part3 --out mixed >/dev/null 2>stderr
    grep -q '2 different elementary functions' stderr || fail "merge does not say that processors differ: $(cat stderr)"
    for file in summary.json.gz summary.md index.html; do
      zgrep -q '2 different elementary functions' mixed/$file || fail "$file does not say that processors differ"
    done
  fi
}

$part
[ $failures -eq 0 ] && echo "$part: all as it should be"
exit $failures
