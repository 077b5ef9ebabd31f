"""The page when it is new, in Debian's Chromium: before anything flies, the tour, a sound."""

from __future__ import annotations

from playwright.sync_api import Browser, Locator, Page, expect
from web import Script, Watched, row, served, session, snapshot, until

NARROW, WIDE = (390, 800, True), (1280, 800, False)


def test_while_a_session_starts_the_page_says_so_and_offers_nothing_that_would_not_work(browser: Browser) -> None:
    rows = [row(sysid, 0.0) for sysid in (1, 2)] + [row(101, 0.0, role="target")]
    source = Script()
    with served(source) as links:
        watched = Watched(browser)
        page = watched.open(links["command"])
        said = page.locator(".picture").get_by_role("status")
        expect(said).to_have_text("The session is starting.")
        for width, height, dark in (NARROW, WIDE):
            watched.look(width, height, dark=dark)
            for name in ("hold", "stop", "all: return"):
                expect(page.get_by_role("button", name=name, exact=True)).to_be_hidden()
            watched.well()
        source.feed(session(rows, name="harvest"))
        expect(page.locator("h1")).to_have_text("harvest")
        expect(said).to_have_text("2 pursuers, 1 target start; they are shown here as soon as they report.")
        expect(page.get_by_role("button", name="stop", exact=True)).to_be_visible()
        source.feed(snapshot(0.1, rows))
        expect(said).to_be_hidden()
        until(page, "skytender.current?.vehicles.length === 3")
        assert watched.wrong == []
        page.close()


def steps(page: Page, tour: Locator) -> set[str | None]:
    """Go through the tour; what it points at."""
    pointed = set()
    for step in range(1, 6):
        expect(tour).to_contain_text(f"{step} of 5")
        expect(page.locator(".pointed")).to_have_count(1)
        pointed.add(page.locator(".pointed").get_attribute("class"))
        tour.get_by_role("button", name="Next" if step < 5 else "Done").press("Enter")
    return pointed


def test_the_first_visit_begins_with_a_tour_of_five_steps_and_the_next_without(browser: Browser) -> None:
    rows = [row(1, 0.0)]
    with served(Script(session(rows), snapshot(1.0, rows))) as links:
        watched = Watched(browser, tour=True)
        page = watched.flying(links["command"])
        tour = page.get_by_role("region", name="tour")
        expect(tour).to_contain_text("1 of 5")
        for width, height, dark in (WIDE, NARROW):
            watched.look(width, height, dark=dark)
            watched.well()
        assert len(steps(page, tour)) == 5
        expect(tour).to_be_hidden()
        page.reload()
        until(page, "window.skytender?.current")
        expect(tour).to_be_hidden()
        watched.look(*WIDE[:2], dark=False)
        page.get_by_role("button", name="keys ?").click()
        page.get_by_role("button", name="Show the tour").click()
        assert len(steps(page, tour)) == 5
        page.get_by_role("button", name="keys ?").click()
        page.get_by_role("button", name="Show the tour").click()
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
        source.feed(snapshot(2.0, [row(1, 0.0), row(2, 0.0, **low)]))
        until(page, "skytender.current.t_s === 2")
        assert page.evaluate("skytender.sound.rung") == 0, "it is no worse than before"
        source.feed(snapshot(3.0, [row(1, 0.0, **dead), row(2, 0.0, **low)]))
        until(page, "skytender.sound.rung === 1")
        button.click()
        expect(button).to_have_attribute("aria-pressed", "false")
        assert page.evaluate("skytender.sound.audio") is None
        assert watched.wrong == []
        page.close()
