# SPDX-License-Identifier: MIT
"""Cages, and the coordinates, deformers and inside tests that are made of them."""

from ctypes import byref, c_int, c_size_t
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from ._library import CBlock, Error, Handle, call, library, numbers, options, passed, points_of, result

Arrays = Union[np.ndarray, Tuple[np.ndarray, ...]]


class Block(NamedTuple):
    """A block of coordinates, such as the phi of all vertices."""

    label: str  #: "phi", "psi", "lambda" ...
    one_a: str  #: what a coordinate belongs to: "vertex", "element", "corner" or "normal"
    reproduces: str  #: the data that it multiplies to reproduce a linear map: "vertices", "turned vertices", "normals", "nothing"
    count: int  #: number of coordinates
    rows: int  #: of each coordinate; 1 and 1 for numbers
    columns: int
    offset: int  #: where its first number stands in a point's row
    normal_factor: float


class Places(NamedTuple):
    """Where points lie: one entry per point in each array."""

    place: np.ndarray  #: 1 inside, 0 on the surface, -1 outside
    face: np.ndarray  #: the first face that the point is on, from 0; -1 for none
    winding: np.ndarray  #: winding number of the surface around the point; NaN on it
    bound: np.ndarray  #: the largest error of `winding`; 0 where it is exact


