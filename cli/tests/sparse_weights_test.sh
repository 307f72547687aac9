#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `coordinates --drop`: sparse rows that NumPy and SciPy read, whose product with a pose is within the bound of the whole table's, and refusals.
# Usage: sparse_weights_test.sh PATH_OF_CAGEPROOF
# shellcheck source=support.sh
here=$(dirname "$(readlink -f "$0")")
source "$here/support.sh"
examples=$(readlink -f "$here/../../docs/examples")
python=/usr/bin/python3
export PYTHONPATH=$examples${PYTHONPATH:+:$PYTHONPATH} PYTHONDONTWRITEBYTECODE=1
refuses() { refuses_to coordinates "$@"; }

"$python" -c '
import random
random.seed(5)
print("\n".join("%.17g %.17g %.17g" % tuple(random.uniform(-0.9, 0.9) for _ in range(3)) for _ in range(500)))' >points.xyz
common=(--cage icosphere --points points.xyz)
for kind in mean_value green; do
  "$cageproof" coordinates "${common[@]}" --kind $kind --out $kind.npz 2>log || fail "$kind: $(cat log)"
  for store in double float half; do
    "$cageproof" coordinates "${common[@]}" --kind $kind --drop 0.02 --budget 0.3 --store $store --out $kind.$store.npz 2>$kind.$store.said || fail "$kind as $store: $(cat $kind.$store.said)"
    grep -q "weights, .* a point, as $store: " $kind.$store.said && grep -q 'no point is off by more than 0.0[0-9]* of the cage' $kind.$store.said || fail "says $(cat $kind.$store.said)"
  done
done
"$python" - <<'PY' || fail "what sparse rows make of poses"
import json, os, numpy as np
from apply_npz import deform
from apply_sparse import deform_sparse
random = np.random.default_rng(1)
types = {"double": np.float64, "float": np.float32, "half": np.float16}
for kind in "mean_value", "green":
    whole = np.load(kind + ".npz")
    rest = whole["cage_vertices"]
    size = np.linalg.norm(rest.max(axis=0) - rest.min(axis=0))
    table = np.hstack([whole[name] for name in ("lambda", "phi", "psi") if name in whole])
    for store, dtype in types.items():
        file = f"{kind}.{store}.npz"
        w = np.load(file)
        meta = json.loads(w["metadata.json"])["sparse"]
        assert w["format"].item() == b"csr" and w["data"].dtype == dtype and tuple(w["shape"]) == table.shape
        assert w["indptr"][0] == 0 and w["indptr"][-1] == len(w["data"]) == len(w["indices"]) == meta["kept"] and (np.diff(w["indptr"]) > 0).all()
        assert abs(meta["cage_size"] - size) < 1e-14 * size and meta["stored_as"] == store and meta["tolerance"] == 0.02 and meta["budget"] == 0.3
        assert 0 < meta["bound"] <= 0.02 and meta["kept"] < 0.98 * table.size, (meta, table.size)
        # Poses as far as they may go: each vertex for itself, all with the signs of a row's changes, and the cage at rest.
        dense = np.zeros(table.shape)
        for p in range(len(dense)):
            row = slice(w["indptr"][p], w["indptr"][p + 1])
            dense[p, w["indices"][row]] = w["data"][row]
        changes = dense - table
        poses = [rest]
        for p in range(20):
            step = random.normal(size=rest.shape)
            poses.append(rest + 0.3 * size * step / np.linalg.norm(step, axis=1, keepdims=True))
        for p in np.argsort(-abs(changes[:, :len(rest)]).sum(axis=1))[:20]:
            along = changes[p, :len(rest)] @ rest
            poses.append(rest + 0.3 * size * np.sign(changes[p, :len(rest)])[:, None] * along / np.linalg.norm(along))
        off = max(np.linalg.norm(deform_sparse(file, pose) - deform(kind + ".npz", pose), axis=1).max() for pose in poses) / size
        print(f"{kind} as {store}: off by {off:.4g}, bound {meta['bound']:.4g}, {meta['kept']} of {table.size} kept")
        assert off <= meta["bound"] + 1e-14
        assert off > meta["bound"] / (1.5 if kind == "mean_value" else 12), "the bound is far from what is found"
        # A pose and the cage moved as a whole.
        away = np.array([5, -3, 2.0]) * size
        moved = np.linalg.norm(deform_sparse(file, poses[1] + away) - deform(kind + ".npz", poses[1] + away), axis=1).max() / size
        assert moved <= meta["bound"] + meta["sum_change"] * np.linalg.norm(away) / size + 1e-13
        try:
            import scipy.sparse
        except ImportError:
            continue
        read = scipy.sparse.load_npz(file)
        assert read.dtype == dtype
        read = read.astype(np.float32) if store == "half" else read  # SciPy knows half by name only
        data = rest if kind == "mean_value" else np.vstack([rest, whole["element_normals"]])
        assert read.has_sorted_indices and abs(read.toarray() - dense).max() == 0 and abs(read.astype(float) @ data - dense @ data).max() < 1e-14
        print("  SciPy reads it")
