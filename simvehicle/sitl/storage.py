"""Storage of a vehicle's parameters and plans beyond its process: two JSON files per vehicle in a folder of the
user's."""

from __future__ import annotations

import contextlib
import json
import math
import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

Row = tuple[float, ...]
"""One item of a plan as the wire carries it: command, frame, params 1..4, x, y, z, autocontinue."""
_KINDS = ("mission", "fence", "rally")
"""The file's names of MAV_MISSION_TYPE 0, 1 and 2."""
_WHOLE = {0: (0, 2**16 - 1), 1: (0, 255), 6: (-(2**31), 2**31 - 1), 7: (-(2**31), 2**31 - 1), 9: (0, 255)}
"""Places in a row that hold whole numbers, and what their fields can hold; the others are 32-bit floats."""
_ROW_LENGTH = 10
_LARGEST_FLOAT = 3.4028235e38


class StateError(ValueError):
    """A state file that cannot be read as one; the text names it."""


class StateFile:
    """Parameters and plans of one vehicle: SYSID.parameters.json and SYSID.plans.json in `folder`, made where missing.

    `values` holds the parameters that were changed, `plans` the items in force by MAV_MISSION_TYPE.
    """

    def __init__(self, folder: Path, sysid: int) -> None:
        """Read what was kept before; raises StateError, and OSError where the folder cannot be used."""
        folder.mkdir(parents=True, exist_ok=True)
        self.path = folder / f"{sysid}.parameters.json"
        self.plans_path = folder / f"{sysid}.plans.json"
        try:
            self.values = {str(name): float(value) for name, value in _read(self.path).items()}
        except (ValueError, AttributeError, TypeError, RecursionError) as error:
            raise _broken(self.path, "parameters") from error
        try:
            content = _read(self.plans_path)
            self.plans = {_KINDS.index(name): tuple(map(_row, rows)) for name, rows in content.items()}
        except (ValueError, AttributeError, TypeError, RecursionError) as error:
            raise _broken(self.plans_path, "plans") from error

    def keep(self, name: str, value: float) -> None:
        """Keep one parameter with the others; all stay as they are where it raises OSError."""
        values = {**self.values, name: value}
        _write(self.path, json.dumps(values, indent=1))
        self.values = values

    def keep_plan(self, kind: int, rows: Iterable[Row]) -> None:
        """Keep the plan of a kind in the place of the one before; the others stay, and all where it raises OSError."""
        plans = {**self.plans, kind: tuple(rows)}
        parts = (
            f" {json.dumps(_KINDS[kind])}: [\n" + ",\n".join(f"  {json.dumps(row)}" for row in rows) + "\n ]"
            for kind, rows in sorted(plans.items())
        )
        _write(self.plans_path, "{\n" + ",\n".join(parts) + "\n}")
        self.plans = plans


def _read(path: Path) -> Any:
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return {}


def _write(path: Path, text: str) -> None:
    """Write a file whole, or leave the old one and raise OSError with its name, which that of a full disk lacks."""
    new = path.with_suffix(".new")
    try:
        new.write_text(text + "\n", encoding="utf-8")
        os.replace(new, path)
    except OSError as error:
        with contextlib.suppress(OSError):
            new.unlink()
        raise OSError(error.errno, error.strerror, str(path)) from error


def _broken(path: Path, what: str) -> StateError:
    return StateError(f"{path} holds no {what}: mend it, or delete it to begin afresh")


def _row(values: Any) -> Row:
    """One item; raises ValueError or TypeError for what no message could carry."""
    numbers = tuple(values)
    if len(numbers) != _ROW_LENGTH:
        raise ValueError(f"{len(numbers)} numbers")
    for at, number in enumerate(numbers):
        if at in _WHOLE:
            least, most = _WHOLE[at]
            fits = isinstance(number, int) and least <= number <= most
        else:
            fits = not math.isfinite(number) or abs(number) <= _LARGEST_FLOAT
        if not fits:
            raise ValueError(f"{number} in place {at}")
    return numbers
