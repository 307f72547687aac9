# SPDX-License-Identifier: MIT
"""Measures claims of the papers with the command cageproof: python3 claims.py NAME prints one line of figures.

Lengths are divided by the cage's size, the diagonal of its box. docs/claims.md says which claim each NAME measures."""

import itertools
import json
import sys
from collections import defaultdict
from pathlib import Path

import numpy as np

import claims_plane
from claims_appendix import appendix_a
from claims_tools import CAGE, MESH, POSED, cageproof, figures, images, size, timed, vertices, write_mesh


def on_the_cage() -> tuple[np.ndarray, np.ndarray]:
    """Points inside the cage's triangles, 0.3 sizes of them apart, and where the posed triangles have them."""
    cageproof("coordinates", "--cage", CAGE, "--points", MESH, "--kind", "green", "--out", "green.npz", "--quiet")
    triangles = np.load("green.npz")["elements"]
    inside = np.array([(a, b, 1 - a - b) for a in (0.1, 0.3, 0.5, 0.7) for b in (0.1, 0.3, 0.5) if a + b < 0.95])
    return [np.einsum("pk,tkc->tpc", inside, vertices(name)[triangles]).reshape(-1, 3) for name in (CAGE, POSED)]


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


def cube_of(cells: int) -> tuple[np.ndarray, np.ndarray]:
    """The unit cube, each face in cells x cells squares of two triangles."""
    points, triangles = [], []
    square = np.array(list(itertools.product(range(cells + 1), repeat=2))) / cells
    own = np.arange((cells + 1) ** 2).reshape(cells + 1, -1)
    a, b, c, d = (x.ravel() for x in (own[:-1, :-1], own[1:, :-1], own[1:, 1:], own[:-1, 1:]))
    for axis, side in itertools.product(range(3), (0, 1)):
        first = len(points) * len(square)
        points.append(np.insert(square, 0, side, axis=1)[:, np.argsort([axis, (axis + 1) % 3, (axis + 2) % 3])])
        both = first + np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
        triangles.append(both if side else both[:, ::-1])
    corners, number = np.unique(np.concatenate(points), axis=0, return_inverse=True)
    return corners, number.reshape(-1)[np.concatenate(triangles)]


def body_load() -> dict[str, float]:
    """How far [C23] Eq 5 is from the displacement (x^2 / 2, 0, 0) of a constant load, from its values at vertices and its tractions at the middles of triangles.
    The integral of K over the body needs no points inside: K is a / r I - b grad grad r, and 1 / r and grad grad r integrate to layers of the surface."""
    nu, found = 0.3, {}
    a = 1 / (4 * np.pi)
    b = a / (4 * (1 - nu))
    points = np.array([[0.3, 0.4, 0.6], [0.55, 0.2, 0.35]])
    np.save("at.npy", points)
    expected = np.stack([points[:, 0] ** 2 / 2, *np.zeros((2, 2))], axis=1)
    load = np.array([-(1 + 1 / (1 - 2 * nu)), 0, 0])  # of Eq 1 after its erratum, the sign of the load
    for cells in (1, 2, 4):
        corners, triangles = cube_of(cells)
        write_mesh("cube.obj", corners, triangles)
        for kind, more in (("biharmonic", ["--order", "1"]), ("somigliana", ["--parameter", f"nu={nu}"])):
            cageproof("coordinates", "--cage", "cube.obj", "--points", "at.npy", "--kind", kind, *more, "--out", f"{kind}.npz", "--quiet")
        layers, matrices = np.load("biharmonic.npz"), np.load("somigliana.npz")
        normals = layers["element_normals"]
        of_r = 8 * np.pi * np.einsum("pta,tc->pac", layers["psibar_gradient"], normals)
        of_load = (a * -4 * np.pi * layers["phibar"].sum(axis=1)[:, None, None] * np.eye(3) + b * of_r) @ load
        moved = np.stack([corners[:, 0] ** 2 / 2, *np.zeros((2, len(corners)))], axis=1)
        middle = corners[triangles].mean(axis=1)[:, 0]
        stress = middle[:, None, None] * (2 * nu / (1 - 2 * nu) * np.eye(3) + 2 * np.diag([1, 0, 0]))
        tractions = np.einsum("tij,tj->ti", stress, normals)
        without = np.einsum("pvij,vj->pi", matrices["T"], moved) + np.einsum("ptij,tj->pi", matrices["K"], tractions)
        found[f"{len(triangles)} triangles"] = float(np.abs(without + of_load - expected).max())
    return found | {"load as printed": float(np.abs(without - of_load - expected).max()), "no load": float(np.abs(without - expected).max())}


