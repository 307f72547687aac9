import numpy as np

def deform(file, posed):
    """Points of an .npz of `cageproof coordinates` (green or mean_value) under a cage whose vertices are `posed`."""
    c = np.load(file)
    if "lambda" in c:                                     # mean_value: coordinates times posed vertices
        return c["lambda"] @ posed
    (a, b, d), (a1, b1, d1) = (v[c["elements"].T] for v in (c["cage_vertices"], posed))  # corners at rest, and posed
    u, v, u1, v1 = b - a, d - a, b1 - a1, d1 - a1
    dot = lambda x, y: np.sum(x * y, axis=1, keepdims=True)
    normals = np.cross(u1, v1) / np.linalg.norm(np.cross(u1, v1), axis=1, keepdims=True)
    s2 = dot(u1, u1) * dot(v, v) - 2 * dot(u1, v1) * dot(u, v) + dot(v1, v1) * dot(u, u)
    stretch = np.sqrt(s2 / 8) / c["element_areas"][:, None]              # Lipman, Levin, Cohen-Or 2008
    return c["phi"] @ posed + c["psi"] @ (stretch * normals)
