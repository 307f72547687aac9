#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The files of `coordinates` suffice to apply them: the examples of docs/apply.md, in NumPy and in Blender, give the images of `deform`.
# Usage: apply_test.sh PATH_OF_CAGEPROOF
# shellcheck source=support.sh
here=$(dirname "$(readlink -f "$0")")
source "$here/support.sh"
examples=$(readlink -f "$here/../../docs/examples")
python=/usr/bin/python3
export PYTHONPATH=$examples PYTHONDONTWRITEBYTECODE=1
"$python" -c 'import numpy' || fail "no NumPy: on Debian, python3-numpy"
refuses() { refuses_to coordinates "$@"; }

# A cage of quads with both diagonals as long, and of triangles; a pose that stretches each element otherwise; a mesh of a quad and a triangle.
cat >cage.obj <<'OBJ'
v -0.5 -0.5 -0.5
v 0.5 -0.5 -0.5
v -0.5 0.5 -0.5
v 0.5 0.5 -0.5
v -0.5 -0.5 0.5
v 0.5 -0.5 0.5
v -0.5 0.5 0.5
v 0.5 0.75 0.5
f 1 3 4 2
f 5 6 8 7
f 1 2 6 5
f 3 7 8
f 3 8 4
f 1 5 7 3
f 2 4 8 6
OBJ
awk '$1 == "v" {print "v", 2 * $2 + 0.3 * $3 * $4, $3 - 0.4 * $2 * $4, 1.5 * $4 + 0.2 * $2; next} {print}' cage.obj >posed.obj
cat >mesh.obj <<'OBJ'
v 0.25 0.125 0
v 0.375 0.125 0
v 0.375 0.25 0
v 0.25 0.25 0.125
v -0.125 0.3 -0.45
f 1 2 3 4
f 1 3 5
OBJ
common=(--cage cage.obj --points mesh.obj)
for split in shortest fan; do
  for kind in green mean_value; do
    "$cageproof" coordinates "${common[@]}" --kind $kind --triangulate $split --order 1 --out $kind.npz 2>log || fail "$kind: $(cat log)"
    "$cageproof" deform "${common[@]}" --posed posed.obj --method $kind --triangulate $split --out $kind.csv || fail "deform $kind"
    "$python" - $kind <<'PY' || fail "NumPy's $kind by $split"
import sys, numpy as np
from apply_npz import deform
kind = sys.argv[1]
posed = np.array([[float(x) for x in line.split()[1:]] for line in open("posed.obj") if line[0] == "v"])
off = abs(deform(kind + ".npz", posed) - np.loadtxt(kind + ".csv", delimiter=",", skiprows=1)).max()
sys.exit(f"{kind}: {off} from what deform writes" if not off < 1e-14 else 0)
PY
  done
done

# Every array by its definition: points from vertices and normals, derivatives of the identity, areas and normals from corners.
"$cageproof" coordinates "${common[@]}" --kind somigliana --parameter nu=0.3 --order 1 --out somigliana.npz 2>log || fail "somigliana: $(cat log)"
"$cageproof" coordinates "${common[@]}" --kind biharmonic_affine --out affine.npz 2>log || fail "biharmonic_affine: $(cat log)"
"$cageproof" coordinates "${common[@]}" --kind quad_mean_value --out quads.npz 2>log || fail "quad_mean_value: $(cat log)"
printf '0.25 0.5\n0.75 0.125\n' >flat.csv
"$cageproof" coordinates --cage square --points flat.csv --kind green --out flat.npz 2>log || fail "plane: $(cat log)"
"$python" - <<'PY' || fail "what the arrays hold"
import json, numpy as np
close = lambda a, b: np.abs(np.asarray(a) - b).max() < 1e-13
g, s, a, q, f = (np.load(n + ".npz") for n in ("green", "somigliana", "affine", "quads", "flat"))
meta = {n: json.loads(c["metadata.json"]) for n, c in (("g", g), ("s", s), ("f", f))}
x, y, z = (g["cage_vertices"][g["elements"].T])
n = np.cross(y - x, z - x)
assert close(np.linalg.norm(n, axis=1) / 2, g["element_areas"]) and close(n / np.linalg.norm(n, axis=1)[:, None], g["element_normals"])
assert g["element_faces"].tolist() == [0, 0, 1, 1, 2, 2, 3, 4, 5, 5, 6, 6]
assert close(g["phi"].sum(axis=1), 1) and close(g["phi"] @ g["cage_vertices"] + g["psi"] @ g["element_normals"], g["points"])
jacobian = np.einsum("pnd,nc->pcd", g["phi_gradient"], g["cage_vertices"]) + np.einsum("pnd,nc->pcd", g["psi_gradient"], g["element_normals"])
assert close(jacobian, np.eye(3))
assert meta["g"]["kind"] == "green" and meta["g"]["triangulation"] == "fan" and meta["g"]["evaluation"] == "batched" and meta["g"]["order"] == 1
c = meta["s"]["blocks"][1]["normal_factor"]
assert meta["s"]["parameters"] == {"mu": 1.0, "nu": 0.3}
assert close(np.einsum("pnij,nj->pi", s["T"], s["cage_vertices"]) + c * np.einsum("pnij,nj->pi", s["K"], s["element_normals"]), s["points"])
assert close(a["phi"] @ a["cage_vertices"] + a["psi"] @ a["element_normals"][a["psi_elements"]], a["points"])
assert a["psi_vertices"].tolist() == a["elements"].ravel().tolist()
assert q["elements"].shape == (7, 4) and q["elements"][3, 3] == -1 and close(q["lambda"] @ q["cage_vertices"], q["points"])
assert f["points"].shape == (2, 2) and close(f["element_lengths"], 1) and f["element_normals"].tolist() == [[0, -1], [1, 0], [0, 1], [-1, 0]]
assert close(f["phi"] @ f["cage_vertices"] + f["psi"] @ f["element_normals"], f["points"])
PY

