"""Jobs: what is wanted and with which bodies, as in a job file."""

from __future__ import annotations

import html
import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from . import _core, _paths
from ._files import written
from ._values import plain


@dataclass(frozen=True)
class Quantity:
    """A quantity that follows from a job.

    Attributes:
        key: Its name, stable, e.g. ``pitch_diameter_mm``.
        label: Its name in words.
        value: A number, a word, or a list of them.
        unit: Unit of the value; empty where it has none.
    """

    key: str
    label: str
    value: Any
    unit: str


@dataclass(frozen=True)
class Remark:
    """Something worth saying that is no error.

    Attributes:
        code: Stable kebab-case code.
        text: What is to be said, in one sentence.
        way_out: What to do about it.
    """

    code: str
    text: str
    way_out: str


class Derived(dict[str, Quantity]):
    """What follows from a job, by key: diameters, base data, measures, contact.

    Attributes:
        warnings: Remarks on the job.
    """

    warnings: list[Remark]

    def __init__(self, document: Mapping[str, Any]) -> None:
        sections = document["sections"]
        super().__init__({q["key"]: Quantity(**q) for section in sections for q in section["quantities"]})
        self.warnings = [Remark(**remark) for remark in document["warnings"]]
        self._sections = sections

    def _repr_html_(self) -> str:
        rows = ""
        for section in self._sections:
            rows += f"<tr><th colspan='3' style='text-align:left'>{html.escape(section['title'])}</th></tr>"
            for q in section["quantities"]:
                value = f"{q['value']:.6g}" if isinstance(q["value"], float) else str(q["value"])
                cells = (q["label"], value, q["unit"])
                rows += "<tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in cells) + "</tr>"
        return f"<table>{rows}</table>"


class Job:
    """A checked job of any process. It does not change; :meth:`replace` makes another one.

    Args:
        tree: The job as nested dictionaries, with the keys of a job file.
        directory: Where files that it names are looked for; the working directory unless given.

    Raises:
        BadInput: everything that is wrong with it.
    """

    __slots__ = ("_core", "_tree")

    def __init__(self, tree: Mapping[str, Any], directory: str | Path | None = None) -> None:
        self._core = _core.CoreJob(json.dumps(plain(tree)), _name(directory))
        self._tree: dict[str, Any] | None = None

    @classmethod
    def _of(cls, core: _core.CoreJob) -> Job:
        job = cls.__new__(cls)
        job._core, job._tree = core, None
        return job

    @classmethod
    def load(cls, path: str | Path) -> Job:
        """Reads a job file (TOML or JSON).

        Raises:
            BadInput: the file cannot be read, or everything that is wrong with it, with line and column.
        """
        return cls._of(_core.CoreJob.read(Path(path)))

    @classmethod
    def parse(cls, text: str, directory: str | Path | None = None) -> Job:
        """A job from a text (TOML or JSON).

        Raises:
            BadInput: everything that is wrong with it.
        """
        return cls._of(_core.CoreJob(text, _name(directory)))

    @classmethod
    def template(cls, process: str = "generating-grinding") -> Job:
        """The commented job of ``flankwright new PROCESS``: it runs as it is.

        Args:
            process: ``generating-grinding``, ``tangential-dressing``, ``electronic-gearbox``, ``five-axis-milling`` or
                ``skiving-tool-measuring``.

        Raises:
            BadInput: a process that is none.
        """
        return cls.parse(_core.template(process))

    @property
    def name(self) -> str:
        """Name of the job."""
        return self._core.name

    @property
    def process(self) -> str:
        """Its process, e.g. ``generating-grinding``."""
        return self._core.process

    @property
    def text(self) -> str:
        """Its text, as it was given."""
        return self._core.text

    @property
    def source(self) -> str:
        """The file that it came from, or the one as which it is read."""
        return self._core.source

    @property
    def tree(self) -> dict[str, Any]:
        """The job as nested dictionaries; a copy."""
        tree: dict[str, Any] = json.loads(self._core.tree())
        return tree

    def __getitem__(self, path: str) -> Any:
        """The entry at a path, e.g. ``job["gear.teeth"]``.

        Raises:
            KeyError: the job has no such entry.
        """
        if self._tree is None:
            self._tree = self.tree
        return _paths.get(self._tree, path)

    def __contains__(self, path: str) -> bool:
        """Whether there is an entry at a path."""
        try:
            self[path]
        except KeyError:
            return False
        return True

    def replace(self, changes: Mapping[str, Any] | None = None, /, **more: Any) -> Job:
        """Another job with entries set, e.g. ``job.replace({"gear.teeth": 31, "target.tolerance_um": 2})``.

        Args:
            changes: Values by path; ``None`` takes an entry out. Tables that are absent are made.
            more: The same for paths that are names, with ``__`` for the dot: ``gear__teeth=31``.

        Raises:
            KeyError: a path that leads nowhere.
            BadInput: what is wrong with the new job.
        """
        if self._tree is None:
            self._tree = self.tree
        named = {path.replace("__", "."): value for path, value in more.items()}
        tree = _paths.changed(self._tree, plain({**(changes or {}), **named}))
        # Its files lie where they lay; what it is written in shows from the name.
        return self._of(_core.CoreJob(json.dumps(tree), str(Path(self.source).with_suffix(".json"))))

    def files(self) -> list[Path]:
        """Files that its entries name and that are there: machines, tables, readings."""
        if self._tree is None:
            self._tree = self.tree
        beside = Path(self.source).parent
        named = (beside / word for word in _paths.words(self._tree) if word and "\0" not in word and len(word) < 1024)
        return sorted({path for path in named if path.is_file()})

    def check(self) -> Derived:
        """What follows from the job before anything is planned: diameters, base data, measures, contact, with their units.

        Raises:
            BadInput: bodies that are impossible.
        """
        return Derived(json.loads(self._core.derived()))

    def save(self, path: str | Path) -> None:
        """Writes its text, as UTF-8.

        Raises:
            OSError: the file cannot be written.
        """
        written(Path(path), lambda part: part.write_text(self.text, encoding="utf-8"))

    def __reduce__(self) -> tuple[Any, ...]:
        # Files that it names lie where they lay, whatever the folder of the process that takes it.
        return _again, (self.text, os.path.abspath(self.source))

    def __repr__(self) -> str:
        return f"<Job {self.name!r}: {self.process}>"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Job) and (self.text, self.source) == (other.text, other.source)

    def __hash__(self) -> int:
        return hash((self.text, self.source))

    def _repr_html_(self) -> str:
        return f"<details><summary>{html.escape(repr(self))}</summary><pre>{html.escape(self.text)}</pre></details>"


def _name(directory: str | Path | None) -> str:
    return str(Path(directory or ".") / "job")


def _again(text: str, source: str) -> Job:
    return Job._of(_core.CoreJob(text, source))


def schema() -> dict[str, Any]:
    """The JSON schema of jobs (draft 2020-12)."""
    found: dict[str, Any] = json.loads(_core.schema())
    return found
