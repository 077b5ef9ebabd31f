"""Commands that change what is flown: arm, take-off, land, return, hold, go, modes, speed, home, mission, transfer."""

from __future__ import annotations

import math

from simvehicle.autopilot.modes import Mode, Severity, Trigger
from simvehicle.autopilot.vectors import Vec3
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.mavlink.commands import (
    ACCEPTED,
    DENIED,
    FAILED,
    TEMPORARILY_REJECTED,
    UNSUPPORTED,
    VehicleCommand,
    transfer_order,
)
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.context import Call, CommandHandler, MessageHandler, ServiceContext
from simvehicle.mavlink.plan_items import too_low
from simvehicle.mavlink.telemetry import message_of
from skytender import mavlink as mav

FORCE_ARM = (21196, 2989)
FASTEST_M_S = 1e3
FARTHEST_M = 1e6
_PRESENT_ITEM = -1.0
_CUSTOM_MODE = mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED
_CHANGE_MODE = mav.MAV_DO_REPOSITION_FLAGS_CHANGE_MODE
_RELATIVE_YAW = mav.MAV_DO_REPOSITION_FLAGS_RELATIVE_YAW
_REPOSITION_FLAGS = _CHANGE_MODE | _RELATIVE_YAW
_WITHOUT_TAKEOFF = frozenset({Mode.TAKEOFF, Mode.MISSION, Mode.RETURN, Mode.LAND})
_NOT_ARMABLE = frozenset({Mode.MISSION, Mode.RETURN, Mode.LAND, Mode.FOLLOW})
"""Modes in which ArduCopter takes no NAV_TAKEOFF, and in which it does not arm (allows_arming; AUTO_OPTIONS 0)."""
_EVENT_OF_MODE = {
    Mode.OFFBOARD: Trigger.OFFBOARD,
    Mode.HOLD: Trigger.HOLD,
    Mode.LAND: Trigger.LAND,
    Mode.RETURN: Trigger.RETURN,
    Mode.MISSION: Trigger.MISSION,
    Mode.FOLLOW: Trigger.FOLLOW,
}


def _result(done: bool) -> int:
    return ACCEPTED if done else TEMPORARILY_REJECTED


def _refuse(context: ServiceContext, text: str) -> int:
    context.vehicle.announce(Severity.WARNING, text)
    return TEMPORARILY_REJECTED


def arm(context: ServiceContext, request: VehicleCommand, connection: Connection) -> int:
    vehicle = context.vehicle
    if request.params[0] not in (0.0, 1.0):
        return DENIED
    if request.whole(1) == 1:
        reason = _arming_refusal(vehicle)
        if reason is not None and request.whole(2) not in FORCE_ARM:
            result = _refuse(context, f"Arming refused: {reason}")
            return FAILED if vehicle.identity.copter_rules else result
        return _result(vehicle.trigger(Trigger.ARM))
    if not vehicle.landed and request.whole(2) not in FORCE_ARM:
        return _refuse(context, "Disarming refused: in the air")
    return _result(vehicle.trigger(Trigger.DISARM))


def _arming_refusal(vehicle: Vehicle) -> str | None:
    """Why a command would not arm the vehicle: ArduCopter looks at the mode as well, which is no part of its health."""
    if vehicle.identity.copter_rules and not vehicle.armed and vehicle.mode in _NOT_ARMABLE:
        return f"not in mode {vehicle.mode}"
    return vehicle.arming_refusal()


def take_off(context: ServiceContext, request: VehicleCommand, connection: Connection) -> int:
    vehicle, identity = context.vehicle, context.vehicle.identity
    if identity.copter_rules and request.framed and request.frame != mav.MAV_FRAME_GLOBAL_RELATIVE_ALT:
        return DENIED
    height_m = request.value(7, 0.0)
    if identity.copter_rules and not _may_leave_ground(vehicle, request.params[6]):
        return FAILED
    if height_m == 0.0:
        height_m = vehicle.parameters["MIS_TAKEOFF_ALT"]
    elif not (identity.takeoff_altitude_is_relative or request.altitude_is_relative):
        height_m -= vehicle.frame.to_global(*vehicle.home_ned)[2]
    if not 0.0 < height_m < 1e4:
        return DENIED
    return _result(vehicle.take_off(height_m))


def _may_leave_ground(vehicle: Vehicle, height_m: float) -> bool:
    """Whether a vehicle waits on the ground, in a mode that lets it, for its take-off, to above where it is; a height
    that is not given (NaN) is."""
    waits = vehicle.armed and vehicle.landed and vehicle.mode not in _WITHOUT_TAKEOFF
    return waits and not height_m <= vehicle.home_ned[2] - vehicle.p_ned[2]


def triggers(event: Trigger) -> CommandHandler:
    """The handler of a command that lets an event happen, whatever its parameters."""
    return lambda context, _request, _connection: _result(context.vehicle.trigger(event))


