"""The page in Debian's Chromium: a session that is flown and commanded, a replay, 254 vehicles, and what goes wrong."""

from __future__ import annotations

import io
import json
import math
import re
import shutil
import signal
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import numpy as np
import pymap3d
import pytest
import yaml
from PIL import Image
from playwright.sync_api import Browser, Page, Route, expect
from sessions import Outcome, Running, merged, small
from web import CHROMIUM, MISSING, Cable, Script, Watched, barriers, chromium, row, served, session, snapshot, until

from gcs.recording.importing import beside
from gcs.report.page import make
from gcs.session.replay import Replay, ReplaySource
from gcs.web.hub import READ_ONLY

pytestmark = pytest.mark.skipif(CHROMIUM is None, reason=MISSING)
HOSTILE = '<img src=x onerror="window.hacked=1"></script><script>window.hacked=1</script>'


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with chromium() as browser:
        yield browser


def chosen(page: Page) -> Any:
    return page.evaluate("skytender.chosen")


def test_a_flight_is_watched_commanded_and_ended_from_the_page(tmp_path: Path, browser: Browser) -> None:
    content = small(clock={"mode": "real", "speed": 4.0}, goal={"duration_s": 600.0, "refuelled_at_least": 0})
    running = Running(content, tmp_path, "--web")
    try:
        said = "".join(line for _, line in zip(range(3), running.lines(), strict=False))
        command, view = re.findall(r"http://127\.0\.0\.1:\d+/#token=\S+", said)
        first, second = Watched(browser), Watched(browser, width=420, height=900, dark=True)
        page, other = first.flying(command), second.flying(view)
        until(page, "skytender.current.vehicles.every((v) => v.mode === 'offboard')")
        live = page.get_by_role("button", name="live", exact=True)
        place = live.bounding_box()
        page.get_by_role("button", name="1", exact=True).first.click()
        assert chosen(page) == 1
        page.get_by_role("button", name="hold", exact=True).click()
        dialog = page.get_by_role("dialog")
        expect(dialog).to_contain_text("Let pursuer 1 hold its position?")
        dialog.get_by_role("button", name="Yes").click()
        expect(page.get_by_role("status")).to_contain_text("hold pursuer 1: sent")
        expect(page.locator(".notices .good")).to_contain_text("hold pursuer 1:")
        for seen in (page, other):  # the other is told too
            until(seen, "skytender.flight.events.some((e) => /operator/i.test(e.text + e.kind))")
        expect(other.get_by_role("button", name="hold", exact=True)).to_be_hidden()
        refused = "new Promise((done) => skytender.operator.send({command: 'stop'}, (ok, text) => done([ok, text])))"
        assert other.evaluate(refused) == [False, READ_ONLY]
        # back in time, and to the newest again
        past_s = page.evaluate("(skytender.player.seek(skytender.flight.first_s + 1), skytender.at_s)")
        until(page, f"Math.abs(skytender.current.t_s - {past_s}) < 0.01")
        live.click()
        until(page, f"skytender.current.t_s > {past_s} + 2")
        until(page, "skytender.strip.element.textContent.includes('Low battery: 1 (')")
        assert live.bounding_box() == place, "trouble moves no button away from under the pointer"
        assert barriers(page) == []
        page.get_by_role("button", name="stop").click()
        page.get_by_role("dialog").get_by_role("button", name="Yes").click()
        for seen in (page, other):
            expect(seen.get_by_role("alert")).to_contain_text("The session has ended: interrupted")
        assert running.process.stderr is not None
        assert "the page stays" in running.process.stderr.readline()
        running.process.send_signal(signal.SIGINT)
        outcome = running.finish()
    finally:
        running.stop()
    assert outcome.status in (1, 130)
    orders = [d["command"] for d in outcome.decisions if d["kind"] == "operator"]
    assert orders == ["hold", "stop"]
    assert first.wrong == second.wrong == []
    port = urlsplit(command).port
    assert {urlsplit(url).port for url in first.asked if url.startswith("http")} == {port}, "nothing from elsewhere"
    first.page.close()
    second.page.close()


