# SPDX-License-Identifier: MIT
"""[W12]'s figures beside baselines that need a mesh of the inside (claims_meshed.py)."""

import json
from pathlib import Path

import numpy as np

from claims_meshed import HermiteMeanValue, Mesh, bounded_weights, moving_least_squares, rigid, similar
from claims_tools import cageproof

BAR = [*((x, 0) for x in range(7)), (6, 1), *((x, 2) for x in range(6, -1, -1)), (0, 1)]
GIRAFFE = [(0, 0), (0.6, 0), (0.6, 1.6), (2.4, 1.6), (2.4, 0), (3, 0), (3, 1.6), (3, 2.8), (3, 4.1), (3, 5.4), (4.2, 5.4), (4.2, 6.2), (3, 6.2), (2.4, 6.2),
           (2.4, 5.4), (2.4, 4.1), (2.4, 2.8), (0.6, 2.8), (0, 2.8), (0, 1.6)]
SNAKE = [*((x, 0) for x in range(10)), *((x, 1) for x in range(9, -1, -1))]
TROUSERS = [(0, 0), (1.7, 0), (2, 3), (2.3, 0), (4, 0), (3.64, 3), (3.4, 5), (2, 5), (0.6, 5), (0.36, 3)]
L = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]


def write_polygon(corners: list[tuple[float, float]]) -> Path:
    count = len(corners)
    lines = [f"v {x} {y} 0" for x, y in corners] + [f"l {k + 1} {(k + 1) % count + 1}" for k in range(count)]
    file = Path("polygon.obj")
    file.write_text("\n".join(lines) + "\n")
    return file


def plane(points: np.ndarray) -> np.ndarray:
    return np.stack([points.real, points.imag], axis=-1)


def by_thickness(corners, held: np.ndarray, to: np.ndarray, points: np.ndarray) -> np.ndarray:
    positions = [{"at": a, "to": b} for a, b in zip(plane(held).tolist(), plane(to).tolist())]
    Path("held.json").write_text(json.dumps({"schema": "cageproof-constraints", "schema_version": 1, "positions": positions}))
    np.save("at.npy", plane(points))
    cageproof("deform", "--cage", write_polygon(corners), "--constraints", "held.json", "--points", "at.npy", "--on", "1e-12", "--method", "thickness",
              "--out", "image.npy", "--quiet")
    return np.load("image.npy") @ (1, 1j)


def by_bounded_weights(mesh: Mesh, held: np.ndarray, to: np.ndarray) -> np.ndarray:
    return mesh.points + bounded_weights(mesh, held) @ (to - mesh.points[held])


def all_methods(mesh: Mesh, corners, held: np.ndarray, to: np.ndarray) -> dict[str, np.ndarray]:
    return {"mls similar": moving_least_squares(mesh.points, mesh.points[held], to, False),
            "mls rigid": moving_least_squares(mesh.points, mesh.points[held], to, True), "asap": similar(mesh, held, to), "arap": rigid(mesh, held, to),
            "bounded": by_bounded_weights(mesh, held, to), "thickness": by_thickness(corners, mesh.points[held], to, mesh.points)}


def bent(points: np.ndarray) -> np.ndarray:
    """The bar bent to half a circle."""
    radius = 6 / np.pi
    return 3 + 1j * (1 - radius) + 1j * (radius + points.imag - 1) * np.exp(-1j * (points.real - 3) / radius)


def least_width(mesh: Mesh, images: np.ndarray, length: float, height: float) -> float:
    """Of a bar whose sides lie along y = 0 and y = height: the least distance of points opposite to each other, over the height."""
    below, above = (mesh.nearest(np.arange(0.5, length, 0.5) + side) for side in (0, 1j * height))
    return float(np.abs(images[above] - images[below]).min() / height)


def bar() -> dict[str, float]:
    """Three held points bend a bar to half a circle: its least width, and the largest difference of Jacobians between two triangles at a held point."""
    mesh = Mesh(BAR, [((0, 6, 8, 14), 24, 8)])
    held = mesh.nearest(np.array([0.5 + 1j, 3 + 1j, 5.5 + 1j]))
    found = {}
    for name, images in all_methods(mesh, BAR, held, bent(mesh.points[held])).items():
        found[f"{name} width"] = least_width(mesh, images, 6, 2)
        z, zbar = mesh.derivative(mesh.dz, images), mesh.derivative(mesh.dzbar, images)
        around = [np.flatnonzero((mesh.triangles == v).any(axis=1)) for v in held]
        found[f"{name} kink"] = max(float((np.abs(z[t][:, None] - z[t]) + np.abs(zbar[t][:, None] - zbar[t])).max()) for t in around)
    return found


