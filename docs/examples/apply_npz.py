import numpy as np

def stretched_normals(c, posed):
    """What psi multiplies: unit normals of the posed triangles, each as long as its triangle is stretched."""
    (a, b, d), (a1, b1, d1) = (v[c["elements"].T] for v in (c["cage_vertices"], posed))  # corners at rest, and posed
    u, v, u1, v1 = b - a, d - a, b1 - a1, d1 - a1
    dot = lambda x, y: np.sum(x * y, axis=1, keepdims=True)
    normals = np.cross(u1, v1) / np.linalg.norm(np.cross(u1, v1), axis=1, keepdims=True)
    s2 = dot(u1, u1) * dot(v, v) - 2 * dot(u1, v1) * dot(u, v) + dot(v1, v1) * dot(u, u)
    return np.sqrt(s2 / 8) / c["element_areas"][:, None] * normals       # Lipman, Levin, Cohen-Or 2008

def deform(file, posed):
    """Points of an .npz of `cageproof coordinates` (green or mean_value) under a cage whose vertices are `posed`."""
    c = np.load(file)
    if "lambda" in c:                                     # mean_value: coordinates times posed vertices
        return c["lambda"] @ posed
    return c["phi"] @ posed + c["psi"] @ stretched_normals(c, posed)
