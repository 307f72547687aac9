#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Forms that people use, judged: what docs/judged.md says of each is found. And whole cages: the template is clean, bad use is refused.
# Usage: judged_test.sh PATH_OF_CAGEPROOF FOLDER_OF_JUDGE [long]: `long` also compiles adapters that take a minute.
. "$(dirname "$0")/support.sh"
export CAGEPROOF_TRUTH_CACHE=off
folder=$2

# Judges code, and wants these findings and no others. $1: library or command, $2: findings, the rest: options.
finds_in() {
  local what=$1 wanted=$2 found
  shift 2
  "$cageproof" judge mine="$what" --samples 30 --quiet "$@" >stdout 2>stderr
  found=$(sed -n 's/^DEFECT \([^,:]*\).*/\1/p' stdout | sort -u | tr '\n' ' ')
  [ "$found" = "$wanted" ] || fail "$what: $found, not $wanted: $(cat stdout stderr)"
}

# The same of an adapter. $1: its name.
finds() {
  local adapter=$1
  shift
  [ -f "$adapter.so" ] || cc -O2 -std=c99 -shared -fPIC -I "$folder/include" "$folder/adapters/$adapter.c" -o "$adapter.so" -lm || fail "$adapter does not compile"
  finds_in "./$adapter.so" "$@"
}
finds solid_angle 'far_cancellation outer_limit_on_face wrong_values '
finds polyhedron_gravity 'far_cancellation log_next_to_edge '
finds graglia_potential 'absolute_threshold far_cancellation wrong_values '
finds urago_layers 'absolute_threshold far_cancellation nan_at_edge nan_at_vertex plane_branch projected_into_face wrong_values '
finds ju_mean_value 'absolute_threshold wrong_on_cage ' --kind mean_value
vtk=$(find /usr/include -maxdepth 1 -name 'vtk-*' | sort | tail -1)
if [ -n "$vtk" ]; then
  version=${vtk##*vtk-}
  c++ -O2 -shared -fPIC -I "$folder/include" -isystem "$vtk" "$folder/adapters/vtk_mean_value.cpp" -o vtk_mean_value.so \
    -lvtkFiltersGeneral-"$version" -lvtkCommonDataModel-"$version" -lvtkCommonCore-"$version" || fail "the adapter of VTK does not compile"
  finds vtk_mean_value 'absolute_threshold wrong_on_cage ' --kind mean_value
fi

# A program of its own: CGAL's headers are under the GPL.
c++ -O1 -DNDEBUG "$folder/adapters/cgal_mean_value.cpp" -o cgal_mean_value -lgmp || fail "the adapter of CGAL does not compile"
finds_in './cgal_mean_value fast' 'not finite ' --kind mean_value --dimension 2
finds_in ./cgal_mean_value '' --kind mean_value --dimension 2 --out cgal
/usr/bin/python3 - <<'END' || fail "CGAL's digits"
import json
rows = {row["regime"]: row for row in json.load(open("cgal/certificate.json"))["formulas"][0]["rows"]}
assert rows["inside"]["digits"] > 11 and rows["on-edge"]["digits"] > 15 and rows["near-edge"]["digits"] < 9, rows
END

if [ "${3:-}" = long ]; then
  c++ -O1 -isystem "$vtk" "$folder/adapters/vtk_polygons.cpp" -o vtk_polygons -lvtkFiltersGeneral-"$version" -lvtkCommonDataModel-"$version" \
    -lvtkCommonCore-"$version" || fail "the adapter of VTK's polygons does not compile"
  finds_in ./vtk_polygons 'absolute_threshold wrong_values ' --kind spherical_mean_value
  c++ -O1 -DNDEBUG "$folder/adapters/cgal_rational.cpp" -o cgal_rational -lgmp || fail "the adapter of CGAL's rational coordinates does not compile"
  for kind in wachspress discrete_harmonic; do
    for policy in precise fast; do
      /usr/bin/python3 "$folder/adapters/rational_polygons.py" $kind ./cgal_rational $kind $policy >stdout || fail "$kind, $policy: $(cat stdout)"
      awk '$5 > 1e-15 || $6 {exit 1} END {exit NR != 7}' stdout || fail "$kind, $policy: $(cat stdout)"
    done
  done
  c++ -O2 -DNDEBUG "$folder/adapters/cgal_side.cpp" -o cgal_side -lgmp || fail "the adapter of CGAL's sides does not compile"
  finds_in ./cgal_side '' --kind inside
  c++ -O2 -DNDEBUG -DDOUBLES "$folder/adapters/cgal_side.cpp" -o cgal_side_doubles -lgmp || fail "the adapter of CGAL's sides in doubles does not compile"
  finds_in ./cgal_side_doubles 'wrong side ' --kind inside
fi

# Sides: exact rays are right, thresholds wrong next to cages, and who counts windings is wrong on cages only, in space and in the plane.
for dimension in 3 2; do
  finds_in "$folder/zoo/sides.py exact" '' --kind inside --dimension $dimension
  finds_in "$folder/zoo/sides.py threshold" 'wrong side ' --kind inside --dimension $dimension --regimes 'generic,near-*,units,on-vertex'
  grep -q ': on-vertex' stdout && fail "a threshold in $dimension dimensions is wrong on vertices, too: $(cat stdout)"
  finds_in "$folder/zoo/sides.py windings" 'wrong side ' --kind inside --dimension $dimension --out sides
  grep -q '^sides of cages$' stdout || fail "no table of sides: $(cat stdout)"
  /usr/bin/python3 - <<'END' || fail "certificate.json of sides in $dimension dimensions"
import json
(found,) = json.load(open("sides/certificate.json"))["formulas"]
wrong = {row["regime"]: row["wrong"] for row in found["rows"]}
assert found["kind"] == "inside" and all(wrong[regime] > 0 for regime in wrong if regime.startswith("on-")), wrong
assert not any(wrong[regime] for regime in ("generic", "far", "units", "offset")), wrong
END
done
refuses_to judge '--promise bounds errors of numbers' -- mine=./ju_mean_value.so --kind inside --promise 1e-3
refuses_to judge "unknown regime 'inside'" -- mine=./ju_mean_value.so --kind inside --regimes inside
refuses_to judge 'has no function for' -- mine=./ju_mean_value.so --kind spherical_mean_value

# The template is clean, and its certificate has the kind.
"$cageproof" judge --template python-cage >/dev/null && "$cageproof" judge mine=./mine_cage.py --kind mean_value --samples 10 --out certificate >stdout 2>stderr ||
  fail "the example of cages: $(cat stdout stderr)"
grep -q '^mine: clean; 10 samples a regime, mean_value$' stdout || fail "verdict: $(cat stdout)"
/usr/bin/python3 - <<'END' || fail "certificate.json of a kind"
import json
(rows,) = [f["rows"] for f in json.load(open("certificate/certificate.json"))["formulas"] if f["kind"] == "mean_value"]
assert len(rows) == 9 and all(row["samples"] == 10 for row in rows), rows
assert rows[1]["conditioned"]["input"]["kind"] == "mean_value"
END
"$cageproof" judge mine=./mine_cage.py --kind mean_value --dimension 2 --samples 10 --out plane >stdout 2>stderr || fail "the example of polygons: $(cat stdout stderr)"
grep -q '^mine: clean; 10 samples a regime, mean_value in the plane$' stdout || fail "verdict in the plane: $(cat stdout)"
/usr/bin/python3 - <<'END' || fail "certificate.json of a kind in the plane"
import json
(found,) = json.load(open("plane/certificate.json"))["formulas"]
assert found["dimension"] == 2 and [row["regime"] for row in found["rows"]] == ["inside", "near-edge", "near-vertex", "on-edge", "on-vertex", "units", "offset"], found
assert all(row["samples"] == 10 for row in found["rows"]) and max(row["conditioned"]["worst"] for row in found["rows"]) < 64, found
assert {len(face) for face in found["rows"][0]["conditioned"]["input"]["faces"]} == {2}, found
END
refuses_to judge 'somigliana has matrices' -- mine=./mine_cage.py --kind somigliana
refuses_to judge 'somigliana has matrices' -- mine=./mine_cage.py --kind somigliana --dimension 2
refuses_to judge 'cauchy is no sum over segments' -- mine=./mine_cage.py --kind cauchy --dimension 2
refuses_to judge "unknown regime 'near-face'" -- mine=./mine_cage.py --kind mean_value --dimension 2 --regimes near-face
refuses_to judge 'dimension' 'kind' -- mine=./mine_cage.py --dimension 2
refuses_to judge 'dimension' -- mine=./mine_cage.py --kind mean_value --dimension 4
refuses_to judge "unknown kind of coordinates 'mean_values'" -- mine=./mine_cage.py --kind mean_values
refuses_to judge 'quad_green is no sum over triangles' -- mine=./mine_cage.py --kind quad_green
refuses_to judge "unknown regime 'generic'" -- mine=./mine_cage.py --kind mean_value --regimes generic
refuses_to judge '--formula' -- mine=./mine_cage.py --kind mean_value --formula triangle.single_layer

[ "$failures" -eq 0 ] || exit 1
echo "judged: ok"
