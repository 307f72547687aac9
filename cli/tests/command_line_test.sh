#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The command line as a user meets it: its answers and its refusals. Usage: command_line_test.sh PATH_OF_CAGEPROOF
set -u
cageproof=$1
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
failures=0

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# refuses WORDS... -- COMMAND...: exit 2, one line on standard error that holds every word, nothing left at $work/out.
refuses() {
  local words=()
  while [ "$1" != -- ]; do words+=("$1"); shift; done
  shift
  "$@" >"$work/stdout" 2>"$work/stderr" </dev/null
  local code=$?
  [ $code -eq 2 ] || fail "exit $code, not 2: $*"
  [ "$(wc -l <"$work/stderr")" -eq 1 ] || fail "not one line: $* : $(cat "$work/stderr")"
  local word
  for word in "${words[@]}"; do grep -qF -- "$word" "$work/stderr" || fail "no '$word' in: $(cat "$work/stderr")"; done
  [ ! -e "$work/out" ] || fail "left something behind: $*"
  rm -rf "$work/out"
  [ -z "$(find "$work" -name '.out*' -print -quit)" ] || fail "left something aside: $*"
}

# Lines on standard error other than places of points and errors of partition and reproduction.
says_more() { grep -qvE '^([0-9]+ points?: |largest residual: )' "$work/stderr"; }

verify_cage() { "$cageproof" verify --suite quick --out "$work/out" --cage "$@"; }

tetrahedron='v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1'
good_faces='f 1 3 2
f 1 2 4
f 2 3 4
f 1 4 3'
write() { printf '%s\n' "${@:2}" >"$work/$1"; }

# Bad cages.
refuses missing.obj -- verify_cage "$work/missing.obj"
: >"$work/empty.obj"
refuses empty.obj -- verify_cage "$work/empty.obj"
write truncated.obj 'v 0 0 0' 'v 1 0'
refuses truncated.obj:2 -- verify_cage "$work/truncated.obj"
write words.obj 'v 0 0 0' 'v 1 abc 0'
refuses words.obj:2 -- verify_cage "$work/words.obj"
write nan.obj 'v 0 0 nan' "$tetrahedron" "$good_faces"
refuses nan.obj:1 -- verify_cage "$work/nan.obj"
write index.obj "$tetrahedron" 'f 1 2 1000000000000'
refuses index.obj:5 -- verify_cage "$work/index.obj"
write hole.obj "$tetrahedron" 'f 1 3 2' 'f 1 2 4' 'f 2 3 4'
refuses hole.obj 'face' -- verify_cage "$work/hole.obj"
write bowtie.obj 'v 0 0 0' 'v 1 0 0' 'v 1 1 0' 'v 0 1 0' 'v 0 0 1' 'v 1 0 1' 'v 1 1 1' 'v 0 1 1' \
  'f 1 3 2 4' 'f 5 6 7 8' 'f 1 2 6 5' 'f 2 3 7 6' 'f 3 4 8 7' 'f 4 1 5 8'
refuses bowtie.obj face -- verify_cage "$work/bowtie.obj"
write inverted.obj "$tetrahedron" 'f 1 2 3' 'f 1 4 2' 'f 2 4 3' 'f 1 3 4'
refuses inverted.obj --flip-inward -- verify_cage "$work/inverted.obj"
write flat.obj "$tetrahedron" 'v 2 0 0' "$good_faces" 'f 1 2 5'
refuses flat.obj -- verify_cage "$work/flat.obj"

# Parts: a tetrahedron within the tetrahedron, as a shell and as a cavity; another next to it, turned over.
inner='v 0.1 0.1 0.1
v 0.3 0.1 0.1
v 0.1 0.3 0.1
v 0.1 0.1 0.3'
write shells.obj "$tetrahedron" "$good_faces" "$inner" 'f 5 7 6' 'f 5 6 8' 'f 6 7 8' 'f 5 8 7'
refuses shells.obj 'part of 4 faces from face 4 (line 13)' 'within 1 other part' 'face 0 (line 5)' --flip-inward -- verify_cage "$work/shells.obj"
write beside.obj "$tetrahedron" "$good_faces" 'v 5 0 0' 'v 6 0 0' 'v 5 1 0' 'v 5 0 1' 'f 5 6 7' 'f 5 8 6' 'f 6 8 7' 'f 5 7 8'
refuses beside.obj 'part of 4 faces from face 4 (line 13)' 'within no other' inward -- verify_cage "$work/beside.obj"
write centre.csv '0.05,0.05,0.05'
write cavity.obj "$tetrahedron" "$good_faces" "$inner" 'f 5 6 7' 'f 5 8 6' 'f 6 8 7' 'f 5 7 8'
for cage in cavity.obj 'shells.obj --flip-inward'; do
  # shellcheck disable=SC2086
  "$cageproof" coordinates --cage "$work"/$cage --points "$work/centre.csv" --kind green >"$work/stdout" 2>"$work/stderr" || fail "coordinates in $cage"
  says_more && fail "a word about $cage: $(cat "$work/stderr")"
done
write crossing.obj "$tetrahedron" "$good_faces" 'v 0.1 0.1 -0.1' 'v 0.3 0.1 -0.1' 'v 0.1 0.3 -0.1' 'v 0.1 0.1 0.1' 'f 5 7 6' 'f 5 6 8' 'f 6 7 8' 'f 5 8 7'
"$cageproof" coordinates --cage "$work/crossing.obj" --points "$work/centre.csv" --kind green >"$work/stdout" 2>"$work/stderr" || fail "coordinates in crossing.obj"
grep -qF 'warning: ' "$work/stderr" && grep -qF 'faces 0 and 5 (lines 5 and 14)' "$work/stderr" || fail "crossing faces: $(cat "$work/stderr")"

# Polygons: the same square, with a hole, in each format, and as the embedded one; an SVG's is drawn the way round that a screen shows.
svg() { printf '<svg xmlns="http://www.w3.org/2000/svg">\n<g transform="translate(-1 1)">\n%s\n</g>\n</svg>\n' "$2" >"$work/$1"; }
write ring.obj 'v -1 -1' 'v 1 -1' 'v 1 1' 'v -1 1' 'v -0.5 0.5' 'v 0.5 0.5' 'v 0.5 -0.5' 'v -0.5 -0.5' 'l 1 2 3 4 1' 'l 5 6 7 8 5'
svg ring.svg '<path d="M0 0H2V-2H0ZM.5-1.5h1v1h-1z"/>'
write ring.geojson '{"type":"Feature","properties":null,"geometry":{"type":"Polygon","coordinates":[' \
  '[[-1,-1],[1,-1],[1,1],[-1,1],[-1,-1]],' '[[-0.5,0.5],[0.5,0.5],[0.5,-0.5],[-0.5,-0.5],[-0.5,0.5]]]}}'
