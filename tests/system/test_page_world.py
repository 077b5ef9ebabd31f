"""An obstacle that a program moves in flight, on the page of the session while it flies and in its report, in Debian's
Chromium."""

from __future__ import annotations

import io
from collections.abc import Iterator
from pathlib import Path

import pytest
import yaml
from PIL import Image
from playwright.sync_api import Browser, Page, expect
from web import CHROMIUM, MISSING, Watched, chromium, served, until

import gcs
from gcs.report.page import make
from gcs.session.client import SessionSource

pytestmark = pytest.mark.skipif(CHROMIUM is None, reason=MISSING)
BEFORE_NE, AFTER_NE = (6.0, -8.0), (-4.0, 9.0)
MOVED_S = 3.0
SCENARIO = {
    "schema": 1, "name": "moved", "axes": "ned", "origin": {"lat_deg": 47.3977, "lon_deg": 8.5456, "alt_m": 488},
    "goal": {"duration_s": 60}, "vehicles": {"defaults": {"battery": {"capacity_j": 60000}},
    "pursuers": [{"sysid": 1, "start_m": [0, 0, 0]}]},
    "obstacles": [
        {"name": name, "cylinder_m": [*place], "radius_m": 1.5, "bottom_m": 0, "top_m": -9}
        for name, place in (("pillar", BEFORE_NE), ("post", (12.0, 16.0)), ("stake", (-12.0, -16.0)))
    ],
}  # fmt: skip


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with chromium() as browser:
        yield browser


def fly_until(session: gcs.Session, page: Page, time_s: float) -> None:
    """Fly on to a time, and wait until the page shows it."""
    while (snapshot := session.step()).time_s < time_s:
        pass
    until(page, f"skytender.current.t_s > {snapshot.time_s - 0.01}")


def filled(page: Page, app: str) -> list[bool]:
    """Whether the map has a solid at the place before, and at the one after; it has none between."""
    page.keyboard.press("m")
    expect(page.locator("canvas.map")).to_be_visible()
    until(page, f"!{app}.map.dirty && !{app}.dirty")
    seen = Image.open(io.BytesIO(page.locator("canvas.map").screenshot())).convert("RGB")
    frame = page.evaluate(f"{app}.map.frame")

    def colour(north_m: float, east_m: float) -> object:
        x = frame["width"] / 2 + (east_m - frame["e"]) * frame["perMetre"]
        y = frame["height"] / 2 - (north_m - frame["n"]) * frame["perMetre"]
        return seen.getpixel((round(x), round(y)))

    paper = colour(4.3, 5.3)
    assert colour(-3.3, -4.3) == paper
    return [colour(north + 0.4, east + 0.3) != paper for north, east in (BEFORE_NE, AFTER_NE)]


def in_space(page: Page, app: str, place_ne: tuple[float, float]) -> None:
    """Wait until a corner of an obstacle in space is near a place: x east, z south."""
    page.keyboard.press("3")
    corners = f"[...Array({app}.space.solid?.geometry.attributes.position.count ?? 0).keys()]"
    x, z = (f"{app}.space.solid.geometry.attributes.position.get{axis}(k)" for axis in "XZ")
    until(page, f"{corners}.some((k) => Math.hypot({x} - {place_ne[1]}, {z} + {place_ne[0]}) < 1.5)")


def test_a_moved_obstacle_is_where_it_was_at_each_time(tmp_path: Path, browser: Browser) -> None:
    path = tmp_path / "scenario.yaml"
    path.write_text(yaml.safe_dump(SCENARIO), encoding="utf-8")
    with gcs.Session(path, lockstep=True, out=tmp_path / "out") as session:
        session.step()
        with served(SessionSource(session.folder)) as links:
            watched = Watched(browser)
            page = watched.flying(links["view"])
            fly_until(session, page, MOVED_S)
            assert filled(page, "skytender") == [True, False]
            session.obstacles.move("pillar", AFTER_NE)
            fly_until(session, page, MOVED_S + 2.0)
            assert filled(page, "skytender") == [False, True]
            in_space(page, "skytender", AFTER_NE)
            page.evaluate("skytender.player.seek(skytender.flight.first_s)")
            in_space(page, "skytender", BEFORE_NE)
            assert filled(page, "skytender") == [True, False]
            assert watched.wrong == []
            page.close()
    watched = Watched(browser)
    page = watched.open(f"{make(session.folder).as_uri()}#t=1")
    until(page, "document.documentElement.dataset.all")
    page.evaluate("skytender.then((app) => { window.app = app; })")
    for t_s, there in ((1.0, [True, False]), (MOVED_S + 1.0, [False, True])):
        page.get_by_role("slider", name="time").fill(str(t_s))
        until(page, f"Math.abs(app.current.t_s - {t_s}) < 1e-6")
        assert filled(page, "app") == there
        in_space(page, "app", AFTER_NE if there[1] else BEFORE_NE)
    assert watched.wrong == []
    page.close()
