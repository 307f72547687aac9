#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""steps_test.py CAGEPROOF: every step that `eval --steps` prints of riemann-<n> against the equation that defines it, computed here from its definition:
integrals by Gauss points, solutions of smallest norm by singular values, the projection by a search of the quad, sums by plain loops."""

import json
import subprocess
import sys

import numpy as np

NODES, WEIGHTS = (x / 2 for x in np.polynomial.legendre.leggauss(24))
NODES = NODES + 0.5
SQUARE = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
CORRECTION = {"": True, "-unguarded": True, "-uncorrected": False}
failures = []


def check(case: str, name: str, found, wanted, tolerance: float = 1e-11) -> None:
    found, wanted = np.asarray(found, dtype=float), np.asarray(wanted, dtype=float)
    off = np.abs(found - wanted).max() / max(np.abs(wanted).max(), 1e-30)
    if not off <= tolerance:
        failures.append(f"{case}: {name} is {found}, not {wanted}: {off:.1e}")


def basis(u, v):
    return np.stack([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v], axis=-1)


def normal(q, u, v):
    u, v = np.asarray(u)[..., None], np.asarray(v)[..., None]
    return np.cross((1 - v) * (q[1] - q[0]) + v * (q[2] - q[3]), (1 - u) * (q[3] - q[0]) + u * (q[2] - q[1]))


def rule_about(centre):
    """Nodes and weights on [0, 1], in panels that shrink towards the centre."""
    cuts = sorted({0.0, 1.0, centre, *(c for k in range(1, 12) for c in (centre - 0.5**k, centre + 0.5**k) if 0 < c < 1)})
    panels = list(zip(cuts, cuts[1:]))
    return np.concatenate([a + (b - a) * NODES for a, b in panels]), np.concatenate([(b - a) * WEIGHTS for a, b in panels])


def integral_over_quad(q, eta, f):
    """The integral of f(u, v, x, r) dB over the quad's solid angle at eta, x from eta to the quad, r = |x|."""
    coarse = np.linspace(0, 1, 65)
    u, v = np.meshgrid(coarse, coarse, indexing="ij")
    nearest = np.unravel_index(np.linalg.norm(basis(u, v) @ q - eta, axis=-1).argmin(), u.shape)
    (at_u, of_u), (at_v, of_v) = rule_about(coarse[nearest[0]]), rule_about(coarse[nearest[1]])
    u, v = np.meshgrid(at_u, at_v, indexing="ij")
    x = basis(u, v) @ q - eta
    r = np.linalg.norm(x, axis=-1)
    solid = (x * normal(q, u, v)).sum(axis=-1) / r**3 * np.outer(of_u, of_v)
    return (f(u, v, x, r) * solid[..., None]).sum(axis=(0, 1))


def mean_vector(q, eta):
    """The integral of unit vectors over the quad's solid angle: Eq 15's sum, from its definition."""
    return integral_over_quad(q, eta, lambda u, v, x, r: x / r[..., None])


def weights(q, eta):
    """Eq 11."""
    return integral_over_quad(q, eta, lambda u, v, x, r: basis(u, v) / r[..., None])


def hull_mean(q, eta):
    """Eq 25 with the fourth power: the hull's surface averaged by |(xi - eta).n|/|xi - eta|^4."""
    nodes, of_nodes = np.polynomial.legendre.leggauss(80)
    nodes, of_nodes = nodes / 2 + 0.5, of_nodes / 2
    total, moment = 0.0, np.zeros(3)
    for a, b, c in ((0, 1, 3), (1, 2, 3), (0, 2, 1), (0, 3, 2)):
        n = np.cross(q[b] - q[a], q[c] - q[a])
        s, t = np.meshgrid(nodes, nodes, indexing="ij")
        xi = q[a] + s[..., None] * (q[b] - q[a]) + (s * t)[..., None] * (q[c] - q[b])
        x = xi - eta
        k = np.abs(x @ n) / np.linalg.norm(x, axis=-1) ** 4 * s * np.outer(of_nodes, of_nodes)
        total += k.sum()
        moment += (k[..., None] * xi).sum(axis=(0, 1))
    return moment / total


