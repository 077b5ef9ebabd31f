"""Programs of real autopilots on this machine: where they are looked for, and which version they are."""

from __future__ import annotations

import mmap
import os
import re
import shutil
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True, kw_only=True)
class AutopilotProgram:
    """One kind of autopilot that a scenario's `autopilot: {KEY: PATH}` may name."""

    name: str
    key: str
    variable: str
    """environment variable that names it for the tests"""
    command: str
    """its name on PATH"""
    usual: str
    """where a build leaves it, as a rule"""
    form: str
    """a word for what PATH is"""
    program: str
    """what PATH has to be"""
    inner: str
    """the program below PATH, where that is a folder"""
    build: str
    """how it is made, in its own checkout"""
    flown: tuple[str, ...]
    """versions that have flown in sessions of the tests"""
    version: re.Pattern[bytes]
    """its version in its program, as the first group"""
    header: str = ""
    """a file of its build, beside the folder of its program, that says its version more surely; empty without one"""
    header_version: re.Pattern[bytes] = re.compile(rb"$^")
    """its version there"""

    def found(self) -> Path | None:
        """The first that there is: by the variable, on PATH, where builds leave it."""
        named, on_path = os.environ.get(self.variable), shutil.which(self.command)
        places = [*(Path(name) for name in (named, on_path) if name), Path(self.usual).expanduser()]
        return next((place for place in places if os.access(self._program(place), os.X_OK)), None)

    def release(self, path: Path) -> str | None:
        """The version that it was built as, such as 4.5.7; None where it names none."""
        program = self._program(path)
        header = program.resolve().parents[1] / self.header
        if self.header and header.is_file() and (said := self.header_version.search(header.read_bytes())):
            return said[1].decode()
        if not program.stat().st_size:
            return None
        with program.open("rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as content:
            found = self.version.search(content)
            return found[1].decode() if found else None

    def _program(self, path: Path) -> Path:
        program = path / self.inner if self.inner and path.is_dir() else path
        return program if program.is_file() else path / "none"


REAL_AUTOPILOTS = (
    AutopilotProgram(
        name="ArduCopter",
        key="ardupilot",
        variable="SKYTENDER_ARDUCOPTER",
        command="arducopter",
        usual="~/ardupilot/build/sitl/bin/arducopter",
        form="program",
        program="build/sitl/bin/arducopter",
        inner="",
        build="the target copter of ArduPilot for the board sitl (ardupilot.org/dev says how)",
        flown=("4.8.0-dev", "4.6.2", "4.6.0-dev"),
        version=re.compile(rb"ArduCopter V([0-9]+\.[0-9]+[0-9A-Za-z.-]*)"),
    ),
    AutopilotProgram(
        name="PX4",
        key="px4",
        variable="SKYTENDER_PX4",
        command="px4",
        usual="~/PX4-Autopilot/build/px4_sitl_default",
        form="build",
        program="build/px4_sitl_default",
        inner="bin/px4",
        build="the target px4_sitl_default of PX4-Autopilot (docs.px4.io says how)",
        flown=("1.18.0-rc1", "1.18.0-beta1-38-g83c4f4e580", "1.17.0", "1.14.0-beta2-4431-gb765769f50"),
        # its tag, the name of its branch where it was built on one, and its commit
        version=re.compile(rb"\0v([0-9]+\.[0-9]+\.[0-9]+[0-9A-Za-z.-]*)\0+(?:(?!v[0-9])[^\0]+\0+)?[0-9a-f]{40}\0"),
        header="src/lib/version/build_git_version.h",
        header_version=re.compile(rb'PX4_GIT_TAG_STR\s+"v([^"]+)"'),
    ),
)
