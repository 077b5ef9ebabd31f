"""What adds to the distances that are kept from a vehicle whose place becomes less certain in flight."""

from typing import Any

import numpy as np
import pytest
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.telemetry.accuracy import DRIFT_M_S, LOST_M, MOST_DRIFT_M, MOST_JUMP_M, Spreads
from gcs.telemetry.fleet import Fleet, GlobalOrigin
from gcs.telemetry.health import health_issues
from gcs.telemetry.track import Member

FACTOR = 4.0
FIXED = {"fix_type": mav.GPS_FIX_TYPE_3D_FIX, "h_acc": 300, "v_acc": 400}


class Flight:
    """One external vehicle, and the distances that are added for it; it reports each 0.1 s."""

    def __init__(self, *, own_clock: bool = False) -> None:
        self.fleet = Fleet([Member(3, "pursuer", "pursuer 3", 1e5, 1e5, external=True)], GlobalOrigin(47.0, 8.0, 400.0))
        self.spreads = Spreads([0.0], FACTOR, np.array([4.0]), np.array([own_clock]))
        self.now_s = 0.0
        self.says("GPS_GLOBAL_ORIGIN", latitude=470_000_000, longitude=80_000_000, altitude=400_000)

    def says(self, kind: str, **fields: Any) -> None:
        message = getattr(mav, f"MAVLink_{kind.lower()}_message")
        empty = dict.fromkeys(message.fieldnames, 0) | fields
        if kind == "HEARTBEAT":
            empty["mavlink_version"] = 3
        (frame,) = codec.split(bytes(message(**empty).pack(mav.MAVLink(None, 3, 1)))).frames
        self.fleet.ingest(frame, self.now_s)

    def tick(self, north_m: float = 0.0, v_north_m_s: float = 0.0, *, armed: bool = True, late: bool = False) -> float:
        self.now_s = round(self.now_s + 0.1, 1)
        self.says("HEARTBEAT", type=2, autopilot=12, base_mode=0x81 if armed else 1, custom_mode=6 << 16)
        self.says("EXTENDED_SYS_STATE", landed_state=2 if armed else 1)
        t_ms = round(1e3 * self.now_s)
        self.says("LOCAL_POSITION_NED", time_boot_ms=t_ms, x=north_m, vx=v_north_m_s, z=-5.0)
        (spread_m,) = self.spreads.of(self.fleet.snapshot(self.now_s), late=late)
        return float(spread_m)

    def tick_in_silence(self, after_s: float = 0.1, *, late: bool = False) -> float:
        self.now_s = round(self.now_s + after_s, 1)
        (spread_m,) = self.spreads.of(self.fleet.snapshot(self.now_s), late=late)
        return float(spread_m)

    def issues(self) -> list[str]:
        return [issue.text for issue in health_issues(self.fleet.snapshot(self.now_s).vehicle(3), self.now_s)]


def test_the_accuracy_before_the_flight_adds_nothing_and_what_comes_on_top_of_it_counts() -> None:
    flight = Flight()
    flight.says("GPS_RAW_INT", **FIXED)
    assert flight.tick(armed=False) == 0.0
    assert flight.tick() == 0.0
    flight.says("GPS_RAW_INT", **FIXED | {"h_acc": 500})
    assert flight.tick() == pytest.approx(FACTOR * 0.3)  # 0.5² = 0.4² + 0.3²
    assert "place known to 0.3 m less" in flight.issues()
    flight.says("ESTIMATOR_STATUS", pos_horiz_accuracy=0.6, pos_vert_accuracy=0.2)
    flight.says("ESTIMATOR_STATUS", pos_horiz_accuracy=1.0, pos_vert_accuracy=0.2)
    assert flight.tick() == pytest.approx(FACTOR * 0.8)
    flight.says("ESTIMATOR_STATUS", pos_horiz_accuracy=0.6, pos_vert_accuracy=0.2)
    flight.says("GPS_RAW_INT", **FIXED)
    assert flight.tick() == 0.0


