# SPDX-License-Identifier: MIT
"""As much of PyTorch as docs/gradients.md uses, over NumPy: tensors, and functions that are differentiated backward."""

from types import ModuleType, SimpleNamespace

import numpy as np


class Tensor:
    def __init__(self, array):
        self.array = np.array(array)

    def detach(self):
        return Tensor(self.array)

    cpu = detach

    def double(self):
        return Tensor(self.array.astype(np.float64))

    def numpy(self):
        return self.array

    def to(self, other):
        return Tensor(self.array.astype(other.array.dtype))


class Context(SimpleNamespace):
    def save_for_backward(self, *tensors):
        self.saved_tensors = tensors


class Function:
    """`apply` gives the result, and what takes weights of it back to the arguments."""

    @classmethod
    def apply(cls, *arguments):
        context = Context()
        return cls.forward(context, *arguments), lambda weights: cls.backward(context, weights)


def module():
    found = ModuleType("torch")
    found.from_numpy, found.autograd = Tensor, SimpleNamespace(Function=Function)
    return found
