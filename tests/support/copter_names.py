"""Names of ArduCopter's parameters that changed with 4.7, by the program that is named for the tests."""

from __future__ import annotations

import re
from pathlib import Path

from gcs.cli.autopilot_programs import REAL_AUTOPILOTS

FIRST_RENAMED = (4, 7)


def of_today(program: Path | str) -> bool:
    """Whether a program has the names since 4.7, in SI units; one that names no version has those of before."""
    if not Path(program).is_file():
        return False
    release = next(kind for kind in REAL_AUTOPILOTS if kind.key == "ardupilot").release(Path(program))
    return release is not None and tuple(map(int, re.findall(r"[0-9]+", release)[:2])) >= FIRST_RENAMED


def speed(program: Path | str, speed_m_s: float) -> dict[str, float]:
    """The parameter of its greatest speed."""
    return {"WP_SPD": speed_m_s} if of_today(program) else {"WPNAV_SPEED": 100.0 * speed_m_s}


def height_of_return(program: Path | str, height_m: float) -> dict[str, float]:
    """The parameter of the height at which it returns."""
    return {"RTL_ALT_M": height_m} if of_today(program) else {"RTL_ALT": 100.0 * height_m}
