#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Help and version as commands, the field's words, the list's groups, and embedded cages as files.
# Usage: help_and_list_test.sh PATH_OF_CAGEPROOF
. "$(dirname "$0")/support.sh"

# The commands help and version print the same as the options --help and --version.
"$cageproof" --help >program.txt || fail --help
"$cageproof" help | cmp -s - program.txt || fail 'help is not --help'
for command in $(sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p' program.txt); do
  "$cageproof" "$command" --help >one.txt || fail "$command --help"
  "$cageproof" help "$command" | cmp -s - one.txt || fail "help $command is not $command --help"
done
"$cageproof" --version >version.txt || fail --version
for asked in version -V; do "$cageproof" $asked | cmp -s - version.txt || fail "$asked is not --version"; done
refuses_to help "unknown command 'lst'" "did you mean 'list'?" -- lst
refuses_to help "unknown command 'frobnicate'" 'known: list, eval' -- frobnicate
refuses_to help "unexpected 'eval'" -- list eval
refuses_to version "unexpected 'list'" -- list

# Options stand under headings, required choices first, each option once.
"$cageproof" help deform >deform.txt
[ "$(sed -n '2s/ --cage.*//p;4p;5s/  *CAGE .*//p' deform.txt)" = "$(printf '%s\n' 'Usage: cageproof deform (--posed CAGE | --constraints FILE)' 'The pose: exactly one of these:' '  --posed')" ] || fail "help deform: $(head -n 5 deform.txt)"
[ "$(grep -x '[A-Z][^.]*:' deform.txt | tr '\n' ' ')" = 'The pose: exactly one of these: Cage and points: Method: Output: Running: Other options: Examples: ' ] ||
  fail "headings of deform: $(grep -x '[A-Z].*:' deform.txt)"
for command in list coordinates deform verify field bench; do
  "$cageproof" help $command | grep -oE '^  (-h,)?--[a-z,-]+' | sort | uniq -d | grep . && fail "help $command has options twice"
  "$cageproof" help $command | grep -E '\[(OPTIONS|Option Group|SUBCOMMAND)' && fail "help $command has the parser's words"
done
for command in coordinates deform verify bench; do "$cageproof" help $command | grep -A1 '^  --points ' | grep -q 'y points up' || fail "help $command does not say where y points"; done
"$cageproof" man >page || fail man
[ "$(grep -n -m 1 '^\\fIThe pose: exactly one of these\\fR$' page | cut -d: -f 1)" -lt "$(grep -n -m 1 'fB.-.-posed' page | cut -d: -f 1)" ] || fail 'the manual has no heading above --posed'

# The field's words, where one name is asked for and in lists.
printf '0 0 0\n' >one.csv
refuses_to coordinates "unknown kind of coordinates 'mvc'" "it is called 'mean_value' here" -- --cage cube --points one.csv --kind mvc
refuses_to coordinates "it is called 'quad_mean_value' here" -- --cage cube --points one.csv --kind QMVC
refuses_to coordinates "it is called 'biharmonic_boundary' or 'elastic' or 'harmonic' or 'triharmonic_boundary' here" -- --cage cube --points one.csv --kind bem
refuses_to coordinates 'Wachspress coordinates need convex cages' -- --cage cube --points one.csv --kind wachspress
refuses_to deform "it is called 'green' here" -- --cage cube --posed cube --points one.csv --method gc --out out.obj
refuses_to deform "it is called 'cauchy' here" -- --cage cube --posed cube --points one.csv --method cauchy-green --out out.obj
refuses_to deform 'bounded biharmonic weights need a mesh of the inside' -- --cage cube --posed cube --points one.csv --method bbw --out out.obj
refuses_to deform "here that is 'single_layer', and no deformer" -- --cage cube --posed cube --points one.csv --method psi --out out.obj
refuses_to eval "it is called 'triangle.solid_angle' or 'quad.solid_angle' or 'segment.winding_angle' here" -- --formula winding --evaluation closed_form
refuses_to eval "it is called 'certified' here" -- --formula triangle.solid_angle --evaluation arb
refuses_to list "it is called 'maximum_entropy' here" -- mec
refuses_to benchmark "unknown command 'benchmark'; it is called 'bench' here" --
refuses_to mvc "here that is 'mean_value', and no command" --
# A near name is still found, and a word of the field goes before it.
refuses_to coordinates "did you mean 'green'?" -- --cage cube --points one.csv --kind gren

# Words lead to names, and every kind and method says what it is good for.
"$cageproof" list --json >catalogue.json || fail 'list --json'
python3 - "$(sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p' program.txt | tr '\n' ' ')" <<'EOF' || fail 'the catalogue'
import json, sys
catalogue = json.load(open("catalogue.json"))
names = set(sys.argv[1].split())
for group in ("formulas", "coordinates", "deformers"):
    names |= {row["name"] for row in catalogue[group]}
for formula in catalogue["formulas"]:
    names.add(formula["name"].split(".")[1])
    names |= {evaluation["name"] for evaluation in formula["evaluations"]}
for word in catalogue["words"]:
    for name in word["here"]:
        if name not in names: sys.exit(f"{word['word']}: nothing is called {name}")
    for name in names:
        if word["word"].replace("-", "_") == name and name not in word["here"]: sys.exit(f"{name} means something else as a word")
for group in ("coordinates", "deformers"):
    lines = [row["good_for"] for row in catalogue[group]]
    for row in catalogue[group]:
        if not row["good_for"]: sys.exit(f"{row['name']} is good for nothing")
    if len(set(lines)) != len(lines): sys.exit(f"two {group} are good for the same")
EOF

# Ends of ranges are included where the list says so: of formulas, and of a kind.
python3 - "$cageproof" <<'EOF' || fail 'ends of ranges'
import json, subprocess, sys
catalogue = json.load(open("catalogue.json"))
elements = {"segment": [[0, 0], [1, 0]], "triangle": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "quad": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]}
asked = 0
def ends(p):
    return (("lowest_included", p["lowest"]), ("highest_included", p["highest"]), ("infinity_included", "inf"))
