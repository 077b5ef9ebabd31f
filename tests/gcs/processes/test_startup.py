"""What is said of vehicles that are missing before a session begins, and when that ends it."""

from gcs.processes.startup import BOOTED_WITHIN_S, HELLO_WITHIN_S, SAY_AGAIN_S, Arrivals
from gcs.scenario.external import External

AT = "udpin:127.0.0.1:14550"
LABELS = {1: "pursuer 1", 2: "pursuer 2", 101: "target 101"}


def arrivals() -> Arrivals:
    block = External(connect=AT, capacity_j=1e5, found_within_s=10.0)
    return Arrivals(LABELS, {1: block, 2: block})


def test_who_is_waited_for_is_said_now_and_then_and_who_comes_at_once() -> None:
    waiting = arrivals()
    assert waiting.look({1, 2, 101}, 0.0, {}) == [
        (1, f"Waiting for pursuer 1 at {AT}"),
        (2, f"Waiting for pursuer 2 at {AT}"),
    ]
    assert waiting.look({1, 2, 101}, 1.0, {}) == []
    assert waiting.look({2}, 2.0, {}) == [(1, "pursuer 1 is there")]
    assert waiting.look({2}, SAY_AGAIN_S, {}) == [(2, f"Waiting for pursuer 2 at {AT}")]


def test_who_was_there_before_anyone_looked_is_said_too() -> None:
    waiting = arrivals()
    assert waiting.look({2, 101}, 0.0, {}) == [(1, "pursuer 1 is there"), (2, f"Waiting for pursuer 2 at {AT}")]
    assert waiting.look(set(), 0.1, {}) == [(2, "pursuer 2 is there")]
    assert arrivals().look(set(), 0.0, {}) == [(1, "pursuer 1 is there"), (2, "pursuer 2 is there")]


def test_each_has_its_own_patience() -> None:
    waiting = arrivals()
    assert waiting.too_late({1, 2, 101}, 10.0, {}, {}) is None
    why = waiting.too_late({2, 101}, 10.1, {}, {})
    assert why is not None
    assert why.startswith(f"no HEARTBEAT of pursuer 2 at {AT} within 10 s: is it switched on")
    assert waiting.too_late({101}, HELLO_WITHIN_S, {}, {}) is None
    assert (
        waiting.too_late({101}, HELLO_WITHIN_S + 0.1, {}, {}) == "no answer from target 101 within 60 s of their start"
    )
    booting = Arrivals(LABELS, {}, [1])
    assert booting.too_late({1}, BOOTED_WITHIN_S, {}, {}) is None
    assert (
        booting.too_late({1}, BOOTED_WITHIN_S + 0.1, {}, {}) == "no answer from pursuer 1 within 300 s of their start"
    )
