"""Several vehicles at once on the page, in Debian's Chromium: selected in table and picture, and given one order. The
tests share a page."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import pytest
from patience import PATIENCE_S
from playwright.sync_api import Browser, Page, expect
from web import Script, Watched, drawn, row, selected, served, session, snapshot, until


class Refusing(Script):
    """A session in which vehicle 2 obeys nothing."""

    def send(self, command: Mapping[str, Any]) -> None:
        if command.get("sysid") == 2:
            self.sent.append(command)
            self.feed({"type": "reply", "id": command["id"], "ok": False, "text": "Pursuer 2 is busy."})
        else:
            super().send(command)


def selection(page: Page) -> list[int]:
    return sorted(page.evaluate("[...skytender.selected]"))


def until_sent(page: Page, source: Refusing, count: int) -> None:
    """Wait until so many commands have come."""
    over_s = time.monotonic() + PATIENCE_S
    while len(source.sent) < count and time.monotonic() < over_s:
        page.wait_for_timeout(20.0)


def fleet() -> list[dict[str, Any]]:
    """Of seven vehicles 7 is dead, and 6 has never been heard."""
    dead = {"alive": False, "condition": "dead", "figure": "9 s", "severity": 2, "trouble": ["dead"]}
    unheard = {
        "heard_s": None,
        "condition": "silent",
        "figure": "none yet",
        "severity": 1,
        "trouble": ["no telemetry yet"],
    }
    return [row(sysid, 0.0, **{7: dead, 6: unheard}.get(sysid, {}), role="pursuer") for sysid in range(1, 8)]


class Showing(NamedTuple):
    """What a source sends, and the page that shows it."""

    source: Refusing
    watched: Watched


@pytest.fixture(scope="module")
def showing(browser: Browser) -> Iterator[Showing]:
    rows = fleet()
    plan = {"return_m": 12.5, "level_after_s": 9.0, "down_after_s": 30.0}
    told = session(rows)
    told["vehicles"] = [one | ({"plan_b": plan} if one["sysid"] < 6 else {}) for one in told["vehicles"]]
    source = Refusing(told, snapshot(1.0, rows))
    with served(source) as links:
        watched = Watched(browser)
        until(watched.flying(links["command"]), "document.querySelectorAll('table.fleet tbody tr').length === 7")
        yield Showing(source, watched)
        assert watched.wrong == []


def test_several_are_selected_and_ordered_with_one_confirmation(showing: Showing) -> None:
    source, watched = showing
    page = watched.page
    ids = page.locator("table.fleet tbody").get_by_role("button")  # 7 dead, 6 silent, 1 to 5
    ids.get_by_text("1", exact=True).click()
    ids.get_by_text("3", exact=True).click(modifiers=["Shift"])
    selected(page, 1, 2, 3)
    ids.get_by_text("3", exact=True).click(modifiers=["Control"])
    ids.get_by_text("7", exact=True).click(modifiers=["Control"])
    selected(page, 1, 2, 7)
    page.keyboard.press("m")
    drawn(page, "map")
    place = page.evaluate("skytender.map.places.find((one) => one.sysid === 5)")
    page.locator("canvas.map").click(position={"x": place["x"], "y": place["y"]}, modifiers=["Shift"])
    selected(page, 1, 2, 5, 7)
    expect(page.locator(".selection")).to_contain_text("4 vehicles selected")
    page.get_by_role("button", name="hold", exact=True).click()
    dialog = page.get_by_role("dialog")
    expect(dialog).to_contain_text("Hold 4 vehicles?")
    expect(dialog.get_by_role("listitem")).to_have_text(["pursuer 7 is dead."])
    assert source.sent == []
    dialog.get_by_role("button", name="Yes").click()
    expect(page.locator(".notices .bad")).to_have_text("hold: 2 of 3 obey. Pursuer 2 is busy.")
    assert sorted((sent["command"], sent["sysid"]) for sent in source.sent) == [("hold", 1), ("hold", 2), ("hold", 5)]


def test_all_are_sent_home_from_wherever_the_page_stands(showing: Showing) -> None:
    source, watched = showing
    page = watched.page
    for width in (390, 1280):
        source.sent.clear()
        watched.look(width, 720, dark=False)
        page.evaluate("scrollTo(0, document.body.scrollHeight)")
        page.get_by_role("button", name="all: return").click()
        assert page.evaluate("scrollY > 300"), "it was in reach"
        dialog = page.get_by_role("dialog")
        expect(dialog).to_contain_text("Return all 7 vehicles?")
        unable = ["pursuer 6 has not sent any telemetry yet.", "pursuer 7 is dead."]
        expect(dialog.get_by_role("listitem")).to_have_text(unable)
        dialog.get_by_role("button", name="Yes").click()
        until_sent(page, source, 5)  # the notice of the time before may still be there
        expect(page.locator(".notices").get_by_text("return: 4 of 5 obey. Pursuer 2 is busy.").last).to_be_visible()
        assert sorted(sent["sysid"] for sent in source.sent) == [1, 2, 3, 4, 5]
    page.evaluate("scrollTo(0, 0)")


def where(page: Page, view: str, sysid: int) -> tuple[float, float]:
    """Where a view shows a vehicle, on the page."""
    drawn(page, view)
    at = page.locator(".picture").bounding_box()
    assert at is not None
    place = page.evaluate(f"skytender.{view}.places.find((one) => one.sysid === {sysid})")
    return at["x"] + place["x"], at["y"] + place["y"]


def drag(page: Page, a: tuple[float, float], b: tuple[float, float], *, spare: float = 10.0) -> None:
    """From beyond one place to beyond another."""
    (x0, x1), (y0, y1) = sorted((a[0], b[0])), sorted((a[1], b[1]))
    page.mouse.move(x0 - spare, y0 - spare)
    page.mouse.down()
    page.mouse.move(x1 + spare, y1 + spare, steps=3)
    expect(page.locator(".picture .box")).to_be_visible()
    page.mouse.up()


@pytest.mark.parametrize("view", ["map", "space"])
def test_a_box_selects_in_the_picture_by_pointer_and_by_keys(showing: Showing, view: str) -> None:
    """Seven vehicles stand in a row, 1 m apart."""
    page = showing.watched.page
    page.keyboard.press("0")
    page.keyboard.press("m" if view == "map" else "3")
    camera = "[skytender.map.view, ...Object.values(skytender.space.camera.position)]"
    first, third, fifth, sixth = (where(page, view, sysid) for sysid in (1, 3, 5, 6))
    before = page.evaluate(camera)
    page.get_by_role("button", name="box").click()
    drag(page, first, third)
    selected(page, 1, 2, 3)
    expect(page.get_by_role("button", name="box")).to_have_attribute("aria-pressed", "false")
    page.keyboard.down("Shift")
    drag(page, fifth, sixth)
    page.mouse.click(*third)
    page.keyboard.up("Shift")
    selected(page, 1, 2, 5, 6)  # the box has joined them, the click has taken one out
    assert page.evaluate(camera) == pytest.approx(before), "neither has moved the picture"
    expect(page.locator(".picture .box")).to_be_hidden()
    # by keys alone: the picture is moved until it shows what is meant
    page.keyboard.press("Escape")
    selected(page)
    page.keyboard.press("b")
    selected(page, 1, 2, 3, 4, 5, 6, 7)
    canvas = page.locator(f"canvas.{view}")
    for _ in range(12):
        canvas.press("+")
        drawn(page, view)
        page.keyboard.press("b")
        if len(selection(page)) < 7:
            break
    assert 0 < len(selection(page)) < 7
    page.get_by_label("filter vehicles").fill("6")
    page.get_by_label("filter vehicles").press("Escape")
    page.keyboard.press("a")
    selected(page, 6)  # all that the table shows
    page.get_by_label("filter vehicles").fill("")
    page.get_by_role("button", name="id", exact=True).click()
    page.locator("table.fleet tbody").get_by_role("button", name="1", exact=True).press("Enter")
    page.locator("table.fleet tbody").get_by_role("button", name="3", exact=True).press("Shift+Enter")
    selected(page, 1, 2, 3)
    page.get_by_role("button", name="trouble", exact=True).click()
    page.keyboard.press("0")


def test_what_may_not_obey_is_listed_with_its_reason(showing: Showing) -> None:
    rows = fleet()
    rows[0] |= {"landed": True, "mode": "land"}
    rows[1] |= {"armed": False, "landed": True}
    rows[2] |= {"condition": "silent", "figure": "6 s", "severity": 2, "trouble": ["no telemetry for 6 s"]}
    rows[3] |= {"note": "taken by the operator", "mode_name": "BRAKE"}
    rows[4] |= {"condition": "failing", "mode_name": "RTL", "severity": 2, "trouble": ["failsafe: RTL"]}
    source, watched = showing
    page = watched.page
    source.feed(snapshot(2.0, rows))
    until(page, "skytender.current.t_s === 2")
    page.get_by_role("button", name="all: return").click()
    dialog = page.get_by_role("dialog")
    expect(dialog).to_contain_text("2 of them cannot:")
    expect(dialog).to_contain_text("5 take the order, but:")
    expect(dialog.get_by_role("listitem")).to_have_text(
        [
            "pursuer 6 has not sent any telemetry yet.",
            "pursuer 7 is dead.",
            "pursuer 1 has landed and stays there.",
            "pursuer 2 is on the ground and stays there.",
            "pursuer 3 is silent (6 s) and may not hear it.",
            "pursuer 4 is taken by the operator already (BRAKE).",
            "pursuer 5 is in RTL by its own failsafe, which the order would end.",
        ]
    )
    expect(dialog.get_by_role("region", name="plan B").locator("tbody tr")).to_have_text(
        [
            "1, 2, 3, 4, 5straight home at 12.5 m above it, level from 9 s, down from 30 s after the last HEARTBEAT",
            "6, 7by its own parameters",
        ]
    )
    watched.well()
    dialog.get_by_role("button", name="No").click()
    rows[4] |= {"trouble": ["RTL"]}
    source.feed(snapshot(3.0, rows))
    until(page, "skytender.current.t_s === 3")
    page.get_by_role("button", name="all: return").click()
    words = "pursuer 5 is in RTL without an order from here, which this order would end."
    expect(dialog.get_by_role("listitem").last).to_have_text(words)
    dialog.get_by_role("button", name="No").click()
    page.locator("table.fleet tbody").get_by_role("button", name="5", exact=True).click()
    expect(page.locator(".vehicle-page")).to_contain_text("plan Bstraight home at 12.5 m above it")


def test_a_monitor_offers_hold_return_and_land_alone(browser: Browser) -> None:
    rows = [row(1, 0.0)]
    source = Refusing(session(rows) | {"source": "monitor", "control": True}, snapshot(1.0, rows))
    with served(source) as links:
        watched = Watched(browser)
        page = watched.flying(links["command"])
        shown = page.locator(".orders button:visible")
        expect(shown).to_have_text(["hold⇧H", "return⇧R", "land⇧L"])
        page.locator("table.fleet tbody").get_by_role("button", name="1", exact=True).click()
        page.keyboard.press("Shift+F")
        expect(page.locator(".notices")).to_contain_text("A monitor takes no refuel: it knows hold, return and land.")
        page.keyboard.press("Shift+H")
        expect(page.get_by_role("dialog")).not_to_contain_text("refuelled")
        page.keyboard.press("Escape")
        page.keyboard.press("?")
        keys = page.get_by_role("dialog", name="keys")
        expect(keys).to_contain_text("land where it is")
        expect(keys.get_by_text("serve it next")).to_be_hidden()
        assert source.sent == []
        assert watched.wrong == []