# Defaults agree: coordinates of somigliana, applied by hand ([C23] Eq 11, 14, without bulging), are the default deformer.
"$cageproof" coordinates "${common[@]}" --kind somigliana --out default.npz 2>log || fail "somigliana: $(cat log)"
"$cageproof" deform "${common[@]}" --posed posed.obj --method somigliana --out default.csv || fail "deform somigliana"
"$python" - <<'PY' || fail "somigliana by default"
import json, sys, numpy as np
c = np.load("default.npz")
block = json.loads(c["metadata.json"])["blocks"][1]
rest, posed = c["cage_vertices"], np.array([[float(x) for x in line.split()[1:]] for line in open("posed.obj") if line[0] == "v"])
p, q = rest - rest.mean(axis=0), posed - posed.mean(axis=0)
u, d, vt = np.linalg.svd(q.T @ p)  # Umeyama 1991
signs = np.array([1, 1, np.sign(np.linalg.det(u @ vt))])
turn, stretch = u @ np.diag(signs) @ vt, (d * signs).sum() / (p * p).sum()
turned = lambda matrices: np.einsum("ai,pnij,bj->pnab", turn, matrices, turn)
tractions = block["normal_factor"] * stretch * c["element_normals"] @ turn.T
right = np.einsum("pnij,nj->pi", turned(c["T"]), posed) + np.einsum("pnij,nj->pi", turned(c["K"]), tractions)
images = np.linalg.solve(turned(c["T"]).sum(axis=1), right[:, :, None])[:, :, 0]
off = abs(images - np.loadtxt("default.csv", delimiter=",", skiprows=1)).max()
sys.exit(f"{off} from what deform writes" if not off < 1e-13 else 0)
PY

# Tables have a description next to them, which holds the same; the same run gives the same bytes.
"$cageproof" coordinates "${common[@]}" --kind green --order 1 --triangulate fan --out table.csv 2>log || fail "csv: $(cat log)"
"$cageproof" coordinates "${common[@]}" --kind green --order 1 --triangulate fan --out array.npy 2>log || fail "npy: $(cat log)"
"$cageproof" coordinates "${common[@]}" --kind green --order 1 --triangulate fan --out again.npz 2>log || fail "npz: $(cat log)"
"$cageproof" coordinates "${common[@]}" --kind green --order 1 --triangulate fan --out scene.vtp 2>log || fail "vtp: $(cat log)"
cmp -s again.npz green.npz || "$python" -c 'import numpy as np; a, b = np.load("again.npz"), np.load("green.npz"); assert list(a) == list(b)' || fail "two .npz differ"
"$cageproof" coordinates "${common[@]}" --kind green --order 1 --triangulate fan --out twice.npz 2>log
cmp again.npz twice.npz || fail "two runs write different .npz"
"$python" - <<'PY' || fail "descriptions"
import json, numpy as np
g = np.load("again.npz")
for table, name in ((np.loadtxt("table.csv", delimiter=",", skiprows=1), "table.json"), (np.load("array.npy"), "array.json")):
    d = json.load(open(name))
    assert d["schema"] == "cageproof-coordinates" and d["triangulation"] == "fan"
    for array in d["arrays"]:
        part = table[:, array["first_column"]:][:, :array["columns"]].reshape([-1] + array["shape"])
        assert (part == g[array["name"]]).all(), array
    for name in ("cage_vertices", "elements", "element_faces", "element_normals", "element_areas"):
        assert (np.array(d[name]) == g[name]).all(), name
PY
# The .vtp can still be read as a mesh; the cage next to it is one.
"$cageproof" coordinates --cage scene.cage.vtp --points scene.vtp --kind green --order 1 2>log | cmp -s - table.csv || fail "the cage or the mesh of a .vtp is another: $(cat log)"
for word in cage_vertices elements element_normals element_areas cageproof_metadata; do grep -q "Name=\"$word\"" scene.vtp || fail "no $word in the .vtp"; done

