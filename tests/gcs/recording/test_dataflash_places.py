"""Where a DataFlash log shows its vehicle: by the estimate that it flew by, whichever others it logged beside it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import autopilot_logs as logs
import numpy as np
import pytest
from autopilot_logs import Estimate
from numpy.typing import NDArray

from gcs.recording import tlog_reader
from gcs.recording.importing import opened

DCM, EKF2, EKF3, SIM, EXTERNAL = 0, 2, 3, 10, 11
DEGREE_M = 0.0112
"""1e-7 degrees of latitude, in which places are logged."""
Told = tuple[Sequence[Estimate], Mapping[str, int]]
WRONG = (Estimate("XKF1", 0), Estimate("XKF1", 1), Estimate("NKF1"), Estimate("NKF6"))


def told(path: Path, message: str) -> NDArray[Any]:
    with opened(path) as source:
        (chunk,) = tlog_reader.read(source.path).chunks()
    return chunk.table(message)


def check_flown(path: Path, within_m: float, every: int = 1) -> None:
    """All places are of the flight, and the speeds too, of which satellites tell every other."""
    places, flown = told(path, "LOCAL_POSITION_NED"), list(logs.moments())
    assert len(places) == len(flown)
    p_ned, v_ned = (np.column_stack([places[axis] for axis in axes]) for axes in (("x", "y", "z"), ("vx", "vy", "vz")))
    np.testing.assert_allclose(p_ned, [at.p_ned for at in flown], atol=within_m)
    np.testing.assert_allclose(v_ned[::every], [at.v_ned for at in flown][::every], atol=1e-5)
    speeds = told(path, "GLOBAL_POSITION_INT")
    if len(speeds):
        np.testing.assert_allclose(speeds["vy"][::every], [100.0 * at.v_ned[1] for at in flown][::every], atol=0.6)


PASSIVE = (Estimate("XKF1", 0), Estimate("XKF1", 1))
INDOORS = (Estimate("NKF1"), Estimate("XKF1", 0, right=True), Estimate("XKF1", 1))
BOTH = (*PASSIVE, Estimate("NKF1"), Estimate("NKF6", right=True))
FLIGHTS: dict[str, tuple[tuple[Estimate, ...], dict[str, int], dict[str, Any], float, int]] = {
    # Places are POS's and speeds the satellites', as AP_AHRS_DCM tells them; EKF2 is named and has no rows here.
    "DCM beside EKF3": (PASSIVE, {}, {"active": DCM}, DEGREE_M, 2),
    "EKF2 without rows": (PASSIVE, {}, {"active": EKF2}, DEGREE_M, 2),
    "external beside EKF3": (PASSIVE, {}, {"active": EXTERNAL}, DEGREE_M, 2),
    # As in logs/00000001.BIN of Gehtschon/autonomous-soaring; SIM2 tells its place from home, not from the origin.
    "a simulator's own": ((*WRONG, Estimate("SIM2", right=True)), {}, {"active": SIM}, DEGREE_M, 1),
    # Before 4.1 no row says which estimate is flown by, and DCM takes over from an EKF in silence.
    "DCM before 4.1": (WRONG, {}, {"active": None, "parameters": {"AHRS_EKF_TYPE": DCM}}, DEGREE_M, 2),
    "DCM long before": (WRONG, {}, {"active": None, "parameters": {"AHRS_EKF_USE": DCM}}, DEGREE_M, 2),
    "EKF2 before 4.1": (
        (Estimate("NKF1", right=True), Estimate("XKF1", 0)),
        {},
        {"active": None, "parameters": {"AHRS_EKF_TYPE": EKF2}},
        DEGREE_M,
        1,
    ),
    "EKF3 before 4.1": (
        (Estimate("XKF1", 0, right=True), Estimate("NKF1")),
        {},
        {"active": None, "parameters": {"AHRS_EKF_TYPE": EKF3}},
        DEGREE_M,
        1,
    ),
    "indoors": (INDOORS, {}, {"active": EKF3, "globe": False}, 1e-5, 1),
    "indoors before 4.1": (INDOORS, {}, {"active": None, "globe": False}, 1e-5, 1),
    # EKF2 is flown by on its second core, of which NKF6 tells; EKF3 flies along on its first.
    "two generations": (BOTH, {"XKF4": 0, "NKF4": 1}, {"active": EKF2}, 1e-5, 1),
}


@pytest.mark.parametrize("flight", FLIGHTS)
def test_places_and_speeds_are_those_of_the_estimate_that_is_flown_by(tmp_path: Path, flight: str) -> None:
    rows, cores, how, within_m, every = FLIGHTS[flight]
    path = tmp_path / "flight.BIN"
    logs.dataflash(path, estimates=lambda _: (rows, cores), **how)
    check_flown(path, within_m, every)
    assert bool(len(told(path, "GLOBAL_POSITION_INT"))) == how.get("globe", True)


def test_a_switch_of_cores_is_followed(tmp_path: Path) -> None:
    path = tmp_path / "flight.BIN"

    def estimates(k: int) -> Told:
        primary = int(k >= 40) - int(k >= 80)
        return [Estimate("XKF1", core, right=core == primary) for core in (0, 1)], {
            "XKF4": primary,
            "NKF4": 1 - primary,
        }

    logs.dataflash(path, estimates=estimates)
    check_flown(path, 1e-5)


@pytest.mark.parametrize("newer", [False, True])
def test_heights_above_the_origin_are_its_own_where_it_tells_them(tmp_path: Path, newer: bool) -> None:
    """RelOriginAlt is exact; altitude goes by the origin's."""
    path = tmp_path / "flight.BIN"
    logs.dataflash(path, active=DCM)
    if newer:
        old, new = b"TimeUS,Lat,Lng,Alt,RelAlt".ljust(31, b"\0"), b"TimeUS,Lat,Lng,Alt,RelOriginAlt"
        content = path.read_bytes()
        assert content.count(old) == 1
        path.write_bytes(content.replace(old, new))
    check_flown(path, DEGREE_M, every=2)
    down_m = set(told(path, "LOCAL_POSITION_NED")["z"].tolist())
    assert down_m == {-logs.HEIGHT_M} if newer else max(abs(one + logs.HEIGHT_M) for one in down_m) < 1e-5


def test_without_an_origin_or_a_speed_there_are_places_on_the_globe_alone(tmp_path: Path) -> None:
    """As the vehicle itself sends no LOCAL_POSITION_NED without both."""
    path = tmp_path / "flight.BIN"
    logs.dataflash(path, active=DCM, satellites=False)
    assert not len(told(path, "LOCAL_POSITION_NED"))
    assert len(told(path, "GLOBAL_POSITION_INT")) == len(list(logs.moments()))


def test_body_rates_are_the_first_gyroscopes(tmp_path: Path) -> None:
    path = tmp_path / "flight.BIN"
    logs.dataflash(path)
    attitude = told(path, "ATTITUDE")
    rates = np.column_stack([attitude[f"{axis}speed"] for axis in ("roll", "pitch", "yaw")])
    np.testing.assert_allclose(rates, np.broadcast_to(logs.RATES_RAD_S, rates.shape), rtol=1e-6)
