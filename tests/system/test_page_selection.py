"""Several vehicles at once on the page, in Debian's Chromium: selected in table and picture, and given one order."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, expect
from web import CHROMIUM, MISSING, Script, Watched, chromium, row, serious, served, session, snapshot, until

pytestmark = pytest.mark.skipif(CHROMIUM is None, reason=MISSING)


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with chromium() as browser:
        yield browser


class Refusing(Script):
    """A session in which vehicle 2 obeys nothing."""

    def send(self, command: Mapping[str, Any]) -> None:
        if command.get("sysid") == 2:
            self.sent.append(command)
            self.tell({"type": "reply", "id": command["id"], "ok": False, "text": "Pursuer 2 is busy."})
        else:
            super().send(command)


def selected(page: Page) -> list[int]:
    return sorted(page.evaluate("[...skytender.selected]"))


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


def test_several_are_selected_and_ordered_with_one_confirmation(browser: Browser) -> None:
    rows = fleet()
    source = Refusing(session(rows), snapshot(1.0, rows))
    with served(source) as links:
        watched = Watched(browser)
        page = watched.flying(links["command"])
        until(page, "document.querySelectorAll('table.fleet tbody tr').length === 7")
        table = page.locator("table.fleet tbody")  # 7 dead, 6 silent, 1 to 5
        ids = table.get_by_role("button")
        ids.get_by_text("1", exact=True).click()
        ids.get_by_text("3", exact=True).click(modifiers=["Shift"])
        assert selected(page) == [1, 2, 3]
        ids.get_by_text("3", exact=True).click(modifiers=["Control"])
        ids.get_by_text("7", exact=True).click(modifiers=["Control"])
        assert selected(page) == [1, 2, 7]
        page.keyboard.press("m")
        until(page, "!skytender.map.dirty && !skytender.dirty")
        place = page.evaluate("skytender.map.places.find((one) => one.sysid === 5)")
        page.locator("canvas.map").click(position={"x": place["x"], "y": place["y"]}, modifiers=["Shift"])
        assert selected(page) == [1, 2, 5, 7]
        expect(page.locator(".selection")).to_contain_text("4 vehicles selected")
        page.get_by_role("button", name="hold", exact=True).click()
        dialog = page.get_by_role("dialog")
        expect(dialog).to_contain_text("Hold 4 vehicles?")
        expect(dialog.get_by_role("listitem")).to_have_text(["pursuer 7 is dead."])
        assert serious(page) == []
        assert source.sent == []
        dialog.get_by_role("button", name="Yes").click()
        notice = page.locator(".notices .bad")
        expect(notice).to_have_text("hold: 2 of 3 obey. Pursuer 2 is busy.")
        assert sorted((sent["command"], sent["sysid"]) for sent in source.sent) == [
            ("hold", 1),
            ("hold", 2),
            ("hold", 5),
        ]
        assert watched.wrong == []
        page.close()


@pytest.mark.parametrize("width", [390, 1280])
def test_all_are_sent_home_from_wherever_the_page_stands(browser: Browser, width: int) -> None:
    rows = fleet()
    source = Script(session(rows), snapshot(1.0, rows))
    with served(source) as links:
        watched = Watched(browser, width=width, height=720)
        page = watched.flying(links["command"])
        page.evaluate("scrollTo(0, document.body.scrollHeight)")
        page.get_by_role("button", name="all: return").click()
        assert page.evaluate("scrollY > 300"), "it was in reach"
        dialog = page.get_by_role("dialog")
        expect(dialog).to_contain_text("Return all 7 vehicles?")
        expect(dialog.get_by_role("listitem")).to_have_text(
            ["pursuer 6 has not sent any telemetry yet.", "pursuer 7 is dead."]
        )
        dialog.get_by_role("button", name="Yes").click()
        expect(page.locator(".notices .good")).to_have_text("return: 5 of 5 obey.")
        assert sorted(sent["sysid"] for sent in source.sent) == [1, 2, 3, 4, 5]
        page.close()
        viewer = Watched(browser).flying(links["view"])
        expect(viewer.get_by_role("button", name="all: return")).to_be_hidden()
        viewer.close()
