"""Lines to pages: late ones catch up, slow ones miss snapshots only, and who may not command is told so."""

from __future__ import annotations

import itertools
import json
import tracemalloc
from typing import Any

from gcs.web.hub import MOST_WAITING, PIECE_BYTES, READ_ONLY, Hub, PageListener

SESSION = {"type": "session", "name": "one", "control": True}


def snapshot(t_s: float, *texts: str, size: int = 0) -> dict[str, Any]:
    events = [{"t_s": t_s, "sysid": 0, "level": "info", "text": text, "kind": "text"} for text in texts]
    return {"type": "snapshot", "t_s": t_s, "events": events, "inspected": {}, "vehicles": "x" * size}


def told(listener: PageListener) -> list[Any]:
    """Everything that waits for a page; the past as one list."""
    lines = []
    while (line := listener.take()) is not None:
        lines.append(json.loads(line))
    return lines


def joined(hub: Hub, commands: bool = True) -> PageListener:
    return hub.join(commands, lambda: None)


def test_a_late_page_is_told_session_events_past_and_newest_in_that_order() -> None:
    hub = Hub()
    hub.take([SESSION, snapshot(0.0, "begins"), snapshot(0.1), snapshot(0.6, "goes on"), snapshot(0.7)])
    session, past, newest = told(joined(hub))
    assert (session["type"], session["told"], [e["text"] for e in session["events"]]) == (
        "session",
        2,
        ["begins", "goes on"],
    )
    assert [(line["t_s"], line["events"]) for line in past] == [(0.0, []), (0.6, [])], "every half second, events apart"
    assert (newest["t_s"], newest["events"]) == (0.7, [])


def test_a_slow_page_misses_snapshots_but_no_event_and_not_the_end() -> None:
    hub = Hub()
    listener = joined(hub)
    hub.take([SESSION, *(snapshot(0.1 * k, *(["told"] if k == 50 else [])) for k in range(100)), {"type": "end"}])
    lines = told(listener)
    assert [line["type"] for line in lines] == ["session", "snapshot", "snapshot", "snapshot", "end"]
    assert [line["t_s"] for line in lines[1:4]] == [0.1 * 49, 0.1 * 50, 0.1 * 99]
    assert lines[2]["events"][0]["text"] == "told"


def test_a_page_that_reads_nothing_is_let_go_of_and_holds_no_memory() -> None:
    hub = Hub()
    listener = joined(hub)
    hub.take([SESSION, *(snapshot(float(k), "event") for k in range(MOST_WAITING + 5))])
    assert listener.slow
    assert told(listener) == []
    _, past, newest = told(joined(hub))
    assert newest["t_s"] == MOST_WAITING + 4.0, "when it comes back, it is told everything"
    assert len(past) == MOST_WAITING + 5


def test_the_past_keeps_to_its_room_and_spans_the_whole_flight() -> None:
    hub = Hub(past_bytes=100_000)
    hub.take([SESSION, *(snapshot(float(k), size=1000) for k in range(1000))])
    _, past, _ = told(joined(hub))
    times = [line["t_s"] for line in past]
    assert 25 <= len(times) <= 100
    assert times[0] == 0.0
    assert times[-1] > 950.0
    steps = {b - a for a, b in itertools.pairwise(times)}
    assert max(steps) <= 2 * min(steps), "evenly thinned out"


def test_a_replay_that_goes_back_leaves_no_later_past() -> None:
    hub = Hub()
    hub.take([SESSION, *(snapshot(float(k)) for k in range(10)), snapshot(3.0), snapshot(4.0)])
    _, past, newest = told(joined(hub))
    assert [line["t_s"] for line in past] == [0.0, 1.0, 2.0, 3.0, 4.0]
    assert newest["t_s"] == 4.0


def test_a_reply_reaches_only_who_asked_under_the_id_that_it_gave() -> None:
    hub = Hub()
    hub.take([SESSION])
    first, second = joined(hub), joined(hub)
    told(first), told(second)
    commands = [hub.command(page, '{"command": "pause", "id": "a"}') for page in (first, second)]
    assert commands[0] != commands[1]
    assert commands[1] is not None
    hub.take([{"type": "reply", "id": commands[1]["id"], "ok": True, "text": "The session stands still."}])
    assert told(first) == []
    assert told(second) == [{"type": "reply", "id": "a", "ok": True, "text": "The session stands still."}]


def test_who_may_only_look_is_told_so_and_sees_a_session_without_control() -> None:
    hub = Hub()
    hub.take([SESSION])
    page = joined(hub, commands=False)
    assert told(page)[0]["control"] is False
    assert hub.command(page, '{"command": "stop", "id": 1}') is None
    assert told(page) == [{"type": "reply", "id": 1, "ok": False, "text": READ_ONLY}]


def test_what_is_no_command_is_passed_over() -> None:
    hub = Hub()
    page = joined(hub)
    for text in ("", "{", "[]", "7", '{"command": 7}', '{"no": "command"}', "\ud800"):
        assert hub.command(page, text) is None
    hub.take([{"type": "reply", "id": "99/x", "ok": True, "text": ""}, {"type": "reply", "id": None, "ok": True}])
    assert told(page) == []


def test_a_page_that_reads_nothing_keeps_no_copy_of_the_past() -> None:
    """16 MB of it, as 20 pages are to have it: each takes it in pieces, the lines are shared."""
    hub = Hub()
    hub.take([SESSION, *(snapshot(float(k), size=40_000) for k in range(390))])
    tracemalloc.start()
    try:
        deaf = [joined(hub) for _ in range(20)]
        assert tracemalloc.get_traced_memory()[1] < 2 << 20
    finally:
        tracemalloc.stop()
    session, *pieces, newest = told(deaf[0])
    assert (session["type"], newest["t_s"]) == ("session", 389.0)
    assert [line["t_s"] for piece in pieces for line in piece] == [float(k) for k in range(390)]
    assert max(len(json.dumps(piece)) for piece in pieces) < PIECE_BYTES + 50_000


def test_where_the_report_is_comes_after_the_end_also_to_a_page_that_comes_later() -> None:
    hub = Hub()
    assert not hub.visited
    page = joined(hub)
    hub.take([SESSION, {"type": "end", "outcome": "met"}])
    assert hub.visited
    assert not hub.reported
    hub.report("/report/secret")
    report = {"type": "report", "path": "/report/secret"}
    assert told(page)[-2:] == [{"type": "end", "outcome": "met"}, report]
    assert told(joined(hub, commands=False))[-1] == report
