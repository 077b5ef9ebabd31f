"""Lines of decisions read many at once, against what the json module reads."""

from __future__ import annotations

import json
import tempfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gcs.recording.decisions_reader import COLUMNS, DecisionLines

FLOATS = st.floats(allow_nan=False, allow_infinity=False)


def line(p_ned: list[float], sysid: int = 1, t_s: float = 0.1) -> bytes:
    point = {"kind": "set_point", "p_ned": p_ned, "sysid": sysid, "t_s": t_s, "v_ned": [0.5, -1e-7, 0.0]}
    return json.dumps(point, separators=(",", ":")).encode() + b"\n"


def numbers(text: bytes) -> list[float]:
    told = json.loads(text)
    return [*map(float, told["p_ned"]), told["sysid"], told["t_s"]]


def decision_lines(text: bytes) -> DecisionLines:
    path = Path(tempfile.mkdtemp()) / "decisions.jsonl"
    path.write_bytes(text)
    return DecisionLines(path)


def points(lines: DecisionLines) -> np.ndarray:
    return np.concatenate([np.empty((0, COLUMNS)), *(some for some, _ in lines.blocks())])


@given(st.lists(st.tuples(st.lists(FLOATS, min_size=3, max_size=3), st.integers(1, 254), FLOATS), max_size=20))
def test_every_number_is_the_one_that_json_reads_to_the_last_bit(some: list[tuple[list[float], int, float]]) -> None:
    lines = [line(*point) for point in some]
    read = decision_lines(b"".join(lines))
    expected = np.array([numbers(each) for each in lines]).reshape(-1, COLUMNS)
    assert points(read).tobytes() == expected.tobytes()
    assert list(read) == [json.loads(each) for each in lines]
    assert read.passed_over == 0


def test_what_is_no_decision_is_passed_over_and_the_others_are_read_all_the_same() -> None:
    good = line([1.0, 2.0, 3.0])
    spaced = json.dumps(json.loads(good)).encode() + b"\n"
    strange = [
        b"no json\n",
        good[:30] + b"\n",
        good.replace(b"1.0,", b"01.0,", 1),
        good.replace(b"1.0,", b'"1",', 1),
        good.replace(b"1.0,", b"NaN,", 1),
        good.replace(b"1.0,", b"1.0,1.0,", 1),
        b'{"kind":"served"}\n',
        b'{"kind":7,"t_s":1.0}\n',
        b"   \n",
    ]
    read = decision_lines(good + spaced + good.join(strange) + good)
    assert points(read).tolist() == [[1.0, 2.0, 3.0, 1.0, 0.1]] * (len(strange) + 2)
    assert (read.broken, read.cut) == (len(strange), False)


@pytest.mark.parametrize("at", [b"served", b"full", b"receiver"])
def test_bytes_that_are_no_text_cost_no_more_than_their_line(at: bytes) -> None:
    good = line([1.0, 2.0, 3.0])
    bad = b'{"kind":"served","reason":"full","receiver":2,"t_s":1.0}\n'.replace(at, b"\xad" + at[1:])
    read = decision_lines(good + bad + good)
    assert [record["kind"] for record in read] == ["set_point", "set_point"]
    assert read.broken == 1
    for _, others in read.blocks():
        assert all(isinstance(other.record(), dict) for other in others)


def test_the_line_in_which_the_file_ends_counts_where_it_is_whole() -> None:
    good = line([1.0, 2.0, 3.0])
    for text, cut in ((good + good[:-1], False), (good + good[:40], True), (good + good[:40] + b"\n", False)):
        read = decision_lines(text)
        assert len(list(read)) == 1 + (text == good + good[:-1])
        assert (read.cut, read.passed_over) == (cut, 0 if text == good + good[:-1] else 1)


def test_decisions_keep_their_order_and_others_are_told_apart_by_their_heads() -> None:
    served = b'{"energy_j":3.5,"kind":"served","receiver":2,"t_s":1}\n'
    contest = b'{"giver":"base","kind":"competition","t_s":2.5,"v":{"1":0.5}}\n'
    read = decision_lines(served + line([1.0, 2.0, 3.0]) + contest)
    assert [record["kind"] for record in read] == ["served", "set_point", "competition"]
    ((_, others),) = read.blocks(set_points=False)
    assert [(o.t_s, o.kind, o.giver) for o in others] == [(1.0, "served", None), (2.5, "competition", "base")]
    assert others[1].record() == json.loads(contest)
