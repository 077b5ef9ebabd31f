"""Set points read many at once, against what the json module reads."""

from __future__ import annotations

import json

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from gcs.recording import set_points

FLOATS = st.floats(allow_nan=False, allow_infinity=False)


def line(p_ned: list[float], sysid: int = 1, t_s: float = 0.1) -> bytes:
    point = {"kind": "set_point", "p_ned": p_ned, "sysid": sysid, "t_s": t_s, "v_ned": [0.5, -1e-7, 0.0]}
    return json.dumps(point, separators=(",", ":")).encode() + b"\n"


def numbers(text: bytes) -> list[float]:
    told = json.loads(text)
    return [*map(float, told["p_ned"]), told["sysid"], told["t_s"]]


@given(st.lists(st.tuples(st.lists(FLOATS, min_size=3, max_size=3), st.integers(1, 254), FLOATS), max_size=20))
def test_every_number_is_the_one_that_json_reads_to_the_last_bit(points: list[tuple[list[float], int, float]]) -> None:
    lines = [line(*point) for point in points]
    rows, others = set_points.scan(b"".join(lines))
    assert others == []
    expected = np.array([numbers(each) for each in lines]).reshape(-1, set_points.COLUMNS)
    assert rows.tobytes() == expected.tobytes()


def test_what_is_no_set_point_is_handed_back_and_the_others_are_read_all_the_same() -> None:
    good = line([1.0, 2.0, 3.0])
    spaced = json.dumps(json.loads(good)).encode() + b"\n"
    strange = [
        spaced,
        b"no json\n",
        good[:30] + b"\n",
        good.replace(b"1.0,", b"01.0,", 1),
        good.replace(b"1.0,", b'"1",', 1),
        good.replace(b"1.0,", b"NaN,", 1),
        good.replace(b"1.0,", b"1.0,1.0,", 1),
        b'{"kind":"served"}\n',
    ]
    rows, others = set_points.scan(good + good.join(strange) + good)
    assert sorted(others) == sorted(text.strip() for text in strange)
    assert rows.tolist() == [[1.0, 2.0, 3.0, 1.0, 0.1]] * (len(strange) + 1)


def test_a_block_without_set_points_has_no_rows() -> None:
    assert set_points.scan(b"")[0].shape == (0, set_points.COLUMNS)
