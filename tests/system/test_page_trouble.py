"""Trouble first on the page, in Debian's Chromium: how many are in which, which and how badly, on every screen."""

from __future__ import annotations

from typing import Any

import pytest
from playwright.sync_api import Browser, Page, expect
from web import Script, Watched, row, served, session, snapshot, until

SCREENS = ((390, 844, True), (1280, 720, False), (1920, 1080, True), (3840, 2160, False))
"""(width, height, whether in the dark theme): one for each arrangement of the page's style sheet."""
CONDITIONS = ("dead", "silent", "failing", "low", "warned")
LANDS = {"mode": "land", "mode_name": "Land"}
TROUBLES: dict[int, dict[str, Any]] = {
    1: {"landed": True, **LANDS, "height_m": 0.0, "severity": 0},
    2: {"condition": "low", "figure": "50 s", "urgency": -50.0, "trouble": ["50 s of flight left"], "battery": 0.3},
    3: {"condition": "silent", "figure": "6 s", "urgency": 6.0, "trouble": ["no telemetry for 6 s"], "severity": 2},
    4: {"condition": "low", "figure": "48 s", "urgency": -48.0, "trouble": ["48 s of flight left"], "battery": 0.15},
    5: {"condition": "warned", "figure": "30 % packet loss", "trouble": ["30 % packet loss"]},
    6: {"condition": "failing", "figure": "Land", "trouble": ["Land", "battery 4 %"], "severity": 2, **LANDS},
    7: {"condition": "dead", "figure": "9 s", "urgency": 9.0, "trouble": ["dead"], "severity": 2, "alive": False},
}
CUT_OFF = """[...document.querySelectorAll('button, h1, h2, .badge, .strip li, .strip .figures-of, dt, dd, ' +
    '.fleet-scroll, table.fleet th, table.fleet td')]
  .filter((one) => one.offsetParent && getComputedStyle(one).display !== 'inline')
  .filter((one) => one.scrollWidth > one.clientWidth + (one.closest('table, .fleet-scroll') ? 0 : 1)
    || one.matches('.figures-of') && one.scrollHeight > one.clientHeight + 1)
  .map((one) => one.outerHTML.slice(0, 80))"""
GROUNDS = "[...document.querySelectorAll('table.fleet tbody tr')].map((one) => getComputedStyle(one).background)"


def fleet(count: int) -> list[dict[str, Any]]:
    """The last seven of `count` vehicles have the troubles above."""
    found = {sysid: TROUBLES.get(sysid - count + 7, {}) for sysid in range(1, count + 1)}
    return [row(sysid, 0.0, **{"severity": int(bool(trouble)), **trouble}) for sysid, trouble in found.items()]


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


