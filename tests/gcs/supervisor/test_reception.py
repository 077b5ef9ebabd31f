"""Frames of a tick that comes late: whose belong to its own time, and whose to the wall clock's."""

from __future__ import annotations

import pytest

from gcs.link.impairment import Impairment
from gcs.mavlink import codec
from gcs.supervisor.radios import Radios
from gcs.supervisor.reception import Reception
from gcs.telemetry.fleet import Fleet, GlobalOrigin
from gcs.telemetry.track import Member

OURS, EXTERNAL = 1, 3
BEAT = {"type": 2, "autopilot": 12, "base_mode": 0, "custom_mode": 0, "system_status": 3}


@pytest.mark.parametrize("late_s", [0.0, 0.6])
def test_an_external_vehicles_frames_are_as_late_as_the_tick(late_s: float) -> None:
    members = [Member(OURS, "pursuer", "pursuer 1", 1e5, 1e5),
               Member(EXTERNAL, "pursuer", "pursuer 3", 1e5, 1e5, external=True)]  # fmt: skip
    fleet = Fleet(members, GlobalOrigin(47.0, 8.0, 500.0))
    reception = Reception(fleet, Radios(Impairment()), None, {EXTERNAL})
    raws = {sysid: codec.encode("HEARTBEAT", 0, sysid, 1, **BEAT) for sysid in (OURS, EXTERNAL)}
    answers = [([(sysid, 1)], [codec.split(raw).frames]) for sysid, raw in raws.items()]
    received = reception.receive(answers, 10.0, lambda: late_s)
    assert set(received.by_system) == {OURS, EXTERNAL}
    if late_s:
        assert (received.frames, received.late_frames) == ([raws[OURS]], [raws[EXTERNAL]])
    else:
        assert (received.frames, received.late_frames) == ([raws[OURS], raws[EXTERNAL]], [])
    assert fleet.snapshot(20.0).vehicle(EXTERNAL).silent_s(20.0) == pytest.approx(10.0 - late_s)
