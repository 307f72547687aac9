#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Meshes deformed from the command line, and how that is refused. Usage: deform_test.sh PATH_OF_CAGEPROOF
# shellcheck source=support.sh
source "$(dirname "$(readlink -f "$0")")/support.sh"

# refuses WORDS... -- ARGUMENTS of deform...
refuses() { refuses_to deform "$@"; }

# The embedded cube, a pose that is twice as large, and a mesh in it: a quad and a triangle.
cat >large.obj <<'OBJ'
v -1 -1 -1
v 1 -1 -1
v -1 1 -1
v 1 1 -1
v -1 -1 1
v 1 -1 1
v -1 1 1
v 1 1 1
OBJ
cat >mesh.obj <<'OBJ'
v 0.25 0.125 0
v 0.375 0.125 0
v 0.375 0.25 0
v 0.25 0.25 0.125
v 0 0 0.25
f 1 2 3 4
f 1 3 5
OBJ
common=(--cage cube --posed large.obj --points mesh.obj)

"$cageproof" deform "${common[@]}" --method mean_value --out moved.obj || fail "a mesh"
grep -q '^f 1 2 3 4$' moved.obj || fail "the quad is lost: $(cat moved.obj)"
[ "$(grep -c '^f ' moved.obj)" -eq 2 ] || fail "faces are lost"
# Images of the first vertex are at twice its place.
awk '$1 == "v" {d = ($2 - 0.5) ^ 2 + ($3 - 0.25) ^ 2 + $4 ^ 2; exit !(d < 1e-28)}' moved.obj || fail "not twice as large: $(cat moved.obj)"
grep -q '"method": "mean_value"' moved.json || fail "no report beside it"
grep -q '"cage_volume_ratio": 8.0' moved.json || fail "volumes: $(cat moved.json)"

# Several values of parameters give as many maps of each pose, numbered in their order, each as if it were the only one.
sed 's/^v 1 1 1$/v 1.5 1 1.25/' large.obj >bent.obj
# The report on one of the maps in a file.
report_on() { /usr/bin/python3 -c 'import json, sys; print(json.dumps(json.load(open(sys.argv[1]))["frames"][int(sys.argv[2]) - 1]))' "$@"; }
swept=(--cage cube --posed bent.obj --points mesh.obj --method somigliana)
"$cageproof" deform "${swept[@]}" --posed large.obj --parameter nu=0,0.25 --parameter gamma=0,1 --out 'swept_{n}.csv' || fail "a sweep"
[ "$(ls swept_*.csv | wc -l)" -eq 8 ] || fail "$(ls swept_*.csv | wc -l) maps, not 8"
for map in 1:0.0:0.0 2:0.0:1.0 3:0.25:0.0 4:0.25:1.0; do
  IFS=: read -r n nu gamma <<<"$map"
  "$cageproof" deform "${swept[@]}" --parameter "nu=$nu" --parameter "gamma=$gamma" --out alone.csv || fail "alone"
  for other in 1 2 3 4; do
    same=$(paste -d, "swept_$other.csv" alone.csv | awk -F, 'NR > 1 {++rows; for (i = 1; i <= 3; ++i) {d = $i - $(i + 3); if (!(d * d < 1e-26)) differs = 1}} END {print rows == 5 && !differs}')
    [ "$same" -eq $((other == n)) ] || fail "map $other is $same that of nu $nu, gamma $gamma"
  done
  report_on swept.json "$n" >report
  grep -q "\"nu\": $nu," report || fail "nu of map $n: $(cat report)"
  grep -q "\"gamma\": $gamma," report || fail "gamma of map $n: $(cat report)"
  grep -q 'bent.obj' report || fail "the pose of map $n"
  report_on swept.json $((n + 4)) | grep -q 'large.obj' || fail "the pose of map $((n + 4))"
done
mv bent.obj pulled_far.obj

# Materials, groups and texture coordinates of a mesh stay, or are named where they do not.
{ printf 'mtllib paint.mtl\nvt 0 0\nvn 0 0 1\ng front\n' && sed 's#^f 1 2 3 4#f 1/1/1 2/1/1 3/1/1 4/1/1#' mesh.obj; } >painted.obj
"$cageproof" deform --cage cube --posed large.obj --points painted.obj --method mean_value --out kept.obj 2>said || fail "a painted mesh"
for line in 'mtllib paint.mtl' 'g front' 'f 1/1 2/1 3/1 4/1' 'f 1 3 5'; do grep -qx "$line" kept.obj || fail "lost: $line"; done
grep -qx 'warning: painted.obj: left out: normals, which turn with the surface' said || fail "no note of normals: $(cat said)"
"$cageproof" deform --cage cube --posed large.obj --points painted.obj --method mean_value --out kept.ply 2>said || fail "a painted mesh as PLY"
grep -q '^warning: painted.obj: left out: materials, texture coordinates, normals, groups, since .ply files' said || fail "no note: $(cat said)"
# A PLY has the digits of an OBJ.
"$cageproof" deform --cage cube --posed cube --points kept.ply --method mean_value --outside rest --out again.csv || fail "a PLY read again"
"$cageproof" deform --cage cube --posed cube --points kept.obj --method mean_value --outside rest --out other.csv || fail "an OBJ read again"
cmp -s again.csv other.csv || fail "PLY and OBJ differ"