def test_a_lost_fix_counts_at_once_and_more_with_time_until_it_is_back() -> None:
    flight = Flight()
    flight.says("GPS_RAW_INT", **FIXED)
    assert flight.tick() == 0.0
    flight.says("GPS_RAW_INT", fix_type=mav.GPS_FIX_TYPE_NO_FIX)
    assert flight.tick() == pytest.approx(LOST_M + 0.1 * DRIFT_M_S)
    assert "no GPS fix" in flight.issues()
    for _ in range(200):
        flight.says("GPS_RAW_INT", fix_type=mav.GPS_FIX_TYPE_NO_FIX)
        most_m = flight.tick()
    assert most_m == MOST_DRIFT_M
    flight.says("GPS_RAW_INT", **FIXED)
    assert flight.tick() == 0.0
    assert "no GPS fix" not in flight.issues()


def test_a_vehicle_that_never_had_a_fix_flies_by_something_else() -> None:
    flight = Flight()
    flight.says("GPS_RAW_INT", fix_type=mav.GPS_FIX_TYPE_NO_GPS)
    assert flight.tick() == 0.0


def test_a_jump_counts_until_it_is_undone_and_quick_flight_is_none() -> None:
    flight = Flight()
    at_m, v_m_s = 0.0, 0.0
    for k in range(60):  # to and fro with 4 m/s²
        turned = -4.0 if k % 20 >= 10 else 4.0
        at_m, v_m_s = at_m + 0.1 * v_m_s + 0.005 * turned, v_m_s + 0.1 * turned
        assert flight.tick(at_m, v_m_s) == 0.0
    assert flight.tick(at_m + 0.1 * v_m_s + 3.0, v_m_s) == pytest.approx(3.0, abs=1e-6)
    assert flight.tick(at_m + 0.2 * v_m_s + 3.0, v_m_s) == pytest.approx(3.0, abs=1e-6)
    assert flight.tick(at_m + 0.3 * v_m_s, v_m_s) == pytest.approx(0.0, abs=1e-6)
    assert flight.tick(at_m + 9.0, v_m_s) <= MOST_JUMP_M
    assert flight.tick(at_m + 29.0, v_m_s) == MOST_JUMP_M
    assert flight.tick(at_m + 29.0, armed=False) == 0.0


def test_a_stretch_without_reports_is_no_jump() -> None:
    flight = Flight()
    flight.tick(0.0, 2.0)
    assert [flight.tick_in_silence() for _ in range(20)] == [0.0] * 20
    assert flight.tick(2.0 * 2.1 + 1.5, 2.0) == 0.0


def test_a_place_dated_by_a_clock_of_its_own_or_in_a_late_tick_has_not_jumped() -> None:
    flight = Flight(own_clock=True)
    flight.tick(0.0, 2.0)
    assert flight.tick(0.2 + 1.4, 2.0) == 0.0  # 0.5 s at 2 m/s, and JUMP_M
    assert flight.tick(0.4 + 1.4 + 1.6, 2.0) == pytest.approx(1.6, abs=1e-6)
    assert flight.tick(40.0, 2.0, late=True) == pytest.approx(1.6, abs=1e-6)


def test_after_a_stop_of_the_station_nothing_has_jumped() -> None:
    """It flies on with 5 m/s for 2.3 s. Ticks that catch up follow each other faster than it reports: the last of what
    came during the stop is dated at its beginning, until the session's time is the wall's again."""
    flight = Flight()
    assert flight.tick(0.0, 5.0) == 0.0
    assert flight.tick(11.5, 5.0, late=True) == 0.0
    assert flight.tick_in_silence(1.0, late=True) == 0.0
    assert flight.tick_in_silence(1.0, late=True) == 0.0
    assert flight.tick_in_silence(0.3) == 0.0
    assert flight.tick(12.0, 5.0) == 0.0
    assert flight.tick(12.5, 5.0) == 0.0
    assert flight.tick(13.0 + 1.0, 5.0) == pytest.approx(1.0, abs=1e-6)  # a jump is one again