def giraffe() -> dict[str, float]:
    """A giraffe whose body and head are held lower: how much of the head's area is left, and by how much of its length the neck goes aside."""
    mesh = Mesh(GIRAFFE, [((0, 1, 2, 19), 2, 5), ((19, 2, 17, 18), 2, 4), ((2, 3, 16, 17), 6, 4), ((4, 5, 6, 3), 2, 5), ((3, 6, 7, 16), 2, 4),
                          ((16, 7, 8, 15), 2, 4), ((15, 8, 9, 14), 2, 4), ((14, 9, 12, 13), 2, 3), ((9, 10, 11, 12), 4, 3)])
    held = mesh.nearest(np.array([0.3 + 0.32j, 2.7 + 0.32j, 0.3 + 2.2j, 2.7 + 2.2j, 3 + 5.67j]))
    to = mesh.points[held] - 1j * np.array([0, 0, 0.5, 0.5, 1.6])
    head = mesh.points[mesh.triangles].imag.min(axis=1) > 5.3
    neck = (np.abs(mesh.points.real - 2.7) < 0.1) & (mesh.points.imag > 2.8) & (mesh.points.imag < 5.4)
    found = {}
    for name, images in all_methods(mesh, GIRAFFE, held, to).items():
        found[f"{name} head"] = float(mesh.areas_of(images)[head].sum() / mesh.areas[head].sum())
        found[f"{name} aside"] = float(np.abs(images[neck].real - 2.7).max() / 2.6)
    return found


def snake() -> dict[str, float]:
    """Five points wind a long bar: the area and the least width that are left, by bounded weights with shifts of held points, with rotations estimated from these,
    and by thickness."""
    mesh = Mesh(SNAKE, [((0, 9, 10, 19), 36, 4)])
    held = mesh.nearest(np.array([0.5, 2.5, 4.5, 6.5, 8.5]) + 0.5j)
    at = mesh.points[held]
    to = 0.9 * at.real + 1j * np.array([0.5, 1.3, -0.3, 1.3, 0.5])
    weights = bounded_weights(mesh, held)
    # The rotation at a held point that moves its neighbours along the chain best.
    turns = np.ones(len(held), complex)
    for k in range(len(held)):
        others = [j for j in (k - 1, k + 1) if 0 <= j < len(held)]
        turns[k] = sum((to[j] - to[k]) * np.conj(at[j] - at[k]) for j in others)
    turns /= np.abs(turns)
    maps = {"bounded": by_bounded_weights(mesh, held, to),
            "bounded turned": (weights * (to + turns * (mesh.points[:, None] - at))).sum(axis=1),
            "thickness": by_thickness(SNAKE, at, to, mesh.points)}
    found = {}
    for name, images in maps.items():
        found[f"{name} area"] = float(mesh.areas_of(images).sum() / mesh.areas.sum())
        found[f"{name} width"] = least_width(mesh, images, 9, 1)
    return found


def unit_normals(corners: np.ndarray) -> np.ndarray:
    along = np.roll(corners, -1) - corners
    return -1j * along / np.abs(along)


def legs() -> dict[str, float]:
    """By how much of the cage's size the still leg of a pair of trousers moves when the other is lifted."""
    rest = np.array(TROUSERS) @ (1, 1j)
    posed = rest.copy()
    posed[3], posed[4] = 4.1 + 0.55j, 5.5 + 1.4j
    u, v = np.meshgrid((0.1, 0.5, 0.9), (0.02, 0.1, 0.3, 0.5))
    leg = (rest[0] + (rest[1] - rest[0]) * u + v * ((rest[9] - rest[0]) * (1 - u) + (rest[2] - rest[1]) * u)).ravel()
    np.save("at.npy", plane(leg))
    np.savetxt("pose.txt", plane(posed))
    found = {}
    for method, parameters in (("mean_value", []), ("harmonic", []), ("green", []), ("biharmonic_boundary", ["--parameter", "pieces=8"])):
        cageproof("deform", "--cage", write_polygon(TROUSERS), "--posed", "pose.txt", "--points", "at.npy", "--method", method, *parameters, "--out", "image.npy",
                  "--quiet")
        found[method] = np.load("image.npy") @ (1, 1j)
    hermite = HermiteMeanValue(rest).interpolant(plane(posed), plane(unit_normals(posed)))
    found["hermite mean value"] = np.array([hermite(p) for p in leg]) @ (1, 1j)
    size = np.hypot(4, 5)
    return {name: float(np.abs(images - leg).max() / size) for name, images in found.items()}


def negative() -> dict[str, float]:
    """How far below zero the coordinates of an L's corners (of its edges, where it says beta) are at most."""
    rest = np.array(L) @ (1, 1j)
    mesh = Mesh(L, [((0, 1, 2, 3), 12, 6), ((0, 3, 4, 5), 6, 12)])
    inside = np.array([complex(x, y) for x in np.arange(0.1, 2, 0.1) for y in np.arange(0.1, 2, 0.1) if min(x, y) < 0.95])
    np.save("at.npy", plane(inside))
    found = {}
    for kind, blocks in (("mean_value", ["lambda"]), ("harmonic", ["lambda"]), ("biharmonic_goursat", ["alpha", "beta"])):
        cageproof("coordinates", "--cage", write_polygon(L), "--points", "at.npy", "--kind", kind, "--out", "c.npz", "--quiet")
        found |= {f"{kind} {block}": np.load("c.npz")[block] for block in blocks}
    found["bounded"] = bounded_weights(mesh, mesh.nearest(rest))
    hermite = HermiteMeanValue(rest)
    six, none = np.eye(6), np.zeros((6, 6))
    for name, at in (("alpha", hermite.interpolant(six, none)), ("beta", hermite.interpolant(none, six))):
        found[f"hermite mean value {name}"] = np.array([at(p) for p in inside])
    return {name: max(0.0, -float(values.min())) for name, values in found.items()}


MEASURES = {"bar": bar, "giraffe": giraffe, "legs": legs, "negative": negative, "snake": snake}