for formula in catalogue["formulas"]:
    element = elements[formula["element"]]
    for p in formula["parameters"]:
        lines = [json.dumps({"element": element, "point": [0.25, 0.5, 1][: len(element[0])], "parameters": {p["name"]: value}}) for _, value in ends(p)]
        name = next(e["standard"][0] for e in formula["evaluations"] if e["standard"])
        ended = subprocess.run([sys.argv[1], "eval", "--formula", formula["name"], "--evaluation", name], input="\n".join(lines), capture_output=True, text=True)
        for (end, value), line in zip(ends(p), ended.stdout.splitlines()):
            asked += 1
            if ("error" in json.loads(line)) == p[end]: sys.exit(f"{formula['name']}: {p['name']} = {value}, {end} {p[end]}: {line}")
for kind in catalogue["coordinates"]:
    for p in kind["parameters"]:
        if kind["name"] != "somigliana" or p["name"] != "nu": continue
        for end, value in ends(p):
            asked += 1
            ended = subprocess.run([sys.argv[1], "coordinates", "--cage", "cube", "--points", "one.csv", "--kind", kind["name"], "--parameter", f"{p['name']}={value}"], capture_output=True)
            if (ended.returncode == 0) != p[end]: sys.exit(f"{kind['name']}: {p['name']} = {value}, {end} {p[end]}: {ended.stderr}")
if asked < 12: sys.exit(f"{asked} ends only")
EOF

# Groups.
"$cageproof" list >list.txt || fail list
for heading in 'coordinates in space and in the plane' 'coordinates in space' 'coordinates in the plane' 'deformers by posed cages in space and in the plane' \
  'deformers by posed cages in space' 'deformers by posed polygons' 'deformers by constraints'; do
  [ "$(grep -cx "$heading:" list.txt)" -eq 1 ] || fail "list has no group '$heading'"
