"""The report of a session that was flown, in a browser: what stands on the page is drawn, and nothing is fetched."""

from __future__ import annotations

import base64
import gzip
import io
import json
import math
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest
from mcap.reader import make_reader
from mcap_protobuf.decoder import DecoderFactory
from PIL import Image
from playwright.sync_api import Browser, Page, expect
from sessions import Outcome, demo, fly_apart, merged, small
from web import Watched, until

from gcs.cli.main import run_argv
from gcs.cli.report import after_run
from gcs.session.replay import Replay

# Of every figure: whether it shows, where, and how many lines or bars it holds, and what stands beside its axes.
FIGURES = """[...document.querySelectorAll('.plot')].map((plot) => {
  const box = plot.getBoundingClientRect();
  return {
    name: plot.dataset.figure, shows: plot.getClientRects().length > 0, marks: Number(plot.dataset.lines ?? 0),
    box: {x: box.x + scrollX, y: box.y + scrollY, width: box.width, height: box.height},
    axes: [...plot.querySelectorAll('.panel-title, .row-name')].map((title) => title.textContent),
  };
})"""
FLIGHT = """(() => {
  const box = document.querySelector('.picture').getBoundingClientRect();
  return {x: box.x + scrollX, y: box.y + scrollY, width: box.width, height: box.height};
})()"""
STATES = """(() => {
  const {flight} = skytender;
  const known = (column) => Array.from(column, (value) => Number.isNaN(value) ? null : value);
  const v = Object.fromEntries([...flight.columns].map(([id, one]) => [id, known(one.v)]));
  return {t_s: Array.from(flight.t_s), v};
})()"""
FIGURE_NAMES = {
    "target",
    "error",
    "motion",
    "attitude",
    "battery",
    "ledger",
    "contest",
    "timeline",
    "nearness",
    "link",
}


def report(folder: Path, *options: str) -> int:
    return run_argv(["report", str(folder), *options])


def copied(flown: Outcome, folder: Path) -> Path:
    shutil.copytree(flown.folder, folder, ignore=shutil.ignore_patterns("*.sock", "report.html"))
    return folder


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    """Of the demo 32 s: two refuellings, and the goal missed."""
    changes = {"goal": {"duration_s": 32}}
    return fly_apart(merged(demo(), changes), tmp_path_factory.mktemp("report"), "--plain", report=True)


@pytest.fixture(scope="module")
def shown(flown: Outcome, browser: Browser) -> Iterator[Watched]:
    """The page that the run has left, opened."""
    watched = Watched(browser, height=900)
    watched.report((flown.folder / "report.html").resolve().as_uri())
    yield watched
    watched.page.close()


def model(page: Path) -> tuple[dict[str, Any], bytes]:
    """What a page carries: its model, and its series."""
    text = page.read_text(encoding="utf-8")
    found = dict(re.findall(r'<script type="[^"]*" id="(model|series)">(.*?)</script>', text, re.DOTALL))
    return json.loads(found["model"]), gzip.decompress(base64.b64decode(found["series"]))


def test_a_run_ends_with_its_report(flown: Outcome) -> None:
    assert flown.status == 1
    page = flown.folder / "report.html"
    assert f"report: {page}" in flown.stdout
    text = page.read_text(encoding="utf-8")
    assert f"The goal was not met: {flown.summary['outcome_text'].removeprefix('not met: ')}" in text
    assert "Not reached: at least 3 refuelled (1 of 3)." in text
    assert flown.summary["digest"] in text
    assert not re.search(r"""(src|href|url)\s*[=(]\s*["']?(https?:)?//""", text)


def test_its_numbers_are_the_summarys(flown: Outcome) -> None:
    """The page's extremes come from the recording alone; the supervisor measured as it flew."""
    content, raw = model(flown.folder / "report.html")

    def values(line: dict[str, Any]) -> np.ndarray:
        told = np.frombuffer(raw, dtype="<u2", count=line["n"], offset=line["at"] + 2 * line["n"]).astype(float)
        told[told == 65535] = np.nan
        return line["low"] + told * (line["high"] - line["low"]) / 65534

    summary, figures = flown.summary, content["figures"]
    near = [panel["own"][0] for panel in figures["nearness"]["panels"]]
    separation, clearance, traffic = near
    between_m = 0.01  # drawn at ticks, judged between them too
    above_m = np.nanmin(values(separation)) - summary["believed_min_separation_m"]
    assert -1e-9 <= above_m <= 0.1 * between_m
    assert np.nanmin(values(clearance)) == pytest.approx(summary["believed_min_clearance_m"], abs=between_m)
    assert np.nanmin(values(traffic)) == pytest.approx(summary["believed_min_traffic_m"], abs=between_m)
    errors = {line["id"]: np.nanmax(values(line)) for line in figures["error"]["panels"][0]["lines"]}
    assert errors == pytest.approx({v["sysid"]: v["max_tracking_error_m"] for v in summary["vehicles"]}, abs=1e-9)
    left = {line["id"]: values(line)[-1] for line in figures["battery"]["panels"][0]["lines"]}
    capacity_j = {1: 24e3, 2: 24e3, 3: 24e3, 4: 24e3, 5: 24e3, 101: 60e3, 201: 180e3}
    told = {v["sysid"]: 100 * v["energy"]["remaining_j"] / capacity_j[v["sysid"]] for v in summary["vehicles"]}
    assert left == pytest.approx(told, abs=0.01)
    done = [bar["to"] for bar in figures["timeline"]["bars"] if bar["stage"] == 2]
    assert done[0] == summary["refuelling"][0]["end_s"]


