"""Moves a mesh with its posed cage in Blender, as a shape key.

    blender --background --python blender_cage.py -- coordinates.npz mesh.obj posed_cage.obj saved.blend

mesh.obj is what coordinates.npz was computed for, posed_cage.obj its cage with vertices moved, in their order. In Blender's own window,
where both are objects of the scene already, paste this in the text editor and call `pose("coordinates.npz", "Mesh", "Cage")`.
"""
import os
import sys

import bpy
import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from apply_npz import deform


def vertices(mesh):
    flat = np.empty(3 * len(mesh.vertices))
    mesh.vertices.foreach_get("co", flat)
    return flat.reshape(-1, 3)


def pose(npz, mesh_name, cage_name, key_name="posed by its cage"):
    """Adds the shape key, or moves it where it is there already, and shows it."""
    for name in (mesh_name, cage_name):
        if name not in bpy.data.objects:
            raise SystemExit(f"no object {name}: there are {', '.join(bpy.data.objects.keys())}")
    mesh, cage = bpy.data.objects[mesh_name], bpy.data.objects[cage_name]
    stored = np.load(npz)
    for what, found, wanted in (("mesh", len(mesh.data.vertices), len(stored["points"])),
                                ("cage", len(cage.data.vertices), len(stored["cage_vertices"]))):
        if found != wanted:
            raise SystemExit(f"the {what} has {found} vertices, and {npz} is for {wanted}")
    moved = deform(npz, vertices(cage.data))
    if mesh.data.shape_keys is None:
        mesh.shape_key_add(name="Basis", from_mix=False)
    keys = mesh.data.shape_keys.key_blocks
    key = keys[key_name] if key_name in keys else mesh.shape_key_add(name=key_name, from_mix=False)
    key.data.foreach_set("co", moved.ravel())
    key.value = 1.0
    mesh.data.update()
    return moved


def load(file):
    """Imports an OBJ as it is, without turning its axes; the name of the object."""
    bpy.ops.wm.obj_import(filepath=os.path.abspath(file), forward_axis="Y", up_axis="Z")
    return bpy.context.selected_objects[0].name


if __name__ == "__main__" and "--" in sys.argv:
    arguments = sys.argv[sys.argv.index("--") + 1:]
    if len(arguments) != 4:
        raise SystemExit(__doc__)
    pose(arguments[0], load(arguments[1]), load(arguments[2]))
    bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath(arguments[3]))
