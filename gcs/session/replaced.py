"""Parameters and plans of external vehicles as they were before a session changed them, in its folder."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from gcs.mavlink.ids import AUTOPILOT
from gcs.mavlink.parameters import file
from gcs.mavlink.parameters.value import ParameterValue
from gcs.mavlink.plans.items import PlanItem, plan_of
from gcs.missions import qgc_plan
from gcs.supervisor.preflight import BEFORE_FILE, PLAN_BEFORE
from gcs.telemetry.state import VehicleView


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


class OldPlans:
    """A .plan of each vehicle, as `gcs mission set` reads it; none as long as nothing has been replaced."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._kept: dict[int, Mapping[int, Sequence[PlanItem]]] = {}

    def keep(
        self, before: Mapping[int, Mapping[int, Sequence[PlanItem]]], vehicle: Callable[[int], VehicleView]
    ) -> None:
        """Write these plans, by system id and MAV_MISSION_TYPE, where there are more than before. Raises OSError."""
        for sysid, parts in before.items():
            if self._kept.get(sysid) == parts:
                continue
            self._kept[sysid] = parts
            path = self._folder / PLAN_BEFORE.format(sysid)
            new = path.with_suffix(".new")
            new.write_text(qgc_plan.write(plan_of(parts, vehicle(sysid).profile.plans)), encoding="utf-8")
            new.replace(path)
