"""Paths of keys as findings write them: ``target.modifications[1].amount_um``. Knows no key."""

from __future__ import annotations

import copy
import re
from collections.abc import Iterator, Mapping
from typing import Any

_STEP = re.compile(r"([^.\[\]]+)|\[(\d+)\]")


def steps(path: str) -> list[str | int]:
    """The steps of a path.

    Raises:
        KeyError: a text that is no path.
    """
    found: list[str | int] = []
    at = 0
    while at < len(path):
        if path[at] == "." and found and at + 1 < len(path):
            at += 1
        match = _STEP.match(path, at)
        if match is None:
            raise KeyError(f"{path!r} is no path of a key, such as 'target.modifications[1].amount_um'")
        found.append(match[1] if match[2] is None else int(match[2]))
        at = match.end()
    if not found:
        raise KeyError("a path has at least one key")
    return found


def get(tree: Any, path: str) -> Any:
    """The entry at a path.

    Raises:
        KeyError: there is none.
    """
    for step in steps(path):
        try:
            tree = tree[step]
        except (KeyError, IndexError, TypeError):
            raise KeyError(f"{path!r}: there is no {step!r}") from None
    return tree


def changed(tree: Mapping[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    """A tree with entries set; ``None`` takes an entry out. Tables that are absent are made, lists grow by one at most.

    Raises:
        KeyError: a path that leads nowhere.
    """
    new: dict[str, Any] = copy.deepcopy(dict(tree))
    for path, value in changes.items():
        *before, last = steps(path)
        at: Any = new
        for step in before:
            if isinstance(step, str) and isinstance(at, dict):
                at = at.setdefault(step, {})
            elif isinstance(step, int) and isinstance(at, list) and step < len(at):
                at = at[step]
            else:
                raise KeyError(f"{path!r}: there is no {step!r}")
        if isinstance(last, str) and isinstance(at, dict):
            if value is None:
                at.pop(last, None)
            else:
                at[last] = value
        elif isinstance(last, int) and isinstance(at, list) and last < len(at) + (value is not None):
            if value is None:
                del at[last]
            else:
                at[last : last + 1] = [value]
        else:
            raise KeyError(f"{path!r}: there is no {last!r}")
    return new


def words(tree: Any) -> Iterator[str]:
    """All words of a tree."""
    if isinstance(tree, str):
        yield tree
    elif isinstance(tree, Mapping):
        for inner in tree.values():
            yield from words(inner)
    elif isinstance(tree, list):
        for inner in tree:
            yield from words(inner)
