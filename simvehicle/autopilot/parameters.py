"""The values of a vehicle's parameters: what it takes of the table of skytender/vehicle/parameters.py.

Changing a value changes the flight.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from difflib import get_close_matches

from simvehicle.law.params import NAMED, BatteryParams, Gains, Limits, VehicleParams
from skytender import mavlink as mav
from skytender.vehicle.parameters import ALONE, ROWS, TABLE, ParameterRow, float32

UNKNOWN: int = mav.MAV_PARAM_ERROR_DOES_NOT_EXIST
OUT_OF_RANGE: int = mav.MAV_PARAM_ERROR_VALUE_OUT_OF_RANGE
READ_ONLY: int = mav.MAV_PARAM_ERROR_READ_ONLY
WRONG_TYPE = 7
"""MAV_PARAM_ERROR_TYPE_MISMATCH, which is younger than pymavlink's dialect."""


class ParameterError(ValueError):
    """An unknown name or a value that the parameter cannot take; the text names both, `code` is PARAM_ERROR's."""

    def __init__(self, text: str, code: int) -> None:
        super().__init__(text)
        self.code = code


GAIN_SETS = ("default", "paper", "paper_literal")
"""Names of the flight law's sets, by SIM_GAIN_SET."""
_DEG = 180.0 / math.pi

READ_ONCE = frozenset({"SIM_BAT_INIT_J", "SIM_GAIN_SET"})
"""Names of parameters that can only be given at start."""


class Parameters:
    """The values of one vehicle, by name, in the table's order."""

    def __init__(self, given: dict[str, float] | None = None, *, alone: bool = False) -> None:
        """`given` overrides defaults; `alone`: no session has launched the vehicle. Raises ParameterError."""
        self.alone = alone
        self.table = (*TABLE, *ALONE) if alone else TABLE
        """rows that it tells, and lets be changed"""
        self._values = {row.name: float32(row.default) for row in (*TABLE, *ALONE)}
        given = given or {}
        self._given = dict(given)
        for name, value in given.items():
            self._values[name] = self._checked(name, value)
        if "SIM_BAT_INIT_J" not in given:
            self._values["SIM_BAT_INIT_J"] = self._values["SIM_BAT_CAP_J"]
        if self._values["SIM_BAT_INIT_J"] > self._values["SIM_BAT_CAP_J"]:
            text = "SIM_BAT_INIT_J is above SIM_BAT_CAP_J: a battery cannot start fuller than full"
            raise ParameterError(text, OUT_OF_RANGE)
        try:
            self.flight()
        except ValueError as error:  # each is within its range, but gains go together
            raise ParameterError(f"the flight law refuses these values: {error}", OUT_OF_RANGE) from error

    def __getitem__(self, name: str) -> float:
        return self._values[name]

    def __iter__(self) -> Iterator[tuple[ParameterRow, float]]:
        return ((row, self._values[row.name]) for row in self.table)

    def __len__(self) -> int:
        return len(self.table)

    def row_at(self, key: str | int) -> tuple[int, ParameterRow] | None:
        """Index and row of a parameter by name or by its place in the table; None where there is none."""
        if isinstance(key, int):
            return (key, self.table[key]) if 0 <= key < len(self.table) else None
        return next(((index, row) for index, row in enumerate(self.table) if row.name == key), None)

    @staticmethod
    def _checked(name: str, value: float) -> float:
        row = ROWS.get(name)
        if row is None:
            near = get_close_matches(name.upper(), ROWS, 1)
            raise ParameterError(f"unknown parameter {name}" + (f", did you mean {near[0]}?" if near else ""), UNKNOWN)
        if not (math.isfinite(value) and row.least <= value <= row.most):
            raise ParameterError(f"{name} = {value:g} is outside {row.least:g} .. {row.most:g}", OUT_OF_RANGE)
        return float(round(value)) if row.whole else float32(value)

    def set(self, name: str, value: float) -> float:
        """Change a value while the vehicle runs; returns what is now in force; raises ParameterError, value kept."""
        if name in READ_ONCE:
            raise ParameterError(f"{name} can only be given at start", READ_ONLY)
        before = self._values.get(name)
        self._values[name] = self._checked(name, value)
        try:
            self.flight()
        except ValueError as error:
            assert before is not None
            self._values[name] = before
            raise ParameterError(f"{name} = {value:g} is refused: {error}", OUT_OF_RANGE) from error
        return self._values[name]

    def values(self) -> dict[str, float]:
        """All values by name."""
        return dict(self._values)

    def with_kept(self, kept: dict[str, float]) -> Parameters:
        """These values with others that were kept from an earlier life; raises ParameterError."""
        return Parameters({**self._given, **kept}, alone=self.alone)

    def restore(self, values: dict[str, float]) -> None:
        """Put values back that were in force before."""
        self._values.update(values)

    def flight(self) -> VehicleParams:
        """Flight law's parameters by these values; the paper's sets keep their gains and have no limits."""
        base = NAMED[GAIN_SETS[int(self["SIM_GAIN_SET"])]]
        battery = BatteryParams(
            capacity_j=self["SIM_BAT_CAP_J"],
            initial_j=min(self["SIM_BAT_INIT_J"], self["SIM_BAT_CAP_J"]),
            hover_w=self["SIM_BAT_HOVER_W"],
            avionics_w=self["SIM_BAT_AVION_W"],
        )
        if self["SIM_GAIN_SET"] != 0:
            return replace(base, battery=battery)
        gains = Gains(
            speed=self["SIM_GAIN_SPEED"],
            rate=self["SIM_GAIN_RATE"],
            angle=self["SIM_GAIN_ANGLE"],
            epsilon=base.gains.epsilon,
        )
        limits = Limits(
            tilt_rad=self["MPC_TILTMAX_AIR"] / _DEG,
            thrust_m_s2=self["MPC_THR_MAX_G"] * base.airframe.gravity_m_s2,
            angular_acceleration_rad_s2=self["SIM_ANGACC_MAX"],
            speed_m_s=self["MPC_XY_VEL_MAX"],
            acceleration_m_s2=self["MPC_ACC_HOR"],
        )
        return replace(base, gains=gains, limits=limits, battery=battery)
