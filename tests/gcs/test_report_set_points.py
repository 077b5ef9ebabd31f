"""Set points read by compiled code, against what the json module reads."""

from __future__ import annotations

import json
import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from gcs.report import set_points

FLOATS = st.floats(allow_nan=False, allow_infinity=False)
NEAR = st.floats(-1e4, 1e4)


def line(p_ned: list[float], sysid: int = 1, t_s: float = 0.1) -> bytes:
    point = {"kind": "set_point", "p_ned": p_ned, "sysid": sysid, "t_s": t_s, "v_ned": [0.5, -1e-7, 0.0]}
    return json.dumps(point, separators=(",", ":")).encode() + b"\n"


def numbers(text: bytes) -> list[float]:
    told = json.loads(text)
    return [*map(float, told["p_ned"]), told["sysid"], told["t_s"]]


@given(st.lists(st.tuples(st.lists(FLOATS | NEAR, min_size=3, max_size=3), st.integers(1, 254), NEAR), max_size=20))
def test_every_number_is_the_one_that_json_reads_to_the_last_bit(points: list[tuple[list[float], int, float]]) -> None:
    lines = [line(*point) for point in points]
    rows, others = set_points.scan(b"".join(lines))
    assert [numbers(each) for each in lines if each not in others] == rows.tolist()
    assert [each for each in lines if each in others] == others
    signs = [[math.copysign(1.0, n) for n in numbers(each)] for each in lines if each not in others]
    assert np.array_equal(np.copysign(1.0, rows), np.reshape(signs, rows.shape))


def test_what_a_planner_plans_is_read_here_and_not_left_to_json() -> None:
    places = np.random.default_rng(1).uniform(-200.0, 200.0, size=(20_000, 3))
    rows, others = set_points.scan(b"".join(line(place) for place in places.tolist()))
    assert len(others) <= 0.01 * len(places)
    assert len(rows) + len(others) == len(places)
    assert set(map(tuple, rows[:, set_points.P_NED])) <= set(map(tuple, places))


def test_numbers_in_the_middle_between_two_floats_are_right_or_handed_back() -> None:
    middles = [2**53 + 2 * k + 1 for k in range(200)] + [(2**54 + 4 * k + 2) * 5 for k in range(200)]
    texts = [line([0.0, 0.0, 0.0]).replace(b"[0.0,0.0,0.0]", f"[{m / 1:.0f},{m},{m}.0]".encode(), 1) for m in middles]
    rows, others = set_points.scan(b"".join(texts))
    assert rows.tolist() == [numbers(each) for each in texts if each not in others]


def test_what_is_not_in_the_recorders_form_is_handed_back_as_it_is() -> None:
    good = line([1.0, 2.0, 3.0])
    spaced = json.dumps(json.loads(good)).encode() + b"\n"
    strange = [
        spaced,
        b"\n",
        b"no json\n",
        good[:30] + b"\n",
        good.replace(b"1.0,", b"01.0,", 1),
        good.replace(b"1.0,", b"1.,", 1),
        good.replace(b"1.0,", b".5,", 1),
        good.replace(b"1.0,", b"-,", 1),
        good.replace(b"1.0,", b"1e,", 1),
        good.replace(b"1.0,", b"NaN,", 1),
        good.replace(b"]}", b",1]}"),
        good[:-1] + b" \n",
        b'{"kind":"served"}\n',
        good[:-1],
    ]
    rows, others = set_points.scan(good + good.join(strange))
    assert others == strange
    assert len(rows) == len(strange)