@pytest.mark.slow
def test_a_calm_fleet_is_said_to_be_well_and_the_strip_tells_how_many_how_badly_and_selects_them(
    browser: Browser,
) -> None:
    rows = fleet(7)
    source = Script(session(rows), snapshot(1.0, [row(r["sysid"], 0.0) for r in rows]))
    with served(source) as links:
        watched = Watched(browser)
        page = watched.flying(links["command"])
        strip = page.get_by_label("trouble", exact=True)
        expect(strip).to_contain_text("All well · 7 vehicles, 7 armed")
        for width, height, dark in SCREENS:
            watched.look(width, height, dark=dark)
            assert in_view(page, ".strip .well"), width
            assert in_view(page, ".strip .all"), width
            assert page.evaluate("document.documentElement.scrollWidth <= innerWidth"), width
        watched.well()
        watched.look(1280, 800, dark=False)
        place = page.get_by_role("button", name="live", exact=True).bounding_box()
        told = snapshot(2.0, rows)
        told["goal"]["broken"] = [{"part": "separation", "text": "separation 0.02 m (3 and 5 at 1.5 s)", "t_s": 1.5}]
        source.feed(told)
        expect(strip.locator("li").get_by_role("button")).to_have_text(
            [
                "✕1Dead: 7 (9 s)",
                "⌀1Silent: 3 (6 s)",
                "▲1Failing: 6 (Land)",
                "◔2Low battery: 4 (48 s left), 2 (50 s)",
                "△1Warned: 5 (30 % packet loss)",
            ]
        )
        expect(strip.get_by_text("All well")).to_be_hidden()
        expect(page.locator(".goal-line")).to_have_text("1 goal failed: separation 0.02 m (3 and 5 at 1.5 s). ")
        assert page.get_by_role("button", name="live", exact=True).bounding_box() == place, "nothing moves away"
        strip.get_by_role("button", name="Low battery").click()
        assert page.evaluate("[skytender.chosen, [...skytender.selected]]") == [4, [4, 2]]
        until(page, "document.querySelectorAll('tr[aria-selected=true]').length === 2")
        expect(page.locator(".vehicle-page")).to_contain_text("pursuer 4")
        # in the past the strip stays at the present, on which its orders act
        page.evaluate("skytender.player.seek(1.0)")
        until(page, "skytender.paneled.t_s === 1.0")
        expect(strip.get_by_role("button", name="Dead: 7 (9 s)")).to_be_visible()
        expect(strip.get_by_text("All well")).to_be_hidden()
        source.feed(snapshot(3.0, [row(r["sysid"], 0.0) for r in rows]))
        expect(strip).to_contain_text("All well")
        assert page.evaluate("skytender.current.t_s") == 1.0
        assert watched.wrong == []
        page.close()


def test_one_vehicle_is_counted_as_one(browser: Browser) -> None:
    rows = [row(1, 0.0)]
    with served(Script(session(rows), snapshot(1.0, rows))) as links:
        page = Watched(browser).flying(links["command"])
        expect(page.locator(".totals")).to_have_text(f"1 vehicle: 1 {rows[0]['mode_name']}")
        page.close()


def test_a_dead_vehicle_is_counted_and_described_as_dead(browser: Browser) -> None:
    """In place of the mode, as in the console; what it was doing when it died is not said of it."""
    rows = [row(1, 0.0), row(2, 0.0), row(3, 0.0, state="lost", stage="down", **TROUBLES[7])]
    with served(Script(session(rows), snapshot(1.0, rows))) as links:
        watched = Watched(browser)
        page = watched.flying(links["command"])
        expect(page.locator(".totals")).to_have_text("3 vehicles: 2 Offboard, 1 DEAD")
        expect(page.locator("table.fleet tr.dead")).to_contain_text("DEAD")
        page.evaluate("skytender.choose(3)")
        expect(page.locator(".vehicle-page h3")).to_have_text("pursuer 3")
        facts = dict(zip(*(page.locator(f".facts {part}").all_inner_texts() for part in ("dt", "dd")), strict=True))
        wanted = {
            "mode": "DEAD",
            "armed": "–",
            "power": "–",
            "lasts": "–",
            "battery": "80.0 %, 8.0 kJ",
            "height": "5.0 m",
        }
        assert {name: facts[name] for name in wanted} == wanted
        page.keyboard.press("Shift+H")
        expect(page.get_by_role("dialog")).to_contain_text("DEAD, 5.0 m high, battery 80 %")
        page.keyboard.press("Escape")
        assert watched.wrong == []
        page.close()


def test_what_a_vehicle_has_not_reported_is_a_dash(browser: Browser) -> None:
    unknown = ("p_ned", "v_ned", "speed_m_s", "height_m", "heading_rad", "roll_rad", "pitch_rad", "age_s", "heard_s",
               "power_w", "endurance_s", "target_m", "lost_share", "autopilot")  # fmt: skip
    rows = [row(1, 0.0), row(2, 0.0, **dict.fromkeys(unknown))]
    with served(Script(session(rows), snapshot(1.0, rows), snapshot(2.0, rows))) as links:
        watched = Watched(browser)
        page = watched.flying(links["command"])
        page.evaluate("skytender.choose(2)")
        expect(page.locator(".vehicle-page h3")).to_have_text("pursuer 2")
        facts = dict(zip(*(page.locator(f".facts {part}").all_inner_texts() for part in ("dt", "dd")), strict=True))
        dashes = ("speed", "heading", "power", "lasts", "height", "north, east", "autopilot", "position's age")
        assert {facts[name] for name in dashes} == {"–"}
        assert facts["roll, pitch"] == "–, –"
        assert not [word for word in ("NaN", "null", "undefined") if word in page.locator("body").inner_text()]
        assert watched.wrong == []
        page.close()