class Cage:
    """A mesh of triangles and quads in space, or of segments in the plane.

    vertices: (n, 3), in the plane (n, 2), finite. faces: (m, 3), (m, 4), in the plane (m, 2), or a list of lists of both
    3 and 4, of vertices from 0, counter-clockwise seen from outside. Immutable. `check()`, and all that make coordinates
    of the mesh, refuse it unless it is closed, oriented and without broken faces.
    """

    def __init__(self, vertices: Any, faces: Any):
        given = numbers(vertices, "vertices")
        if given.ndim != 2 or given.shape[1] not in (2, 3):
            raise Error(f"vertices: the shape is {given.shape}, not (n, 3) or (n, 2)")
        if isinstance(faces, np.ndarray) and faces.ndim == 2 and np.issubdtype(faces.dtype, np.integer):
            corners, sizes = faces.ravel(), np.full(len(faces), faces.shape[1], np.int32)
        else:
            rows = [np.asarray(face) for face in faces]
            for f, row in enumerate(rows):
                if row.ndim != 1 or not np.issubdtype(row.dtype, np.integer):
                    raise Error(f"faces: face {f} is no list of whole numbers (faces counted from 0)")
            corners = np.concatenate(rows) if rows else np.empty(0, np.int64)
            sizes = np.array([len(row) for row in rows], np.int32)
        if corners.size and (corners.min() < -(2**31) or corners.max() >= 2**31):
            raise Error("faces: an index is out of range")
        corners = np.ascontiguousarray(corners, np.int32)
        self._own(Handle("cage", "cage_make", given.shape[1], *passed(given), *passed(corners), *passed(sizes)))

    @classmethod
    def embedded(cls, name: str) -> "Cage":
        """Returns a built-in cage; `names("cages")` lists all."""
        return cls._made(Handle("cage", "cage_embedded", name.encode()))

    @classmethod
    def _made(cls, handle: Handle) -> "Cage":
        cage = cls.__new__(cls)
        cage._own(handle)
        return cage

    def _own(self, handle: Handle) -> None:
        self._handle, self._inside = handle, {}
        dimension, count, corners, faces = c_int(), c_size_t(), c_size_t(), c_size_t()
        call("cage_sizes", handle.pointer, byref(dimension), byref(count), byref(corners), byref(faces))
        #: of space: 3, or 2 for the plane
        self.dimension: int = dimension.value
        #: (n, dimension), read-only
        self.vertices = np.empty((count.value // self.dimension, self.dimension))
        self._corners, self._sizes = np.empty(corners.value, np.int32), np.empty(faces.value, np.int32)
        call("cage_copy", handle.pointer, *passed(self.vertices), *passed(self._corners), *passed(self._sizes))
        self.vertices.flags.writeable = False
        #: what was left out of a file, or cut in triangles
        self.warnings: List[str] = []
        while (text := library.cageproof_cage_warning(handle.pointer, len(self.warnings))) is not None:
            self.warnings.append(text.decode())

    @property
    def faces(self) -> List[List[int]]:
        """The vertices of each face, as new lists."""
        corners, ends = self._corners.tolist(), np.cumsum(self._sizes).tolist()
        return [corners[first:end] for first, end in zip([0, *ends], ends)]

    def check(self, **given: Any) -> None:
        """Raises Error for a mesh that is no cage, naming the face or vertex at fault."""
        call("cage_check", self._handle.pointer, *options(given))

    def prepare(self, kind: str, **given: Any) -> "Coordinates":
        """Prepares coordinates of a kind ("green", "mean_value" ...) for many calls.

        Options: evaluation, triangulation ("shortest", "fan"), flip_inward, allow_invalid_quads, threads, and the
        kind's parameters (nu, mu, pieces ...)."""
        return Coordinates(self, kind, **given)

    def coordinates(self, kind: str, points: Any, order: int = 0, **given: Any) -> Arrays:
        """Computes coordinates of points: prepare(kind, **options)(points, order)."""
        return Coordinates(self, kind, **given)(points, order)

    def deformer(self, method: str, **given: Any) -> "Deformer":
        """Prepares a method of `names("methods")`, which moves points with poses of this cage. Options as for `prepare`, and digits."""
        return Deformer(self, method, **given)

    def inside(self, points: Any, any_mesh: bool = False, threads: int = 0, **given: Any) -> np.ndarray:
        """Returns 1 for each point inside, 0 exactly on the surface, and -1 outside: (n,) int32. Arguments as for `places`."""
        return self.places(points, any_mesh, threads, **given).place

    def places(self, points: Any, any_mesh: bool = False, threads: int = 0, **given: Any) -> Places:
        """Returns where points lie, with faces and winding numbers.

        any_mesh: accept open, overlapping or inconsistently oriented faces; a point is then inside if its winding number is
        above 1/2 or below -1/2. Options: triangulation, flip_inward, keep_quads."""
        key = (any_mesh, tuple(sorted(given.items())))
        if key not in self._inside:
            self._inside[key] = Handle("inside", "inside_make", self._handle.pointer, int(any_mesh), *options(given))
        at = points_of(points, self.dimension)
        found = Places(np.empty(len(at), np.int32), np.empty(len(at), np.int32), np.empty(len(at)), np.empty(len(at)))
        call("inside_points", self._inside[key].pointer, *passed(at), threads, *(x for array in found for x in passed(array)))
        return found

    def __repr__(self) -> str:
        return f"<cageproof.Cage of {len(self.vertices)} vertices and {len(self._sizes)} faces>"


def read(file: Any) -> Cage:
    """Reads a mesh from an OBJ file; faces of more than four corners are cut in triangles (`warnings` says so)."""
    import os

    return Cage._made(Handle("cage", "cage_read", os.fsencode(file)))


class Coordinates:
    """Coordinates of one kind in one cage: call it with points. Thread-safe."""

    def __init__(self, cage: Cage, kind: str, **given: Any):
        self._handle = Handle("coordinates", "coordinates_make", cage._handle.pointer, kind.encode(), *options(given))
        pointer = self._handle.pointer
        dimension, order, row, blocks, elements = c_int(), c_int(), c_size_t(), c_size_t(), c_size_t()
        call("coordinates_sizes", pointer, byref(dimension), byref(order), byref(row), byref(blocks), byref(elements))
        self.kind, self.dimension, self.max_order = kind, dimension.value, order.value
        self._vertices = len(cage.vertices)
        #: numbers per point
        self.row: int = row.value
        self.blocks: List[Block] = []
        for index in range(blocks.value):
            b = CBlock()
            call("coordinates_block", pointer, index, byref(b))
            texts = (b.label.decode(), b.one_a.decode(), b.reproduces.decode())
            self.blocks.append(Block(*texts, b.count, b.rows, b.columns, b.offset, b.normal_factor))
        #: (elements, 4): vertices of the elements that coordinates belong to, -1 beyond the last
        self.elements = np.empty((elements.value, 4), np.int32)
        #: the cage's face that each element is, or is part of
        self.element_faces = np.empty(elements.value, np.int32)
        #: (elements, dimension): unit, outward
        self.normals = np.empty((elements.value, self.dimension))
        call("coordinates_elements", pointer, *passed(self.elements), *passed(self.element_faces), *passed(self.normals))

    def __call__(self, points: Any, order: int = 0, out: Optional[Arrays] = None) -> Arrays:
        """Returns values (n, row); with order=1 also gradients (n, row, dimension), with order=2 also Hessians (n, row,
        dimension, dimension), as a tuple. On the cage they are limits from inside; derivatives that do not exist are NaN.

        out: an array for the result, or a tuple of them, to be filled again and again: new memory takes a third of the
        time of cheap coordinates."""
        at = points_of(points, self.dimension)
        if order not in (0, 1, 2):
            raise Error(f"order {order} is none of 0, 1, 2")
        to = [out] if isinstance(out, np.ndarray) or out is None else list(out)
        if out is not None and len(to) != order + 1:
            raise Error(f"out: {len(to)} arrays, not {order + 1}")
        found = [result((len(at), self.row) + (self.dimension,) * o, to[o] if out is not None else None) for o in range(order + 1)]
        spans = [x for o in range(3) for x in passed(found[o] if o <= order else None)]
        if len(at):
            call("coordinates_evaluate", self._handle.pointer, *passed(at), *spans)
        return found[0] if order == 0 else tuple(found)

    def apply(self, points: Any, data: Any) -> np.ndarray:
        """Returns sums of coordinates times data (row, functions), without keeping coordinates: (n, functions)."""
        at, given = points_of(points, self.dimension), numbers(data, "data")
        if given.ndim not in (1, 2) or given.shape[0] != self.row:
            raise Error(f"data: the shape is {given.shape}, not ({self.row},) or ({self.row}, functions)")
        sums = np.empty((len(at),) + given.shape[1:])
        functions = given.shape[1] if given.ndim == 2 else 1
        if len(at):
            call("coordinates_apply", self._handle.pointer, *passed(at), *passed(given), functions, *passed(sums))
        return sums

    def jvp(self, points: Any, change: Any, out: Optional[np.ndarray] = None) -> np.ndarray:
        """Returns the change of values (n, row) under a change of the cage's vertices (vertices, dimension), to first order,
        for points that stay where they are. Only for the kind "green"; NaN on edges and vertices."""
        at, given = points_of(points, self.dimension), points_of(change, self.dimension, "change")
        found = result((len(at), self.row), out)
        call("coordinates_jvp", self._handle.pointer, *passed(at), *passed(given), *passed(found))
        return found

    def vjp(self, points: Any, weights: Any, out: Optional[np.ndarray] = None) -> np.ndarray:
        """Returns a function's derivatives by the cage's vertices (vertices, dimension) from those by the values (n, row),
        the weights. Only for the kind "green"."""
        at, given = points_of(points, self.dimension), numbers(weights, "weights")
        if given.shape != (len(at), self.row):
            raise Error(f"weights: the shape is {given.shape}, not {(len(at), self.row)}")
        found = result((self._vertices, self.dimension), out)
        call("coordinates_vjp", self._handle.pointer, *passed(at), *passed(given), *passed(found))
        return found

    def split(self, values: np.ndarray) -> Dict[str, np.ndarray]:
        """Returns values, gradients or Hessians by block, as views: {"phi": (n, count, ...), "psi": ...}; coordinates that are
        matrices have shape (n, count, rows, columns, ...)."""
        parts = {}
        for b in self.blocks:
            part = values[:, b.offset : b.offset + b.count * b.rows * b.columns]
            matrix = (b.rows, b.columns) if b.rows * b.columns > 1 else ()
            parts[b.label] = part.reshape((len(values), b.count) + matrix + values.shape[2:])
        return parts


class BoundPoints:
    """Points whose coordinates a Deformer keeps."""

    def __init__(self, handle: Handle, count: int, jacobians: bool):
        self._handle, self._count, self.has_jacobians = handle, count, jacobians

    def __len__(self) -> int:
        return self._count


class Deformer:
    """The map of points by a posed cage, with one method. `images` is thread-safe, `pose` is not."""

    def __init__(self, cage: Cage, method: str, **given: Any):
        self._handle = Handle("deformer", "deformer_make", cage._handle.pointer, method.encode(), *options(given))
        self.method, self.dimension, self._vertices = method, cage.dimension, len(cage.vertices)

    def pose(self, vertices: Any) -> "Deformer":
        """Sets the posed cage's vertices, in the rest cage's order; returns itself."""
        posed = points_of(vertices, self.dimension, "posed vertices")
        call("deformer_pose", self._handle.pointer, *passed(posed))
        return self

    def bind(self, points: Any, jacobians: bool = False) -> BoundPoints:
        """Computes and keeps the points' coordinates, so that their `images` are quick for any number of poses."""
        at = points_of(points, self.dimension)
        handle = Handle("bound", "deformer_bind", self._handle.pointer, *passed(at), int(jacobians))
        return BoundPoints(handle, len(at), jacobians)

    def images(self, points: Any, jacobians: bool = False, out: Optional[np.ndarray] = None) -> Arrays:
        """Returns the images of points or BoundPoints: (n, dimension), and with jacobians=True also the Jacobians (n,
        component, axis). NaN for points without image, such as those outside the cage with "green". out: an array for the
        images."""
        bound = isinstance(points, BoundPoints)
        at = None if bound else points_of(points, self.dimension)
        shape = (len(points if bound else at), self.dimension)
        images = result(shape, out)
        maps = np.empty(shape + (self.dimension,)) if jacobians else None
        if bound:
            call("bound_images", self._handle.pointer, points._handle.pointer, *passed(images), *passed(maps))
        else:
            call("deformer_images", self._handle.pointer, *passed(at), *passed(images), *passed(maps))
        return images if maps is None else (images, maps)

    def jvp(self, points: Any, change: Any, out: Optional[np.ndarray] = None) -> np.ndarray:
        """Returns the change of images (n, dimension) under a change of the posed vertices (vertices, dimension), to first
        order: the derivative J of images by the pose, times the change. NaN for points without image.

        points: as for `images`. Raises Error for methods without derivatives, naming those that have them."""
        given = points_of(change, self.dimension, "change")
        return self._product("jvp", points, given, lambda count: result((count, self.dimension), out))

    def vjp(self, points: Any, weights: Any, out: Optional[np.ndarray] = None) -> np.ndarray:
        """Returns a function's derivatives by the posed vertices (vertices, dimension) from those by the images (n,
        dimension): the transposed J times these weights. Weights of points without image must be zero.

        points: as for `images`. Raises Error as `jvp`."""
        given = points_of(weights, self.dimension, "weights")
        return self._product("vjp", points, given, lambda count: result((self._vertices, self.dimension), out))

    def _product(self, name: str, points: Any, given: np.ndarray, room: Callable[[int], np.ndarray]) -> np.ndarray:
        if isinstance(points, BoundPoints):
            product = room(len(points))
            call("bound_" + name, self._handle.pointer, points._handle.pointer, *passed(given), *passed(product))
        else:
            at = points_of(points, self.dimension)
            product = room(len(at))
            call("deformer_" + name, self._handle.pointer, *passed(at), *passed(given), *passed(product))
        return product


__all__: Sequence[str] = ["Block", "BoundPoints", "Cage", "Coordinates", "Deformer", "Places", "read"]
