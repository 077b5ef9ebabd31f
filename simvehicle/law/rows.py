"""Where each field stands in the flight core's rows, as rows.pxd declares them: a slice for vectors, an integer for
scalars. Axes are nwu, units SI.
"""

from __future__ import annotations

from typing import Any

import cython

from skytender.layout import COUNTED, places, size


def _state_of(row: Any) -> Any:
    return cython.cast("State *", cython.address(row[0]))[0]


def _command_of(row: Any) -> Any:
    return cython.cast("Command *", cython.address(row[0]))[0]


def _parameters_of(row: Any) -> Any:
    return cython.cast("Parameters *", cython.address(row[0]))[0]


def _rotor_state_of(row: Any) -> Any:
    return cython.cast("RotorState *", cython.address(row[0]))[0]


_state, _command, _rotor_state = _state_of(COUNTED), _command_of(COUNTED), _rotor_state_of(COUNTED)
STATE, COMMAND, ROTOR_STATE = places(_state), places(_command), places(_rotor_state)
PARAMETERS = places(_parameters_of(COUNTED))
STATE_SIZE, COMMAND_SIZE, ROTOR_STATE_SIZE = size(_state), size(_command), size(_rotor_state)
PARAMS_SIZE = len(PARAMETERS)

POSITION, VELOCITY, ATTITUDE, RATES = STATE["position"], STATE["velocity"], STATE["attitude"], STATE["rates"]
DIFF_ROLL, DIFF_PITCH = STATE["diff_roll"], STATE["diff_pitch"]
GUIDE, GUIDE_YAW, LINEAR = STATE["guide"], STATE["guide_yaw"], STATE["linear"]
GUIDE_FIELDS, GUIDE_YAW_FIELDS = places(_state["guide"]), places(_state["guide_yaw"])
LINEAR_STAMP = int(_state["linear"]["stamp_s"])
REFERENCE_POSITION, REFERENCE_VELOCITY = STATE["reference_position"], STATE["reference_velocity"]
REFERENCE_ACCELERATION = STATE["reference_acceleration"]
STARTED, CONTACT, EFFORT = STATE["started"], STATE["contact"], STATE["effort"]
DRAWN_J, REMAINING_J = STATE["drawn_j"], STATE["remaining_j"]

CMD_POSITION, CMD_VELOCITY, CMD_USE_POSITION = COMMAND["position"], COMMAND["velocity"], COMMAND["use_position"]
CMD_TIME_S, CMD_YAW, CMD_MOTORS, CMD_GROUND = COMMAND["time_s"], COMMAND["yaw"], COMMAND["motors"], COMMAND["ground"]
CMD_SPEED_MAX, CMD_PERIOD_S = COMMAND["speed_max"], COMMAND["period_s"]

BODY = ROTOR_STATE["body"]
GUST, WIND, ERROR = ROTOR_STATE["gust"], ROTOR_STATE["wind"], ROTOR_STATE["error"]
VOLTAGE_V, CURRENT_A, CAPACITY_J = ROTOR_STATE["voltage_v"], ROTOR_STATE["current_a"], ROTOR_STATE["capacity_j"]
_body = places(_rotor_state["body"])
TRUE_POSITION, TRUE_VELOCITY, TRUE_QUATERNION = _body["position"], _body["velocity"], _body["quaternion"]
BODY_RATES, ROTOR_SPEEDS = _body["rates"], _body["rotors"]