# STL: triangles of the faces, in single precision, of which a warning tells once.
"$cageproof" deform "${common[@]}" --posed cube --method mean_value --out 'moved_{n}.stl' 2>said || fail "STL"
[ "$(wc -c <moved_1.stl)" -eq $((84 + 3 * 50)) ] || fail "not three triangles: $(wc -c <moved_1.stl) bytes"
[ "$(cat said)" = 'warning: mesh.obj: STL is single precision: coordinates are rounded to about 7 digits' ] || fail "warnings of STL: $(cat said)"
report_on moved.json 1 | grep -q '"method": "mean_value"' || fail "no report beside an STL"
"$cageproof" deform --cage cube --posed cube --points moved_2.stl --method mean_value --out again.obj || fail "an STL read again"
[ "$(grep -c '^v ' again.obj) $(grep -c '^f ' again.obj)" = '5 3' ] || fail "not the same surface: $(cat again.obj)"
awk '$1 == "v" {print $1, $2 * 1e39, $3 * 1e39, $4 * 1e39}' large.obj >huge.obj
rm -f moved_* said

# SVG: polylines of the plane, which are read again as they were written.
printf '<svg><path d="M.1,.9 L.1,.2 .3333333333333333,.1z"/><polyline points=".5 .5 .7 .9"/></svg>\n' >drawn.svg
awk 'BEGIN {print "-0.5,0.5"; print "0.5,0.25"; print "0.25,1.5"; print "-0.5,1.25"}' >bent_square.csv
"$cageproof" deform --cage square --posed bent_square.csv --points drawn.svg --outside rest --method mean_value --out bent.svg 2>/dev/null || fail "SVG"
"$cageproof" deform --cage square --posed bent_square.csv --points drawn.svg --outside rest --method mean_value --out bent.csv 2>/dev/null || fail "SVG as CSV"
[ "$(grep -c '<path.* Z"' bent.svg) $(grep -c '<path' bent.svg)" = '1 2' ] || fail "polylines: $(cat bent.svg)"
"$cageproof" deform --cage square --posed square --points bent.svg --outside rest --method mean_value --out again.obj 2>/dev/null || fail "an SVG read again"
[ "$(grep -c '^l ' again.obj)" -eq 4 ] || fail "segments: $(cat again.obj)"
rm -f bent.* bent_square.csv

# A PLY that is written from a PLY keeps its comments, properties and elements, a VTP its arrays.
{
  printf 'ply\nformat ascii 1.0\ncomment TextureFile skin.png\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\n'
  printf 'property float ny\nproperty float nz\nproperty uchar red\nelement face 1\nproperty list uchar int vertex_indices\nproperty float quality\nend_header\n'
  printf '0 0 0 0 0 1 7\n0.25 0 0 0 0 1 8\n0 0.25 0 0 0 1 9\n3 0 1 2 0.5\n'
} >scan.ply
"$cageproof" deform --cage cube --posed large.obj --points scan.ply --method mean_value --out kept.ply 2>said || fail "a PLY of a PLY"
[ "$(cat said)" = 'warning: scan.ply: left out: normals, which turn with the surface' ] || fail "warnings of PLY: $(cat said)"
for line in 'comment TextureFile skin.png' 'property double x' 'property uchar red' 'property float quality' '3 0 1 2 0.5'; do grep -qx "$line" kept.ply || fail "lost: $line"; done
grep -q 'property float n' kept.ply && fail "normals stay: $(cat kept.ply)"
awk 'NF == 4 && $4 == 8 {found = ($1 - 0.5) ^ 2 + $2 ^ 2 + $3 ^ 2 < 1e-28} END {exit !found}' kept.ply || fail "not twice as large: $(cat kept.ply)"
cat >scan.vtp <<'VTP'
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>
<Piece NumberOfPoints="3" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="1">
<PointData Scalars="heat"><DataArray type="Int16" Name="heat" format="ascii">7 8 9</DataArray>
<DataArray type="Float32" Name="Normals" NumberOfComponents="3" format="ascii">0 0 1 0 0 1 0 0 1</DataArray></PointData>
<CellData><DataArray type="UInt8" Name="part" format="ascii">5</DataArray></CellData>
<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 0.25 0 0 0 0.25 0</DataArray></Points>
<Polys><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2</DataArray><DataArray type="Int32" Name="offsets" format="ascii">3</DataArray></Polys>
</Piece></PolyData></VTKFile>
VTP
"$cageproof" deform --cage cube --posed large.obj --points scan.vtp --method mean_value --out kept.vtp 2>said || fail "a VTP of a VTP"
[ "$(cat said)" = 'warning: scan.vtp: left out: normals, which turn with the surface' ] || fail "warnings of VTP: $(cat said)"
for array in 'type="Int16" Name="heat"' 'type="UInt8" Name="part"' 'type="Float64" Name="Points"' 'Name="image \[1\]"'; do grep -qa "$array" kept.vtp || fail "no $array"; done
grep -qa Normals kept.vtp && fail "normals stay in a VTP"
"$cageproof" deform --cage cube --posed cube --points kept.vtp --method mean_value --outside rest --out again.vtp 2>said || fail "a VTP read again"
grep -qx 'warning: kept.vtp: left out: array image \[1\], in whose place this run.s stand' said || fail "no word of an array: $(cat said)"

# A posed cage that numbers its vertices otherwise says so by its faces.
printf 'f 1 2 8\nf 2 3 4\n' | cat large.obj - >numbered.obj
"$cageproof" deform --cage cube --posed numbered.obj --points mesh.obj --method mean_value --out numbered.csv 2>said || fail "a pose with other faces"
grep -q '^warning: numbered.obj: face [01] (line [0-9]*) joins vertices .* numbered otherwise' said || fail "no warning: $(cat said)"
refuses 'numbered.obj' 'numbered otherwise' -- --cage cube --posed numbered.obj --points mesh.obj --method mean_value --strict --out n.csv

# An order that coordinates do not have is refused before the pose is read, or anything is solved.
refuses 'order 1' 'quad_mean_value by riemann-4' 'order 0' -- --cage cube --posed nowhere.obj --points mesh.obj --method quad_mean_value --evaluation riemann-4 --order 1 --out o.csv
"$cageproof" deform "${common[@]}" --method ahap --parameter alignment=hard,free --out 'swept_{n}.csv' || fail "a sweep of names"
report_on swept.json 2 | grep -q '"alignment": "free"' || fail "no alignment: $(cat swept.json)"
rm -f swept* alone.* report
refuses '2 maps' '{n}' -- "${common[@]}" --method somigliana --parameter nu=0,0.25 --out one.csv
refuses '25000000 combinations' '10000' -- "${common[@]}" --method somigliana --parameter "nu=$(seq -s, 0 0.00009 0.44995)" --parameter "gamma=$(seq -s, 0 0.0001 0.4999)" --out '{n}.csv'
refuses 'somigliana' 'other coordinates' -- "${common[@]}" --method somigliana --evaluation as-printed-eq48 --parameter nu=0,0.25 --out '{n}.csv'
refuses 'map 2' 'number 0' 'not finite' -- --cage cube --posed pulled_far.obj --points mesh.obj --method somigliana --parameter gamma=0,900000 --out '{n}.csv'
refuses '0 <= gamma_d' -- "${common[@]}" --method biharmonic_1_3 --parameter gamma_d=-1 --out one.csv
refuses 'nu' 'not a number' -- "${common[@]}" --method somigliana --parameter nu=0,,0.25 --out '{n}.csv'
refuses 'nu' 'out of range' -- "${common[@]}" --method somigliana --parameter nu=0,0.5 --out '{n}.csv'
refuses 'neumann' 'biharmonic_1_3' 'one value' -- "${common[@]}" --method biharmonic_1_3 --parameter neumann=constant,affine --out '{n}.csv'
refuses '0.5 is out of range' -- "${common[@]}" --method somigliana --parameter nu=0,0.5 --out '{n}.csv'
refuses 'alpha' 'not a number' -- --cage cube --constraints large.obj --points mesh.obj --method variational --parameter alpha=1,2 --out one.csv

# A warning of one map names it, and is said once.
"$cageproof" deform "${common[@]}" --method biharmonic_1_3 --parameter level=0,1 --out 'level_{n}.csv' 2>stderr || fail "levels"
[ "$(grep -c 'level_1.csv: .*deficient rank' stderr)" -eq 1 ] || fail "no word of level 0: $(cat stderr)"
grep -q 'level_2.csv' stderr && fail "a word of level 1: $(cat stderr)"
rm -f level_* stderr

# Coordinates of an element's corner are named by both.
"$cageproof" coordinates --cage cube --points mesh.obj --kind biharmonic_affine --out corners.csv || fail "coordinates of corners"
head -1 corners.csv | grep -q 'phi_7,psi_0_0,psi_0_1,psi_0_2,psi_1_0,.*psi_11_2,phibar_0' || fail "names of corners: $(head -1 corners.csv)"

# One line per corner of each triangle.
for i in $(seq 36); do echo "0 0 1"; done >corners.txt
"$cageproof" deform "${common[@]}" --method biharmonic_1_3 --parameter neumann=affine --normal-derivatives corners.txt --out bent.csv || fail "affine normal derivatives"
whole=$(tr -d ' \n' <bent.json)
grep -q '"triangulation":"shortest"' <<<"$whole" || fail "no triangulation: $whole"
[ "$(grep -o '"elements":\[\(\[[0-7],[0-7],[0-7]\],\?\)*\]' <<<"$whole" | grep -o '\[[0-7],' | wc -l)" -eq 12 ] || fail "not twelve triangles: $whole"
refuses 'corners.txt' '36 rows' '12 elements' -- "${common[@]}" --method biharmonic_1_3 --normal-derivatives corners.txt --out one.csv
head -12 corners.txt >few.txt
refuses 'few.txt' '12 rows' '36 corners' -- "${common[@]}" --method biharmonic_1_3 --parameter neumann=affine --normal-derivatives few.txt --out one.csv
rm -f bent.* few.txt corners.txt

# Several poses in one run, each as by itself; every format; derivatives next to a mesh.
"$cageproof" deform "${common[@]}" --posed cube --method green --out 'both_{n}.csv' || fail "two poses"
"$cageproof" deform "${common[@]}" --method green --out one.csv
cmp -s both_1.csv one.csv || fail "the first of two poses is another"
[ "$(head -n 1 both_2.csv)" = x,y,z ] || fail "columns: $(head -n 1 both_2.csv)"
for format in ply vtp npy; do
  "$cageproof" deform "${common[@]}" --method tp --out "out.$format" || fail "$format"
done
"$cageproof" deform "${common[@]}" --method green --order 1 --out jacobians.obj --derivatives jacobians.csv || fail "derivatives"
[ "$(head -n 1 jacobians.csv)" = x,y,z,x_dx,x_dy,x_dz,y_dx,y_dy,y_dz,z_dx,z_dy,z_dz ] || fail "columns: $(head -n 1 jacobians.csv)"
grep -q '"largest_singular_value": 2.0' jacobians.json || fail "singular values: $(cat jacobians.json)"

# Written meshes can be read again, and are the same.
"$cageproof" deform "${common[@]}" --method mean_value --out again.ply && "$cageproof" deform --cage cube --posed cube --points again.ply --method mean_value --out again.obj || fail "a PLY is not read again"
grep '^f ' again.obj | cmp -s - <(grep '^f ' moved.obj) || fail "faces of a PLY: $(cat again.obj)"
awk '$1 == "v" {d = ($2 - 0.5) ^ 2 + ($3 - 0.25) ^ 2 + $4 ^ 2; exit !(d < 1e-12)}' again.obj || fail "vertices of a PLY: $(cat again.obj)"
"$cageproof" deform "${common[@]}" --posed cube --method green --out '{n}_{n}.csv' || fail "two numbers in a name"
[ -f 2_2.csv ] && [ -f maps.json ] || fail "not numbered twice: $(ls)"
# A mesh that is open has no volume; points on the cage no Jacobian.
grep -q '"mesh_volume_ratio": null' moved.json || fail "an open mesh with a volume: $(cat moved.json)"
printf '0.5,0.5,0.5\n0,0,0\n' >corner.csv
"$cageproof" deform --cage cube --posed large.obj --points corner.csv --method green --order 1 --out on_cage.csv 2>stderr || fail "a point at a corner"
grep -q '"points_without_jacobian": 1' on_cage.json || fail "the corner's Jacobian is not counted: $(cat on_cage.json)"
grep -q '1 points have images and no Jacobians' stderr && grep -q '1 points have images and no Jacobians' on_cage.json || fail "no warning of it: $(cat stderr)"

# The plane, by the same command.
printf '0,0\n2,0\n2,2\n0,2\n' >square.csv
printf '0.5,0.25\n' >points.csv
"$cageproof" deform --cage square --posed square --points points.csv --method somigliana --out still.csv || fail "the plane"

# Normal derivatives and Laplacians: with those of the map itself a stretch along z is exact, and Laplacians of one bend it.
printf '%s\n' '0 0 -3' '0 0 -3' '0 0 3' '0 0 3' '0 -1 0' '0 -1 0' '0 1 0' '0 1 0' '-1 0 0' '-1 0 0' '1 0 0' '1 0 0' >normals.txt
yes '1 1 1' | head -n 8 >ones.txt
awk '$1 == "v" {print $1, $2 / 2, $3 / 2, $4 * 1.5}' large.obj >tall.obj
stretched=(--cage cube --posed tall.obj --points mesh.obj --normal-derivatives normals.txt)
for method in green biharmonic_1_3 biharmonic_weber biharmonic_direct; do
  "$cageproof" deform "${stretched[@]}" --method $method --out stretched.csv || fail "$method with normal derivatives"
  awk -F, 'NR == 5 {d = ($1 - 0.25) ^ 2 + ($2 - 0.25) ^ 2 + ($3 - 0.375) ^ 2; exit !(d < 1e-24)}' stretched.csv || fail "$method, not stretched: $(cat stretched.csv)"
done
"$cageproof" deform "${stretched[@]}" --method biharmonic_direct --laplacians ones.txt --order 2 --out bent.csv || fail "densities"
awk -F, 'NR == 2 {d = $13 + $17 + $21 - 1; exit !(d ^ 2 < 1e-20)}' bent.csv || fail "the Laplacian is not one: $(cat bent.csv)"
grep -q '"normal_derivatives": "normals.txt"' bent.json || fail "no word of the normal derivatives: $(cat bent.json)"
refuses tp --normal-derivatives -- "${stretched[@]}" --method tp --out out.obj
refuses biharmonic_1_3 --laplacians -- "${common[@]}" --method biharmonic_1_3 --laplacians ones.txt --out out.obj
refuses green --laplacian-derivatives -- "${common[@]}" --method green --laplacian-derivatives normals.txt --out out.obj
refuses ones.txt '8 rows' '12 elements' -- "${common[@]}" --method green --normal-derivatives ones.txt --out out.obj

# Methods that keep quads: under the name of the triangulated method or their own, with one normal per corner.
sed 's/^v 1 1 1$/v 1.5 1 1.25/' large.obj >twisted.obj
kept=(--cage cube --posed twisted.obj --points mesh.obj)
for method in green biharmonic_1_3 somigliana mean_value; do
  "$cageproof" deform "${kept[@]}" --method $method --keep-quads --out kept.csv || fail "$method on quads"
  grep -q "\"method\": \"quad_$method\"" kept.json || fail "$method on quads by another name: $(cat kept.json)"
  grep -q '"triangulation": "none"' kept.json || fail "triangulated: $(cat kept.json)"
  "$cageproof" deform "${kept[@]}" --method quad_$method --out named.csv && cmp -s kept.csv named.csv || fail "quad_$method is another"
  "$cageproof" deform "${kept[@]}" --method quad_$method --triangulate fan --out named.csv && cmp -s kept.csv named.csv || fail "quad_$method has diagonals"
  "$cageproof" deform "${kept[@]}" --method $method --out named.csv && cmp -s kept.csv named.csv && fail "$method is not triangulated"
  "$cageproof" deform "${common[@]}" --method $method --keep-quads $([ $method = biharmonic_1_3 ] && echo --parameter normals=rms) --out kept.csv || fail "$method on quads, twice as large"
  awk -F, 'NR == 2 {d = ($1 - 0.5) ^ 2 + ($2 - 0.25) ^ 2 + $3 ^ 2; exit !(d < 1e-26)}' kept.csv || fail "$method, not twice as large: $(cat kept.csv)"
done
for n in '0 0 -1.5' '0 0 1.5' '0 -0.5 0' '0 0.5 0' '-0.5 0 0' '0.5 0 0'; do yes -- "$n" | head -n 4; done >corner_normals.txt
awk '$1 == "v" {print $1, $2 / 4, $3 / 4, $4 * 0.75}' large.obj >low.obj
"$cageproof" deform --cage cube --posed low.obj --points mesh.obj --method green --keep-quads --normal-derivatives corner_normals.txt --out kept.csv || fail "normals of corners"
awk -F, 'NR == 5 {d = ($1 - 0.125) ^ 2 + ($2 - 0.125) ^ 2 + ($3 - 0.1875) ^ 2; exit !(d < 1e-26)}' kept.csv || fail "quads are not stretched: $(cat kept.csv)"
refuses corner_normals.txt '24 rows' '12 elements' -- --cage cube --posed low.obj --points mesh.obj --method green --normal-derivatives corner_normals.txt --out kept.csv
refuses normals.txt '12 rows' '24 corners of quads, and triangles' -- "${kept[@]}" --method green --keep-quads --normal-derivatives normals.txt --out kept.csv
refuses tp 'bilinear quads' 'biharmonic_1_3, green, mean_value, somigliana' -- "${kept[@]}" --method tp --keep-quads --out kept.csv
refuses --keep-quads variational -- --cage cube --constraints large.obj --points mesh.obj --method variational --keep-quads --out kept.csv
refuses square 'polygons have no quads' -- --cage square --posed square --points points.csv --method green --keep-quads --out kept.csv
sed 's/^v 1 \(.*\)$/v -1 \1/' large.obj >flat.obj
refuses flat.obj 'the posed quad 0 ' 'has no area' -- --cage cube --posed flat.obj --points mesh.obj --method green --keep-quads --out kept.csv
"$cageproof" list --json | tr -d ' \n' | grep -q '"name":"quad_green","source":"[^"]*","keeps":"[^"]*","coordinates":"quad_green","keeps_quads":true' || fail "the catalogue does not say that quads are kept"
"$cageproof" list --json | tr -d ' \n' | grep -q '"coordinates":"green","keeps_quads":false' || fail "the catalogue does not say that quads are split"

# By constraints, without a posed cage: everything turned by a quarter about z.
cat >turned.json <<'JSON'
{"schema": "cageproof-constraints", "schema_version": 1,
 "positions": [{"at": [0.25, 0, 0], "to": [0, 0.25, 0]}, {"at": [-0.25, 0, 0], "to": [0, -0.25, 0]},
               {"at": [0, 0.25, 0], "to": [-0.25, 0, 0]}, {"at": [0, 0, 0.25], "to": [0, 0, 0.25]}],
 "orientations": [{"at": [0, 0, 0], "jacobian": [[0, -1, 0], [1, 0, 0], [0, 0, 1]]}],
 "rotations": [[0, 0, 0], [0.25, 0.25, 0.25]],
 "hessians": [[0.25, 0.125, 0], [-0.25, 0.125, 0.25], [0, 0, -0.25]]}
JSON
by_constraints=(--cage cube --constraints turned.json --points mesh.obj --method variational)
"$cageproof" deform "${by_constraints[@]}" --parameter subspace=harmonic --out moved.csv --energies energies.csv 2>stderr || fail "by constraints: $(cat stderr)"
awk -F, 'NR == 2 {d = ($1 + 0.125) ^ 2 + ($2 - 0.25) ^ 2 + $3 ^ 2; exit !(d < 1e-12)}' moved.csv || fail "not turned: $(cat moved.csv)"
grep -q '^step 1: energy ' stderr || fail "no progress: $(cat stderr)"
[ "$(head -n 1 energies.csv)" = number,energy ] || fail "energies: $(head -n 1 energies.csv)"
awk -F, 'NR > 2 && $2 > before * (1 + 1e-12) + 1e-28 {exit 1} {before = $2}' energies.csv || fail "the energy rises: $(cat energies.csv)"
[ "$(grep -c . energies.csv)" -gt 2 ] || fail "no energies"
"$cageproof" deform "${by_constraints[@]}" --out moved.obj --energies energies.png 2>/dev/null || fail "a picture of the energies"
head -c 4 energies.png | grep -q PNG || fail "energies.png is no picture"
refuses 'nu' '0.5' 'out of range' -- "${by_constraints[@]}" --parameter subspace=elastic --parameter nu=0.5 --out out.obj
refuses --poisson-ratio '--parameter nu' -- "${by_constraints[@]}" --stress s.csv --poisson-ratio 0.3 --out out.obj
refuses variational --constraints -- --cage cube --posed large.obj --points mesh.obj --method variational --out out.obj
refuses green --posed -- --cage cube --constraints turned.json --points mesh.obj --method green --out out.obj
refuses --energies -- "${common[@]}" --method green --energies out.csv --out out.obj
refuses .svg -- "${by_constraints[@]}" --energies out.svg --out out.obj
sed 's/"at": \[0, 0, 0\]/"at": [0, 0, 3]/' turned.json >far.json
refuses far.json 'orientations[0]' outside -- --cage cube --constraints far.json --points mesh.obj --method variational --out out.obj
sed 's/"hessians"/"hessian"/' turned.json >misspelt.json
refuses misspelt.json '"hessian"' -- --cage cube --constraints misspelt.json --points mesh.obj --method variational --out out.obj
sed 's/0.25, 0, 0\], "to"/0.25, 0\], "to"/' turned.json >short.json
refuses short.json 'positions[0].at' '3 numbers' -- --cage cube --constraints short.json --points mesh.obj --method variational --out out.obj
head -c 200 turned.json >cut.json
refuses cut.json malformed -- --cage cube --constraints cut.json --points mesh.obj --method variational --out out.obj
refuses variational --laplacians -- "${by_constraints[@]}" --laplacians ones.txt --out out.obj
refuses turned.json --out -- --cage cube --constraints turned.json --points mesh.obj --method variational --out turned.csv

# The plane's methods, and the posed cage that one of them finds.
printf '{"schema": "cageproof-constraints", "schema_version": 1, "positions": [{"at": [0.5, 0.5], "to": [0.5, 0.5]}, {"at": [0.25, 0.75], "to": [0.2, 0.8]}]}\n' >drawn.json
printf '0.3,0.6\n' >in_square.csv
"$cageproof" deform --cage square --constraints drawn.json --points in_square.csv --method thickness --out thick.csv 2>/dev/null || fail "thickness"
[ "$(grep -c '"posed_vertices"' thick.json)" -eq 1 ] && grep -q '"merits"' thick.json || fail "no posed cage, or no merits: $(cat thick.json)"
# Two targets for one position, which no pose meets: nothing is written.
sed 's/\]}$/, {"at": [0.25, 0.75], "to": [0.2, 0.9]}]}/' drawn.json >twice.json
refuses twice.json "not converged" "positions are missed by" -- --cage square --constraints twice.json --points in_square.csv --method thickness --quiet --out met.csv
[ -e met.csv ] && fail "images of a pose that was not found"
sed 's/0.75\]/7.5]/' drawn.json >outside.json
refuses outside.json 'positions[1]' outside -- --cage square --constraints outside.json --points in_square.csv --method thickness --out out.csv
refuses nosuch -- --cage square --constraints drawn.json --points in_square.csv --method thickness --evaluation nosuch --out out.csv
grep -q drawn.json stderr 2>/dev/null && fail "an evaluation that is none is blamed on the constraints"
for method in cauchy biharmonic_boundary; do
  "$cageproof" deform --cage square --posed square --points in_square.csv --method $method --out still.csv || fail "$method"
  awk -F, 'NR == 2 {exit !(($1 - 0.3) ^ 2 + ($2 - 0.6) ^ 2 < 1e-24)}' still.csv || fail "$method moves what stays: $(cat still.csv)"
done
"$cageproof" deform "${common[@]}" --method somigliana --parameter variant=blend --parameter blend=0.25 --out blend.csv || fail "blend"
"$cageproof" deform "${common[@]}" --method somigliana --parameter nu=inf --out inf.csv || fail "an infinite nu"
grep -q '"nu": "inf"' inf.json || fail "nu in the report: $(grep nu inf.json)"

# No file is written twice, nor one that is read.
refuses mesh.obj --points -- "${common[@]}" --method green --out mesh.obj
refuses large.obj --posed -- "${common[@]}" --method green --out ./large.obj
refuses same.csv --derivatives -- "${common[@]}" --method green --order 1 --out same.csv --derivatives same.csv

# All files or none, and nobody else's.
refuses 'the folder nowhere does not exist' -- "${common[@]}" --method green --order 1 --out fine.csv --derivatives nowhere/fine.csv
printf '{"a": 1}\n' >theirs.json
refuses theirs.json 'which is no such' -- "${common[@]}" --method green --out theirs.csv
mkdir folder.csv
refuses folder.csv -- "${common[@]}" --method green --order 1 --out fine.csv --derivatives folder.csv
rmdir folder.csv

# Points outside.
printf '0,0,0\n3,0,0\n' >outside.csv
refuses '1 of 2 points' 'number 1' '--outside rest' -- --cage cube --posed large.obj --points outside.csv --method green --out out.csv
"$cageproof" deform --cage cube --posed large.obj --points outside.csv --method green --outside rest --out rest.csv 2>stderr || fail "--outside rest"
[ "$(tail -n 1 rest.csv)" = 3,0,0 ] || fail "not at rest: $(tail -n 1 rest.csv)"
grep -q '1 of 2 points' stderr || fail "no word of the point outside"
grep -q '1 of 2 points have no image' rest.json || fail "no word of it in the report"
"$cageproof" deform --cage cube --posed large.obj --points outside.csv --method green --outside nan --out nan.csv 2>stderr
[ "$(tail -n 1 nan.csv)" = nan,nan,nan ] || fail "not nan: $(tail -n 1 nan.csv)"
"$cageproof" deform --cage cube --posed large.obj --points outside.csv --method mean_value --out all.csv || fail "mean value coordinates exist outside"

# Suffixes in capitals are the same formats.
for out in moved.obj moved.ply moved.csv moved.npy moved.vtp; do
  capital=CAPITAL.${out#*.}
  capital=${capital^^}
  "$cageproof" deform "${common[@]}" --method mean_value --out $out || fail "$out"
  "$cageproof" deform "${common[@]}" --method mean_value --out "$capital" || fail "$capital"
  cmp -s $out "$capital" || fail "$capital differs from $out"
  rm -f $out "$capital" CAPITAL.json
done

# Points, a cage and a pose of OFF files.
{ echo OFF 8 6 0; sed 's/^v //' large.obj; printf '%s\n' '4 0 2 3 1' '4 4 5 7 6' '4 0 1 5 4' '4 2 6 7 3' '4 0 4 6 2' '4 1 3 7 5'; } >cube.off
"$cageproof" deform --cage cube.off --posed cube.off --points cube.off --method mean_value --out off.obj || fail "OFF"
[ "$(grep -c '^f ' off.obj)" -eq 6 ] || fail "faces of an OFF file are lost"

# Bytes behind a binary STL's triangles are told.
{ head -c 80 /dev/zero; printf '\1\0\0\0'; head -c 24 /dev/zero; printf '\0\0\200\76'; head -c 16 /dev/zero; printf '\0\0\200\76\0\0more'; } >more.stl
"$cageproof" deform --cage cube --posed large.obj --points more.stl --method mean_value --out more.csv 2>stderr || fail "a long STL: $(cat stderr)"
grep -q '^warning: more.stl: 4 bytes behind the last triangle are left out; 1 triangles need 134$' stderr || fail "no warning: $(cat stderr)"

# A cube with a vertex for each corner of a face: joined, and a pose must keep them together.
awk 'BEGIN {split("1 3 4 2 5 6 8 7 1 2 6 5 3 7 8 4 1 5 7 3 2 4 8 6", c, " ")}
  $1 == "v" {v[++n] = $0} END {for (i = 1; i <= 24; ++i) print v[c[i]]; for (f = 0; f < 6; ++f) print "f", 4 * f + 1, 4 * f + 2, 4 * f + 3, 4 * f + 4}' large.obj >apart.obj
refuses 'face 0 (line 25)' 'vertices 0 and 8 lie in one place' -- --cage apart.obj --posed apart.obj --points mesh.obj --method green --out out.obj
refuses '--merge -1' -- --cage apart.obj --merge -1 --posed apart.obj --points mesh.obj --method green --out out.obj
grep '^v' apart.obj | awk '!seen[$0]++ {print $2, $3, $4}' >merged_pose.txt
"$cageproof" deform --cage apart.obj --merge 0 --posed apart.obj --points mesh.obj --method green --out merged.csv 2>stderr || fail "merged: $(cat stderr)"
[ "$(cat stderr)" = 'warning: apart.obj: 24 vertices are merged to 8' ] || fail "a warning of merging: $(cat stderr)"
paste -d' ' <(grep '^v' mesh.obj) <(tail -n +2 merged.csv | tr , ' ') | awk '{for (i = 2; i < 5; ++i) {d = $i - $(i + 3); if (d * d > 1e-28) differs = 1}} END {exit differs}' || fail "the identity: $(cat merged.csv)"
"$cageproof" deform --cage apart.obj --merge 0 --posed merged_pose.txt --points mesh.obj --method green --out welded.csv 2>stderr || fail "a pose that is merged already: $(cat stderr)"
cmp -s merged.csv welded.csv || fail "another image by a pose that is merged already: $(cat welded.csv)"
sed '24s/.*/v 9 9 9/' apart.obj >pulled_apart.obj
"$cageproof" deform --cage apart.obj --merge 0 --posed pulled_apart.obj --points mesh.obj --method green --out out.obj 2>stderr && fail "a pose that pulls merged vertices apart"
grep -q 'pulled_apart.obj: vertices 5 and 23 are one in the rest cage by --merge, and lie ' stderr || fail "merged vertices: $(cat stderr)"

# Points outside: by a rounding, and beyond a face.
printf 'v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n' >corner.obj
printf '0.6666666666666667 0.6666666666666667 0.6666666666666667\n' >slanted.txt
printf '1 1 1\n' >beyond.txt
on_corner=(--cage corner.obj --posed corner.obj --method green)
refuses 'are outside' '--on' -- "${on_corner[@]}" --points slanted.txt --out out.csv
refuses 'are outside' '--outside extend' -- "${on_corner[@]}" --points beyond.txt --out out.csv
refuses 'does not continue' -- --cage corner.obj --posed corner.obj --method biharmonic_1_3 --points beyond.txt --outside extend --out out.csv
"$cageproof" deform "${on_corner[@]}" --points slanted.txt --on 1e-12 --out on.csv 2>stderr || fail "--on: $(cat stderr)"
grep -q '^1 of 1 points lay outside by at most 1e-12 .* moved onto it, by at most' stderr || fail "what was moved: $(cat stderr)"
"$cageproof" deform "${on_corner[@]}" --points beyond.txt --outside extend --out beyond.csv || fail "--outside extend"
for of in on:0.6666666666666667 beyond:1; do
  tail -n 1 "${of%:*}.csv" | tr , '\n' | awk -v x="${of#*:}" '{d = $1 - x; if (d * d > 1e-28) differs = 1} END {exit differs}' || fail "${of%:*}: $(cat "${of%:*}.csv")"
done
"$cageproof" coordinates --cage corner.obj --points slanted.txt --kind green --on 1e-12 --strict >/dev/null 2>stderr || fail "--on of coordinates: $(cat stderr)"

# Two cubes that share an edge.
{ grep '^v' large.obj && printf 'v 3 1 -1\nv 1 3 -1\nv 3 3 -1\nv 3 1 1\nv 1 3 1\nv 3 3 1\n' &&
  printf 'f %s\n' '1 3 4 2' '5 6 8 7' '1 2 6 5' '3 7 8 4' '1 5 7 3' '2 4 8 6' '4 10 11 9' '8 12 14 13' '4 9 12 8' '10 13 14 11' '4 8 13 10' '9 11 14 12'; } >joined.obj
"$cageproof" deform --cage joined.obj --posed joined.obj --points mesh.obj --method green --out joined.csv 2>stderr || fail "parts that meet: $(cat stderr)"
grep -q '^warning: joined.obj: parts of the surface meet in 1 edge (the first between vertices 3 and 7)' stderr || fail "what meets: $(cat stderr)"

# Images to some digits: of a cube of 1,728 triangles, and face by face of one of twelve.
awk 'function at(x, y, z, key) {
       key = x "," y "," z
       if (!(key in number)) { number[key] = ++count; printf "v %g %g %g\n", 2 * x / n - 1, 2 * y / n - 1, 2 * z / n - 1 }
       return number[key]
     }
     function square(a, b, c, d) { faces = faces "f " a " " b " " c " " d "\n" }
     BEGIN {
       n = 12
       for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) {
         square(at(i, j, 0), at(i, j + 1, 0), at(i + 1, j + 1, 0), at(i + 1, j, 0)); square(at(i, j, n), at(i + 1, j, n), at(i + 1, j + 1, n), at(i, j + 1, n))
         square(at(i, 0, j), at(i + 1, 0, j), at(i + 1, 0, j + 1), at(i, 0, j + 1)); square(at(i, n, j), at(i, n, j + 1), at(i + 1, n, j + 1), at(i + 1, n, j))
         square(at(0, i, j), at(0, i, j + 1), at(0, i + 1, j + 1), at(0, i + 1, j)); square(at(n, i, j), at(n, i + 1, j), at(n, i + 1, j + 1), at(n, i, j + 1))
       }
       printf "%s", faces
     }' >fine.obj
