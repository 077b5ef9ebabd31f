"""Parts of a campaign's table that cannot be read hold no rows, and hide no other's."""

from __future__ import annotations

import random
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from commands import gcs

from gcs.campaign import statistics, table
from gcs.campaign.file import from_data
from gcs.campaign.plan import Plan, make

CAMPAIGN = {
    "schema": 1,
    "name": "small",
    "scenario": "paper/example1",
    "sessions": 6,
    "measure": ["min_separation_m"],
    "set": {"goal.duration_s": 1},
}


@pytest.fixture
def written(tmp_path: Path) -> tuple[Path, Plan]:
    """A campaign's folder whose six rows lie in two parts."""
    flown, folder = make(from_data(CAMPAIGN), []), tmp_path / "campaign"
    folder.mkdir()
    flown.write(folder)
    writer = table.Writer(folder, flown.campaign)
    for first in (0, 3):
        writer.write([row(number) for number in range(first, first + 3)])
    return folder, flown


def row(number: int) -> dict[str, Any]:
    rest = {"combination": 0, "seed": 1, "min_separation_m": 1.5, "ok": True, "kept": False, "digest": "sha256:x"}
    return {"row": number, "session": number, **rest}


def parts(folder: Path) -> list[Path]:
    return sorted((folder / "rows").iterdir())


def numbers(folder: Path, flown: Plan) -> list[int]:
    return list(table.read(folder, flown.campaign)["row"].to_pylist())


@pytest.mark.parametrize("size", [0, 4, 2000, -1])
def test_of_a_part_that_was_cut_the_others_rows_are_read(size: int, written: tuple[Path, Plan]) -> None:
    folder, flown = written
    first, second = parts(folder)
    content = first.read_bytes()
    first.write_bytes(content[: size if size >= 0 else len(content) - 1])
    assert table.broken(folder, flown.campaign) == [first]
    assert numbers(folder, flown) == [3, 4, 5]
    writer = table.Writer(folder, flown.campaign)
    assert table.broken(folder, flown.campaign) == []
    assert parts(folder) == [first.with_name(f"{first.name}.broken"), second]
    writer.write([row(number) for number in range(3)])
    assert numbers(folder, flown) == list(range(6))


def test_no_flipped_bit_makes_reading_raise(written: tuple[Path, Plan]) -> None:
    folder, flown = written
    first, _ = parts(folder)
    whole, rng = first.read_bytes(), random.Random(3)
    for _ in range(80):
        at = rng.randrange(len(whole))
        first.write_bytes(whole[:at] + bytes([whole[at] ^ 1 << rng.randrange(8)]) + whole[at + 1 :])
        assert {3, 4, 5} <= set(numbers(folder, flown))


def test_a_part_whose_columns_name_is_no_text_is_broken(written: tuple[Path, Plan]) -> None:
    folder, flown = written
    path = next(folder.glob("rows/part-*.parquet"))
    path.write_bytes(path.read_bytes().replace(b"row", b"r\x9bw"))
    assert table.broken(folder, flown.campaign) == [path]


@pytest.mark.parametrize(
    "foreign",
    [
        pa.table({"other": [1, 2]}),
        pa.table({"row": ["a", "b"]}),
        pa.table({"row": pa.array([1, None])}),
        pa.table({"row": pa.array([0]), "ok": ["yes"]}),
        pa.table({"row": pa.array([0] * (table.MOST_ROWS + 1))}),
    ],
    ids=["other columns", "words for numbers", "no number", "a word for a truth", "more rows than any part"],
)
def test_what_is_no_part_of_this_table_is_broken(foreign: pa.Table, written: tuple[Path, Plan]) -> None:
    folder, flown = written
    path = folder / "rows" / "part-99999999-foreign.parquet"
    pq.write_table(foreign, path)
    assert table.broken(folder, flown.campaign) == [path]
    assert numbers(folder, flown) == list(range(6))


@pytest.mark.parametrize("column", ["row", "seed", "ok"])
def test_a_part_with_a_row_that_lacks_its_number_or_its_verdict_is_broken(
    column: str, written: tuple[Path, Plan]
) -> None:
    folder, flown = written
    first, _ = parts(folder)
    part = pq.read_table(first)
    values = [None, *part[column].to_pylist()[1:]]
    at = part.column_names.index(column)
    pq.write_table(part.set_column(at, part.schema.field(at), pa.array(values, part.schema.field(at).type)), first)
    assert table.broken(folder, flown.campaign) == [first]
    assert numbers(folder, flown) == [3, 4, 5]


def test_what_a_row_may_lack_it_may_lack(written: tuple[Path, Plan]) -> None:
    folder, flown = written
    for path in parts(folder):
        part = pq.read_table(path)
        for column in ("min_separation_m", "fault", "error", "digest", "wall_s", "cpu_s", "kept"):
            at = part.column_names.index(column)
            none = pa.nulls(part.num_rows, part.schema.field(at).type)
            part = part.set_column(at, part.schema.field(at), none)
        pq.write_table(part, path)
    assert numbers(folder, flown) == list(range(6))
    statistics.text(flown, table.read(folder, flown.campaign))
    assert gcs("campaign", "report", str(folder)).returncode == 0


def test_commands_name_it_and_resume_flies_its_rows_again(written: tuple[Path, Plan]) -> None:
    folder, flown = written
    first, _ = parts(folder)
    first.write_bytes(first.read_bytes()[:2000])
    sentence = (
        f"gcs: {first}: no rows can be read from it; gcs campaign resume {folder} sets it aside and flies them again\n"
    )
    status = gcs("campaign", "status", str(folder))
    assert (status.returncode, status.stderr) == (1, sentence)
    assert status.stdout.startswith("small: 3 of 6 sessions")
    resumed = gcs("campaign", "resume", str(folder), "--workers", "1", "--plain")
    assert resumed.returncode in (0, 1)
    assert sentence in resumed.stderr
    assert numbers(folder, flown) == list(range(6))
    digests = table.read(folder, flown.campaign)["digest"].to_pylist()
    assert digests[3:] == ["sha256:x"] * 3
    assert all(len(digest) == 71 for digest in digests[:3])
    assert first.with_name(f"{first.name}.broken").exists()
    again = gcs("campaign", "status", str(folder))
    assert (again.returncode, again.stderr) == (0, "")
