"""ArduPilot's packed parameters, its file `@PARAM/param.pck`: all of them in 20 to 40 kB, read at once by MAVFTP.

After a head (magic, how many there are in the file, how many in all; uint16 each) each parameter has two bytes, the end
of its name, and its value:

    type: 4 low bits, flags: 4 high bits | bytes shared with the name before: 4 low bits, further bytes - 1: 4 high bits

Zero bytes before a parameter fill up a piece of the transfer. A value's type is 1, 2, 3, 4: int8, int16, int32, float.
[lineage] ArduPilot, libraries/AP_Filesystem/README.md
"""

from __future__ import annotations

import struct

from gcs.mavlink.parameters.value import ParameterValue
from skytender import mavlink as mav

MAGIC, MAGIC_WITH_DEFAULTS = 0x671B, 0x671C
_HEAD = struct.Struct("<HHH")
_TYPES = {
    1: ("<b", int(mav.MAV_PARAM_TYPE_INT8)),
    2: ("<h", int(mav.MAV_PARAM_TYPE_INT16)),
    3: ("<i", int(mav.MAV_PARAM_TYPE_INT32)),
    4: ("<f", int(mav.MAV_PARAM_TYPE_REAL32)),
}
LONGEST_NAME = 16


def unpack(raw: bytes) -> dict[str, ParameterValue]:
    """Values by name. Raises ValueError where it is not whole, or no such file."""
    if len(raw) < _HEAD.size or _HEAD.unpack_from(raw)[0] not in (MAGIC, MAGIC_WITH_DEFAULTS):
        raise ValueError("it does not begin as packed parameters do")
    magic, count, _ = _HEAD.unpack_from(raw)
    found: dict[str, ParameterValue] = {}
    at, name = _HEAD.size, b""
    while True:
        while at < len(raw) and raw[at] == 0:
            at += 1
        if at == len(raw):
            break
        name, value, at = _one(raw, at, name, with_defaults=magic == MAGIC_WITH_DEFAULTS)
        found[name.decode("ascii")] = value
    if len(found) != count:
        raise ValueError(f"{len(found)} of {count} parameters are in it")
    return found


def _one(raw: bytes, at: int, before: bytes, *, with_defaults: bool) -> tuple[bytes, ParameterValue, int]:
    """(name, value, where the next one begins) of the parameter at `at`."""
    if at + 2 > len(raw) or raw[at] & 15 not in _TYPES:
        raise ValueError(f"byte {at} begins no parameter")
    form, kind = _TYPES[raw[at] & 15]
    shared, more = raw[at + 1] & 15, (raw[at + 1] >> 4) + 1
    value_at = at + 2 + more
    size = struct.calcsize(form)
    end = value_at + size * (2 if with_defaults and raw[at] >> 4 & 1 else 1)
    name = before[:shared] + raw[at + 2 : value_at]
    if end > len(raw) or shared > len(before) or len(name) > LONGEST_NAME or not name.isascii():
        raise ValueError(f"the parameter at byte {at} is not whole")
    (value,) = struct.unpack_from(form, raw, value_at)
    return name, ParameterValue(value, kind), end
