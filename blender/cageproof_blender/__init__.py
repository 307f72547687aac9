# SPDX-License-Identifier: MIT
"""Cageproof in Blender: meshes that follow the edited vertices of a cage (docs/blender.md)."""

# Blender 4.2 and later read blender_manifest.toml instead.
bl_info = {
    "name": "Cageproof",
    "author": "The Cageproof authors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "View3D > Sidebar > Cageproof",
    "description": "Meshes that follow cages, by any kind of cage coordinates",
    "category": "Animation",
}

from . import wheel  # noqa: E402

wheel.find()

from . import operators, panel, scene  # noqa: E402


def register() -> None:
    operators.register()
    panel.register()
    scene.register()


def unregister() -> None:
    scene.unregister()
    panel.unregister()
    operators.unregister()