def test_a_narrow_dark_page_that_only_looks_on_is_accessible(browser: Browser) -> None:
    rows = [row(sysid, 0.0) for sysid in (1, 2, 3)]
    rows[1] |= {"trouble": ["battery 4 %"], "severity": 2, "condition": "low", "figure": "4 %", "battery": 0.04}
    with served(Script(session(rows), snapshot(1.0, rows))) as links:
        watched = Watched(browser, width=420, height=900, dark=True)
        page = watched.flying(links["view"])
        expect(page.get_by_label("trouble", exact=True)).to_contain_text("Low battery: 2 (4 % left)")
        expect(page.get_by_role("button", name="hold", exact=True)).to_be_hidden()
        assert barriers(page) == []
        assert watched.wrong == []
        page.close()


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    from sessions import fly  # noqa: PLC0415 - beside its only use

    return fly(merged(small(), {"goal": {"duration_s": 25.0}}), tmp_path_factory.mktemp("page"), "--quiet")


def test_the_slider_moves_a_replay(recorded: Outcome, browser: Browser) -> None:
    with served(ReplaySource(Replay(recorded.folder), speed=0.5)) as links:
        watched = Watched(browser)
        page = watched.flying(links["command"])
        until(page, "skytender.end_s > 20")
        slider = page.get_by_role("slider", name="time")
        slider.fill("20")
        until(page, "skytender.current.t_s >= 20")
        late = page.evaluate("skytender.current.vehicles[0].battery")
        slider.fill("5")
        until(page, "skytender.current.t_s >= 5 && skytender.current.t_s < 8")
        assert page.evaluate("skytender.current.vehicles[0].battery") != late
        page.keyboard.press("Escape")
        page.locator("h1").click()
        page.keyboard.press("Space")
        until(page, "skytender.current.phase === 'paused'")
        expect(page.get_by_role("button", name="hold", exact=True)).to_be_hidden()
        page.keyboard.press("m")
        expect(page.locator("canvas.map")).to_be_visible()
        page.keyboard.press("?")
        expect(page.get_by_role("dialog", name="keys")).to_be_visible()
        page.keyboard.press("Escape")
        assert barriers(page) == []
        assert watched.wrong == []
        page.close()


def test_the_report_plays_from_a_file_and_fetches_nothing(recorded: Outcome, tmp_path: Path, browser: Browser) -> None:
    """The scenario's name and description are a stranger's; the page's policy lets nothing but its own script run."""
    folder = tmp_path / "hostile"
    shutil.copytree(recorded.folder, folder, ignore=shutil.ignore_patterns("*.sock"))
    scenario = yaml.safe_load((folder / "scenario.yaml").read_text(encoding="utf-8"))
    (folder / "scenario.yaml").write_text(yaml.safe_dump(scenario | {"description": HOSTILE}), encoding="utf-8")
    page_file = make(folder)
    assert page_file.stat().st_size < 900_000
    watched = Watched(browser)
    page = watched.open(page_file.as_uri())
    until(page, "document.documentElement.dataset.all")
    page.evaluate("skytender.then((app) => { window.app = app; })")
    assert page.evaluate("app.current.t_s") == 25.0
    page.get_by_role("slider", name="time").fill("10")
    until(page, "Math.abs(app.current.t_s - 10) < 1e-6")
    at = page.evaluate("app.current.vehicles.find((one) => one.sysid === 1)")
    truth = recorded.truth(1)
    k = int(np.searchsorted(truth.time_s, 10.0))
    assert at["p_ned"] == pytest.approx(truth.p_ned[k], abs=0.05)
    service = recorded.summary["refuelling"][0]
    assert service["start_s"] < 10.0 < service["end_s"]
    assert (at["mode"], at["state"]) == ("refuel", "served")
    page.get_by_role("button", name="play", exact=True).click()
    until(page, "app.current.t_s > 11")
    assert page.evaluate("app.time.now_s > 11"), "the figures' line of time goes with it"
    assert page.evaluate("window.hacked") is None
    assert page.locator("img").count() == 0
    assert barriers(page) == []
    assert watched.wrong == []
    assert watched.asked == [page_file.as_uri()]
    page.evaluate("fetch('https://example.org/').then(() => { window.fetched = 1; }, () => { window.fetched = 0; })")
    until(page, "window.fetched !== undefined")
    assert page.evaluate("window.fetched") == 0, "the policy"
    page.close()


