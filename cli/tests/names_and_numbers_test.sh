#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Names, globs and lists have one grammar, numbers one form, and every refusal names a correct input.
# Usage: names_and_numbers_test.sh PATH_OF_CAGEPROOF
. "$(dirname "$0")/support.sh"

# Commands and options.
refuses_to frobnicate "unknown command 'frobnicate'" 'known: list, eval' --
refuses_to verfy "did you mean 'verify'?" --
refuses_to --jobs "stands behind its command" -- 2 verify
refuses_to --versoin "did you mean '--version'?" --
refuses_to eval "'--formla'" "did you mean '--formula'?" 'cageproof eval --help' -- --formla triangle.single_layer --evaluation closed_form
refuses_to list "'triangle.*'" -- '*.single_layer' 'triangle.*'
refuses_to report 'folder is required' --
for command in eval explain coordinates deform merge report compare field replay hunt bench completion; do refuses_to $command "cageproof $command --help" --; done
for command in list eval explain coordinates deform verify merge report compare field figures replay hunt bench man completion; do
  "$cageproof" $command --help >stdout 2>stderr || fail "$command --help"
  [ ! -s stderr ] && grep -q Usage stdout || fail "$command --help: $(cat stderr)"
done

# Refusals of names say which may have been meant.
verify() { "$cageproof" verify "$@"; }
refuses_to verify "unknown formula 'triangle.solid_angel'" "did you mean 'triangle.solid_angle'?" -- --formulas triangle.solid_angel
refuses_to verify "unknown regime 'fra'" "did you mean 'far'?" -- --regimes 'near-*,fra'
refuses_to verify "no regime matches 'nera-*'" -- --regimes 'far,nera-*'
refuses_to verify "did you mean 'closed_form'?" -- --evaluations gauss-8,closed_frm
refuses_to verify "'near-*,,far' is no list" -- --regimes 'near-*,,far'
refuses_to verify "no list" -- --regimes ' '
refuses_to verify "'' is empty" -- --regimes ''
refuses_to deform "did you mean '--method'?" -- --kind green
refuses_to coordinates "did you mean '--kind'?" -- --method green
refuses_to verify "no formula of 'triangle.*' has an evaluation 'line_form': quad.mean_value has" -- --formulas 'triangle.*' --evaluations closed_form,line_form
refuses_to verify 'of gauss-<N>, N from 1 to 256, verification runs gauss-4, gauss-8, gauss-16' -- --evaluations closed_form,gauss-999
refuses_to verify 'of tessellated-<n>, n from 1 to 512, verification runs tessellated-5' -- --evaluations tessellated-3000
refuses_to verify "did you mean 'quick'?" 'quick, standard, full' -- --suite quik
refuses_to eval "did you mean 'triangle.solid_angle'?" -- --formula solid_angle --evaluation closed_form
refuses_to eval 'gauss-<N> takes N from 1 to 256' -- --formula triangle.single_layer --evaluation gauss-300
refuses_to eval 'near-singular-<N> takes N from 2 to 64' -- --formula triangle.single_layer --evaluation near-singular-1
refuses_to eval 'P = 3 n^2' -- --formula triangle.single_layer --evaluation three-quad-76
refuses_to eval 'riemann-<n> takes n from 1 to 512' -- --formula quad.mean_value --evaluation riemann-600
refuses_to eval 'riemann-<n>-unguarded takes n from 1 to 512' -- --formula quad.mean_value --evaluation riemann-600-unguarded
refuses_to eval 'line-<digits> takes digits from 2 to 90' -- --formula quad.mean_value --evaluation line-1
refuses_to eval 'one name' glob -- --formula triangle.single_layer --evaluation 'gauss-*'
refuses_to eval 'one name' list -- --formula triangle.single_layer --evaluation gauss-4,gauss-8
refuses_to eval "did you mean 'double'?" -- --formula triangle.single_layer --evaluation closed_form --scalar doubel
refuses_to coordinates "did you mean 'green'?" -- --cage cube --points none.csv --kind gren
refuses_to coordinates "did you mean 'cube'?" -- --cage cueb --points none.csv --kind green
refuses_to deform "did you mean 'green'?" -- --cage cube --posed cube --points none.csv --method gren --out out.obj
refuses_to hunt "did you mean 'truth'?" -- --formula triangle.solid_angle --evaluation closed_form --check trth --budget 10
refuses_to bench "did you mean 'near-face'?" -- --formula triangle.solid_angle --regime near-fce
refuses_to bench 'gauss-<N> takes N from 1 to 256' -- --formula triangle.solid_angle --evaluations gauss-300,closed_form
refuses_to bench 'derivatives of order 1' -- --formula quad.mean_value --evaluations 'riemann-*' --order 1
refuses_to list "did you mean 'near-face'?" -- near-fac
write() { printf '%s\n' "${@:2}" >"$1"; }
refuses_to verify "no formula of 'triangle.solid_angle' has an evaluation 'batched'" -- --formulas triangle.solid_angle --evaluations batched
# A cage that no formula asked for is summed on would not be verified.
refuses_to verify "cube: no coordinates on it sum a formula of 'segment.single_layer'" 'quad.double_layer' "or leave out --cage" -- \
  --cage cube --formulas segment.single_layer
