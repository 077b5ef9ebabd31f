"""What the console's panels say, as pure functions of messages and room."""

from __future__ import annotations

import math
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from feed import session, snapshot
from hypothesis import given, settings
from hypothesis import strategies as st

from gcs.console.drawing.canvas import Canvas
from gcs.console.drawing.chart import chart
from gcs.console.job import can_suspend
from gcs.console.model import TRAIL_LENGTH, SessionModel, margin, ordered
from gcs.console.pages.fleet import table, window
from gcs.console.pages.heading import session_line
from gcs.console.pages.map_view import MapView, draw, symbol
from gcs.console.styles import COLOURS
from gcs.console.text import ASCII, UNICODE, bar, can_unicode, fitted, number, width_of, wrapped
from gcs.scenario.colours import DARK, LIGHT
from gcs.session.client import GONE_S, SessionSource
from gcs.session.server import Publisher


def vehicle(sysid: int, **other: Any) -> dict[str, Any]:
    return {"sysid": sysid, "severity": 0, **other}


def text(lines: list[list[tuple[str, str]]]) -> list[str]:
    return ["".join(part for part, _ in line) for line in lines]


@given(st.floats(allow_nan=False, allow_infinity=False, width=32).filter(lambda x: abs(x) < 9e8), st.integers(4, 8))
def test_a_number_keeps_its_column_and_is_never_cut(value: float, width: int) -> None:
    shown = number(value, width, 2)
    assert len(shown) <= width
    scale = {"k": 1e3, "M": 1e6, "G": 1e9}.get(shown[-1], 1.0)
    read = float(shown.rstrip("kMG")) * scale
    digits = len(shown.rstrip("kMG").partition(".")[2])
    assert abs(read - value) <= 0.5000001 * scale * 10.0**-digits


def test_bars_are_full_only_at_the_end_and_empty_only_at_zero() -> None:
    drawn = [text([bar(share, 4, ASCII, "")])[0] for share in (0.0, 0.001, 0.5, 1.0, 7.0)]
    assert drawn == ["....", "#...", "##..", "####", "####"]


@settings(max_examples=40)
@given(st.text(max_size=40), st.integers(1, 30))
def test_a_fitted_line_takes_its_width_in_cells(words: str, width: int) -> None:
    printable = "".join(letter for letter in words if letter.isprintable())
    assert width_of(fitted([(printable, "")], width, UNICODE)) == width


def test_wrapped_words_are_all_there() -> None:
    words = "Vehicle 3 is refuelled next: its need is the largest"
    assert " ".join(wrapped(words, 12)) == words
    assert max(map(len, wrapped(words, 12))) <= 12


def test_unicode_is_what_the_locale_and_the_terminal_say() -> None:
    assert can_unicode({}, "utf-8")
    assert can_unicode({"LANG": "de_CH.UTF-8", "TERM": "xterm"}, "utf-8")
    assert not can_unicode({"LC_ALL": "C"}, "utf-8")
    assert not can_unicode({"LANG": "en_US.ISO-8859-1"}, "utf-8")
    assert not can_unicode({"TERM": "linux"}, "utf-8")
    assert not can_unicode({}, "ascii")


@pytest.mark.parametrize(
    ("environment", "unicode"),
    [
        ({"LANG": "C"}, False),
        ({"LANG": "C", "LC_CTYPE": ""}, False),
        ({"LANG": "C", "LC_CTYPE": "C.UTF-8"}, True),
        ({"LANG": "C.UTF-8"}, True),
    ],
)
def test_a_locale_that_python_gave_itself_is_none_that_the_terminal_has(
    environment: dict[str, str], unicode: bool
) -> None:
    ask = "from gcs.console.text import own_glyphs; print(own_glyphs('utf-8').unicode)"
    paths = {"PYTHONPATH": os.pathsep.join(sys.path), "PATH": os.environ["PATH"]}
    told = subprocess.check_output([sys.executable, "-c", ask], env=environment | paths, text=True)
    assert told.strip() == str(unicode)


def test_the_worst_come_first_then_the_chosen_order() -> None:
    fleet = [
        vehicle(1, battery=0.9, v=0.1),
        vehicle(2, battery=0.3, v=0.2),
        vehicle(3, battery=0.5, severity=1),
        vehicle(4, battery=0.6, severity=2),
        {"sysid": 5, "alive": False},
    ]
    assert [v["sysid"] for v in ordered(fleet, "id")] == [4, 5, 3, 1, 2]
    assert [v["sysid"] for v in ordered(fleet, "battery")][3:] == [2, 1]
    assert [v["sysid"] for v in ordered(fleet, "competition")][3:] == [2, 1]


