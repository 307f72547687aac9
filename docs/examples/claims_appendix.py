# SPDX-License-Identifier: MIT
"""[T24] Appendix A, step by step: the integral of the distance r over a triangle, from polar coordinates (Eq 50) to Eq 10.

Each step is compared with the one before it, the last one with the command cageproof, and each misprint replaces its step in the integral."""

import json
import subprocess

import numpy as np

TRIANGLES = 20


def parts(triangle: np.ndarray, point: np.ndarray) -> dict[str, np.ndarray]:
    """Lengths and angles of the three triangles (p, t_i, t_i+1) of Eq 50, p the point's projection (Figure 11). Pairs are of corners i and i + 1."""
    a, b, c = triangle
    normal = np.cross(b - a, c - a)
    normal /= np.linalg.norm(normal)
    p = point - (point - a) @ normal * normal
    from_, to = triangle, np.roll(triangle, -1, axis=0)
    edge = (to - from_) / np.linalg.norm(to - from_, axis=1)[:, None]
    turn = np.cross(from_ - p, to - p) @ normal
    delta = np.stack([np.linalg.norm(from_ - p, axis=1), np.linalg.norm(to - p, axis=1)])
    cosine = np.stack([np.einsum("ic,ic->i", p - from_, edge), -np.einsum("ic,ic->i", p - to, edge)]) / delta
    gamma = np.arccos(cosine)
    return {"sign": np.sign(turn), "beta": np.pi - gamma.sum(axis=0), "gamma": gamma, "delta": delta, "a": delta[0] * np.sin(gamma[0]),
            "d": abs((point - a) @ normal), "l": np.stack([np.linalg.norm(point - from_, axis=1), np.linalg.norm(point - to, axis=1)]),
            "zeta": np.stack([np.einsum("ic,ic->i", point - from_, edge), np.einsum("ic,ic->i", point - to, edge)]), "eps": np.array([[1], [-1]])}


def integrated(function, low, high, panels: int = 40) -> np.ndarray:
    """Integrals by Gauss points on panels of equal length, one per part."""
    nodes, weights = np.polynomial.legendre.leggauss(16)
    at = ((np.arange(panels)[:, None] + (nodes + 1) / 2) / panels).ravel()
    return ((high - low)[:, None] * np.tile(weights, panels) / (2 * panels) * function(low[:, None] + at * (high - low)[:, None])).sum(axis=1)


def antiderivative(x, d, a):
    """F of Eq 55. x may be complex, for derivatives."""
    u, v = np.sqrt(d**2 * x**2 + a**2 * (1 + x**2)), np.sqrt((d**2 + a**2) * (1 + x**2))
    return np.sign(x.real) * (d**3 * (np.arccos(d / v) - np.pi / 2) - (3 * a * d**2 + a**3) / 4 * np.log((a + u) ** 2 / ((d**2 + a**2) * x**2))
                              - a**2 * u / (2 * x**2))


def lines_of_f1(m) -> list[np.ndarray]:
    d, a, c, s = m["d"], m["a"], np.cos(m["gamma"]), np.sin(m["gamma"])
    both = d**2 + a**2
    return [np.sign(c) * d**3 * (np.arccos(d / np.sqrt(both * (1 + (s / c) ** 2))) - np.pi / 2),
            np.sign(c) * d**3 * (np.arccos(d * abs(c) / np.sqrt(both)) - np.pi / 2), d**3 * (np.arccos(d * c / np.sqrt(both)) - np.pi / 2)]


def lines_of_f2(m) -> list[np.ndarray]:
    d, a, c, s = m["d"], m["a"], np.cos(m["gamma"]), np.sin(m["gamma"])
    root = np.sqrt(d**2 * s**2 + a**2)
    return [-np.sign(c) * a**2 * np.sqrt((d * s / c) ** 2 + a**2 * (1 + (s / c) ** 2)) * c**2 / (2 * s**2), -(a**2) * root * c / (2 * s**2),
            -a * m["l"] * m["delta"] * c / 2, -a * m["eps"] * m["l"] * m["zeta"] / 2]


def lines_of_f3(m, as_printed: bool) -> list[np.ndarray]:
    """Lines 2 to 8. Lines 3, 5 and 7 are misprinted."""
    d, a, c, s = m["d"], m["a"], np.cos(m["gamma"]), np.sin(m["gamma"])
    both, root, factor = d**2 + a**2, np.sqrt(d**2 * s**2 + a**2), (3 * a * d**2 + a**3) / 4
    third = (a + np.sqrt(d**2 * s**2 + a**2 * (1 + (s / c) ** 2))) ** 2 if as_printed else (a * abs(c) + root) ** 2
    fifth = root - a * abs(c) if as_printed else root + a * c
    seventh = s - m["delta"] * s * c if as_printed else (m["l"] - m["delta"] * c) * s
    return [-np.sign(c) * factor * np.log((a + np.sqrt((d * s / c) ** 2 + a**2 * (1 + (s / c) ** 2))) ** 2 * c**2 / (both * s**2)),
            -np.sign(c) * factor * np.log(third / (d**2 * s**2 + a**2 - a**2 * c**2)),
            -np.sign(c) * factor * np.log((root + a * abs(c)) / (root - a * abs(c))),
            factor * np.log((root - a * c) / fifth),
            factor * np.log((root - a * c) ** 2 / (both * s**2)),
            factor * np.log(seventh**2 / (both * s**2)),
            m["eps"] * 2 * factor * np.log((m["l"] - m["zeta"]) / np.sqrt(both))]


