"""Orders from the page to a real session, in Debian's Chromium: from table, map and space, to a selection and to all;
a second page that looks on; then the page after the session's end. One session for all; the tests are its parts."""

from __future__ import annotations

import re
import signal
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import Browser, Locator, Page, expect
from sessions import Running, small
from web import Watched, barriers, drawn, selected, until

from gcs.web.hub import READ_ONLY

SEPARATION_M = 0.6
BOXES = 5


class Flying(NamedTuple):
    """A session under way, and its page."""

    running: Running
    watched: Watched
    link: str
    view: str


def scenario() -> dict[str, Any]:
    content = small(
        clock={"mode": "real", "speed": 4.0},
        goal={"duration_s": 1200.0, "refuelled_at_least": 0},
        planner={"separation_m": SEPARATION_M},
        refuelling={"enabled": False},
    )
    charged = {"capacity_j": 90_000}
    content["vehicles"]["pursuers"] = [
        {"sysid": k, "start_m": [2.0, 3.0 * (k - 1), 0.0], "battery": charged} for k in (1, 2, 3)
    ]
    return content


@pytest.fixture(scope="module")
def flying(tmp_path_factory: pytest.TempPathFactory, browser: Browser) -> Iterator[Flying]:
    running = Running(scenario(), tmp_path_factory.mktemp("orders"), "--web", report=True)
    try:
        said = "".join(line for _, line in zip(range(3), running.lines(), strict=False))
        link, view = re.findall(r"http://127\.0\.0\.1:\d+/#token=\S+", said)
        watched = Watched(browser, height=900)
        until(watched.flying(link), "skytender.current.vehicles.every((v) => v.mode === 'offboard')")
        yield Flying(running, watched, link, view)
    finally:
        running.stop()


def mode(page: Page, wanted: str, *sysids: int) -> None:
    rows = f"skytender.current.vehicles.filter((v) => {list(sysids)}.includes(v.sysid))"
    until(page, f"{rows}.every((v) => v.mode === '{wanted}')")


def choose(page: Page, sysid: int) -> None:
    """Click a vehicle in the table, wherever its row moves with its troubles, and wait until the page has taken that:
    an order goes to what was chosen before."""
    page.locator("table.fleet").get_by_role("button", name=str(sysid), exact=True).dispatch_event("click")
    selected(page, sysid)


def asked(page: Page, button: str) -> Locator:
    page.get_by_role("button", name=button, exact=True).click()
    return page.get_by_role("dialog")


def answered(page: Page, text: str, level: str = "good") -> None:
    page.get_by_role("dialog").get_by_role("button", name="Yes").click()
    expect(page.locator(f".notices .{level}", has_text=text).last).to_be_visible()


def around(page: Page, *sysids: int) -> tuple[float, float, float, float]:
    """A box on the page around vehicles as the picture shows them: left, top, right, bottom. It stays inside the
    picture, as a drag that begins beside the picture draws no box."""
    drawn(page, page.evaluate("skytender.view"))
    at = page.locator(".picture").bounding_box()
    assert at is not None
    places = [one for one in page.evaluate("skytender.places") if one["sysid"] in sysids]
    (x0, x1), (y0, y1) = [(at[edge] + 1, at[edge] + at[span] - 1) for edge, span in (("x", "width"), ("y", "height"))]
    xs, ys = [at["x"] + one["x"] for one in places], [at["y"] + one["y"] for one in places]
    return max(min(xs) - 12, x0), max(min(ys) - 12, y0), min(max(xs) + 12, x1), min(max(ys) + 12, y1)


def drag(page: Page, box: tuple[float, float, float, float]) -> None:
    page.keyboard.down("Shift")
    page.mouse.move(*box[:2])
    page.mouse.down()
    page.mouse.move(*box[2:], steps=3)
    page.mouse.up()
    page.keyboard.up("Shift")


def selection(page: Page) -> list[int]:
    return sorted(page.evaluate("[...skytender.selected]"))


def draw_box(page: Page, *sysids: int) -> None:
    """Drag a box around vehicles in the picture of ten seconds ago, in which they stand still: at four times real time
    they fly out of a box before a busy machine has drawn it. The view still makes room for what is flown meanwhile; a
    box that missed for that is drawn again."""
    page.keyboard.press("ArrowLeft")
    until(page, "skytender.at_s !== null")
    for _ in range(BOXES):
        drag(page, around(page, *sysids))
        if set(sysids) <= set(selection(page)):
            break
    else:
        pytest.fail(f"{BOXES} boxes around {sysids} selected {selection(page)} of {page.evaluate('skytender.places')}")
    page.keyboard.press("End")
    until(page, "skytender.at_s === null")


def test_an_order_from_the_table_is_sent_acknowledged_and_obeyed(flying: Flying) -> None:
    page = flying.watched.page
    choose(page, 2)
    page.keyboard.press("Shift+H")
    expect(page.get_by_role("dialog")).to_contain_text("Let pursuer 2 hold its position?")
    answered(page, "hold pursuer 2: Pursuer 2 holds where it is until it rejoins.")
    mode(page, "hold", 2)
    expect(page.locator("table.fleet tbody tr", has_text="taken by the operator")).to_have_count(1)