awk '$1 == "v" { print "v", $2 + 0.3 * $3 * $4 + 5, $3 * 1.2, $4 - 0.2 * $2 * $2; next } { print }' fine.obj >bent.obj
awk 'BEGIN { srand(3); for (i = 0; i < 20000; ++i) print 1.98 * rand() - 0.99, 1.98 * rand() - 0.99, 1.98 * rand() - 0.99; print 1, 0, 0; print 7, 0, 0 }' >many.txt
fine=(--cage fine.obj --posed bent.obj --points many.txt --method green --outside rest)
"$cageproof" deform "${fine[@]}" --out all.csv || fail "all digits"
for digits in 3 6 12; do
  "$cageproof" deform "${fine[@]}" --digits $digits --out some.csv 2>stderr || fail "--digits $digits: $(cat stderr)"
  grep -q '^far faces are summed together, by harmonics up to degree [1-9]' stderr || fail "what --digits does: $(cat stderr)"
  grep -q "\"asked\": $digits" some.json || fail "digits in the report"
  paste -d, all.csv some.csv | awk -F, -v most=1e-$digits '
    NR > 1 { square = ($1 - $4) ^ 2 + ($2 - $5) ^ 2 + ($3 - $6) ^ 2; if (square > (4 * most) ^ 2) wrong = 1; if (square > 0) differs = 1 }
    END { exit wrong || !differs || NR != 20003 }' || fail "images to $digits digits"