# Nobody's files are in the way.
echo '{}' >mine.json
refuses mine.json 'which is no such' -- "${common[@]}" --kind green --out mine.csv
refuses cage.obj .obj -- "${common[@]}" --kind green --out cage.obj
cp table.json solved.json
refuses solved.json --solved -- "${common[@]}" --kind green --out solved.csv --solved solved.json
cp table.csv points.csv
refuses points.csv --points -- --cage cage.obj --points points.csv --kind green --out points.csv

# Blender's example with a stand-in for its module, and in Blender itself where there is one: shape keys are in single precision.
check_shape() {
  "$python" -c 'import sys, numpy as np; off = abs(np.loadtxt(sys.argv[1]) - np.loadtxt("green.csv", delimiter=",", skiprows=1)).max(); sys.exit(f"{off}" if not off < 3e-7 else 0)' "$1"
}
PYTHONPATH=$here/stand_in:$examples "$python" "$examples/blender_cage.py" -- green.npz mesh.obj posed.obj shape.txt || fail "the Blender example"
check_shape shape.txt || fail "the Blender example moves the mesh elsewhere"
PYTHONPATH=$here/stand_in:$examples "$python" "$examples/blender_cage.py" -- green.npz posed.obj posed.obj wrong.txt 2>log && fail "a mesh of other vertices is taken"
grep -q 'the mesh has 8 vertices' log || fail "no reason: $(cat log)"
if command -v blender >/dev/null; then
  cat >read.py <<'PY'
import bpy, numpy as np
keys = bpy.data.objects["mesh"].data.shape_keys.key_blocks
flat = np.empty(3 * len(keys[1].data))
keys[1].data.foreach_get("co", flat)
assert keys[1].value == 1.0
np.savetxt("blender.txt", flat.reshape(-1, 3))
PY
  env -u PYTHONPATH blender --background --python-exit-code 1 --python "$examples/blender_cage.py" -- green.npz mesh.obj posed.obj saved.blend >log 2>&1 &&
    env -u PYTHONPATH blender --background saved.blend --python-exit-code 1 --python read.py >log 2>&1 || fail "Blender: $(tail -n 5 log)"
  check_shape blender.txt || fail "Blender moves the mesh elsewhere"
  echo "in Blender, too"
else
  echo "no Blender here: its example ran with a stand-in alone"
fi

# Points come from NumPy, and through pipes.
"$python" - <<'PY' || fail "NumPy writes no points"
import numpy as np
p = np.array([[0.1, 0.2, 0.05], [-0.2, 0.1, 0.3]])
np.savetxt("p.txt", p)
np.save("rows.npy", p)
np.save("columns.npy", np.asfortranarray(p).astype(">f8"))
np.savez_compressed("one.npz", anything=p)
np.savez("two.npz", a=p, b=p)
PY
coordinates_of() { "$cageproof" coordinates --cage cage.obj --kind green --points "$@" 2>/dev/null; }
coordinates_of p.txt >expected.csv
for file in rows.npy columns.npy one.npz; do coordinates_of $file | cmp - expected.csv || fail "$file: other points"; done
coordinates_of - <p.txt | cmp - expected.csv || fail "other points on standard input"
coordinates_of - <rows.npy | cmp - expected.csv || fail "another array on standard input"
# shellcheck disable=SC2002
cat p.txt | coordinates_of /dev/stdin | cmp - expected.csv || fail "other points through a pipe"
coordinates_of <(cat p.txt) | cmp - expected.csv || fail "other points by process substitution"
refuses 'two.npz' '2 arrays (a, b)' -- --cage cage.obj --kind green --points two.npz
sed 's/$/ 255 0 0/' p.txt >coloured.xyz
coordinates_of coloured.xyz | cmp - expected.csv || fail "colours are taken for coordinates"
"$cageproof" coordinates --cage cage.obj --kind green --points coloured.xyz 2>&1 >/dev/null | grep -q '^warning: coloured.xyz: 3 of 6 columns' || fail "colours are left out in silence"
sed -n 's/^v //p' posed.obj >posed.xyz
for posed in posed.obj posed.xyz; do "$cageproof" deform --cage cage.obj --posed $posed --points p.txt --method green --out $posed.csv 2>/dev/null; done
"$cageproof" deform --cage cage.obj --posed <(cat posed.xyz) --points - --method green --out piped.csv <p.txt 2>/dev/null
cmp posed.obj.csv piped.csv || fail "a pose through a pipe is another one"
cmp posed.obj.csv posed.xyz.csv || fail "a pose as text is another one"

# The page shows the example that was run.
awk '/^```$/ && inside {exit} inside {print} /^```python$/ {inside = 1}' "$examples/../apply.md" | cmp - "$examples/apply_npz.py" || fail "docs/apply.md shows another example"

[ $failures -eq 0 ] && echo "coordinates can be applied with what is written"
exit $failures