def nearest_to_line(q, start, direction):
    """The parameters of the quad's point nearest to a line, by a search that halves its step."""
    d = direction / np.linalg.norm(direction)

    def off(u, v):
        return np.linalg.norm(np.cross(basis(u, v) @ q - start, d), axis=-1)
    grid = np.linspace(0, 1, 81)
    us, vs = np.meshgrid(grid, grid, indexing="ij")
    at = off(us, vs).argmin()
    u, v = us.flat[at], vs.flat[at]
    step = grid[1]
    while step > 1e-14:
        around = [(min(max(u + i * step, 0), 1), min(max(v + j * step, 0), 1)) for i in (-1, 0, 1) for j in (-1, 0, 1)]
        best = min(around, key=lambda at: off(*at))
        if best == (u, v):
            step /= 2
        u, v = best
    return u, v


def grid_of(n, centre):
    """The grid and the lengths of its cells, as Section 3.4.3 prints them."""
    at = [k / n * centre if k < n else centre if k == n else centre + (k - n) / n * (1 - centre) for k in range(2 * n + 1)]
    return at, [(at[min(k + 1, 2 * n)] - at[max(k - 1, 0)]) / 2 for k in range(2 * n + 1)]


def check_point(case, q, eta, n, suffix, answer):
    q, eta = np.array(q, dtype=float), np.array(eta, dtype=float)
    steps = {step["name"]: np.array([float(x) for x in step["values"]]) for step in answer["steps"]}
    a = (q - eta).T
    check(case, "A_q", steps["A_q"], a.ravel())
    # Eq 26's remark: the barycentric coordinates of the point in the tetrahedron, times the determinant of its edges.
    edges = np.linalg.det(np.array([q[1] - q[0], q[2] - q[0], q[3] - q[0]]))
    kernel = np.linalg.solve(np.vstack([q.T, np.ones(4)]), np.append(eta, 1)) * -edges if abs(edges) > 1e-9 else None
    kappa = steps["kappa"]
    if kernel is not None:
        check(case, "kappa", kappa, -kernel)
    check(case, "A kappa", np.linalg.norm(a @ kappa) / np.linalg.norm(kappa) + 1, 1)
    sides = [(q[i] - eta, q[(i + 1) % 4] - eta) for i in range(4)]
    check(case, "theta", steps["theta"], [np.arccos(a @ b / np.linalg.norm(a) / np.linalg.norm(b)) for a, b in sides], 1e-10)
    check(case, "N_i", steps["N_i"], np.ravel([np.cross(b, a) for a, b in sides]))
    m = mean_vector(q, eta)
    check(case, "m_q", steps["m_q"], m)
    wbar = np.linalg.pinv(a) @ m
    check(case, "minimal_norm", steps["minimal_norm"], wbar)
    hull = eta if kernel is not None and min(kernel / kernel.sum()) >= 0 else hull_mean(q, eta)
    check(case, "hull_point", steps["hull_point"], hull, 1e-9)
    if kernel is not None:
        check(case, "hull_mean_vector", steps["hull_mean_vector"] / np.linalg.norm(steps["hull_mean_vector"]),
              mean_vector(q, hull) / np.linalg.norm(mean_vector(q, hull)), 1e-9)
    u, v = nearest_to_line(q, hull, steps["hull_mean_vector"])
    check(case, "uv", steps["uv"], [u, v], 1e-9)
    u, v = steps["uv"]
    check(case, "projection", steps["projection"], basis(u, v) @ q)
    # Eq 4: the bilinear combination of the corners' normals.
    check(case, "normal", steps["normal"], basis(u, v) @ np.array([np.cross(q[(i + 1) % 4] - q[i], q[i - 1] - q[i]) for i in range(4)]))
    at_u, cell_u = grid_of(n, u)
    at_v, cell_v = grid_of(n, v)
    for name, wanted in (("grid_u", at_u), ("grid_v", at_v), ("delta_u", cell_u), ("delta_v", cell_v)):
        check(case, name, steps[name], wanted)
    solid, omega = [], np.zeros(4)
    for k in range(2 * n + 1):
        for l in range(2 * n + 1):
            x = basis(at_u[k], at_v[l]) @ q - eta
            solid.append(normal(q, at_u[k], at_v[l]) @ x / np.linalg.norm(x) ** 3 * cell_u[k] * cell_v[l])
            omega += basis(at_u[k], at_v[l]) / np.linalg.norm(x) * solid[-1]
    check(case, "dB", steps["dB"], solid)
    check(case, "Omega", steps["Omega"], omega)
    plain, factor = omega @ kappa / (kappa @ kappa), wbar @ wbar / (omega @ wbar)
    check(case, "lambda_uncorrected", steps["lambda_uncorrected"], plain, 1e-10)
    check(case, "norm_correction", steps["norm_correction"], factor, 1e-10)
    check(case, "lambda_printed", steps["lambda_printed"], plain * factor, 1e-10)
    trust = steps["trust"][0]
    if suffix:
        check(case, "trust", trust, float(CORRECTION[suffix]))
    lam = plain * (1 + trust * (factor - 1))
    check(case, "lambda", steps["lambda"], lam, 1e-10)
    check(case, "weights", steps["weights"], wbar + lam * kappa, 1e-10)
    check(case, "value", steps["weights"], [float(x) for x in answer["value"]], 0)
    exact = weights(q, eta)
    check(case, "exact_weights", steps["exact_weights"], exact, 1e-10)
    check(case, "exact_lambda", steps["exact_lambda"], exact @ kappa / (kappa @ kappa), 1e-9)