def boundary_scheme_in_space() -> dict[str, float]:
    """[W12]'s scheme in a cube: Laplacians at vertices and their slopes on triangles from a biharmonic function's values at vertices and its slopes, at three
    places per triangle by least squares. How far it is from the function at three points inside."""
    def function(p: np.ndarray) -> np.ndarray:
        return (p**2).sum(axis=1) * (p[:, 0] * p[:, 1] + p[:, 2])

    def gradient(p: np.ndarray) -> np.ndarray:
        x, y, z = p.T
        return 2 * p * (x * y + z)[:, None] + (p**2).sum(axis=1)[:, None] * np.stack([y, x, np.ones_like(x)], axis=1)

    inside, found = np.array([[0.3, 0.4, 0.6], [0.55, 0.2, 0.35], [0.5, 0.5, 0.5]]), {}
    for cells in (1, 2, 4):
        corners, triangles = cube_of(cells)
        write_mesh("cube.obj", corners, triangles)
        shares = np.full((3, 3), 0.1875) + 0.4375 * np.eye(3)  # dyadic, so that places are exactly on the cube
        places = np.einsum("qk,tkc->tqc", shares, corners[triangles]).reshape(-1, 3)
        hats = np.zeros((len(places), len(corners)))
        np.put_along_axis(hats, np.repeat(triangles, 3, axis=0), np.tile(shares, (len(triangles), 1)), axis=1)
        np.save("at.npy", np.concatenate([places, inside]))
        cageproof("coordinates", "--cage", "cube.obj", "--points", "at.npy", "--kind", "biharmonic", "--out", "c.npz", "--quiet")
        layers = np.load("c.npz")
        phi, psi, phibar, psibar = (layers[name][: len(places)] for name in ("phi", "psi", "phibar", "psibar"))
        values, slopes = function(corners), np.einsum("tc,tc->t", gradient(corners[triangles].mean(axis=1)), layers["element_normals"])
        equations = np.block([[phi - hats, psi], [phibar, psibar]])
        right = np.concatenate([np.zeros(len(places)), (hats - phi) @ values - psi @ slopes])
        solved = np.linalg.lstsq(equations, right, rcond=None)[0]
        at = np.concatenate([layers[name][len(places):] for name in ("phi", "psi", "phibar", "psibar")], axis=1)
        found[f"{len(triangles)} triangles"] = float(np.abs(at @ np.concatenate([values, slopes, solved]) - function(inside)).max())
    return found


def seconds_of_poses(poses: int, *arguments: object) -> tuple[float, float]:
    """Processor time of deform on one thread: for a cage, its points and one pose, and for each further pose."""
    def run(count: int) -> float:
        posed = [part for _ in range(count) for part in ("--posed", "pose.txt")]
        return timed("deform", *arguments, *posed, "--points", "at.npy", "--out", "film.mdd", "--jobs", "1", "--quiet")

    first = min(run(1), run(1))
    return first, (run(1 + poses) - first) / poses


def frames_of_the_plane() -> str:
    """A polygon of 100 edges, and 1,000 points of a drawing."""
    angle = 2 * np.pi * np.arange(100) / 100
    corners = np.stack([np.cos(angle), np.sin(angle)], axis=1) * (1 + 0.2 * np.cos(5 * angle))[:, None]
    claims_plane.write_polygon(corners.tolist())
    np.savetxt("pose.txt", corners * (1.2, 0.9))
    np.save("at.npy", 0.7 * np.random.default_rng(0).uniform(-0.7, 0.7, (1000, 2)))
    first, next_ = seconds_of_poses(1000, "--cage", "polygon.obj", "--method", "biharmonic_boundary", "--parameter", "pieces=1")
    return f"first {first:.1e} s, further {next_:.1e} s"


def frames_in_space() -> str:
    """A sphere of 80 triangles, and 39,028 points, as many as the model of [C23] has."""
    cageproof("list", "--cage", "icosphere", "--out", "sphere.obj")
    np.savetxt("pose.txt", vertices("sphere.obj") * (1.2, 0.9, 1))
    np.save("at.npy", 0.4 * np.random.default_rng(0).uniform(-1, 1, (39028, 3)))
    first, next_ = seconds_of_poses(10, "--cage", "sphere.obj", "--method", "somigliana")
    return f"first {first:.1e} s, further {next_:.1e} s"


MEASURES = {"densities": densities, "elastic_held": elastic_held, "follow": follow, "gamma_d": gamma_d, "affine": affine, "similar": similar,
            "infinite_nu": infinite_nu, "phong": phong, "unity": unity, "appendix_a": appendix_a, "body_load": body_load, "boundary_scheme_in_space": boundary_scheme_in_space,
            "frames_of_the_plane": frames_of_the_plane, "frames_in_space": frames_in_space} | claims_plane.MEASURES

if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1] not in MEASURES:
        sys.exit(f"usage: python3 claims.py NAME, NAME one of {', '.join(MEASURES)}")
    measured = MEASURES[sys.argv[1]]()
    print(measured if isinstance(measured, str) else figures(measured))
