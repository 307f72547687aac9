# SPDX-License-Identifier: MIT
"""Run by `blender --background --python-exit-code 1 --python in_blender.py -- ZIP FOLDER`: installs the zip and uses its operators.

FOLDER has cage.json and points.npy, and gets images.npy and later.npy, which blender_test.sh compares with `cageproof deform`."""

import json
import sys
from pathlib import Path

import bmesh
import bpy
import numpy as np

ZIP, FOLDER = sys.argv[sys.argv.index("--") + 1 :]
FOLDER = Path(FOLDER)


def mesh(name, vertices, faces=()):
    data = bpy.data.meshes.new(name)
    data.from_pydata([list(map(float, v)) for v in vertices], [], [list(f) for f in faces])
    found = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(found)
    return found


def refused(call, text):
    """Operators that report an error raise it for scripts."""
    try:
        call()
    except RuntimeError as error:
        assert text in str(error), f"'{text}' is not in: {error}"
    else:
        raise AssertionError(f"not refused: {text}")


def key(of):
    data = of.data.shape_keys.key_blocks["Cageproof"].data
    found = np.empty(3 * len(data), np.float32)
    data.foreach_get("co", found)
    return found.reshape(-1, 3)


def move(cage, to):
    cage.data.vertices.foreach_set("co", np.asarray(to, np.float32).ravel())
    cage.data.update()
    bpy.context.view_layer.update()


bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.preferences.addon_install(filepath=ZIP)
bpy.ops.preferences.addon_enable(module="cageproof_blender")
given = json.loads((FOLDER / "cage.json").read_text())
rest, posed, faces, points = np.array(given["rest"]), np.array(given["posed"]), given["faces"], np.load(FOLDER / "points.npy")
cage, follower = mesh("Cage", rest, faces), mesh("Follower", points)

# Refusals name their reason, and change nothing.
hole, far, pentagon = mesh("Hole", rest, faces[1:]), mesh("Far", points + 9), mesh("Pentagon", rest, [[0, 1, 2, 3, 4]])
bind, pose, unbind = bpy.ops.cageproof.bind, bpy.ops.cageproof.pose, bpy.ops.cageproof.unbind
refused(lambda: bind(mesh="Follower", cage="Hole", method="green"), "the cage has a hole")
refused(lambda: bind(mesh="Far", cage="Cage", method="green"), f"{len(points)} of the mesh's {len(points)} vertices are outside")
refused(lambda: bind(mesh="Follower", cage="Pentagon", method="green"), "face 0 has 5 corners")
refused(lambda: bind(mesh="Follower", cage="None", method="green"), "cage 'None' is no object of this file")
refused(lambda: bind(mesh="Follower", cage="Cage", method="green", parameters="nu=0.3"), "nu=0.3")
refused(lambda: bind(mesh="Cage", cage="Cage", method="green"), "its own cage")
refused(lambda: pose(mesh="Follower"), "is bound to no cage")
assert follower.data.shape_keys is None and not follower.cageproof.token and "cageproof_rest" not in follower

# Bound, the mesh follows the edited cage without being asked, under another place, turn and scale of both, too.
assert bind(mesh="Follower", cage="Cage", method="green") == {"FINISHED"}
assert np.abs(key(follower) - points).max() < 1e-6
refused(lambda: bind(mesh="Follower", cage="Cage", method="green"), "bound already")
move(cage, posed)
np.save(FOLDER / "images.npy", key(follower))
assert np.abs(key(follower) - points).max() > 0.1
parent = bpy.data.objects.new("Parent", None)
bpy.context.scene.collection.objects.link(parent)
cage.parent = follower.parent = parent
parent.location, parent.rotation_euler, parent.scale = (1, 2, 3), (0.3, 0.2, 0.1), (2, 2, 2)
before = key(follower)
bpy.context.view_layer.update()
assert np.abs(key(follower) - before).max() < 1e-5
cage.location = (0.25, 0, 0)
bpy.context.view_layer.update()
assert np.abs(key(follower) - before - [0.25, 0, 0]).max() < 1e-5
cage.location = (0, 0, 0)
bpy.context.view_layer.update()

# Without "Follow the cage" only the operator moves it.
follower.cageproof.live = False
move(cage, rest)
assert np.abs(key(follower) - before).max() < 1e-5
assert pose(mesh="Follower") == {"FINISHED"}
assert np.abs(key(follower) - points).max() < 1e-5
follower.cageproof.live = True

