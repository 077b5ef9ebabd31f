"""A snapshot's columns against its views, which are made one by one in Python; and what it tells of changes."""

import random

import numpy as np

from gcs.mavlink.codec import Frame
from gcs.telemetry.columns import FleetColumns
from gcs.telemetry.fleet import Fleet, GlobalOrigin
from gcs.telemetry.state import FleetSnapshot, VehicleView
from gcs.telemetry.track import Member
from tests.gcs.telemetry.test_fleet import DEG_E7, battery, counter, frame, heartbeat, parameter, position

ORIGIN = GlobalOrigin(47.397742, 8.545594, 488.0)
FIGURES = {
    "last_received_s", "p_ned", "p_local_ned", "v_ned", "age_s", "heading_rad", "roll_rad", "pitch_rad", "capacity_j",
    "initial_j", "drawn_j", "power_w", "control_effort", "effort_age_s", "given_reported_s", "received_reported_s",
    "last_message_s", "way_m",
}  # fmt: skip


def origin(sysid: int, lat: int, lon: int) -> Frame:
    return frame("GPS_GLOBAL_ORIGIN", sysid=sysid, latitude=lat, longitude=lon, altitude=DEG_E7[2])


def said(chance: random.Random, now_s: float) -> Frame:
    """Something that a vehicle may say, now and then what cannot be."""
    sysid, t_ms = chance.choice((3, 4, 9)), round(1e3 * now_s)
    at = tuple(chance.choice((-1.0, 0.1, 2.5, -40.0)) * chance.random() for _ in range(3))
    return chance.choice(
        (
            lambda: heartbeat(chance.choice((6 << 16, 4 << 16)), chance.choice((0x81, 0x01)), sysid=sysid),
            lambda: position(t_ms, at, (0.3, -0.2, 0.1), sysid=sysid),
            lambda: position(t_ms, (9e7, 0.0, 0.0), sysid=sysid),
            lambda: origin(sysid, DEG_E7[0] + chance.randrange(900), DEG_E7[1] + chance.randrange(900)),
            lambda: frame("EXTENDED_SYS_STATE", sysid=sysid, landed_state=chance.choice((1, 2))),
            lambda: battery(energy_consumed=chance.choice((1, 40, 9_000))),
            lambda: counter("XferIn", chance.choice((0, 500)), t_ms),
            lambda: parameter("SIM_BAT_CAP_J", chance.choice((24_000.0, 900.0))),
            lambda: frame("ATTITUDE", sysid=sysid, roll=0.1, yaw=chance.random()),
        )
    )()


def told(snapshot: FleetSnapshot) -> list[tuple[object, ...]]:
    """All of each vehicle but figures."""
    unread = [
        view._replace(**dict.fromkeys(FIGURES), doubt=view.doubt.split(" would hold ")[0]) for view in snapshot.vehicles
    ]
    known = [
        (view.p_ned is None, view.last_received_s >= 0.0, view.fresh, view.remaining_j <= 0.0)
        for view in snapshot.vehicles
    ]
    return [(*one, *other) for one, other in zip(unread, known, strict=True)]


def made_of_views(snapshot: FleetSnapshot) -> FleetColumns:
    return FleetSnapshot(snapshot.time_s, snapshot.vehicles, snapshot.traffic).columns


def test_columns_are_the_views_and_tell_of_every_change_of_what_is_no_figure() -> None:
    changes = same = 0
    for seed in range(6):
        chance = random.Random(seed)
        members = [Member(sysid, "pursuer", f"p {sysid}", 24_000.0, 18_000.0, external=sysid == 9) for sysid in (9, 3)]
        fleet = Fleet(members, ORIGIN)
        fleet.join(Member(4, "tanker", "t", 24_000.0, 18_000.0, airborne=True))
        earlier: list[tuple[FleetSnapshot, tuple[VehicleView, ...]]] = []
        last = fleet.snapshot(0.0)
        for tick in range(1, 80):
            now_s = tick * chance.choice((0.1, 0.1, 0.9))
            for _ in range(chance.randrange(4)):
                fleet.ingest(said(chance, now_s), now_s)
            if chance.random() < 0.05:
                (fleet.lost if chance.random() < 0.5 else fleet.found)(3)
            snapshot = fleet.snapshot(now_s)
            if tick % 3:
                assert fleet.snapshot(now_s).vehicles == snapshot.vehicles
            else:
                earlier.append((snapshot, fleet.snapshot(now_s).vehicles))
            expected = made_of_views(fleet.snapshot(now_s))
            for block in ("row", "flags", "places", "figures"):
                actual = getattr(snapshot.columns, block)
                np.testing.assert_array_equal(actual, getattr(expected, block), err_msg=block)
            views = fleet.snapshot(now_s).vehicles
            for name in ("alive", "flying", "fresh", "v_ned", "age_s", "remaining_j"):
                told_by_views = [getattr(view, name) for view in views]
                np.testing.assert_array_equal(getattr(snapshot.columns, name), told_by_views, err_msg=name)
            for name, column in (("p_ned", snapshot.columns.p_ned), ("ground_down_m", snapshot.columns.ground_down_m)):
                unknown = [getattr(view, name) is None for view in views]
                np.testing.assert_array_equal(np.isnan(column.reshape(3, -1)[:, 0]), unknown, err_msg=name)
            assert list(snapshot.columns.sysids) == [3, 4, 9]
            before, after = told(last), told(snapshot) if tick % 3 else told(fleet.snapshot(now_s))
            moved = snapshot.columns.changed_since(last.columns.number)
            for row, sysid in enumerate(snapshot.columns.sysids):
                assert sysid in moved or before[row] == after[row], (seed, tick, row)
                changes += before[row] != after[row]
            same += not moved
            last = fleet.snapshot(now_s)
        for snapshot, views in earlier:  # made long after the vehicles have said more
            assert snapshot.vehicles == views
    assert changes > 250
    assert same > 50
    assert fleet.snapshot(last.time_s).columns.changed_since(last.columns.number) == []
    fleet.join(Member(200, "pursuer", "late", 24_000.0, 18_000.0))
    assert fleet.snapshot(last.time_s).columns.changed_since(last.columns.number) == [3, 4, 9, 200]
