"""Rows of a campaign on disk: Parquet parts in one folder, written as they come, each whole or not at all.

Any reader of Parquet can open the folder `rows` while the campaign runs. A row that is in a part is done, until errors
are to be flown again. A part that cannot be read, as after a disk failure, holds no row: a writer sets it aside, and
its rows are flown again.
"""

from __future__ import annotations

import json
import os
import uuid
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from gcs.campaign import measures
from gcs.campaign.model import ARGUMENTS, CampaignRules
from gcs.extras import missing
from gcs.scenario import keys

if TYPE_CHECKING:
    import pyarrow as pa

FOLDER = "rows"
BROKEN = ".broken"
"""At the end of the name of a part that was set aside: no reader of the folder takes it for one."""
MOST_ROWS = 1 << 16
"""A part with more was not written here, and may be larger by far than its file."""
FIRST = ("row", "session", "combination", "seed")
FILLED = (*FIRST, "ok")
"""Columns that no row leaves empty."""


def schema(campaign: CampaignRules) -> pa.Schema:
    """The columns: session, what was varied and drawn, what was measured, how it went."""
    pa = _arrow()
    types: dict[str, Any] = dict.fromkeys(FIRST, pa.int64())
    for key, values in campaign.vary.items():
        types[key] = _type_of(values)
    for key, draw in campaign.draw.items():
        kind = (
            pa.string()
            if draw.random is not None
            else _type_of(draw.choice)
            if draw.choice is not None
            else pa.int64()
            if draw.integers is not None
            else pa.float64()
        )
        each = keys.EACH in key and not key.startswith(ARGUMENTS) and not draw.together
        types[key] = pa.list_(kind) if each else kind
    for name in campaign.measured:
        types[name] = pa.string() if measures.is_word(name) else pa.float64()
    types |= {"ok": pa.bool_(), "fault": pa.string(), "error": pa.string(), "digest": pa.string()}
    types |= {"wall_s": pa.float64(), "cpu_s": pa.float64(), "kept": pa.bool_()}
    return pa.schema(list(types.items()))


class Writer:
    """Writes rows of a campaign as parts."""

    def __init__(self, folder: Path, campaign: CampaignRules) -> None:
        self._folder = folder / FOLDER
        self._folder.mkdir(parents=True, exist_ok=True)
        for unfinished in self._folder.glob(".*"):
            unfinished.unlink(missing_ok=True)
        self._schema = schema(campaign)
        for path in broken(folder, campaign):
            path.rename(path.with_name(path.name + BROKEN))

    def write(self, rows: Sequence[Mapping[str, Any]]) -> None:
        """Add a part with these rows; raises OSError, and then nothing of it is there."""
        if not rows:
            return
        import pyarrow as pa  # noqa: PLC0415 - an extra

        columns = {
            field.name: pa.array([_fitted(row.get(field.name), field.type) for row in rows], field.type)
            for field in self._schema
        }
        name = f"part-{rows[0]['row']:08d}-{uuid.uuid4().hex[:8]}.parquet"
        self._put(self._folder / name, pa.table(columns, schema=self._schema))

    def drop_errors(self) -> None:
        """Take out the rows of sessions that ended with an error; raises OSError."""
        import pyarrow.compute as pc  # noqa: PLC0415 - an extra

        for path, part in _parts(self._folder.parent, self._schema).items():
            assert part is not None  # a broken one was set aside
            kept = part.filter(pc.is_null(part["error"]))
            if not kept.num_rows:
                path.unlink()
            elif kept.num_rows < part.num_rows:
                self._put(path, kept)

    @staticmethod
    def _put(path: Path, part: pa.Table) -> None:
        """Write a part, or put it in place of another, whole or not at all; raises OSError."""
        import pyarrow.parquet as pq  # noqa: PLC0415 - an extra

        beside = path.with_name(f".{path.name}")
        try:
            pq.write_table(part, beside, compression="zstd")
            with beside.open("rb") as written:
                os.fsync(written.fileno())
            beside.replace(path)
        except BaseException:
            beside.unlink(missing_ok=True)
            raise


def read(folder: Path, campaign: CampaignRules) -> pa.Table:
    """All rows so far, in order of their numbers, without broken parts; raises OSError."""
    pa, wanted = _arrow(), schema(campaign)
    parts = [part for part in _parts(folder, wanted).values() if part is not None]
    table = pa.concat_tables(parts) if parts else wanted.empty_table()
    return table.sort_by("row")


def broken(folder: Path, campaign: CampaignRules) -> list[Path]:
    """Parts that cannot be read; raises OSError."""
    return [path for path, part in _parts(folder, schema(campaign)).items() if part is None]


def _parts(folder: Path, wanted: pa.Schema) -> dict[Path, pa.Table | None]:
    """Each part by its path, None for a broken one. Raises OSError where a file cannot be opened."""
    return {path: _part(path, wanted) for path in sorted((folder / FOLDER).glob("part-*.parquet"))}


def _part(path: Path, wanted: pa.Schema) -> pa.Table | None:
    import pyarrow as pa  # noqa: PLC0415 - an extra
    import pyarrow.parquet as pq  # noqa: PLC0415

    # A file of Python's would be released by Arrow's threads, also while the process ends, and wait for its lock then.
    with pa.OSFile(str(path)) as file:
        try:
            if pq.ParquetFile(file).metadata.num_rows > MOST_ROWS:
                return None
            part = pq.read_table(file, schema=wanted)
            part.validate(full=True)
        except (pa.ArrowException, OSError, UnicodeDecodeError):  # OSError: what does not fit together; a column's name
            return None
    return None if any(part[name].null_count for name in FILLED) else part


def _type_of(values: Sequence[Any]) -> pa.DataType:
    pa = _arrow()
    if all(isinstance(value, bool) for value in values):
        return pa.bool_()
    if all(isinstance(value, int | float) and not isinstance(value, bool) for value in values):
        return pa.float64()
    return pa.string()


def _fitted(value: Any, kind: pa.DataType) -> Any:
    """A value as its column has it: what is no number, word or truth value is JSON."""
    import pyarrow as pa  # noqa: PLC0415

    if value is None:
        return None
    if pa.types.is_list(kind):
        return [_fitted(one, kind.value_type) for one in value]
    if pa.types.is_string(kind) and not isinstance(value, str):
        return json.dumps(value)
    return float(value) if pa.types.is_floating(kind) else value


def _arrow() -> Any:
    try:
        import pyarrow as pa  # noqa: PLC0415
    except ImportError:
        raise missing("a campaign's table", "pyarrow", "campaign") from None
    return pa
