"""Whose stamps are new, and what that spares those who look for events."""

import numpy as np
from changing import ChangingFleet
from views import snapshot, view

from gcs.telemetry.changes import ChangeDetector
from gcs.telemetry.columns import UNSTAMPED, FleetColumns
from gcs.telemetry.stamps import StampWatch


def stamped(*stamps: int) -> FleetColumns:
    columns = snapshot(*(view(sysid=10 * (k + 1)) for k in range(len(stamps)))).columns
    return columns._replace(stamps=np.array(stamps, np.int64))


def test_all_are_new_at_first_and_then_those_with_another_stamp() -> None:
    watch = StampWatch()
    assert [watch.new(stamped(*stamps)) for stamps in ((1, 1, 1), (1, 1, 1), (1, 2, 3), (1, 2, 3), (1, 1, 3))] == [
        [10, 20, 30], [], [20, 30], [], [20],
    ]  # fmt: skip


def test_who_is_not_stamped_is_always_new() -> None:
    watch = StampWatch()
    watch.new(stamped(1, UNSTAMPED))
    assert [watch.new(stamped(1, UNSTAMPED)) for _ in range(2)] == [[20], [20]]
    assert [watch.new(stamped(1, 1)) for _ in range(2)] == [[20], []]


def test_another_fleet_is_new_as_a_whole() -> None:
    watch = StampWatch()
    watch.new(stamped(1, 1))
    assert [watch.new(stamped(1, 1, 1)) for _ in range(2)] == [[10, 20, 30], []]


def test_events_are_the_same_as_when_everybody_is_looked_at_in_every_tick() -> None:
    fleet, some, everybody = ChangingFleet((1, 2, 5, 101), seed=3), ChangeDetector(), ChangeDetector()
    kinds: set[str] = set()
    for tick in range(3000):
        ordered = None if tick % 1000 < 100 else {2: "return", 5: "hold"} if tick % 200 < 100 else {}
        skipping, all_of_them = fleet.tick()
        events = some.look(skipping, ordered)  # type: ignore[arg-type]
        assert events == everybody.look(all_of_them, ordered)  # type: ignore[arg-type]
        kinds |= {event.text.split()[0] if event.kind == "link" else event.kind for event in events}
    assert kinds == {"mode", "failsafe", "No", "Heard", "Is", "Its"}
