#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# field_page_test.sh CAGEPROOF: a scene of errors side by side, and its page in a browser without network: Chromium draws
# it, and what it drew is looked at. Chromium is one of the packages that `scripts/ensure_packages.sh tests` installs.
set -uo pipefail

cageproof=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
  printf 'FAILED: %s\n' "$*" >&2
  exit 1
}

third_party=$(cd "$(dirname "$0")/../../reports/third_party/vtk.js" && pwd)
(cd "$third_party" && grep -E '^ +[0-9a-f]{64}  ' README.md | sed 's/^ *//' | sha256sum --check --quiet -) || fail "vtk.js is not the file that its README names"

"$cageproof" field --kind green --cage cube --compare gauss-8,published,closed_form --resolution 6 --out "$work/scene" >"$work/stdout" ||
  fail "field --compare: $(cat "$work/stdout")"
grep -q '^gauss-8: relative error: largest found' "$work/stdout" || fail "no largest error: $(cat "$work/stdout")"
name=cube.green.side-by-side
for file in field.html "fields/$name.vti" "fields/$name.cage.vtp" "fields/$name.pvsm" "pictures/field.$name.png"; do
  [ -s "$work/scene/$file" ] || fail "no $file"
done
for array in 'log10 gauss-8: relative error' 'mask closed_form: relative error' 'truth: norm of psi' 'Name="kind"' 'Name="version"'; do
  grep -qF "$array" "$work/scene/fields/$name.vti" || fail "the volume has no $array"
done
[ "$(stat -c %s "$work/scene/field.html")" -lt 1500000 ] || fail "field.html is larger than 1.5 MB"
"$cageproof" field --kind green --cage cube --compare gauss-8,nonsense --out "$work/none" 2>"$work/stderr" && fail "an evaluation that does not exist"
grep -q nonsense "$work/stderr" || fail "does not name it: $(cat "$work/stderr")"
[ ! -e "$work/none" ] || fail "something is left of a refused field"

command -v chromium >/dev/null || fail "chromium is missing: scripts/ensure_packages.sh tests"
browse() {
  timeout 120 chromium --headless --no-sandbox --disable-gpu --use-angle=swiftshader --enable-unsafe-swiftshader --disable-quic --no-first-run \
    --disable-background-networking --disable-component-update --disable-sync --user-data-dir="$work/browser" --window-size=1200,800 \
    --virtual-time-budget=20000 "$@" "file://$work/scene/field.html" 2>"$work/log"
}
browse --dump-dom >"$work/dom" || fail "chromium: $(tail -n 3 "$work/log")"
grep -q 'data-state="drawn"' "$work/dom" || fail "the page drew nothing: $(grep -o 'id="message"[^<]*<' "$work/dom")"
browse --screenshot="$work/page.png" || fail "chromium: $(tail -n 3 "$work/log")"
# Three views with different colours: gauss-8's errors are large, the others' are not.
/usr/bin/python3 - "$work/page.png" <<'PYTHON' || fail "the picture does not show three coloured views"
import sys
from vtkmodules.vtkIOImage import vtkPNGReader
reader = vtkPNGReader()
reader.SetFileName(sys.argv[1])
reader.Update()
image = reader.GetOutput()
width, height, _ = image.GetDimensions()
colours = []
for view in range(3):
    found = {}
    for x in range(view * width // 3 + 4, (view + 1) * width // 3 - 4, 3):
        for y in range(height * 3 // 10, height * 8 // 10, 3):
            rgb = tuple(int(image.GetScalarComponentAsDouble(x, y, 0, c)) for c in range(3))
            if max(rgb) - min(rgb) > 30:
                found[rgb] = found.get(rgb, 0) + 1
    assert sum(found.values()) > 300, (view, sum(found.values()))
    colours.append(max(found, key=found.get))
green = [rgb[1] for rgb in colours]
print(colours)
assert green[0] > green[2] + 40, colours
PYTHON
echo "field_page_test: passed"