def test_report_and_replay_open_on_the_flight_at_the_moment_of_a_link(
    recorded: Outcome, tmp_path: Path, browser: Browser
) -> None:
    page_file = make(recorded.folder, tmp_path / "report.html")
    watched = Watched(browser, height=720)
    page = watched.open(f"{page_file.as_uri()}#t=10")
    until(page, "document.documentElement.dataset.all")
    page.evaluate("skytender.then((app) => { window.app = app; })")
    until(page, "Math.abs(app.current?.t_s - 10) < 1e-6")
    picture, verdict = page.locator(".picture").bounding_box(), page.locator(".verdict").bounding_box()
    assert picture is not None
    assert verdict is not None
    assert verdict["y"] < picture["y"] < 360
    assert picture["y"] + 0.5 * picture["height"] < 720
    page.evaluate("location.hash = 't=20'")
    until(page, "Math.abs(app.current.t_s - 20) < 1e-6")
    assert barriers(page) == []
    assert watched.wrong == []
    page.close()
    with served(ReplaySource(Replay(recorded.folder), speed=0.1)) as links:
        watched = Watched(browser)
        page = watched.flying(links["command"] + "&t=15")
        until(page, "skytender.current.t_s >= 15 && skytender.current.t_s < 18")
        assert watched.wrong == []
        page.close()


