"""Arguments of what users call: of the types that their annotations say, or refused at once in one line."""

from __future__ import annotations

import difflib
import functools
import inspect
import types
import typing
from collections.abc import Callable, Collection, Mapping, Sequence, Set
from numbers import Integral, Real
from typing import Any, TypeVar, Union

import numpy as np

from ._errors import ArgumentTypeError

_F = TypeVar("_F", bound=Callable[..., Any])
_EMPTY = inspect.Parameter.empty


def checked(function: _F) -> _F:
    """`function`, whose arguments must be of the types that it annotates.

    Numbers of NumPy come to it as those of Python. What is annotated with a protocol, such as ``ArrayLike``, is for the
    function itself to look at.

    Raises:
        ArgumentTypeError: an argument has another type, or there is none of that name; the nearest one is named.
    """
    signature = inspect.signature(function)
    words = [name for name, p in signature.parameters.items() if p.kind is not p.POSITIONAL_ONLY and name != "self"]
    takes_any = any(p.kind is p.VAR_KEYWORD for p in signature.parameters.values())
    name = function.__qualname__.removesuffix(".__init__").rsplit(".", 1)[-1]

    @functools.cache
    def hints() -> dict[str, Any]:
        # When it is first called: by then all modules are there, but perhaps not that of what it gives.
        of = types.SimpleNamespace(__annotations__={word: signature.parameters[word].annotation for word in words})
        return typing.get_type_hints(of, function.__globals__)

    @functools.wraps(function)
    def call(*args: Any, **keywords: Any) -> Any:
        for word in keywords:
            if word not in words and not takes_any:
                near = difflib.get_close_matches(word, words, 1)
                raise ArgumentTypeError(
                    f"{name}: has no argument {word!r}; "
                    + (f"did you mean {near[0]}?" if near else f"there are {', '.join(words)}")
                )
        try:
            bound = signature.bind(*args, **keywords)
        except TypeError:
            # One is missing, or there are too many: Python itself says so, with the name of the function.
            return function(*args, **keywords)
        for word, value in bound.arguments.items():
            hint = hints().get(word)
            if hint is None:
                continue
            if signature.parameters[word].kind is inspect.Parameter.VAR_POSITIONAL:
                bound.arguments[word] = tuple(_taken(word, one, hint) for one in value)
            else:
                bound.arguments[word] = _taken(word, value, hint)
        return function(*bound.args, **bound.kwargs)

    return typing.cast(_F, call)


def _taken(name: str, value: Any, hint: Any) -> Any:
    """`value` as one of the types in `hint`."""
    choices = _choices(hint)
    for choice in choices:
        found = _as(name, value, choice)
        if found is not _EMPTY:
            return found
    raise wrong_type(name, value, " or ".join(dict.fromkeys(_in_words(choice) for choice in choices)))


def wrong_type(name: str, value: Any, right: str) -> ArgumentTypeError:
    """The argument `name` should have been what `right` says."""
    shown = " ".join(repr(value).split())
    shown = shown if len(shown) <= 60 else f"a {type(value).__name__}"
    return ArgumentTypeError(f"{name}: is {shown}; it must be {right}")


def _choices(hint: Any) -> tuple[Any, ...]:
    if typing.get_origin(hint) in (Union, types.UnionType):
        return tuple(inner for one in typing.get_args(hint) for inner in _choices(one))
    return (hint,)


def _as(name: str, value: Any, kind: Any) -> Any:
    """`value`, as a type of Python where it is a number of NumPy; `_EMPTY` if it is of another `kind`."""
    origin: Any = typing.get_origin(kind) or kind
    if isinstance(value, np.ndarray) and value.ndim == 0 and kind in (float, int, bool):
        value = value[()]
    if kind is float:
        is_number = isinstance(value, Real) and not isinstance(value, (bool, np.bool_))
        return (value if isinstance(value, (float, int)) else float(value)) if is_number else _EMPTY
    if kind is int:
        return int(value) if isinstance(value, Integral) and not isinstance(value, (bool, np.bool_)) else _EMPTY
    if kind is bool:
        return bool(value) if isinstance(value, (bool, np.bool_)) else _EMPTY
    if origin is Callable:
        return value if callable(value) else _EMPTY
    if origin is Sequence:
        return _sequence(name, value, typing.get_args(kind))
    if not isinstance(origin, type) or getattr(origin, "_is_protocol", False):
        return value
    if isinstance(value, Mapping) and any(not isinstance(key, str) for key in value):
        raise ArgumentTypeError(f"{name}: has a key that is no text: {list(value)}")
    return value if isinstance(value, origin) else _EMPTY


def _sequence(name: str, value: Any, of: tuple[Any, ...]) -> Any:
    """`value` as a list, each entry looked at."""
    if isinstance(value, (str, bytes, Mapping, Set)) or not isinstance(value, Collection):
        return _EMPTY
    if isinstance(value, np.ndarray) and value.ndim == 0:
        return _EMPTY
    return [_taken(f"{name}[{k}]", one, *of) for k, one in enumerate(value)]


def _in_words(kind: Any) -> str:
    origin = typing.get_origin(kind) or kind
    if origin is Sequence:
        return f"a list of {_in_words(*typing.get_args(kind))}".replace(" of a number", " of numbers")
    return _WORDS.get(origin.__name__, f"a {origin.__name__}")


_WORDS = {
    "Callable": "a function",
    "Force": "what daphnis.kick or daphnis.acceleration made",
    "Mapping": "a dict such as {'until': 10}",
    "NoneType": "None",
    "PathLike": "a path",
    "bool": "True or False",
    "float": "a number",
    "int": "a whole number",
    "str": "text",
}
