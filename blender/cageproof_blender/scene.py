# SPDX-License-Identifier: MIT
"""Between Blender's objects and `core`: what is bound, posing, and the handlers that make meshes follow their cages."""

from typing import Any, Dict, List, Optional, Tuple

import bmesh
import bpy
import numpy as np

from . import core
from .core import Error

KEY = "Cageproof"
REST = "cageproof_rest"  # custom property: rest places in double precision, and the cage's faces
_bindings: Dict[str, core.Binding] = {}
_posed: Dict[Tuple[str, str], np.ndarray] = {}  # what each mesh was last posed by
_busy = False


def is_bound(mesh: Any) -> bool:
    return mesh is not None and mesh.type == "MESH" and bool(mesh.cageproof.token)


def places(data: Any) -> np.ndarray:
    """Vertices (n, 3) of a mesh, or of a shape key's data."""
    found = np.empty(3 * len(data), np.float32)
    data.foreach_get("co", found)
    return found.reshape(-1, 3).astype(float)


def cage_places(cage: Any, depsgraph: Any) -> np.ndarray:
    """The cage's vertices as they are shown: with shape keys, armatures and other modifiers, or as they are being edited."""
    if cage.mode == "EDIT":
        return np.array([v.co[:] for v in bmesh.from_edit_mesh(cage.data).verts], float).reshape(-1, 3)
    shown = cage.evaluated_get(depsgraph)
    mesh = shown.to_mesh()
    found = places(mesh.vertices)
    shown.to_mesh_clear()
    if len(found) != len(cage.data.vertices):
        raise Error(
            f"modifiers give cage '{cage.name}' {len(found)} vertices instead of {len(cage.data.vertices)}: "
            "apply or remove those that add or take vertices"
        )
    return found


def cage_faces(cage: Any) -> List[List[int]]:
    if cage.mode == "EDIT":
        return [[v.index for v in face.verts] for face in bmesh.from_edit_mesh(cage.data).faces]
    return [list(face.vertices) for face in cage.data.polygons]


def to_mesh_space(mesh: Any, cage: Any, depsgraph: Any) -> np.ndarray:
    return core.between(mesh.evaluated_get(depsgraph).matrix_world, cage.evaluated_get(depsgraph).matrix_world)


def rest_of(mesh: Any) -> Tuple[np.ndarray, List[List[int]], np.ndarray]:
    """The cage's rest vertices and faces and the mesh's rest points, as they were bound; all in the mesh's space."""
    if REST not in mesh:
        raise Error(f"'{mesh.name}' has lost its custom property {REST}: unbind, and bind again")
    kept = mesh[REST]
    return (
        np.array(kept["cage"].to_list()).reshape(-1, 3),
        core.unflat(kept["faces"].to_list()),
        np.array(kept["points"].to_list()).reshape(-1, 3),
    )


def binding_of(mesh: Any) -> core.Binding:
    """The mesh's binding, computed again after a file was loaded."""
    kept = mesh.cageproof
    if kept.token not in _bindings:
        vertices, faces, points = rest_of(mesh)
        _bindings[kept.token] = core.Binding(vertices, faces, points, kept.method, kept.parameters, kept.outside)
    return _bindings[kept.token]


def keep(mesh: Any, cage: Any, binding: core.Binding, token: str) -> None:
    _bindings[token] = binding
    mesh[REST] = {"cage": binding.vertices.ravel().tolist(), "faces": core.flat(binding.faces), "points": binding.points.ravel().tolist()}
    mesh.cageproof.cage, mesh.cageproof.token = cage, token


def key_of(mesh: Any) -> Optional[Any]:
    keys = mesh.data.shape_keys
    return keys.key_blocks.get(mesh.cageproof.key) if keys else None


def pose(mesh: Any, depsgraph: Any, again: bool = True) -> bool:
    """Moves the mesh's shape key to where its cage takes it now; without `again` only if the cage has changed. True if it moved.

    Raises Error if cage or mesh are not those that were bound."""
    cage = mesh.cageproof.cage
    if cage is None or cage.name not in depsgraph.scene.objects:
        raise Error(f"the cage of '{mesh.name}' is not in the scene: bring it back, or unbind")
    binding = binding_of(mesh)
    if len(mesh.data.vertices) != len(binding.points):
        raise Error(
            f"'{mesh.name}' has {len(mesh.data.vertices)} vertices, and had {len(binding.points)} when it was bound: "
            "unbind, and bind again"
        )
    at = core.moved(to_mesh_space(mesh, cage, depsgraph), cage_places(cage, depsgraph))
    last = (mesh.cageproof.token, mesh.name)
    if not again and last in _posed and np.array_equal(at, _posed[last]):
        return False
    _posed[last] = at  # also if it fails: an error is said once per pose
    if len(at) == len(binding.vertices) and cage_faces(cage) != binding.faces:
        raise Error(f"the faces of cage '{cage.name}' are others than when '{mesh.name}' was bound: unbind, and bind again")
    images = core.in_single(binding.images(at))
    key = key_of(mesh)
    if key is None:
        raise Error(f"the shape key '{mesh.cageproof.key}' of '{mesh.name}' is gone: unbind, and bind again")
    key.data.foreach_set("co", images)
    mesh.data.update()
    return True


def say(mesh: Any, text: str) -> None:
    """Keeps an error for the panel, and prints it once."""
    if mesh.cageproof.error != text:
        mesh.cageproof.error = text
        if text:
            print(f"Cageproof: {text}")


@bpy.app.handlers.persistent
def follow(scene: Any, depsgraph: Any = None) -> None:
    """Poses each live mesh whose cage has changed."""
    global _busy
    if _busy or depsgraph is None:
        return
    _busy = True
    try:
        for mesh in scene.objects:
            if is_bound(mesh) and mesh.cageproof.live and mesh.mode != "EDIT":
                try:
                    if pose(mesh, depsgraph, again=False):
                        say(mesh, "")
                except (Error, RuntimeError, MemoryError) as error:
                    say(mesh, str(error))
    finally:
        _busy = False


@bpy.app.handlers.persistent
def forget(*_: Any) -> None:
    """Another file has other objects."""
    _bindings.clear()
    _posed.clear()


_HANDLERS = (("depsgraph_update_post", follow), ("frame_change_post", follow), ("load_post", forget))


def register() -> None:
    for name, handler in _HANDLERS:
        getattr(bpy.app.handlers, name).append(handler)


def unregister() -> None:
    for name, handler in _HANDLERS:
        getattr(bpy.app.handlers, name).remove(handler)
    forget()
