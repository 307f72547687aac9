#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tables that `coordinates` writes by blocks of rows are whole or missing, and the same by any number of threads; tables beyond the memory are refused.
# Usage: large_tables_test.sh PATH_OF_CAGEPROOF
# shellcheck source=support.sh
source "$(dirname "$(readlink -f "$0")")/support.sh"
python=/usr/bin/python3
refuses() { refuses_to coordinates "$@"; }

# More points than one block has, also on the cage and outside.
"$python" -c '
import random
random.seed(3)
print("\n".join("%.17g %.17g %.17g" % tuple(random.uniform(-0.6, 0.6) for _ in range(3)) for _ in range(1000)))
print("0.5 0 0\n0.5 0.5 0.5")' >points.xyz
common=(--cage cube --points points.xyz --kind green --order 1)
"$cageproof" coordinates "${common[@]}" --out whole.npz 2>said_whole || fail "npz: $(cat said_whole)"
for jobs in 1 3; do
  "$cageproof" coordinates "${common[@]}" --jobs $jobs --out rows_$jobs.npy 2>said_$jobs || fail "npy: $(cat said_$jobs)"
  "$cageproof" coordinates "${common[@]}" --jobs $jobs --out rows_$jobs.csv 2>said_csv || fail "csv: $(cat said_csv)"
  "$cageproof" coordinates "${common[@]}" --jobs $jobs >printed_$jobs.csv 2>said_csv || fail "standard output: $(cat said_csv)"
  cmp said_$jobs said_whole || fail "other messages with $jobs threads"
  cmp rows_$jobs.csv printed_$jobs.csv || fail "standard output has other lines with $jobs threads"
done
for kind in npy csv json; do cmp rows_1.$kind rows_3.$kind || fail "threads decide bytes of .$kind"; done
"$python" - <<'PY' || fail "tables differ"
import numpy as np
rows, text, whole = np.load("rows_1.npy"), np.loadtxt("rows_1.csv", delimiter=",", skiprows=1), np.load("whole.npz")
assert rows.shape == (1002, 20 * 4) and np.array_equal(rows, text, equal_nan=True)
parts = [whole[name].reshape(1002, -1) for name in ("phi", "phi_gradient", "psi", "psi_gradient")]
assert np.array_equal(np.concatenate(parts, axis=1), rows, equal_nan=True)
PY

# Functions of data, which are written likewise.
for _ in $(seq 20); do echo "0.5 -1"; done >data.txt
"$cageproof" coordinates "${common[@]}" --data data.txt --out functions.npy 2>said || fail "data: $(cat said)"
"$python" - <<'PY' || fail "functions of data are others"
import numpy as np
rows, made = np.load("rows_1.npy"), np.load("functions.npy")
sums = rows[:, :8].sum(axis=1) + rows[:, 32:44].sum(axis=1)
assert made.shape == (1002, 8) and np.allclose(made[:, 0], 0.5 * sums) and np.allclose(made[:, 4], -sums)
PY

# A pipe gets all rows in their order, of .npy too.
for kind in npy csv; do
  mkfifo pipe.$kind
  cat pipe.$kind >through.$kind &
  "$cageproof" coordinates "${common[@]}" --jobs 3 --out pipe.$kind 2>said || fail "a pipe: $(cat said)"
  wait
  cmp through.$kind rows_1.$kind || fail "another .$kind through a pipe"
  rm -f pipe.*
done

# A disk that is full on the way gives an error, and the earlier file stays.
echo old >kept.npy
(ulimit -f 8 && "$cageproof" coordinates "${common[@]}" --out kept.npy >said 2>&1)
[ $? -eq 2 ] && grep -q 'cannot write kept.npy' said || fail "a full disk: $(cat said)"
[ "$(cat kept.npy)" = old ] || fail "a full disk took the old file"
[ -z "$(find . -name '*partial*')" ] || fail "left: $(find . -name '*partial*')"
"$cageproof" coordinates "${common[@]}" >/dev/full 2>said && fail "a full standard output is a success"

# 3 GB of address space hold no table of 3 GB in three copies: refused at once, where .npy goes by blocks.
"$python" - <<'PY'
import random
random.seed(4)
with open("many.xyz", "w") as f:
    for _ in range(100000): f.write("%.3f %.3f %.3f\n" % tuple(random.uniform(-0.45, 0.45) for _ in range(3)))
PY
limited() { (ulimit -v 3000000 && "$cageproof" "$@"); }
for kind in npz vtp; do
  limited coordinates --cage cube --points many.xyz --kind somigliana --order 2 --jobs 1 --out table.$kind >said 2>&1
  [ $? -eq 2 ] || fail "a table that does not fit, as .$kind: $(cat said)"
  grep -q "^cageproof: table.$kind: a table of 100000 points with 2340 numbers each has 1.87 GB, and making this file takes [57].[0-9]* GB, more than half of the memory, 1.54 GB; write .npy or .csv" said ||
    fail "says of .$kind: $(cat said)"
  [ ! -e table.$kind ] || fail "a table that was refused"
done
limited coordinates --cage cube --points many.xyz --kind green --jobs 1 --out table.npy >said 2>&1 || fail "by blocks: $(cat said)"
[ "$(stat -c %s table.npy)" -eq $((128 + 100000 * 20 * 8)) ] || fail "size of table.npy"

# Where memory ends on the way, the message says so, whatever it was taken for. Rows are made by blocks, so that few points take as much as many.
head -n 3000 many.xyz >few.xyz
for kilobytes in 250000 350000 500000; do
  (ulimit -v $kilobytes && "$cageproof" coordinates --cage cube --points few.xyz --kind somigliana --order 2 --jobs 1 --out table.csv) >said 2>&1 ||
    ! grep -q 'unexpected\|bad_alloc' said || fail "of $kilobytes KB: $(cat said)"
  rm -f table.csv table.json
done

[ $failures -eq 0 ] && echo "large tables are written by rows, or refused"
exit $failures
