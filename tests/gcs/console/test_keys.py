"""The console's keys: what each asks before it sends, what it shows, and what it leaves alone."""

from __future__ import annotations

import pytest
from feed import crowd, session, snapshot
from pilots import Messages, Shown, drive


def test_an_order_is_asked_first_sent_once_and_its_reply_shown(flown: Messages) -> None:
    async def steps(shown: Shown) -> None:
        await shown.press("h")
        assert "Let pursuer 3 hold its position?" in shown.text()
        await shown.press("n")
        assert shown.source.sent == []
        await shown.press("h", "y")
        (sent,) = shown.source.sent
        assert {"command": "hold", "sysid": 3, "id": sent["id"]} == sent
        await shown.feed({"type": "reply", "id": sent["id"], "ok": False, "text": "3 is on the ground"})
        assert shown.lines()[-1] == " hold pursuer 3: 3 is on the ground"

    drive(steps, flown)


def test_each_order_has_its_key(flown: Messages) -> None:
    orders = {"r": "return", "l": "land", "f": "refuel", "s": "skip", "j": "rejoin", "p": "pause", "x": "stop"}

    async def steps(shown: Shown) -> None:
        for key, command in orders.items():
            await shown.press(key, "enter")
            sent = shown.source.sent.pop()
            assert sent["command"] == command
            assert ("sysid" in sent) == (command not in ("pause", "stop"))
            assert shown.source.sent == []

    drive(steps, flown)


def test_a_paused_session_is_resumed_by_the_same_key() -> None:
    async def steps(shown: Shown) -> None:
        await shown.press("p", "y")
        assert [sent["command"] for sent in shown.source.sent] == ["resume"]

    drive(steps, [session(), snapshot(10.0, phase="paused")])


def test_a_new_target_is_chosen_by_arrows_or_by_its_id() -> None:
    fleet = crowd(254, 1.0)  # its targets are 50, 100, 150, 200 and 250

    async def steps(shown: Shown) -> None:
        await shown.press("t", "down", "enter")
        await shown.press("t", "2", "5", "enter")
        await shown.press("t", "escape")
        assert [sent["target"] for sent in shown.source.sent] == [100, 250]
        assert {sent["sysid"] for sent in shown.source.sent} == {77}

    drive(steps, [session(), fleet])


def test_the_chosen_vehicle_stays_chosen_when_the_order_changes() -> None:
    async def steps(shown: Shown) -> None:
        await shown.feed(session(), snapshot(20.0))
        assert shown.app.main.chosen == 1
        await shown.feed(snapshot(48.2))
        assert shown.app.main.chosen == 1
        await shown.press("down")
        assert shown.app.main.chosen == 2
        await shown.press("N", "N", "N")
        assert shown.app.main.chosen == 3

    drive(steps, [])


def test_one_vehicle_is_inspected_while_its_page_shows() -> None:
    async def steps(shown: Shown) -> None:
        await shown.press("enter", "n", "1")
        assert [(s["command"], s["sysid"]) for s in shown.source.sent] == [
            ("inspect", 1),
            ("inspect", 2),
            ("inspect", None),
        ]

    drive(steps, [session(), snapshot(20.0)])


def test_events_are_filtered_by_level_kind_vehicle_and_words(flown: Messages) -> None:
    async def steps(shown: Shown) -> None:
        def rows() -> list[str]:
            return [line for line in shown.lines()[4:-1] if line]

        await shown.press("4")
        assert len(rows()) == 12
        assert rows()[6].endswith("hold: accepted (+1)"), "what follows at once is folded into it"
        await shown.press("e")
        assert len(rows()) == 13
        await shown.press("w")
        assert len(rows()) == 3
        await shown.press("w")
        assert [row.split()[-3:] for row in rows()] == [["Battery", "8", "%"]]
        await shown.press("0", "v")
        assert {" ".join(row.replace("!", "").replace("▲", "").split()[2:4]) for row in rows()} == {"pursuer 3"}
        await shown.press("0", "slash", *"heard", "enter")
        assert [row.split()[-2:] for row in rows()] == [["Heard", "again"]]
        await shown.press("0", "k", "k")
        assert [row.split()[1] for row in rows()] == ["mode", "mode"]

    drive(steps, flown)


def test_old_events_stay_in_place_while_new_ones_come() -> None:
    many = [{"t_s": float(i), "sysid": 1, "level": "info", "kind": "text", "text": f"number {i}."} for i in range(100)]

    async def steps(shown: Shown) -> None:
        await shown.press("4", "e")
        assert "number 99." in shown.text()
        await shown.press("home")
        before = shown.lines()[4:-1]
        assert "number 0." in before[0]
        await shown.feed(snapshot(101.0, events=[many[0] | {"text": "number 100."}]))
        assert shown.lines()[4:-1] == before
        await shown.press("end")
        assert "number 100." in shown.text()

    drive(steps, [session(), snapshot(100.0, events=many)])