refuses_to verify "square: no coordinates on it sum a formula of 'triangle.*'" 'segment.double_layer' -- --cage square --formulas 'triangle.*'
write one.csv '0.1 0.2 0.3'
write flat.csv '0.1 0.2'
refuses_to coordinates 'harmonic, which is made of other coordinates' "'bached'" -- --cage square --points flat.csv --kind harmonic --evaluation bached
refuses_to coordinates "green has no evaluation 'bached'" "did you mean 'batched'?" -- \
  --cage cube --points one.csv --kind green --evaluation bached --out out.csv
refuses_to field "green has no evaluation 'bached'" "did you mean 'batched'?" -- --cage cube --kind green --evaluation bached --out out
refuses_to eval "quad.double_layer has no evaluation 'hybrid'; 'line_form' is recommended" -- --formula quad.double_layer --evaluation hybrid
refuses_to coordinates 'gauss-<N> takes N from 1 to 256' -- --cage cube --points one.csv --kind green --evaluation gauss-999
refuses_to bench "green has no evaluation 'bached'" "did you mean 'batched'?" -- --kind green --evaluations gauss-4,bached
for option in out solved data; do refuses_to coordinates "--$option: '' is empty" -- --cage cube --points one.csv --kind green --$option ''; done
for command in bench hunt; do refuses_to $command "--out: '' is empty" -- --formula triangle.solid_angle --out ''; done
refuses_to coordinates "did you mean 'nu'" -- --cage cube --points one.csv --kind somigliana --parameter un=0.3
"$cageproof" list 'near-*,*.solid_angle' >stdout || fail 'list of globs'
[ "$(grep -c '^[a-z]*\.[a-z_]*$' stdout)" -eq "$(grep -c '^[a-z]*\.solid_angle$' stdout)" ] && grep -qx triangle.solid_angle stdout && grep -q '^regimes: near-face near-plane near-edge near-line near-vertex$' stdout || fail "list of globs: $(cat stdout)"
"$cageproof" list 'closed_f*,batched' >stdout || fail 'list of evaluations'
grep -q '^evaluation closed_form of: .*triangle.single_layer' stdout && grep -q '^evaluation batched of: .*green' stdout ||
  fail "list of evaluations: $(cat stdout)"
"$cageproof" list closed_form,gauss-9 >stdout || fail 'list of a rule with a number'
grep -q '^evaluation gauss-<N>, N from 1 to 256 of: ' stdout && grep -q '^evaluation closed_form of: .*quad.mean_value' stdout ||
  fail "list of a rule with a number, and of an alias: $(cat stdout)"
"$cageproof" list --json | grep -q '"range": "N from 1 to 256"' || fail 'list --json does not say the range of gauss-<N>'

# The same lists mean the same everywhere.
bench() { "$cageproof" bench --samples 2 --seconds 0 --csv "$@"; }
bench --formula triangle.solid_angle --regime 'near-f*,far' --evaluations 'gauss-4,clos*' >a.csv || fail 'bench of lists'
bench --formula triangle.solid_angle --regimes near-face --regimes far --evaluations gauss-4 --evaluation closed_form >b.csv || fail 'bench of repeated options'
[ "$(cut -d, -f 3-14 a.csv)" = "$(cut -d, -f 3-14 b.csv)" ] && [ "$(wc -l <a.csv)" -eq 5 ] || fail "lists differ from repeated options: $(cat a.csv b.csv)"
verify --suite quick --formulas 'triangle.solid_*,segment.winding_angle' --regimes near-face,far --evaluations 'gauss-8,clos*' --samples 1e1 --out run >stdout ||
  fail "verify of lists: $(cat stdout)"
