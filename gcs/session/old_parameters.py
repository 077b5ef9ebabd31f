"""Values of external vehicles before a session changed them, in its folder: for a session that cannot put them back."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from gcs.mavlink.ids import AUTOPILOT
from gcs.mavlink.parameters import file
from gcs.mavlink.parameters.value import ParameterValue
from gcs.supervisor.preflight import BEFORE_FILE


class OldParameters:
    """The file, as `gcs params load` reads it; none as long as nothing has been changed."""

    def __init__(self, folder: Path) -> None:
        self._path = folder / BEFORE_FILE
        self._count = 0

    def keep(self, before: Mapping[int, Mapping[str, ParameterValue]]) -> None:
        """Write these values, by system id and name, where there are more than before. Raises OSError."""
        count = sum(map(len, before.values()))
        if count == self._count:
            return
        self._count = count
        rows = [
            file.line((sysid, AUTOPILOT), name, value)
            for sysid, values in sorted(before.items())
            for name, value in values.items()
        ]
        new = self._path.with_suffix(".new")
        new.write_text("\n".join([file.HEAD, *rows, ""]), encoding="utf-8")
        new.replace(self._path)
