# SPDX-License-Identifier: MIT
"""The package `cageproof` where nobody installed it: Blender before 4.2 does not install an add-on's wheels."""

import importlib.util
import shutil
import sys
import zipfile
from pathlib import Path

FOLDER = Path(__file__).resolve().parent


def find() -> None:
    """Makes `import cageproof` work: as it is installed, or else from the wheel beside, unpacked once next to it.

    Raises ImportError if there is neither."""
    found = importlib.util.find_spec("cageproof")
    if found is not None and found.origin:  # a mere folder of that name has no origin
        return
    wheels = sorted((FOLDER / "wheels").glob("cageproof-*.whl"))
    if not wheels:
        raise ImportError(f"no package cageproof, and no wheel in {FOLDER / 'wheels'}: install the zip that blender/build.py makes")
    to = wheels[-1].with_suffix("")
    if not to.is_dir():
        # Aside first: a run that dies leaves no half of the package.
        aside = to.with_name(to.name + ".part")
        shutil.rmtree(aside, ignore_errors=True)
        with zipfile.ZipFile(wheels[-1]) as packed:
            packed.extractall(aside)
        aside.rename(to)
    sys.path.append(str(to))
    importlib.invalidate_caches()
