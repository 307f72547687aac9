# SPDX-License-Identifier: MIT
"""Formulas on triangles, quads and segments: by pairs, for all pairs, or summed with densities."""

from ctypes import byref, c_void_p
from typing import Any, List, NamedTuple, Optional, Tuple, Union

import numpy as np

from ._library import CFormula, Error, Request, Tensors, call, numbers, options, passed

_SIDES = {"inside": 0, "outside": 1, "mean": 2}
Arrays = Union[np.ndarray, Tuple[np.ndarray, ...]]


class Formula(NamedTuple):
    """The shape of a formula's input and result for one element and point."""

    dimension: int  #: of space
    corners: int  #: of an element
    tensors: int  #: 1, or one per corner
    rows: int  #: of each tensor; 1 and 1 for numbers
    columns: int

    @property
    def shape(self) -> Tuple[int, ...]:
        """The shape of a result: () for numbers, (corners,), (corners, rows, columns) ..."""
        return self._of(self.rows, self.columns)

    def _of(self, *matrix: int) -> Tuple[int, ...]:
        per_corner = (self.tensors,) if self.tensors > 1 else ()
        return per_corner + (matrix if self.rows * self.columns > 1 else ())


def formula(name: str) -> Formula:
    """Returns the shape of a formula of `names("formulas")`."""
    found = CFormula()
    call("formula_of", name.encode(), byref(found))
    return Formula(found.dimension, found.corners, found.tensors, found.rows, found.columns)


class _Asked:
    def __init__(self, name: str, elements: Any, points: Any, order: int, evaluation: Optional[str], side: str, given: dict):
        self.shape = formula(name)
        if side not in _SIDES:
            raise Error(f"side: '{side}' is none of {', '.join(_SIDES)}")
        if order not in (0, 1, 2):
            raise Error(f"order {order} is none of 0, 1, 2")
        f = self.shape
        self.elements, self.points = numbers(elements, "elements"), numbers(points, "points")
        self.one_element, self.one_point = self.elements.ndim == 2, self.points.ndim == 1
        if self.one_element:
            self.elements = self.elements[np.newaxis]
        if self.one_point:
            self.points = self.points[np.newaxis]
        if self.elements.ndim != 3 or self.elements.shape[1:] != (f.corners, f.dimension):
            raise Error(f"elements: the shape is {self.elements.shape}, not (n, {f.corners}, {f.dimension})")
        if self.points.ndim != 2 or self.points.shape[1] != f.dimension:
            raise Error(f"points: the shape is {self.points.shape}, not (n, {f.dimension})")
        self.order, self._options = order, options(given)
        self.request = Request(name.encode(), evaluation.encode() if evaluation else None, *self._options, order, _SIDES[side])

    def results(self, shape: Tuple[int, ...]) -> Tuple[List[np.ndarray], Tensors]:
        arrays = [np.empty(shape + (self.shape.dimension,) * o) for o in range(self.order + 1)]
        tensors = Tensors()
        for o, array in enumerate(arrays):
            tensors.data[o], tensors.size[o] = c_void_p(array.ctypes.data), array.size
        return arrays, tensors

    def returned(self, arrays: List[np.ndarray]) -> Arrays:
        return arrays[0] if self.order == 0 else tuple(arrays)


def evaluate(
    name: str,
    elements: Any,
    points: Any,
    order: int = 0,
    evaluation: Optional[str] = None,
    side: str = "inside",
    **given: Any,
) -> Arrays:
    """Computes one result per pair of an element and a point, or of one with all of the other.

    elements: (n, corners, dimension) or one element; points: (n, dimension) or one point. Values are (n,) + shape of the
    formula; with order=1 also gradients by the point, with order=2 Hessians, as a tuple. evaluation: one of
    names(formula), the recommended one by default. side: the limit for points on an element's inside: "inside" (behind
    the normal), "outside" or "mean". Parameters (nu, mu ...) and threads are further arguments."""
    asked = _Asked(name, elements, points, order, evaluation, side, given)
    pairs = max(len(asked.elements), len(asked.points))
    single = asked.one_element and asked.one_point
    arrays, tensors = asked.results((pairs,) + asked.shape.shape)
    call("evaluate", byref(asked.request), *passed(asked.elements), *passed(asked.points), byref(tensors))
    return asked.returned([a[0] for a in arrays] if single else arrays)


def potentials(
    name: str,
    elements: Any,
    points: Any,
    densities: Any = None,
    order: int = 0,
    evaluation: Optional[str] = None,
    side: str = "inside",
    **given: Any,
) -> Arrays:
    """Computes all pairs of points and elements: (points, elements) + shape of the formula; or, with densities, their sums over
    elements, which keep no pairs.

    densities: (elements,), of formulas per corner (elements, corners), of matrices with a last axis for columns; one more
    axis for several sets at once. Sums are (points,), with rows for matrices, and the sets last. Other arguments as of
    `evaluate`. evaluation="batched" computes values of single, double and biharmonic layers for several points at a time;
    digits are then those of the largest value at a point."""
    asked = _Asked(name, elements, points, order, evaluation, side, given)
    f, count = asked.shape, len(asked.points)
    if densities is None:
        arrays, tensors = asked.results((count, len(asked.elements)) + f.shape)
        call("potentials", byref(asked.request), *passed(asked.elements), *passed(asked.points), byref(tensors))
    else:
        given_densities = numbers(densities, "densities")
        one = (len(asked.elements),) + f._of(f.columns)
        sets = given_densities.shape[len(one) :]
        if given_densities.shape[: len(one)] != one or len(sets) > 1:
            raise Error(f"densities: the shape is {given_densities.shape}, not {one} or {one + ('sets',)}")
        rows = (f.rows,) if f.rows > 1 else ()
        arrays, tensors = asked.results((count,) + rows + sets)
        call(
            "potentials_apply",
            byref(asked.request),
            *passed(asked.elements),
            *passed(given_densities),
            sets[0] if sets else 1,
            *passed(asked.points),
            byref(tensors),
        )
    return asked.returned([a[0] for a in arrays] if asked.one_point else arrays)
