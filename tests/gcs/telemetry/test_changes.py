"""Changes of mode, failsafes and silence, read off snapshots."""

import math
from typing import Any

import pytest
from changing import ChangingFleet
from hypothesis import given, settings
from hypothesis import strategies as st
from views import snapshot, view

from gcs.mavlink.autopilots import FlightMode
from gcs.telemetry.changes import REGULAR_S, ChangeDetector
from gcs.telemetry.state import STALE_S

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
    assert told(before, after, {}) == [(kind, level, f"{before.capitalize()} -> {after.capitalize()}")]


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
    assert told(OFFBOARD, LAND, None) == [("mode", "info", "Offboard -> Land")]


def test_one_on_the_ground_flies_no_failsafe() -> None:
    assert [event[0] for event in told(OFFBOARD, LAND, {}, armed=False)] == ["mode"]


def heard(*times_s: tuple[float, float, float]) -> list[str]:
    """Events of a vehicle looked at each time, whose last message and last position came so long ago."""
    watch = ChangeDetector()
    events = []
    for now_s, silent_s, age_s in times_s:
        one = view(age_s=age_s, last_received_s=now_s - silent_s, last_message_s=now_s - silent_s)
        events += watch.look(snapshot(one, time_s=now_s), {})
    assert {event.kind for event in events} <= {"link"}
    return [event.text for event in events]


def test_silence_and_its_end_are_told_once() -> None:
    times = [(0.0, 0.0, 0.0), (1.6, 1.6, 1.6), (3.0, 3.0, 3.0), (4.0, 0.0, 0.0), (10.0, 0.0, 0.0)]
    assert heard(*times) == ["No telemetry for 1.6 s", "Heard again"]


def test_of_a_vehicle_without_a_place_silence_is_told_too() -> None:
    assert heard((0.0, 0.0, math.inf), (1.6, 1.6, math.inf)) == ["No telemetry for 1.6 s"]


def test_positions_that_stop_are_told_apart_from_silence_and_so_are_those_that_come_again() -> None:
    late, again = "No position for 1.6 s, though it is heard", "Its positions come again"
    assert heard((0.0, 0.0, 0.0), (1.6, 0.1, 1.6), (4.0, 0.1, 4.0)) == [late]
    assert heard((1.6, 0.1, 1.6), (2.0, 0.1, 0.1), (1.6 + REGULAR_S, 0.1, 0.1), (9.0, 0.1, 0.1)) == [late, again]
    assert heard((1.6, 0.1, 1.6), (5.0, 3.5, 5.0), (6.0, 0.0, 6.0)) == [late, "No telemetry for 3.5 s", "Heard again"]
    assert heard((2.0, 2.0, 2.0), (3.0, 0.0, 1.6)) == ["No telemetry for 2.0 s", "Heard again", late]


@settings(max_examples=25)
@given(st.floats(0.02, 8.0), st.floats(0.02, 8.0))
def test_for_any_two_periods_each_fact_is_what_its_own_clock_says(message_s: float, place_s: float) -> None:
    """Messages come each `message_s`, positions among them each `place_s` or at the next one."""
    watch, texts, now_s = ChangeDetector(), set[str](), 0.0
    longest_silent_s = longest_old_s = 0.0
    for _ in range(400):
        now_s += 0.1
        last_s = now_s // message_s * message_s
        of_place_s = math.ceil(last_s // place_s * place_s / message_s) * message_s
        of_place_s = min(of_place_s, last_s)
        one = view(age_s=now_s - of_place_s, last_received_s=last_s, last_message_s=last_s)
        old = now_s - of_place_s > STALE_S
        silent = now_s - last_s > STALE_S
        longest_silent_s = max(longest_silent_s, now_s - last_s)
        longest_old_s = max(longest_old_s, now_s - of_place_s if not silent else 0.0)
        for event in watch.look(snapshot(one, time_s=now_s), {}):
            words = event.text.split(" for ")[0]
            texts.add(words)
            assert silent or words != "No telemetry"
            assert not silent or words != "Heard again"
            assert old or words != "No position"
            assert not old or words != "Its positions come again"
    assert ("No telemetry" in texts) == (longest_silent_s > STALE_S)
    assert ("No position" in texts) == (longest_old_s > STALE_S)


def test_an_uncertain_place_is_told_with_its_reason_and_so_is_that_it_is_certain() -> None:
    watch = ChangeDetector()
    reasons = ["", "no height", "no height", "it has booted", "", ""]
    events = [event for reason in reasons for event in watch.look(snapshot(view(uncertain=reason)), {})]
    assert [(event.level, event.text) for event in events] == [
        ("warning", "Its position is uncertain: no height"),
        ("warning", "Its position is uncertain: it has booted"),
        ("info", "Its position is certain now"),
    ]


def test_the_dead_are_not_silent() -> None:
    assert ChangeDetector().look(snapshot(view(age_s=5.0, last_message_s=95.0, alive=False)), {}) == []


def test_events_are_the_same_as_when_each_vehicle_is_looked_at_in_every_tick() -> None:
    fleet, some, every = ChangingFleet((1, 2, 5, 101), seed=3), ChangeDetector(), ChangeDetector()
    kinds: set[str] = set()
    for tick in range(2000):
        ordered = None if tick % 1000 < 100 else {2: "return", 5: "hold"} if tick % 200 < 100 else {}
        telling, plain = fleet.tick()
        events = some.look(telling, ordered)  # type: ignore[arg-type]
        assert events == every.look(plain, ordered)  # type: ignore[arg-type]
        kinds |= {event.text.split()[0] if event.kind == "link" else event.kind for event in events}
    assert kinds == {"mode", "failsafe", "No", "Heard", "Is", "Its"}
