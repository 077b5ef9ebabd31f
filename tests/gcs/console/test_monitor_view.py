"""A monitor's state for people: as lines of text, and in the console."""

from __future__ import annotations

from typing import Any

import pytest
from feed import Fed, session, snapshot
from pilots import Shown, drive
from pymavlink import mavutil

from gcs.console.follow import Steps, follow
from gcs.scenario.endpoint import Endpoint
from gcs.session.monitor import MonitorSource

WATCHED = session(source="monitor", control=False, goal={}, vehicles=[])
WIDE = (140, 40)


def written(*messages: dict[str, Any], changes_only: bool) -> list[str]:
    """Lines of text of snapshots that come every half second."""
    lines: list[str] = []
    source, clock, left = Fed(), Steps(), list(messages)

    def wait() -> None:
        clock.go_on()
        source.feed(left.pop(0))

    follow(
        source, lines.append, as_json=False, changes_only=changes_only, clock=clock, wait=wait, over=lambda: not left
    )
    return lines


@pytest.mark.parametrize(("changes_only", "times"), [(True, [0.5, 10.0]), (False, [0.5, 2.5, 4.5, 6.5, 8.5, 10.5])])
def test_a_line_of_progress_that_says_nothing_new_is_left_out_of_a_monitor(
    changes_only: bool, times: list[float]
) -> None:
    still = snapshot(0.0, phase="monitoring", events=[])
    disarmed = still | {"vehicles": [row | {"armed": False} for row in still["vehicles"]]}
    told = [(disarmed if k >= 20 else still) | {"t_s": 0.5 * k} for k in range(1, 22)]
    lines = written(*told, told[-1], changes_only=changes_only)
    assert [float(line.split()[0]) for line in lines] == times
    assert "| monitoring |" in lines[0]
    assert "7 disarmed" in lines[-1]


def test_a_monitor_says_that_it_monitors() -> None:
    source = MonitorSource(Endpoint("udpin", "127.0.0.1", 0))
    vehicle = mavutil.mavlink_connection(f"udpout:127.0.0.1:{source.port}", source_system=3)
    lines: list[str] = []
    try:
        vehicle.mav.heartbeat_send(2, 12, 0x01, 0, 4)
        follow(source, lines.append, as_json=False, changes_only=True, over=lambda: bool(lines))
    finally:
        vehicle.close()
        source.close()
    assert any("| monitoring | " in line for line in lines)


def test_a_monitor_has_no_pane_for_a_competition_and_starts_no_vehicles() -> None:
    async def steps(shown: Shown) -> None:
        assert "─ competition" not in shown.text()
        assert "no vehicle yet" in shown.lines()[2]
        assert "monitoring" in shown.lines()[0]
        await shown.feed(session())
        assert "─ competition" in shown.text()

    drive(steps, [WATCHED, snapshot(3.0, phase="monitoring", vehicles=[])], size=WIDE)
