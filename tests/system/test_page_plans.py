"""Missions, fences and rally points on the page, in Debian's Chromium: where they are drawn, and what the list says."""

from __future__ import annotations

import io
from collections.abc import Iterator
from pathlib import Path

import pytest
from mission_tapes import AWAY_DEG, LAT_DEG, LON_DEG, VEHICLE, Tape, north
from PIL import Image
from playwright.sync_api import Browser, Page, expect
from pymavlink.dialects.v20 import ardupilotmega as mav
from web import CHROMIUM, MISSING, Watched, barriers, chromium, served, until

from gcs.missions.files import read
from gcs.session.replay import Replay, ReplaySource

pytestmark = pytest.mark.skipif(CHROMIUM is None, reason=MISSING)
FENCE = f"""QGC WPL 110
0 0 0 5003 400 0 0 0 {LAT_DEG} {LON_DEG} 0 0
1 0 0 5004 60 0 0 0 {LAT_DEG - AWAY_DEG} {LON_DEG} 0 0
2 0 3 5100 0 0 0 0 {LAT_DEG} {LON_DEG + AWAY_DEG} 30 0
"""


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with chromium() as browser:
        yield browser


def test_missions_and_fences_are_drawn_and_listed(tmp_path: Path, browser: Browser) -> None:
    tape = Tape()
    tape.fly(2.0)
    tape.upload([north(1), north(2, 30.0)])
    tape.say(VEHICLE, mav.MAVLink_mission_current_message(1))
    tape.fly(3.0)
    replay = Replay(tape.write(tmp_path / "flight.tlog"), plans={"site.txt": read(FENCE.encode(), "site.txt")})
    replay.seek(4.0)
    with served(ReplaySource(replay, speed=0.01)) as links:
        watched = Watched(browser)
        page = watched.flying(links["command"])
        card = page.get_by_role("region", name="missions and fences")
        expect(card.locator("summary")).to_have_text(["site.txt: 2 fence areas, 1 rally point", "vehicle 3: 2 items"])
        card.locator("summary", has_text="vehicle 3").click()
        rows = card.locator("details", has_text="vehicle 3").locator("tbody tr")
        expect(rows).to_have_count(2)
        expect(rows.nth(1)).to_contain_text("NAV_WAYPOINT")
        expect(rows.nth(1)).to_contain_text("30.0 m")
        expect(rows.nth(1)).to_contain_text("above home")
        expect(rows.nth(1)).to_have_attribute("aria-current", "step")
        page.keyboard.press("m")
        until(page, "!skytender.map.dirty && !skytender.dirty")
        seen = Image.open(io.BytesIO(page.locator("canvas.map").screenshot())).convert("RGB")
        paper = shade(seen, page, -450.0, -450.0)
        assert any(green(colour) for colour in around(seen, page, 0.0, 400.0)), "the border to stay inside"
        assert any(red(colour) for colour in around(seen, page, -111.2 - 60.0, 0.0)), "the border to stay out of"
        assert red_of(shade(seen, page, -111.2, 20.0)) > red_of(paper), "the area to stay out of is tinted"
        assert any(sum(colour) < sum(paper) - 200 for colour in around(seen, page, 222.4, 0.0)), "the second item"
        assert barriers(page) == []
        assert watched.wrong == []
        page.close()


Colour = tuple[int, ...]


def place(page: Page, north_m: float, east_m: float) -> tuple[int, int]:
    frame = page.evaluate("skytender.map.frame")
    x = round(frame["width"] / 2 + (east_m - frame["e"]) * frame["perMetre"])
    return x, round(frame["height"] / 2 - (north_m - frame["n"]) * frame["perMetre"])


def shade(seen: Image.Image, page: Page, north_m: float, east_m: float) -> Colour:
    x, y = place(page, north_m, east_m)
    return tuple(seen.getpixel((min(max(x, 2), seen.width - 3), min(max(y, 2), seen.height - 3))))  # type: ignore[arg-type]


def around(seen: Image.Image, page: Page, north_m: float, east_m: float) -> list[Colour]:
    """Colours within 9 pixels of a place: lines are dashed."""
    x, y = place(page, north_m, east_m)
    return [tuple(seen.getpixel((x + u, y + w))) for u in range(-9, 10) for w in range(-9, 10)]  # type: ignore[arg-type]


def green(colour: Colour) -> bool:
    return colour[1] > colour[0] + 40 and colour[1] > colour[2] + 15


def red(colour: Colour) -> bool:
    return colour[0] > colour[1] + 60 and colour[0] > colour[2] + 60


def red_of(colour: Colour) -> float:
    """By how much there is more red than blue and green."""
    return colour[0] - (colour[1] + colour[2]) / 2.0
