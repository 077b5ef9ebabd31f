"""Frames far from each other, against pymap3d's way over the ellipsoid, point by point."""

import math
from typing import Any

import pymap3d
import pytest

from gcs.mavlink import codec
from gcs.mavlink.common_frame import Vec3, frame_place, turned
from gcs.mavlink.setpoints import SetPoint, SetPoints
from gcs.supervisor.grants import OwnFrames
from gcs.telemetry.fleet import Fleet, GlobalOrigin
from gcs.telemetry.track import Member

COMMON = (47.397742, 8.545594, 488.0)
RADIUS_M = 6_371_000.0


def away(distance_m: float, bearing_rad: float, alt_m: float, common: tuple[float, float, float]) -> Vec3:
    """An origin so far away along the ground: latitude, longitude, altitude."""
    north, east = distance_m * math.cos(bearing_rad), distance_m * math.sin(bearing_rad)
    lat, lon, _ = pymap3d.ned2geodetic(north, east, 0.0, *common)
    return float(lat), float(lon), alt_m


def truth(local: Vec3, own: Vec3, common: tuple[float, float, float]) -> Vec3:
    """A place of the own frame in the common one: north and east in its plane, down by altitude."""
    lat, lon, alt = pymap3d.ned2geodetic(*local, *own)
    north, east, _ = pymap3d.geodetic2ned(lat, lon, common[2], *common)
    return float(north), float(east), common[2] - float(alt)


@pytest.mark.parametrize("common", [COMMON, (-33.9, 151.2, 20.0)])
@pytest.mark.parametrize("bearing_rad", [0.8, 3.9])
@pytest.mark.parametrize(("distance_m", "reach_m"), [(0.0, 300.0), (5e3, 300.0), (30e3, 100.0), (99e3, 100.0)])
def test_a_place_is_off_by_the_stated_foreshortening_and_the_curve_of_the_ground_alone(
    distance_m: float, reach_m: float, bearing_rad: float, common: tuple[float, float, float]
) -> None:
    own = away(distance_m, bearing_rad, 520.0, common)
    place = frame_place(*own, *common)
    foreshortened_m = reach_m * distance_m**2 / (2.0 * RADIUS_M**2)
    curved_m = reach_m**2 / (2.0 * RADIUS_M) + (abs(520.0 - common[2]) + 20.0) / RADIUS_M * reach_m
    worst_m = moved_only_m = 0.0
    for k in range(12):
        local = (reach_m * math.cos(k * math.pi / 6), reach_m * math.sin(k * math.pi / 6), -20.0)
        wanted = truth(local, own, common)
        found = [a + b for a, b in zip(turned(local, place.turn_rad), place.offset_ned, strict=True)]
        worst_m = max(worst_m, math.dist(found, wanted))
        moved_only_m = max(
            moved_only_m, math.dist([a + b for a, b in zip(local, place.offset_ned, strict=True)], wanted)
        )
    assert worst_m <= 1.05 * foreshortened_m + curved_m + 1e-6
    if distance_m > 20e3 and abs(math.sin(bearing_rad)) > 0.5:
        assert moved_only_m > 5.0 * worst_m  # what turning is for


def frame(name: str, **values: Any) -> codec.Frame:
    raw = codec.frame(codec.message(name, **values), 0, 3, 1)
    return codec.split(raw).frames[0]


@pytest.mark.parametrize("home_only", [False, True])
def test_a_vehicle_80_km_away_is_seen_where_it_is_and_sent_where_it_should_go(home_only: bool) -> None:
    """By GPS_GLOBAL_ORIGIN, or by HOME_POSITION with home's place in its own frame."""
    own = away(80e3, 1.2, 600.0, COMMON)
    fleet = Fleet([Member(3, "pursuer", "three", 1e5, 1e5, external=True)], GlobalOrigin(*COMMON))
    fleet.ingest(frame("HEARTBEAT", type=2, autopilot=12, base_mode=0x81, custom_mode=6 << 16, system_status=4), 0.0)
    if home_only:
        at = (30.0, -12.0, 0.0)
        lat, lon, alt = (float(x) for x in pymap3d.ned2geodetic(*at, *own))
        local = dict(zip("xyz", at, strict=True)) | {"q": [1.0, 0.0, 0.0, 0.0]}
        local |= dict.fromkeys(("approach_x", "approach_y", "approach_z"), 0.0)
        where = {"latitude": round(1e7 * lat), "longitude": round(1e7 * lon), "altitude": round(1e3 * alt)}
        fleet.ingest(frame("HOME_POSITION", **where, **local), 0.0)
    else:
        where = {"latitude": round(1e7 * own[0]), "longitude": round(1e7 * own[1]), "altitude": 600_000}
        fleet.ingest(frame("GPS_GLOBAL_ORIGIN", **where), 0.0)
    at = (60.0, 80.0, -15.0)
    motion = dict(zip(("x", "y", "z", "vx", "vy", "vz"), (*at, 3.0, 0.0, -1.0), strict=True))
    fleet.ingest(frame("LOCAL_POSITION_NED", time_boot_ms=0, **motion), 0.0)
    seen = fleet.snapshot(0.0).vehicle(3)
    assert seen.p_ned is not None
    assert seen.origin_offset_ned is not None
    assert math.dist(seen.p_ned, truth(at, own, COMMON)) < 0.05
    ahead = truth((at[0] + 3.0, at[1], at[2] - 1.0), own, COMMON)
    assert math.dist(seen.v_ned, [b - a for a, b in zip(truth(at, own, COMMON), ahead, strict=True)]) < 0.001
    point = SetPoint(3, seen.p_ned, seen.v_ned)
    placed = OwnFrames().placed(SetPoints.of([point]), fleet.snapshot(0.0).columns, 0)
    sent = codec.fields(codec.split(codec.frame(placed.message(3), 0, 255, 190)).frames[0])
    assert (sent.x, sent.y, sent.z) == pytest.approx(at, abs=0.01)  # 32 bits at 80 km are 8 mm
    assert (sent.vx, sent.vy, sent.vz) == pytest.approx((3.0, 0.0, -1.0), abs=1e-6)