done
# in_group NAME HEADING: whether the row of that name is the heading's.
in_group() {
  awk -v name="$1" -v heading="$2:" '/^[a-z]/ {group = $0} $1 == name && /^    [a-z]/ && group == heading {found = 1} END {exit !found}' list.txt ||
    fail "list: $1 is not of '$2'"
}
in_group mean_value 'coordinates in space and in the plane'
in_group maximum_entropy 'coordinates in space'
in_group cauchy 'coordinates in the plane'
in_group green 'deformers by posed cages in space and in the plane'
in_group spherical_mean_value 'deformers by posed cages in space'
in_group elastic 'deformers by posed cages in space and in the plane'
in_group cauchy 'deformers by posed polygons'
in_group thickness 'deformers by constraints'
[ "$(grep -c '^    [a-z_0-9]* (' list.txt)" -eq "$(grep -c '"good_for"' <(sed '/"deformers"/,$d' catalogue.json))" ] || fail 'list leaves out a kind, or has it twice'
"$cageproof" list mean_value >list.txt || fail 'list mean_value'
[ "$(grep -c '^        ' list.txt)" -eq 2 ] && in_group mean_value 'coordinates in space and in the plane' || fail "list mean_value: $(cat list.txt)"
grep -q '^coordinates in space:' list.txt && fail 'an empty group has a heading'

# Embedded cages as files are the same cages.
# as_files CAGE POINT EXTENSIONS...
as_files() {
  local cage=$1 point=$2 extension
  shift 2
  printf '%s\n' "$point" >point.csv
  "$cageproof" coordinates --cage "$cage" --points point.csv --kind mean_value >embedded.csv 2>/dev/null || fail "$cage: coordinates"
  for extension in "$@"; do
    "$cageproof" list --cage "$cage" --out "cage.$extension" 2>stderr || fail "$cage as $extension: $(cat stderr)"
    "$cageproof" coordinates --cage "cage.$extension" --points point.csv --kind mean_value >read.csv 2>stderr || fail "$cage as $extension is not read: $(cat stderr)"
    cmp -s embedded.csv read.csv || fail "$cage as $extension is another cage"
  done
}
as_files cube '0.1 0.2 0.3' obj ply vtp
as_files l-block '0.25 0.25 0.25' obj ply vtp
as_files icosphere '0.1 0.2 0.3' obj ply vtp
as_files thin-wall-1e-3 '0.1 0.2 -0.3' obj ply vtp
as_files square '0.1 0.2' obj svg vtp
as_files frame '0.1 0.2' obj svg vtp
as_files comb '0.1 0.2' obj svg vtp
"$cageproof" list --cage cube --out cube.stl 2>stderr || fail 'the cube as STL'
"$cageproof" coordinates --cage cube.stl --points one.csv --kind mean_value >stdout 2>stderr || fail "the cube as STL is not read: $(cat stderr)"
rm -f cage.* cube.stl
refuses_to list '--out cube.svg: a cage in space is written as .obj, .ply, .stl, .vtp' -- --cage cube --out cube.svg
refuses_to list '--out square.ply: a polygon is written as .obj, .svg, .vtp' -- --cage square --out square.ply
refuses_to list '--out cube: a cage in space is written as' -- --cage cube --out cube
refuses_to list 'in the single precision of STL it is no cage: thin-wall-1e-12: ' -- --cage thin-wall-1e-12 --out thin.stl
refuses_to list "unknown embedded cage 'cub'; did you mean 'cube'?" -- --cage cub --out cube.obj
refuses_to list nowhere -- --cage cube --out nowhere/cube.obj
refuses_to list '--out' -- --cage cube
refuses_to list '--cage' -- --out cube.obj
refuses_to list '--json' -- --cage cube --out cube.obj --json

[ $failures -eq 0 ] && echo "help, list and words are as they say"
exit $failures
