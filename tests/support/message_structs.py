"""Payloads of MAVLink messages as packed C structs, declared from pymavlink's definitions.

`python tests/support/message_structs.py` writes skytender/messages.pxd anew: what compiled code reads or writes of a
message it names there. A struct has its message's fields as they stand on the wire, little-endian as the processor.
"""

from __future__ import annotations

import sys
from pathlib import Path

import newer
from pymavlink.dialects.v20 import common

DECLARED = Path(__file__).resolve().parents[2] / "skytender" / "messages.pxd"
MESSAGES = (
    "HEARTBEAT", "SYS_STATUS", "SYSTEM_TIME", "PING", "GPS_RAW_INT", "ATTITUDE", "ATTITUDE_QUATERNION",
    "LOCAL_POSITION_NED", "GLOBAL_POSITION_INT", "MISSION_CURRENT", "GPS_GLOBAL_ORIGIN", "VFR_HUD",
    "SET_POSITION_TARGET_LOCAL_NED", "POSITION_TARGET_LOCAL_NED", "ALTITUDE", "FOLLOW_TARGET", "BATTERY_STATUS",
    "HOME_POSITION", "EXTENDED_SYS_STATE", "NAMED_VALUE_FLOAT", "NAMED_VALUE_INT",
    "CURRENT_MODE", "CONTROL_STATUS",
)  # fmt: skip
NUMBERED = (
    "HEARTBEAT", "SYSTEM_TIME", "PING", "LOCAL_POSITION_NED", "SET_POSITION_TARGET_LOCAL_NED",
    "POSITION_TARGET_LOCAL_NED",
)  # fmt: skip
"""Messages whose ids compiled code needs."""
CHECKED = ("SYSTEM_TIME",)
"""Messages whose CRC seeds compiled code needs."""
CONSTANTS = (
    "MAV_COMP_ID_AUTOPILOT1", "MAV_TYPE_GCS", "MAV_TYPE_QUADROTOR", "MAV_MODE_FLAG_CUSTOM_MODE_ENABLED",
    "MAV_MODE_FLAG_STABILIZE_ENABLED", "MAV_MODE_FLAG_GUIDED_ENABLED", "MAV_MODE_FLAG_AUTO_ENABLED",
    "MAV_MODE_FLAG_SAFETY_ARMED", "MAV_STATE_BOOT", "MAV_STATE_STANDBY", "MAV_STATE_ACTIVE", "MAV_STATE_CRITICAL",
    "MAV_SYS_STATUS_SENSOR_3D_GYRO", "MAV_SYS_STATUS_SENSOR_3D_ACCEL", "MAV_SYS_STATUS_SENSOR_3D_MAG",
    "MAV_SYS_STATUS_SENSOR_ABSOLUTE_PRESSURE", "MAV_SYS_STATUS_SENSOR_GPS", "MAV_SYS_STATUS_SENSOR_BATTERY",
    "MAV_SYS_STATUS_SENSOR_MOTOR_OUTPUTS", "MAV_SYS_STATUS_GEOFENCE", "MAV_SYS_STATUS_AHRS",
    "MAV_SYS_STATUS_PREARM_CHECK", "MAV_VTOL_STATE_UNDEFINED", "MAV_LANDED_STATE_ON_GROUND",
    "MAV_LANDED_STATE_IN_AIR", "MAV_LANDED_STATE_TAKEOFF", "MAV_LANDED_STATE_LANDING", "GPS_FIX_TYPE_NO_FIX",
    "GPS_FIX_TYPE_3D_FIX", "MAV_BATTERY_FUNCTION_ALL", "MAV_BATTERY_TYPE_LIPO", "MAV_BATTERY_CHARGE_STATE_OK",
    "MAV_BATTERY_CHARGE_STATE_CRITICAL", "MAV_BATTERY_CHARGE_STATE_EMERGENCY",
    "MAV_FRAME_LOCAL_NED", "MAV_FRAME_LOCAL_OFFSET_NED", "MAV_FRAME_BODY_NED", "MAV_FRAME_BODY_OFFSET_NED",
    "MAV_FRAME_BODY_FRD", "POSITION_TARGET_TYPEMASK_AX_IGNORE", "POSITION_TARGET_TYPEMASK_AY_IGNORE",
    "POSITION_TARGET_TYPEMASK_AZ_IGNORE", "POSITION_TARGET_TYPEMASK_YAW_IGNORE",
    "POSITION_TARGET_TYPEMASK_YAW_RATE_IGNORE", "GCS_CONTROL_STATUS_FLAGS_SYSTEM_MANAGER",
    "GCS_CONTROL_STATUS_FLAGS_TAKEOVER_ALLOWED",
)  # fmt: skip
_C_TYPES = {
    "char": "char",
    "uint8_t": "unsigned char",
    "int8_t": "signed char",
    "uint16_t": "unsigned short",
    "int16_t": "short",
    "uint32_t": "unsigned int",
    "int32_t": "int",
    "uint64_t": "unsigned long long",
    "int64_t": "long long",
    "float": "float",
    "double": "double",
}


def declarations() -> str:
    """The text of messages.pxd."""
    known = {cls.msgname: cls for cls in (*common.mavlink_map.values(), *newer.MESSAGES.values())}
    parts = ["# Made by tests/support/message_structs.py from pymavlink's definitions: payloads as on the wire.\n"]
    for name in MESSAGES:
        definition = known[name]
        types = dict(zip(definition.fieldnames, definition.fieldtypes, strict=True))
        lines = [f"cdef packed struct {name.title().replace('_', '')}:"]
        for field, length in zip(definition.ordered_fieldnames, definition.array_lengths, strict=True):
            lines.append(f"    {_C_TYPES[types[field]]}{f'[{length}]' if length else ''} {field}")
        parts.append("\n".join(lines) + "\n")
    numbers = vars(newer.dialect) | vars(common)
    constants = [f"    {name}_ID = {known[name].id}" for name in NUMBERED]
    constants += [f"    {name}_SEED = {known[name].crc_extra}" for name in CHECKED]
    constants += [f"    {name} = {numbers[name]}" for name in CONSTANTS]
    return "\n".join([*parts, "cdef enum:", *constants, ""])


if __name__ == "__main__":
    DECLARED.write_text(declarations())
    print(f"written: {DECLARED}", file=sys.stderr)