def figures(page: Page) -> list[dict[str, Any]]:
    """All that show."""
    return [figure for figure in page.evaluate(FIGURES) if figure["shows"]]


def part(picture: Image.Image, box: dict[str, float]) -> Image.Image:
    """What a picture of the whole page shows in a box."""
    x, y = int(box["x"]), int(box["y"])
    return picture.crop((x, y, x + int(box["width"]), y + int(box["height"])))


@pytest.mark.parametrize(("width", "dark"), [(1280, False), (420, True)])
def test_every_figure_is_drawn_and_nothing_is_fetched(flown: Outcome, shown: Watched, width: int, dark: bool) -> None:
    page = shown.page
    assert page.evaluate("skytender.current.t_s") == 32.0, "it opens at the end"
    shown.look(width, 900, dark=dark)
    until(page, f"{FIGURES}.every((one) => one.box.x + one.box.width <= {width})")
    found = figures(page)
    assert {figure["name"] for figure in found} == FIGURE_NAMES
    whole = Image.open(io.BytesIO(page.screenshot(full_page=True))).convert("RGB")
    for figure in [*found, {"name": "flight", "marks": 1, "axes": ["(m)"], "box": page.evaluate(FLIGHT)}]:
        colours = part(whole, figure["box"]).getcolors(1 << 24)
        assert len(colours) > 20, f"{figure['name']}: lines and letters have soft edges"
        assert figure["box"]["x"] + figure["box"]["width"] <= width
        assert figure["marks"] >= 1, figure["name"]
        units = any("(" in title for title in figure["axes"]) or figure["name"] == "contest"
        assert units, f"{figure['name']} has units, but for states and shares"
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    assert shown.wrong == []
    assert shown.asked == [(flown.folder / "report.html").resolve().as_uri()]


def test_a_state_of_the_competition_is_shown_where_its_vehicle_competed_and_nowhere_else(
    flown: Outcome, shown: Watched
) -> None:
    """Held against the lines of the competition: 0.25 s, two and a half ticks, after one its state is shown no more."""
    states = shown.page.evaluate(STATES)
    lines = [d for d in flown.decisions if d["kind"] == "competition" and d.get("giver") != "base"]
    competed = {name: [line["t_s"] for line in lines if name in line["v"]] for line in lines for name in line["v"]}
    rounding_s = 1e-3  # times are told in 65,534ths of the flight
    count = 0
    for name, moments in states["v"].items():
        told = np.array([-np.inf, *competed.get(name, [])])
        for t_s, v in zip(states["t_s"], moments, strict=True):
            since_s = t_s - told[told < t_s - rounding_s].max()
            begins = since_s > 0.25 and np.abs(told - t_s).min() <= rounding_s
            if not begins and abs(since_s - 0.25) > rounding_s:
                assert (v is not None) == (since_s < 0.25), (name, t_s, v)
                count += v is not None
    assert count > 50
    assert len(competed) >= 3


def test_a_session_that_is_blind_until_its_end_is_shown_so(tmp_path: Path, browser: Browser) -> None:
    """As on the live page: trouble in strip and table, and the event, which the line of time marks."""
    scenario = small(radio={"ground_blackouts": [{"from_s": 9.0, "to_s": 30.0}]}, goal={"duration_s": 25.0})
    page = fly_apart(scenario, tmp_path, "--plain", report=True).folder / "report.html"
    watched = Watched(browser, height=900)
    watched.report(page.resolve().as_uri())
    shown = watched.page
    expect(shown.locator(".strip li.silent")).to_contain_text("3Silent: ")
    expect(shown.locator("table.fleet tbody tr.silent")).to_have_count(3)
    expect(shown.locator("table.fleet tbody tr").first).to_contain_text("no telemetry for 16 s")
    expect(shown.get_by_label("events", exact=True)).to_contain_text("No telemetry for 1.6 s")
    expect(shown.locator(".problems")).to_contain_text("No telemetry of 1, 101, 201 for more than 1.5 s")
    shown.evaluate("skytender.player.seek(8.0)")
    expect(shown.locator(".strip li.silent")).to_be_hidden()
    assert watched.wrong == []
    shown.close()


