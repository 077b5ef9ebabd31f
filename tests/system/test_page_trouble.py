"""Trouble first on the page, in Debian's Chromium: how many are in which, which and how badly, on every screen."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, expect
from web import CHROMIUM, MISSING, Script, Watched, barriers, chromium, row, served, session, snapshot, until

pytestmark = pytest.mark.skipif(CHROMIUM is None, reason=MISSING)

SCREENS = ((390, 844), (1280, 720), (1920, 1080), (3840, 2160))
TROUBLES: dict[int, dict[str, Any]] = {
    1: {"landed": True, "mode": "land", "height_m": 0.0, "severity": 0},
    2: {"condition": "low", "figure": "50 s", "urgency": -50.0, "trouble": ["50 s of flight left"], "battery": 0.3},
    3: {"condition": "silent", "figure": "6 s", "urgency": 6.0, "trouble": ["no telemetry for 6 s"], "severity": 2},
    4: {"condition": "low", "figure": "48 s", "urgency": -48.0, "trouble": ["48 s of flight left"], "battery": 0.25},
    5: {"condition": "warned", "figure": "30 % packet loss", "trouble": ["30 % packet loss"]},
    6: {"condition": "failing", "figure": "land", "trouble": ["land", "battery 4 %"], "severity": 2, "mode": "land"},
    7: {"condition": "dead", "figure": "9 s", "urgency": 9.0, "trouble": ["dead"], "severity": 2, "alive": False},
}


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with chromium() as browser:
        yield browser


def fleet(count: int, shift: int = 0) -> list[dict[str, Any]]:
    """The last seven of `count` vehicles have the troubles above, `shift` further on."""
    found = {sysid: TROUBLES.get(sysid - shift, {}) for sysid in range(1, count + 1)}
    return [row(sysid, 0.0, **{"severity": int(bool(trouble)), **trouble}) for sysid, trouble in found.items()]


@pytest.fixture(scope="module", params=[7, 254])
def link(request: pytest.FixtureRequest) -> Iterator[str]:
    rows = fleet(request.param, request.param - 7)
    with served(Script(session(rows), snapshot(1.0, rows))) as links:
        yield links["command"]


@pytest.fixture(scope="module")
def calm() -> Iterator[str]:
    rows = [row(sysid, 0.0) for sysid in range(1, 8)]
    with served(Script(session(rows), snapshot(1.0, rows))) as links:
        yield links["command"]


def in_view(page: Page, selector: str) -> bool:
    """Whether an element lies on the screen, wholly and uncovered."""
    there: bool = page.evaluate(
        """(selector) => {
          const box = document.querySelector(selector).getBoundingClientRect();
          const [x, y] = [box.left + box.width / 2, box.bottom - 3];
          const inside = box.left >= 0 && box.right <= innerWidth && box.top >= 0 && box.bottom <= innerHeight;
          return inside && document.elementFromPoint(x, y)?.closest(selector) !== null;
        }""",
        selector,
    )
    return there


def test_the_strip_tells_how_many_how_badly_and_selects_them(browser: Browser) -> None:
    rows = fleet(7)
    source = Script(session(rows), snapshot(1.0, [row(r["sysid"], 0.0) for r in rows]))
    with served(source) as links:
        watched = Watched(browser)
        page = watched.flying(links["command"])
        strip = page.get_by_label("trouble", exact=True)
        expect(strip).to_contain_text("All well · 7 vehicles, 7 armed")
        place = page.get_by_role("button", name="live", exact=True).bounding_box()
        broken = {"part": "separation", "text": "separation 0.02 m", "t_s": 1.5}
        told = snapshot(2.0, rows)
        told["goal"]["broken"] = [broken]
        source.tell(told)
        expect(strip.locator("li").get_by_role("button")).to_have_text(
            [
                "✕1Dead: 7 (9 s)",
                "⌀1Silent: 3 (6 s)",
                "▲1Failing: 6 (land)",
                "◔2Low battery: 4 (48 s left), 2 (50 s)",
                "△1Warned: 5 (30 % packet loss)",
            ]
        )
        expect(strip.get_by_text("All well")).to_be_hidden()
        expect(page.locator(".goal-line")).to_contain_text("1 goal failed: separation 0.02 m (1.5 s)")
        assert page.get_by_role("button", name="live", exact=True).bounding_box() == place, "nothing moves away"
        strip.get_by_role("button", name="Low battery").click()
        assert page.evaluate("[skytender.chosen, [...skytender.selected]]") == [4, [4, 2]]
        until(page, "document.querySelectorAll('tr[aria-selected=true]').length === 2")
        expect(page.locator(".vehicle-page")).to_contain_text("pursuer 4")
        # in the past the strip shows what was
        page.evaluate("skytender.player.seek(1.0)")
        expect(strip).to_contain_text("All well")
        assert watched.wrong == []
        page.close()


@pytest.mark.parametrize("dark", [False, True])
@pytest.mark.parametrize(("width", "height"), SCREENS)
def test_trouble_is_read_on_every_screen(
    browser: Browser, link: str, width: int, height: int, dark: bool, tmp_path: Path
) -> None:
    watched = Watched(browser, width=width, height=height, dark=dark)
    page = watched.flying(link)
    page.screenshot(path=tmp_path / "page.png")
    for condition in ("dead", "silent", "failing", "low", "warned"):
        assert in_view(page, f".strip .{condition} button")
    page.evaluate("scrollTo(0, document.body.scrollHeight)")
    until(page, "scrollY > 500 || scrollY + innerHeight >= document.documentElement.scrollHeight - 1")
    for condition in ("dead", "silent", "failing", "low", "warned"):
        assert in_view(page, f".strip .{condition} button"), "it stays on top"
    page.evaluate("scrollTo(0, 0)")
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    cut = page.evaluate(
        """[...document.querySelectorAll('button, h1, h2, .badge, .strip li, dt, dd')]
          .filter((one) => one.offsetParent && getComputedStyle(one).display !== 'inline')
          .filter((one) => one.scrollWidth > one.clientWidth + 1)
          .map((one) => one.outerHTML.slice(0, 80))"""
    )
    assert cut == []
    cut = page.evaluate(
        """[...document.querySelectorAll('.strip .figures-of')]
          .filter((one) => one.offsetParent)
          .filter((one) => one.scrollWidth > one.clientWidth + 1 || one.scrollHeight > one.clientHeight + 1)
          .map((one) => one.textContent)"""
    )
    assert cut == []
    assert barriers(page) == []
    assert watched.wrong == []
    page.close()


@pytest.mark.parametrize("dark", [False, True])
@pytest.mark.parametrize(("width", "height"), SCREENS)
def test_the_table_has_trouble_first_and_nothing_is_cut_off(
    browser: Browser, link: str, width: int, height: int, dark: bool, tmp_path: Path
) -> None:
    watched = Watched(browser, width=width, height=height, dark=dark)
    page = watched.flying(link)
    until(page, "document.querySelector('table.fleet tbody tr')")
    table = page.locator("table.fleet")
    expect(table.locator("th").nth(1)).to_have_text("trouble")
    rows = table.locator("tbody tr")
    first = [rows.nth(k).get_attribute("class") for k in range(7)]
    assert first == ["dead", "silent", "failing", "low", "low", "warned", None]
    low = [int(rows.nth(k).locator("td").first.inner_text()) for k in (3, 4)]
    assert low[1] == low[0] + 2, "by their ids"
    expect(rows.nth(6)).to_contain_text("▼landed")
    expect(rows.nth(2)).to_contain_text("land, battery 4 %")
    cut = page.evaluate(
        """[...document.querySelectorAll('.fleet-scroll, table.fleet th, table.fleet td')]
          .filter((one) => one.scrollWidth > one.clientWidth).map((one) => one.outerHTML.slice(0, 80))"""
    )
    assert cut == []
    grounds = "[...document.querySelectorAll('table.fleet tbody tr')].map((one) => getComputedStyle(one).background)"
    dead, _, _, low_ground, _, _, well, *_ = page.evaluate(grounds)
    assert len({dead, low_ground, well}) == 3
    if width >= 1280:
        for condition in ("dead", "silent", "failing", "low", "warned"):
            assert in_view(page, f"table.fleet tr.{condition}"), "on the screen from the beginning"
    table.scroll_into_view_if_needed()
    page.screenshot(path=tmp_path / "page.png")
    table.get_by_role("button", name="id").click()
    assert [rows.nth(k).locator("td").first.inner_text() for k in range(3)] == ["1", "2", "3"]
    assert barriers(page) == []
    assert watched.wrong == []
    page.close()


@pytest.mark.parametrize("dark", [False, True])
@pytest.mark.parametrize(("width", "height"), SCREENS)
def test_a_calm_fleet_is_said_to_be_well(
    browser: Browser, calm: str, width: int, height: int, dark: bool, tmp_path: Path
) -> None:
    watched = Watched(browser, width=width, height=height, dark=dark)
    page = watched.flying(calm)
    strip = page.get_by_label("trouble", exact=True)
    expect(strip).to_contain_text("All well · 7 vehicles, 7 armed")
    page.screenshot(path=tmp_path / "page.png")
    assert in_view(page, ".strip .well")
    assert in_view(page, ".strip .all")
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    assert barriers(page) == []
    assert watched.wrong == []
    page.close()
