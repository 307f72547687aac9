# SPDX-License-Identifier: MIT
"""The shared library by ctypes: signatures, errors, arrays, options."""

import ctypes
import os
from ctypes import POINTER, byref, c_char_p, c_double, c_int, c_size_t, c_void_p
from pathlib import Path
from typing import Any, List, Optional, Sequence, Tuple

import numpy as np

ABI_VERSION = 1


class Error(ValueError):
    """What the library refuses, in its own words: one line that names the face, vertex, array or name at fault."""


class Option(ctypes.Structure):
    _fields_ = [("name", c_char_p), ("value", c_char_p)]


class CBlock(ctypes.Structure):
    _fields_ = [
        ("label", c_char_p),
        ("one_a", c_char_p),
        ("reproduces", c_char_p),
        ("count", c_size_t),
        ("rows", c_size_t),
        ("columns", c_size_t),
        ("offset", c_size_t),
        ("normal_factor", c_double),
    ]


class CFormula(ctypes.Structure):
    _fields_ = [(name, c_int) for name in ("dimension", "corners", "tensors", "rows", "columns")]


class Request(ctypes.Structure):
    _fields_ = [
        ("formula", c_char_p),
        ("evaluation", c_char_p),
        ("options", POINTER(Option)),
        ("option_count", c_size_t),
        ("order", c_int),
        ("side", c_int),
    ]


class Tensors(ctypes.Structure):
    _fields_ = [("data", c_void_p * 3), ("size", c_size_t * 3)]


_ARRAY = [c_void_p, c_size_t]
_OPTIONS = [POINTER(Option), c_size_t]
_SIGNATURES = {
    "list": [c_char_p, c_char_p, c_size_t, POINTER(c_size_t)],
    "cage_make": [c_int, *_ARRAY, *_ARRAY, *_ARRAY, POINTER(c_void_p)],
    "cage_read": [c_char_p, POINTER(c_void_p)],
    "cage_embedded": [c_char_p, POINTER(c_void_p)],
    "cage_check": [c_void_p, *_OPTIONS],
    "cage_sizes": [c_void_p, POINTER(c_int), POINTER(c_size_t), POINTER(c_size_t), POINTER(c_size_t)],
    "cage_copy": [c_void_p, *_ARRAY, *_ARRAY, *_ARRAY],
    "coordinates_make": [c_void_p, c_char_p, *_OPTIONS, POINTER(c_void_p)],
    "coordinates_sizes": [c_void_p, POINTER(c_int), POINTER(c_int), POINTER(c_size_t), POINTER(c_size_t), POINTER(c_size_t)],
    "coordinates_block": [c_void_p, c_size_t, POINTER(CBlock)],
    "coordinates_elements": [c_void_p, *_ARRAY, *_ARRAY, *_ARRAY],
    "coordinates_evaluate": [c_void_p, *_ARRAY, *_ARRAY, *_ARRAY, *_ARRAY],
    "coordinates_apply": [c_void_p, *_ARRAY, *_ARRAY, c_int, *_ARRAY],
    "coordinates_jvp": [c_void_p, *_ARRAY, *_ARRAY, *_ARRAY],
    "coordinates_vjp": [c_void_p, *_ARRAY, *_ARRAY, *_ARRAY],
    "deformer_make": [c_void_p, c_char_p, *_OPTIONS, POINTER(c_void_p)],
    "deformer_pose": [c_void_p, *_ARRAY],
    "deformer_images": [c_void_p, *_ARRAY, *_ARRAY, *_ARRAY],
    "deformer_bind": [c_void_p, *_ARRAY, c_int, POINTER(c_void_p)],
    "bound_images": [c_void_p, c_void_p, *_ARRAY, *_ARRAY],
    "deformer_jvp": [c_void_p, *_ARRAY, *_ARRAY, *_ARRAY],
    "deformer_vjp": [c_void_p, *_ARRAY, *_ARRAY, *_ARRAY],
    "bound_jvp": [c_void_p, c_void_p, *_ARRAY, *_ARRAY],
    "bound_vjp": [c_void_p, c_void_p, *_ARRAY, *_ARRAY],
    "inside_make": [c_void_p, c_int, *_OPTIONS, POINTER(c_void_p)],
    "inside_points": [c_void_p, *_ARRAY, c_int, *_ARRAY, *_ARRAY, *_ARRAY, *_ARRAY],
    "formula_of": [c_char_p, POINTER(CFormula)],
    "evaluate": [POINTER(Request), *_ARRAY, *_ARRAY, POINTER(Tensors)],
    "potentials": [POINTER(Request), *_ARRAY, *_ARRAY, POINTER(Tensors)],
    "potentials_apply": [POINTER(Request), *_ARRAY, *_ARRAY, c_int, *_ARRAY, POINTER(Tensors)],
}


