# SPDX-License-Identifier: MIT
"""What the add-on computes, without Blender: points bound to a rest cage, and where a posed cage takes them."""

import math
from typing import Any, Dict, List, Sequence

import cageproof
import numpy as np
from cageproof import Error

# The smallest cage: tells which methods and kinds exist in space.
_TETRAHEDRON = ([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
_methods: List[str] = []


def methods() -> List[str]:
    """Methods for cages in space, and kinds of coordinates that multiply vertices; mean_value and green first."""
    if not _methods:
        cage = cageproof.Cage(*_TETRAHEDRON)
        found = [name for name in cageproof.names("methods") if _exists(lambda: cage.deformer(name))]
        found += [name for name in cageproof.names("kinds") if name not in found and _exists(lambda: _weights(cage, name, {}))]
        found.sort(key=lambda name: ({"mean_value": 0, "green": 1}.get(name, 2), name))
        _methods.extend(found)
    return list(_methods)


def _exists(make: Any) -> bool:
    try:
        make()
        return True
    except Error:
        return False


def _weights(cage: cageproof.Cage, kind: str, given: Dict[str, str]) -> cageproof.Coordinates:
    """A kind with one number per vertex. Raises Error for others."""
    prepared = cage.prepare(kind, flip_inward=True, **given)
    if [(b.one_a, b.rows * b.columns) for b in prepared.blocks] != [("vertex", 1)]:
        raise Error(f"{kind} has coordinates of faces, too: choose a method, such as {', '.join(cageproof.names('methods')[:3])}")
    return prepared


def parameters_of(text: str) -> Dict[str, str]:
    """Parameters "nu=0.3 variant=local", as `cageproof deform --parameter` takes them. Raises Error for other words."""
    found = {}
    for word in text.replace(",", " ").split():
        name, sign, value = word.partition("=")
        if not (name and sign and value) or name in found:
            raise Error(f"parameters: '{word}' is not NAME=VALUE, or comes twice; for example nu=0.3")
        found[name] = value
    return found


def between(mesh: Any, cage: Any) -> np.ndarray:
    """From the cage's space to the mesh's (4, 4), of both objects' matrices to the world. Raises Error if the mesh is flat."""
    to_world, from_cage = np.array(mesh, float), np.array(cage, float)
    if np.array_equal(to_world, from_cage):
        return np.eye(4)  # exactly, so that places are the files' own
    if not np.all(np.isfinite(to_world)) or np.linalg.cond(to_world[:3, :3]) > 1e12:
        raise Error("the mesh's object is scaled to nothing along an axis: apply its scale, or give it another")
    return np.linalg.solve(to_world, from_cage)


def moved(matrix: np.ndarray, vertices: np.ndarray) -> np.ndarray:
    """Vertices (n, 3) by a matrix (4, 4) without projection; by the identity exactly themselves."""
    return vertices @ matrix[:3, :3].T + matrix[:3, 3]


def outside_text(indices: Sequence[int], count: int) -> str:
    few = ", ".join(str(i) for i in indices[:5]) + (" ..." if len(indices) > 5 else "")
    return f"{len(indices)} of the mesh's {count} vertices are outside of the cage (vertices {few}, counted from 0)"


class Binding:
    """Points (n, 3) bound to a cage at rest, vertices (m, 3) in the same space and faces of 3 or 4 corners, by a method.

    parameters: text for `parameters_of`. outside: take points outside, too; those without an image there stay at rest.
    Faces may point inward. Raises Error for a mesh that is no cage, points outside, or what the method does not take.
    """

    def __init__(self, vertices: Any, faces: Sequence[Sequence[int]], points: Any, method: str, parameters: str = "", outside: bool = False):
        if method not in methods():
            raise Error(f"method '{method}' is none of {', '.join(methods())}")
        for f, face in enumerate(faces):
            if len(face) not in (3, 4):
                raise Error(f"cage: face {f} has {len(face)} corners: cut it into triangles or quads (Ctrl+T in Edit Mode)")
        self.points = np.array(points, float).reshape(-1, 3)
        self.vertices = np.array(vertices, float).reshape(-1, 3)
        if not len(faces):
            raise Error("cage: it has no faces")
        if not len(self.points):
            raise Error("the mesh has no vertices")
        self.faces = [list(map(int, face)) for face in faces]
        cage = cageproof.Cage(self.vertices, self.faces)
        cage.check(flip_inward=True)
        beyond = np.flatnonzero(cage.inside(self.points, flip_inward=True) < 0)
        if len(beyond) and not outside:
            raise Error(f"{outside_text(beyond, len(self.points))}: enlarge the cage, or allow vertices outside")
        given = parameters_of(parameters)
        if method in cageproof.names("methods"):
            self._deformer = cage.deformer(method, flip_inward=True, **given)
            self._bound = self._deformer.bind(self.points)
        else:
            self._deformer, self._bound = None, _weights(cage, method, given)(self.points)
        self.method, self._outside = method, outside

    def images(self, posed: Any) -> np.ndarray:
        """Where the points go (n, 3) for posed vertices (m, 3). Raises Error for another number of them, or a point without image."""
        to = np.array(posed, float).reshape(-1, 3)
        if len(to) != len(self.vertices):
            raise Error(f"the cage has {len(to)} vertices, and had {len(self.vertices)} when the mesh was bound: unbind, and bind again")
        if not np.all(np.isfinite(to)):
            raise Error(f"the cage's vertex {int(np.argmin(np.isfinite(to).all(axis=1)))} is not finite")
        found = self._bound @ to if self._deformer is None else self._deformer.pose(to).images(self._bound)
        lost = np.flatnonzero(~np.isfinite(found).all(axis=1))
        if len(lost) and not self._outside:
            raise Error(f"{self.method} has no image of the mesh's vertex {lost[0]} ({len(lost)} of {len(found)}, counted from 0)")
        found[lost] = self.points[lost]
        return found


def flat(faces: Sequence[Sequence[int]]) -> List[int]:
    """Faces as one list, each behind its number of corners."""
    return [x for face in faces for x in (len(face), *map(int, face))]


def unflat(numbers: Sequence[int]) -> List[List[int]]:
    found, at = [], 0
    while at < len(numbers):
        size = int(numbers[at])
        found.append([int(x) for x in numbers[at + 1 : at + 1 + size]])
        at += 1 + size
    return found


def in_single(points: np.ndarray) -> np.ndarray:
    """Flat float32, as Blender keeps places. Raises Error for places that this has no numbers for."""
    with np.errstate(over="ignore"):
        found = np.ascontiguousarray(points, np.float32).ravel()
    if not math.isfinite(float(np.abs(found).max(initial=0))):
        raise Error("an image is too far away for Blender's single precision: pose the cage nearer to the origin")
    return found
