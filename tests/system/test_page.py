"""Recordings on the page and in reports, in Debian's Chromium; and the page as strangers and a bad line meet it."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import urlsplit

import numpy as np
import pytest
import yaml
from playwright.sync_api import Browser, expect
from sessions import Outcome, fly, merged, small
from web import Cable, Script, Watched, barriers, row, served, session, snapshot, until

from gcs.recording.importing import beside
from gcs.report.page import make
from gcs.session.replay import Replay, ReplaySource

HOSTILE = '<img src=x onerror="window.hacked=1"></script><script>window.hacked=1</script>'


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    return fly(merged(small(), {"goal": {"duration_s": 25.0}}), tmp_path_factory.mktemp("page"), "--quiet")


def test_two_recordings_are_replayed_at_the_same_time_from_the_moment_of_a_link(
    recorded: Outcome, tmp_path: Path, browser: Browser
) -> None:
    second = tmp_path / "second.tlog"
    shutil.copy(recorded.folder / "session.tlog", second)
    with beside([recorded.folder, second]) as opened, served(ReplaySource(Replay(opened.path), speed=0.1)) as links:
        watched = Watched(browser)
        page = watched.flying(links["command"] + "&t=15")
        until(page, "skytender.current.t_s >= 15 && skytender.current.t_s < 18")
        assert len(page.evaluate("skytender.current.vehicles")) == 6, "three and three"
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
        watched.well()
        page.close()


@pytest.fixture(scope="module")
def report(recorded: Outcome, browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Watched]:
    """A page whose scenario's description is a stranger's."""
    folder = tmp_path_factory.mktemp("hostile") / "session"
    shutil.copytree(recorded.folder, folder, ignore=shutil.ignore_patterns("*.sock"))
    scenario = yaml.safe_load((folder / "scenario.yaml").read_text(encoding="utf-8"))
    (folder / "scenario.yaml").write_text(yaml.safe_dump(scenario | {"description": HOSTILE}), encoding="utf-8")
    watched = Watched(browser)
    page = watched.report(make(folder).as_uri())
    assert page.evaluate("skytender.current.t_s") == 25.0
    yield watched
    assert page.evaluate("window.hacked") is None
    assert page.locator("img").count() == 0
    watched.page.close()


def test_a_report_opens_on_the_flight_at_the_moment_of_a_link(
    recorded: Outcome, tmp_path: Path, browser: Browser
) -> None:
    watched = Watched(browser, height=720)
    page = watched.report(f"{make(recorded.folder, tmp_path / 'report.html').as_uri()}#t=10")
    until(page, "Math.abs(skytender.current?.t_s - 10) < 1e-6")
    picture, verdict = page.locator(".picture").bounding_box(), page.locator(".verdict").bounding_box()
    assert picture is not None
    assert verdict is not None
    assert verdict["y"] < picture["y"] < 360
    assert picture["y"] + 0.5 * picture["height"] < 720
    page.evaluate("location.hash = 't=20'")
    until(page, "Math.abs(skytender.current.t_s - 20) < 1e-6")
    assert watched.wrong == []
    page.close()


def test_a_report_plays_from_a_file_and_fetches_nothing(report: Watched, recorded: Outcome) -> None:
    """The page's policy lets nothing but its own script run."""
    page = report.page
    page.get_by_role("slider", name="time").fill("10")
    until(page, "Math.abs(skytender.current.t_s - 10) < 1e-6")
    at = page.evaluate("skytender.current.vehicles.find((one) => one.sysid === 1)")
    truth = recorded.truth(1)
    k = int(np.searchsorted(truth.time_s, 10.0))
    assert at["p_ned"] == pytest.approx(truth.p_ned[k], abs=0.05)
    service = recorded.summary["refuelling"][0]
    assert service["start_s"] < 10.0 < service["end_s"]
    assert (at["mode_name"], at["state"]) == ("Refuel", "served")
    page.get_by_role("button", name="play", exact=True).click()
    until(page, "skytender.current.t_s > 11")
    assert page.evaluate("skytender.time.now_s > 11"), "the figures' line of time goes with it"
    page.get_by_role("button", name="pause", exact=True).click()
    report.well()
    own = urlsplit(page.url)
    assert Path(own.path).stat().st_size < 900_000
    assert [urlsplit(url).path for url in report.asked] == [own.path]
    page.evaluate("fetch('https://example.org/').then(() => { window.fetched = 1; }, () => { window.fetched = 0; })")
    until(page, "window.fetched !== undefined")
    assert page.evaluate("window.fetched") == 0, "the policy"


