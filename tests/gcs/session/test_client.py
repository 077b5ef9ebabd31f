"""What was told before a client came, shown once, over real sockets."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any

from gcs.session.client import GONE_S, RETRY_S, EarlierEvents, SessionSource
from gcs.session.server import BACKLOG_BYTES, REMEMBERED, Publisher


def told(messages: list[Any]) -> list[int]:
    return [event["n"] for message in messages if message["type"] == "snapshot" for event in message["events"]]


def snapshot(*numbers: int, padding: str = "") -> dict[str, Any]:
    return {"type": "snapshot", "events": [{"n": n} for n in numbers], "padding": padding}


def test_who_comes_late_and_is_dropped_and_comes_again_sees_every_event_once(tmp_path: Path) -> None:
    now_s = 0.0
    publisher = Publisher(tmp_path, {"type": "session"})
    source = SessionSource(tmp_path, clock=lambda: now_s)
    publisher.publish(snapshot(0, 1))
    source.receive()
    publisher.poll()
    publisher.publish(snapshot(2))
    assert told(source.receive()) == [0, 1, 2]
    for n in itertools.count(3):  # it does not read
        publisher.publish(snapshot(n, padding="x" * (BACKLOG_BYTES // 20)))
        if not publisher.clients:
            break
    seen: list[int] = []
    while source.connected:
        seen += told(source.receive())
    now_s += 2 * RETRY_S
    source.receive()
    publisher.poll()
    publisher.publish(snapshot(n + 1))
    assert seen + told(source.receive()) == list(range(3, n + 2))
    source.close()
    publisher.close()


def test_a_session_that_has_gone_without_a_word_ends_with_a_sentence(tmp_path: Path) -> None:
    now_s = 0.0
    publisher = Publisher(tmp_path, {"type": "session"})
    source = SessionSource(tmp_path, clock=lambda: now_s)
    source.receive()
    publisher.poll()
    publisher.close()
    source.receive()
    now_s += RETRY_S
    assert source.receive() == []
    now_s += GONE_S
    (end,) = source.receive()
    assert (end["type"], end["outcome"], end["exit"]) == ("end", None, None)
    assert "without a last word" in end["text"]
    assert source.receive() == []


def test_another_session_in_the_same_place_is_shown_from_its_start() -> None:
    earlier = EarlierEvents()
    first: dict[str, Any] = {"type": "session", "events": [{"n": n} for n in range(5)], "told": 5}
    other: dict[str, Any] = {"type": "session", "events": [{"n": 90}], "told": 1}
    assert told(earlier.joined([first, snapshot(5), other, snapshot(91)])) == [0, 1, 2, 3, 4, 5, 90, 91]


def test_events_that_a_session_no_longer_keeps_are_counted_and_a_session_that_sends_none_is_no_trouble() -> None:
    kept = [{"n": n, "t_s": 0.1 * n} for n in range(REMEMBERED)]
    some: dict[str, Any] = {"type": "session", "events": kept, "told": 10 * REMEMBERED}
    ((_, shown),) = [(m, m["events"]) for m in EarlierEvents().joined([some, snapshot()]) if m["type"] == "snapshot"]
    assert shown[1:] == kept
    assert shown[0]["text"].startswith(f"{9 * REMEMBERED} earlier events are not shown here")
    assert told(EarlierEvents().joined([{"type": "session"}, snapshot(7), snapshot()])) == [7]
