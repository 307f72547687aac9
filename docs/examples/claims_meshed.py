# SPDX-License-Identifier: MIT
"""Baselines of [W12]'s figures that need a mesh of the inside, or none of the cage: small, dense, in NumPy. Points of the plane are complex numbers."""

from collections.abc import Callable

import numpy as np

Patch = tuple[tuple[int, int, int, int], int, int]


class Mesh:
    """A polygon's inside in triangles: quads of its corners, each cut into so many cells along its first and its second edge."""

    def __init__(self, corners: list[tuple[float, float]], patches: list[Patch]) -> None:
        at = np.array(corners) @ (1, 1j)
        points, quads = [], []
        for (a, b, c, d), across, up in patches:
            u, v = np.meshgrid(np.linspace(0, 1, across + 1), np.linspace(0, 1, up + 1))
            first = len(points)
            points += list(((1 - v) * ((1 - u) * at[a] + u * at[b]) + v * ((1 - u) * at[d] + u * at[c])).ravel())
            for j in range(up):
                for i in range(across):
                    k = first + j * (across + 1) + i
                    quads.append((k, k + 1, k + across + 2, k + across + 1))
        _, kept, number = np.unique(np.round(points, 9), return_index=True, return_inverse=True)
        self.points = np.array(points)[kept]
        quads = number[np.array(quads)]
        # Diagonals in turns, so that none of the two directions is preferred.
        odd = np.arange(len(quads)) % 2 == 1
        quads[odd] = np.roll(quads[odd], 1, axis=1)
        self.triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
        p = self.points[self.triangles]
        along = np.roll(p, 1, axis=1) - np.roll(p, -1, axis=1)  # opposite to each corner
        double = (np.conj(p[:, 1] - p[:, 0]) * (p[:, 2] - p[:, 0])).imag
        self.areas = double / 2
        # f_z and f_zbar of each triangle as sums over its corners: a hat's gradient is 1j times the opposite edge over the double area.
        gradient = 1j * along / double[:, None]
        self.dz, self.dzbar = np.conj(gradient) / 2, gradient / 2

    def derivative(self, rows: np.ndarray, images: np.ndarray) -> np.ndarray:
        return np.einsum("tc,tc->t", rows, images[self.triangles])

    def energy(self, rows: np.ndarray) -> np.ndarray:
        """The matrix of the integral of |f_z|^2 or |f_zbar|^2."""
        found = np.zeros((len(self.points), len(self.points)), complex)
        blocks = np.einsum("t,ta,tb->tab", self.areas, rows.conj(), rows)
        np.add.at(found, (self.triangles[:, :, None], self.triangles[:, None, :]), blocks)
        return found

    def weak(self, rows: np.ndarray, values: np.ndarray) -> np.ndarray:
        """The integrals of one value per triangle times the conjugate of f_z or f_zbar of each hat function."""
        found = np.zeros(len(self.points), complex)
        np.add.at(found, self.triangles, rows.conj() * (self.areas * values)[:, None])
        return found

    def nearest(self, points: np.ndarray) -> np.ndarray:
        return np.abs(self.points[None, :] - points[:, None]).argmin(axis=1)

    def areas_of(self, images: np.ndarray) -> np.ndarray:
        p = images[self.triangles]
        return (np.conj(p[:, 1] - p[:, 0]) * (p[:, 2] - p[:, 0])).imag / 2

    def folded(self, images: np.ndarray) -> float:
        """The share of triangles that are turned over."""
        return float(np.mean(self.areas_of(images) < 0))


def least(energy: np.ndarray, right: np.ndarray, held: np.ndarray, to: np.ndarray) -> np.ndarray:
    """The w of least conj(w) energy w - 2 Re conj(w) right with w[held] = to."""
    free = np.setdiff1d(np.arange(len(energy)), held)
    w = np.zeros(len(energy), np.result_type(energy, right, to))
    w[held] = to
    w[free] = np.linalg.solve(energy[np.ix_(free, free)], right[free] - energy[np.ix_(free, held)] @ to)
    return w


def similar(mesh: Mesh, held: np.ndarray, to: np.ndarray) -> np.ndarray:
    """As similar as possible: Jacobians nearest to similarities, which have f_zbar = 0."""
    return least(mesh.energy(mesh.dzbar), np.zeros(len(mesh.points)), held, to)


def rigid(mesh: Mesh, held: np.ndarray, to: np.ndarray, steps: int = 5000) -> np.ndarray:
    """As rigid as possible: Jacobians nearest to rotations, by turns of rotations and positions."""
    energy = mesh.energy(mesh.dz) + mesh.energy(mesh.dzbar)
    free = np.setdiff1d(np.arange(len(energy)), held)
    solve = np.linalg.inv(energy[np.ix_(free, free)])
    w, fixed = similar(mesh, held, to), energy[np.ix_(free, held)] @ to
    for _ in range(steps):
        turns = mesh.derivative(mesh.dz, w)
        moved = solve @ (mesh.weak(mesh.dz, turns / np.abs(turns))[free] - fixed)
        change = np.abs(moved - w[free]).max()
        w[free] = moved
        if change < 1e-6 * np.ptp(np.abs(mesh.points)):
            return w
    raise RuntimeError("rotations do not settle")


