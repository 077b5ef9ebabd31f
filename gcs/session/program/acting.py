"""Set points, commands and parameters of a program in Python, checked before they are sent to its session."""

from __future__ import annotations

import math
import operator
import struct
import sys
from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from gcs.planner.request import FARTHEST
from gcs.scenario.document import did_you_mean
from gcs.scenario.faults import Fault
from gcs.scenario.types import plain_numbers
from gcs.supervisor.operator import COMMANDS
from skytender import mavlink as mav

MOST_PARAMS = 7
_PREFIX = "MAV_CMD_"


def known(sysid: Any, sysids: Collection[int]) -> int:
    """A system id as it is. Raises ValueError where no vehicle has it."""
    try:
        number = operator.index(sysid)
    except TypeError:
        raise ValueError(f"{sysid!r:.40} is no system id: give a vehicle's number, one of {_listed(sysids)}") from None
    if number not in sysids:
        raise ValueError(f"there is no vehicle {number} in this session: it has {_listed(sysids)}")
    return number


def checked_set_points(set_points: Mapping[int, ArrayLike], sysids: Collection[int]) -> dict[int, list[float]]:
    """Six numbers for each vehicle: position, m, and velocity, m/s, common NED frame. Raises ValueError."""
    if not isinstance(set_points, Mapping):
        raise ValueError(
            "set_points is a mapping from system id to (p_ned, v_ned), such as {1: ((0, 0, -5), (0, 0, 0))}"
        )
    try:
        numbers = np.array(list(set_points.values()), dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        numbers = np.empty(0)
    if set_points and (numbers.shape != (len(set_points), 2, 3) or not np.all(np.abs(numbers) <= FARTHEST)):
        for sysid, pair in set_points.items():
            _check_pair(sysid, pair)
    rows: list[list[float]] = numbers.reshape(-1, 6).tolist()
    return {known(sysid, sysids): six for sysid, six in zip(set_points, rows, strict=True)}


def _check_pair(sysid: int, pair: ArrayLike) -> None:
    what = f"the set point of vehicle {sysid}"
    try:
        numbers = np.asarray(pair, dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        raise ValueError(f"{what} is not (p_ned, v_ned) of three numbers each") from None
    if numbers.shape != (2, 3):
        raise ValueError(f"{what} has the shape {numbers.shape}, not (2, 3): (p_ned, v_ned) of three numbers each")
    for number in numbers.ravel().tolist():
        if not abs(number) <= FARTHEST:
            shown = "NaN" if math.isnan(number) else f"{number:g}"
            raise ValueError(f"{what} holds {shown}, which is no place or speed: m and m/s up to {FARTHEST:g}")


def checked_commands(commands: Iterable[Sequence[Any]]) -> list[Sequence[Any]]:
    """Arguments of `command`, a tuple each. Raises ValueError."""
    rows = list(commands) if isinstance(commands, Iterable) else [commands]
    for row in rows:
        if isinstance(row, str) or not isinstance(row, Sequence) or len(row) < 2:
            raise ValueError(f"commands are tuples such as (1, 'hold'), and {row!r:.40} is none")
    return rows


def checked_command(command: str | int, params: Sequence[float]) -> tuple[str, int | None]:
    """An operator's order, or a MAV_CMD's name with its number. Raises ValueError."""
    if isinstance(command, str) and command in COMMANDS:
        wanted = 1 if command == "retarget" else 0
        if len(params) != wanted:
            needs = "needs the system id of the new target" if wanted else "takes no parameters"
            raise ValueError(f"{command} {needs}, not {len(params)} more")
        return command, None
    number, name = _mav_cmd(command)
    if len(params) > MOST_PARAMS:
        raise ValueError(f"{name} has {len(params)} parameters; a MAV_CMD has up to {MOST_PARAMS}")
    return name, number


def checked_params(name: str, params: Sequence[float]) -> list[float | None]:
    """Parameters of a MAV_CMD, None for NaN. Raises ValueError."""
    return [_param(name, index, value) for index, value in enumerate(params, 1)]


def _mav_cmd(command: str | int) -> tuple[int, str]:
    names = mav.ENUMS["MAV_CMD"]
    if isinstance(command, str):
        numbers = {name: number for number, name in names.items()}
        full = command if command.startswith(_PREFIX) else _PREFIX + command
        if full not in numbers:
            near = did_you_mean(command, (*COMMANDS, *numbers))
            raise ValueError(f"{command[:48]!r} is neither an order ({', '.join(COMMANDS)}) nor a MAV_CMD{near}")
        return numbers[full], full
    try:
        number = operator.index(command)
    except TypeError:
        raise ValueError(f"a command is an order's name, or a MAV_CMD by name or number, not {command!r:.40}") from None
    if not 0 <= number < 1 << 16:
        raise ValueError(f"{number} is no MAV_CMD: these are 0 to 65535")
    return number, names.get(number, f"{_PREFIX}{number}")


def _param(name: str, index: int, value: Any) -> float | None:
    try:
        number = float(value)
        struct.pack("<f", number)
    except (TypeError, ValueError):
        raise ValueError(f"parameter {index} of {name} is {value!r:.40}, and not a number") from None
    except OverflowError:
        raise ValueError(f"parameter {index} of {name} is {value!r:.40}, more than its float32 holds") from None
    if math.isinf(number):
        raise ValueError(f"parameter {index} of {name} is infinite; NaN leaves it unset")
    return None if math.isnan(number) else number


def _listed(sysids: Collection[int]) -> str:
    """`1 to 3, 101`."""
    parts: list[list[int]] = []
    for sysid in sorted(sysids):
        if parts and sysid == parts[-1][-1] + 1:
            parts[-1][1:] = [sysid]
        else:
            parts.append([sysid])
    return ", ".join(" to ".join(map(str, part)) for part in parts)


def keys_of(fault: Fault | Mapping[str, Any], sysids: Collection[int]) -> Any:
    """The keys of a fault; of what is none, how it is written, for the session's refusal.

    Raises ValueError where it names a vehicle that is not there, and for numbers that are not finite: a message to the
    session cannot hold them.
    """
    if isinstance(fault, Fault):
        fault = fault.model_dump(mode="json", exclude_unset=True)
    if not isinstance(fault, Mapping):
        return repr(fault)
    keys = plain_numbers(dict(fault))
    if keys.get("sysid") is not None:
        known(keys["sysid"], sysids)
    for key, value in keys.items():
        for number in value if isinstance(value, Sequence) else (value,):
            if isinstance(number, int | float) and not abs(number) <= sys.float_info.max:
                raise ValueError(f"{key} of a fault must be a finite number, not {number!r:.40}")
    return keys
