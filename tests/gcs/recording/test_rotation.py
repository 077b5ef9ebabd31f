"""Recordings in several files: read as one, bounded where only some are kept, and by every reader."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gcs.recording import export, rotation, session_folder, tlog_reader
from gcs.recording.changes import ChangeFilter
from gcs.recording.decisions_reader import DecisionLines
from gcs.recording.recorder import DECISIONS, TLOG, Recorder
from gcs.recording.tables import tables
from gcs.session.replay import Replay
from gcs.supervisor.redecide import redecide

CORPUS = Path(__file__).resolve().parents[2] / "fuzz" / "corpus" / "session"
"""A session of 3 s with one vehicle."""
ROTATE = 6000


def rerecorded(folder: Path, **how: Any) -> Path:
    """The corpus's session as a recorder writes it that rotates, tick by tick."""
    shutil.copytree(CORPUS, folder)
    frames = [(t_us, frame.raw) for t_us, frame in tlog_reader.read(CORPUS / TLOG)]
    decisions = [json.loads(line) for line in (CORPUS / DECISIONS).read_text().splitlines()]
    first_us = frames[0][0]
    for name in (TLOG, DECISIONS):
        (folder / name).unlink()
    with Recorder(folder, **how) as recorder:
        for t_us in sorted({t_us for t_us, _ in frames}):
            recorder.frames(t_us, [raw for at_us, raw in frames if at_us == t_us])
            for decision in decisions:
                if round(1e6 * decision["t_s"]) == t_us - first_us:
                    recorder.decisions([decision])
            recorder.flush()
    return folder


@pytest.fixture(scope="module")
def rotated(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return rerecorded(tmp_path_factory.mktemp("rotated") / "session", rotate_bytes=ROTATE)


def exported(folder: Path, out: Path) -> dict[str, str]:
    out.mkdir()
    written = tables("csv", out)
    try:
        export.export(folder, written)
    finally:
        written.close()
    return {path.name: path.read_text(encoding="utf-8") for path in sorted(out.glob("*.csv"))}


def test_the_parts_one_behind_the_other_are_the_whole(rotated: Path) -> None:
    for name in (TLOG, DECISIONS):
        files = rotation.parts(rotated / name)
        assert len(files) >= 4
        assert b"".join(path.read_bytes() for path in files) == (CORPUS / name).read_bytes()
        assert rotation.size(rotated / name) == (CORPUS / name).stat().st_size
    pairs = zip(rotation.parts(rotated / TLOG)[:-1], rotation.parts(rotated / DECISIONS)[:-1], strict=True)
    for frames, decisions in pairs:  # full, and no more than a tick too full
        assert ROTATE <= frames.stat().st_size + decisions.stat().st_size < ROTATE + 3000


def test_every_reader_reads_them_as_one(rotated: Path, tmp_path: Path) -> None:
    whole = session_folder.read(CORPUS)
    found = session_folder.read(rotated)
    assert found.problems == whole.problems
    assert found.tables.keys() == whole.tables.keys()
    for name, table in whole.tables.items():
        assert (found.tables[name].tobytes(), found.tables[name].dtype) == (table.tobytes(), table.dtype), name
    assert found.decisions == whole.decisions
    assert np.array_equal(found.set_points, whole.set_points)
    assert list(DecisionLines(rotated / DECISIONS)) == list(DecisionLines(CORPUS / DECISIONS))
    assert exported(rotated, tmp_path / "a") == exported(CORPUS, tmp_path / "b")
    replays = Replay(rotated, block_bytes=4096), Replay(CORPUS, block_bytes=4096)
    for at_s in (0.5, 2.5, 1.5):
        seen = []
        for replay in replays:
            replay.seek(at_s)
            seen.append(replay.snapshot(speed=1.0))
        assert seen[0] == seen[1]
    assert redecide(rotated).agrees == redecide(CORPUS).agrees


def test_only_the_newest_are_kept_and_what_they_hold_is_read(tmp_path: Path) -> None:
    folder = rerecorded(tmp_path / "session", rotate_bytes=ROTATE, keep=2)
    files = rotation.parts(folder / TLOG)
    assert len(files) == 3
    assert rotation.size(folder / TLOG) + rotation.size(folder / DECISIONS) < 3 * (ROTATE + 3000)
    assert (CORPUS / TLOG).read_bytes().endswith(b"".join(path.read_bytes() for path in files))
    times = [t_us for t_us, _ in tlog_reader.read(CORPUS / TLOG)]
    kept = [t_us for t_us, _ in tlog_reader.read(folder / TLOG)]
    assert kept == times[-len(kept) :]
    found = session_folder.read(folder)
    assert found.end_s == session_folder.read(CORPUS).end_s  # of the session, though its begin is gone
    replay = Replay(folder)
    replay.seek(replay.to_s)
    assert replay.snapshot(speed=1.0)["vehicles"]


def test_a_session_that_was_killed_while_it_rotated_is_read(rotated: Path, tmp_path: Path) -> None:
    folder = tmp_path / "session"
    shutil.copytree(rotated, folder)
    for name in (TLOG, DECISIONS):
        (folder / name).unlink()
    found = session_folder.read(folder)
    assert len(found.tables["LOCAL_POSITION_NED"]) > 20
    assert found.decisions is not None


def test_another_recording_beside_it_is_no_part(tmp_path: Path) -> None:
    for name in ("flight.tlog", "flight.0001.tlog", "session.tlog", "session.1.tlog", "session.0001.tlog.bak"):
        (tmp_path / name).write_bytes(b"")
    assert rotation.parts(tmp_path / "flight.tlog") == [tmp_path / "flight.tlog"]
    assert rotation.parts(tmp_path / "session.tlog") == [tmp_path / "session.tlog"]


def point(t_s: float, north: float, v_m_s: float, sysid: int = 1) -> dict[str, Any]:
    return {"kind": "set_point", "t_s": t_s, "sysid": sysid, "p_ned": (north, 0.0, -3.0), "v_ned": (v_m_s, 0.0, 0.0)}


def test_what_the_last_set_point_foretells_is_written_once_a_second() -> None:
    changes = ChangeFilter()
    straight = [changes.is_change(point(k / 10, 0.15 * k, 1.5)) for k in range(31)]
    assert [k for k, written in enumerate(straight) if written] == [0, 10, 20, 30]
    assert changes.is_change(point(3.1, 4.65, 1.4))  # slower
    assert not changes.is_change(point(3.2, 4.79, 1.4))
    assert changes.is_change(point(3.3, 5.0, 1.4))  # elsewhere
    assert changes.is_change(point(3.3, 5.0, 1.4, sysid=2))
    assert changes.is_change({"kind": "served", "t_s": 3.4})


def test_the_digests_lines_are_the_same_whatever_is_written(tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    (tmp_path / "b").mkdir()
    with Recorder(tmp_path / "a") as whole, Recorder(tmp_path / "b", changes_only=True) as changed:
        for k in range(50):
            decision = point(k / 10, 0.15 * k, 1.5)
            assert whole.decisions([decision]) == changed.decisions([decision])
    sizes = [(tmp_path / name / DECISIONS).stat().st_size for name in ("a", "b")]
    assert sizes[1] < 0.12 * sizes[0]
