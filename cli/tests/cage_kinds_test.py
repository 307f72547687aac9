#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Vectors of each kind of coordinates are passed by `cageproof coordinates` in double, in all three checkers, and failed by numbers that are off by 1e-9. Tables hold what the JSON has.

cage_kinds_test.py PATH_OF_CAGEPROOF FOLDER_OF_CHECKERS [KIND.CAGE...]"""
import json
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

PROGRAM, CHECKERS = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
# A polygon and a cage with quads at each change, others at night (cmake/thinned.h says the same of C++'s tests). Others than these take minutes.
CASES = sys.argv[3:] or ["biharmonic_affine.star", "maximum_entropy.bent-box"]
if len(sys.argv) == 3 and os.environ.get("CAGEPROOF_TESTS") == "all":
    CASES += ["green.l-shape", "biharmonic.l-shape", "somigliana.l-shape"]


def run(*command, code=0):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    assert done.returncode == code, (command, done.returncode, done.stdout[-500:], done.stderr[-500:])
    return done.stdout


def replaced(text, old, new):
    assert old in text, old
    return text.replace(old, new, 1)


def write_checkers(kind, has_quads):
    """The checkers with the kind's name, and with functions that read a line of the file `answers` at each call."""
    text = replaced((CHECKERS / "check_cage.py").read_text(), 'KIND = "mean_value"', f'KIND = "{kind}"')
    text = replaced(text, "QUADS = False", f"QUADS = {has_quads}")
    text = replaced(text, "    # Exact differences: in floats they cancel next to a cage.\n", "    return next(ANSWERS)\n")
    Path("check_cage.py").write_text(replaced(text, "\n\ndef minus", '\nANSWERS = ([float(x) for x in line.split()] for line in open("answers"))\n\n\ndef minus'))
    text = replaced((CHECKERS / "check_cage.js").read_text(), "KIND = 'mean_value'", f"KIND = '{kind}'\nconst answers = fs.readFileSync('answers', 'ascii').split('\\n')")
    text = replaced(text, "QUADS = false", f"QUADS = {str(has_quads).lower()}")
    Path("check_cage.js").write_text(replaced(text, "  // Exact differences, as whole", "  return answers.shift().split(' ').map(Number)\n  // Exact differences, as whole"))
    text = replaced((CHECKERS / "check_cage.c").read_text(), 'KIND "mean_value"', f'KIND "{kind}"')
    text = replaced(text, "QUADS 0", f"QUADS {int(has_quads)}")
    text = replaced(text, "  const int dimension = cage->dimension;\n  double sum = 0;", """  static FILE* answers = NULL;
  static char text[1 << 16];
  char* at = text;
  if (!answers) answers = fopen("answers", "r");
  if (!answers || !fgets(text, sizeof text, answers)) exit(3);
  for (char* end = at; *at != '\\n'; at = end) *found++ = strtod(at, &end);
  return;
  const int dimension = cage->dimension;
  double sum = 0;""")
    Path("check_cage.c").write_text(text)
    run("cc", "-std=c99", "-O0", "check_cage.c", "-lm", "-o", "check_cage")


def answers_of(data, kind):
    """All coordinates of all points in double, by the program."""
    numbers = lambda row: " ".join(repr(float.fromhex(x)) for x in row)
    plane = len(data["vertices"][0]) == 2
    lines = ["v " + numbers(v) + (" 0" if plane else "") for v in data["vertices"]]
    lines += [("l " if plane else "f ") + " ".join(str(i + 1) for i in face) for face in data["faces"]]
    Path("cage.obj").write_text("\n".join(lines) + "\n")
    Path("points.txt").write_text("".join(numbers(v["point"]) + "\n" for v in data["vectors"]))
    rows = run(PROGRAM, "coordinates", "--kind", kind, "--cage", "cage.obj", "--points", "points.txt", "--quiet").splitlines()[1:]
    return [[float(x) for x in row.split(",")] for row in rows]


def check_all(vectors, code):
    counts = {tuple(line for line in run(*command, code=code).splitlines() if not line.startswith("worst"))
              for command in (("/usr/bin/python3", "check_cage.py", f"{vectors}.json"), ("node", "check_cage.js", f"{vectors}.json"))}
    counts.add(tuple(sorted(line for line in run("./check_cage", f"{vectors}.txt", code=code).splitlines() if not line.startswith("worst"))))
    assert len({tuple(sorted(c)) for c in counts}) == 1, counts
    return counts.pop()


def table(path):
    """Shape and numbers of an .npy file."""
    raw = path.read_bytes()
    length = struct.unpack("<H", raw[8:10])[0]
    header = raw[10:10 + length].decode()
    shape = tuple(int(x) for x in re.search(r"'shape': \(([^)]*)\)", header).group(1).split(",") if x.strip())
    body = raw[10 + length:]
    code, size = ("d", 8) if "<f8" in header else ("i", 4)
    return shape, struct.unpack(f"<{len(body) // size}{code}", body)


def check_tables(stem, data):
    count, numbers = len(data["vectors"]), sum(b["size"] for b in data["blocks"])
    shape, truths = table(Path(f"{stem}.truths.npy"))
    assert shape == (count, numbers, 2), shape
    for v, vector in enumerate(data["vectors"]):
        for i, text in enumerate(vector["value"]):
            high, low = truths[2 * (v * numbers + i):][:2]
            exact = Fraction(text)
            assert abs(Fraction(high) + Fraction(low) - exact) <= abs(exact) / 2**100, (stem, v, i)
    exact = lambda rows: tuple(float.fromhex(x) for row in rows for x in row)
    dimension = len(data["vertices"][0])
    assert table(Path(f"{stem}.points.npy")) == ((count, dimension), exact(v["point"] for v in data["vectors"])), stem
    assert table(Path(f"{stem}.vertices.npy")) == ((len(data["vertices"]), dimension), exact(data["vertices"])), stem
    corners = max(len(face) for face in data["faces"])
    faces = tuple(i for face in data["faces"] for i in face + [-1] * (corners - len(face)))
    assert table(Path(f"{stem}.faces.npy")) == ((len(data["faces"]), corners), faces), stem
    shape, denominators = table(Path(f"{stem}.denominators.npy"))
    assert shape == (count, len(data["blocks"])) and denominators == tuple(float(x) for v in data["vectors"] for x in v["denominators"]), stem


def main():
    for name in ("check.py", "check.js", "vector_checks.h"):
        shutil.copy(CHECKERS / name, name)
    for case in CASES:
        kind, cage = case.split(".")
        run(PROGRAM, "vectors", "--kinds", kind, "--cages", cage, "--out", "vectors")
        data = json.loads(Path(f"vectors/{case}.json").read_text())
        write_checkers(kind, any(len(face) == 4 for face in data["faces"]))
        answers = answers_of(data, kind)
        write = lambda rows: Path("answers").write_text("".join(" ".join(map(repr, row)) + "\n" for row in rows))
        write(answers)
        counts = check_all(f"vectors/{case}", 0)
        # A number is off in one block after the other.
        end = 0
        for block in data["blocks"]:
            wrong = [list(row) for row in answers]
            middle = max(range(end, end + block["size"]), key=lambda i: abs(wrong[0][i]))
            wrong[0][middle] *= 1 + 1e-9
            end += block["size"]
            write(wrong)
            failed = check_all(f"vectors/{case}", 1)
            assert failed != counts, (case, block)
        check_tables(f"vectors/{case}", data)
        print(f"{case}: {len(data['vectors'])} vectors, blocks of {[b['size'] for b in data['blocks']]}")


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        main()