def steps(m) -> tuple[list[tuple[str, float, float]], dict[str, float]]:
    """(equation, its value, what it equals) of one triangle and point, and the integral of r with each misprint in its place."""
    d, a, beta, sign = m["d"], m["a"], m["beta"], m["sign"]
    g0, g1 = m["gamma"]
    gamma = np.pi - g0
    x = np.tan(m["gamma"])
    zero = np.zeros(3)

    def whole(thirds):  # the integral over the triangle, from three times those over its parts, without d^3 beta
        return float(sign @ (thirds - d**3 * beta) / 3)

    def power(angle):
        return (d**2 + (a[:, None] / np.sin(angle)) ** 2) ** 1.5

    def by_f(low, high):
        return whole(antiderivative(high, d, a) - antiderivative(low, d, a))

    in_polar = float(sign @ integrated(lambda t: (np.sqrt(d**2 + (m["delta"][0] * np.sin(g0))[:, None] ** 2 / np.sin(np.pi - g0[:, None] - t) ** 2) ** 3 - d**3) / 3, zero, beta))
    eq51 = whole(integrated(power, gamma - beta, gamma))
    eq56, eq57 = by_f(np.tan(gamma - beta), np.tan(gamma)), whole(-antiderivative(x, d, a).sum(axis=0))
    f = ((d**2 + a**2) + (a / x) ** 2) ** 1.5 / (1 + x**2)
    f1, f2, f3, printed = lines_of_f1(m), lines_of_f2(m), lines_of_f3(m, False), lines_of_f3(m, True)

    def with_f3(third):
        return whole(-(f1[0] + f2[0] + third).sum(axis=0))

    cosines = np.arccos(d * np.cos(m["gamma"]) / np.sqrt(d**2 + a**2)).sum(axis=0)
    eq10 = float(sign @ (d**3 * (np.pi - beta - cosines) - (f2[-1] + f3[-1]).sum(axis=0))) / 3
    compared = [("Eq 51", eq51, in_polar), ("Eq 54", np.sign(x) * ((d**2 + a**2) * x**2 + a**2) ** 1.5 / (x**3 * (1 + x**2)), f),
                ("Eq 55", antiderivative(x + 1e-30j, d, a).imag / 1e-30, f), ("Eq 56", eq56, eq51), ("Eq 57", eq57, eq56),
                ("Eq 58", np.sign(x), np.sign(np.cos(m["gamma"]))), ("Eq 59", m["delta"] * np.sin(m["gamma"]), np.stack([a, a])),
                ("Eq 60", m["l"] * np.sin(m["gamma"]), np.sqrt((d * np.sin(m["gamma"])) ** 2 + a**2)),
                ("Eq 61", m["eps"] * m["zeta"], m["delta"] * np.cos(m["gamma"]))]
    for name, lines in (("F_1", f1), ("F_2", f2), ("F_3", f3)):
        compared += [(name, after, before) for before, after in zip(lines, lines[1:])]
    compared.append(("Eq 10", eq10, eq57))
    misprints = {"limit of Eq 51": by_f(np.tan(-beta - gamma), np.tan(gamma)), "limit of Eq 52": by_f(-np.tan(gamma - beta), np.tan(gamma)),
                 "F_3 line 3": with_f3(printed[1]), "F_3 line 5": with_f3(printed[3]), "F_3 line 7": with_f3(printed[5]),
                 "sum of F_1": float(sign @ (-(d**3) / 3 * beta - f1[-1].sum(axis=0) - (f2[-1] + f3[-1]).sum(axis=0) / 3))}
    return compared, misprints | {"Eq 10": eq10}


def off(found, expected) -> float:
    return float(np.abs(np.subtract(found, expected)).max() / np.abs(expected).max())


def appendix_a() -> dict[str, float]:
    """The largest relative differences of each step over random triangles and points, and the median error of the integral with each misprint."""
    random = np.random.default_rng(0)
    triangles, points = random.uniform(-1, 1, (TRIANGLES, 3, 3)), random.uniform(-1, 1, (TRIANGLES, 3))
    lines = "".join(json.dumps({"element": t.tolist(), "point": p.tolist()}) + "\n" for t, p in zip(triangles, points))
    command = ["cageproof", "eval", "--formula", "triangle.biharmonic_single_layer", "--evaluation", "hybrid"]
    printed = subprocess.run(command, input=lines, check=True, capture_output=True, text=True).stdout
    truths = [8 * np.pi * json.loads(line)["value"][0] for line in printed.splitlines()]
    correct: dict[str, float] = {}
    wrong: dict[str, list[float]] = {}
    for triangle, point, truth in zip(triangles, points, truths):
        compared, integrals = steps(parts(triangle, point))
        for name, found, expected in [*compared, ("the command", integrals.pop("Eq 10"), truth)]:
            correct[name] = max(correct.get(name, 0), off(found, expected))
        for name, value in integrals.items():
            wrong.setdefault(f"as printed {name}", []).append(off(value, truth))
    return correct | {name: float(np.median(errors)) for name, errors in wrong.items()}
