"""The console's app under Textual's pilot: its screens, its keys, what it asks before it sends, what it survives.

The screens in tests/gcs/console/screens show a fabricated session. `python tests/gcs/console/test_app.py`
in the clone writes them anew, and a person is to look at them then.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
from feed import INSPECTED, crowd, flight, session, snapshot
from pilots import Shown, drive, screen

from gcs.console.pages import help_text
from gcs.console.text import ASCII

SCREENS = Path(__file__).parent / "screens"
SIZES = {"80x24": (80, 24), "160x50": (160, 50)}
PAGES = {"fleet": "1", "map": "2", "competition": "3", "events": "4", "vehicle": "5"}
Messages = list[Mapping[str, Any]]


@pytest.fixture(scope="module")
def flown() -> Messages:
    """The demo up to 48.2 s."""
    return list(flight())


def pictured(messages: Messages, page: str, size: str) -> str:
    """A page as text."""
    seen: list[str] = []

    async def steps(shown: Shown) -> None:
        await shown.press(PAGES[page])
        if page == "vehicle":
            told = {str(shown.app.main.chosen): INSPECTED}
            await shown.feed(snapshot(48.2, since_s=48.2, inspected=told))
        seen.extend(shown.lines())

    drive(steps, messages, size=SIZES[size])
    return "\n".join(seen) + "\n"


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("page", PAGES)
def test_each_page_looks_as_it_did_when_someone_looked_at_it(flown: Messages, page: str, size: str) -> None:
    wanted = (SCREENS / f"{page}-{size}.txt").read_text(encoding="utf-8")
    assert pictured(flown, page, size) == wanted


def test_every_page_names_the_vehicles_in_trouble_the_worst_first(flown: Messages) -> None:
    for key in PAGES.values():
        line = screen(flown, key)[2]
        assert line.index("pursuer 3: battery 8 %, return") < line.index("pursuer 4: held")
        assert "ACT 1" in line
        assert "LOOK 1" in line


def test_of_254_vehicles_those_in_trouble_stay_in_sight_wherever_the_table_is_scrolled() -> None:
    messages = [session(), crowd(254, 20.0)]
    top = screen(messages)
    assert [line.split()[1] for line in top[4:5]] == ["77"]
    bottom = screen(messages, "end")
    assert [line.split()[0] for line in bottom[4:6]] == ["▲", "!200"]
    assert any(line.split()[:1] == ["254"] for line in bottom)
    assert any("242 more" in line for line in top)


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


@pytest.mark.parametrize(
    ("key", "command"),
    [("r", "return"), ("l", "land"), ("f", "refuel"), ("s", "skip"), ("j", "rejoin"), ("p", "pause"), ("x", "stop")],
)
def test_each_order_has_its_key(flown: Messages, key: str, command: str) -> None:
    async def steps(shown: Shown) -> None:
        await shown.press(key, "enter")
        (sent,) = shown.source.sent
        assert sent["command"] == command
        assert ("sysid" in sent) == (command not in ("pause", "stop"))

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


def test_a_terminal_that_is_too_small_says_so_until_it_grows(flown: Messages) -> None:
    async def steps(shown: Shown) -> None:
        await shown.press("h")
        await shown.pilot.resize_terminal(60, 18)
        await shown.pilot.pause()
        assert "This terminal is 60 x 18: the console needs 80 x 24" in shown.text()
        assert "pursuer" not in shown.text()
        await shown.press("x", "y")
        assert shown.source.sent == []
        await shown.pilot.resize_terminal(80, 24)
        await shown.pilot.pause()
        assert "ACT 1" in shown.lines()[2]

    drive(steps, flown)


@pytest.mark.parametrize(("replay", "promised"), [(None, True), ({"from_s": 0.0, "to_s": 150.0, "speed": 1.0}, False)])
def test_a_small_terminal_promises_that_the_session_goes_on_only_where_one_flies(
    replay: dict[str, float] | None, promised: bool
) -> None:
    told = [session(), snapshot(5.0, replay=replay) if replay else snapshot(5.0)]
    text = " ".join(screen(told, size=(60, 18)))
    assert "close the console with q" in " ".join(text.split())
    assert ("the session goes on" in text) == promised


@pytest.mark.parametrize("size", [(60, 18), (40, 4), (20, 4), (10, 4)])
def test_however_small_the_terminal_it_says_what_is_needed_and_how_to_close(size: tuple[int, int]) -> None:
    text = " ".join(" ".join(screen([session(), snapshot(5.0)], size=size)).split())
    assert "needs 80 x 24" in text
    assert text.endswith(("q; the session goes on.", "q closes; the session goes on.", "q closes"))


@pytest.mark.parametrize("key", [*PAGES.values(), "question_mark", "h", "t"])
def test_without_unicode_everything_is_ascii_and_says_what_is_lost(flown: Messages, key: str) -> None:
    lines = screen(flown, key, glyphs=ASCII, size=(160, 50))
    assert "\n".join(lines).isascii()
    assert ("No Unicode" in "\n".join(lines)) == (key == "question_mark")


def test_without_colour_none_is_used_and_trouble_still_stands_out(
    flown: Messages, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("NO_COLOR", "1")

    async def steps(shown: Shown) -> None:
        for key in (*PAGES.values(), "1"):
            await shown.press(key)
            for segment in (segment for line in shown.segments() for segment in line):
                assert segment.style is None or segment.style.color is None or segment.style.color.is_default
                assert segment.style is None or segment.style.bgcolor is None or segment.style.bgcolor.is_default
        (mark,) = (segment for segment in shown.segments()[2] if "ACT 1" in segment.text)
        assert mark.style is not None
        assert mark.style.reverse
        await shown.press("question_mark")
        assert "No colour" in shown.text()

    drive(steps, flown)


def test_the_help_page_scrolls_where_it_does_not_fit(flown: Messages) -> None:
    async def steps(shown: Shown) -> None:
        await shown.press("question_mark")
        assert "lines 1-" in shown.text()
        assert "Signs" not in shown.text()
        await shown.press(*["down"] * 40)
        assert "Signs" in shown.text()

    drive(steps, flown)


def test_the_help_page_says_all_of_its_words_at_80_columns(flown: Messages) -> None:
    def words(text: str) -> list[str]:
        return [word for word in text.split() if any(letter.isalnum() for letter in word)]

    async def steps(shown: Shown) -> None:
        await shown.press("question_mark")
        read = shown.text()
        for _ in range(60):
            await shown.press("down")
            read += shown.text()
        said = help_text.page(control=True, replay=False, owner=False, lost=[], glyphs=shown.app.glyphs)
        assert set(words(" ".join(text for line in said for text, _ in line))) <= set(words(read))

    drive(steps, flown)


def test_what_is_typed_to_look_for_can_be_read_and_the_help_with_it(flown: Messages) -> None:
    async def steps(shown: Shown) -> None:
        await shown.press("4", "slash", *"battery 8")
        assert any("battery 8" in line for line in shown.lines())
        assert "without a word all are shown" in shown.text()
        await shown.press("enter")
        assert '"battery 8"' in shown.lines()[3]

    drive(steps, flown)


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
    many = [{"t_s": float(i), "sysid": 1, "level": "info", "kind": "text", "text": f"n{i}. {words}"} for i in range(40)]

    async def steps(shown: Shown) -> None:
        await shown.press("4", "e", "home")
        seen = {number for number in range(40) if f"n{number}." in shown.text()}
        assert min(seen) == 0
        for _ in range(40):
            await shown.press("down")
            seen |= {number for number in range(40) if f"n{number}." in shown.text()}
        assert seen == set(range(40))
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


@pytest.mark.parametrize("owner", [True, False])
def test_the_help_says_what_ctrl_c_does_where_it_stops_a_session(flown: Messages, owner: bool) -> None:
    async def steps(shown: Shown) -> None:
        await shown.press("question_mark")
        assert ("stop the session and save it" in shown.text()) == owner

    drive(steps, flown, owner=owner, size=(100, 60))


@pytest.mark.parametrize("size", SIZES.values())
def test_what_each_service_gave_can_be_read_at_any_size(size: tuple[int, int]) -> None:
    past = {"receiver": 102, "tanker": 201, "base": None, "by": "competition", "decided_at_s": 1.0, "end_s": 10.5}
    past |= {"energy_j": 12345, "reason": "full", "joined_at_s": 2.0, "start_s": 3.0}
    lines = screen([session(), snapshot(48.2, history=[past, past | {"energy_j": 250000.0}])], "3", size=size)
    assert any("10.5 s  12345 J" in line for line in lines)
    assert any("250000 J" in line and line.rstrip(" …").endswith(("competition", "full")) for line in lines)


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
    for key in PAGES.values():
        screen([{"type": "session"}, bare], key, size=(160, 50))
    assert any("hello" in line for line in screen([{"type": "session"}, bare], "4"))


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


if __name__ == "__main__":
    SCREENS.mkdir(exist_ok=True)
    for a_page in PAGES:
        for a_size in SIZES:
            (SCREENS / f"{a_page}-{a_size}.txt").write_text(pictured(list(flight()), a_page, a_size), encoding="utf-8")