subjects=$(zcat run/results.csv.gz | cut -d, -f 2 | sort -u)
for name in triangle.solid_angle segment.winding_angle; do grep -qx $name <<<"$subjects" || fail "verify of lists leaves out $name"; done
grep -qx triangle.single_layer <<<"$subjects" && fail 'verify of lists has what was not asked for'
"$cageproof" hunt --formula triangle.solid_angle --evaluation 'gauss-4,clos*' --check 'tr*' --budget 2e1 --regime 'near-*,far' >stdout 2>/dev/null || fail 'hunt of lists'
[ "$(wc -l <stdout)" -eq 2 ] || fail "hunt of lists: $(cat stdout)"

# Evaluations that lack the order are left out of a default with a word.
bench --formula quad.mean_value --regime near-face --order 1 >stdout || fail "bench --order 1: $(cat stdout)"
"$cageproof" bench --samples 2 --seconds 0 --formula quad.mean_value --regime near-face --order 1 | grep -q 'left out.*order 1.*riemann' || fail 'nothing says what is left out'
# Evaluations that compute all coordinates at once are compared with sums.
"$cageproof" bench --kind green --cage cube --evaluations 'gauss-4,bat*' --samples 2 --seconds 0 --csv >whole.csv || fail 'bench of a kind by batched'
[ "$(cut -d, -f 5 whole.csv | tail -n +2 | sort -u | tr '\n' ' ')" = 'batched gauss-4 ' ] || fail "bench of a kind by batched: $(cat whole.csv)"
# Rules have nodes, and say how many.
bench --formula quad.mean_value --regime near-face --evaluations riemann-4,tessellated-5,gauss-8,line-12,adaptive >nodes.csv || fail 'bench of rules'
awk -F, 'NR > 1 && !($14 > 0) || $5 == "riemann-4" && $14 != 81 || $5 == "tessellated-5" && $14 != 50 || $5 == "gauss-8" && $14 != 64 { exit 1 }' nodes.csv ||
  fail "nodes: $(cut -d, -f 5,14 nodes.csv)"
"$cageproof" bench --coordinates --cage cube --samples 1 --seconds 0 --evaluations riemann-4 --csv | grep -qF ',1,81,' || fail 'nodes of whole coordinates'
# Times are compared with the first column of [T18] Table 1, in turns: a grid of 21 x 21 samples takes longer than two triangles on any machine.
"$cageproof" bench --coordinates --cage cube --samples 1 --seconds 0 --evaluations riemann-10 >whole.txt || fail 'bench of whole coordinates'
times=$(sed -n 's/^quad_mean_value, riemann-10: [0-9]* ms for the mesh, \([0-9.e+]*\) times as long as mean_value, published$/\1/p' whole.txt)
awk -v times="$times" 'BEGIN { exit !(times > 1.5 && times < 100) }' || fail "times of the first column: $(cat whole.txt)"

# One name where one is asked for, and no word that would be taken for something else.
refuses_to eval 'one name is asked for here, no glob' -- --formula 'triangle.*' --evaluation closed_form
refuses_to coordinates 'one name is asked for here, no list' -- --cage cube --points one.csv --kind green,mean_value
refuses_to deform 'one name is asked for here, no glob' -- --cage cube --posed cube --points one.csv --method 'gr*' --out out.obj
refuses_to man "unexpected 'verify'" -- verify
refuses_to list "unknown name 'figures'" -- figures
refuses_to coordinates "unexpected 'list'" -- --cage cube --points one.csv --kind green list
refuses_to man "--out: '' is empty" -- --out= --markdown
refuses_to man '--markdown takes no value' -- --markdown=xx
refuses_to bench 'excludes' -- --coordinates --cage cube --order 1
refuses_to bench "unexpected 'far'" -- --formula triangle.solid_angle --regime generic far
refuses_to hunt "'hull'" 'only `verify` has it' -- --formula triangle.solid_angle --budget 10 --regime hull
refuses_to field --colours 'takes 2 values: it was given 1' -- --kind green --cage cube --out out --colours 1
refuses_to field "green has no evaluation 'gau'" -- --kind green --cage cube --out out --compare gau
refuses_to field "no evaluation of green matches 'nosuch-*'" -- --kind green --cage cube --out out --compare 'nosuch-*'
refuses_to field '2 to 4 are compared' -- --kind green --cage cube --out out --compare 'near-sing*'

