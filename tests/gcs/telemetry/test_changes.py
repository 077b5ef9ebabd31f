"""Changes of mode, failsafes and silence, read off snapshots."""

from typing import Any

import pytest
from views import snapshot, view

from gcs.mavlink.autopilots import FlightMode
from gcs.telemetry.changes import ChangeDetector

OFFBOARD, HOLD, RETURN, LAND = FlightMode.OFFBOARD, FlightMode.HOLD, FlightMode.RETURN, FlightMode.LAND


def told(before: FlightMode, after: FlightMode, ordered: Any, **changed: Any) -> list[tuple[str, str, str]]:
    watch = ChangeDetector()
    assert watch.look(snapshot(view(mode=before)), ordered) == []
    events = watch.look(snapshot(view(mode=after, **changed)), ordered)
    assert watch.look(snapshot(view(mode=after, **changed)), ordered) == []
    return [(event.kind, event.level, event.text) for event in events]


@pytest.mark.parametrize(
    ("before", "after", "kind", "level"),
    [
        (FlightMode.TAKEOFF, OFFBOARD, "mode", "info"),
        (FlightMode.TAKEOFF, HOLD, "mode", "info"),
        (OFFBOARD, HOLD, "failsafe", "warning"),
        (FlightMode.REFUEL, HOLD, "failsafe", "warning"),
        (OFFBOARD, RETURN, "failsafe", "critical"),
        (HOLD, LAND, "failsafe", "critical"),
        (RETURN, LAND, "mode", "info"),
        (LAND, HOLD, "mode", "info"),
    ],
)
def test_who_leaves_the_plan_by_itself_flies_a_failsafe(before: Any, after: Any, kind: str, level: str) -> None:
    assert told(before, after, {}) == [(kind, level, f"{before} -> {after}")]


@pytest.mark.parametrize(
    ("order", "after", "kind"),
    [
        ("hold", HOLD, "mode"),
        ("return", RETURN, "mode"),
        ("return", LAND, "mode"),
        ("hold", LAND, "failsafe"),
        (None, HOLD, "failsafe"),
    ],
)
def test_what_was_ordered_is_no_failsafe(order: Any, after: FlightMode, kind: str) -> None:
    ordered = {} if order is None else {3: order}
    assert [event[0] for event in told(OFFBOARD, after, ordered)] == [kind]


def test_who_does_not_know_the_orders_tells_of_modes_only() -> None:
    assert told(OFFBOARD, LAND, None) == [("mode", "info", "offboard -> land")]


def test_one_on_the_ground_flies_no_failsafe() -> None:
    assert [event[0] for event in told(OFFBOARD, LAND, {}, armed=False)] == ["mode"]


def test_silence_and_its_end_are_told_once() -> None:
    watch = ChangeDetector()
    ages = [0.0, 1.6, 3.0, 0.0, 0.0]
    events = [event for age_s in ages for event in watch.look(snapshot(view(age_s=age_s)), {})]
    assert [(event.kind, event.text) for event in events] == [("link", "No word for 1.6 s"), ("link", "Heard again")]


def test_the_dead_are_not_silent() -> None:
    assert ChangeDetector().look(snapshot(view(age_s=5.0, alive=False)), {}) == []
