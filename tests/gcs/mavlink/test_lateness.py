"""Links that deliver seconds late, with clocks that the test turns; the vehicles' bytes are pymavlink's."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

from gcs.link.external_peer import ExternalPeer, PeerLink
from gcs.mavlink import codec
from gcs.mavlink.boot_clock import CLOCKS
from gcs.mavlink.services.lateness import ASK_EVERY_S, LATE_S, TIMESYNC, UNANSWERED

STEP_S = 0.1
BOOTED_S = 1000.0
"""By its own clock the vehicle is so much older than the session."""


class Air:
    """A vehicle that reports its place ten times a second and answers TIMESYNC, over links with delays of their own;
    what comes is judged as `ExternalLink` does."""

    def __init__(self, links: int = 1, *, answers: bool = True) -> None:
        made: list[Any] = [PeerLink(None, f"udpin:127.0.0.1:{k}") for k in range(links)]  # type: ignore[arg-type]
        for link in made:
            link.address = ("127.0.0.1", 1)
        self.peer = ExternalPeer((1, 1), made, made[0])
        self.delay_s: list[Callable[[float], float]] = [lambda _: 0.05] * links
        self.vehicle = mav.MAVLink(None, srcSystem=1, srcComponent=1)
        self.answers, self.stood_s, self.is_off = answers, 0.0, False
        self.now_s, self.asked = 0.0, 0
        self.taken: list[float] = []
        """how old each place was that was taken"""
        self.said: list[str] = []
        self._down: list[deque[tuple[float, float, bytes]]] = [deque() for _ in range(links)]
        self._up: list[deque[tuple[float, int]]] = [deque() for _ in range(links)]

    def run(self, until_s: float) -> None:
        while self.now_s < until_s - 1e-9:
            self.now_s = round(self.now_s + STEP_S, 3)
            boot_ms = round(1e3 * (self.now_s + BOOTED_S - self.stood_s))
            place = bytes(mav.MAVLink_local_position_ned_message(boot_ms, 1, 2, 3, 0, 0, 0).pack(self.vehicle))
            for k, link in enumerate(self.peer.links):
                delay_s = self.delay_s[k](self.now_s)
                if not self.is_off:
                    self._down[k].append((self.now_s + delay_s, self.now_s, place))
                if (question := link.trips.ask(self.now_s)) is not None:
                    self.asked += 1
                    self._up[k].append((self.now_s + delay_s, question.values[1]))
                if self.is_off:
                    self._up[k].clear()
                while self.answers and self._up[k] and self._up[k][0][0] <= self.now_s:
                    stamp = self._up[k].popleft()[1]
                    answer = mav.MAVLink_timesync_message(1000 * boot_ms, stamp).pack(self.vehicle)
                    self._down[k].append((self.now_s + delay_s, self.now_s, bytes(answer)))
                while self._down[k] and self._down[k][0][0] <= self.now_s:
                    self._arrive(link, *self._down[k].popleft()[1:])

    def _arrive(self, link: PeerLink, sent_s: float, raw: bytes) -> None:
        (frame,) = codec.split(raw).frames
        text = self.peer.answered(link, frame, self.now_s) if frame.msgid == TIMESYNC else ""
        if frame.msgid in CLOCKS:
            boot_s = codec.fields(frame).time_boot_ms / 1e3
            text = self.peer.judge(link, frame.msgid, boot_s, self.now_s, self.now_s)
            if not link.late_s:
                link.received_s = self.now_s
                self.peer.clock.feed(frame.msgid, boot_s, self.now_s)
                self.taken.append(self.now_s - sent_s)
        self.said += [text] if text else []


def test_a_link_that_holds_everything_back_for_seconds_is_said_once_and_not_taken_until_it_is_in_time() -> None:
    air = Air()
    air.delay_s[0] = lambda now_s: 5.0 if 20.0 <= now_s < 80.0 else 0.05
    air.run(70.0)
    assert max(air.taken) <= LATE_S + STEP_S
    (said,) = air.said
    assert said.startswith("Delivers 4.9 s late over udpin:127.0.0.1:0")
    air.run(100.0)
    assert air.said[1:] == ["Delivers in time again over udpin:127.0.0.1:0"]
    assert max(air.taken) <= LATE_S + STEP_S
    assert air.taken[-1] == pytest.approx(0.1)


def test_a_link_that_is_late_from_the_first_message_on_is_as_late_as_its_round_trip() -> None:
    air = Air()
    air.delay_s[0] = lambda _: 4.0
    air.run(60.0)
    assert len(air.said) == 1
    taken = len(air.taken)
    air.run(80.0)
    assert len(air.taken) == taken


def test_a_simulation_that_stood_still_is_in_time_as_soon_as_its_answers_are() -> None:
    air = Air()
    air.run(20.0)
    air.stood_s = 6.0  # its clock has lost so much at once; its answers come as quickly as before
    taken = len(air.taken)
    air.run(22.0)
    assert (air.said, len(air.taken)) == ([], taken + 20)


def test_a_vehicle_that_boots_anew_is_in_time_though_it_left_questions_open() -> None:
    air = Air()
    air.run(20.0)
    air.is_off = True
    air.run(23.0)
    air.is_off, air.stood_s, taken = False, BOOTED_S + 22.0, len(air.taken)
    air.run(26.0)
    assert (air.said, len(air.taken)) == ([], taken + 29)  # the last one is on its way
    assert air.peer.clock.offset_s == pytest.approx(22.05, abs=STEP_S)


@pytest.mark.parametrize("answers", [True, False])
def test_a_vehicle_that_boots_anew_is_in_time_over_both_of_its_links(answers: bool) -> None:
    """Its HEARTBEATs show both links before either brings a time of the new boot."""
    air = Air(2, answers=answers)
    air.run(20.0)
    air.is_off = True
    air.run(23.0)
    air.is_off, air.stood_s, taken = False, BOOTED_S + 22.0, len(air.taken)
    for link in air.peer.links:
        link.received_s = 23.0
    air.run(26.0)
    assert (air.said, len(air.taken)) == ([], taken + 2 * 29)
    assert air.peer.clock.offset_s == pytest.approx(22.05, abs=STEP_S)


def test_without_timesync_a_single_link_is_believed_as_it_comes() -> None:
    air = Air(answers=False)
    air.delay_s[0] = lambda now_s: 5.0 if now_s >= 20.0 else 0.05
    air.run(60.0)
    assert air.said == []
    assert air.asked == UNANSWERED


def test_of_two_links_the_late_one_is_left_out_even_without_timesync() -> None:
    """mavlink-router 457: two modems, one of them up to ten seconds late."""
    air = Air(2, answers=False)
    air.delay_s[1] = lambda now_s: 10.0 if now_s >= 20.0 else 0.05
    air.run(60.0)
    assert max(air.taken) <= LATE_S + STEP_S
    assert len(air.said) == 1
    assert "9.9 s late over udpin:127.0.0.1:1" in air.said[0]


def test_a_question_goes_out_once_a_second_and_strangers_answers_do_not_count() -> None:
    air = Air()
    air.run(10.0)
    assert air.asked == pytest.approx(10.0 / ASK_EVERY_S, abs=1)
    trips = air.peer.links[0].trips
    before_s = trips.last_s
    for message in (mav.MAVLink_timesync_message(0, 5), mav.MAVLink_timesync_message(7, 5)):
        (frame,) = codec.split(bytes(message.pack(air.vehicle))).frames
        trips.receive(frame, 500.0)
    assert trips.last_s == before_s
