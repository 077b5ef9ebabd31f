"""Traffic: positions in closed form, and what is told of them."""

import math
from itertools import pairwise
from pathlib import Path
from typing import Any

import pymap3d
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pymavlink.dialects.v20 import common as mav

from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.mavlink.connection import Connection
from simvehicle.sitl.traffic import Aircraft, Traffic, TrafficError, load

SQUARE = ((0.0, 0.0, -10.0), (20.0, 0.0, -10.0), (20.0, 20.0, -10.0), (0.0, 20.0, -10.0))
ORIGIN = (47.397742, 8.545594, 488.0)


def test_closed_path_is_flown_round_and_round() -> None:
    mover = Aircraft("A", SQUARE, 4.0, True, 2.0)
    for lap in range(3):
        for time_s, p, v in (
            (2.5, (2.0, 0.0, -10.0), (4.0, 0.0, 0.0)),
            (9.5, (20.0, 10.0, -10.0), (0.0, 4.0, 0.0)),
            (14.5, (10.0, 20.0, -10.0), (-4.0, 0.0, 0.0)),
            (20.75, (0.0, 5.0, -10.0), (0.0, -4.0, 0.0)),
        ):
            at, velocity = mover.at(time_s + 20.0 * lap)
            assert at == pytest.approx(p, abs=1e-9)
            assert velocity == pytest.approx(v)


def test_open_path_is_flown_to_its_end_and_back() -> None:
    mover = Aircraft("A", ((0.0, 0.0, 0.0), (3.0, 4.0, 0.0), (3.0, 4.0, -5.0)), 1.0, False, 0.0)
    for time_s, p in (
        (2.5, (1.5, 2.0, 0.0)),
        (7.5, (3.0, 4.0, -2.5)),
        (12.5, (3.0, 4.0, -2.5)),
        (17.5, (1.5, 2.0, 0.0)),
    ):
        assert mover.at(time_s)[0] == pytest.approx(p)
    assert mover.at(2.5)[1] == pytest.approx((0.6, 0.8, 0.0))
    assert mover.at(17.5)[1] == pytest.approx((-0.6, -0.8, 0.0))


def test_mover_waits_at_its_first_point_until_its_start() -> None:
    mover = Aircraft("A", SQUARE, 4.0, True, 2.0)
    for time_s in (-1.0, 0.0, 2.0):
        assert mover.at(time_s) == (SQUARE[0], (0.0, 0.0, 0.0))


@pytest.mark.parametrize("path", [((1.0, 2.0, 3.0),), ((1.0, 2.0, 3.0), (1.0, 2.0, 3.0))])
@pytest.mark.parametrize("closed", [False, True])
def test_path_without_length_stands_still(path: Any, closed: bool) -> None:
    assert Aircraft("A", path, 4.0, closed, 0.0).at(9.0) == ((1.0, 2.0, 3.0), (0.0, 0.0, 0.0))


points = st.tuples(*[st.floats(-100.0, 100.0).map(lambda x: round(x, 6))] * 3)


@settings(max_examples=50)
@given(st.lists(points, min_size=2, max_size=6), st.floats(0.1, 30.0), st.booleans(), st.floats(0.0, 500.0))
def test_mover_moves_at_its_speed_and_never_jumps(path: Any, speed: float, closed: bool, time_s: float) -> None:
    mover = Aircraft("A", tuple(path), speed, closed, 0.0)
    (p, v), (q, _) = mover.at(time_s), mover.at(time_s + 0.01)
    assert math.dist(p, q) <= 0.01 * speed * (1.0 + 1e-6) + 1e-9
    length = sum(math.dist(a, b) for a, b in pairwise(path))
    if length > 0.0 and time_s > 0.0:
        assert math.hypot(*v) == pytest.approx(speed)


def said_by(traffic: Traffic, connection: Connection, to_ms: int) -> list[Any]:
    traffic.advance(to_ms)
    return [m for raw in connection.frames() for m in mav.MAVLink(None).parse_buffer(raw)]


