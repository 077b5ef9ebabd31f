"""Places that an observer shows are right, or said not to be certain; and in the end, when all has been heard, right.

Vehicles say the truth (tests/support/truthful.py), of which frames get lost, streams stop, and the order is any.
"""

from __future__ import annotations

import itertools
import math
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from truthful import ARDUPILOT, GENERIC, KINDS, PX4, TruthfulVehicle, seen_from, v10, v20

from gcs.session.observer import Observer
from gcs.telemetry.place_claims import BOOTED, CONTRADICTED, HEIGHT_UNKNOWN, JUMPED
from gcs.telemetry.state import STALE_S

HOME = (-35.363262, 149.165237, 584.1)
ELSEWHERE = (-35.361, 149.1674, 614.1)
ROUND_S = 0.5
WITHIN_M = 0.06
"""Degrees are rounded by 6 mm in either direction in each of two messages, heights by 0.5 mm, local positions to 32
bits."""
ORDERS = [(KINDS[k:] + KINDS[:k])[::way] for k in range(4) for way in (1, -1)]
"""In which each kind comes first, second, third and last, before and behind each other one."""
IDENTITIES = pytest.mark.parametrize("autopilot", [PX4, ARDUPILOT, GENERIC])


class Watched:
    """An observer that is held against the truth at each frame."""

    def __init__(self, *vehicles: TruthfulVehicle, latest_s: float = 0.0) -> None:
        """`latest_s`: by how much a frame may be late; a vehicle flies on meanwhile."""
        self.observer = Observer("monitor", "udpin:127.0.0.1:14550")
        self.vehicles = {vehicle.sysid: vehicle for vehicle in vehicles}
        self.latest_s = latest_s
        self.certain = 0

    def hear(self, vehicle: TruthfulVehicle, kind: str, t_s: float, *, late_s: float = 0.0) -> None:
        """Let a message as of `t_s` arrive; judge what is shown then."""
        frame = vehicle.beat() if kind == "HEARTBEAT" else vehicle.says(kind, t_s)
        if frame is not None:
            self.observer.receive(frame, t_s + late_s)
            self.judge(t_s + late_s)

    def judge(self, now_s: float) -> None:
        """No place is shown, unless it is uncertain or old, that is farther from the truth."""
        if self.observer.changed:  # as programs that send it on do
            self.origin = self.observer.session()["origin"]
        for view in self.observer.view(now_s).vehicles:
            assert not view.doubt
            vehicle = self.vehicles[view.sysid]
            if view.p_ned is None or view.age_s > STALE_S or view.uncertain in (BOOTED, CONTRADICTED, JUMPED):
                continue
            then_s = now_s - view.age_s
            truth = seen_from(self.origin, vehicle.place(then_s))
            if view.uncertain == HEIGHT_UNKNOWN:  # as high as it is above where it was switched on
                truth = (*truth[:2], -vehicle.above_start_m(then_s))
            else:
                assert not view.uncertain
                self.certain += 1
            within_m = WITHIN_M + self.latest_s * math.hypot(*vehicle.v_ned)
            assert math.dist(view.p_ned, truth) <= within_m, (now_s, view.sysid, view.p_ned, truth)

    def hear_all(self, order: tuple[str, ...], from_s: float) -> None:
        """Let every vehicle say everything twice, in this order; then all must be known, right and certain."""
        for again in range(2):
            t_s = from_s + again * ROUND_S
            for vehicle in self.vehicles.values():
                for kind in ("HEARTBEAT", *order):
                    self.hear(vehicle, kind, t_s)
        self.certain = 0
        self.judge(t_s)
        assert self.certain == len(self.vehicles)
        rows = self.observer.snapshot(t_s, speed=1.0, phase="flying")["vehicles"]
        assert [row["trouble"] for row in rows] == [[]] * len(rows)


def schedule(order: tuple[str, ...], rounds: int, *, once: bool) -> list[tuple[str, float]]:
    """Messages and their times: the streams begin one after the other, each two rounds behind the one before it.

    `once`: where frames lie is said twice only, as by an autopilot that says it when it changes.
    """
    said = []
    for k in range(rounds):
        for place, kind in enumerate(order):
            since = k - 2 * place
            if since >= 0 and (not once or kind in KINDS[2:] or since in (0, 6)):
                said.append((kind, k * ROUND_S))
    return said


@IDENTITIES
@pytest.mark.parametrize("order", ORDERS)
def test_in_every_order_with_any_frame_lost_each_place_is_right(autopilot: int, order: tuple[str, ...]) -> None:
    """From a start at which an ArduPilot does not know its height for 3 s."""
    said = schedule(order, 14, once=True)
    for lost in range(ORDERS.index(order) % 2 - 1, len(said), 2):  # every other one; of two orders together each
        one = TruthfulVehicle(1, autopilot, HOME, origin_in_home=(4.0, 5.0, 1.0), knows_s=3.0)
        watched = Watched(one)
        watched.hear(one, "HEARTBEAT", 0.0)
        for k, (kind, t_s) in enumerate(said):
            if k != lost:
                watched.hear(one, kind, t_s)
        watched.hear_all(order, 7.0)


