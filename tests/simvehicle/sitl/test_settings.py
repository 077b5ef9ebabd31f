"""What autopilots of others are given at their start, by version: against the parameters of their builds, where those
are named, and against the notes of their releases."""

from __future__ import annotations

import json
import math
import os
import re
from collections.abc import Sequence
from pathlib import Path

import pytest

from simvehicle.sitl import ardupilot_process, px4_process
from simvehicle.sitl.settings import Setting, given

PX4 = os.environ.get("SKYTENDER_PX4", "")
RENAMED = {
    "px4": [
        ("1.17", "SDLOG_MODE", "SDLOG_BACKEND"),
        ("1.18", "SIM_BAT_ENABLE", "SIM_BAT_DRAIN"),
        ("1.18", "EKF2_GPS_DELAY", "SENS_GPS0_DELAY"),
        ("1.18", "EKF2_GPS_DELAY", "SENS_GPS1_DELAY"),
    ],
    "ardupilot": [("4.6", "GPS_TYPE", "GPS1_TYPE")],
}
"""First release with the new name, the old name, the new one."""
OTHER_BEFORE = {"SDLOG_MODE", "SIM_BAT_DRAIN"}
"""Names that a release has in which they do not do what is meant: -1 of the first turned logs off until 1.16, 0 of the
second turns the simulated battery off from 1.18 on."""
SETTINGS = {"px4": px4_process.SETTINGS, "ardupilot": ardupilot_process.SETTINGS}
RELEASES = {"px4": ["1.14.3", "1.15.4", "1.16.0", "1.17.0", "1.18.0-rc1"], "ardupilot": ["4.5.7", "4.6.2", "4.8.0-dev"]}


def names(settings: Sequence[Setting], release: str) -> set[str]:
    return {setting.name for setting in settings if setting.applies(release)}


@pytest.mark.parametrize(("kind", "release"), [(kind, r) for kind, releases in RELEASES.items() for r in releases])
def test_each_release_has_one_name_for_each_thing(kind: str, release: str) -> None:
    """A release knows the old name or the new ones, and of all that never changed its name each."""
    known = names(SETTINGS[kind], release)
    for first, old, new in RENAMED[kind]:
        is_new = [int(part) for part in release.split(".")[:2]] >= [int(part) for part in first.split(".")]
        assert {old, new} & known == {new if is_new else old}
    changed = {name for _, *both in RENAMED[kind] for name in both}
    assert {setting.name for setting in SETTINGS[kind]} - changed == known - changed


@pytest.mark.parametrize("kind", SETTINGS)
def test_all_are_given_whatever_the_version_is(kind: str) -> None:
    values = given(SETTINGS[kind])
    assert len(values) == len(SETTINGS[kind])
    assert all(math.isfinite(value) for value in values.values())


@pytest.mark.skipif(not PX4, reason="SKYTENDER_PX4 names no build/px4_sitl_default")
def test_a_built_px4_has_the_parameters_of_its_version_and_no_other() -> None:
    build = Path(PX4)
    listed = {row["name"] for row in json.loads((build / "parameters.json").read_text())["parameters"]}
    header = next(build.rglob("build_git_version.h")).read_text()
    tag = re.search(r'#define PX4_GIT_TAG_STR\s+"v?([0-9][^"]*)"', header)
    assert tag is not None
    applied = names(SETTINGS["px4"], tag[1])
    assert applied <= listed
    others = {setting.name for setting in SETTINGS["px4"]} - applied
    assert others & listed <= OTHER_BEFORE
