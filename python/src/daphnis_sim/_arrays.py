"""Arrays between NumPy and Java."""

from __future__ import annotations

from operator import methodcaller
from typing import Any

import jpype
import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._errors import InputError

_MOST = 2**31 - 1


def numbers(name: str, values: ArrayLike, shape: tuple[int | str, ...]) -> NDArray[np.float64]:
    """`values` as finite float64 numbers of `shape`, in which a word stands for any length.

    Copies only what has another type. Whole numbers and shorter floats are taken, anything else is not.

    Raises:
        InputError: the argument `name` has another shape or type, or holds a number that is not finite.
    """
    try:
        array = np.asarray(values)
    except ValueError:
        raise InputError(f"{name}: rows differ in length; its shape must be {_said(shape)}") from None
    _unmasked(name, values)
    if array.dtype.kind not in "fiu" or array.dtype.itemsize > 8:
        raise InputError(f"{name}: holds {array.dtype}; it must hold numbers that fit into float64")
    if array.ndim != len(shape) or any(isinstance(n, int) and n != m for n, m in zip(shape, array.shape, strict=True)):
        raise InputError(f"{name}: has shape {array.shape}; it must be {_said(shape)}")
    array = array.astype(np.float64, copy=False)
    wrong = np.argwhere(~np.isfinite(array))
    if len(wrong):
        place = f"[{', '.join(str(k) for k in wrong[0])}]" if shape else ""
        raise InputError(f"{name}{place} is {array[tuple(wrong[0])]}; it must be finite")
    return array


def _unmasked(name: str, values: ArrayLike) -> None:
    masked = np.argwhere(np.ma.getmaskarray(values)) if isinstance(values, np.ma.MaskedArray) else ()
    if len(masked):
        place = f"[{', '.join(str(k) for k in masked[0])}]" if len(masked[0]) else ""
        raise InputError(f"{name}{place} is masked; fill it or leave the sphere out")


def each(name: str, values: ArrayLike, n: int) -> NDArray[np.float64]:
    """`values` of the spheres, one for all or one for each of `n`."""
    if np.ndim(values) == 0:
        return np.full(n, numbers(name, values, ()))
    return numbers(name, values, (n,))


def ids(values: ArrayLike | None, n: int) -> NDArray[np.int32]:
    """`values` as ids; 0, 1, 2, … for None."""
    if values is None:
        return np.arange(n, dtype=np.int32)
    _unmasked("id", values)
    array = np.asarray(values)
    if array.dtype.kind not in "iu":
        raise InputError(f"id: holds {array.dtype}; it must hold whole numbers")
    if array.shape != (n,):
        raise InputError(f"id: has shape {array.shape}; it must be ({n},)")
    if n and (array.min() < 0 or array.max() > _MOST):
        raise InputError(f"id: from {array.min()} to {array.max()}; ids must be in 0..{_MOST}")
    return array.astype(np.int32)


def doubles(array: NDArray[np.float64]) -> Any:
    """A Java ``double[]`` with the numbers of a 1-d `array`: one copy."""
    java = jpype.JArray(jpype.JDouble)(len(array))
    _buffer(np.ascontiguousarray(array), "asDoubleBuffer", methodcaller("get", java))
    return java


def ints(array: NDArray[np.int32]) -> Any:
    """A Java ``int[]`` with the numbers of a 1-d `array`: one copy."""
    java = jpype.JArray(jpype.JInt)(len(array))
    _buffer(np.ascontiguousarray(array), "asIntBuffer", methodcaller("get", java))
    return java


def of_doubles(java: Any) -> NDArray[np.float64]:
    """The numbers of a Java ``double[]``: one copy, straight into the memory of NumPy."""
    array = np.empty(len(java))
    _buffer(array, "asDoubleBuffer", methodcaller("put", java))
    return array


def of_ints(java: Any) -> NDArray[np.int32]:
    """The numbers of a Java ``int[]``: one copy."""
    array = np.empty(len(java), np.int32)
    _buffer(array, "asIntBuffer", methodcaller("put", java))
    return array


def columns(x: Any, y: Any, z: Any) -> NDArray[np.float64]:
    """Three Java ``double[]`` of length n as one array of shape (n, 3), whose columns are contiguous: one copy."""
    block = np.empty((3, len(x)))
    for row, java in zip(block, (x, y, z), strict=True):
        _buffer(row, "asDoubleBuffer", methodcaller("put", java))
    return block.T


def _buffer(array: NDArray[Any], view: str, act: Any) -> None:
    """Lets Java act on the memory of a contiguous `array`."""
    if array.size == 0:
        return
    order = jpype.JClass("java.nio.ByteOrder").nativeOrder()
    act(getattr(jpype.nio.convertToDirectBuffer(array).order(order), view)())


def _said(shape: tuple[int | str, ...]) -> str:
    if not shape:
        return "()"
    return "(" + ", ".join(str(n) for n in shape) + (",)" if len(shape) == 1 else ")")
