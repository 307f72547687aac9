# SPDX-License-Identifier: MIT
"""Measures claims of the papers with the command cageproof: python3 claims.py NAME prints one line of figures.

Lengths are divided by the cage's size, the diagonal of its box. docs/claims.md says which claim each NAME measures."""

import itertools
import json
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

import numpy as np

CAGE, POSED, MESH = "my_cage.obj", "my_posed_cage.obj", "my_mesh.obj"


def cageproof(*arguments: object) -> str:
    return subprocess.run(["cageproof", *map(str, arguments)], check=True, capture_output=True, text=True).stderr


def vertices(name: str) -> np.ndarray:
    return np.array([line.split()[1:4] for line in Path(name).read_text().splitlines() if line.startswith("v ")], float)


def size(name: str = CAGE) -> float:
    return float(np.linalg.norm(np.ptp(vertices(name), axis=0)))


def images(method: str, points: np.ndarray, posed: object = POSED, cage: str = CAGE, **parameters: object) -> np.ndarray:
    """The images of points (n x 3) under a method, with its parameters."""
    if isinstance(posed, np.ndarray):
        np.savetxt("pose.txt", posed, fmt="%.17g")
        posed = "pose.txt"
    np.save("at.npy", points)
    options = [part for name, value in parameters.items() for part in ("--parameter", f"{name}={value}")]
    cageproof("deform", "--cage", cage, "--posed", posed, "--points", "at.npy", "--method", method, *options, "--out", "image.npy", "--quiet")
    return np.load("image.npy")


def on_the_cage() -> tuple[np.ndarray, np.ndarray]:
    """Points inside the cage's triangles, 0.3 sizes of them apart, and where the posed triangles have them."""
    cageproof("coordinates", "--cage", CAGE, "--points", MESH, "--kind", "green", "--out", "green.npz", "--quiet")
    triangles = np.load("green.npz")["elements"]
    inside = np.array([(a, b, 1 - a - b) for a in (0.1, 0.3, 0.5, 0.7) for b in (0.1, 0.3, 0.5) if a + b < 0.95])
    return [np.einsum("pk,tkc->tpc", inside, vertices(name)[triangles]).reshape(-1, 3) for name in (CAGE, POSED)]


def figures(named: dict[str, float]) -> str:
    return ", ".join(f"{name} {value:.1e}" if value >= 1e-12 else f"{name} below 1e-12" for name, value in named.items())


def rms(difference: np.ndarray) -> float:
    return float(np.sqrt(np.mean(np.sum(difference**2, axis=-1)))) / size()


def follow() -> str:
    rest, posed = on_the_cage()
    methods = ("mean_value", "green", "somigliana", "biharmonic_1_3", "biharmonic_1_2", "biharmonic_weber")
    return figures({name: rms(images(name, rest) - posed) for name in methods})


def gamma_d() -> str:
    rest, posed = on_the_cage()
    return figures({f"gamma_d={g}": rms(images("biharmonic_1_3", rest, gamma_d=g) - posed) for g in ("0", "0.01", "1", "100", "10000")})


def affine() -> str:
    matrix = np.array([[1.3, 0.05, -0.2], [0.2, 0.8, 0.1], [-0.1, 0.3, 1.1]])
    points = 0.6 * vertices(MESH)
    found = {}
    for name in ("aaap", "ahap", "tp"):
        for alignment in ("free", "hard"):
            moved = images(name, points, vertices(CAGE) @ matrix.T, alignment=alignment)
            found[f"{name} {alignment}"] = rms(moved - points @ matrix.T)
    return figures(found)


def similar() -> str:
    angle, points = 0.7, 0.6 * vertices(MESH)
    turn = 1.5 * np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    shift = np.array([0.3, -0.2, 0.1])
    chosen = {"global": ("somigliana", {"variant": "global"}), "local": ("somigliana", {"variant": "local", "gamma": 2}), "green": ("green", {}),
              "biharmonic_1_3": ("biharmonic_1_3", {}), "biharmonic_1_3 rms": ("biharmonic_1_3", {"normals": "rms"})}
    return figures({name: rms(images(method, points, vertices(CAGE) @ turn.T + shift, **more) - points @ turn.T - shift)
                    for name, (method, more) in chosen.items()})


