#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The report's pages after their scripts, read from the document that headless Chromium ends with; no script fails.
# Usage: pages_test.sh PATH_OF_CAGEPROOF
# shellcheck source=support.sh
source "$(dirname "$(readlink -f "$0")")/support.sh"

browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || {
  echo "FAILED: no Chromium: scripts/ensure_packages.sh tests installs it"
  exit 1
}

# opened ADDRESS FILE: the document after its scripts have run, into FILE; the scripts' complaints, into FILE.log.
opened() {
  timeout 120 "$browser" --headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking --disable-component-update --disable-sync \
    --user-data-dir="$work/profile" --window-size=1400,1000 --virtual-time-budget=4000 --enable-logging=stderr --dump-dom "file://$work/$1" >"$2" 2>"$2.log"
  [ -s "$2" ] || fail "$1 does not open"
  ! grep -E 'CONSOLE.*(Error|error|Uncaught)' "$2.log" || fail "a script of $1 fails"
}

# has FILE WORDS...: each stands in the document.
has() {
  local file=$1 word
  shift
  for word in "$@"; do grep -qF -- "$word" "$file" || fail "$file lacks: $word"; done
}

"$cageproof" verify --formulas triangle.double_layer --regimes '*-edge,generic' --samples 8 --enclosures 1 --cage cube --out report >stdout || fail "verify: $(cat stdout)"

opened report/index.html index
has index '4 of 4 lines' '<option value="gauss-8, double">' 'aria-sort' 'everywhere: hybrid'
opened 'report/index.html?overview.evaluation=gauss-8,%20double&overview.order=1' filtered
has filtered 'of gauss-8, double' 'href="formulas/triangle.double_layer.html#truth.near-edge.gauss-8.double.1"'
opened 'report/index.html?heat.evaluation=gauss-8,%20double&heat.order=1' heat
has heat 'of gradients in gauss-8, double'
grep -q '<td class="e[1-4] open"><a href="#r[0-9]*">' heat || fail "the heat map does not show gauss-8"

# A cell that the address names answers: worst input, truth, reason, lines to copy.
page=report/formulas/triangle.double_layer.html
opened "$page#truth.near-edge.closed_form.double.2" cell
has cell 'furthest entry' 'digits right' 'backward stable' 'class="chosen' 'cageproof replay worst/triangle.double_layer.jsonl.gz --line' \
  'cageproof eval --formula triangle.double_layer --evaluation closed_form --order 2 --scalar double' 'promise kept'
grep -q '<aside id="answer"[^>]*hidden' cell && fail "the answer stays hidden"
[ "$(grep -o '<svg viewBox' cell | wc -l)" -ge 2 ] || fail "no curves or no times"
has cell 'everywhere: hybrid' 'data-series="gauss-8, double"'

# So few samples show no quantile.
grep -qF '99.9 % up to $' report/formulas/cells.js || fail "the words for quantiles have changed, and with them what is looked for here"
grep -q '99\.9 % up to ' cell && fail "a quantile of eight samples"

# Rows that no result could break are grey, and say so.
opened "$page#truth.on-edge.closed_form.double.2" grey
grep -q 'ill-posed here: a result without a right digit would score at most [0-9]' grey || fail "a grey cell does not say why"
grep -q '<td [^>]*class="[^"]*\bill\b' grey || fail "no cell is grey"
grep -q '^\.ill {' report/formulas/page.css || fail "grey cells have no style"

# The lines to copy are commands that run, in the report's folder.
sed -n 's/.*<pre>\(echo [^<]*\)<\/pre>.*/\1/p' cell | sed 's/&amp;/\&/g; s/&lt;/</g; s/&gt;/>/g' | head -n 1 >eval_line
sed -n 's/.*<pre>\(cageproof replay [^<]*\)<\/pre>.*/\1/p' cell | head -n 1 >replay_line
[ -s eval_line ] && [ -s replay_line ] || fail "no lines to copy"
mkdir bin && ln -s "$cageproof" bin/cageproof
(cd report && PATH=$work/bin:$PATH bash ../eval_line) >answer || fail "the eval line fails: $(cat eval_line)"
grep -q '"hessian"' answer || fail "eval answers without a Hessian: $(cat answer)"
(cd report && PATH=$work/bin:$PATH bash ../replay_line) >answer || fail "the replay line fails: $(cat replay_line)"
grep -q 'near-edge' answer || fail "replay answers something else: $(cat answer)"

opened "report/cages/cube.html" cage
has cage 'partition_<wbr>of_<wbr>unity' 'rows <button'

# A regime that elements do not have is named at once: on standard error, and before the verdict's figures.
"$cageproof" verify --formulas segment.single_layer --regimes generic,near-edge --samples 2 --enclosures 0 --out nowhere >/dev/null 2>warnings || fail "verify of segments: $(cat warnings)"
grep -qF 'warning: near-edge is no regime of segments: nothing was asked there.' warnings || fail "nothing says that segments have no near-edge: $(cat warnings)"
sed '/<\/header>/q' nowhere/index.html | grep -qF 'near-edge is no regime of segments' || fail "the page does not say that segments have no near-edge"
"$cageproof" verify --formulas '*.single_layer' --regimes 'near-*' --evaluations closed_form --samples 1 --enclosures 0 --out globs >/dev/null 2>warnings || fail "verify of globs"
grep -qF 'no regime' warnings && fail "a glob of regimes warns: $(cat warnings)"

# A cage's page has coordinates down and checks across, and long paths make no page wider.
mkdir -p deep/er && printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' >deep/er/my_cage.obj
"$cageproof" verify --cage "$PWD/deep/er/my_cage.obj" --formulas triangle.mean_value --regimes generic --samples 1 --enclosures 0 --out given >/dev/null 2>&1 || fail "verify of a file"
grep -c "$PWD/deep/er/my_cage.obj" given/cages/*.html | grep -qx 1 || fail "the path stands more than once on the cage's page"
grep -q '<h1>my_cage.obj' given/field.html || fail "the field's page has another name than the file's"
[ "$(zcat given/summary.json.gz | grep -cF "\"title\":\"$PWD/deep/er/my_cage.obj")" -gt 0 ] || fail "titles of the summary lack the path"
opened "$(cd given && ls -d "$PWD"/cages/*.html | sed "s|$work/||")#partition_of_unity.mean_value.batched.double.inside.0" panel
grep -q '<h2>mean_value, batched, double: partition_of_unity, my_cage.obj, inside, value' panel || fail "a cell's heading has more than the file's name"

# Sizes that open at once.
[ "$(wc -c <report/index.html)" -lt 1000000 ] || fail "index.html has a megabyte"
for file in report/formulas/*.html; do [ "$(wc -c <"$file")" -lt 2000000 ] || fail "$file has two megabytes"; done

[ $failures -eq 0 ] && echo "the pages are as they should be"
exit $failures