def _filled_in(context: ServiceContext, request: VehicleCommand) -> tuple[float, ...]:
    """Params 5..7, those that are not given (NaN) as the vehicle's place has them."""
    vehicle = context.vehicle
    north, east, down = vehicle.p_ned
    here = (north, east, down)
    if request.frame != mav.MAV_FRAME_LOCAL_NED:
        here = vehicle.frame.to_global(north, east, down)
    if request.altitude_is_relative:
        here = (*here[:2], vehicle.home_ned[2] - down)
    return tuple(own if math.isnan(given) else given for own, given in zip(here, request.params[4:7], strict=True))


def _place(context: ServiceContext, request: VehicleCommand, *, or_here: bool = False) -> Vec3 | None:
    """Params 5..7 in the local frame; None where they name no place. `or_here`: what is not given is as it is."""
    vehicle, numbers = context.vehicle, request.params[4:7]
    if or_here and request.frame_is_known:
        numbers = _filled_in(context, request)
    if not all(map(math.isfinite, numbers)) or not request.frame_is_known:
        return None
    if request.frame == mav.MAV_FRAME_LOCAL_NED:
        north, east, down = numbers
    else:
        north, east, down = vehicle.frame.to_local(*numbers)
    if request.altitude_is_relative:
        down = vehicle.home_ned[2] - numbers[2]
    return (north, east, down) if max(abs(north), abs(east), abs(down)) < FARTHEST_M else None


def reposition(context: ServiceContext, request: VehicleCommand, connection: Connection) -> int:
    """MAV_CMD_DO_REPOSITION: hold at another place, and there with another yaw; it changes the mode only where its
    flags say so."""
    vehicle, identity = context.vehicle, context.vehicle.identity
    place = _place(context, request, or_here=True)
    speed_m_s, yaw_rad, flags = request.value(1, -1.0), request.params[3], request.whole(2)
    if place is None or not -1.0 <= speed_m_s < FASTEST_M_S:
        return DENIED
    if not math.isnan(request.params[6]) and too_low(vehicle.home_ned[2] - place[2]):
        return DENIED
    if flags & ~_REPOSITION_FLAGS or math.isinf(yaw_rad):
        return DENIED
    holding = Mode.GUIDED if identity.guided else Mode.HOLD
    if not flags & _CHANGE_MODE and identity.spoken[vehicle.mode] != identity.spoken[holding]:
        return DENIED
    if flags & _RELATIVE_YAW:
        yaw_rad += vehicle.attitude_ned[2]
    return _result(vehicle.reposition(place, speed_m_s if speed_m_s > 0.0 else None, yaw_rad))


def change_speed(context: ServiceContext, request: VehicleCommand, connection: Connection) -> int:
    """MAV_CMD_DO_CHANGE_SPEED: airspeed or ground speed; -1 changes nothing, -2 goes back to the parameters'."""
    speed_m_s = request.value(2, -1.0)
    if request.whole(1) not in (0, 1) or not (0.0 < speed_m_s < FASTEST_M_S or speed_m_s in (-1.0, -2.0)):
        return DENIED
    if speed_m_s != -1.0:
        context.vehicle.change_speed(speed_m_s if speed_m_s > 0.0 else None)
    return ACCEPTED


def set_home(context: ServiceContext, request: VehicleCommand, connection: Connection) -> int:
    """MAV_CMD_DO_SET_HOME: to where the vehicle is (param1 1), or to a place. Arming does not move it then; but a PX4's
    that was set to where it is."""
    vehicle, here = context.vehicle, request.whole(1) == 1
    place = vehicle.p_ned if here else _place(context, request)
    if place is None:
        return DENIED
    vehicle.home_ned, vehicle.home_locked = place, vehicle.identity.copter_rules or not here
    for each in context.connections:
        each.streams.hasten("HOME_POSITION", vehicle.time_ms)
    return ACCEPTED


def set_mode(context: ServiceContext, request: VehicleCommand, connection: Connection) -> int:
    main, sub = request.whole(2), request.whole(3)
    if not request.whole(1) & _CUSTOM_MODE or not (0 <= main <= 255 and 0 <= sub <= 255):
        return DENIED
    return enter_custom(context, main << 16 | sub << 24 if context.vehicle.identity.modes_packed else main)


def set_standard_mode(context: ServiceContext, request: VehicleCommand, connection: Connection) -> int:
    """MAV_CMD_DO_SET_STANDARD_MODE; an autopilot that has no standard modes does not know it."""
    numbers = {one.standard: one.number for one in context.vehicle.identity.available if one.standard}
    number = numbers.get(request.whole(1))
    if number is None:
        return FAILED if numbers else UNSUPPORTED
    return enter_custom(context, number)


def set_mode_message(context: ServiceContext, call: Call) -> None:
    """SET_MODE has no acknowledgement: the next HEARTBEAT is the answer."""
    if call.content.base_mode & _CUSTOM_MODE:
        enter_custom(context, call.content.custom_mode)