done
"$cageproof" deform "${common[@]}" --method green --digits 3 --out some.obj 2>stderr || fail "--digits on few faces: $(cat stderr)"
grep -q 'summed face by face, which is quicker' stderr || fail "few faces: $(cat stderr)"
"$cageproof" deform "${common[@]}" --method green --out every.obj || fail "all digits on few faces"
cmp -s some.obj every.obj || fail "--digits on few faces has other images"
grep -q '"points_by_faces": [1-9]' some.json || fail "points by faces of few faces: $(cat some.json)"
# At the end of the exponent range nothing is computed in blocks.
"$cageproof" list --cage cube --out unit.obj >/dev/null && sed -E 's/^v ([^ ]+) ([^ ]+) ([^ ]+)$/v \1e90 \2e90 \3e90/' unit.obj >vast.obj
echo 1e89,2e89,3e89 | "$cageproof" deform --cage vast.obj --posed vast.obj --points - --method green --digits 6 --out vast.csv || fail "--digits of a large cage"
grep -q '"points_by_faces": 1' vast.json || fail "points by faces of a large cage: $(cat vast.json)"
refuses --digits 'always computes all digits; leave --digits out, or take green' -- "${common[@]}" --method somigliana --digits 6 --out out.obj
refuses --digits quad_green -- "${common[@]}" --method green --keep-quads --digits 6 --out out.obj
refuses --digits derivatives -- "${common[@]}" --method green --digits 6 --order 1 --derivatives out.csv --out out.obj
refuses --digits hybrid batched -- "${common[@]}" --method green --digits 6 --evaluation hybrid --out out.obj
refuses --digits extend -- "${common[@]}" --method green --digits 6 --outside extend --out out.obj
refuses 'always have all digits' batched -- --cage square --posed square --points points.csv --method green --digits 6 --out out.csv
refuses --digits 2 -- "${common[@]}" --method green --digits 2 --out out.obj