def test_a_silent_and_a_dead_vehicle_are_shown_as_a_replay_shows_them(tmp_path: Path, browser: Browser) -> None:
    """Where they were last, with their last values and the age of these; 101 is heard again at 17 s."""
    faults = [{"fault": "blackout", "sysid": 101, "at_s": 9, "for_s": 8}, {"fault": "kill", "sysid": 1, "at_s": 12}]
    folder = fly_apart(small(faults=faults, goal={"duration_s": 20.0}), tmp_path, "--plain", report=True).folder
    replay = Replay(folder)
    watched = Watched(browser, height=900)
    watched.report((folder / "report.html").resolve().as_uri())
    page = watched.page
    close = {"height_m": 0.05, "speed_m_s": 0.05, "heading_rad": 0.02, "battery": 0.005, "age_s": 0.15, "target_m": 0.1}
    conditions = {101: {13.5: "silent", 16.5: "silent"}, 1: {16.5: "dead", 19.5: "dead"}}
    for t_s in (5.0, 13.5, 16.5, 19.5):
        replay.advance(t_s, math.inf)
        told = {row["sysid"]: row for row in replay.snapshot(speed=None)["vehicles"]}
        page.evaluate(f"skytender.player.seek({t_s})")
        until(page, f"skytender.current.t_s === {t_s}")
        assert {place["sysid"] for place in page.evaluate("skytender.places")} == {1, 101, 201}
        for row in page.evaluate("skytender.current.vehicles"):
            wanted = told[row["sysid"]]
            assert row["p_ned"] == pytest.approx(wanted["p_ned"], abs=0.05), (t_s, row)
            for name, within in close.items():
                assert row[name] == pytest.approx(wanted[name], abs=within), (t_s, row["sysid"], name)
            expected = conditions.get(row["sysid"], {}).get(t_s)
            assert expected is None or row["condition"] == wanted["condition"] == expected
    assert watched.wrong == []
    page.close()


def test_a_vehicle_can_be_left_out_of_every_figure(shown: Watched) -> None:
    battery, button = shown.page.locator("[data-figure=battery]"), shown.page.locator(".picker button").first
    expect(battery).to_have_attribute("data-lines", "7")
    for pressed, lines in (("false", "6"), ("true", "7")):
        button.click()
        expect(button).to_have_attribute("aria-pressed", pressed)
        expect(battery).to_have_attribute("data-lines", lines)


def test_no_figure_is_lost_on_paper(shown: Watched) -> None:
    page = shown.page
    shown.look(1280, 900, dark=True)
    pdf = page.pdf(prefer_css_page_size=True, print_background=True)
    assert pdf.startswith(b"%PDF")
    assert len(re.findall(rb"/Type\s*/Page\b", pdf)) >= 4
    page.emulate_media(media="print")
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    printed = figures(page)
    assert {figure["name"] for figure in printed} == FIGURE_NAMES | {"flight"}, "a map in place of the view in space"
    assert all(figure["marks"] for figure in printed)
    assert max(figure["box"]["width"] for figure in printed) >= 600
    whole = Image.open(io.BytesIO(page.screenshot(full_page=True))).convert("RGB")
    sky = part(whole, next(one["box"] for one in printed if one["name"] == "flight")).getpixel((2, 2))
    assert sky == (255, 255, 255), "paper is white, whatever the screen is"


# folders that lack something


