# SPDX-License-Identifier: MIT
"""What docs/examples/blender_cage.py asks of Blender's module bpy, for machines without Blender: objects of a scene, their vertices in single precision, shape keys.
Saving writes the shown shape as text."""
import numpy as np


class Vertices:
    def __init__(self, places):
        self.places = np.asarray(places, dtype=np.float32).reshape(-1, 3)

    def __len__(self):
        return len(self.places)

    def foreach_get(self, name, to):
        assert name == "co"
        to[:] = self.places.ravel()

    def foreach_set(self, name, values):
        assert name == "co" and len(values) == self.places.size
        self.places = np.asarray(values, dtype=np.float32).reshape(-1, 3)


class Key:
    def __init__(self, mesh):
        self.data, self.value = Vertices(mesh.vertices.places.copy()), 0.0


class Keys:
    def __init__(self):
        self.key_blocks = {}


class Mesh:
    def __init__(self, places):
        self.vertices, self.shape_keys = Vertices(places), None

    def update(self):
        pass


class Object:
    def __init__(self, name, places):
        self.name, self.data = name, Mesh(places)

    def shape_key_add(self, name, from_mix):
        assert from_mix is False
        self.data.shape_keys = self.data.shape_keys or Keys()
        return self.data.shape_keys.key_blocks.setdefault(name, Key(self.data))


class data:
    objects = {}


class context:
    selected_objects = []


class ops:
    class wm:
        @staticmethod
        def obj_import(filepath, forward_axis, up_axis):
            # Blender turns axes unless told not to.
            assert (forward_axis, up_axis) == ("Y", "Z")
            with open(filepath) as lines:
                places = [[float(x) for x in line.split()[1:4]] for line in lines if line.startswith("v ")]
            name = filepath.rsplit("/", 1)[-1].rsplit(".", 1)[0]
            data.objects[name] = Object(name, places)
            context.selected_objects[:] = [data.objects[name]]

        @staticmethod
        def save_as_mainfile(filepath):
            for mesh in (o.data for o in data.objects.values() if o.data.shape_keys):
                shown = [key for key in mesh.shape_keys.key_blocks.values() if key.value == 1.0]
                assert len(shown) == 1
                np.savetxt(filepath, shown[0].data.places, fmt="%.9g")