def infinite_nu() -> str:
    points = 0.6 * vertices(MESH)
    space = rms(images("somigliana", points, nu="inf", gamma=0) - images("green", points, stretch="mean"))
    flat = np.loadtxt("points.csv")
    posed = np.array([[0, 0], [1.2, 0.1], [1.1, 0.9], [-0.2, 1.3]])
    np.savetxt("pose.txt", posed)
    found = []
    for method, parameters in (("somigliana", ["--parameter", "nu=inf", "--parameter", "gamma=0", "--parameter", "variant=local"]), ("green", [])):
        np.save("at.npy", flat)
        cageproof("deform", "--cage", "square", "--posed", "pose.txt", "--points", "at.npy", "--method", method, *parameters, "--out", "image.npy", "--quiet")
        found.append(np.load("image.npy"))
    return figures({"plane": float(np.abs(found[0] - found[1]).max()) / 2**0.5, "space": space})


def unity() -> str:
    """How far coordinates by quadrature are from summing to one, at ten points that near a face of the cube."""
    np.save("at.npy", np.array([[0.1, 0.2, z] for z in np.linspace(0, 0.49, 10)]))
    found = {}
    for rule in ("three-quad-75", "three-quad-1200", "three-quad-7500", "closed_form"):
        cageproof("coordinates", "--cage", "cube", "--points", "at.npy", "--kind", "somigliana", "--evaluation", rule, "--out", "T.npz", "--quiet")
        sums = np.load("T.npz")["T"].sum(axis=1).reshape(-1, 3, 3)
        found[rule] = float(np.abs(sums - np.eye(3)).max())
    return figures(found)


def densities() -> str:
    """The largest density D', in units of the cage's size."""
    found = {}
    for method in ("biharmonic_1_3", "biharmonic_weber", "biharmonic_1_2"):
        cageproof("deform", "--cage", CAGE, "--posed", POSED, "--points", MESH, "--method", method, "--out", "m.obj", "--solved", "solved.npz", "--quiet")
        found[method] = float(np.abs(np.load("solved.npz")["D"]).max()) * size() ** 2
    return figures(found)


def bar_of_tetrahedra(cells: int) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and tetrahedra of a bar 4 x 1 x 1: cells in a row, each cut into six tetrahedra of one volume. All vertices lie on its surface."""
    rest = np.array([(4 * k / cells, y, z) for k in range(cells + 1) for y in (0, 1) for z in (0, 1)], float)
    paths = [np.cumsum([0, *steps]) for steps in itertools.permutations((4, 2, 1))]
    return rest, np.array([4 * k + path for k in range(cells) for path in paths])


def phong_jacobians(rest: np.ndarray, posed: np.ndarray, tetrahedra: np.ndarray, element: int, point: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Jacobians at a point of a tetrahedron: of the linear map there, and of Phong deformation [James 2020], the mean of the linear map and of the vertices'
    maps, which have the mean Jacobian of their tetrahedra and are interpolated linearly."""
    corners = rest[tetrahedra]
    hats = np.linalg.inv(np.concatenate([corners, np.ones((len(corners), 4, 1))], axis=2))  # hats[e, :3, i]: the gradient of corner i's
    linear = np.einsum("eic,eji->ecj", posed[tetrahedra], hats[:, :3])
    vertex = np.array([linear[(tetrahedra == v).any(axis=1)].mean(axis=0) for v in range(len(rest))])
    own = tetrahedra[element]
    moved = posed[own] + np.einsum("icj,ij->ic", vertex[own], point - rest[own])
    weights = np.append(point, 1) @ hats[element]
    taylor = np.einsum("ic,ji->cj", moved, hats[element, :3]) + np.einsum("i,icj->cj", weights, vertex[own])
    return linear[element], (linear[element] + taylor) / 2


