"""What is wrong, as exceptions that carry what the command would tell."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

Finding = Mapping[str, Any]


class FlankwrightError(Exception):
    """Something has no result.

    Attributes:
        code: Stable kebab-case code, e.g. ``unknown-key``; that of the first finding.
        field: Path of the key that it is about, e.g. ``target.modifications[1].amount_um``.
        value: The value as given.
        allowed: What would be allowed.
        way_out: What to do about it.
        exit_status: The exit status that the command would have.
        findings: All findings, each with these entries and, where known, ``file``, ``line``, ``column``.
        omitted: How many further findings were not kept.
    """

    exit_status = 1

    def __init__(self, findings: Sequence[Finding], omitted: int = 0) -> None:
        self.findings = [dict(finding) for finding in findings]
        self.omitted = omitted
        first = self.findings[0] if self.findings else {}
        self.code: str = first.get("code", "internal-error")
        self.field: str | None = first.get("field")
        self.value: str | None = first.get("value")
        self.allowed: str | None = first.get("allowed")
        self.way_out: str | None = first.get("way_out")
        super().__init__("\n".join(_told(finding) for finding in self.findings))

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.findings, self.omitted)


class BadInput(FlankwrightError, ValueError):
    """The input itself is wrong or contradicts itself."""

    exit_status = 2


def bad_input(
    message: str, *, field: str, value: object, allowed: str, way_out: str, sample: int | None = None
) -> BadInput:
    """The exception for an argument that is wrong before anything is asked of the library."""
    told = {"field": field, "value": str(value), "allowed": allowed, "way_out": way_out}
    place = {} if sample is None else {"sample": sample}
    return BadInput([{"code": "invalid-argument", "message": message, **told, **place}])


class NotProducible(FlankwrightError):
    """Each part is valid, but these bodies cannot make the target."""

    exit_status = 4
    _refusal: Any = None

    def write(self, directory: str | os.PathLike[str]) -> list[Path]:
        """Writes ``result.json`` and ``report.html`` of the refused job: reason, bodies, for generating grinding the candidates that
        were tried and the picture of what limits.

        Args:
            directory: Where to; it is made if missing.

        Returns:
            The paths, the report last.

        Raises:
            ValueError: no task on a job raised this, or it came from another process.
            OSError: the files cannot be written.
        """
        if self._refusal is None:
            raise ValueError("there is nothing to report: no plan or simulation of this process raised this")
        return list(self._refusal.write(Path(directory)))


class InternalError(FlankwrightError):
    """A fault of the program."""

    exit_status = 1


def _told(finding: Finding) -> str:
    place = ""
    if "file" in finding:
        place = f"{finding['file']}:{finding['line']}:{finding['column']}: "
    if "sample" in finding:
        place = f"sample {finding['sample']}: "
    text = f"{place}{finding.get('message', '')} [{finding.get('code', '')}]"
    for key, words in (("field", "field"), ("value", "value"), ("allowed", "allowed"), ("way_out", "remedy")):
        if finding.get(key) is not None:
            text += f"\n  {words}: {finding[key]}"
    return text


def raised(exit_status: int, findings: str, omitted: int) -> FlankwrightError:
    """The exception for findings as JSON; called by the extension module."""
    kinds: dict[int, type[FlankwrightError]] = {2: BadInput, 4: NotProducible}
    return kinds.get(exit_status, InternalError)(json.loads(findings), omitted)
