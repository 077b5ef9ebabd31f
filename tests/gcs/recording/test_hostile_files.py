"""Files from elsewhere: flipped, cut, nested and endless ones cost little, and what can be read of them is."""

from __future__ import annotations

import json
import math
import re
import shutil
import struct
import tempfile
import tracemalloc
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from commands import gcs
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from sessions import Outcome, fly, small

from gcs.mavlink import codec
from gcs.recording import pursuit_held, series, session_folder, tables, tlog_reader, tlog_walk, truth
from gcs.recording.decisions_reader import DecisionLines
from gcs.recording.export import export
from gcs.scenario.file import load
from gcs.session.client import Lines
from gcs.session.timeline import Timeline

CORPUS = Path(__file__).resolve().parents[2] / "fuzz" / "corpus" / "session"

EPOCH_US = 1_767_225_600_000_000
FLIPS = (40, 55, 63)


@pytest.fixture(scope="module")
def session(tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    return fly(small(goal={"duration_s": 8.0, "refuelled_at_least": 0}), tmp_path_factory.mktemp("flown"))


@pytest.fixture
def copied(session: Outcome, tmp_path: Path) -> Path:
    return Path(shutil.copytree(session.folder, tmp_path / "copy"))


def record(t_us: int, seq: int = 0) -> bytes:
    beat = codec.encode("HEARTBEAT", seq, 1, 1, type=2, autopilot=12, base_mode=0, custom_mode=0, system_status=3)
    return t_us.to_bytes(8, "big") + beat


def times_of(path: Path) -> list[int]:
    return [t_us for t_us, _ in tlog_reader.read(path)]


@pytest.mark.parametrize("at", [0, 17, 39])
@pytest.mark.parametrize("bit", FLIPS)
def test_a_time_with_a_flipped_bit_is_the_one_before(tmp_path: Path, at: int, bit: int) -> None:
    path = tmp_path / "flipped.tlog"
    times = [EPOCH_US + 1_000_000 * k for k in range(40)]
    flipped = [t_us ^ (1 << bit if k == at else 0) for k, t_us in enumerate(times)]
    path.write_bytes(b"".join(record(t_us, k) for k, t_us in enumerate(flipped)))
    read = times_of(path)
    assert read[:at] + read[at + 1 :] == times[:at] + times[at + 1 :]
    assert read[at] == times[max(at - 1, 0)] or (at == 0 and read[0] == times[1])
    log = tlog_reader.read(path)
    assert len(list(log)) == 40
    assert log.problems == ["flipped.tlog: one frame has a time that cannot be: it has the time of the frame before."]


def test_a_recording_of_two_days_keeps_its_times(tmp_path: Path) -> None:
    path = tmp_path / "days.tlog"
    times = [EPOCH_US + day * 86_400_000_000 + 1_000_000 * k for day in (1, 3) for k in range(6)]
    path.write_bytes(b"".join(record(t_us, k) for k, t_us in enumerate(times)))
    log = tlog_reader.read(path)
    assert [t_us for t_us, _ in log] == times
    assert log.problems == ["days.tlog: nothing was recorded for 2.0 days until 172800.0 s."]


def flip_times(path: Path, seed: int) -> None:
    """One time in ten gets a random high bit flipped."""
    rng = np.random.default_rng(seed)
    data = bytearray(path.read_bytes())
    for chunk in tlog_reader.read(path).chunks():
        for at in chunk.heads[:, tlog_walk.AT].tolist():
            if rng.random() < 0.1:
                bit = int(rng.integers(36, 63))
                data[chunk.begin + at - 1 - bit // 8] ^= 1 << bit % 8
    path.write_bytes(bytes(data))


def test_flipped_times_do_not_make_a_replay_endless_or_a_report_large(copied: Path) -> None:
    flip_times(copied / "session.tlog", 7)
    played = gcs("replay", str(copied), "--json")
    assert played.returncode == 0
    assert len(played.stdout.splitlines()) < 2000
    tracemalloc.start()
    recorded = session_folder.read(copied)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 120 << 20
    assert max(map(len, recorded.traffic_count.values())) < 20_000


@pytest.mark.parametrize(
    "line",
    ['{"kind":"competition","t_s":1,"x":' + "[" * 20_000 + "]" * 20_000 + "}",
     "[" * 100_000],
)  # fmt: skip
def test_a_deeply_nested_line_is_passed_over_by_every_reader(copied: Path, line: str) -> None:
    decisions = copied / "decisions.jsonl"
    whole = decisions.read_text()
    count = sum(1 for _ in DecisionLines(decisions))
    decisions.write_text(whole + line + "\n" + whole.splitlines()[0] + "\n")
    lines = DecisionLines(decisions)
    assert sum(1 for _ in lines) == count + 1
    assert lines.broken == 1
    for command in (("report", "--out", str(copied / "page.html")), ("replay", "--json"), ("replay", "--decide")):
        told = gcs(command[0], str(copied), *command[1:])
        assert told.returncode in (0, 1), (command, told.stderr)
    assert gcs("export", str(copied), "--format", "csv").returncode == 0
    assert Lines().feed(line.encode() + b'\n{"type": "end"}\n') == [{"type": "end"}]


@pytest.fixture
def broken_truth(copied: Path) -> Iterator[Path]:
    path = copied / "vehicles" / "1.truth"
    yield path
    assert gcs("report", str(copied), "--out", str(copied / "page.html")).returncode == 0
    told = gcs("export", str(copied), "--format", "csv")
    assert (told.returncode, "1.truth" in told.stderr) == (0, True)


@pytest.mark.parametrize("steps", [math.nan, -1.0, 1e18])
def test_a_truth_whose_records_say_impossible_lengths_is_read_up_to_there(broken_truth: Path, steps: float) -> None:
    data = bytearray(broken_truth.read_bytes())
    begin = data.index(b"\n") + 1
    before = truth.read(broken_truth.parents[1], 1)
    assert before is not None
    first = begin + 8 * (18 + int(struct.unpack_from("<d", data, begin + 8)[0]))
    struct.pack_into("<d", data, first + 8, steps)
    broken_truth.write_bytes(bytes(data))
    after = truth.read(broken_truth.parents[1], 1)
    assert after is not None
    assert after.tolist() == before[:1].tolist()


IMPOSSIBLE = json.dumps({"sysid": 700, "step_s": 1, "state": [[1]], "energy": [2]}).encode()


@pytest.mark.parametrize(
    "head", [b"[" * 50_000, b'{"sysid": 1e999, "state": [], "energy": [], "step_s": 1}', IMPOSSIBLE]
)
def test_a_truth_with_an_impossible_beginning_is_left_out(broken_truth: Path, head: bytes) -> None:
    broken_truth.write_bytes(head + b"\n" + broken_truth.read_bytes().partition(b"\n")[2])


@pytest.mark.parametrize(
    "broken", [b'"v":{"":1.0}', b'"v":{"1":"x"}', b'"v":[]', b'"v":{"1":1e999}', b'"v":{"1":1},"leader":{}']
)
def test_a_broken_line_of_the_competition_shows_none(tmp_path: Path, broken: bytes) -> None:
    scenario = load(CORPUS / "scenario.yaml")
    line = b'{"kind":"competition","leader":1,"share":0.5,"t_s":1.0,"tau":{"1":0.5},' + broken + b"}\n"
    (tmp_path / "decisions.jsonl").write_bytes(line)
    timeline = Timeline(tmp_path / "decisions.jsonl", scenario)
    assert timeline._competition_at(1.0).leader is None


@pytest.mark.parametrize(
    "broken",
    [
        '"kind":"competition","leader":1,"share":0.5,"v":{"":1.0}',
        '"kind":"competition","leader":1,"share":"0.5","v":{"1":1.0}',
        '"kind":"competition","leader":1,"share":0.5,"v":{"1":1e999}',
        '"kind":"decided","receiver":1,"tanker":null,"by":"policy","bids":{}',
        '"kind":"decided","receiver":0,"tanker":201,"by":"policy","bids":{}',
        '"kind":"violation","part":"lost","at_s":[],"sysids":[1],"text":""',
        '"kind":"fault","sysid":1e9,"state":"begins","text":""',
        '"kind":"death","text":null',
    ],
)
def test_a_decision_of_the_wrong_type_is_passed_over_by_a_report(tmp_path: Path, broken: str) -> None:
    folder = Path(shutil.copytree(CORPUS, tmp_path / "copy"))
    before = session_folder.read(folder)
    with (folder / "decisions.jsonl").open("a", encoding="utf-8") as file:
        file.write(f'{{{broken},"t_s":1.0}}\n')
    recorded = session_folder.read(folder)
    assert recorded.decisions == before.decisions
    assert any("1 line that is no decision" in problem for problem in recorded.problems)
    series.competition(recorded)


_KINDS_OF_LINES = st.sampled_from(
    ("set_point", "competition", "served", "decided", "of another day", "../up", "k" * 99)
)
_NAMES = st.sampled_from(
    ("sysid", "p_ned", "v_ned", "time_s", "n_ned_m", "receiver", "tanker", "v", "tau", "share", "x")
)
_IDS = st.sampled_from(("1", "7", "254", "999", "-1", "\u00b2", "9" * 30, "9" * 5000, "one"))
_SCALARS = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(),
    st.sampled_from((2**63 - 1, 2**63, -(2**63) - 1, 2**64, 10**19, 99999999999999999999, 10**400)),
    st.floats(allow_nan=False, allow_infinity=False),
    st.text(st.characters(exclude_categories=["Cs"]), max_size=5),
)
_VALUES = st.recursive(
    _SCALARS, lambda each: st.lists(each, max_size=4) | st.dictionaries(_IDS, each, max_size=3), max_leaves=6
)
_LINES = st.lists(
    st.tuples(_KINDS_OF_LINES, st.one_of(st.integers(0, 9), _SCALARS), st.dictionaries(_NAMES, _VALUES)), max_size=6
)


@pytest.mark.parametrize("form", ["csv", "parquet"])
@settings(max_examples=40, suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(lines=_LINES)
def test_decisions_that_hold_anything_are_tables_or_passed_over(
    form: tables.Format, lines: list[Any], tmp_path: Path
) -> None:
    with tempfile.TemporaryDirectory(dir=tmp_path) as place:
        (Path(place) / "out").mkdir()
        content = "".join(json.dumps({"kind": kind, "t_s": t_s, **rest}) + "\n" for kind, t_s, rest in lines)
        (Path(place) / "decisions.jsonl").write_text(content, encoding="utf-8")
        written = tables.tables(form, Path(place) / "out")
        try:
            problems = export(Path(place), written)
        finally:
            written.close()
        rows = sum(n for name, n in written.rows.items() if not name.endswith("_by_vehicle"))
        said = re.search(r"(\d+) lines? (?:is|are) no decision", " ".join(problems))
        assert rows + int(said[1] if said else 0) == len(lines)


def test_a_recording_of_a_week_by_254_vehicles_costs_memory_by_its_frames(tmp_path: Path) -> None:
    """350,000 frames, one each 1.7 s from one vehicle after the other: a table by seconds would hold 300 million."""
    count, period_us, vehicles = 350_000, 1_700_000, 254
    beats = [
        [codec.encode("HEARTBEAT", n, sysid, 1, type=2, autopilot=12, base_mode=0, custom_mode=0, system_status=3)
         for n in range(256)] for sysid in range(1, vehicles + 1)
    ]  # fmt: skip
    times_us = EPOCH_US + period_us * np.arange(count)
    frames = (
        t_us.to_bytes(8, "big") + beats[k % vehicles][k // vehicles % 256] for k, t_us in enumerate(times_us.tolist())
    )
    (tmp_path / "session.tlog").write_bytes(b"".join(frames))
    session_folder.read(CORPUS)  # loads and compiles
    tracemalloc.start()
    try:
        recorded = session_folder.read(tmp_path)
        links = series.links(recorded, {})
        _, most_bytes = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert most_bytes < 250e6
    assert recorded.traffic_bin_s == 64
    own_s = 1e-6 * period_us * np.arange(count)
    bins = np.arange(len(links[1].rate_hz.t_s) + 1) * 64.0
    for sysid, link in links.items():
        expected, _ = np.histogram(own_s[sysid - 1 :: vehicles], bins)
        np.testing.assert_allclose(link.rate_hz.values * 64.0, expected)
        assert link.rate_hz.t_s[0] == 32.0
        assert not link.lost.values.any()


@given(st.floats(0.0, 604_800.0), st.integers(0, 254))
@settings(deadline=None, max_examples=40)
def test_ticks_that_are_looked_at_are_all_or_every_few(end_s: float, vehicles: int) -> None:
    t_s = pursuit_held.ticks_of(session_folder.Recorded(Path(), end_s=end_s), vehicles)
    whole = math.floor(end_s / 0.1 + pursuit_held.ROUNDING_S)
    assert len(t_s) * vehicles <= pursuit_held.MOST_PLACES
    if whole * vehicles <= pursuit_held.MOST_PLACES:
        np.testing.assert_array_equal(t_s, 0.1 * np.arange(1, whole + 1))
    else:
        assert len(t_s) * vehicles > 0.4 * pursuit_held.MOST_PLACES
        np.testing.assert_allclose(np.diff(t_s), t_s[0])