def moving_least_squares(points: np.ndarray, held: np.ndarray, to: np.ndarray, is_rigid: bool) -> np.ndarray:
    """The similarity or rigid motion of each point that moves held points best, by weights of 1 / distance^2 (Schaefer, McPhail, Warren 2006)."""
    weights = 1 / np.maximum(np.abs(points[:, None] - held) ** 2, 1e-20)
    weights /= weights.sum(axis=1)[:, None]
    from_, image = weights @ held, weights @ to
    turn = (weights * np.conj(held - from_[:, None]) * (to - image[:, None])).sum(axis=1)
    turn /= np.abs(turn) if is_rigid else (weights * np.abs(held - from_[:, None]) ** 2).sum(axis=1)
    return image + turn * (points - from_)


def bounded_weights(mesh: Mesh, held: np.ndarray) -> np.ndarray:
    """Bounded biharmonic weights (Jacobson et al. 2011), one column per held vertex: least squared Laplacians, with nothing asked on the border, not negative,
    and divided by their sum. Which vertices are zero is found by pivoting (Judice, Pires 1994)."""
    laplacian = 4 * mesh.energy(mesh.dz).real
    mass = np.zeros(len(mesh.points))
    np.add.at(mass, mesh.triangles, np.repeat(mesh.areas[:, None] / 3, 3, axis=1))
    energy = laplacian @ (laplacian / mass[:, None])
    weights = np.zeros((len(mesh.points), len(held)))
    for k, own in enumerate(held):
        values = np.zeros(len(mesh.points))
        values[own] = 1
        is_zero, fewest, tries = np.zeros(len(mesh.points), bool), len(mesh.points) + 1, 10
        while True:
            fixed = np.union1d(held, np.flatnonzero(is_zero))
            w = least(energy, np.zeros(len(energy)), fixed, values[fixed])
            slope = energy @ w
            wrong = np.where(is_zero, slope < -1e-9 * np.abs(slope).max(), w < -1e-12)
            wrong[held] = False
            places = np.flatnonzero(wrong)
            if len(places) == 0:
                break
            # All of them at once while that helps, or else one by one, which ends.
            if len(places) < fewest:
                fewest, tries = len(places), 10
            elif tries > 0:
                tries -= 1
            else:
                places = places[-1:]
            is_zero[places] = ~is_zero[places]
        weights[:, k] = w
    return weights / weights.sum(axis=1)[:, None]


class HermiteMeanValue:
    """Hermite mean value interpolation (Dyken, Floater 2009) of values that are affine on a polygon's edges, and of outward normal derivatives that are constant
    there: the mean value interpolant, plus the weight 1 / phi, which begins with slope 1/2 at the border, times the interpolant of twice what slopes lack."""

    SAMPLES = 60  # per edge, of the slopes of mean value interpolants

    def __init__(self, polygon: np.ndarray) -> None:
        self.from_, to = polygon, np.roll(polygon, -1)
        self.lengths = np.abs(to - polygon)
        self.units = (to - polygon) / self.lengths
        nodes, self.gauss = np.polynomial.legendre.leggauss(32)
        self.nodes = (nodes + 1) / 2
        # Closer to corners, where slopes change quickly.
        self.at = np.sin(np.pi / 2 * (np.arange(self.SAMPLES) + 0.5) / self.SAMPLES) ** 2

    def _sums(self, point: complex, values: Callable, skipped: int = -1) -> tuple[float, np.ndarray]:
        """Integrals of 1 / r and of f / r over directions, the border's far sides counted with their sign. \param values at places from 0 to 1 of each edge"""
        start = (self.from_ - point) * np.conj(self.units)
        seen = np.abs(start.imag) > 1e-12 * self.lengths
        if skipped >= 0:
            seen[skipped] = False
        height = np.where(seen, start.imag, 1)
        ends = np.arctan2([start.real, start.real + self.lengths], np.abs(height))
        angles = ends[0][:, None] + (ends[1] - ends[0])[:, None] * self.nodes
        inverse = seen[:, None] * -np.cos(angles) / height[:, None] * self.gauss / 2 * (ends[1] - ends[0])[:, None]
        at = (np.abs(height)[:, None] * np.tan(angles) - start.real[:, None]) / self.lengths[:, None]
        return inverse.sum(), np.einsum("eq,eqm->m", inverse, values(np.clip(at, 0, 1)))

    def interpolant(self, values: np.ndarray, slopes: np.ndarray) -> Callable[[complex], np.ndarray]:
        """\param values one row per vertex \param slopes outward, one row per edge"""
        steps = np.roll(values, -1, axis=0) - values

        def affine(t):
            return values[:, None] + t[:, :, None] * steps[:, None]

        lacking = np.zeros((len(values), self.SAMPLES, values.shape[1]))
        for e in range(len(values)):
            for k, t in enumerate(self.at):
                phi, sums = self._sums(self.from_[e] + t * self.lengths[e] * self.units[e], affine, skipped=e)
                lacking[e, k] = -2 * slopes[e] - (sums - phi * (values[e] + t * steps[e]))

        def lack(t):
            return np.stack([[np.interp(t[e], self.at, column) for column in lacking[e].T] for e in range(len(t))]).transpose(0, 2, 1)

        def at(point):
            phi, sums = self._sums(point, affine)
            return sums / phi + self._sums(point, lack)[1] / phi**2

        return at