def phong() -> str:
    """The largest jump of Jacobians (spectral norm) over the faces between tetrahedra, of a bar bent by a right angle."""
    found = {}
    for cells in (4, 8, 16):
        rest, tetrahedra = bar_of_tetrahedra(cells)
        angle, radius = rest[:, 0] * np.pi / 8, 8 / np.pi
        posed = np.stack([(radius - rest[:, 1] + 0.5) * np.sin(angle), radius - (radius - rest[:, 1] + 0.5) * np.cos(angle), rest[:, 2]], axis=1)
        faces = defaultdict(list)
        for element, corners in enumerate(tetrahedra):
            for face in itertools.combinations(corners, 3):
                faces[face].append(element)
        shared = {face: elements for face, elements in faces.items() if len(elements) == 2}
        centres = np.array([rest[list(face)].mean(axis=0) for face in shared])
        jumps = np.array([[np.linalg.norm(a - b, 2) for a, b in zip(*(phong_jacobians(rest, posed, tetrahedra, e, centre) for e in elements))]
                          for elements, centre in zip(shared.values(), centres)])
        found |= {f"linear {cells}": jumps[:, 0].max(), f"phong {cells}": jumps[:, 1].max()}
    # The cage is the last bar's surface. Its Jacobians on both sides of the faces, 1e-6 apart.
    outward = []
    for face, elements in faces.items():
        a, b, c = rest[list(face)]
        inside = np.cross(b - a, c - a) @ (rest[tetrahedra[elements[0]]].mean(axis=0) - a) > 0
        outward += [face[::-1] if inside else face] if len(elements) == 1 else []
    Path("bar.obj").write_text("".join(f"v {x} {y} {z}\n" for x, y, z in rest) + "".join("f {} {} {}\n".format(*(v + 1 for v in f)) for f in outward))
    normals = np.array([np.cross(*(rest[list(face)][1:] - rest[face[0]])) for face in shared])
    step = 0.5e-6 * normals / np.linalg.norm(normals, axis=1)[:, None]
    np.save("at.npy", np.vstack([centres - step, centres + step]))
    np.savetxt("pose.txt", posed, fmt="%.17g")
    cageproof("deform", "--cage", "bar.obj", "--posed", "pose.txt", "--points", "at.npy", "--method", "somigliana", "--parameter", "variant=local",
              "--parameter", "nu=0", "--order", "1", "--out", "image.npy", "--quiet")
    below, above = np.load("image.npy")[:, 3:].reshape(2, -1, 3, 3)
    found["somigliana"] = np.linalg.norm(above - below, 2, axis=(1, 2)).max()
    return figures(found)


def elastic_held() -> str:
    """Elastic maps of least energy without a posed cage: how far they are from affine targets of points, and, of the map that draws points at random, the
    load that would hold it, (1 - 2 nu) laplacian + grad div of the displacement, relative to second derivatives."""
    at = np.array(list(itertools.product((-0.7, 0, 0.7), (-0.3, 0, 0.3), (-0.3, 0, 0.3))))
    matrix, shift = np.array([[1.3, 0.05, -0.2], [0.2, 0.8, 0.1], [-0.1, 0.3, 1.1]]), np.array([0.3, -0.2, 0.1])
    points, found = at[1:-1] + 0.05, {"affine": 0.0, "load": 0.0}
    np.save("at.npy", points)
    for nu, drawn in itertools.product((0, 0.3, 0.45), (False, True)):
        to = at + 0.1 * np.random.default_rng(0).uniform(-1, 1, at.shape) if drawn else at @ matrix.T + shift
        positions = [{"at": a, "to": b} for a, b in zip(at.tolist(), to.tolist())]
        Path("held.json").write_text(json.dumps({"schema": "cageproof-constraints", "schema_version": 1, "positions": positions, "hessians": at.tolist()}))
        cageproof("deform", "--cage", CAGE, "--constraints", "held.json", "--points", "at.npy", "--method", "variational", "--parameter", "subspace=elastic",
                  "--parameter", f"nu={nu}", "--order", "2", "--out", "image.npy", "--quiet")
        image = np.load("image.npy")
        second = image[:, 12:].reshape(-1, 3, 3, 3)
        if drawn:
            load = (1 - 2 * nu) * np.einsum("pcaa->pc", second) + np.einsum("paac->pc", second)
            found["load"] = max(found["load"], np.abs(load).max() / np.abs(second).max())
        else:
            found["affine"] = max(found["affine"], rms(image[:, :3] - points @ matrix.T - shift))
    return figures(found)


MEASURES = {"densities": densities, "elastic_held": elastic_held, "follow": follow, "gamma_d": gamma_d, "affine": affine, "similar": similar, "infinite_nu": infinite_nu, "phong": phong, "unity": unity}

if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1] not in MEASURES:
        sys.exit(f"usage: python3 claims.py NAME, NAME one of {', '.join(MEASURES)}")
    print(MEASURES[sys.argv[1]]())