write flat.csv '0.75,0.125' '-0.75 , -0.625,0' '0,0'
for kind in green biharmonic mean_value; do
  for cage in ring.obj ring.svg ring.geojson; do
    "$cageproof" coordinates --cage "$work/$cage" --points "$work/flat.csv" --kind $kind --order 2 >"$work/$cage.$kind" 2>"$work/stderr" || fail "coordinates in $cage: $(cat "$work/stderr")"
    cmp -s "$work/ring.obj.$kind" "$work/$cage.$kind" || fail "$kind coordinates in $cage are others than in ring.obj"
  done
done
head -1 "$work/ring.obj.green" | grep -q '^phi_0,.*,phi_7,phi_0_dx,phi_0_dy,phi_1_dx.*phi_0_dxx,phi_0_dxy,phi_0_dyx,phi_0_dyy' || fail "columns of a polygon: $(head -1 "$work/ring.obj.green")"
"$cageproof" coordinates --cage "$work/ring.svg" --points "$work/ring.geojson" --kind mean_value --out "$work/ring.vtp" || fail "ring.vtp"
"$cageproof" coordinates --cage "$work/ring.vtp" --points "$work/flat.csv" --kind mean_value --order 2 | cmp -s - "$work/ring.obj.mean_value" || fail "the polygon of a written .vtp is another one"
for cage in square l-shape star comb thin-bar frame figure; do
  "$cageproof" coordinates --cage $cage --points "$work/flat.csv" --kind green >"$work/stdout" || fail "coordinates in $cage"
  # At a point in the cage the vertices' functions sum to one, at one outside to zero.
  awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) phi[i] = $i ~ /^phi/ } NR > 1 { s = 0; for (i = 1; i <= NF; i++) if (phi[i]) s += $i
    if (s * s > 1e-24 && (s - 1) * (s - 1) > 1e-24) exit 1 }' "$work/stdout" || fail "coordinates in $cage: $(cat "$work/stdout")"
done
coordinates_in() { "$cageproof" coordinates --points "$work/flat.csv" --kind green --cage "$work/$1" "${@:2}"; }
write cross.obj 'v 0 0' 'v 1 0' 'v 0 1' 'v 1 1' 'l 1 2 3 4 1'
refuses cross.obj 'segments 1 and 3 (lines 5 and 5) cross' -- coordinates_in cross.obj
write open.obj 'v 0 0' 'v 1 0' 'v 0 1' 'l 1 2' 'l 2 3'
refuses open.obj 'vertex 0' 'open' 'segment 0 (line 4)' -- coordinates_in open.obj
write twice.obj 'v 0 0' 'v 1 0' 'v 1 1' 'v 0 0' 'l 1 2 3 4 1'
refuses twice.obj 'segment 3 (line 5)' 'coincide' -- coordinates_in twice.obj
write clockwise.obj 'v 0 0' 'v 1 0' 'v 0 1' 'l 1 3 2 1'
refuses clockwise.obj clockwise 'line 4' --flip-inward -- coordinates_in clockwise.obj
coordinates_in clockwise.obj --flip-inward >/dev/null || fail "--flip-inward of a polygon"
# Where a format gives direction no meaning.
write clockwise.svg '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0 0-1 1 0z"/></svg>'
write clockwise.geojson '{"type":"Polygon","coordinates":[[[0,0],[0,1],[1,0],[0,0]]]}'
for cage in clockwise.svg clockwise.geojson; do
  coordinates_in $cage >"$work/stdout" && head -1 "$work/stdout" | grep -q '^phi_0,phi_1,phi_2,' || fail "a polygon of $cage"
done
write lifted.obj 'v 0 0 0' 'v 1 0 0' 'v 0 1 2' 'l 1 2 3 1'
refuses lifted.obj 'vertex 2' '3D points for a polygon' -- coordinates_in lifted.obj
write mixed.obj "$tetrahedron" "$good_faces" 'l 1 2 3 1'
refuses mixed.obj 'faces (the first in line 5)' 'polylines (the first in line 9)' -- coordinates_in mixed.obj
svg curve.svg '<path id="leaf" d="M0 0H1c1 1 2 2 0 1z"/>'
refuses curve.svg:3 leaf 'cubic Bezier' -- coordinates_in curve.svg
svg round.svg '<circle r="1"/>'
refuses round.svg:3 '<circle>' -- coordinates_in round.svg
svg empty.svg ''
refuses empty.svg -- coordinates_in empty.svg
write open.geojson '{"type":"Polygon","coordinates":[' '[[0,0],[1,0],[1,1],[0,1]]]}'
refuses open.geojson:2 'coordinates[0]' open -- coordinates_in open.geojson
refuses ring.obj 'dimension' -- "$cageproof" coordinates --points "$work/flat.csv" --kind spherical_mean_value --cage "$work/ring.obj"
refuses lifted.obj 'vertex 2' '3D points for a polygon' -- "$cageproof" coordinates --cage square --points "$work/lifted.obj" --kind green
refuses figure 'dimension' -- "$cageproof" bench --coordinates --cage figure
refuses ring.obj 'no triangle' -- "$cageproof" field --formula triangle.double_layer --evaluation gauss-4 --cage "$work/ring.obj" --out "$work/out"
refuses cross.obj 'cross each other' -- verify_cage "$work/cross.obj"
refuses flat.csv:1 'three coordinates' -- verify_cage cube --points "$work/flat.csv"
"$cageproof" bench --kind green --cage "$work/ring.svg" --samples 1 --seconds 0 >"$work/stdout" || fail "bench in a polygon"
"$cageproof" field --kind biharmonic --cage "$work/ring.svg" --evaluation closed_form --resolution 8 --out "$work/flat_field" >/dev/null || fail "field in a polygon"
"$cageproof" verify --suite quick --formulas segment.double_layer --regimes near-face --cage "$work/ring.svg" --points "$work/flat.csv" --out "$work/flat_report" >"$work/stdout" ||
  fail "verify of a polygon: $(cat "$work/stdout")"