def test_a_second_report_is_shown_as_ghosts_at_the_same_time_and_two_recordings_in_one_replay(
    recorded: Outcome, tmp_path: Path, browser: Browser
) -> None:
    one, other = make(recorded.folder, tmp_path / "one.html"), make(recorded.folder, tmp_path / "other.html")
    watched = Watched(browser)
    page = watched.open(f"{one.as_uri()}#t=10")
    until(page, "document.documentElement.dataset.all")
    page.evaluate("skytender.then((app) => { window.app = app; })")
    wrong = tmp_path / "wrong.html"
    wrong.write_text("<script>window.hacked = 1</script>", encoding="utf-8")
    page.get_by_label("reports to compare with").set_input_files([other, wrong])
    expect(page.locator(".compare")).to_contain_text("In grey, ids in brackets: small, 25.0 s")
    expect(page.locator(".compare")).to_contain_text("wrong.html is no report that can be compared")
    until(page, "app.ghosts.length === 1 && !app.dirty")
    far = "[...app.ghosts[0].columns.values()].forEach((one) => (one.n[0] = 300)); app.ghosts = [...app.ghosts];"
    page.evaluate(far)
    page.keyboard.press("m")
    until(page, "!app.dirty && app.map.frame.m > 250")
    places = page.evaluate(
        "[app.current, app.ghosts[0].at(app.current.t_s)].map((s) => s.vehicles.map((v) => v.p_ned))"
    )
    assert places[0] == places[1], "the same flight at the same time"
    for key in ("m", "3"):
        page.keyboard.press(key)
        shot = "document.querySelector(app.view === 'map' ? 'canvas.map' : 'canvas.names').toDataURL()"
        until(page, "!app.dirty")
        ghosted = page.evaluate(shot)
        page.evaluate("(window.kept = app.ghosts, app.ghosts = [], app.dirty = true)")
        until(page, "!app.dirty")
        assert page.evaluate(shot) != ghosted, "the picture shows them"
        page.evaluate("(app.ghosts = window.kept, app.dirty = true)")
    battery = page.locator("[data-figure=battery]")
    doubled = int(battery.get_attribute("data-lines") or 0)
    page.get_by_label("reports to compare with").set_input_files([])
    expect(battery).to_have_attribute("data-lines", str(doubled // 2))
    assert doubled, "figures draw them, too"
    assert page.evaluate("window.hacked") is None
    assert barriers(page) == []
    assert watched.wrong == []
    page.close()
    second = tmp_path / "second.tlog"
    shutil.copy(recorded.folder / "session.tlog", second)
    with beside([recorded.folder, second]) as opened, served(ReplaySource(Replay(opened.path), speed=0.1)) as links:
        watched = Watched(browser)
        page = watched.flying(links["command"] + "&t=15")
        until(page, "skytender.current.t_s >= 15 && skytender.current.t_s < 18")
        assert len(page.evaluate("skytender.current.vehicles")) == 6, "three and three, at the same time"
        assert watched.wrong == []
        page.close()


def test_254_vehicles_are_filtered_counted_and_gone_to(browser: Browser) -> None:
    rows = [row(sysid, 0.0) for sysid in range(1, 255)]
    rows[199] |= {"trouble": ["battery 4 %"], "severity": 2, "condition": "low", "figure": "4 %", "battery": 0.04}
    source = Script(session(rows), snapshot(1.0, rows), snapshot(2.0, [row(r["sysid"], 1.0) | r for r in rows]))
    with served(source) as links:
        watched = Watched(browser)
        page = watched.flying(links["command"])
        expect(page.locator(".totals")).to_have_text("254 vehicles: 254 offboard")
        expect(page.get_by_label("trouble", exact=True)).to_contain_text("Low battery: 200 (4 % left)")
        assert "1 below 20 %" in (page.locator(".histogram").get_attribute("aria-label") or "")
        page.get_by_label("filter vehicles").fill("25")
        assert page.locator("table.fleet tbody tr:visible").count() == 6, "25, and 250 to 254"
        page.get_by_label("filter vehicles").fill("")
        page.get_by_label("go to vehicle").fill("200")
        page.get_by_role("button", name="go to").click()
        assert chosen(page) == 200
        expect(page.locator(".vehicle-page")).to_contain_text("pursuer 200")
        assert page.evaluate("skytender.map.follow"), "the picture goes there too"
        assert barriers(page) == []
        assert watched.wrong == []
        page.close()


def test_tiles_lie_under_the_map_where_they_belong_and_the_wind_is_shown(browser: Browser) -> None:
    lat, lon = 47.397742, 8.545594
    rows = [row(1, 0.0, p_ned=[400.0, -300.0, -5.0]), row(2, 0.0, p_ned=[-350.0, 250.0, -5.0])]
    told = session(rows, origin=[lat, lon, 400.0], wind={"speed_m_s": 6.0, "from_deg": 250.0})
    asked: list[tuple[int, int, int]] = []

    def tile(route: Route) -> None:
        z, x, y = (int(word) for word in route.request.url.removeprefix("https://tiles.example/").split("/"))
        asked.append((z, x, y))
        picture = io.BytesIO()
        Image.new("RGB", (256, 256), shade(x, y)).save(picture, "PNG")
        route.fulfill(body=picture.getvalue(), content_type="image/png")

    def shade(x: int, y: int) -> tuple[int, int, int]:
        return 40 * (x % 6), 40 * (y % 6), 255

    with served(Script(told, snapshot(1.0, rows)), "https://tiles.example/{z}/{x}/{y}") as links:
        watched = Watched(browser)
        watched.page.route("https://tiles.example/**", tile)
        page = watched.flying(links["command"])
        expect(page.locator(".wind")).to_have_text("wind 6.0 m/s from 250°")
        page.keyboard.press("m")
        pictures = "[...skytender.map.tiles.kept.values()]"
        until(page, f"skytender.map.tiles.kept.size > 0 && {pictures}.every((one) => one.complete)")
        until(page, "!skytender.map.dirty && !skytender.dirty")
        seen = Image.open(io.BytesIO(page.locator("canvas.map").screenshot())).convert("RGB")
        frame = page.evaluate("skytender.map.frame")
        ((z, *_), *_) = asked
        for north, east in ((130.0, -170.0), (-210.0, 90.0), (20.0, 205.0), (-333.0, -140.0)):
            there_lat, there_lon, _ = pymap3d.ned2geodetic(north, east, 0.0, lat, lon, 400.0)
            # The tile of a place: https://wiki.openstreetmap.org/wiki/Slippy_map_tilenames
            across = (there_lon + 180.0) / 360.0 * 2**z
            s = math.sin(math.radians(there_lat))
            down = (0.5 - math.log((1.0 + s) / (1.0 - s)) / (4.0 * math.pi)) * 2**z
            assert min(across % 1.0, 1.0 - across % 1.0, down % 1.0, 1.0 - down % 1.0) > 0.02, "at no tile's edge"
            x = round(frame["width"] / 2 + (east - frame["e"]) * frame["perMetre"])
            y = round(frame["height"] / 2 - (north - frame["n"]) * frame["perMetre"])
            assert seen.getpixel((x, y)) == shade(int(across), int(down)), (north, east)
        assert barriers(page) == []
        assert watched.wrong == []
        page.close()


def test_a_page_of_another_origin_cannot_reach_the_stream(browser: Browser) -> None:
    rows = [row(1, 0.0)]
    with served(Script(session(rows, name="secret"), snapshot(1.0, rows))) as links:
        token, port = urlsplit(links["command"]).fragment.removeprefix("token="), urlsplit(links["command"]).port
        page = browser.new_page()
        page.route("http://evil.example/", lambda route: route.fulfill(body="<p>evil</p>", content_type="text/html"))
        page.goto("http://evil.example/")
        opened = page.evaluate(
            f"""new Promise((done) => {{
              const socket = new WebSocket("ws://127.0.0.1:{port}/stream", ["skytender", "token.{token}"]);
              socket.onmessage = (event) => done(event.data);
              socket.onerror = () => done("refused");
            }})"""
        )
        assert opened == "refused"
        read = page.evaluate(f"fetch('http://127.0.0.1:{port}/').then((r) => r.text(), () => 'refused')")
        assert read == "refused"
        page.close()


def test_a_lost_connection_is_told_and_comes_back_with_what_was_missed(browser: Browser) -> None:
    rows = [row(1, 0.0)]
    event = {"sysid": 1, "level": "info", "kind": "text"}
    source = Script(session(rows), snapshot(1.0, rows, {**event, "t_s": 1.0, "text": "before"}))
    with served(source) as links:
        cable = Cable(urlsplit(links["command"]).port or 0)
        watched = Watched(browser)
        page = watched.flying(links["command"].replace(f":{urlsplit(links['command']).port}", f":{cable.port}"))
        cable.cut()
        expect(page.get_by_role("alert")).to_contain_text("The connection is lost")
        refused = "new Promise((done) => skytender.operator.send({command: 'hold'}, (ok, text) => done([ok, text])))"
        assert page.evaluate(refused) == [False, "There is no connection: it was not sent."]
        source.tell(snapshot(2.0, rows, {**event, "t_s": 2.0, "text": "meanwhile"}))
        cable.mend()
        until(page, "skytender.current.t_s === 2")
        expect(page.get_by_role("alert")).to_be_hidden()
        assert page.evaluate("skytender.flight.events.map((e) => e.text)") == ["before", "meanwhile"]
        page.close()
        cable.close()


def test_a_link_without_its_token_shows_nothing(browser: Browser) -> None:
    rows = [row(1, 0.0)]
    with served(Script(session(rows, name="secret"), snapshot(1.0, rows))) as links:
        for link in (links["command"].partition("#")[0], links["command"][:-1]):
            watched = Watched(browser)
            page = watched.open(link)
            expect(page.get_by_role("alert")).to_contain_text("lacks its token")
            assert "secret" not in page.content()
            assert page.evaluate("skytender.flight.count") == 0
            page.close()


def test_hostile_names_and_texts_are_shown_as_text(browser: Browser) -> None:
    rows = [
        row(
            1,
            0.0,
            label=HOSTILE,
            role="target",
            mode=HOSTILE,
            state=HOSTILE,
            note=HOSTILE,
            trouble=[HOSTILE],
            severity=2,
            condition="failing",
            figure=HOSTILE,
        )
    ]
    event = {"t_s": 1.0, "sysid": 1, "level": "warning", "kind": "text", "text": HOSTILE}
    with served(Script(session(rows, name=HOSTILE), snapshot(1.0, rows, event))) as links:
        watched = Watched(browser)
        page = watched.flying(links["command"])
        page.get_by_role("button", name="1", exact=True).first.click()
        page.get_by_role("button", name="hold", exact=True).click()
        expect(page.get_by_role("dialog")).to_contain_text("onerror")
        page.get_by_role("dialog").get_by_role("button", name="No").click()
        expect(page.locator("h1")).to_have_text(HOSTILE)
        assert page.evaluate("window.hacked") is None
        assert page.locator("img").count() == 0
        assert watched.wrong == []
        assert json.dumps(HOSTILE)[1:-1] not in page.evaluate("document.getElementById('config').textContent")
        page.close()
