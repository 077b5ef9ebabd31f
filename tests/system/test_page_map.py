"""The map in Debian's Chromium, by the colours of its pixels: tiles, missions, fences, and an obstacle that moves in
flight."""

from __future__ import annotations

import io
import math
from pathlib import Path

import pymap3d
import pytest
import yaml
from mission_tapes import AWAY_DEG, LAT_DEG, LON_DEG, VEHICLE, Tape, north
from PIL import Image
from playwright.sync_api import Browser, Page, Route, expect
from pymavlink.dialects.v20 import ardupilotmega as mav
from web import MapPicture, Script, Watched, row, served, session, snapshot, until

import gcs
from gcs.missions.files import read
from gcs.report.page import make
from gcs.session.client import SessionSource
from gcs.session.replay import Replay, ReplaySource

FENCE = f"""QGC WPL 110
0 0 0 5003 400 0 0 0 {LAT_DEG} {LON_DEG} 0 0
1 0 0 5004 60 0 0 0 {LAT_DEG - AWAY_DEG} {LON_DEG} 0 0
2 0 3 5100 0 0 0 0 {LAT_DEG} {LON_DEG + AWAY_DEG} 30 0
"""
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
Colour = tuple[int, int, int]


def test_tiles_lie_under_the_map_where_they_belong_and_the_wind_is_shown(browser: Browser) -> None:
    lat, lon = 47.397742, 8.545594
    rows = [row(1, 0.0, p_ned=[400.0, -300.0, -5.0]), row(2, 0.0, p_ned=[-350.0, 250.0, -5.0])]
    told = session(rows, origin=[lat, lon, 400.0], wind={"speed_m_s": 6.0, "from_deg": 250.0})
    asked: list[tuple[int, int, int]] = []

    def tile(route: Route) -> None:
        z, x, y = (int(word) for word in route.request.url.removeprefix("https://tiles.example/").split("/"))
        asked.append((z, x, y))
        picture = io.BytesIO()
        Image.new("RGB", (256, 256), shade(x, y)).save(picture, "PNG")
        route.fulfill(body=picture.getvalue(), content_type="image/png")

    def shade(x: int, y: int) -> Colour:
        return 40 * (x % 6), 40 * (y % 6), 255

    with served(Script(told, snapshot(1.0, rows)), "https://tiles.example/{z}/{x}/{y}") as links:
        watched = Watched(browser)
        watched.page.route("https://tiles.example/**", tile)
        page = watched.flying(links["command"])
        expect(page.locator(".wind")).to_have_text("wind 6.0 m/s from 250°")
        page.keyboard.press("m")
        pictures = "[...skytender.map.tiles.kept.values()]"
        until(page, f"skytender.map.tiles.kept.size > 0 && {pictures}.every((one) => one.complete)")
        seen = MapPicture(page)
        ((z, *_), *_) = asked
        for north_m, east_m in ((130.0, -170.0), (-210.0, 90.0), (20.0, 205.0), (-333.0, -140.0)):
            there_lat, there_lon, _ = pymap3d.ned2geodetic(north_m, east_m, 0.0, lat, lon, 400.0)
            # The tile of a place: https://wiki.openstreetmap.org/wiki/Slippy_map_tilenames
            across = (there_lon + 180.0) / 360.0 * 2**z
            s = math.sin(math.radians(there_lat))
            down = (0.5 - math.log((1.0 + s) / (1.0 - s)) / (4.0 * math.pi)) * 2**z
            assert min(across % 1.0, 1.0 - across % 1.0, down % 1.0, 1.0 - down % 1.0) > 0.02, "at no tile's edge"
            assert seen.colours(north_m, east_m) == [shade(int(across), int(down))], (north_m, east_m)
        watched.well()
        page.close()


def green(colour: Colour) -> bool:
    return colour[1] > colour[0] + 40 and colour[1] > colour[2] + 15


def red(colour: Colour) -> bool:
    return colour[0] > colour[1] + 60 and colour[0] > colour[2] + 60


def red_of(colour: Colour) -> float:
    """By how much there is more red than blue and green."""
    return colour[0] - (colour[1] + colour[2]) / 2.0


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
        for words in ("NAV_WAYPOINT", "30.0 m", "above home"):
            expect(rows.nth(1)).to_contain_text(words)
        expect(rows.nth(1)).to_have_attribute("aria-current", "step")
        seen = MapPicture(page)
        # A corner of the picture; the other places are given with what lies around them, for lines are dashed.
        (paper,) = seen.colours(-420.0, -420.0)
        assert any(green(colour) for colour in seen.colours(0.0, 400.0, 9)), "the border to stay inside"
        assert any(red(colour) for colour in seen.colours(-111.2 - 60.0, 0.0, 9)), "the border to stay out of"
        assert red_of(*seen.colours(-111.2, 20.0)) > red_of(paper), "the area to stay out of is tinted"
        assert any(sum(colour) < sum(paper) - 200 for colour in seen.colours(222.4, 0.0, 9)), "the second item"
        watched.well()
        page.close()


def fly_until(flying: gcs.Session, page: Page, time_s: float) -> None:
    """Fly on to a time, and wait until the page shows it."""
    while (told := flying.step()).time_s < time_s:
        pass
    until(page, f"skytender.current.t_s > {told.time_s - 0.01}")


def stands(page: Page, place_ne: tuple[float, float]) -> None:
    """The obstacle is at this one: the map is filled there alone, and in space (x east, z south) a corner is near."""
    seen = MapPicture(page)
    (paper,) = seen.colours(4.3, 5.3)
    assert seen.colours(-3.3, -4.3) == [paper]
    filled = [seen.colours(north_m + 0.4, east_m + 0.3) != [paper] for north_m, east_m in (BEFORE_NE, AFTER_NE)]
    assert filled == [place_ne == BEFORE_NE, place_ne == AFTER_NE]
    page.keyboard.press("3")
    corners = "[...Array(skytender.space.solid?.geometry.attributes.position.count ?? 0).keys()]"
    x, z = (f"skytender.space.solid.geometry.attributes.position.get{axis}(k)" for axis in "XZ")
    until(page, f"{corners}.some((k) => Math.hypot({x} - {place_ne[1]}, {z} + {place_ne[0]}) < 1.5)")


@pytest.mark.slow
def test_a_moved_obstacle_is_where_it_was_at_each_time(tmp_path: Path, browser: Browser) -> None:
    path = tmp_path / "scenario.yaml"
    path.write_text(yaml.safe_dump(SCENARIO), encoding="utf-8")
    with gcs.Session(path, lockstep=True, out=tmp_path / "out") as flying:
        flying.step()
        with served(SessionSource(flying.folder)) as links:
            watched = Watched(browser)
            page = watched.flying(links["view"])
            fly_until(flying, page, MOVED_S)
            stands(page, BEFORE_NE)
            flying.obstacles.move("pillar", AFTER_NE)
            fly_until(flying, page, MOVED_S + 2.0)
            stands(page, AFTER_NE)
            page.evaluate("skytender.player.seek(skytender.flight.first_s)")
            until(page, "skytender.current.t_s === skytender.flight.first_s")
            stands(page, BEFORE_NE)
            assert watched.wrong == []
            page.close()
    watched = Watched(browser)
    page = watched.report(f"{make(flying.folder).as_uri()}#t=1")
    for t_s, there in ((1.0, BEFORE_NE), (MOVED_S + 1.0, AFTER_NE)):
        page.get_by_role("slider", name="time").fill(str(t_s))
        until(page, f"Math.abs(skytender.current.t_s - {t_s}) < 1e-6")
        stands(page, there)
    assert watched.wrong == []
    page.close()
