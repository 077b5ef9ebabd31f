"""Somebody else's code may raise, hang, or swallow what would end it."""

from __future__ import annotations

import signal
import time

import numpy as np
import pytest

from gcs.scenario.guard import Guard, Nonsense, shown


def fails() -> None:
    raise KeyError("a\nb")


def hangs() -> None:
    while True:
        try:
            time.sleep(60.0)
        except Exception:
            continue


def test_an_answer_comes_through() -> None:
    answer = Guard("planner a:B").call(1, lambda: 5)
    assert answer == 5


def test_who_raises_is_named_once_with_its_place_until_it_is_good_again() -> None:
    guard = Guard("planner a:B")
    for _ in range(3):
        assert guard.call(1, fails) is None
    (problem,) = guard.pop_faults()
    assert problem.sysid == 1
    assert problem.sentence.startswith("planner a:B raised KeyError at test_guard.py:")
    assert problem.sentence.endswith("; the vehicle is held")
    assert "\n" not in problem.sentence
    guard.call(1, lambda: 5)
    guard.call(1, fails)
    assert len(guard.pop_faults()) == 1


def test_an_answer_that_cannot_be_used_is_told_in_the_words_of_who_looked_at_it() -> None:
    def looks() -> None:
        raise Nonsense("returned a poem")

    guard = Guard("planner a:B")
    assert guard.call(1, looks) is None
    assert guard.pop_faults()[0].sentence == "planner a:B returned a poem; the vehicle is held"


def test_a_problem_with_an_address_is_the_same_problem_in_the_next_call() -> None:
    kept: list[object] = []  # each call has an object of its own, at another address

    def refuses() -> None:
        kept.append(object())
        raise ValueError(f"no good: {kept[-1]!r}")

    guard = Guard("planner a:B")
    for _ in range(3):
        guard.call(1, refuses)
    assert len({repr(one) for one in kept}) == 3
    (fault,) = guard.pop_faults()
    assert fault.problem.endswith(": no good: <object object>")


def test_an_answer_is_shown_by_its_number_or_text_or_else_by_its_type() -> None:
    numbers = [77, 2.5, float("nan"), True, np.int64(77), np.float64("nan"), np.array(77), np.True_]
    assert [shown(one) for one in numbers] == ["77", "2.5", "NaN", "True", "77", "NaN", "77", "True"]
    assert shown("two\nlines" + "x" * 99) == repr("two\nlines" + "x" * 99)[:60]
    assert [shown(one) for one in (object(), (n for n in ()), [1], np.array([1, 2]))] == [
        "object",
        "generator",
        "list",
        "ndarray",
    ]


def test_an_exit_in_a_policy_does_not_end_the_session() -> None:
    def leave() -> None:
        raise SystemExit(3)

    guard = Guard("planner a:B")
    assert guard.call(1, leave) is None
    assert guard.pop_faults()[0].problem.startswith("raised SystemExit")


def test_an_interrupt_is_the_policys_own_only_where_a_person_cannot_interrupt() -> None:
    def interrupts() -> None:
        raise KeyboardInterrupt

    guard = Guard("planner a:B")
    with pytest.raises(KeyboardInterrupt):
        guard.call(1, interrupts)
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        assert guard.call(1, interrupts) is None
    finally:
        signal.signal(signal.SIGINT, before)
    assert guard.pop_faults()[0].problem.startswith("raised KeyboardInterrupt")


def test_who_hangs_is_cut_off_and_not_asked_again_and_one_is_cut_per_tick() -> None:
    guard = Guard("planner a:B", limit_s=0.05)
    guard.begin_tick(0.1)
    assert guard.call(1, hangs) is None
    guard.begin_tick(0.1)
    assert guard.call(2, hangs) is None
    assert [problem.sysid for problem in guard.pop_faults()] == [1]
    guard.begin_tick(0.2)
    assert guard.call(1, lambda: 5) is None
    assert guard.call(3, lambda: 5) is not None


def test_a_timer_that_was_running_goes_on() -> None:
    before = signal.getitimer(signal.ITIMER_REAL)[0]
    if not before:
        pytest.skip("no timer runs in this test run")
    Guard("planner a:B").call(1, lambda: 5)
    after = signal.getitimer(signal.ITIMER_REAL)[0]
    assert 0.0 < after <= before
    assert after > before - 5.0
