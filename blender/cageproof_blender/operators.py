# SPDX-License-Identifier: MIT
"""Operators: bind, pose, unbind. Errors are reported with their reason, and nothing is changed then."""

import uuid
from typing import Any, List, Set

import bpy
from bpy.props import BoolProperty, EnumProperty, PointerProperty, StringProperty

from . import core, scene
from .core import Error

_ITEMS: List[Any] = []  # Blender keeps no texts of its own of these


def _method_items(_self: Any, _context: Any) -> List[Any]:
    if not _ITEMS:
        _ITEMS.extend((name, name, f"cageproof deform --method {name}") for name in core.methods())
    return _ITEMS


class CageproofBinding(bpy.types.PropertyGroup):
    """What a mesh is bound to. An empty token says that it is not."""

    cage: PointerProperty(type=bpy.types.Object, name="Cage")
    method: StringProperty(name="Method")
    parameters: StringProperty(name="Parameters")
    outside: BoolProperty(name="Vertices outside")
    live: BoolProperty(name="Follow the cage", description="Move the mesh whenever its cage changes", default=True)
    key: StringProperty(name="Shape key")
    token: StringProperty()
    error: StringProperty()


def object_of(name: str, what: str) -> Any:
    """A mesh object by its name. Raises Error."""
    found = bpy.data.objects.get(name)
    if found is None or found.type != "MESH":
        raise Error(f"{what} '{name}' is {'no mesh' if found else 'no object of this file'}")
    return found


class _Operator:
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context: Any) -> Set[str]:
        try:
            self.report({"INFO"}, self.run(context))
            return {"FINISHED"}
        except (Error, RuntimeError, MemoryError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}

    def bound_meshes(self, context: Any) -> List[Any]:
        found = [object_of(self.mesh, "mesh")] if self.mesh else [o for o in context.selected_objects if scene.is_bound(o)]
        if not found or not all(map(scene.is_bound, found)):
            raise Error(f"'{self.mesh}' is bound to no cage" if self.mesh else "no bound mesh is selected")
        return found


class CAGEPROOF_OT_bind(_Operator, bpy.types.Operator):
    """Bind the selected meshes to the active object, their cage"""

    bl_idname, bl_label = "cageproof.bind", "Bind to Cage"
    method: EnumProperty(items=_method_items, name="Method")
    parameters: StringProperty(name="Parameters", description="NAME=VALUE, with spaces between: nu=0.3 variant=local")
    outside: BoolProperty(name="Allow Vertices Outside", description="Vertices outside of the cage without an image stay at rest")
    mesh: StringProperty(name="Mesh", options={"SKIP_SAVE"}, description="The mesh's object; the selected ones if empty")
    cage: StringProperty(name="Cage", options={"SKIP_SAVE"}, description="The cage's object; the active one if empty")

    def run(self, context: Any) -> str:
        cage = object_of(self.cage, "cage") if self.cage else context.active_object
        if cage is None or cage.type != "MESH":
            raise Error("no cage: select the mesh, then the cage, so that the cage is the active object")
        meshes = [object_of(self.mesh, "mesh")] if self.mesh else [o for o in context.selected_objects if o.type == "MESH" and o != cage]
        if not meshes:
            raise Error("no mesh: select the mesh, then the cage, so that the cage is the active object")
        depsgraph = context.evaluated_depsgraph_get()
        ready = [self.bound(mesh, cage, depsgraph) for mesh in meshes]
        for mesh, binding in ready:
            self.store(mesh, cage, binding)
            scene.pose(mesh, depsgraph)
        return f"{len(meshes)} mesh(es) follow '{cage.name}' by {self.method}"

    def bound(self, mesh: Any, cage: Any, depsgraph: Any) -> Any:
        if mesh == cage:
            raise Error(f"'{mesh.name}' cannot be its own cage")
        if scene.is_bound(mesh):
            raise Error(f"'{mesh.name}' is bound already: unbind it first")
        if mesh.mode == "EDIT":
            raise Error(f"'{mesh.name}' is being edited: leave Edit Mode first")
        keys = mesh.data.shape_keys
        points = scene.places(keys.reference_key.data if keys else mesh.data.vertices)
        rest = core.moved(scene.to_mesh_space(mesh, cage, depsgraph), scene.cage_places(cage, depsgraph))
        try:
            return mesh, core.Binding(rest, scene.cage_faces(cage), points, self.method, self.parameters, self.outside)
        except Error as error:
            raise Error(f"'{mesh.name}' in '{cage.name}': {error}") from None

    def store(self, mesh: Any, cage: Any, binding: core.Binding) -> None:
        if mesh.data.shape_keys is None:
            mesh.shape_key_add(name="Basis", from_mix=False)
        key = mesh.shape_key_add(name=scene.KEY, from_mix=False)
        key.value = 1.0
        kept = mesh.cageproof
        kept.method, kept.parameters, kept.outside, kept.key = self.method, self.parameters, self.outside, key.name
        kept.live, kept.error = True, ""
        scene.keep(mesh, cage, binding, uuid.uuid4().hex)


class CAGEPROOF_OT_pose(_Operator, bpy.types.Operator):
    """Move the selected meshes to where their cages take them now"""

    bl_idname, bl_label = "cageproof.pose", "Pose by Cage"
    mesh: StringProperty(name="Mesh", options={"SKIP_SAVE"})

    def run(self, context: Any) -> str:
        meshes, depsgraph = self.bound_meshes(context), context.evaluated_depsgraph_get()
        for mesh in meshes:
            if mesh.mode == "EDIT":
                raise Error(f"'{mesh.name}' is being edited: leave Edit Mode first")
            scene.pose(mesh, depsgraph)
            scene.say(mesh, "")
        return f"{len(meshes)} mesh(es) posed"


class CAGEPROOF_OT_unbind(_Operator, bpy.types.Operator):
    """Free the selected meshes from their cages"""

    bl_idname, bl_label = "cageproof.unbind", "Unbind from Cage"
    keep_shape: BoolProperty(name="Keep the Shape", description="Keep the shape key with the last pose")
    mesh: StringProperty(name="Mesh", options={"SKIP_SAVE"})

    def run(self, context: Any) -> str:
        meshes = self.bound_meshes(context)
        for mesh in meshes:
            key = scene.key_of(mesh)
            if key is not None and not self.keep_shape:
                mesh.shape_key_remove(key)
            if scene.REST in mesh:
                del mesh[scene.REST]
            for name in ("cage", "method", "parameters", "outside", "live", "key", "token", "error"):
                mesh.cageproof.property_unset(name)
        return f"{len(meshes)} mesh(es) unbound"


CLASSES = (CageproofBinding, CAGEPROOF_OT_bind, CAGEPROOF_OT_pose, CAGEPROOF_OT_unbind)


def register() -> None:
    for one in CLASSES:
        bpy.utils.register_class(one)
    bpy.types.Object.cageproof = PointerProperty(type=CageproofBinding)


def unregister() -> None:
    del bpy.types.Object.cageproof
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
