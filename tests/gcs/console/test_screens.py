"""The console's screens: as someone approved them, at any size, with less than Unicode and colours.

The screens in tests/gcs/console/screens show a fabricated session. `python tests/gcs/console/test_screens.py`
in the clone writes them anew, and a person is to look at them then.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from feed import INSPECTED, TARGET, flight, session, snapshot, vehicle
from pilots import Messages, Shown, drive, screen

from gcs.console.pages import help_text
from gcs.console.text import ASCII

SCREENS = Path(__file__).parent / "screens"
SIZES = {"80x24": (80, 24), "160x50": (160, 50)}
PAGES = {"fleet": "1", "map": "2", "competition": "3", "events": "4", "vehicle": "5"}


def pictured(messages: Messages, size: str) -> dict[str, str]:
    """Each page as text."""
    seen: dict[str, str] = {}

    async def steps(shown: Shown) -> None:
        for page, key in PAGES.items():
            await shown.press(key)
            if page == "vehicle":
                told = {str(shown.app.main.chosen): INSPECTED}
                await shown.feed(snapshot(48.2, since_s=48.2, inspected=told))
            seen[page] = shown.text() + "\n"

    drive(steps, messages, size=SIZES[size])
    return seen


@pytest.mark.parametrize("size", SIZES)
def test_each_page_looks_as_it_did_when_someone_looked_at_it(flown: Messages, size: str) -> None:
    for page, text in pictured(flown, size).items():
        assert text == (SCREENS / f"{page}-{size}.txt").read_text(encoding="utf-8")


def test_from_every_page_at_80_x_24_all_pages_the_trouble_and_stop_are_in_reach(flown: Messages) -> None:
    async def steps(shown: Shown) -> None:
        for key in PAGES.values():
            await shown.press(key)
            _, pages, trouble, *_, keys = shown.lines()
            assert [name for name in PAGES if name not in pages] == []
            assert "ACT 1" in trouble
            assert "pursuer 3: battery 8 %" in trouble
            assert "x stop" in keys
            await shown.press("x")
            assert "Stop the session?" in shown.text()
            await shown.press("escape")
            assert "Stop the session?" not in shown.text()

    drive(steps, flown, size=(80, 24))


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


def test_without_unicode_everything_is_ascii_and_says_what_is_lost(flown: Messages) -> None:
    async def steps(shown: Shown) -> None:
        for keys in (*((key,) for key in PAGES.values()), ("h",), ("escape", "t"), ("escape", "question_mark")):
            await shown.press(*keys)
            assert shown.text().isascii()
            assert ("No Unicode" in shown.text()) == (keys[-1] == "question_mark")

    drive(steps, flown, glyphs=ASCII, size=(160, 50))


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


def test_the_help_page_scrolls_where_it_does_not_fit_and_says_all_of_its_words(flown: Messages) -> None:
    def words(text: str) -> list[str]:
        return [word for word in text.split() if any(letter.isalnum() for letter in word)]

    async def steps(shown: Shown) -> None:
        await shown.press("question_mark")
        assert "lines 1-" in shown.text()
        assert "Signs" not in shown.text()
        read, before = "", ""
        while before != (before := shown.text()):
            read += before
            await shown.press("down")
        assert "Signs" in before
        said = help_text.page(control=True, replay=False, monitor=False, owner=False, lost=[], glyphs=shown.app.glyphs)
        assert set(words(" ".join(text for line in said for text, _ in line))) <= set(words(read))

    drive(steps, flown)


@pytest.mark.parametrize("size", [(80, 24), (120, 40)])
def test_all_targets_are_listed_to_choose_from(size: tuple[int, int]) -> None:
    rows = [vehicle(1, 1.0), *(vehicle(TARGET, 1.0) | {"sysid": k, "label": f"target {k}"} for k in (101, 102, 103))]

    async def steps(shown: Shown) -> None:
        await shown.press("t")
        for listed in ("target 101", "target 102", "target 103"):
            assert any(listed in line and "│" in line for line in shown.lines()), shown.text()
        assert "or an id" in shown.text()

    drive(steps, [session(), snapshot(1.0, vehicles=rows)], size=size)


def test_what_is_typed_to_look_for_can_be_read_and_the_help_with_it(flown: Messages) -> None:
    async def steps(shown: Shown) -> None:
        await shown.press("4", "slash", *"battery 8")
        assert any("battery 8" in line for line in shown.lines())
        assert "without a word all are shown" in shown.text()
        await shown.press("enter")
        assert '"battery 8"' in shown.lines()[3]

    drive(steps, flown)


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


if __name__ == "__main__":
    SCREENS.mkdir(exist_ok=True)
    for a_size in SIZES:
        for a_page, a_text in pictured(list(flight()), a_size).items():
            (SCREENS / f"{a_page}-{a_size}.txt").write_text(a_text, encoding="utf-8")
