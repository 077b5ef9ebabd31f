"""Many vehicles in the console: found by words and by id, counted; its looks; what a late console knows of before."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from feed import crowd, flight, session, snapshot
from pilots import Shown, drive, screen

from gcs.console.events_log import folded
from gcs.console.model import SessionModel
from gcs.console.styles import COLOURS, GROUNDS, look_of

CROWD = [session(), crowd(254, 20.0)]


def ids(lines: list[str]) -> list[str]:
    """The ids at the beginnings of the fleet's rows."""
    first = [line.replace("!", " ").replace("▲", " ").split()[:1] for line in lines[4:]]
    return [one[0] for one in first if one and one[0].isdigit()]


def test_vehicles_are_filtered_by_the_beginning_of_their_id_and_by_words() -> None:
    async def steps(shown: Shown) -> None:
        await shown.press("slash", *"25", "enter")
        assert set(ids(shown.lines())) >= {"25", "250", "251", "252", "253", "254"}
        assert '"25": 6 of 254' in shown.text()
        await shown.press("slash", *["backspace"] * 2, *"no such", "enter")
        assert '"no such": 0 of 254' in shown.text()
        await shown.press("slash", *["backspace"] * 7, "enter")
        assert " of 254" not in shown.text()

    drive(steps, CROWD, size=(120, 40))


def test_a_vehicle_is_gone_to_by_its_id_and_its_page_is_that_one() -> None:
    async def steps(shown: Shown) -> None:
        await shown.press("g", *"200", "enter")
        assert shown.app.main.chosen == 200
        assert "200" in ids(shown.lines())
        await shown.press("enter")
        assert "target 200   id 200" in shown.text()

    drive(steps, CROWD)


def test_more_than_fit_are_counted_by_mode_and_charge() -> None:
    rows = crowd(254, 20.0)["vehicles"]
    offboard = sum(row["mode"] == "offboard" and row["alive"] for row in rows)
    low = sum(row["battery"] < 0.2 for row in rows)
    (line,) = (line for line in screen(CROWD, size=(160, 50)) if "more" in line)
    assert f"{offboard} Offboard" in line
    assert (f"{low} below 20 %" in line) == (low > 0)


def test_what_a_vehicle_says_at_once_is_one_event_and_what_is_bad_never_is() -> None:
    def told(t_s: float, sysid: int, kind: str, level: str = "info") -> Mapping[str, Any]:
        return {"t_s": t_s, "sysid": sysid, "kind": kind, "level": level, "text": kind}

    events = [
        told(1.0, 1, "text"), told(1.1, 2, "mode"), told(1.2, 1, "ack"), told(1.3, 1, "mode"),
        told(1.4, 1, "text", "warning"), told(1.5, 1, "decision"), told(4.5, 1, "mode"), told(4.6, 2, "ack"),
    ]  # fmt: skip
    found = [(event["t_s"], event.get("more", 0)) for event in folded(events)]
    assert found == [(1.0, 2), (1.1, 0), (1.4, 0), (1.5, 0), (4.5, 0), (4.6, 0)]


def test_the_ground_is_the_terminals_and_a_key_turns_it() -> None:
    assert (look_of({}), look_of({"COLORFGBG": "15;0"})) == ("dark", "dark")
    assert (look_of({"COLORFGBG": "0;15"}), look_of({"COLORFGBG": "0;default;7"})) == ("light", "light")
    assert COLOURS["dark"].keys() == COLOURS["light"].keys()

    async def steps(shown: Shown) -> None:
        def ground() -> set[str]:
            styles = [segment.style for line in shown.segments() for segment in line if segment.style]
            return {style.bgcolor.triplet.hex for style in styles if style.bgcolor and style.bgcolor.triplet}

        assert GROUNDS["dark"].ground in ground()
        await shown.press("d")
        assert not ground() & {GROUNDS["dark"].ground, GROUNDS["dark"].raised}
        assert {GROUNDS["light"].ground, GROUNDS["light"].raised} <= ground()

    drive(steps, list(flight()))


def contrast(ink: str, ground: str) -> float:
    """Of two colours (WCAG 2.2, relative luminance)."""

    def luminance(colour: str) -> float:
        parts = [int(colour[k : k + 2], 16) / 255.0 for k in (1, 3, 5)]
        linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
        return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]

    a, b = sorted((luminance(ink), luminance(ground)))
    return (b + 0.05) / (a + 0.05)


def test_words_can_be_read_on_the_light_ground() -> None:
    lines = ("faint", "grid", "aim", "badge", "trail", "path", "raised", "chosen")
    for name, style in COLOURS["light"].items():
        ink = next((word for word in style.split() if word.startswith("#")), None)
        if name not in lines and ink is not None:
            least = 3.0 if name.startswith("vehicle") else 4.5  # curves and marks; their names say who it is, too
            assert contrast(ink, GROUNDS["light"].ground) >= least, name


def test_a_console_that_comes_late_has_the_curves_of_before() -> None:
    past = [[40.0 + k / 2, {"1": 0.5, "2": 0.1}] for k in range(10)]
    watch = SessionModel()
    watch.update([session(contest=past), snapshot(48.2)])
    assert [t_s for t_s, _ in watch.competition_states][:10] == [t_s for t_s, _ in past]
    watch.update([session(contest=past)])
    times = [t_s for t_s, _ in watch.competition_states]
    assert times == sorted(set(times)), "once each"


def test_a_question_shows_its_vehicle_as_it_is_now_and_what_follows() -> None:
    async def steps(shown: Shown) -> None:
        await shown.press("h")
        assert "battery 8 %" in shown.text()
        assert "It will not be refuelled" in shown.text()
        rows = [row | {"battery": 0.07} for row in snapshot(48.4)["vehicles"]]
        await shown.feed({**snapshot(48.4), "vehicles": rows})
        assert "battery 7 %" in shown.text()

    drive(steps, list(flight()))