@given(st.integers(1, 300), st.integers(2, 60), st.integers(0, 40), st.integers(0, 299), st.integers(-5, 400))
def test_the_window_always_holds_the_chosen_one_and_the_worst(
    number_of: int, room: int, bad: int, chosen: int, top: int
) -> None:
    fleet = ordered((vehicle(i, severity=2 if i < bad else 0) for i in range(number_of)), "id")
    chosen %= number_of
    shown, _, again = window(fleet, room, chosen, top)
    ids = [v["sysid"] for v in shown]
    assert len(ids) == min(room, number_of) == len(set(ids))
    assert chosen in ids
    assert set(range(min(bad, number_of, room // 2))) <= set(ids)
    assert window(fleet, room, chosen, again)[0] == shown


@pytest.mark.parametrize("width", [40, 61, 80, 120, 219])
def test_the_table_is_as_wide_as_its_room_and_its_columns_stand_under_their_titles(width: int) -> None:
    fleet = snapshot(48.2)["vehicles"]
    lines, ids, _ = table(fleet, width=width, height=20, glyphs=UNICODE, chosen=3, top=0)
    assert {width_of(line) for line in lines} == {width}
    assert len(ids) == 7
    head, row = text(lines)[:2]
    assert row[head.index("mode") :].startswith("Offboard")


def test_positions_that_are_far_away_are_rounded_not_cut() -> None:
    far = snapshot(1.0)["vehicles"][0] | {"p_ned": [-12345.6, 98765.4, -3.0]}
    lines, _, _ = table([far], width=80, height=5, glyphs=UNICODE, chosen=None, top=0)
    assert "-12k  99k" in text(lines)[1]


@given(st.lists(st.tuples(*[st.floats(-1e6, 1e6)] * 4), max_size=8))
def test_lines_off_the_canvas_neither_fail_nor_take_long(ends: list[tuple[float, float, float, float]]) -> None:
    canvas = Canvas(10, 4, UNICODE)
    for x0, y0, x1, y1 in ends:
        canvas.line((x0, y0), (x1, y1), "")
    assert [len(line) for line in text(canvas.lines())] == [10] * 4


def test_a_diagonal_of_dots_is_what_braille_says() -> None:
    canvas = Canvas(2, 1, UNICODE)
    canvas.line((0, 0), (3, 3), "")
    # Unicode 15, Braille Patterns: dots 1, 5 of the first cell, 3 and 8 of the second.
    assert text(canvas.lines()) == [chr(0x2800 + 0x01 + 0x10) + chr(0x2800 + 0x04 + 0x80)]
    coarse = Canvas(3, 1, ASCII)
    for x, y in ((0, 0), (1, 1), (2, 0), (2, 1)):
        coarse.dot(x, y, "")
    assert text(coarse.lines()) == ["'.:"]


@pytest.mark.parametrize(
    ("heading_deg", "arrow", "ascii_arrow"),
    [(0, "↑", "^"), (45, "↗", "^"), (90, "→", ">"), (180, "↓", "v"), (-90, "←", "<"), (359, "↑", "^")],
)
def test_a_vehicle_points_where_its_nose_does(heading_deg: float, arrow: str, ascii_arrow: str) -> None:
    view = vehicle(1, heading_rad=math.radians(heading_deg))
    assert symbol(view, UNICODE) == arrow
    assert symbol(view, ASCII) == ascii_arrow


def test_a_rising_curve_rises_and_keeps_its_style_whoever_leads() -> None:
    samples = [(t / 10.0, {"1": t / 100.0, "12": 0.5}) for t in range(101)]
    drawn = chart(
        samples, ["1", "12"], [], style_of="style {}".format, width=60, height=12, glyphs=ASCII, span_s=10.0, now_s=10.0
    )
    rows = [row for row, line in enumerate(drawn) for part, name in line if name == "style 1" and part.strip()]
    assert min(rows) == 0
    assert max(rows) == 10
    assert text(drawn)[0].endswith("  1 1.00")


def test_a_vehicle_has_one_colour_on_map_and_in_curves_by_its_place_in_the_scenario() -> None:
    watch = SessionModel()
    watch.update([session(), snapshot(30.0)])
    styles = {sysid: watch.style(sysid) for sysid in watch.vehicles}
    assert styles == {
        1: "vehicle0",
        2: "vehicle1",
        3: "vehicle2",
        4: "vehicle3",
        5: "vehicle4",
        101: "target",
        201: "vehicle6",
    }
    plan = draw(watch, MapView(), width=120, height=40, glyphs=UNICODE, chosen=None)
    numbers = {part.strip(): name for line in plan for part, name in line if part.strip() in ("2", "5")}
    assert all(styles[int(part)] in name for part, name in numbers.items())
    for look, own in (("dark", DARK), ("light", LIGHT)):
        assert [COLOURS[look][f"vehicle{place}"] for place in range(len(own))] == list(own), "the page's own"


def test_the_map_shows_missions_fences_and_rally_points_whatever_lies_far_off() -> None:
    item = {"number": 1, "command": "NAV_WAYPOINT", "p_ned": [300.0, 0.0, -10.0], "flown": True}
    far = {**item, "number": 2, "p_ned": [4e6, 0.0, -10.0], "flown": True}
    fence = {"inside": True, "outline_ne": [[-400.0, -400.0], [-400.0, 400.0], [400.0, 400.0], [-400.0, -400.0]]}
    plan = {"source": "a.plan", "sysid": None, "items": [item, far], "fence": [fence], "rally_ned": [[0.0, 350.0, 0.0]]}
    watch = SessionModel()
    watch.update([session() | {"plans": [plan]}, snapshot(30.0)])
    view = MapView()
    drawn = draw(watch, view, width=120, height=40, glyphs=ASCII, chosen=None)
    styles = {name for line in drawn for part, name in line if part.strip()}
    assert {"base", "aim"} <= styles
    assert any("R" in part and name == "base" for line in drawn for part, name in line)
    assert 400.0 <= view.m_per_dot * 120 * 2 <= 8000.0, "the map holds the fence, and not what lies 4000 km off"


def test_the_present_is_at_the_curves_right_edge_though_nobody_competes_any_more() -> None:
    samples = [(t / 10.0, {"7": 0.5}) for t in range(101)]
    drawn = text(chart(samples, ["7"], [], style_of=str, width=60, height=12, glyphs=ASCII, span_s=10.0, now_s=15.0))
    assert drawn[-1].split() == ["5", "s", "15", "s"]
    assert not any("0.50" in line for line in drawn)
    now = text(chart(samples, ["7"], [], style_of=str, width=60, height=12, glyphs=ASCII, span_s=10.0, now_s=10.0))
    assert any("7 0.50" in line for line in now)


def test_axes_stand_before_anybody_has_competed() -> None:
    drawn = text(chart([], [], [], style_of=str, width=60, height=12, glyphs=ASCII, span_s=60.0, now_s=1.0))
    assert drawn[0].startswith(" 1.0")
    assert drawn[-1].split() == ["0", "s", "60", "s"]


def test_trails_are_bounded_and_forgotten_when_time_goes_back() -> None:
    watch = SessionModel()
    for tick in range(2000):
        watch.update([snapshot(tick / 10.0, since_s=(tick - 1) / 10.0)])
    assert {len(trail) for trail in watch.trails.values()} == {TRAIL_LENGTH}
    watch.update([snapshot(3.0, since_s=3.0)])
    assert {len(trail) for trail in watch.trails.values()} == {1}
    assert all(event["t_s"] <= 3.0 for event in watch.events)


def test_the_margin_is_the_share_less_what_is_needed() -> None:
    assert margin({"share": 0.95, "threshold": 0.9}) == pytest.approx(0.05)
    assert margin({"share": None}) is None


def test_a_lost_connection_is_told_in_words() -> None:
    watch = SessionModel()
    watch.update([snapshot(10.0)])
    assert "not connected" in text([session_line(watch, "demo", False, 0.0, 80, UNICODE)])[0]


def test_a_session_that_goes_without_a_word_ends_and_one_that_dropped_us_is_found_again(tmp_path: Path) -> None:
    now_s = 0.0
    source = SessionSource(tmp_path, clock=lambda: now_s)
    assert source.receive() == []
    assert not source.connected
    publisher = Publisher(tmp_path)
    now_s = 1.0
    source.receive()
    source.send({"command": "inspect", "sysid": 5})
    assert {"command": "inspect", "sysid": 5}.items() <= _commands(publisher)[0].items()
    publisher.publish(snapshot(1.0))
    assert [message["type"] for message in source.receive()][-1] == "snapshot"
    publisher.close()
    publisher = Publisher(tmp_path)
    now_s = 2.0
    source.receive()
    now_s = 3.0
    source.receive()
    assert source.connected
    assert _commands(publisher)[0]["sysid"] == 5
    publisher.close()
    source.receive()
    now_s = 3.0 + GONE_S
    assert [message["type"] for message in [*source.receive(), *source.receive()]] == ["end"]
    source.close()


def _commands(publisher: Publisher) -> list[Any]:
    commands: list[Any] = []
    for _ in range(100):
        commands = publisher.poll()
        if commands:
            break
    return [command[-1] if isinstance(command, tuple) else command for command in commands]


def test_a_process_group_without_a_shell_is_not_suspended() -> None:
    done, told = os.pipe()
    child = os.fork()
    if child == 0:
        os.setsid()
        os.write(told, b"y" if can_suspend() else b"n")
        os._exit(0)
    os.waitpid(child, 0)
    assert os.read(done, 1) == b"n"
    os.close(done)
    os.close(told)