def test_a_killed_sessions_report_says_what_it_lacks(
    flown: Outcome, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """What is on the disk after `kill -9`: no summary, and files that end anywhere."""
    folder = copied(flown, tmp_path / "killed")
    (folder / "summary.json").unlink()
    for name in ("session.tlog", "decisions.jsonl"):
        (folder / name).write_bytes((folder / name).read_bytes()[:-7])
    assert report(folder) == 0
    assert capsys.readouterr().out == f"report: {folder / 'report.html'}\n"
    top, _, _ = (folder / "report.html").read_text(encoding="utf-8").partition("<main>")
    assert "No outcome is known" in top
    assert "summary.json is missing, as after a session that was killed" in top
    assert "session.tlog ends inside a frame" in top
    assert "decisions.jsonl has 1 line that is no decision" in top
    content, _ = model(folder / "report.html")
    assert content["figures"].keys() == FIGURE_NAMES - {"ledger"}


@pytest.mark.parametrize("kept", ["session.tlog", "decisions.jsonl", "summary.json"])
def test_one_file_alone_makes_a_page(flown: Outcome, tmp_path: Path, kept: str) -> None:
    folder = copied(flown, tmp_path / "poor")
    for file in folder.iterdir():
        if file.is_file() and file.name != kept:
            file.unlink()
    page = tmp_path / "page.html"
    assert report(folder, "--out", str(page), "--quiet") == 0
    top, _, _ = page.read_text(encoding="utf-8").partition("<main>")
    assert top.count("is missing") == 3
    assert not (folder / "report.html").exists()


def test_a_page_without_figures_is_no_error(flown: Outcome, tmp_path: Path, browser: Browser) -> None:
    folder = tmp_path / "only"
    folder.mkdir()
    shutil.copy(flown.folder / "summary.json", folder)
    assert report(folder, "--quiet") == 0
    watched = Watched(browser)
    watched.report((folder / "report.html").as_uri())
    assert watched.wrong == []
    watched.page.close()


def test_what_is_no_session_is_refused_in_a_sentence(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for folder in (tmp_path, tmp_path / "none"):
        assert report(folder) == 2
        said = capsys.readouterr().err
        assert said.count("\n") == 1
        assert str(folder) in said


def test_a_report_that_cannot_be_written_fails_alone(
    flown: Outcome, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = copied(flown, tmp_path / "session")
    (folder / "report.html").mkdir()
    told: list[str] = []
    after_run(folder, told.append)
    assert [line for line in told if not line.startswith("making")] == []
    assert "warning: no report was made" in capsys.readouterr().err
    assert report(folder) == 1
    assert not list(folder.glob(".report*")), "nothing half written is left"


STOPPED_LAST = """
import os, signal, sys
from pathlib import Path
from gcs.cli.report import after_run
after_run(Path(sys.argv[1]), print, 1, last=True)
os.kill(os.getpid(), signal.SIGINT)
print("went on")
"""


def test_ctrl_c_behind_the_last_line_of_a_session_says_nothing_more(flown: Outcome, tmp_path: Path) -> None:
    folder = copied(flown, tmp_path / "session")
    words = [sys.executable, "-c", STOPPED_LAST, str(folder)]
    done = subprocess.run(words, capture_output=True, text=True, timeout=100, check=False)
    said = [line for line in done.stdout.splitlines() if not line.startswith("making")]
    assert (done.returncode, said, done.stderr) == (1, [f"report: {folder / 'report.html'}"], "")


# other programs


def test_foxglove_finds_what_it_shows_without_set_up(
    flown: Outcome, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Read by MCAP's own reader: schemas by the names that Foxglove knows, places as the vehicles knew them."""
    path = tmp_path / "session.mcap"
    assert run_argv(["export", str(flown.folder), "--format", "mcap", "--out", str(path)]) == 0
    assert capsys.readouterr().out == f"321 snapshots: {path}\n"
    truth = flown.truth(3)
    begun_ns = 1767225600 * 10**9
    with path.open("rb") as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory()])
        summary = reader.get_summary()
        assert summary is not None
        kinds = {c.topic: summary.schemas[c.schema_id].name for c in summary.channels.values()}
        assert {kinds[topic] for topic in ("/tf", "/scene", "/log", "/location/3")} == {
            "foxglove.FrameTransforms", "foxglove.SceneUpdate", "foxglove.Log", "foxglove.LocationFix"}  # fmt: skip
        assert kinds["/vehicle/3"] == "skytender.VehicleRow"
        row_schema = next(s for s in summary.schemas.values() if s.name == "skytender.VehicleRow")
        validator = jsonschema.Draft202012Validator(json.loads(row_schema.data))
        placed = []
        for _, _, message, frame in reader.iter_decoded_messages(topics=["/tf"]):
            moved = next(one for one in frame.transforms if one.child_frame_id == "vehicle_3")
            t = moved.translation
            placed.append(((message.log_time - begun_ns) / 1e9, t.y, t.x, -t.z))
        rows = [json.loads(m.data) for _, _, m in reader.iter_messages(topics=["/vehicle/3"])]
        events = [d.message for _, _, _, d in reader.iter_decoded_messages(topics=["/log"])]
        entities = [e.id for _, _, _, d in reader.iter_decoded_messages(topics=["/scene"]) for e in d.entities]
    for row in rows:
        validator.validate(row)
    at = np.array(placed)
    known = [np.interp(at[:, 0], truth.time_s, truth.p_ned[:, axis]) for axis in range(3)]
    assert at[:, 1:] == pytest.approx(np.column_stack(known), abs=0.2)
    assert any("Refuelling of" in text for text in events)
    assert {"obstacle point 1", "vehicle 3", "ring 101", "traffic NORTH1"} <= set(entities)
    assert run_argv(["export", str(flown.folder), "--format", "mcap", "--out", str(path)]) == 2
    assert "left as it is" in capsys.readouterr().err
