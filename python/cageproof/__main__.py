# SPDX-License-Identifier: MIT
"""python -m cageproof: runs the program `cageproof` where it is installed; else has inside, coordinates and deform."""

import argparse
import os
import shutil
import sys
from pathlib import Path

import numpy as np

from . import Cage, Error, Places, names, read, version


def cage_of(text: str) -> Cage:
    return Cage.embedded(text) if text in names("cages") and not Path(text).exists() else read(text)


def points_of(file: str) -> np.ndarray:
    """The vertices of an OBJ file, an array of .npy, or text with a point per line."""
    if file.lower().endswith(".npy"):
        return np.load(file)
    if file.lower().endswith(".obj"):
        return np.array([[float(x) for x in line.split()[1:4]] for line in open(file) if line.startswith("v ")])
    try:
        with open(file) as lines:
            return np.array([[float(x) for x in line.replace(",", " ").split()] for line in lines if line.strip()])
    except ValueError as error:
        raise Error(f"{file}: {error}") from None


def write(file: str, header: str, table: np.ndarray, faces_of: str = "") -> None:
    """A table as .npy, or as CSV with digits that are read back exactly; points also as OBJ, with the faces of another."""
    if file.lower().endswith(".npy"):
        np.save(file, table)
        return
    rows = [",".join(repr(float(x)) for x in row) for row in table]
    if file.lower().endswith(".obj"):
        rows = ["v " + row.replace(",", " ") for row in rows]
        if faces_of.lower().endswith(".obj"):
            rows += [line.rstrip() for line in open(faces_of) if line.startswith("f ")]
    else:
        rows.insert(0, header)
    write_text(file, "\n".join(rows) + "\n")


def write_places(file: str, found: Places) -> None:
    """As the program writes them: words in CSV, numbers in .npy."""
    if file.lower().endswith(".npy"):
        np.save(file, np.column_stack(found))
        return
    words = {1: "inside", 0: "on", -1: "outside"}
    rows = [f"{words[p]},{f},{repr(float(w))},{repr(float(b))}".replace(".0,", ",") for p, f, w, b in zip(*(x.tolist() for x in found))]
    rows = [row[:-2] if row.endswith(".0") else row for row in rows]
    write_text(file, "\n".join(["place,face,winding_number,bound", *rows]) + "\n")


def write_text(file: str, text: str) -> None:
    """On standard output for no file; else aside first, so that no half is left."""
    if not file:
        sys.stdout.write(text)
        return
    aside = Path(file + ".part")
    aside.write_text(text)
    aside.replace(file)


def main() -> int:
    program = shutil.which("cageproof")
    if program:
        os.execv(program, [program, *sys.argv[1:]])
    parser = argparse.ArgumentParser(prog="python -m cageproof", description=__doc__)
    parser.add_argument("--version", action="version", version=f"cageproof {version()}")
    commands = parser.add_subparsers(dest="command", required=True)
    for name in ("inside", "coordinates", "deform"):
        command = commands.add_parser(name)
        command.add_argument("--cage", required=True, help="an OBJ file, or the name of an embedded cage")
        command.add_argument("--points", required=True, help="OBJ, .npy, or text with a point per line")
        command.add_argument("--out", default="", help=".npy, .csv (of deform also .obj); standard output if not given")
        if name == "inside":
            command.add_argument("--any-mesh", action="store_true")
        if name == "coordinates":
            command.add_argument("--kind", required=True)
            command.add_argument("--order", type=int, default=0)
        if name == "deform":
            command.add_argument("--posed", required=True, help="the posed cage: OBJ, .npy or text")
            command.add_argument("--method", required=True)
        if name != "inside":
            command.add_argument("--parameter", action="append", default=[], metavar="NAME=VALUE")
    a = parser.parse_args()
    try:
        cage, points = cage_of(a.cage), points_of(a.points)
        if a.command == "inside":
            write_places(a.out, cage.places(points, any_mesh=a.any_mesh))
            return 0
        options = dict(text.split("=", 1) if "=" in text else (text, "") for text in a.parameter)
        if a.command == "coordinates":
            prepared = cage.prepare(a.kind, **options)
            found = prepared(points, a.order)
            arrays = found if isinstance(found, tuple) else (found,)
            header = ",".join(f"{b.label}_{i}" for b in prepared.blocks for i in range(b.count * b.rows * b.columns))
            if len(arrays) > 1:
                header += "".join(f",d{o}_{i}" for o in range(1, len(arrays)) for i in range(arrays[o][0].size))
            write(a.out, header, np.hstack([array.reshape(len(points), -1) for array in arrays]))
        else:
            images = cage.deformer(a.method, **options).pose(points_of(a.posed)).images(points)
            write(a.out, "x,y,z"[: 2 * cage.dimension - 1], images, a.points)
        return 0
    except (Error, OSError, MemoryError) as error:
        print(f"cageproof: {error}", file=sys.stderr)
        return 2


sys.exit(main())
