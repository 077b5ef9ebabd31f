"""Signs of a vehicle's state in map and space: told apart by shape and by colour, for four kinds of sight.

Protanopia, deuteranopia and tritanopia by the matrices of G. M. Machado, M. M. Oliveira, L. A. F. Fernandes: A
Physiologically-based Model for Simulation of Color Vision Deficiency, IEEE TVCG 15(6), 2009, severity 1; they work on
linear RGB. Distances are CIE 1976 ΔE*ab; 2.3 is just noticeable (Mahy et al. 1994).
"""

from __future__ import annotations

import base64
import io
from itertools import combinations, product
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from PIL import Image
from playwright.sync_api import Browser, Page
from web import Script, Watched, row, served, session, snapshot, until

from gcs.scenario.colours import ALARM_DARK, ALARM_LIGHT, DARK, LIGHT

Floats = npt.NDArray[np.float64]
SIGHTS: dict[str, Floats] = {
    "normal": np.eye(3),
    "protanopia": np.array(
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]
    ),
    "deuteranopia": np.array(
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]
    ),
    "tritanopia": np.array(
        [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]]
    ),
}
INKS = {"light": "#1b1f24", "dark": "#e6e9ed"}
APART = 20.0
CONDITIONS = ("", "dead", "silent", "failing", "low", "warned")
COUNT = 48
"""More than are named: only signs stand beside the vehicles."""
REACH = 17
BESIDE_GRID = 18.0
"""In lightness: lines of the grid differ less from the ground."""
MOST_ALIKE, LEAST_APART = 1, 4
"""Pixels of one picture with none of the other beside them: of one state at most, of two states at least."""


def linear(srgb: Floats) -> Floats:
    """IEC 61966-2-1, 0..1."""
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def lab(rgb: Floats) -> Floats:
    """CIE L*a*b* (D65) of linear RGB (..., 3)."""
    to_xyz = np.array(
        [[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.072175], [0.0193339, 0.119192, 0.9503041]]
    )
    xyz = np.clip(rgb, 0.0, 1.0) @ to_xyz.T / np.array([0.95047, 1.0, 1.08883])
    f = np.where(xyz > (6 / 29) ** 3, np.cbrt(xyz), xyz * (29 / 6) ** 2 / 3 + 4 / 29)
    return np.stack([116 * f[..., 1] - 16, 500 * (f[..., 0] - f[..., 1]), 200 * (f[..., 1] - f[..., 2])], axis=-1)


def hexed(colour: str) -> Floats:
    return linear(np.array([int(colour[k : k + 2], 16) for k in (1, 3, 5)]) / 255.0)


@pytest.mark.parametrize("sight", SIGHTS)
@pytest.mark.parametrize(
    ("alarm", "others"),
    [(ALARM_LIGHT, (*LIGHT, INKS["light"], "#ffffff")), (ALARM_DARK, (*DARK, INKS["dark"], "#12161b"))],
)
def test_the_alarms_colour_is_no_vehicles(sight: str, alarm: str, others: tuple[str, ...]) -> None:
    """Nor the other signs' ink, nor the ground."""
    seen = [lab(hexed(colour) @ SIGHTS[sight].T) for colour in (alarm, *others)]
    distances = {colour: float(np.linalg.norm(seen[0] - other)) for colour, other in zip(others, seen[1:], strict=True)}
    assert min(distances.values()) > APART, distances


def states() -> list[dict[str, Any]]:
    """Side by side two of each condition in the air and two that have landed, the rest behind them; none so badly off
    that its id is written."""
    rows = []
    for k in range(COUNT):
        condition = CONDITIONS[k // 2] if k < 12 else ""
        landed = k // 2 == 6
        place = [20.0 * (k % 2), 10.0 * (k // 2), 0.0 if landed else -5.0] if k < 14 else [40.0, 30.0, -5.0]
        rows.append(
            row(k + 1, 0.0, condition=condition, landed=landed, p_ned=place, battery=0.3, alive=condition != "dead")
        )
    return rows


def signs(page: Page, view: str) -> dict[int, Floats]:
    """Pictures (RGB, linear) around the first 14 vehicles, by system id."""
    canvas = "canvas.map" if view == "map" else "canvas.names"
    url = page.evaluate(f"document.querySelector('{canvas}').toDataURL()")
    picture = Image.open(io.BytesIO(base64.b64decode(url.split(",")[1]))).convert("RGBA")
    ground = Image.new("RGBA", picture.size, page.evaluate("getComputedStyle(document.body).backgroundColor"))
    seen = linear(np.asarray(Image.alpha_composite(ground, picture).convert("RGB")) / 255.0)
    found = {}
    for place in page.evaluate(f"skytender.{view}.places.filter((one) => one.sysid <= 14)"):
        x, y = round(place["x"]), round(place["y"])
        found[place["sysid"]] = seen[y - REACH : y + REACH + 1, x - REACH : x + REACH + 1]
        assert found[place["sysid"]].shape == (2 * REACH + 1, 2 * REACH + 1, 3), "no vehicle at an edge"
    return found


def strays(picture: npt.NDArray[np.bool_], other: npt.NDArray[np.bool_]) -> int:
    """How many pixels of a picture have none of the other among themselves and their eight neighbours."""
    near = np.zeros_like(other)
    for down, right in product((-1, 0, 1), repeat=2):
        near |= np.roll(other, (down, right), (0, 1))
    return int(np.count_nonzero(picture & ~near))


def seen_by(name: str, found: dict[int, Floats]) -> None:
    """Pictures of two states differ for a kind of sight, and pictures of one state do not."""
    light = {sysid: lab(seen @ SIGHTS[name].T)[..., 0] for sysid, seen in found.items()}
    ground = np.median(light[1])
    shape = {sysid: np.abs(one - ground) > BESIDE_GRID for sysid, one in light.items()}
    for a, b in combinations(shape, 2):
        apart = strays(shape[a], shape[b]) + strays(shape[b], shape[a])
        same = (a - 1) // 2 == (b - 1) // 2
        assert (apart <= MOST_ALIKE) if same else (apart >= LEAST_APART), (name, a, b, apart)


@pytest.mark.slow
def test_states_differ_in_shape_for_every_sight(browser: Browser) -> None:
    rows = states()
    members = session(rows)
    members["vehicles"] = [{**one, "colour": 0} for one in members["vehicles"]]
    with served(Script(members, snapshot(1.0, rows))) as links:
        watched = Watched(browser)
        page = watched.flying(links["command"])
        page.keyboard.press("v")
        for _ in range(2):  # none at the picture's edge
            page.locator("canvas.space").press("-")
        for view, dark in (("space", False), ("space", True), ("map", True), ("map", False)):
            watched.look(1280, 900, dark=dark)
            page.keyboard.press("m" if view == "map" else "3")
            shown = f"skytender.{view}.places.length === {COUNT}"
            until(page, f"skytender.view === '{view}' && !skytender.{view}.dirty && !skytender.dirty && {shown}")
            for name in SIGHTS:
                seen_by(name, signs(page, view))
        assert watched.wrong == []
        page.close()