# Numbers, and how often.
refuses_to verify '--samples takes one value, once' -- --samples 3 --samples 4
refuses_to verify '--samples needs a value' -- --samples
for bad in nan inf -inf 0x10 '' ' ' -3 3k 1.5 1e99 0 1e400 ++3 +-3 1,000 '1 2'; do
  refuses_to verify --samples "'$bad' is not a whole number from 1 to 100000000" -- --samples "$bad"
done
for bad in -1 99999999999999999999999 18446744073709551616 1.5 nan ' ' seed 0x1; do
  refuses_to verify --seed 'from 0 to 2^64 - 1' -- "--seed=$bad"
  refuses_to hunt --seed 'from 0 to 2^64 - 1' -- --formula triangle.solid_angle --budget 10 "--seed=$bad"
  refuses_to bench --seed 'from 0 to 2^64 - 1' -- --formula triangle.solid_angle "--seed=$bad"
done
for bad in nan inf 1h -1 4e3 ' '; do refuses_to bench --seconds 'a finite number from 0 to 3600' -- --formula triangle.solid_angle "--seconds=$bad"; done
for command in coordinates deform verify field figures hunt bench; do refuses_to $command --jobs 'from 0 to 1024' -- --jobs 2000; done
refuses_to eval --order 'from 0 to 2' -- --formula triangle.single_layer --evaluation closed_form --order 3
refuses_to hunt --budget 'from 1 to 1000000000' -- --formula triangle.solid_angle --budget 0
refuses_to field --resolution 'from 2 to 4096' -- --formula triangle.single_layer --evaluation gauss-4 --resolution 1e9 --out out
for shard in 2/2 -1/2 1 1/2x a/b 1.5/2; do refuses_to verify "--shard $shard" -- --shard=$shard; done
refuses_to verify --seed 'from 0 to 2^64 - 1' -- --seed ''
far() { "$cageproof" bench --formula triangle.solid_angle --regime far --evaluations gauss-4 --seconds 0 --csv "$@"; }
far --samples 2e0 --seed 18446744073709551615 >a.csv || fail 'a seed of 2^64 - 1'
far --samples +2 --seed 1e3 >a.csv || fail '1e3'
far --samples 2 --seed 1000 >b.csv || fail '1000'
[ "$(cut -d, -f 1-14 a.csv)" = "$(cut -d, -f 1-14 b.csv)" ] || fail '1e3 is not 1000'

# A session records the threads and the commit that were used.
"$cageproof" verify --suite quick --formulas segment.winding_angle --regimes far --jobs 1 --out one >/dev/null || fail 'verify --jobs 1'
zgrep -qF '"threads":"1"' one/summary.json.gz || fail 'threads that were used'
commit=$("$cageproof" --version | sed -n 's/^cageproof [0-9.]* (commit \(.*\))$/\1/p')
[ -n "$commit" ] || fail "--version: $("$cageproof" --version)"
zgrep -qF "\"commit\":\"$commit\"" one/summary.json.gz || fail "the commit $commit is not recorded"
zgrep -qF '"flags":"' one/summary.json.gz || fail 'no flags'

# Input files are never written over.
printf '0.5,0.5\n' >inside.csv
refuses_to coordinates inside.csv '--solved is the file of --points' -- --cage square --points inside.csv --kind harmonic --solved inside.csv
[ "$(cat inside.csv)" = 0.5,0.5 ] || fail "--solved wrote over the points"

# A number beyond the range of a double is refused, not taken as infinite.
refuses_to deform 'nu=1e400' 'beyond the range' -- --cage cube --posed cube --points inside.csv --method somigliana --parameter nu=1e400 --out out.csv
printf '{"element":[[0,0,0],[1,0,0],[0,1,0]],"point":[0,0,1],"parameters":{"mu":1,"nu":"-1e400"}}\n' >far.jsonl
"$cageproof" eval --formula triangle.kelvin_displacement --evaluation closed_form <far.jsonl >stdout 2>stderr
grep -q 'nu = -1e400 is beyond the range of a double' stdout stderr || fail "eval takes -1e400: $(cat stdout stderr)"

