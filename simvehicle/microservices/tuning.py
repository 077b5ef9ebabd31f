"""The parameter protocol: list, read, set; what is refused is told by PARAM_ERROR, and the value in force after it."""

from __future__ import annotations

from typing import Any

from pymavlink.dialects.v20 import common as mav

from simvehicle.mavlink import parameters
from simvehicle.mavlink.parameters import ParameterError
from simvehicle.microservices.desk import Call, Desk, MessageHandler

NO_INDEX = -1
CAPACITY = "SIM_BAT_CAP_J"


def tell_all(desk: Desk, call: Call) -> None:
    for index, (row, value) in enumerate(desk.vehicle.parameters):
        call.connection.put(_told(desk, row, value, index))


def read(desk: Desk, call: Call) -> None:
    content = call.content
    found = parameters.row_at(content.param_id if content.param_index < 0 else content.param_index)
    if found is None:
        error = parameters.error_message(content.param_id, content.param_index, parameters.UNKNOWN, call.sender)
        return call.connection.put(error)
    index, row = found
    return call.connection.put(_told(desk, row, desk.vehicle.parameters[row.name], index))


def change(desk: Desk, call: Call) -> None:
    content, vehicle = call.content, desk.vehicle
    found = parameters.row_at(content.param_id)
    if found is None:
        error = parameters.error_message(content.param_id, NO_INDEX, parameters.UNKNOWN, call.sender)
        return call.connection.put(error)
    index, row = found
    try:
        value = parameters.value_from_wire(
            row, content.param_value, content.param_type, bytewise=vehicle.identity.integers_bytewise
        )
        if row.name == CAPACITY and row.least <= value < vehicle.remaining_j:
            text = f"{CAPACITY} = {value:g}: the battery holds {vehicle.remaining_j:.0f} J"
            raise ParameterError(text, parameters.OUT_OF_RANGE)
        taken = vehicle.parameters.set(row.name, value)
        vehicle.retune()
        if desk.store is not None:
            desk.store.keep(row.name, taken)
    except ParameterError as refusal:
        desk.complain(row.name, str(refusal))
        call.connection.put(parameters.error_message(row.name, index, refusal.code, call.sender))
    return call.connection.put(_told(desk, row, vehicle.parameters[row.name], index))


def _told(desk: Desk, row: parameters.Row, value: float, index: int) -> Any:
    return parameters.value_message(row, value, index, bytewise=desk.vehicle.identity.integers_bytewise)


MESSAGES: dict[int, MessageHandler] = {
    mav.MAVLINK_MSG_ID_PARAM_REQUEST_LIST: tell_all,
    mav.MAVLINK_MSG_ID_PARAM_REQUEST_READ: read,
    mav.MAVLINK_MSG_ID_PARAM_SET: change,
}
