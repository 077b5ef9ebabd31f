"""The page by the keyboard alone: every control is reached, and what a pointer does can be done without one."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import pytest
from playwright.sync_api import Page, expect
from sessions import Running, small
from web import CHROMIUM, MISSING, Watched, chromium, until

pytestmark = pytest.mark.skipif(CHROMIUM is None, reason=MISSING)
MOST_TABS = 250
CONTROLS = "button, input, select, summary, a[href], [tabindex='0']"
USABLE = f"""[...document.querySelectorAll("{CONTROLS}")].filter((one) =>
  !one.disabled && one.checkVisibility({{visibilityProperty: true}}) && !one.closest("dialog"))"""
NAMED = "((one) => one && (one.ariaLabel || one.textContent || one.placeholder || one.className).trim().slice(0, 60))"


@pytest.fixture(scope="module")
def flying(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Page]:
    content: dict[str, Any] = small(
        clock={"mode": "real", "speed": 4.0},
        goal={"duration_s": 1200.0, "refuelled_at_least": 0},
        refuelling={"enabled": False},
    )
    content["vehicles"]["pursuers"] = [
        {"sysid": k, "start_m": [2.0, 3.0 * (k - 1), 0.0], "battery": {"capacity_j": 90_000}} for k in (1, 2, 3)
    ]
    running = Running(content, tmp_path_factory.mktemp("keyboard"), "--web", report=False)
    try:
        said = "".join(line for _, line in zip(range(3), running.lines(), strict=False))
        link = re.findall(r"http://127\.0\.0\.1:\d+/#token=\S+", said)[0]
        with chromium() as browser:
            page = Watched(browser).flying(link)
            until(page, "skytender.current.vehicles.every((v) => v.mode === 'offboard')")
            yield page
    finally:
        running.stop()


def focus(page: Page, name: str) -> None:
    """Press Tab until the control of a name has the focus."""
    for _ in range(MOST_TABS):
        if page.evaluate(f"{NAMED}(document.activeElement)") == name[:60]:
            return
        page.keyboard.press("Tab")
    raise AssertionError(f"no Tab leads to {name!r}")


def test_tab_leads_to_every_control(flying: Page) -> None:
    page = flying
    page.keyboard.press("m")  # what the picture offers does not depend on the view
    page.evaluate(f"for (const one of {USABLE}) one.unreached = true")
    for _ in range(MOST_TABS):
        page.keyboard.press("Tab")
        page.evaluate("if (document.activeElement) document.activeElement.unreached = false")
    left = page.evaluate(f"{USABLE}.filter((one) => one.unreached).map({NAMED})")
    # Events come while Tab is pressed; each is a button that had not been there.
    assert [name for name in left if not name.startswith("go to")] == []


def test_vehicles_are_selected_from_the_table_and_given_one_order(flying: Page) -> None:
    page = flying
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
    until(page, "skytender.current.vehicles.filter((v) => v.mode === 'hold').length === 2")
    page.keyboard.press("/")
    page.keyboard.type("hold")
    until(page, "skytender.table.shown.sort().join() === '1,3'")
    page.keyboard.press("Escape")
    page.keyboard.press("a")
    page.keyboard.press("Escape")
    until(page, "skytender.selected.size === 0")


def test_an_order_to_all_is_reached_and_can_be_declined(flying: Page) -> None:
    page = flying
    focus(page, "all: return")
    page.keyboard.press("Enter")
    expect(page.get_by_role("dialog")).to_contain_text("Return all 5 vehicles?")
    page.keyboard.press("Escape")
    expect(page.get_by_role("dialog")).to_be_hidden()
    assert not page.evaluate("skytender.current.vehicles.some((v) => v.mode === 'return')")


def test_figures_are_zoomed_around_the_time_that_is_shown(flying: Page) -> None:
    page = flying
    focus(page, "Battery over time")
    page.keyboard.press("+")
    page.keyboard.press("+")
    begin_s, end_s = page.evaluate("skytender.time.zoom")
    assert end_s - begin_s == pytest.approx(page.evaluate("skytender.time.end_s") / 4, rel=0.2)
    page.keyboard.press("-")
    assert page.evaluate("skytender.time.zoom[1] - skytender.time.zoom[0]") > 1.5 * (end_s - begin_s)
    page.keyboard.press("0")
    assert page.evaluate("skytender.time.zoom") is None


def test_the_past_is_shown_and_the_newest_again(flying: Page) -> None:
    page = flying
    focus(page, "time")
    page.keyboard.press("Home")
    until(page, "skytender.at_s !== null && skytender.current.t_s < 1")
    page.keyboard.press("End")
    until(page, "skytender.at_s === null")


def test_the_picture_is_turned_moved_and_zoomed(flying: Page) -> None:
    page = flying
    page.keyboard.press("m")
    focus(page, "the fleet from above, north up; arrow keys move, + and − zoom, 0 shows everything")
    for key in ("+", "ArrowLeft"):
        page.keyboard.press(key)
    until(page, "skytender.map.view !== null")
    page.keyboard.press("0")
    until(page, "skytender.map.view === null")