# A folder of truths that nobody named does not stop a run; one that was named does.
touch no_folder
XDG_CACHE_HOME=$PWD/no_folder CAGEPROOF_TRUTH_CACHE='' "$cageproof" verify --suite quick --formulas segment.winding_angle --regimes far --out uncached >stdout 2>stderr ||
  fail "verify without a cache: $(cat stderr)"
[ "$(grep -c 'warning: no truths are kept for other runs: .*no_folder' stderr)" -eq 1 ] || fail "no warning of a cache that cannot be written: $(cat stderr)"
refuses_to verify no_folder --truth-cache -- --suite quick --formulas segment.winding_angle --regimes far --out named --truth-cache no_folder/x

# compare names the file that is no report.
zcat one/summary.json.gz >good.json
sed 's/"schema_version":[0-9]*/"schema_version":99/' good.json >later.json
refuses_to compare later.json 'schema_version 99 is unknown' -- one later.json
cp one/summary.json.gz junk.gz && echo junk >>junk.gz
refuses_to compare junk.gz 'behind its packed text' -- junk.gz one
"$cageproof" compare one one >stdout 2>stderr || fail "compare: $(cat stdout stderr)"
[ ! -s stderr ] || fail "compare of finished runs warns: $(cat stderr)"

# replay ends with a summary, of a file, or of a line of it.
"$cageproof" replay one/worst.jsonl >stdout && grep -q 'is empty' stdout || fail "replay of what fell short, which is nothing: $(cat stdout)"
zcat one/worst/*.jsonl.gz >one/worst.jsonl
refuses_to replay one/worst.jsonl 'no case in line 99999' -- one/worst.jsonl --line 99999
"$cageproof" replay one/worst.jsonl --line 2 >stdout || fail "replay of one line: $(cat stdout)"
[ "$(grep -c ': error ' stdout)" -le 1 ] && grep -q ': 1 case of' stdout || fail "not one line: $(cat stdout)"
"$cageproof" replay one/worst.jsonl >stdout || fail "replay: $(tail -n 2 stdout)"
grep -q "^all promises kept: $(wc -l <one/worst.jsonl) cases of one/worst.jsonl: .* 0 broken, .* 0 changed since stored$" stdout || fail "replay: $(tail -n 2 stdout)"
grep -q '^largest share of a promise: .* in line [0-9]*: segment.winding_angle' stdout || fail "replay: $(tail -n 1 stdout)"
sed '1s/"regime":"far"/"regime":"fra"/' one/worst.jsonl >misspelt.jsonl
refuses_to replay misspelt.jsonl:1 "unknown regime 'fra'; did you mean 'far'?" -- misspelt.jsonl --line 1
sed 's/"bound":[^,}]*/"bound":1e-300/' one/worst.jsonl >broken.jsonl
"$cageproof" replay broken.jsonl >stdout
[ $? -eq 1 ] && grep -q '^PROMISES BROKEN: ' stdout || fail "replay of broken promises: $(tail -n 2 stdout)"
grep -q "^PROMISES BROKEN: .* $(grep -c 'above the promised' stdout) broken, " stdout || fail "replay miscounts broken promises: $(tail -n 2 stdout)"
# Each case is counted once: kept where it has a bound, not promised where it has none, without error where there is no truth: at an end of the segment.
grep '"check":"truth"' one/worst.jsonl | grep '"evaluation":"closed_form","scalar":"double"' | grep -v '"order":0' |
  sed -E 's/("element":\[(\[[^]]*\]).*"point":)\[[^]]*\]/\1\2/' >ends.jsonl
ends=$(wc -l <ends.jsonl) open=$(grep -c '"bound":null' one/worst.jsonl)
[ "$ends" -gt 0 ] || fail "no case to move to an end of its segment"
cat one/worst.jsonl ends.jsonl >moved.jsonl
"$cageproof" replay moved.jsonl >stdout || fail "replay of what has no truth: $(tail -n 2 stdout)"
grep -q ": $(wc -l <moved.jsonl) cases of moved.jsonl: $(($(wc -l <one/worst.jsonl) - open)) kept, 0 broken, $open not promised, $ends without error; 0 changed since stored$" stdout ||
  fail "replay miscounts: $(tail -n 2 stdout)"

[ $failures -eq 0 ] && echo "names and numbers mean the same everywhere"
exit $failures