def _load() -> ctypes.CDLL:
    file = os.environ.get("CAGEPROOF_LIBRARY") or str(Path(__file__).resolve().parent / "libcageproof.so")
    try:
        library = ctypes.CDLL(file)
    except OSError as error:
        raise ImportError(f"cageproof's library cannot be loaded: {error}; docs/python.md says which packages it needs") from None
    library.cageproof_abi_version.restype = c_int
    found = library.cageproof_abi_version()
    if found != ABI_VERSION:
        raise ImportError(f"{file} has version {found} of the interface, this package wants {ABI_VERSION}: install both anew")
    for name, arguments in _SIGNATURES.items():
        try:
            function = getattr(library, "cageproof_" + name)
        except AttributeError:
            raise ImportError(f"{file} has no cageproof_{name}: it is older than this package; install both anew") from None
        function.argtypes, function.restype = arguments, c_int
    for name in ("cage", "coordinates", "deformer", "bound", "inside"):
        function = getattr(library, f"cageproof_{name}_free")
        function.argtypes, function.restype = [c_void_p], None
    for name in ("error", "version"):
        getattr(library, "cageproof_" + name).restype = c_char_p
    library.cageproof_cage_warning.argtypes, library.cageproof_cage_warning.restype = [c_void_p, c_size_t], c_char_p
    return library


library = _load()


def call(name: str, *arguments: Any) -> None:
    """Calls cageproof_<name>. Raises Error, or MemoryError, with the library's text."""
    code = getattr(library, "cageproof_" + name)(*arguments)
    if code == 0:
        return
    text = library.cageproof_error().decode(errors="replace")
    if code == 2:
        raise MemoryError(text)
    raise Error(text) if code == 1 else RuntimeError(text)


class Handle:
    """Owns one of the library's objects."""

    def __init__(self, kind: str, make: str, *arguments: Any):
        self.pointer, self._free = c_void_p(), getattr(library, f"cageproof_{kind}_free")
        call(make, *arguments, byref(self.pointer))

    def __del__(self):
        if getattr(self, "pointer", None):
            self._free(self.pointer)
            self.pointer = c_void_p()


def numbers(array: Any, what: str) -> np.ndarray:
    """As C-contiguous float64: the array itself where it is that."""
    try:
        return np.ascontiguousarray(array, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise Error(f"{what}: no array of numbers: {error}") from None


def points_of(array: Any, dimension: int, what: str = "points") -> np.ndarray:
    """Points (n, dimension). Raises Error for another shape."""
    found = numbers(array, what)
    if found.ndim != 2 or found.shape[1] != dimension:
        raise Error(f"{what}: the shape is {found.shape}, not (n, {dimension})")
    return found


def result(shape: Sequence[int], out: Optional[np.ndarray] = None) -> np.ndarray:
    """An array to be filled: a new one, or the caller's. Raises Error for one of another shape or type."""
    if out is None:
        return np.empty(tuple(shape))
    good = isinstance(out, np.ndarray) and out.shape == tuple(shape) and out.dtype == np.float64
    if not good or not out.flags.c_contiguous or not out.flags.writeable:
        raise Error(f"out: not a writable C-contiguous array of float64 and shape {tuple(shape)}")
    return out


def passed(array: Optional[np.ndarray]) -> Tuple[Optional[int], int]:
    """An array as the library takes it: address and size in numbers."""
    return (None, 0) if array is None else (array.ctypes.data, array.size)


def options(given: dict) -> Tuple[Any, int]:
    """Keyword arguments as the library's options."""

    def text(value: Any) -> bytes:
        if isinstance(value, (bool, np.bool_)):
            return b"1" if value else b"0"
        return (value if isinstance(value, str) else repr(value.item() if hasattr(value, "item") else value)).encode()

    rows = [Option(name.encode(), text(value)) for name, value in given.items() if value is not None]
    return (Option * len(rows))(*rows), len(rows)


def names(of: str) -> List[str]:
    """Names of "kinds", "methods", "formulas", "cages", or a formula's evaluations, the recommended one first."""
    needed = c_size_t()
    call("list", of.encode(), None, 0, byref(needed))
    text = ctypes.create_string_buffer(needed.value)
    call("list", of.encode(), text, needed, None)
    return text.value.decode().split("\n")


def version() -> str:
    """The library's version, "0.1.0"."""
    return library.cageproof_version().decode()