# A cage that is animated by a shape key moves the mesh from frame to frame.
cage.shape_key_add(name="Basis", from_mix=False)
bent = cage.shape_key_add(name="Bent", from_mix=False)
bent.data.foreach_set("co", np.asarray(posed, np.float32).ravel())
for frame, value in ((1, 0.0), (11, 1.0)):
    bent.value = value
    bent.keyframe_insert("value", frame=frame)
bpy.context.scene.frame_set(1)
assert np.abs(key(follower) - points).max() < 1e-5
bpy.context.scene.frame_set(11)
assert np.abs(key(follower) - np.load(FOLDER / "images.npy")).max() < 1e-5
# The renderer gets the mesh as evaluated for the frame, not for the one before.
shown = follower.evaluated_get(bpy.context.evaluated_depsgraph_get()).data.vertices
assert np.abs(np.array([v.co[:] for v in shown]) - np.load(FOLDER / "images.npy")).max() < 1e-5

# A saved file keeps what is bound.
file = str(FOLDER / "saved.blend")
bpy.ops.wm.save_as_mainfile(filepath=file)
bpy.ops.wm.open_mainfile(filepath=file)
cage, follower = bpy.data.objects["Cage"], bpy.data.objects["Follower"]
bpy.context.scene.frame_set(1)
assert np.abs(key(follower) - points).max() < 1e-5
bpy.context.scene.frame_set(11)
np.save(FOLDER / "later.npy", key(follower))

# Edited meshes and cages are named, by the handler as by the operator.
cage.modifiers.new("Finer", "SUBSURF")
bpy.context.view_layer.update()
refused(lambda: pose(mesh="Follower"), "apply or remove those that add or take vertices")
assert "apply or remove" in follower.cageproof.error
cage.modifiers.clear()
bpy.context.view_layer.update()
assert pose(mesh="Follower") == {"FINISHED"} and follower.cageproof.error == ""
cage.data = mesh("Other", rest * 1.5, faces[::-1]).data
bpy.context.view_layer.update()
refused(lambda: pose(mesh="Follower"), "the faces of cage 'Cage' are others")
cage.data = mesh("Fewer", rest[:4], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]).data
bpy.context.view_layer.update()
refused(lambda: pose(mesh="Follower"), f"has 4 vertices, and had {len(rest)} when the mesh was bound")
bpy.data.objects.remove(cage)
refused(lambda: pose(mesh="Follower"), "is not in the scene")

# After unbinding nothing is left, or only the shape.
assert unbind(mesh="Follower") == {"FINISHED"}
assert "Cageproof" not in follower.data.shape_keys.key_blocks and not follower.cageproof.token and "cageproof_rest" not in follower
cage, follower.parent = mesh("Again", rest, faces), None
assert bind(mesh="Follower", cage="Again", method="mean_value") == {"FINISHED"}
assert unbind(mesh="Follower", keep_shape=True) == {"FINISHED"}
assert "Cageproof" in follower.data.shape_keys.key_blocks

# Selected objects, the cage last; a kind of coordinates that is no method of its own; points outside, which stay without an image.
follower, far = mesh("Second", points), bpy.data.objects["Far"]
for one in (follower, far, cage):
    one.select_set(True)
bpy.context.view_layer.objects.active = cage
refused(lambda: bind(method="green"), "'Far' in 'Again': 200 of the mesh's 200 vertices are outside")
assert not follower.cageproof.token
assert bind(method="green", outside=True) == {"FINISHED"}
move(cage, posed)
assert np.abs(key(far) - points - 9).max() < 1e-5 and np.array_equal(key(follower), np.load(FOLDER / "images.npy"))
assert unbind() == {"FINISHED"} and not far.cageproof.token and not follower.cageproof.token
move(cage, rest)
assert bind(mesh="Second", cage="Again", method="positive_mean_value") == {"FINISHED"}
move(cage, rest * 2)
assert np.abs(key(follower) - 2 * points).max() < 1e-5

# A cage in Edit Mode moves the mesh while it is edited.
far.select_set(False)
follower.select_set(False)
bpy.ops.object.mode_set(mode="EDIT")
edited = bmesh.from_edit_mesh(cage.data)
for vertex, to in zip(edited.verts, rest * 3):
    vertex.co = to
bmesh.update_edit_mesh(cage.data)
bpy.context.view_layer.update()
assert np.abs(key(follower) - 3 * points).max() < 1e-5
bpy.ops.object.mode_set(mode="OBJECT")

# A mesh that was edited since.
follower.data = mesh("Edited", points[:5]).data
refused(lambda: pose(mesh="Second"), "'Second' has 5 vertices, and had 200 when it was bound")
bpy.ops.preferences.addon_disable(module="cageproof_blender")
print("all is well in Blender", bpy.app.version_string)
