#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Real cages and meshes of others, where they lie next to the project: their data set's licence forbids a copy here. Exit code 77, which CTest lists as skipped,
# where they are absent. Usage: real_cage_test.sh PATH_OF_CAGEPROOF FOLDER
data=$(readlink -f "$2")
# shellcheck source=support.sh
source "$(dirname "$(readlink -f "$0")")/support.sh"
[ -d "$data" ] || { echo "skipped: no folder $data"; exit 77; }

"$cageproof" verify --cage "$data/SpikyBox_Cage.obj" --points "$data/SpikyBox.obj" --formulas triangle.single_layer --suite quick --samples 16 --out report >said ||
  fail "verify: $(cat said)"
for name in FireHydrant SpikyBox WireSphere Bench; do
  "$cageproof" deform --cage "$data/${name}_Cage.obj" --posed "$data/${name}_Cage_Deformed.obj" --points "$data/$name.obj" --method green --outside rest --out moved.obj ||
    fail "deform $name"
  [ "$(grep -c '^v ' moved.obj)" -eq "$(grep -c '^v ' "$data/$name.obj")" ] || fail "$name lost vertices"
done
[ $failures -eq 0 ] && echo 'Real cages are verified and deformed.'
exit $((failures > 0))
