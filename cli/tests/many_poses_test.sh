#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Many poses in one run of `deform`: numbered files, point caches and collections for ParaView. Usage: many_poses_test.sh PATH_OF_CAGEPROOF
# shellcheck source=support.sh
source "$(dirname "$(readlink -f "$0")")/support.sh"
python=/usr/bin/python3
refuses() { refuses_to deform "$@"; }

# The embedded cube, a pose twice as large, a sheared one, and a mesh in it whose places need more than single precision.
pose() { for z in -1 1; do for y in -1 1; do for x in -1 1; do awk -v x=$x -v y=$y -v z=$z -v s="$1" -v h="$2" 'BEGIN {print "v", s * x + h * z, s * y, s * z}'; done; done; done; }
pose 1 0 >large.obj
pose 0.5 0.25 >sheared.obj
printf 'v 0.3 0.1 0\nv 0.375 0.125 0\nv 0.4 0.25 0\nv 0.25 0.25 0.125\nv 0 0 0.2\nf 1 2 3 4\nf 1 3 5\n' >mesh.obj
poses=(--cage cube --posed large.obj --posed cube --posed sheared.obj --points mesh.obj --method mean_value)

# Names by number.
"$cageproof" deform "${poses[@]}" --out 'at_{n:02d}.obj' || fail "numbers of two digits"
"$cageproof" deform "${poses[@]}" --out '{n}_{n:03d}_{n:01d}.csv' || fail "three numbers in a name"
for file in at_0{1,2,3}.obj at.json {1_001_1,2_002_2,3_003_3}.csv maps.json; do [ -f "$file" ] || fail "no $file: $(ls)"; done
[ "$(find . -name '*.json' | wc -l)" -eq 2 ] || fail "more reports than runs: $(ls)"
many=()
for _ in 1 2 3 4 5 6 7 8 9 10; do many+=(--posed large.obj); done
"$cageproof" deform "${poses[@]:0:2}" "${many[@]}" "${poses[@]:8}" --out 'more_{n:01d}.csv' || fail "ten maps"
[ -f more_9.csv ] && [ -f more_10.csv ] || fail "a number that is longer than its place: $(ls)"
rm -f more* ./*_00?_* maps.json
for name in 'a_{n:3}.obj' 'a_{n:3d}.obj' 'a_{n:00d}.obj' 'a_{n:010d}.obj' 'a_{n}_{n:}.obj'; do
  refuses "--out $name" '{n:03d}' -- "${poses[@]}" --out "$name"
done
refuses '--derivatives d_{n:2}.csv' '{n:03d}' -- "${poses[@]}" --order 1 --out 'a_{n}.obj' --derivatives 'd_{n:2}.csv'
refuses one.obj '3 maps' '{n:03d}' .pc2 .pvd -- "${poses[@]}" --out one.obj

# Point caches hold the places of the numbered files, rounded to single precision, in the order of --points.
for format in pc2 mdd; do
  "$cageproof" deform "${poses[@]}" --out "film.$format" 2>said || fail "$format"
  [ "$(cat said)" = "warning: film.$format: point caches are single precision: coordinates are rounded to about 7 digits" ] || fail "said: $(cat said)"
  mv film.json "film.$format.json"
done
"$cageproof" deform "${poses[@]}" --frame-rate 50 --out quick.mdd 2>said || fail "a frame rate"
"$python" - <<'PY' || fail "bytes of the caches"
import json, struct

def single(x):
    return struct.unpack("<f", struct.pack("<f", x))[0]

frames = [[single(float(x)) for line in open(f"at_0{k}.obj") if line.startswith("v ") for x in line.split()[1:]] for k in (1, 2, 3)]
assert all(len(frame) == 15 for frame in frames) and frames[0] != frames[1] != frames[2], frames
numbers = [x for frame in frames for x in frame]
pc2 = open("film.pc2", "rb").read()
assert struct.unpack("<12siiffi", pc2[:32]) == (b"POINTCACHE2\0", 1, 5, 1.0, 1.0, 3), pc2[:32]
assert list(struct.unpack("<45f", pc2[32:])) == numbers
for name, rate in ("film", 24), ("quick", 50):
    mdd = open(name + ".mdd", "rb").read()
    assert struct.unpack(">ii3f", mdd[:20]) == (3, 5, 0, single(1 / rate), single(2 / rate)), mdd[:20]
    assert list(struct.unpack(">45f", mdd[20:])) == numbers
for name in "film.pc2.json", "film.mdd.json", "quick.json":
    report = json.load(open(name))
    assert (report["schema"], report["schema_version"]) == ("cageproof-deformations", 1), report
    frames = json.load(open("at.json"))["frames"]
    assert [frame.pop("file") for frame in frames] == [f"at_0{k}.obj" for k in (1, 2, 3)], frames
    assert report["frames"] == frames, report
PY
# One map is one frame; places that single precision holds need no warning; several parameters are frames, too, and a warning names the frame.
printf '0.25,0.5,0\n' >exact.csv
"$cageproof" deform --cage cube --posed cube --points exact.csv --method green --outside rest --parameter stretch=rms --out one.PC2 2>said || fail "one frame"
[ "$(wc -c <one.PC2)" -eq 44 ] || fail "not one place: $(wc -c <one.PC2) bytes"
"$cageproof" deform --cage cube --posed large.obj --posed cube --points mesh.obj --method somigliana --parameter nu=0,0.25 --out swept.pc2 2>said || fail "a sweep"
[ "$(wc -c <swept.pc2)" -eq $((32 + 4 * 5 * 12)) ] || fail "not four frames: $(wc -c <swept.pc2) bytes"
[ "$(grep -c '"nu": 0.25' swept.json)" -eq 2 ] || fail "parameters of frames: $(cat swept.json)"
"$cageproof" deform --cage cube --posed large.obj --posed cube --points mesh.obj --method biharmonic_1_3 --parameter level=0,1 --out solved.pc2 2>said || fail "a sweep with warnings"
grep -q '^warning: solved.pc2, frame 1: ' said || fail "no frame in the warnings: $(cat said)"
"$cageproof" deform "${poses[@]}" --order 1 --out film.pc2 --derivatives 'film_{n:02d}.csv' 2>said || fail "derivatives beside a cache"
[ -f film_03.csv ] || fail "no derivatives beside a cache"
rm -f ./film* ./one.* ./swept.* ./solved.* ./quick.* said

awk '$1 == "v" {print $1, $2 * 1e39, $3 * 1e39, $4 * 1e39}' large.obj >huge.obj
for format in pc2 mdd; do
  refuses "far.$format: frame 4 (huge.obj), vertex 0 " 'single precision' .vtp -- "${poses[@]}" --posed huge.obj --out "far.$format"
  refuses "film_{n}.$format" 'all maps' -- "${poses[@]}" --out "film_{n}.$format"
  refuses '--outside nan' "'.$format'" -- "${poses[@]}" --outside nan --out "film.$format"
  refuses '--order 1' --derivatives -- "${poses[@]}" --order 1 --out "film.$format"
  refuses 'd.csv' '3 maps' -- "${poses[@]}" --order 1 --out "film.$format" --derivatives d.csv
done
refuses --frame-rate .pc2 .mdd -- "${poses[@]}" --frame-rate 25 --out film.pc2
refuses --frame-rate .pvd .mdd -- "${poses[@]}" --frame-rate 25 --out film.pvd
refuses --frame-rate -- "${poses[@]}" --frame-rate 0 --out film.mdd
echo mine >film.json
refuses film.json 'which is no such' -- "${poses[@]}" --out film.pc2
rm film.json

# A collection names the maps' files by paths from its own folder on.
mkdir 'R&D <new>'
"$cageproof" deform "${poses[@]}" --order 1 --out 'R&D <new>/a & b.pvd' || fail "a collection"
"$cageproof" deform "${poses[@]}" --order 1 --out 'map_{n}.vtp' || fail "VTP"
"$python" - <<'PY' || fail "what the collection names"
import os
import xml.etree.ElementTree as tree

folder = "R&D <new>"
assert sorted(os.listdir(folder)) == ["a & b.json", "a & b.pvd"] + [f"a & b_00{k}.vtp" for k in (1, 2, 3)], os.listdir(folder)
root = tree.parse(os.path.join(folder, "a & b.pvd")).getroot()
assert (root.tag, root.get("type")) == ("VTKFile", "Collection")
steps = root.findall("Collection/DataSet")
assert [float(step.get("timestep")) for step in steps] == [1, 2, 3]
assert [step.get("file") for step in steps] == [f"a & b_00{k}.vtp" for k in (1, 2, 3)]
for k, step in enumerate(steps, 1):
    assert open(os.path.join(folder, step.get("file")), "rb").read() == open(f"map_{k}.vtp", "rb").read(), k
PY
refuses 'film_{n}.pvd' 'all maps' -- "${poses[@]}" --out 'film_{n}.pvd'
refuses 'film_{n:2}.pvd' '{n:03d}' -- "${poses[@]}" --out 'film_{n:2}.pvd'
refuses 'UTF-8' .pvd -- "${poses[@]}" --out $'film\xff.pvd'
# Reports name poses whose names are not UTF-8 as far as JSON can.
cp large.obj $'large\xff.obj'
"$cageproof" deform --cage cube --posed $'large\xff.obj' --points mesh.obj --method green --out strange.obj || fail "a pose's name that is not UTF-8"
grep -q $'"posed_cage": "large\xef\xbf\xbd.obj"' strange.json || fail "a name that is not UTF-8: $(cat strange.json)"
mkdir film.pvd
refuses film.pvd -- "${poses[@]}" --out film.pvd
rmdir film.pvd
cp mesh.obj film.mesh.obj
"$cageproof" deform "${poses[@]}" --out film.mesh.PVD && [ -f film.mesh_003.vtp ] || fail "a name with two dots: $(ls)"
"$cageproof" deform --cage cube --posed cube --points film.mesh_002.vtp --method green --out again.csv || fail "a file of the collection is not read again"
cp film.mesh_002.vtp film_002.vtp
refuses film_002.vtp --points -- --cage cube --posed cube --posed large.obj --points film_002.vtp --method green --out film.pvd

[ $failures -eq 0 ] && echo "all as it should be"
exit $failures
