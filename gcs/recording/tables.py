"""Tables that grow while they are written, one file each: CSV, or Parquet where pyarrow is installed.

A column is a numpy array or a list of text. NaN, or what is masked, is an empty cell, in Parquet a null.
"""

from __future__ import annotations

import csv
import importlib.util
import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Literal, Protocol

import numpy as np
from numpy.typing import NDArray

Format = Literal["csv", "parquet"]
Column = NDArray[Any] | Sequence[Any]
NO_PARQUET = (
    "Parquet needs pyarrow, which is not installed: pip install '.[parquet]' in Skytender's checkout, "
    "or give --format csv."
)
ROW_GROUP = 1 << 17


class Tables(Protocol):
    """A folder of tables."""

    rows: dict[str, int]
    """how many each table has so far, in the order in which they began"""

    def append(self, table: str, columns: Mapping[str, Column]) -> None:
        """Add rows; a table has the columns of its first call, in their order and of their types. Raises OSError."""

    def close(self) -> None:
        """Finish every file."""


def available(form: Format) -> bool:
    """Whether this format can be written here."""
    return form == "csv" or importlib.util.find_spec("pyarrow") is not None


def tables(form: Format, folder: Path) -> Tables:
    """New tables in `folder`, which exists."""
    return CsvTables(folder) if form == "csv" else ParquetTables(folder)


class CsvTables:
    """RFC 4180 with a head line; numbers in as many digits as they need to be read back equal."""

    def __init__(self, folder: Path) -> None:
        self.rows: dict[str, int] = {}
        self._folder = folder
        self._files: dict[str, Any] = {}

    def append(self, table: str, columns: Mapping[str, Column]) -> None:
        """As `Tables.append`."""
        file = self._files.get(table)
        if file is None:
            file = self._files[table] = (self._folder / f"{table}.csv").open("w", encoding="utf-8", newline="")
            csv.writer(file, lineterminator="\n").writerow(columns)
            self.rows[table] = 0
        shown = [_cells(column) for column in columns.values()]
        csv.writer(file, lineterminator="\n").writerows(zip(*shown, strict=True))
        self.rows[table] += len(shown[0])

    def close(self) -> None:
        """As `Tables.close`."""
        for file in self._files.values():
            file.close()


def _cells(column: Column) -> Sequence[Any]:
    if not isinstance(column, np.ndarray):
        return column
    cells: list[Any] = column.tolist()
    if column.dtype.kind == "b":
        return [cell if cell is None else str(cell).lower() for cell in cells]
    if column.dtype.kind == "f" and not np.isfinite(column).all():
        return ["" if math.isnan(cell) else cell for cell in cells]
    return cells


class ParquetTables:
    """One Parquet file each, compressed; rows wait until a row group is full."""

    def __init__(self, folder: Path) -> None:
        self.rows: dict[str, int] = {}
        self._folder = folder
        self._writers: dict[str, Any] = {}
        self._waiting: dict[str, list[Any]] = {}

    def append(self, table: str, columns: Mapping[str, Column]) -> None:
        """As `Tables.append`."""
        import pyarrow  # noqa: PLC0415 - an extra of the package

        batch = pyarrow.RecordBatch.from_arrays(
            [_arrow(pyarrow, column) for column in columns.values()], names=list(columns)
        )
        self.rows[table] = self.rows.get(table, 0) + batch.num_rows
        waiting = self._waiting.setdefault(table, [])
        waiting.append(batch)
        if sum(one.num_rows for one in waiting) >= ROW_GROUP:
            self._write(table)

    def close(self) -> None:
        """As `Tables.close`."""
        for table in self._waiting:
            self._write(table)
        for writer in self._writers.values():
            writer.close()

    def _write(self, table: str) -> None:
        import pyarrow  # noqa: PLC0415
        import pyarrow.parquet  # noqa: PLC0415

        waiting = self._waiting[table]
        if not waiting:
            return
        whole = pyarrow.Table.from_batches(waiting)
        writer = self._writers.get(table)
        if writer is None:
            path = self._folder / f"{table}.parquet"
            writer = self._writers[table] = pyarrow.parquet.ParquetWriter(path, whole.schema, compression="zstd")
        writer.write_table(whole)
        waiting.clear()


def _arrow(pyarrow: Any, column: Column) -> Any:
    if not isinstance(column, np.ndarray):
        return pyarrow.array(column, type=pyarrow.string())
    return pyarrow.array(column, from_pandas=True)
