"""The page when it is new, in Debian's Chromium: before anything flies, the tour, a sound, keys on their buttons."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, expect
from web import CHROMIUM, MISSING, Script, Watched, barriers, chromium, row, served, session, snapshot, until

pytestmark = pytest.mark.skipif(CHROMIUM is None, reason=MISSING)


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with chromium() as browser:
        yield browser


@pytest.mark.parametrize("width", [390, 1280])
def test_while_a_session_starts_the_page_says_so_and_offers_nothing_that_would_not_work(
    browser: Browser, width: int
) -> None:
    rows = [row(sysid, 0.0) for sysid in (1, 2)] + [row(101, 0.0, role="target")]
    source = Script()
    with served(source) as links:
        watched = Watched(browser, width=width)
        page = watched.open(links["command"])
        said = page.locator(".picture").get_by_role("status")
        expect(said).to_have_text("The session is starting.")
        for name in ("hold", "stop", "all: return"):
            expect(page.get_by_role("button", name=name, exact=True)).to_be_hidden()
        assert barriers(page) == []
        source.tell(session(rows, name="harvest"))
        expect(page.locator("h1")).to_have_text("harvest")
        expect(said).to_have_text("2 pursuers, 1 target start; they are shown here as soon as they report.")
        expect(page.get_by_role("button", name="stop", exact=True)).to_be_visible()
        source.tell(snapshot(0.1, rows))
        expect(said).to_be_hidden()
        until(page, "skytender.current?.vehicles.length === 3")
        assert watched.wrong == []
        page.close()


@pytest.mark.parametrize(("width", "dark"), [(390, True), (1280, False)])
def test_the_first_visit_begins_with_a_tour_of_five_steps_and_the_next_without(
    browser: Browser, width: int, dark: bool
) -> None:
    rows = [row(1, 0.0)]
    with served(Script(session(rows), snapshot(1.0, rows))) as links:
        watched = Watched(browser, width=width, dark=dark, tour=True)
        page = watched.flying(links["command"])
        tour = page.get_by_role("region", name="tour")
        pointed = set()
        for step in range(1, 6):
            expect(tour).to_contain_text(f"{step} of 5")
            expect(page.locator(".pointed")).to_have_count(1)
            pointed.add(page.locator(".pointed").get_attribute("class"))
            assert step > 1 or barriers(page) == []
            tour.get_by_role("button", name="Next" if step < 5 else "Done").press("Enter")
        assert len(pointed) == 5
        expect(tour).to_be_hidden()
        page.reload()
        until(page, "window.skytender?.current")
        expect(tour).to_be_hidden()
        page.get_by_role("button", name="keys ?").click()
        page.get_by_role("button", name="Show the tour").click()
        expect(tour).to_contain_text("1 of 5")
        tour.get_by_role("button", name="Close tour").click()
        expect(tour).to_be_hidden()
        assert watched.wrong == []
        page.close()


def test_a_sound_is_off_until_it_is_switched_on_and_tells_what_gets_worse(browser: Browser) -> None:
    low = {"condition": "low", "figure": "40 s", "severity": 1}
    dead = {"condition": "dead", "figure": "1 s", "severity": 2, "alive": False}
    source = Script(session([row(1, 0.0), row(2, 0.0)]), snapshot(1.0, [row(1, 0.0), row(2, 0.0, **low)]))
    with served(source) as links:
        watched = Watched(browser)
        page = watched.flying(links["command"])
        button = page.get_by_role("button", name="sound")
        expect(button).to_have_attribute("aria-pressed", "false")
        assert page.evaluate("[skytender.sound.rung, skytender.sound.audio]") == [0, None]
        button.click()
        expect(button).to_have_attribute("aria-pressed", "true")
        source.tell(snapshot(2.0, [row(1, 0.0), row(2, 0.0, **low)]))
        until(page, "skytender.current.t_s === 2")
        assert page.evaluate("skytender.sound.rung") == 0, "it is no worse than before"
        source.tell(snapshot(3.0, [row(1, 0.0, **dead), row(2, 0.0, **low)]))
        until(page, "skytender.sound.rung === 1")
        button.click()
        expect(button).to_have_attribute("aria-pressed", "false")
        assert page.evaluate("skytender.sound.audio") is None
        assert watched.wrong == []
        page.close()


def test_keys_stand_on_the_buttons_that_they_press(browser: Browser) -> None:
    rows = [row(1, 0.0)]
    with served(Script(session(rows), snapshot(1.0, rows))) as links:
        watched = Watched(browser)
        page = watched.flying(links["command"])
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
        for name, key, before, after in (
            ("map", "M", "space", "map"),
            ("3-D", "3", "map", "space"),
        ):
            assert page.evaluate("skytender.view") == before
            expect(page.get_by_role("button", name=name, exact=True).locator("kbd")).to_have_text(key)
            page.keyboard.press(key.lower())
            assert page.evaluate("skytender.view") == after
        assert watched.wrong == []
        page.close()
