"""The console's app from its start to its end, and what every page says of vehicles in trouble."""

from __future__ import annotations

from feed import crowd, session, snapshot
from pilots import Messages, Shown, drive, screen

PAGES = "12345"


def test_every_page_names_the_vehicles_in_trouble_the_worst_first(flown: Messages) -> None:
    async def steps(shown: Shown) -> None:
        for key in PAGES:
            await shown.press(key)
            line = shown.lines()[2]
            assert line.index("pursuer 3: battery 8 %, Return") < line.index("pursuer 4: held")
            assert "ACT 1" in line
            assert "LOOK 1" in line

    drive(steps, flown)


def test_of_254_vehicles_those_in_trouble_stay_in_sight_wherever_the_table_is_scrolled() -> None:
    messages = [session(), crowd(254, 20.0)]
    top = screen(messages)
    assert [line.split()[1] for line in top[4:5]] == ["77"]
    bottom = screen(messages, "end")
    assert [line.split()[0] for line in bottom[4:6]] == ["▲", "!200"]
    assert any(line.split()[:1] == ["254"] for line in bottom)
    assert any("242 more" in line for line in top)


def test_filling_a_page_is_no_notice_and_a_refusal_is_one(flown: Messages) -> None:
    async def steps(shown: Shown) -> None:
        keys = shown.lines()[-1]
        await shown.feed({"type": "reply", "ok": True, "text": "Snapshots tell everything that vehicle 3 sends."})
        assert shown.lines()[-1] == keys
        await shown.feed({"type": "reply", "ok": False, "text": "There is no vehicle 9 in this session."})
        assert "There is no vehicle 9 in this session." in shown.lines()[-1]

    drive(steps, flown)


def test_before_the_first_snapshot_the_vehicles_are_starting() -> None:
    lines = screen([session()])
    assert "starting 7 vehicles" in lines[2]
    assert sum("starting" in line for line in lines[4:12]) == 7


def test_missing_keys_read_as_unknown() -> None:
    bare = {"type": "snapshot", "vehicles": [{"sysid": 1}], "events": [{"text": "hello"}], "services": [{}]}

    async def steps(shown: Shown) -> None:
        for key in PAGES:
            await shown.press(key)
            assert ("hello" in shown.text()) == (key in "14")

    drive(steps, [{"type": "session"}, bare], size=(160, 50))


def test_the_console_ends_with_the_session() -> None:
    async def steps(shown: Shown) -> None:
        await shown.feed({"type": "end", "outcome": "met", "exit": 0})

    assert drive(steps, [session(), snapshot(1.0)]).return_code == 0


def test_q_closes_and_asks_the_session_for_nothing(flown: Messages) -> None:
    async def steps(shown: Shown) -> None:
        await shown.press("q")
        assert shown.source.sent == []

    assert drive(steps, flown).return_code == 0


def test_ctrl_c_asks_and_a_second_one_stops_the_session_of_this_terminal(flown: Messages) -> None:
    async def steps(shown: Shown) -> None:
        await shown.press("ctrl+c")
        assert "Stop the session?" in shown.text()
        assert shown.source.sent == []
        await shown.press("ctrl+c")
        assert [sent["command"] for sent in shown.source.sent] == ["stop"]

    drive(steps, flown, owner=True)


def test_a_snapshot_that_comes_before_the_question_is_drawn_waits_for_it(flown: Messages) -> None:
    async def steps(shown: Shown) -> None:
        shown.app.main.action_interrupt()
        await shown.feed(snapshot(50.0))
        assert "Stop the session?" in shown.text()
        await shown.press("ctrl+c")
        assert [sent["command"] for sent in shown.source.sent] == ["stop"]

    drive(steps, flown, owner=True)


def test_ctrl_c_before_there_is_a_session_hands_the_wish_on() -> None:
    async def steps(shown: Shown) -> None:
        shown.source.connected = False
        await shown.press("ctrl+c")

    assert drive(steps, [], owner=True).return_code == 130


def test_ctrl_c_closes_any_other_console(flown: Messages) -> None:
    async def steps(shown: Shown) -> None:
        await shown.press("ctrl+c")
        assert shown.source.sent == []

    assert drive(steps, flown).return_code == 0


def test_only_what_has_changed_is_painted_again(flown: Messages) -> None:
    async def steps(shown: Shown) -> None:
        panel = shown.app.main.query_one("#fleet")
        before = list(panel._strips)
        again = snapshot(48.2, since_s=48.2)
        again["vehicles"][0]["speed_m_s"] = 9.9
        await shown.feed(again)
        changed = [row for row, strip in enumerate(panel._strips) if strip is not before[row]]
        assert len(changed) == 1

    drive(steps, flown)