zcat "$work"/flat_report/worst/*.jsonl.gz >"$work/flat_worst.jsonl"
grep -q 'ring.svg' "$work/flat_worst.jsonl" || fail "no worst case in a polygon"
"$cageproof" replay "$work/flat_worst.jsonl" >"$work/stdout" || fail "replay in a polygon: $(tail -n 3 "$work/stdout")"

# A cage is verified by itself, and with single elements when formulas are asked for.
write two.csv '0.2,0.2' '0.4,0.3'
rows_of() {
  "$cageproof" verify --suite quick --out "$work/scope" --cage square --points "$work/two.csv" "$@" >"$work/stdout" || fail "verify of a cage $*"
  zcat -f "$work"/scope/results.csv* >"$work/rows"
}
rows_of
grep -q square "$work/rows" || fail "no row of the cage"
! grep -q '^element,' "$work/rows" || fail "single elements without --formulas"
rows_of --formulas segment.double_layer --samples 1
grep -q '^element,' "$work/rows" || fail "no single elements with --formulas"

# Bad points and names.
write points.csv '0.1,0.2,0.3' '0.1,0.2'
refuses points.csv:2 -- verify_cage cube --points "$work/points.csv"
refuses --cage -- "$cageproof" verify --points "$work/points.csv" --out "$work/out"
refuses nonsense -- "$cageproof" verify --formulas nonsense --out "$work/out"
refuses "CAGEPROOF_SIMD: 'axv2'" plain -- env CAGEPROOF_SIMD=axv2 "$cageproof" list
refuses "CAGEPROOF_SIMD: 'axv2'" plain -- env CAGEPROOF_SIMD=axv2 "$cageproof" verify --formulas triangle.solid_angle --regimes generic --samples 1 --out "$work/out"
CAGEPROOF_SIMD=plain "$cageproof" list >"$work/stdout" || fail "CAGEPROOF_SIMD=plain is refused"
CAGEPROOF_SIMD= "$cageproof" list >"$work/stdout" || fail "an empty CAGEPROOF_SIMD is refused"
refuses nonsense -- "$cageproof" verify --evaluations nonsense --out "$work/out"
refuses nonsense -- "$cageproof" verify --regimes nonsense --out "$work/out"
refuses suite -- "$cageproof" verify --suite nonsense --out "$work/out"
refuses nonsense -- "$cageproof" eval --formula nonsense --evaluation closed_form
refuses gauss-0 -- "$cageproof" eval --formula triangle.single_layer --evaluation gauss-0
refuses nonsense -- "$cageproof" field --formula nonsense --evaluation closed_form --out "$work/out"
refuses nonsense -- "$cageproof" coordinates --cage cube --points "$work/missing.csv" --kind nonsense
refuses missing.csv -- "$cageproof" coordinates --cage cube --points "$work/missing.csv" --kind green
refuses missing.jsonl -- "$cageproof" replay "$work/missing.jsonl"
write bad.jsonl '{"formula":'
refuses bad.jsonl:1 -- "$cageproof" replay "$work/bad.jsonl"
refuses nonsense -- "$cageproof" hunt --formula nonsense --evaluation closed_form --budget 10
refuses nonsense -- "$cageproof" hunt --formula triangle.solid_angle --evaluation nonsense --budget 10
refuses nonsense -- "$cageproof" hunt --formula triangle.solid_angle --evaluation closed_form --budget 10 --check nonsense
refuses nonsense -- "$cageproof" hunt --formula triangle.solid_angle --evaluation closed_form --budget 10 --regime nonsense
refuses budget -- "$cageproof" hunt --formula triangle.solid_angle --evaluation closed_form --budget 0
refuses bad.jsonl:1 -- "$cageproof" hunt --formula triangle.solid_angle --evaluation closed_form --budget 10 --out "$work/bad.jsonl"
refuses "$work/nowhere" -- "$cageproof" hunt --formula triangle.solid_angle --evaluation closed_form --budget 10 --out "$work/nowhere/x.jsonl"
refuses 'a command is missing' verify -- "$cageproof"
refuses "'nonsense'" command -- "$cageproof" nonsense
refuses "'--nonsense'" option -- "$cageproof" --nonsense verify
refuses --seed "'-1'" -- "$cageproof" verify --seed -1 --out "$work/out"
refuses --seed 18446744073709551616 -- "$cageproof" hunt --formula triangle.solid_angle --evaluation closed_form --budget 10 --seed 18446744073709551616
refuses nowhere 'no such file' cube -- "$cageproof" coordinates --cage nowhere --points "$work/missing.csv" --kind green
write lifted.csv '0.3,0.4,0' '0.3,0.4,7'
refuses lifted.csv:2 '3D points for a polygon' -- "$cageproof" coordinates --cage square --points "$work/lifted.csv" --kind green
refuses "$work/nowhere" -- "$cageproof" verify --suite quick --formulas '*.solid_angle' --regimes generic --out "$work/nowhere/out"
write one.csv '0.1 0.2 0.3'
refuses .doc -- "$cageproof" coordinates --cage cube --points "$work/one.csv" --kind green --out "$work/out.doc"
refuses "$work/nowhere" -- "$cageproof" coordinates --cage cube --points "$work/one.csv" --kind green --out "$work/nowhere/x.csv"

# A full disk.
if [ -e /dev/full ]; then
  echo '{"element":[[0,0,0],[1,0,0],[0,1,0]],"point":[0,0,1]}' |
    "$cageproof" eval --formula triangle.single_layer --evaluation closed_form >/dev/full 2>"$work/stderr"
  [ $? -eq 2 ] || fail "a full disk is not exit 2 for eval"
fi
(ulimit -f 40; trap '' XFSZ
 "$cageproof" verify --suite quick --formulas '*.solid_angle' --regimes generic --out "$work/out" >/dev/null 2>"$work/stderr")
[ $? -eq 2 ] || fail "a file that cannot be written is not exit 2: $(cat "$work/stderr")"
[ ! -e "$work/out/index.html" ] && [ ! -e "$work/out/summary.json.gz" ] || fail "half a report"
rm -rf "$work/out" # the journal, with which the run would go on

# eval goes on after a bad line, says which, and exits 2.
printf '%s\n' '{"element":[[0,0,0],[1,0,0],[0,1,0]],"point":[0.25,0.25,"0x1p-4"]}' '{"element":' \
  '{"element":[[0,0,0],[1,0,0]],"point":[0,0,1]}' '{"element":[[0,0,0],[1,0,0],[2,0,0]],"point":[0,0,1]}' \
  '{"element":[[0,0,0],[1,0,0],[0,1,0]],"point":[0,0,1e999]}' '{"element":[[0,0,0],[1,0,0],[0,1,0]],"point":[0,0]}' \
  '{"element":[[0,0,0],[1,0,0],[0,1,0]],"point":[0,0,1]}' |
  "$cageproof" eval --formula triangle.double_layer --evaluation closed_form --order 2 >"$work/stdout"
[ $? -eq 2 ] || fail "eval with bad lines is not exit 2"
[ "$(grep -c '"value"' "$work/stdout")" -eq 2 ] || fail "eval: two good lines"
for n in 2 3 4 5 6; do grep -q "\"error\":.*\"line\":$n}" "$work/stdout" || fail "eval: no error for line $n"; done

# Multiprecision takes and gives more digits than a double has.
printf '%s\n' '{"element":[[0,0,0],[1,0,0],[0,1,0]],"point":["0.1","0.1","0.1"]}' \
  '{"element":[[0,0,0],[1,0,0],[0,1,0]],"point":[0.1,0.1,0.1]}' '{"element":[[0,0,0],[1,0,0],[0,1,0]],"point":["0x1.999999999999ap-4",0.1,0.1]}' |
  "$cageproof" eval --formula triangle.single_layer --evaluation closed_form --scalar mp100 >"$work/stdout"
[ "$(sed -n 1p "$work/stdout")" = "$(sed -n 2p "$work/stdout")" ] || fail "a JSON number loses digits in mp100"
[ "$(sed -n 1p "$work/stdout")" != "$(sed -n 3p "$work/stdout")" ] || fail "a hexadecimal double is not its decimal"

# Enclosures come with their radii, and nothing else does.
for evaluation in certified closed_form; do
  echo '{"element":[[0,0,0],[1,0,0],[0,1,0]],"point":[0,0,1]}' |
    "$cageproof" eval --formula triangle.solid_angle --evaluation $evaluation --order 1 >"$work/$evaluation"
done
grep -q '"value_radius":\[[^]]*\],"gradient_radius":\[' "$work/certified" || fail "eval certified: $(cat "$work/certified")"
! grep -q radius "$work/closed_form" || fail "radii of a closed form"
"$cageproof" list --json | grep -q '"name": "certified"' || fail "list: no certified"

# coordinates: one row per point, and sums of one.
write three.csv 'x,y,z' '0.1,0.2,0.3' '-0.2,0.1,0' '0,0,0'
"$cageproof" coordinates --cage cube --points "$work/three.csv" --kind mean_value >"$work/stdout" || fail "coordinates"
awk -F, 'NR > 1 { s = 0; for (i = 1; i <= NF; i++) s += $i; if (s < 0.999999999 || s > 1.000000001) exit 1 } END { if (NR != 4) exit 1 }' \
  "$work/stdout" || fail "coordinates do not sum to one"
for kind in csv npy vtp; do
  "$cageproof" coordinates --cage cube --points "$work/three.csv" --kind green --out "$work/c.$kind" && [ -s "$work/c.$kind" ] || fail "$kind"
done

# Derivatives on the cage are not finite, and VTK's own reader takes the file all the same.
write on.csv '0.5,0,0' '0,0,0' '0.25,0.5,0'
for order in 1 2; do
  "$cageproof" coordinates --cage cube --points "$work/on.csv" --kind green --order $order --out "$work/on.vtp" || fail "vtp of order $order"
  "$cageproof" coordinates --cage cube --points "$work/on.vtp" --kind green >/dev/null 2>"$work/stderr" || fail "vtp of order $order: $(cat "$work/stderr")"
done

# Coordinates that are solved for: sums of one, the systems on standard error and as JSON, and a warning where one is singular.
write flat.csv '0.25,0.5,0' '0,0,0' '0.375,0,0'
for parameter in collocation=vertices-and-midpoints collocation=vertices; do
  "$cageproof" coordinates --cage square --points "$work/flat.csv" --kind biharmonic_boundary --parameter pieces=1 --parameter $parameter \
    --solved "$work/solved.json" >"$work/stdout" 2>"$work/stderr" || fail "biharmonic_boundary: $(cat "$work/stderr")"
  awk -F, 'NR > 1 { s = $1 + $2 + $3 + $4; if (NF != 8 || s < 0.999999999 || s > 1.000000001) exit 1 } END { if (NR != 4) exit 1 }' "$work/stdout" ||
    fail "biharmonic_boundary, $parameter: $(cat "$work/stdout")"
  grep -q 'rank 4, condition' "$work/stderr" || fail "what was solved: $(cat "$work/stderr")"
  grep -q '"residual"' "$work/solved.json" || fail "what was solved: $(cat "$work/solved.json")"
done
grep -q '^warning: .*singular.* 3, not 4' "$work/stderr" || fail "no warning of a singular system: $(cat "$work/stderr")"
grep -q '"singular": true' "$work/solved.json" || fail "no singular system: $(cat "$work/solved.json")"
# Data at vertices, then normal derivatives of edges: x, and a constant.
write affine.csv 'f g' '0 2' '1 2' '1 2' '0 2' '' '0 0 # bottom' '1 0' '0 0' '-1 0'
"$cageproof" coordinates --cage square --points "$work/flat.csv" --kind biharmonic_boundary --data "$work/affine.csv" --order 1 >"$work/stdout" 2>"$work/stderr" ||
  fail "data: $(cat "$work/stderr")"
head -1 "$work/stdout" | grep -qx 'f_0,f_0_dx,f_0_dy,f_1,f_1_dx,f_1_dy' || fail "columns of data: $(head -1 "$work/stdout")"
awk -F, 'function off(a, b) { return a - b > 1e-12 || b - a > 1e-12 } NR == 2 && (off($1, 0.25) || off($2, 1) || off($3, 0) || off($4, 2) || off($5, 0)) { exit 1 }' \
  "$work/stdout" || fail "functions of data: $(cat "$work/stdout")"
write short.csv '1' '2'
refuses short.csv '4 of alpha and 4 of beta' -- "$cageproof" coordinates --cage square --points "$work/flat.csv" --kind biharmonic_boundary --data "$work/short.csv"
write words.csv '1' 'two'
refuses words.csv:2 -- "$cageproof" coordinates --cage square --points "$work/flat.csv" --kind biharmonic_boundary --data "$work/words.csv"
refuses matrices -- "$cageproof" coordinates --cage cube --points "$work/three.csv" --kind somigliana --data "$work/short.csv"
refuses collocation=corners vertices-and-midpoints -- "$cageproof" coordinates --cage square --points "$work/flat.csv" --kind biharmonic_boundary --parameter collocation=corners
refuses pieces=1.5 range -- "$cageproof" coordinates --cage square --points "$work/flat.csv" --kind harmonic --parameter pieces=1.5
refuses cube dimension -- "$cageproof" coordinates --cage cube --points "$work/three.csv" --kind cauchy
refuses nonsense evaluation -- "$cageproof" coordinates --cage square --points "$work/flat.csv" --kind cauchy --evaluation nonsense

# Stated digits are rounded down: one rounding of a double is 15.95 digits.
echo '{"element":[[0,-1,0],[0,0,0],[0,0,1]],"point":["0x1.12e0be826d695p-30","-0x1.000010c6f7a0bp+0",0]}' |
  "$cageproof" eval --formula triangle.double_layer --evaluation accurate --order 2 >"$work/stdout"
grep -q '"stated_digits":1[0-5]' "$work/stdout" || fail "16 digits stated: $(cat "$work/stdout")"

# The limit of an infinite Poisson's ratio has a name.
for nu in '"inf"' '"-inf"' 1e300; do
  echo '{"element":[[0,0,0],[1,0,0],[0,1,0]],"point":[0,0,1],"parameters":{"nu":'$nu'}}' |
    "$cageproof" eval --formula triangle.kelvin_displacement --evaluation closed_form
done >"$work/stdout"
grep -c '"value":\[0\.' "$work/stdout" | grep -qx 2 || fail "nu = inf: $(cat "$work/stdout")"
echo '{"element":[[0,0,0],[1,0,0],[0,1,0]],"point":[0,0,"inf"]}' | "$cageproof" eval --formula triangle.solid_angle --evaluation closed_form >"$work/stdout"
grep -q 'not finite' "$work/stdout" || fail "a point at infinity: $(cat "$work/stdout")"

# explain: its value is that of eval, its lines are those of the closed form's headers, and bad input is refused as everywhere.
explain() { "$cageproof" explain "$@"; }
element='[[0,0,0],[1,0,0],[0,"0x1.4f2f36e262042p-1",0]]' point='["0x1.233a0f7dd2858p-5",0,"0x1.826552aa027bdp+0"]'
explain --formula triangle.biharmonic_double_layer --element "$element" --point "$point" --order 1 --entry 4 --limit 3 >"$work/stdout" || fail explain
grep -q '^  value ' "$work/stdout" && grep -q 'conditioned units, .* digits lost' "$work/stdout" || fail "explain: $(cat "$work/stdout")"
[ "$(grep -cE ' (closed_form/include/cageproof/closed_form|fast/include/cageproof/fast)/triangle/.*\.h' "$work/stdout")" -eq 3 ] || fail "explain: three lines of the closed form: $(cat "$work/stdout")"
grep -q '^and [0-9]* lines more$' "$work/stdout" || fail "explain: what is left out"
for formula in triangle.kelvin_traction triangle.mean_value quad.mean_value segment.double_layer; do
  case $formula in
    segment*) line='{"element":[[0,0],[1,0]],"point":[0.25,0.125]}' ;;
    quad*) line='{"element":[[0,0,0],[1,0,0],[1,1,0.25],[0,1,0]],"point":[0.25,0.25,0.125]}' ;;
    *) line='{"element":[[0,0,0],[1,0,0],[0,1,0]],"point":[0.25,0.25,0.125]}' ;;
  esac
  case $formula in quad*) evaluations=line_form ;; *) evaluations='hybrid closed_form' ;; esac
  for evaluation in $evaluations; do
    value=$(echo "$line" | explain --formula $formula --evaluation $evaluation --order 2 --entry 3 --json | tee "$work/stdout" | sed -n 's/^  "counted": \(.*\),$/\1/p')
    grep -q '"counted_is_the_value": true' "$work/stdout" || fail "explain $formula $evaluation: $(head -12 "$work/stdout")"
    [ -n "$value" ] && echo "$line" | "$cageproof" eval --formula $formula --evaluation $evaluation --order 2 | sed 's/.*"hessian"//' | grep -qF -- "$value" ||
      fail "explain $formula $evaluation: '$value' is not in eval's Hessian"
  done
done
# The algebra far away is algebra, and says on which rung of its ladder it stands; the hybrid takes Gauss points there.
far() { explain --formula triangle.double_layer --evaluation "$1" --element '[[0,0,0],[1,0,0],[0,1,0]]' --point '[0.25,0.25,100]'; }
far closed_form | grep -q '^  form    edge form in double-double, since in double the bound of its error is .*, more than 1000 units$' || fail "explain closed_form: $(far closed_form)"
far closed_form | grep -q '/panel\|/far_form' && fail "explain closed_form: $(far closed_form)"
far hybrid | grep -q '^  form    far form in double, .* Gauss points' || fail "explain hybrid: $(far hybrid)"
refuses nonsense -- explain --formula nonsense
refuses 'accurate of triangle.solid_angle is not run in counted numbers: give closed_form or hybrid' -- explain --formula triangle.solid_angle --evaluation accurate --element '[[0,0,0],[1,0,0],[0,1,0]]' --point '[0,0,1]'
refuses 'no entry 3' -- explain --formula triangle.solid_angle --order 1 --entry 3 --element '[[0,0,0],[1,0,0],[0,1,0]]' --point '[0,0,1]'
refuses area -- explain --formula triangle.solid_angle --element '[[0,0,0],[1,0,0],[2,0,0]]' --point '[0,0,1]'
refuses 'element[2]' -- explain --formula triangle.solid_angle --element '[[0,0,0],[1,0,0],[0,1]]' --point '[0,0,1]'
refuses --point -- explain --formula triangle.solid_angle --element '[[0,0,0],[1,0,0],[0,1,0]]'
refuses 'no input' -- explain --formula triangle.solid_angle
refuses '--element [[0,0,0: malformed JSON' 'expected [[x,y,z],...]' -- explain --formula triangle.solid_angle --element '[[0,0,0' --point '[0,0,1]'
refuses '--point [0,0 1]: malformed JSON' 'expected [x,y,z]' -- explain --formula triangle.solid_angle --element '[[0,0,0],[1,0,0],[0,1,0]]' --point '[0,0 1]'
refuses '--point [0,0,1],"parameters":{}: malformed JSON' -- explain --formula triangle.solid_angle --element '[[0,0,0],[1,0,0],[0,1,0]]' --point '[0,0,1],"parameters":{}'
refuses 'point must be 3 numbers, [x,y,z]' -- explain --formula triangle.solid_angle --element '[[0,0,0],[1,0,0],[0,1,0]]' --point '[0,0]'
refuses 'element must be 3 corners of a triangle, [[x,y,z],...]' -- explain --formula triangle.solid_angle --element '{}' --point '[0,0,1]'

# A hunted input of the plane is one that eval takes; a key that occurs twice is none.
"$cageproof" hunt --formula segment.double_layer --evaluation closed_form --order 1 --budget 20 >"$work/stdout" 2>/dev/null
grep -o '{"element".*}}' "$work/stdout" | "$cageproof" eval --formula segment.double_layer --evaluation closed_form >/dev/null || fail "eval of a hunted input"
echo '{"element":[[0,0],[1,0]],"point":[0,1],"point":[0,2]}' | "$cageproof" eval --formula segment.double_layer --evaluation closed_form >"$work/stdout"
grep -qF '"point\" occurs twice' "$work/stdout" || fail "a key twice: $(cat "$work/stdout")"

# Evaluations without the order asked for are left out of a default comparison.
"$cageproof" bench --formula triangle.kelvin_traction --regime near-face --order 1 --samples 1 --seconds 0 >"$work/stdout" 2>&1 ||
  fail "bench --order 1: $(cat "$work/stdout")"

# Coordinates that keep quads: sums of one, points without coordinates counted, invalid quads named or warned of.
for kind in quad_mean_value spherical_mean_value maximum_entropy; do
  "$cageproof" coordinates --cage twisted-bar --points "$work/three.csv" --kind $kind >"$work/stdout" 2>"$work/stderr" || fail "coordinates $kind"
  awk -F, 'NR > 1 { s = 0; for (i = 1; i <= NF; i++) s += $i; if (s < 0.999999999999 || s > 1.000000000001) exit 1 } END { if (NR != 4) exit 1 }' \
    "$work/stdout" || fail "$kind coordinates do not sum to one"
  says_more && fail "$kind: $(cat "$work/stderr")"
done
write far.csv '9,9,9' '0,0,0'
"$cageproof" coordinates --cage cube --points "$work/far.csv" --kind maximum_entropy >"$work/stdout" 2>"$work/stderr" || fail "maximum_entropy outside"
grep -q '1 of 2 points' "$work/stderr" || fail "points without coordinates are not counted: $(cat "$work/stderr")"
[ "$(grep -c nan "$work/stdout")" -eq 1 ] || fail "maximum_entropy: $(cat "$work/stdout")"
write arrowheads.obj 'v 0 0 0' 'v 2 -1 0' 'v 1 0 0' 'v 2 1 0' 'v 0 0 1' 'v 2 -1 1' 'v 1 0 1' 'v 2 1 1' \
  'f 1 4 3 2' 'f 5 6 7 8' 'f 1 2 6 5' 'f 2 3 7 6' 'f 3 4 8 7' 'f 4 1 5 8'
arrowheads() { "$cageproof" coordinates --cage "$work/arrowheads.obj" --points "$work/three.csv" "$@"; }
arrowheads --kind mean_value >/dev/null || fail "mean_value on arrowheads"
refuses arrowheads.obj 'face 0' 'folds over' --allow-invalid-quads -- arrowheads --kind quad_mean_value
refuses --allow-invalid-quads mean_value -- arrowheads --kind mean_value --allow-invalid-quads
arrowheads --kind quad_mean_value --allow-invalid-quads >"$work/stdout" 2>"$work/stderr" || fail "--allow-invalid-quads"
[ "$(grep -c 'warning: .*face [01] (line [0-9]*): .*folds over' "$work/stderr")" -eq 2 ] || fail "no warning of invalid quads: $(cat "$work/stderr")"
refuses bowtie.obj face bow-tie -- "$cageproof" coordinates --cage "$work/bowtie.obj" --points "$work/three.csv" --kind quad_mean_value
refuses nonsense -- "$cageproof" coordinates --cage cube --points "$work/three.csv" --kind spherical_mean_value --evaluation nonsense
# eval says the same of the same quads, goes on after them, and takes the same flag.
write quads.jsonl '{"element":[[0,0,0],[2,1,0],[1,0,0],[2,-1,0]],"point":[0.1,0.2,0.3]}' '{"element":[[0,0,0],[1,0,0],[1,1,0],[0,1,0]],"point":[0.1,0.2,0.3]}' \
  '{"element":[[0,0,0],[1,1,0],[1,0,0],[0,1,0]],"point":[0.1,0.2,0.3]}' '{"element":[[1,0,0],["1.00000000000000000000000000000001",0,0],["1.00000000000000000000000000000001","1e-32",0],[1,"1e-32",0]],"point":[0,0,1]}'
eval_quads() { "$cageproof" eval --formula quad.mean_value --evaluation line_form "$@" <"$work/quads.jsonl" >"$work/stdout" 2>"$work/stderr"; }
eval_quads --scalar mp50
[ $? -eq 2 ] || fail "invalid quads are not exit 2"
[ "$(grep -c '"value"' "$work/stdout")" -eq 2 ] || fail "eval of valid quads: $(cat "$work/stdout")"
reason=$("$cageproof" coordinates --cage "$work/arrowheads.obj" --points "$work/three.csv" --kind quad_mean_value 2>&1 | grep -o 'folds over') || fail "no reason"
grep -q "\"error\":\"element: .*$reason.*--allow-invalid-quads.*\"line\":1}" "$work/stdout" || fail "eval of an arrowhead: $(cat "$work/stdout")"
grep -q '"error":"element: .*bow-tie.*"line":3}' "$work/stdout" || fail "eval of a bow-tie: $(cat "$work/stdout")"
eval_quads --scalar mp50 --allow-invalid-quads || fail "eval --allow-invalid-quads: $(cat "$work/stdout")"
[ "$(grep -c '"value"' "$work/stdout")" -eq 4 ] || fail "eval of invalid quads: $(cat "$work/stdout")"
[ "$(grep -c '^warning: line [13]: element: ' "$work/stderr")" -eq 2 ] || fail "no warning of invalid quads: $(cat "$work/stderr")"
refuses --allow-invalid-quads triangle.solid_angle -- "$cageproof" eval --formula triangle.solid_angle --evaluation closed_form --allow-invalid-quads

# verify, its report, and replay.
"$cageproof" verify --suite quick --formulas '*.solid_angle' --regimes 'near-face' --out "$work/report" >"$work/stdout"
[ $? -eq 0 ] || fail "verify: $(cat "$work/stdout")"
for file in summary.json.gz summary.md results.csv.gz worst.jsonl worst index.html formulas/triangle.solid_angle.html fields pictures; do
  [ -e "$work/report/$file" ] || fail "no $file"
done
[ ! -s "$work/report/worst.jsonl" ] || fail "worst.jsonl holds what is kept"
"$cageproof" replay "$work/report/worst.jsonl" >"$work/stdout" || fail "replay of no case: $(cat "$work/stdout")"
zcat "$work"/report/worst/*.jsonl.gz >"$work/worst.jsonl"
"$cageproof" replay "$work/worst.jsonl" >"$work/stdout" || fail "replay: $(tail -n 3 "$work/stdout")"
[ "$(grep -c ': error ' "$work/stdout")" -eq "$(wc -l <"$work/worst.jsonl")" ] || fail "replay: a line a case"
awk '/: error / { if (!match($0, /: error [^ ]+/)) exit 1; e = substr($0, RSTART + 8, RLENGTH - 8); if (!match($0, /stored [^)]+/)) exit 1
       s = substr($0, RSTART + 7, RLENGTH - 7); if (e != s) { print; exit 1 } }' "$work/stdout" || fail "replay differs from what was stored"
grep -q '"regime":"hunted"' "$work/worst.jsonl" || fail "verify does not replay the stored worst cases"

# hunt: one line, the same for any number of threads, and cases that replay; a second hunt adds to them.
hunt() { "$cageproof" hunt --formula triangle.solid_angle --evaluation closed_form --regime 'near-*' --budget 300 --order 1 "$@"; }
hunt --jobs 1 --out "$work/hunted.jsonl" >"$work/stdout" || fail "hunt: $(cat "$work/stdout")"
grep -q 'largest found .* promised 64: kept' "$work/stdout" || fail "hunt does not say what it found: $(cat "$work/stdout")"
hunt --jobs 2 | diff -q "$work/stdout" - >/dev/null || fail "hunt depends on the number of threads"
cp "$work/hunted.jsonl" "$work/before.jsonl"
hunt --seed 2 --out "$work/hunted.jsonl" >/dev/null || fail "a second hunt"
head -n "$(wc -l <"$work/before.jsonl")" "$work/hunted.jsonl" | diff -q - "$work/before.jsonl" >/dev/null || fail "hunt loses what was there"
"$cageproof" replay "$work/hunted.jsonl" >"$work/stdout" || fail "replay of hunted cases"
(cd "$work" && "$cageproof" verify --suite quick --formulas '*.solid_angle' --regimes generic --out plain >/dev/null) ||
  fail "a report in the folder that one is in"
[ -e "$work/plain/index.html" ] || fail "no report under a plain name"
"$cageproof" field --formula triangle.single_layer --evaluation gauss-4 --resolution 12 --out "$work/field" >/dev/null || fail field
[ -n "$(find "$work/field/fields" -name '*.vti')" ] || fail "field: no .vti"
"$cageproof" field --kind somigliana --cage cube --evaluation three-quad-75 --colours 1e-16 1 --resolution 12 --out "$work/residual" >/dev/null ||
  fail "field --kind"
[ -n "$(find "$work/residual/pictures" -name '*.png')" ] || fail "field --kind: no picture"

# bench: one line per evaluation and distance, the same errors again, and a folder that replaces only its own kind.
bench() { "$cageproof" bench --samples 2 --seconds 0 "$@"; }
errors_of() { cut -d, -f 1-14 "$1"; }
bench --kind somigliana --cage cube --evaluations three-quad-75,closed_form --parameter nu=0.3 --csv --out "$work/bench" >"$work/bench.csv" 2>"$work/said" ||
  fail bench
grep -q "^written to $work/bench: work_precision.csv, .*, pictures/error_time.png$" "$work/said" || fail "bench does not say where its pictures are: $(cat "$work/said")"
[ "$(wc -l <"$work/bench.csv")" -eq 11 ] || fail "bench: $(cat "$work/bench.csv")"
for file in work_precision.csv work_precision.json pictures/error_nodes.png pictures/error_time.png pictures/error_distance.png; do
  [ -s "$work/bench/$file" ] || fail "bench: no $file"
done
bench --kind somigliana --cage cube --evaluations three-quad-75,closed_form --parameter nu=0.3 --csv --jobs 1 --out "$work/bench" >"$work/again.csv" ||
  fail "bench over an earlier one"
[ "$(errors_of "$work/bench.csv")" = "$(errors_of "$work/again.csv")" ] || fail "bench: other errors with the same seed"
awk -F, '$5 == "closed_form" && !($9 < 1e-10) || $5 == "three-quad-75" && ($14 != 75 || $3 == "1e-4" && !($9 > 1e-2)) { exit 1 }' \
  "$work/bench.csv" || fail "bench: $(cat "$work/bench.csv")"
bench --kind green --points "$work/three.csv" >"$work/stdout" || fail "bench --points"
bench --formula triangle.solid_angle --order 1 --regime near-face --evaluations gauss-4,closed_form >"$work/stdout" || fail "bench --formula"
[ "$(grep -c near-face "$work/stdout")" -eq 2 ] || fail "bench --formula: $(cat "$work/stdout")"
# Globs and lists of regimes select those that exist for the element, each once; the output names the calls timed, and their times.
bench --formula triangle.solid_angle --regime 'on-*,generic,on-face' --evaluations closed_form --csv >"$work/globs.csv" || fail "bench --regime 'on-*'"
[ "$(cut -d, -f 3 "$work/globs.csv" | sort | uniq -c | awk '$1 > 1' | wc -l)" -eq 0 ] || fail "a regime twice: $(cat "$work/globs.csv")"
for regime in generic on-face on-edge on-vertex; do grep -q ",$regime," "$work/globs.csv" || fail "no $regime: $(cat "$work/globs.csv")"; done
awk -F, 'NR == 1 { if ($16 != "median_nanoseconds" || $17 != "quantile_nanoseconds" || $18 != "timed") exit 1; next }
  !($15 > 0 && $16 > 0 && $17 >= $16 && $18 == 2) { exit 1 }' "$work/globs.csv" || fail "times: $(cat "$work/globs.csv")"
bench --formula segment.double_layer --regime '*' --evaluations closed_form >"$work/stdout" || fail "bench --regime '*' in the plane"
"$cageproof" bench --formula triangle.solid_angle --regime generic --evaluations closed_form --samples 2 --timed 70 --seconds 10 --csv >"$work/globs.csv" || fail "bench --timed"
[ "$(tail -n 1 "$work/globs.csv" | cut -d, -f 18)" -eq 70 ] || fail "bench --timed 70: $(cat "$work/globs.csv")"
refuses nonsense -- bench --formula triangle.solid_angle --regime 'nonsense*'
refuses nonsense gauss-0 -- bench --kind somigliana --evaluations nonsense,closed_form,gauss-0 --out "$work/out"
refuses nonsense -- bench --kind nonsense
refuses nonsense -- bench --formula nonsense
refuses nonsense -- bench --formula triangle.solid_angle --regime nonsense
refuses kind formula -- bench
refuses kind formula -- bench --kind green --formula triangle.solid_angle
refuses nu -- bench --kind somigliana --parameter nu=0.7
refuses missing.csv -- bench --kind green --points "$work/missing.csv"
refuses "does not replace" -- bench --kind green --out "$work/report"
refuses "does not replace" -- "$cageproof" field --formula triangle.solid_angle --evaluation gauss-4 --resolution 4 --out "$work/bench"
refuses --cage -- "$cageproof" field --kind green --evaluation gauss-4 --out "$work/out"
refuses nonsense -- "$cageproof" field --kind green --cage cube --evaluation nonsense --out "$work/out"
refuses --colours -- "$cageproof" field --kind green --cage cube --evaluation gauss-4 --colours 1 0 --out "$work/out"
"$cageproof" list --json | grep -q triangle.mean_value || fail "list --json"

# coordinates reports on its points: exit codes with --strict, and lines on standard error.
says() {
  local code=$1 words=()
  shift
  while [ "$1" != -- ]; do words+=("$1"); shift; done
  shift
  "$cageproof" coordinates --cage "$work/unit.obj" --points "$@" >"$work/stdout" 2>"$work/stderr"
  [ $? -eq "$code" ] || fail "not exit $code: coordinates $*"
  local word
  for word in "${words[@]}"; do grep -qF -- "$word" "$work/stderr" || fail "no '$word' of $*: $(cat "$work/stderr")"; done
}
write unit.obj "$tetrahedron" "$good_faces"
write around.csv '0.25 0.25 0.125' '0 0.25 0.5' '-1 0.5 0.5'
write inside.csv '0.25 0.25 0.125'
write lost.csv '0.25 0.25 0.125' '1e20 0 0'
says 0 '3 points: 1 inside, 1 on and 1 outside' 'largest residual: partition of unity' 'collapses to the origin at 1 point' -- "$work/around.csv" --kind green
says 1 'green coordinates sum to zero outside' -- "$work/around.csv" --kind green --strict
says 0 '1 point: 1 inside, 0 on and 0 outside' -- "$work/inside.csv" --kind green --strict
grep -q warning "$work/stderr" && fail "a warning of a point inside: $(cat "$work/stderr")"
says 0 '1 outside' -- "$work/around.csv" --kind mean_value --strict
grep -q warning "$work/stderr" && fail "a warning of mean values outside: $(cat "$work/stderr")"
says 1 '1 of 3 points have no finite derivatives of mean_value coordinates, the first is point 1: on the cage' -- "$work/around.csv" --kind mean_value --order 1 --strict
# Next to an edge elements' derivatives leave double's range, those of the coordinates need not; those that do are infinite.
write edges.csv '0.25 0 1e-170' '0.25 0.25 0.125' '1e-160 1e-160 0.25'
says 0 '3 points: 2 inside, 1 on and 0 outside' -- "$work/edges.csv" --kind green --order 2 --strict
grep -q nan "$work/stdout" && fail "nan next to edges: $(cat "$work/stdout")"
says 1 '1 of 3 points have no finite derivatives of green coordinates, the first is point 0: on the cage' -- "$work/edges.csv" --kind green --order 2 --evaluation plain --strict
# Hessians from there are sums of terms of 1e620, of which 200 digits do not tell all.
write denormal.csv '0.25 0.25 0.125' '1e-310 1e-310 0.25'
says 0 '1 of 2 points have no derivatives of green coordinates, the first is point 1: terms of theirs leave the range of double' -- "$work/denormal.csv" --kind green --order 2
says 1 'the first is point 1' -- "$work/denormal.csv" --kind green --order 2 --strict
says 0 '2 points: 2 inside' -- "$work/denormal.csv" --kind green --order 1 --strict
write faint.csv '0.25 0.25 0.125' '1e13 0.5 0'
says 0 '1 of 2 points sum to one to fewer than 8 digits' -- "$work/faint.csv" --kind mean_value --strict
says 1 '1 of 2 points have' 'mean_value coordinates' 'the sum of their weights is zero' -- "$work/lost.csv" --kind mean_value --strict
awk '/largest residual/ { if ($6 + 0 > 1e-14 || $12 + 0 > 1e-14) exit 1; found = 1 } END { exit !found }' "$work/stderr" || fail "residuals: $(cat "$work/stderr")"

# Doubles 1e15 sizes from the origin are an eighth of the cage apart.
write far_cage.obj 'v 1000000000000000 0 0' 'v 1000000000000001 0 0' 'v 1000000000000000 1 0' 'v 1000000000000000 0 1' "$good_faces"
write far_point.csv '1000000000000000.25 0.21 0.13'
for strict in 0 1; do
  "$cageproof" coordinates --cage "$work/far_cage.obj" --points "$work/far_point.csv" --kind green $([ $strict = 1 ] && echo --strict) >/dev/null 2>"$work/stderr"
  [ $? -eq $strict ] || fail "--strict ($strict) far from the origin: $(cat "$work/stderr")"
  grep -q 'give 1 of 1 points back to fewer than 8 digits.*sizes from the origin.*subtract the same whole numbers' "$work/stderr" || fail "far from the origin: $(cat "$work/stderr")"
done
# A mesh that pokes out of the cage is told, and an error with --strict.
poking() { (cd "$work" && "$cageproof" verify --cage unit.obj --points "$1" --evaluations batched --out poking "${@:2}" >stdout 2>stderr); }
poking around.csv || fail "points outside without --strict: $(cat "$work/stderr")"
grep -q '^warning: 1 of 3 points of around.csv are outside unit.obj, the first of them number 2' "$work/stderr" || fail "points outside: $(cat "$work/stderr")"
[ "$(grep -c '1 of 3 points of around.csv are outside unit.obj\.' "$work/poking/summary.md" "$work/poking/index.html" | cut -d: -f2 | tr '\n' ' ')" = '1 1 ' ] || fail 'the report says nothing of points outside'
zcat "$work/poking/summary.json.gz" | grep -q '"points outside":"1 of 3"' || fail 'summary.json.gz says nothing of points outside'
poking around.csv --strict
[ $? -eq 1 ] || fail 'points outside with --strict'
poking inside.csv --strict || fail "a point inside with --strict: $(cat "$work/stderr")"
grep -q outside "$work/stderr" && fail "no point is outside: $(cat "$work/stderr")"

[ $failures -eq 0 ] && echo "all of the command line answers as it should"
exit $failures
