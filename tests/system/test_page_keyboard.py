"""The page by the keyboard alone: every control is reached, and what a pointer does can be done without one. The tests
share a page, on which nothing flies on."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import pytest
from playwright.sync_api import Browser, Page, expect
from web import Script, Watched, row, served, session, snapshot, until

CONTROLS = "button, input, select, summary, a[href], [tabindex='0']"
USABLE = f"""[...document.querySelectorAll("{CONTROLS}")].filter((one) =>
  !one.disabled && one.checkVisibility({{visibilityProperty: true}}) && !one.closest("dialog"))"""
NAMED = "((one) => one && (one.ariaLabel || one.textContent || one.placeholder || one.className).trim().slice(0, 60))"


def rows(t_s: float) -> list[dict[str, Any]]:
    """Five vehicles that hasten, fall behind and use energy, all at one height."""
    more = {"height_m": 5.0, "speed_m_s": 0.2 + 0.1 * t_s, "target_m": 2.0 + 0.1 * t_s}
    return [row(sysid, t_s, role="pursuer", battery=0.8 - 0.01 * t_s, **more) for sysid in range(1, 6)]


class Showing(NamedTuple):
    """What a source sends, and the page that shows it."""

    source: Script
    page: Page


@pytest.fixture(scope="module")
def showing(browser: Browser) -> Iterator[Showing]:
    source = Script(session(rows(0.0)), *(snapshot(0.5 * k, rows(0.5 * k)) for k in range(41)))
    with served(source) as links:
        watched = Watched(browser)
        page = watched.flying(links["command"])
        until(page, "skytender.current.t_s === 20")
        yield Showing(source, page)
        assert watched.wrong == []


def focus(page: Page, name: str) -> None:
    """Press Tab until the control of a name has the focus."""
    for _ in range(page.evaluate(f"{USABLE}.length") + 10):
        if page.evaluate(f"{NAMED}(document.activeElement)") == name[:60]:
            return
        page.keyboard.press("Tab")
    raise AssertionError(f"no Tab leads to {name!r}")


def test_tab_leads_to_every_control(showing: Showing) -> None:
    page = showing.page
    page.evaluate("addEventListener('focusin', (event) => { event.target.reached = true; })")
    for _ in range(page.evaluate(f"{USABLE}.length") + 10):
        page.keyboard.press("Tab")
    assert page.evaluate(f"{USABLE}.filter((one) => !one.reached).map({NAMED})") == []


def test_vehicles_are_selected_from_the_table_and_given_one_order(showing: Showing) -> None:
    page = showing.page
    focus(page, "3")
    page.keyboard.press("Enter")
    until(page, "skytender.chosen === 3")
    focus(page, "1")
    page.keyboard.press("Control+Enter")
    until(page, "[...skytender.selected].sort().join() === '1,3'")
    page.keyboard.press("Shift+H")
    expect(page.get_by_role("dialog")).to_contain_text("Hold 2 vehicles?")
    page.keyboard.press("Enter")
    expect(page.locator(".notices .good", has_text="hold: 2 of 2 obey.")).to_be_visible()
    held = [one | ({"mode": "hold"} if one["sysid"] in (1, 3) else {}) for one in rows(20.5)]
    showing.source.feed(snapshot(20.5, held))
    until(page, "skytender.table.last.snapshot.t_s === 20.5")
    page.keyboard.press("/")
    page.keyboard.type("hold")
    until(page, "skytender.table.shown.sort().join() === '1,3'")
    page.keyboard.press("Escape")
    page.keyboard.press("a")
    page.keyboard.press("Escape")
    until(page, "skytender.selected.size === 0")


def test_an_order_to_all_is_reached_and_can_be_declined(showing: Showing) -> None:
    page, source = showing.page, showing.source
    before = len(source.sent)
    focus(page, "all: return")
    page.keyboard.press("Enter")
    expect(page.get_by_role("dialog")).to_contain_text("Return all 5 vehicles?")
    page.keyboard.press("Escape")
    expect(page.get_by_role("dialog")).to_be_hidden()
    assert len(source.sent) == before


def test_figures_are_zoomed_around_the_time_that_is_shown(showing: Showing) -> None:
    page = showing.page
    focus(page, "Battery over time")
    page.keyboard.press("+")
    page.keyboard.press("+")
    begin_s, end_s = page.evaluate("skytender.time.zoom")
    assert end_s - begin_s == pytest.approx(page.evaluate("skytender.time.end_s") / 4, rel=0.2)
    page.keyboard.press("-")
    assert page.evaluate("skytender.time.zoom[1] - skytender.time.zoom[0]") > 1.5 * (end_s - begin_s)
    for _ in range(60):
        page.keyboard.press("+")
    assert page.evaluate("skytender.time.zoom[1] - skytender.time.zoom[0]") == pytest.approx(0.1)
    page.keyboard.press("0")
    assert page.evaluate("skytender.time.zoom") is None


def test_the_past_is_shown_and_the_newest_again(showing: Showing) -> None:
    page = showing.page
    focus(page, "time")
    page.keyboard.press("Home")
    until(page, "skytender.at_s !== null && skytender.current.t_s < 1")
    page.keyboard.press("End")
    until(page, "skytender.at_s === null")


def test_the_picture_is_turned_moved_and_zoomed(showing: Showing) -> None:
    page = showing.page
    page.keyboard.press("m")
    focus(page, "the fleet from above, north up; arrow keys move, + and − zoom, 0 shows everything")
    for key in ("+", "ArrowLeft"):
        page.keyboard.press(key)
    until(page, "skytender.map.view !== null")
    page.keyboard.press("0")
    until(page, "skytender.map.view === null")


def test_keys_stand_on_the_buttons_that_they_press(showing: Showing) -> None:
    page = showing.page
    page.locator("table.fleet tbody").get_by_role("button", name="1", exact=True).click()
    for button in page.locator("button:has(kbd):visible").all():
        shown = button.locator("kbd").inner_text()
        name = button.inner_text().removesuffix(shown).strip()
        if not shown.startswith("⇧"):
            continue
        page.keyboard.press(f"Shift+{shown[1:]}")
        if name == "retarget":
            expect(page.get_by_role("status").last).to_contain_text("There is no target.")
            continue
        expect(page.get_by_role("dialog")).to_be_visible()
        page.keyboard.press("Escape")
        expect(page.get_by_role("dialog")).to_be_hidden()
    for name, key, view in (("3-D", "3", "space"), ("map", "M", "map")):
        expect(page.get_by_role("button", name=name, exact=True).locator("kbd")).to_have_text(key)
        page.keyboard.press(key.lower())
        assert page.evaluate("skytender.view") == view
