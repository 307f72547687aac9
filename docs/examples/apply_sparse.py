import numpy as np
from apply_npz import stretched_normals

def deform_sparse(file, posed):
    """Points of an .npz of `cageproof coordinates --drop` (green or mean_value) under a cage whose vertices are `posed`."""
    w = np.load(file)
    rows = posed if w["shape"][1] == len(posed) else np.vstack([posed, stretched_normals(w, posed)])
    # With SciPy: return scipy.sparse.load_npz(file) @ rows. Without it, sums over each row, which has at least one weight.
    return np.add.reduceat(w["data"][:, None] * rows[w["indices"]], w["indptr"][:-1])