def test_the_map_zooms_pans_follows_and_shows_everything_again(flown: Messages) -> None:
    async def steps(shown: Shown) -> None:
        plan = shown.app.main.plan
        await shown.press("2")
        whole, centre = plan.m_per_dot, plan.centre_ne
        await shown.press("z")
        assert plan.m_per_dot == pytest.approx(whole / 1.25)
        await shown.press("up", "right")
        assert plan.centre_ne[0] > centre[0]
        assert plan.centre_ne[1] > centre[1]
        await shown.press("c")
        n, e, _ = shown.app.seen.vehicles[3]["p_ned"]
        assert plan.centre_ne == pytest.approx((n, e), abs=4.0 * plan.m_per_dot)
        await shown.press("a")
        assert (plan.m_per_dot, plan.centre_ne) == (whole, centre)

    drive(steps, flown)


def test_a_replay_is_paused_sought_and_hurried_and_takes_no_orders() -> None:
    replay = {"from_s": 0.0, "to_s": 150.0, "speed": 2.0, "paused": False}

    async def steps(shown: Shown) -> None:
        await shown.press("space", "right", "left", "plus", "minus")
        assert [tuple(s.values()) for s in shown.source.sent] == [
            ("pause",),
            ("seek", 30.0),
            ("seek", 10.0),
            ("speed", 5.0),
            ("speed", 1.0),
        ]
        await shown.press("h")
        assert "takes no commands" in shown.lines()[-1]
        await shown.feed(snapshot(5.0, replay=replay))
        assert all(t_s <= 5.0 for t_s, _ in shown.app.seen.competition_states)
        assert all(event["t_s"] <= 5.0 for event in shown.app.seen.events)

    drive(steps, [session(control=False), snapshot(20.0, replay=replay)])


def test_a_monitor_offers_hold_return_and_land_alone() -> None:
    async def steps(shown: Shown) -> None:
        assert "h hold" in shown.lines()[-1]
        assert "j rejoin" not in shown.lines()[-1]
        await shown.press("j")
        assert "a monitor takes no rejoin" in shown.lines()[-1]
        await shown.press("h")
        assert "refuelled" not in shown.text()
        await shown.press("n", "question_mark")
        assert "land where it is" in shown.text()
        assert "serve it next" not in shown.text()
        assert shown.source.sent == []

    ordering = [session(source="monitor", control=True), snapshot(20.0, phase="monitoring")]
    drive(steps, ordering, size=(200, 70))


def test_a_monitor_that_only_watches_names_the_option_that_lets_it_order() -> None:
    async def steps(shown: Shown) -> None:
        await shown.press("h")
        assert "start it with --control" in shown.lines()[-1]
        assert shown.source.sent == []
        await shown.press("question_mark")
        assert "start the monitor with --control" in shown.text()

    watched = [session(source="monitor", control=False), snapshot(20.0, phase="monitoring")]
    drive(steps, watched, size=(120, 70))


def test_an_event_is_told_to_its_last_word_and_where_no_event_passes_that_is_said() -> None:
    words = " ".join(f"word{i}" for i in range(30))
    told = {"t_s": 47.0, "sysid": 0, "level": "info", "kind": "operator", "text": f"Operator: {words}"}

    async def steps(shown: Shown) -> None:
        await shown.press("4")
        for key in ("4", "1"):
            await shown.press(key)
            assert all(word in shown.text() for word in words.split())
            assert "Operator:" not in shown.text()
        await shown.press("4", "slash", *"nowhere", "enter")
        assert "none" in [line.strip() for line in shown.lines()]

    drive(steps, [session(), snapshot(48.2, events=[told])])


def test_every_event_can_be_scrolled_to_however_many_lines_each_takes() -> None:
    words = " ".join(f"word{i}" for i in range(20))
    many = [{"t_s": float(i), "sysid": 1, "level": "info", "kind": "text", "text": f"n{i}. {words}"} for i in range(16)]

    async def steps(shown: Shown) -> None:
        await shown.press("4", "e", "home")
        seen = {number for number in range(16) if f"n{number}." in shown.text()}
        assert min(seen) == 0
        assert max(seen) < 8, "they do not fit"
        for _ in range(16):
            await shown.press("down")
            seen |= {number for number in range(16) if f"n{number}." in shown.text()}
        assert seen == set(range(16))
        assert "newer below" not in shown.text()

    drive(steps, [session(), snapshot(100.0, events=many)])


def test_at_the_end_of_a_recording_the_same_key_begins_it_again_and_the_help_promises_no_session() -> None:
    replay = {"from_s": 0.0, "to_s": 150.0, "speed": 1.0, "paused": False}

    async def steps(shown: Shown) -> None:
        assert "ended" in shown.lines()[0]
        await shown.press("space")
        assert [sent["command"] for sent in shown.source.sent] == ["resume"]
        await shown.press("h")
        assert "a recording takes no commands" in shown.lines()[-1]
        await shown.press("question_mark")
        assert "close the replay" in shown.text()
        assert "the session goes on" not in shown.text()

    drive(steps, [session(control=False), snapshot(150.0, phase="ended", replay=replay)], size=(100, 60))
