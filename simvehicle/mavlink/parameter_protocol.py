"""The parameter protocol: list, read, set; what is refused is reported by PARAM_ERROR, and the value in force after
it; a value that has been set, on all connections."""

from __future__ import annotations

import struct
from typing import Any

from simvehicle.autopilot import parameters
from simvehicle.autopilot.parameters import WRONG_TYPE, ParameterError
from simvehicle.mavlink.codec import message
from simvehicle.mavlink.context import Call, MessageHandler, ServiceContext, unwritten
from skytender import mavlink as mav
from skytender.vehicle.parameters import ParameterRow

NO_INDEX = -1
CAPACITY = "SIM_BAT_CAP_J"


def send_all(context: ServiceContext, call: Call) -> None:
    for index, (row, value) in enumerate(context.vehicle.parameters):
        call.connection.put(_param_value(context, row, value, index))


def read(context: ServiceContext, call: Call) -> None:
    content = call.content
    key = content.param_id if content.param_index < 0 else content.param_index
    found = context.vehicle.parameters.row_at(key)
    if found is None:
        error = error_message(content.param_id, content.param_index, parameters.UNKNOWN, call.sender)
        return call.connection.put(error)
    index, row = found
    return call.connection.put(_param_value(context, row, context.vehicle.parameters[row.name], index))


def change(context: ServiceContext, call: Call) -> None:
    content, vehicle = call.content, context.vehicle
    found = vehicle.parameters.row_at(content.param_id)
    if found is None:
        error = error_message(content.param_id, NO_INDEX, parameters.UNKNOWN, call.sender)
        return call.connection.put(error)
    index, row = found
    try:
        value = value_from_wire(
            row, content.param_value, content.param_type, bytewise=vehicle.identity.integers_bytewise
        )
        if row.name == CAPACITY and row.least <= value < vehicle.remaining_j:
            text = f"{CAPACITY} = {value:g}: the battery holds {vehicle.remaining_j:.0f} J"
            raise ParameterError(text, parameters.OUT_OF_RANGE)
        before = vehicle.parameters[row.name]
        taken = vehicle.parameters.set(row.name, value)
        if context.store is not None:
            try:
                context.store.keep(row.name, taken)
            except OSError as error:
                vehicle.parameters.restore({row.name: before})
                raise ParameterError(f"{row.name}: {unwritten(error)}", parameters.READ_ONLY) from error
        vehicle.retune()
        answered = context.connections
    except ParameterError as refusal:
        context.complain(row.name, str(refusal))
        call.connection.put(error_message(row.name, index, refusal.code, call.sender))
        answered = [call.connection]
    for connection in answered:
        connection.put(_param_value(context, row, vehicle.parameters[row.name], index))
    return None


def _param_value(context: ServiceContext, row: ParameterRow, value: float, index: int) -> Any:
    vehicle = context.vehicle
    return value_message(row, value, index, len(vehicle.parameters), bytewise=vehicle.identity.integers_bytewise)


MESSAGES: dict[int, MessageHandler] = {
    mav.MAVLINK_MSG_ID_PARAM_REQUEST_LIST: send_all,
    mav.MAVLINK_MSG_ID_PARAM_REQUEST_READ: read,
    mav.MAVLINK_MSG_ID_PARAM_SET: change,
}


def value_message(row: ParameterRow, value: float, index: int, count: int, *, bytewise: bool) -> Any:
    """PARAM_VALUE of one parameter; `index` is its place among `count`, or 65535 in the answer to a change by name."""
    wire, kind = value, mav.MAV_PARAM_TYPE_REAL32
    if row.whole:
        kind = mav.MAV_PARAM_TYPE_INT32
        if bytewise:
            wire = struct.unpack("<f", struct.pack("<i", int(value)))[0]
    return message("PARAM_VALUE")(
        param_id=row.name, param_value=wire, param_type=kind, param_count=count, param_index=index
    )


def error_message(name: str, index: int, code: int, asker: tuple[int, int]) -> Any:
    """PARAM_ERROR to the sender of a request for a parameter by name, or by its place in the table."""
    return message("PARAM_ERROR")(
        param_id=name, param_index=index, error=code, target_system=asker[0], target_component=asker[1]
    )


def value_from_wire(row: ParameterRow, wire: float, kind: int, *, bytewise: bool) -> float:
    """Value that a PARAM_SET's param_value of MAV_PARAM_TYPE `kind` means for this parameter; raises ParameterError.

    Sent by value, every type says the same. Bytewise, another type's bytes would be another number.
    """
    if bytewise and kind != (mav.MAV_PARAM_TYPE_INT32 if row.whole else mav.MAV_PARAM_TYPE_REAL32):
        raise ParameterError(f"{row.name} is {'an INT32' if row.whole else 'a REAL32'}: value refused", WRONG_TYPE)
    if row.whole and bytewise:
        return float(struct.unpack("<i", struct.pack("<f", wire))[0])
    return wire
