"""By which a function is known again after a restart: its code and all values that it holds, not its name."""

from __future__ import annotations

import functools
import hashlib
import pickle
import types
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

# Values of a module that a function may look up and that take part in what it computes.
_PLAIN = (bool, int, float, complex, str, bytes, tuple, frozenset, np.ndarray, np.generic)


def identity(function: Callable[..., Any]) -> str:
    """A hash (SHA-256) of code, defaults, enclosed values and plain values of its module that it names. Another Python version is another code.

    Raises:
        ValueError: a function that holds what cannot be pickled.
    """
    digest = hashlib.sha256()
    for part in _parts(function, set()):
        digest.update(len(part).to_bytes(8, "little") + part)
    return digest.hexdigest()


def _parts(value: Any, seen: set[int]) -> Iterator[bytes]:
    if id(value) in seen:
        yield b"again"
        return
    if isinstance(value, functools.partial):
        yield b"partial"
        for inner in (value.func, *value.args, *sorted(value.keywords.items())):
            yield from _parts(inner, seen)
    elif isinstance(value, types.MethodType):
        yield b"method"
        yield from _parts(value.__func__, seen)
        yield from _parts(value.__self__, seen)
    elif isinstance(value, types.FunctionType):
        seen.add(id(value))
        yield b"function"
        yield from _of_code(value.__code__)
        yield from _parts((value.__defaults__, sorted((value.__kwdefaults__ or {}).items())), seen)
        for cell in value.__closure__ or ():
            yield from _parts(cell.cell_contents, seen)
        for name in sorted(set(_names(value.__code__))):
            there = value.__globals__.get(name)
            if isinstance(there, (*_PLAIN, types.FunctionType, functools.partial)):
                yield name.encode()
                yield from _parts(there, seen)
    else:
        try:
            yield pickle.dumps(value, protocol=4)
        except (pickle.PicklingError, AttributeError, TypeError) as error:
            text = f"a function of a sweep that is kept in a folder holds {value!r}, by which it cannot be known again ({error})"
            raise ValueError(f"{text}: give it plain values") from None


def _of_code(code: types.CodeType) -> Iterator[bytes]:
    yield code.co_code
    yield repr((code.co_names, code.co_varnames, code.co_freevars, code.co_flags)).encode()
    for constant in code.co_consts:
        if isinstance(constant, types.CodeType):
            yield from _of_code(constant)
        else:
            # The order of a set is not that of another process.
            yield repr(sorted(map(repr, constant)) if isinstance(constant, frozenset) else constant).encode()


def _names(code: types.CodeType) -> Iterator[str]:
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, types.CodeType):
            yield from _names(constant)