def test_a_second_report_is_shown_as_ghosts_at_the_same_time(
    report: Watched, recorded: Outcome, tmp_path: Path
) -> None:
    page, other, wrong = report.page, make(recorded.folder, tmp_path / "other.html"), tmp_path / "wrong.html"
    wrong.write_text("<script>window.hacked = 1</script>", encoding="utf-8")
    page.get_by_label("reports to compare with").set_input_files([other, wrong])
    expect(page.locator(".compare")).to_contain_text("In grey, ids in brackets: small, 25.0 s")
    expect(page.locator(".compare")).to_contain_text("wrong.html is no report that can be compared")
    until(page, "skytender.ghosts.length === 1 && !skytender.dirty")
    page.evaluate("[...skytender.ghosts[0].columns.values()].forEach((one) => (one.n[0] = 300))")
    page.evaluate("skytender.ghosts = [...skytender.ghosts]")
    page.keyboard.press("m")
    until(page, "!skytender.dirty && skytender.map.frame.m > 250")
    places = page.evaluate(
        "[skytender.current, skytender.ghosts[0].at(skytender.current.t_s)].map((s) => s.vehicles.map((v) => v.p_ned))"
    )
    assert places[0] == places[1], "the same flight at the same time"
    for key in ("m", "3"):
        page.keyboard.press(key)
        shot = "document.querySelector(skytender.view === 'map' ? 'canvas.map' : 'canvas.names').toDataURL()"
        until(page, "!skytender.dirty")
        ghosted = page.evaluate(shot)
        page.evaluate("(window.kept = skytender.ghosts, skytender.ghosts = [], skytender.dirty = true)")
        until(page, "!skytender.dirty")
        assert page.evaluate(shot) != ghosted, "the picture shows them"
        page.evaluate("(skytender.ghosts = window.kept, skytender.dirty = true)")
    battery = page.locator("[data-figure=battery]")
    doubled = int(battery.get_attribute("data-lines") or 0)
    page.get_by_label("reports to compare with").set_input_files([])
    expect(battery).to_have_attribute("data-lines", str(doubled // 2))
    assert doubled, "figures draw them, too"
    assert barriers(page) == []


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
        expect(page.locator(".badge:visible")).to_have_text(["not connected"])
        refused = "new Promise((done) => skytender.operator.send({command: 'hold'}, (ok, text) => done([ok, text])))"
        assert page.evaluate(refused) == [False, "There is no connection: it was not sent."]
        source.feed(snapshot(2.0, rows, {**event, "t_s": 2.0, "text": "meanwhile"}))
        cable.mend()
        until(page, "skytender.current.t_s === 2")
        expect(page.get_by_role("alert")).to_be_hidden()
        expect(page.locator(".badge:visible")).to_have_text(["live", "flying 0:02.0 of 2:00.0"])
        assert page.evaluate("skytender.flight.events.map((e) => e.text)") == ["before", "meanwhile"]
        page.close()
        cable.close()


LATER = """(() => {
  const now = performance.now.bind(performance);
  window.later_ms = 0;
  performance.now = () => now() + window.later_ms;
})()"""
"""Lets a test move a page's clock on."""


def test_a_session_that_says_nothing_is_shown_so(browser: Browser) -> None:
    """As in the console's header: `flying` and a speed are no longer known."""
    rows = [row(1, 0.0)]
    source = Script(session(rows), snapshot(1.0, rows))
    with served(source) as links:
        watched = Watched(browser)
        watched.page.add_init_script(LATER)
        page = watched.flying(links["command"])
        badges, speed = page.locator(".badge:visible"), page.locator(".time-line .value").first
        expect(badges).to_have_text(["live", "flying 0:01.0 of 2:00.0"])
        expect(speed).to_have_text("×1.0")
        calm = page.get_by_text("All well")
        expect(calm).to_be_visible()
        page.evaluate("window.later_ms = 900e3")
        expect(badges).to_have_text([re.compile(r"no news for 9\d\d s")])
        expect(speed).to_have_text("")
        expect(calm).to_be_hidden()
        source.feed(snapshot(2.0, rows))
        expect(badges).to_have_text(["live", "flying 0:02.0 of 2:00.0"])
        expect(speed).to_have_text("×1.0")
        expect(calm).to_be_visible()
        assert watched.wrong == []
        page.close()


def test_a_session_that_broke_off_is_shown_so(browser: Browser) -> None:
    """With its reason; it is neither live, nor flying, nor well, and takes no order."""
    rows = [row(1, 0.0)]
    source = Script(session(rows), snapshot(1.0, rows))
    with served(source) as links:
        watched = Watched(browser)
        page = watched.flying(links["command"])
        badges, calm = page.locator(".badge:visible"), page.get_by_text("All well")
        expect(badges).to_have_text(["live", "flying 0:01.0 of 2:00.0"])
        expect(calm).to_be_visible()
        why = "no HEARTBEAT of pursuer 5 within 12 s"
        source.feed({"type": "end", "outcome": None, "text": why, "exit": 1})
        expect(page.get_by_role("alert")).to_have_text(
            f"The session has broken off: {why}. The page keeps what it has seen. Open the report"
        )
        expect(page.get_by_role("link", name="Open the report")).to_be_hidden()
        expect(badges).to_have_text(["broken off"])
        expect(page.locator(".time-line .value").first).to_have_text("")
        expect(calm).to_be_hidden()
        assert watched.wrong == []
        page.close()


def test_a_session_that_has_ended_has_one_result_and_takes_no_order(browser: Browser) -> None:
    rows = [row(1, 0.0), row(5, 0.0)]
    told = snapshot(2.0, rows)
    told["goal"]["broken"] = [{"part": "lost", "text": "lost 1 (5 at 20.3 s: crashed)", "t_s": 20.3}]
    source = Script(session(rows), told)
    with served(source) as links:
        watched = Watched(browser)
        page = watched.flying(links["command"])
        expect(page.locator(".goal-line")).to_have_text("1 goal failed: lost 1 (5 at 20.3 s: crashed). ")
        result = "not met: lost 2 (5 at 20.3 s: crashed; 1 at 75.0 s: never in the air)"
        page.evaluate("skytender.choose(5)")
        page.keyboard.press("Shift+H")
        expect(page.get_by_role("dialog")).to_be_visible()
        source.feed({**told, "phase": "ended"}, {"type": "end", "outcome": "lost", "text": result, "exit": 1})
        expect(page.get_by_role("alert")).to_contain_text(f"The session has ended: {result}. The page keeps")
        expect(page.locator(".goal-line")).to_have_text("")
        expect(page.locator(".badge:visible")).to_have_text(["ended 0:02.0 of 2:00.0"])
        page.get_by_role("button", name="Yes").click()
        notices = page.locator(".notices p")
        late = "hold pursuer 5: The session has ended: it was not sent."
        expect(notices.last).to_have_text(late)
        assert notices.all_inner_texts() == [late]
        page.keyboard.press("Shift+H")
        expect(notices).to_have_text([late, "The session has ended: it takes no commands."])
        expect(page.get_by_role("dialog")).to_be_hidden()
        assert source.sent == []
        assert watched.wrong == []
        page.close()


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
    texts = dict.fromkeys(("label", "mode", "mode_name", "state", "note", "figure"), HOSTILE)
    rows = [row(1, 0.0, role="target", trouble=[HOSTILE], severity=2, condition="failing", **texts)]
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