PY

# The same run gives the same bytes, by any number of threads.
for jobs in 1 3; do "$cageproof" coordinates "${common[@]}" --kind green --drop 1e-3 --jobs $jobs --out jobs_$jobs.npz 2>said_$jobs; done
cmp jobs_1.npz jobs_3.npz && cmp said_1 said_3 || fail "threads decide what is kept"
# Nothing is dropped by zero, but zeros; a point without coordinates is one NaN.
echo '0.5 0.5 0.5' >corner.xyz
"$cageproof" coordinates --cage cube --points corner.xyz --kind mean_value --drop 0 --out corner.npz 2>said || fail "a corner: $(cat said)"
"$python" -c 'import numpy as np; w = np.load("corner.npz"); assert w["data"].tolist() == [1]' || fail "a corner has another weight"
echo '3 3 3' >outside.xyz
"$cageproof" coordinates --cage cube --points outside.xyz --kind maximum_entropy --drop 0.1 --out outside.npz 2>said || fail "outside: $(cat said)"
"$python" -c 'import numpy as np; w = np.load("outside.npz"); assert np.isnan(w["data"]).tolist() == [True]' || fail "a point without coordinates"
# In the plane, too.
printf '0.25 0.5\n0.75 0.125\n' >flat.xyz
for kind in mean_value green cauchy; do "$cageproof" coordinates --cage star --points flat.xyz --kind $kind --drop 1e-2 --out flat.npz 2>said || fail "$kind in the plane: $(cat said)"; done

small=("${common[@]}" --kind mean_value)
refuses '--drop' 'needs an --out' -- "${small[@]}" --drop 1e-3
for kind in npy csv vtp; do refuses '--drop' .npz -- "${small[@]}" --drop 1e-3 --out x.$kind; done
refuses '--drop' '--order' -- "${small[@]}" --drop 1e-3 --order 1 --out x.npz
refuses '--drop' '--data' -- "${small[@]}" --drop 1e-3 --data points.xyz --out x.npz
refuses '--budget' '--drop' -- "${small[@]}" --budget 1 --out x.npz
refuses '--store' '--drop' -- "${small[@]}" --store half --out x.npz
refuses '--store' half -- "${small[@]}" --drop 1e-3 --store int --out x.npz
for wrong in -1 2 nan some; do refuses '--drop' -- "${small[@]}" --drop $wrong --out x.npz; done
refuses '--budget' -- "${small[@]}" --drop 1e-3 --budget -1 --out x.npz
refuses '--drop 1e-06' 'rounded to half' 'store double' -- "${small[@]}" --drop 1e-6 --store half --out x.npz
refuses somigliana matrices 'kinds with one' mean_value green -- "${common[@]}" --kind somigliana --drop 1e-3 --out x.npz
refuses biharmonic Laplacians mean_value -- "${common[@]}" --kind biharmonic --drop 1e-3 --out x.npz
refuses quad_green 'bilinear quads' -- --cage cube --points points.xyz --kind green --keep-quads --drop 1e-3 --out x.npz

# A disk that is full on the way leaves the old file.
echo old >kept.npz
(ulimit -f 8 && "$cageproof" coordinates "${small[@]}" --drop 1e-6 --out kept.npz >said 2>&1)
[ $? -eq 2 ] && grep -q 'cannot write kept.npz' said || fail "a full disk: $(cat said)"
[ "$(cat kept.npz)" = old ] || fail "a full disk took the old file"

[ $failures -eq 0 ] && echo "sparse rows are within their bound"
exit $failures
