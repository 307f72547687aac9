# SPDX-License-Identifier: MIT
"""The tab Cageproof in the sidebar of the 3D view."""

from typing import Any

import bpy

from . import operators, scene


class CAGEPROOF_PT_panel(bpy.types.Panel):
    bl_label, bl_idname = "Cageproof", "CAGEPROOF_PT_panel"
    bl_space_type, bl_region_type, bl_category = "VIEW_3D", "UI", "Cageproof"

    def draw(self, context: Any) -> None:
        column, mesh = self.layout.column(), context.active_object
        if not scene.is_bound(mesh):
            column.label(text="Select meshes, then their cage")
            column.operator(operators.CAGEPROOF_OT_bind.bl_idname)
            return
        bound = mesh.cageproof
        column.label(text=f"{mesh.name} follows {bound.cage.name if bound.cage else 'no object'}")
        column.label(text=f"{bound.method} {bound.parameters}")
        column.prop(bound, "live")
        key = scene.key_of(mesh)
        if key is not None:
            column.prop(key, "value", text="Strength")
        column.operator(operators.CAGEPROOF_OT_pose.bl_idname)
        column.operator(operators.CAGEPROOF_OT_unbind.bl_idname)
        if bound.error:
            column.label(text=bound.error, icon="ERROR")


def register() -> None:
    bpy.utils.register_class(CAGEPROOF_PT_panel)


def unregister() -> None:
    bpy.utils.unregister_class(CAGEPROOF_PT_panel)
