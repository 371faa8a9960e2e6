"""A sweep on the disk: what is asked, and a file for every finished chunk. A chunk is there whole or not at all."""

from __future__ import annotations

import hashlib
import json
import shutil
from collections.abc import Iterable
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from .._extras import needed
from .._files import written
from .._values import plain
from ._outputs import Columns, joined
from ._samples import Samples

Form = Literal["parquet", "zarr"]
FORMS: tuple[Form, ...] = ("parquet", "zarr")


class Folder:
    """The folder of a sweep.

    Args:
        path: Made if missing.
        asked: What the sweep is; a folder of another sweep is refused.
        form: ``parquet``: a file for each chunk, for numbers and words; ``zarr``: arrays of any shape, chunked as they are computed.
    """

    def __init__(self, path: Path, asked: dict[str, Any], samples: Samples, chunk: int, form: Form) -> None:
        self.path, self.samples, self.chunk, self.form = path, samples, chunk, form
        needed(*(("pyarrow", "sweep") if form == "parquet" else ("zarr", "sweep")))
        self.outputs = list(asked["outputs"])
        path.mkdir(parents=True, exist_ok=True)
        (path / "chunks").mkdir(exist_ok=True)
        asked = {**asked, "samples": samples.digest(), "chunk": chunk, "form": form, "shape": list(samples.shape)}
        manifest = path / "sweep.json"
        # Nothing is lost with a folder in which nothing is finished.
        if manifest.exists() and any((path / "chunks").iterdir()):
            there = json.loads(manifest.read_text(encoding="utf-8"))
            if there != asked:
                other = sorted(key for key in {*there, *asked} if there.get(key) != asked.get(key))
                raise ValueError(
                    f"{path} holds another sweep (it differs in {', '.join(other)}): choose another folder, or remove this one"
                )
        else:
            if form == "zarr":
                for group in ("samples", "results"):
                    shutil.rmtree(path / f"{group}.zarr", ignore_errors=True)
                self._put_zarr("samples", 0, _told(samples), len(samples))
            else:
                written(path / "samples.parquet", lambda to: _to_parquet(_told(samples), to))
            written(manifest, lambda to: to.write_text(json.dumps(asked, indent=2), encoding="utf-8"))

    def has(self, part: slice) -> bool:
        """Whether a chunk is finished."""
        return self._mark(part).exists()

    def put(self, part: slice, columns: Columns) -> None:
        """Keeps a finished chunk."""
        if self.form == "zarr":
            self._put_zarr("results", part.start, columns, len(self.samples))
            written(self._mark(part), lambda to: to.write_text(_digest(columns), encoding="utf-8"))
        else:
            # Every file has every column: who reads them all takes the names of the first.
            empty = {name: np.full(part.stop - part.start, np.nan) for name in self.outputs}
            written(self._mark(part), lambda to: _to_parquet({**empty, **columns}, to))

    def known(self) -> Columns:
        """Columns as the finished chunks have them, without the errors; of no sample if nothing is finished."""
        columns = self._parquet_columns() if self.form == "parquet" else self._zarr_columns()
        return {name: values[:0] for name, values in columns.items() if name != "error"}

    def _parquet_columns(self) -> Columns:
        columns: Columns = {}
        for path in sorted((self.path / "chunks").glob("*.parquet")):
            columns = {**_from_parquet(path), **columns}
            # One chunk tells it, unless all of its samples were refused.
            if all(name in columns for name in self.outputs):
                break
        return columns

    def _zarr_columns(self) -> Columns:
        import zarr

        path = self.path / "results.zarr"
        if not path.exists():
            return {}
        root: Any = zarr.open_group(path, mode="r")
        return {str(name): np.asarray(root[name][:0]) for name in root}

    def get(self) -> Columns:
        """All finished chunks, in order; missing ones are left out."""
        return read(self.path, self.form, self.chunk, len(self.samples), self.outputs)[1]

    def _mark(self, part: slice) -> Path:
        return self.path / "chunks" / _name(part.start // self.chunk, self.form)

    def _put_zarr(self, group: str, start: int, columns: Columns, count: int) -> None:
        import zarr

        root: Any = zarr.open_group(self.path / f"{group}.zarr", mode="a")
        for name, values in columns.items():
            if name not in root:
                root.create_array(
                    name,
                    shape=(count, *values.shape[1:]),
                    chunks=(min(self.chunk, count), *values.shape[1:]),
                    dtype=str if values.dtype.kind == "U" else values.dtype,
                    fill_value={"U": "", "f": np.nan}.get(values.dtype.kind, 0),
                )
            root[name][start : start + len(values)] = values


def _told(samples: Samples) -> Columns:
    """Samples for who reads the folder: numbers beside words as JSON."""
    mixed = {path: of for path, of in samples.columns.items() if of.dtype.kind == "O"}
    words = {path: np.array([json.dumps(value) for value in plain(of)], dtype=np.str_) for path, of in mixed.items()}
    return {**samples.columns, **words}


def read(
    path: Path, form: Form, chunk: int, count: int, outputs: Iterable[str]
) -> tuple[NDArray[np.int64], Columns]:
    """The samples of finished chunks by their numbers, and their columns."""
    starts = range(0, count, chunk)
    there = [k for k in range(len(starts)) if (path / "chunks" / _name(k, form)).exists()]
    rows = np.concatenate([np.arange(0), *(np.arange(starts[k], min(starts[k] + chunk, count)) for k in there)])
    if not there:
        return rows, {}
    if form == "parquet":
        return rows, joined([_from_parquet(path / "chunks" / _name(k, form)) for k in there], outputs)
    import zarr

    root: Any = zarr.open_group(path / "results.zarr", mode="r")
    return rows, joined([{str(name): np.asarray(root[name][:])[rows] for name in root}], outputs)


def _name(number: int, form: Form) -> str:
    return f"{number:06d}.{'parquet' if form == 'parquet' else 'done'}"


def _digest(columns: Columns) -> str:
    digest = hashlib.sha256()
    for name, values in sorted(columns.items()):
        digest.update(name.encode() + np.ascontiguousarray(values).tobytes())
    return digest.hexdigest()


def _to_parquet(columns: dict[str, NDArray[Any]], to: Path) -> None:
    import pyarrow
    import pyarrow.parquet

    deep = [name for name, values in columns.items() if values.ndim > 1]
    if deep:
        raise ValueError(f"the outputs {', '.join(deep)} are arrays: Parquet keeps numbers and words, Zarr keeps arrays")
    pyarrow.parquet.write_table(pyarrow.table({name: values for name, values in columns.items()}), to)


def _from_parquet(path: Path) -> Columns:
    import pyarrow.parquet

    found = pyarrow.parquet.read_table(path)
    columns = {name: found[name].to_numpy(zero_copy_only=False) for name in found.column_names}
    if (columns["error"] != "").all():
        columns = {"error": columns["error"]}
    return {name: of.astype(np.str_) if of.dtype.kind == "O" else of for name, of in columns.items()}