def test_movers_are_told_every_100_ms_in_wgs84_with_a_heartbeat_every_second() -> None:
    frame, connection = LocalFrame(*ORIGIN), Connection(255, 156)
    movers = [
        Aircraft("BIRD1", SQUARE, 4.0, True, 0.0),
        Aircraft("BIRD2", ((0.0, 0.0, 0.0), (0.0, 0.0, -30.0)), 2.0, False, 0.0),
    ]
    traffic = Traffic(frame, movers, [connection])
    said = [said_by(traffic, connection, t) for t in range(0, 3000, 100)]
    assert sum(m.get_type() == "HEARTBEAT" for tick in said for m in tick) == 3
    for tick, messages in enumerate(said):
        told = [m for m in messages if m.get_type() == "ADSB_VEHICLE"]
        assert [m.ICAO_address for m in told] == [1, 2]
        assert [m.callsign for m in told] == ["BIRD1", "BIRD2"]
        for mover, m in zip(movers, told, strict=True):
            p, v = mover.at(0.1 * tick)
            back = frame.to_local(1e-7 * m.lat, 1e-7 * m.lon, 1e-3 * m.altitude)
            assert back == pytest.approx(p, abs=0.01)
            course = math.radians(m.heading / 100)
            assert m.hor_velocity / 100 * math.cos(course) == pytest.approx(v[0], abs=0.01)
            assert m.hor_velocity / 100 * math.sin(course) == pytest.approx(v[1], abs=0.01)
            assert -m.ver_velocity / 100 == pytest.approx(v[2], abs=0.01)
    assert {(m.get_srcSystem(), m.get_srcComponent()) for tick in said for m in tick} == {(255, 156)}


def test_longitudes_across_the_180th_meridian_stay_within_the_message() -> None:
    origin = (47.4, 179.99998, 488.0)
    connection = Connection(255, 156)
    mover = Aircraft("BIRD1", ((0.0, 20.0, -3.0), (0.0, 2.5, -3.0)), 1.0, False, 0.0)
    traffic = Traffic(LocalFrame(*origin), [mover], [connection])
    told = [m for m in said_by(traffic, connection, 0) if m.get_type() == "ADSB_VEHICLE"]
    assert -1_800_000_000 <= told[0].lon <= 1_800_000_000
    back = pymap3d.geodetic2ned(1e-7 * told[0].lat, 1e-7 * told[0].lon, 1e-3 * told[0].altitude, *origin)
    assert back == pytest.approx((0.0, 20.0, -3.0), abs=0.02)


GOOD = """
origin: {lat_deg: 47.0, lon_deg: 8.0, alt_m: 400.0}
movers:
  - {callsign: BIRD1, path_ned_m: [[0, 0, -5], [10, 0, -5]], speed_m_s: 2.0, closed: true, start_s: 1.5}
"""


def test_file_is_read(tmp_path: Path) -> None:
    path = tmp_path / "traffic.yaml"
    path.write_text(GOOD)
    frame, movers = load(path)
    assert frame == LocalFrame(47.0, 8.0, 400.0)
    assert movers == [Aircraft("BIRD1", ((0.0, 0.0, -5.0), (10.0, 0.0, -5.0)), 2.0, True, 1.5)]


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (("origin", "origen"), "'origin' is missing"),
        (("speed_m_s: 2.0, ", ""), "'speed_m_s' is missing"),
        (("speed_m_s: 2.0", "speed_m_s: .nan"), "speed_m_s of BIRD1 is nan"),
        (("speed_m_s: 2.0", "speed_m_s: -1"), "speed_m_s of BIRD1 is -1"),
        (("speed_m_s: 2.0", "speed_m_s: fast"), "could not convert"),
        (("[[0, 0, -5], [10, 0, -5]]", "[]"), "path_ned_m of BIRD1 needs points"),
        (("[10, 0, -5]", "[10, 0, .inf]"), "path_ned_m of BIRD1 needs points"),
        (("[10, 0, -5]", "[10, 0]"), "not enough values"),
        (("start_s: 1.5", "start_s: .nan"), "start_s of BIRD1"),
        (("lat_deg: 47.0", "lat_deg: 97.0"), "is no origin"),
        (("movers:", "movers: ["), "no traffic file"),
        ((GOOD, ""), "no traffic file"),
        ((GOOD, "\x00"), "no traffic file"),
    ],
)
def test_bad_file_is_named_with_one_reason(tmp_path: Path, change: tuple[str, str], said: str) -> None:
    path = tmp_path / "traffic.yaml"
    path.write_text(GOOD.replace(*change))
    with pytest.raises(TrafficError) as error:
        load(path)
    assert str(path) in str(error.value)
    assert said in str(error.value)
    assert "\n" not in str(error.value)


def test_missing_or_binary_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(TrafficError, match="No such file"):
        load(tmp_path / "none.yaml")
    (tmp_path / "binary").write_bytes(b"\xff\xfe\x00\x80" * 20)
    with pytest.raises(TrafficError, match="no traffic file"):
        load(tmp_path / "binary")