def test_who_looks_on_is_told_of_it_and_may_send_nothing(flying: Flying) -> None:
    browser = flying.watched.page.context.browser
    assert browser is not None
    other = Watched(browser, width=420, height=900, dark=True)
    page = other.flying(flying.view)
    until(page, "skytender.flight.events.some((e) => /operator/i.test(e.text + e.kind))")
    expect(page.get_by_role("button", name="hold", exact=True)).to_be_hidden()
    refused = "new Promise((done) => skytender.operator.send({command: 'stop'}, (ok, text) => done([ok, text])))"
    assert page.evaluate(refused) == [False, READ_ONLY]
    assert other.wrong == []
    page.close()


def test_an_order_that_makes_no_sense_is_refused_with_its_reason(flying: Flying) -> None:
    page = flying.watched.page
    choose(page, 1)
    asked(page, "rejoin")
    answered(page, "Pursuer 1 flies by the plan already.", "bad")


def test_vehicles_in_a_box_on_the_map_are_given_one_order(flying: Flying) -> None:
    page = flying.watched.page
    page.keyboard.press("Escape")
    page.keyboard.press("m")
    draw_box(page, 1, 2)
    assert page.evaluate("skytender.map.view") is None, "the map has not moved"
    count = len(selection(page))
    dialog = asked(page, "hold")
    expect(dialog).to_contain_text(f"Hold {count} vehicles?")
    expect(dialog.get_by_role("listitem")).to_have_text("pursuer 2 is taken by the operator already (Hold).")
    answered(page, f"hold: {count} of {count} obey.")
    mode(page, "hold", 1, 2)


def test_vehicles_in_a_box_in_space_are_given_one_order(flying: Flying) -> None:
    page = flying.watched.page
    page.keyboard.press("3")
    page.keyboard.press("Escape")
    draw_box(page, 1, 2, 3, 101, 201)
    selected(page, 1, 2, 3, 101, 201)
    asked(page, "land")
    answered(page, "land: 5 of 5 obey.")
    until(page, "skytender.current.vehicles.every((v) => !v.armed && v.landed)")
    dialog = asked(page, "all: hold")
    expect(dialog).to_contain_text("5 take the order, but:")
    expect(dialog.get_by_role("listitem").first).to_have_text("pursuer 1 is on the ground and stays there.")
    dialog.get_by_role("button", name="No").click()


def test_all_come_home_but_the_dead_and_plan_b_keeps_them_apart(flying: Flying) -> None:
    page = flying.watched.page
    page.keyboard.press("Escape")
    for sysid in (1, 2):
        choose(page, sysid)
        asked(page, "rejoin")
        answered(page, f"rejoin pursuer {sysid}: Pursuer {sysid} takes off and flies by the plan again.")
    mode(page, "offboard", 1, 2)
    flying.running.vehicle(3).kill()
    expect(page.get_by_label("trouble", exact=True)).to_contain_text("Dead: 3")
    dialog = asked(page, "all: return")
    expect(dialog).to_contain_text("Return all 5 vehicles?")
    expect(dialog.get_by_role("listitem").first).to_have_text("pursuer 3 is dead.")
    plans = dict(re.findall(r"^(\d+)\s+straight home at (\d+\.\d) m", dialog.locator("table").inner_text(), re.M))
    assert set(plans) == {"1", "2", "3", "101", "201"}
    heights = sorted(map(float, plans.values()))
    assert min(b - a for a, b in pairwise(heights)) >= SEPARATION_M, "their ways meet"
    assert barriers(page) == []
    answered(page, "return: 4 of 4 obey.")
    until(page, "skytender.current.vehicles.filter((v) => v.alive).every((v) => v.mode === 'return' || v.landed)")


def test_after_the_end_the_page_stays_and_opens_the_report(flying: Flying) -> None:
    page = flying.watched.page
    asked(page, "stop").get_by_role("button", name="Yes").click()
    expect(page.get_by_role("alert")).to_contain_text("The session has ended: interrupted")
    link = page.get_by_role("link", name="Open the report")
    expect(link).to_be_visible()
    expect(page.get_by_role("button", name="all: return")).to_be_hidden()
    with page.context.expect_page() as opened:
        link.click()
    report = opened.value
    expect(report.locator(".verdict").first).to_contain_text("The session was interrupted")
    until(report, "document.documentElement.dataset.all")
    late = Watched(page.context.browser)  # type: ignore[arg-type]
    late.open(flying.link)
    expect(late.page.get_by_role("link", name="Open the report")).to_be_visible()
    guess = late.page.request.get(f"http://127.0.0.1:{urlsplit(flying.link).port}/report/guessed")
    assert guess.status == 404
    assert flying.watched.wrong == late.wrong == []
    served_by = {urlsplit(url).port for url in flying.watched.asked if url.startswith("http")}
    assert served_by == {urlsplit(flying.link).port}, "nothing from elsewhere"
    late.page.close()


def test_ctrl_c_ends_the_page_that_stayed(flying: Flying) -> None:
    flying.running.process.send_signal(signal.SIGINT)
    outcome = flying.running.finish()
    assert outcome.status == 130, "of the session, which was stopped"
    assert "the page stays, with the report; Ctrl-C ends it" in outcome.stderr
    orders = [(d["command"], d.get("sysid"), d["taken"]) for d in outcome.decisions if d["kind"] == "operator"]
    assert ("rejoin", 1, False) in orders
    assert [command for command, *_ in orders].count("stop") == 1, "the page that looked on has stopped nothing"
    assert [sysid for command, sysid, _ in orders if command == "return"] == [1, 2, 101, 201]
    assert Path(outcome.folder, "report.html").is_file()
