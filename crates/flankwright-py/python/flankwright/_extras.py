"""Libraries that are used only here and there. An error names the extra that brings them."""

from __future__ import annotations

import importlib
from typing import Any


def needed(module: str, extra: str) -> Any:
    """A module of an extra.

    Raises:
        ModuleNotFoundError: it is not installed.
    """
    try:
        return importlib.import_module(module)
    except ModuleNotFoundError as error:
        if error.name is None or error.name.partition(".")[0] != module.partition(".")[0]:
            raise
        text = f"this needs {error.name}: pip install 'flankwright[{extra}]'"
        raise ModuleNotFoundError(text, name=error.name) from None