def enter_custom(context: ServiceContext, custom_mode: int) -> int:
    """Enter the mode that the identity knows by this number."""
    vehicle = context.vehicle
    mode = vehicle.identity.requestable.get(custom_mode)
    if mode is None:
        return UNSUPPORTED
    if mode is Mode.TAKEOFF:
        return _result(vehicle.take_off(vehicle.parameters["MIS_TAKEOFF_ALT"]))
    if mode is Mode.OFFBOARD and not vehicle.setpoints_fresh():
        if vehicle.identity.guided:
            return _result(vehicle.trigger(Trigger.GUIDED))
        return _refuse(context, "Offboard refused: no set points")
    if mode is Mode.MISSION and vehicle.mission is None:
        return _refuse(context, "Mission refused: there is none")
    if mode is Mode.FOLLOW and vehicle.landed:
        return _refuse(context, "Follow refused: on the ground")
    return _result(vehicle.trigger(_EVENT_OF_MODE[mode]))


def start_mission(context: ServiceContext, request: VehicleCommand, connection: Connection) -> int:
    """MAV_CMD_MISSION_START: arm where that is needed, and fly; param1 the first item, 0 for where it was left, and
    param2 the last one, or 0. ArduCopter enters AUTO alone, without items."""
    vehicle, copter = context.vehicle, context.vehicle.identity.copter_rules
    if vehicle.mission is None:
        return _refuse(context, "Mission refused: there is none")
    first, last = request.whole(1), request.whole(2)
    if copter and (first or last):
        return DENIED
    if 0 < last < len(vehicle.mission.legs) - 1:  # it flies to the end
        return DENIED
    if first and not vehicle.mission.go_to(first):
        return DENIED
    if not vehicle.armed and not copter:
        reason = vehicle.arming_refusal()
        if reason is not None:
            return _refuse(context, f"Arming refused: {reason}")
        vehicle.trigger(Trigger.ARM)
    return _result(vehicle.trigger(Trigger.MISSION))


def pause_or_continue(context: ServiceContext, request: VehicleCommand, connection: Connection) -> int:
    if request.params[0] not in (0.0, 1.0):
        return DENIED
    if request.params[0] == 0.0:
        return _result(context.vehicle.trigger(Trigger.HOLD))
    if context.vehicle.mission is None:
        return _refuse(context, "Mission refused: there is none")
    return _result(context.vehicle.trigger(Trigger.MISSION))


def set_mission_item(context: ServiceContext, request: VehicleCommand, connection: Connection) -> int:
    """MAV_CMD_DO_SET_MISSION_CURRENT: param1 the item, -1 for the present one; param2 1 resets the mission."""
    vehicle, mission = context.vehicle, context.vehicle.mission
    number, reset = request.value(1, math.inf), request.value(2, 0.0)
    if reset not in (0.0, 1.0):
        return DENIED
    if mission is None or not math.isfinite(number):
        return FAILED
    if number != _PRESENT_ITEM and not mission.go_to(round(number)):
        return FAILED
    if reset:
        mission.reset()
    for each in context.connections:
        if each is not connection:
            each.streams.hasten("MISSION_CURRENT", vehicle.time_ms)
    context.after_ack.append(message_of(vehicle, "MISSION_CURRENT"))
    return ACCEPTED


def transfer(context: ServiceContext, request: VehicleCommand, connection: Connection) -> int:
    order = transfer_order(request)
    if order is None:
        return DENIED
    reason = context.vehicle.order(order)
    if reason is not None:
        return _refuse(context, f"Transfer refused: {reason}")
    for counter in ("XferOut", "XferIn"):
        connection.streams.hasten(counter, context.vehicle.time_ms)
    return ACCEPTED


MESSAGES: dict[int, MessageHandler] = {mav.MAVLINK_MSG_ID_SET_MODE: set_mode_message}
COMMANDS: dict[int, CommandHandler] = {
    mav.MAV_CMD_COMPONENT_ARM_DISARM: arm,
    mav.MAV_CMD_NAV_TAKEOFF: take_off,
    mav.MAV_CMD_NAV_LAND: triggers(Trigger.LAND),
    mav.MAV_CMD_NAV_RETURN_TO_LAUNCH: triggers(Trigger.RETURN),
    mav.MAV_CMD_NAV_LOITER_UNLIM: triggers(Trigger.HOLD),
    mav.MAV_CMD_DO_REPOSITION: reposition,
    mav.MAV_CMD_DO_CHANGE_SPEED: change_speed,
    mav.MAV_CMD_DO_SET_HOME: set_home,
    mav.MAV_CMD_DO_SET_MODE: set_mode,
    mav.MAV_CMD_DO_SET_STANDARD_MODE: set_standard_mode,
    mav.MAV_CMD_MISSION_START: start_mission,
    mav.MAV_CMD_DO_PAUSE_CONTINUE: pause_or_continue,
    mav.MAV_CMD_DO_SET_MISSION_CURRENT: set_mission_item,
    mav.MAV_CMD_USER_1: transfer,
}