def main() -> int:
    program = sys.argv[1]

    def answers(evaluation, scalar, lines):
        ended = subprocess.run([program, "eval", "--formula", "quad.mean_value", "--evaluation", evaluation, "--scalar", scalar, "--steps"], text=True,
                               input="".join(json.dumps(line) + "\n" for line in lines), capture_output=True)
        if ended.returncode != 0:
            failures.append(f"{evaluation} in {scalar}: {ended.returncode}: {ended.stdout}{ended.stderr}")
            return []
        return [json.loads(line) for line in ended.stdout.splitlines()]

    twisted = [[0, 0, 0], [1, 0.125, 0], [1.25, 1, 0.5], [-0.125, 0.75, 0]]
    cases = [(twisted, [0.25, 0.5, 1]), (twisted, [1.5, -0.5, -0.75]), (twisted, [0.75, 0.625, 0.25]), (SQUARE, [0.25, 0.75, 0.5])]
    lines = [{"element": q, "point": p} for q, p in cases]
    for evaluation, suffix, n, scalar in (("riemann-2", "", 2, "double"), ("riemann-1-unguarded", "-unguarded", 1, "double"),
                                          ("riemann-3-uncorrected", "-uncorrected", 3, "mp50")):
        for (q, p), answer in zip(cases, answers(evaluation, scalar, lines)):
            check_point(f"{evaluation} in {scalar} at {p}", q, p, n, suffix, answer)
    # On the quad the parameters are all there is; in the plane of a planar one, nothing is.
    for q, p, wanted in ((SQUARE, [0.25, 0.75, 0], ["uv", "basis"]), (SQUARE, [1.5, 0.75, 0], [])):
        for answer in answers("riemann-4", "double", [{"element": q, "point": p}]):
            names = [step["name"] for step in answer["steps"]]
            if names != ["A_q", "kappa", "theta", "N_i", "m_q", *wanted]:
                failures.append(f"steps at {p}: {names}")
            if wanted and answer["steps"][5]["values"] != p[:2]:
                failures.append(f"parameters at {p}: {answer['steps'][5]}")
    # In a unit of length times 2^-30, every step changes by its power of it.
    small = 2.0**-30
    q, p = cases[0]
    one = answers("riemann-2", "double", [{"element": q, "point": p}])
    scaled = answers("riemann-2", "double", [{"element": (np.array(q) * small).tolist(), "point": (np.array(p) * small).tolist()}])
    for a, b in zip(one and one[0]["steps"], scaled and scaled[0]["steps"]):
        check("in another unit", a["name"], np.array(b["values"]) / small ** a["length"], a["values"], 0)
    ended = subprocess.run([program, "eval", "--formula", "quad.mean_value", "--evaluation", "line_form", "--steps"], text=True, input="", capture_output=True)
    if ended.returncode != 2 or "riemann-<n> of quad.mean_value" not in ended.stderr:
        failures.append(f"line_form --steps: {ended.returncode} {ended.stderr}")
    print("\n".join(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