# Wrong options and values are refused.
refuses "unknown deformer 'grean'" -- "${common[@]}" --method grean --out out.obj
refuses stretch rms -- "${common[@]}" --method green --parameter stretch=most --out out.obj
refuses 'green has only stretch' -- "${common[@]}" --method green --parameter level=1 --out out.obj
refuses 'out of range' -- "${common[@]}" --method somigliana --parameter nu=0.5 --out out.obj
for method in maximum_entropy quad_mean_value green; do
  refuses nosuch -- --cage l-block --posed l-block --points mesh.obj --method $method --evaluation nosuch --out out.csv
done
printf '%s\n' '-0.6,-0.5,-0.7' '0.5,-0.5,-0.5' '-0.5,0.5,-0.5' '0.5,0.2,-0.4' '-0.5,-0.5,0.5' '0.5,-0.5,0.5' '-0.5,0.5,0.5' '0.8,0.7,0.9' >pulled.csv
refuses 'number 0' 'not finite' -- --cage cube --posed pulled.csv --points mesh.obj --method somigliana --parameter gamma=900000 --outside rest --out out.csv
refuses missing.obj -- --cage cube --posed missing.obj --points mesh.obj --method green --out out.obj
refuses mesh.obj '5 vertices, the rest cage 8' -- --cage cube --posed mesh.obj --points mesh.obj --method green --out out.obj
refuses .off .stl .svg -- "${common[@]}" --method green --out out.off
refuses corner.csv faces .csv -- --cage cube --posed large.obj --points corner.csv --method green --out out.stl
refuses plane -- "${common[@]}" --method green --out out.svg
refuses points.csv polylines -- --cage square --posed square --points points.csv --method somigliana --out out.svg
refuses beyond.stl 'vertex 0 ' 'single precision' -- --cage cube --posed huge.obj --points mesh.obj --method mean_value --out beyond.stl
refuses --derivatives -- "${common[@]}" --method green --order 1 --out out.obj
refuses '{n}' -- "${common[@]}" --posed cube --method green --out out.obj
refuses '--outside nan' -- "${common[@]}" --method green --outside nan --out out.obj
sed 's/^v 1 1 1$/v 1 1 -1/' large.obj >flat.obj
refuses flat.obj 'has no area' -- --cage cube --posed flat.obj --points mesh.obj --method green --out out.obj
refuses dimension -- --cage square --posed square --points points.csv --method maximum_entropy --out out.csv

[ $failures -eq 0 ] && echo "all as it should be"
exit $failures