@IDENTITIES
@pytest.mark.parametrize(("wire", "first"), [(v10, 1), (v20, 2)], ids=["MAVLink 1", "MAVLink 2"])
def test_streams_that_stop_and_begin_again_leave_each_place_right(autopilot: int, wire: Any, first: int) -> None:
    """Beside a vehicle whose height is known, which comes first or second."""
    for order, gone in itertools.product(ORDERS[::2], (*((kind,) for kind in KINDS), KINDS[2:])):
        one = TruthfulVehicle(1, autopilot, HOME, origin_in_home=(4.0, 5.0, 1.0), knows_s=2.0, wire=wire)
        two = TruthfulVehicle(2, PX4, ELSEWHERE, v_ned=(0.0, 1.0, 0.0), wire=wire)
        watched = Watched(one, two)
        for k in range(16):
            if k == (6 if first == 1 else 0):
                watched.hear(two, "HEARTBEAT", k * ROUND_S)
            if k == (0 if first == 1 else 2):
                watched.hear(one, "HEARTBEAT", k * ROUND_S)
            for kind in order:
                if not (kind in gone and 7 <= k < 12):
                    watched.hear(one, kind, k * ROUND_S)
                watched.hear(two, kind, k * ROUND_S)
            if k >= 9 and gone != KINDS[2:]:
                views = watched.observer.view(k * ROUND_S).vehicles
                assert [view.age_s for view in views] == [0.0, 0.0]
        watched.hear_all(order, 8.0)


@IDENTITIES
@pytest.mark.parametrize("without", [None, "GLOBAL_POSITION_INT", "LOCAL_POSITION_NED"])
@pytest.mark.parametrize("boots", [False, True], ids=["moves", "boots"])
def test_a_frame_that_begins_elsewhere_leaves_each_place_right(
    autopilot: int, without: str | None, boots: bool
) -> None:
    """The vehicle says once where it lies now, with any frame lost; in the air, at a step of its filter, or after it
    has booted, when an ArduPilot does not know its height for a while. Positions of one kind may be missing."""
    for nth, order in enumerate(ORDERS):
        said = [(kind, k * ROUND_S) for k in range(12) for kind in order if kind != without]
        said = [(kind, t_s) for kind, t_s in said if kind in KINDS[2:] or t_s in (0.0, 3.0, 5.0)]
        for lost in (-1, *range(nth % 4, len(said), 4)):  # of four orders together each
            one = TruthfulVehicle(1, autopilot, HOME, origin_in_home=(4.0, 5.0, 1.0), booted_s=-60.0)
            watched = Watched(one)
            watched.hear(one, "HEARTBEAT", 0.0)
            for k, (kind, t_s) in enumerate(said):
                if t_s == 3.0 and said[k - 1][1] < 3.0:
                    if boots:
                        one.reboot(3.0, knows_s=4.2)
                    else:
                        one.origin_in_home = (-200.0, 60.0, -20.0)
                if k != lost:
                    watched.hear(one, kind, t_s)
            watched.hear_all(order, 6.0)


@settings(max_examples=60, deadline=None)
@given(st.data())
def test_whatever_is_lost_late_or_said_twice_each_place_is_right(data: st.DataObject) -> None:
    """Frames of a kind overtake those of another by up to 0.4 s, and a copy comes later still."""
    autopilot = data.draw(st.sampled_from([PX4, ARDUPILOT, GENERIC]), "autopilot")
    sea_level = data.draw(st.booleans(), "home at sea level")
    one = TruthfulVehicle(
        1,
        autopilot,
        (*HOME[:2], 0.4) if sea_level else HOME,
        origin_in_home=data.draw(st.sampled_from([(0.0, 0.0, 0.0), (-30.0, 400.0, 12.0)]), "origin"),
        knows_s=data.draw(st.sampled_from([0.0, 2.1, 4.4]), "knows its height"),
        wire=data.draw(st.sampled_from([v10, v20]), "wire"),
    )
    two = TruthfulVehicle(2, PX4, ELSEWHERE, v_ned=(0.0, 0.0, 0.0))
    watched = Watched(one, two, latest_s=0.45)
    frames: list[tuple[float, float, TruthfulVehicle, str]] = []
    for kind in KINDS:
        every_s = data.draw(st.sampled_from([0.25, 0.5, 1.0, 3.0]), f"period of {kind}")
        late = st.lists(st.sampled_from([None, 0.0, 0.1, 0.4]), min_size=32, max_size=32)
        lates = data.draw(late, f"delays of {kind}; None: lost")
        for k, late_s in enumerate(lates):
            if late_s is not None and k * every_s < 8.0:
                frames.append((k * every_s, late_s, one, kind))
        copied = data.draw(st.sets(st.integers(0, 31), max_size=3), "said twice")
        frames += [(k * every_s, 0.45, one, kind) for k in copied if k * every_s < 8.0]
    two_s = data.draw(st.sampled_from([0.0, 3.3, 20.0]), "second vehicle from")
    frames += [(two_s + 0.5 * k, 0.0, two, kind) for k in range(8) for kind in ("HEARTBEAT", *KINDS)]
    watched.hear(one, "HEARTBEAT", 0.0)
    for t_s, late_s, vehicle, kind in sorted(frames, key=lambda each: each[0] + each[1]):
        if t_s < 8.0:
            watched.hear(vehicle, kind, t_s, late_s=late_s)
    if two_s > 8.0:
        watched.hear(two, "HEARTBEAT", 8.5)
    watched.hear_all(KINDS, 9.0)
