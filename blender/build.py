#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Builds the extension's zip for Blender: the folder cageproof_blender with the wheel of the package inside.

blender/build.py [--wheel FILE] [--out FOLDER]

Without --wheel it builds the wheel of python/ (docs/python.md) with the library that CAGEPROOF_LIBRARY names, or that of build/release. Prints the zip's path. Exit 0: written; 2: it cannot be, with the reason.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import tomllib
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROJECT, ADD_ON = HERE.parent, HERE / "cageproof_blender"


def build_wheel(to: Path) -> Path:
    """Builds the wheel in a copy, so that the project's folder stays as it is."""
    library = Path(os.environ.get("CAGEPROOF_LIBRARY") or PROJECT / "build/release/lib/libcageproof.so").resolve()
    if not library.is_file():
        raise SystemExit(f"build.py: no file {library}: scripts/build.sh release cageproof_shared builds it")
    copy = to / "project"
    shutil.copytree(PROJECT / "python", copy / "python", ignore=shutil.ignore_patterns("build", "*.egg-info", "__pycache__"))
    (copy / "docs").mkdir()
    for name in ("CMakeLists.txt", "LICENSE", "docs/licences.md"):
        shutil.copyfile(PROJECT / name, copy / name)
    command = [sys.executable, "-m", "pip", "wheel", "--no-index", "--no-build-isolation", "--no-deps", "--wheel-dir", to, copy / "python"]
    done = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "CAGEPROOF_LIBRARY": str(library)})
    if done.returncode:
        raise SystemExit(f"build.py: the wheel cannot be built:\n{(done.stdout + done.stderr)[-2000:]}")
    return next(to.glob("*.whl"))


def entries(wheel: Path) -> tuple:
    """Names in the zip with their contents, and the manifest. One folder holds all, which Blender 3.4 needs and 4.2 allows."""
    manifest = tomllib.loads((ADD_ON / "blender_manifest.toml").read_text())
    wanted = [Path(name).name for name in manifest["wheels"]]
    if wanted != [wheel.name]:
        raise SystemExit(f"build.py: the wheel is {wheel.name}, and blender_manifest.toml names {', '.join(wanted)}: make them the same")
    found = {f"{ADD_ON.name}/{file.name}": file.read_bytes() for file in sorted(ADD_ON.glob("*")) if file.suffix in (".py", ".toml")}
    found[f"{ADD_ON.name}/LICENSE"] = (PROJECT / "LICENSE").read_bytes()
    found[f"{ADD_ON.name}/wheels/{wheel.name}"] = wheel.read_bytes()
    return found, manifest


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--wheel", type=Path, help="a wheel that is there already")
    parser.add_argument("--out", type=Path, default=PROJECT / "build/blender", help="folder for the zip")
    a = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        if a.wheel and not a.wheel.is_file():
            raise SystemExit(f"build.py: no file {a.wheel}")
        found, manifest = entries(a.wheel or build_wheel(Path(folder)))
    a.out.mkdir(parents=True, exist_ok=True)
    to = a.out / f"{manifest['id']}-{manifest['version']}-{manifest['platforms'][0]}.zip"
    aside = to.with_suffix(".part")
    with zipfile.ZipFile(aside, "w", zipfile.ZIP_DEFLATED) as packed:
        for name, content in found.items():
            info = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            info.external_attr = 0o644 << 16
            packed.writestr(info, content, zipfile.ZIP_DEFLATED)
    aside.replace(to)
    print(to)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except SystemExit as stop:
        if isinstance(stop.code, str):
            print(stop.code, file=sys.stderr)
            sys.exit(2)
        raise
