# SPDX-License-Identifier: MIT
"""Cage coordinates, deformers, exact inside tests and potentials of triangles, quads and segments.

Arrays in, arrays out: points are (n, 3), in the plane (n, 2), of float64. Arrays that are C-contiguous float64 are not
copied. Errors are raised as cageproof.Error (a ValueError) with the library's text. All functions release the
interpreter's lock, and use all cores unless threads=... says fewer.

    import cageproof
    cage = cageproof.Cage.embedded("cube")
    cage.inside([[0, 0, 0], [2, 0, 0]])           # array([ 1, -1], dtype=int32)
"""

from typing import TYPE_CHECKING, Any

from ._library import Error, names, version
from .cage import Block, BoundPoints, Cage, Coordinates, Deformer, Places, read
from .potentials import Formula, evaluate, formula, potentials

if TYPE_CHECKING:
    from .judging import judge


def __getattr__(name: str) -> Any:
    """What few programs need, and takes long to import: `judge`."""
    if name == "judge":
        from .judging import judge

        return judge
    raise AttributeError(f"module 'cageproof' has no attribute '{name}'")


__version__ = version()
__all__ = [
    "Block",
    "BoundPoints",
    "Cage",
    "Coordinates",
    "Deformer",
    "Error",
    "Formula",
    "Places",
    "evaluate",
    "formula",
    "judge",
    "names",
    "potentials",
    "read",
    "version",
]