def trouble_is_read(page: Page, width: int) -> None:
    """In the strip, wherever the page is scrolled to, and in the table's first rows."""
    page.evaluate("scrollTo(0, 0)")
    assert [one for one in CONDITIONS if not in_view(page, f".strip .{one} button")] == [], width
    if width >= 1280:
        assert [one for one in CONDITIONS if not in_view(page, f"table.fleet tr.{one}")] == [], width
    page.evaluate("scrollTo(0, document.body.scrollHeight)")
    until(page, "scrollY > 500 || scrollY + innerHeight >= document.documentElement.scrollHeight - 1")
    assert [one for one in CONDITIONS if not in_view(page, f".strip .{one} button")] == [], f"on top at {width}"
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth"), width
    assert page.evaluate(CUT_OFF) == [], width
    rows = page.locator("table.fleet tbody tr")
    first = [rows.nth(k).get_attribute("class") for k in range(7)]
    assert first == ["dead", "silent", "failing", "low", "low", "warned", None]
    dead, _, _, low, _, _, well, *_ = page.evaluate(GROUNDS)
    assert len({dead, low, well}) == 3


@pytest.mark.parametrize(("count", "link"), [(7, "view"), pytest.param(254, "command", marks=pytest.mark.slow)])
def test_trouble_is_read_on_every_screen_and_nothing_is_cut_off(browser: Browser, count: int, link: str) -> None:
    rows = fleet(count)
    with served(Script(session(rows), snapshot(1.0, rows))) as links:
        watched = Watched(browser)
        page = watched.flying(links[link])
        until(page, "document.querySelector('table.fleet tbody tr')")
        for width, height, dark in SCREENS:
            watched.look(width, height, dark=dark)
            trouble_is_read(page, width)
            if count == 7:
                watched.well()
        table = page.locator("table.fleet")
        expect(table.locator("th").nth(1)).to_have_text("trouble")
        rows_shown = table.locator("tbody tr")
        low = [int(rows_shown.nth(k).locator("td").first.inner_text()) for k in (3, 4)]
        assert low[1] == low[0] + 2, "by their ids"
        expect(rows_shown.nth(6)).to_contain_text("▼landed")
        expect(rows_shown.nth(2)).to_contain_text("Land, battery 4 %")
        table.get_by_role("button", name="id").click()
        assert [rows_shown.nth(k).locator("td").first.inner_text() for k in range(3)] == ["1", "2", "3"]
        if link == "view":
            for name in ("hold", "all: return"):
                expect(page.get_by_role("button", name=name, exact=True)).to_be_hidden()
        else:
            many_are_filtered_counted_and_gone_to(page)
        watched.well()
        page.close()


def many_are_filtered_counted_and_gone_to(page: Page) -> None:
    expect(page.locator(".totals")).to_have_text("254 vehicles: 251 Offboard, 2 Land, 1 DEAD")
    assert "1 below 20 %" in (page.locator(".histogram").get_attribute("aria-label") or "")
    page.get_by_label("filter vehicles").fill("25")
    assert page.locator("table.fleet tbody tr:visible").count() == 6, "25, and 250 to 254"
    page.get_by_label("filter vehicles").fill("")
    page.get_by_label("go to vehicle").fill("200")
    page.get_by_role("button", name="go to").click()
    assert page.evaluate("skytender.chosen") == 200
    expect(page.locator(".vehicle-page")).to_contain_text("pursuer 200")
    assert page.evaluate("skytender.map.follow"), "the picture goes there too"
