"""Files that say what the vehicle's parameters and events are, for any ground station: component metadata by MAVFTP.

COMPONENT_METADATA names the general file, and that the others. They are made when one is asked for, compressed with xz.
[lineage] Component Metadata Protocol, https://mavlink.io/en/services/component_information.html; the files' schemas
stand in MAVLink's folder component_metadata, that of events in libevents.
"""

from __future__ import annotations

import json
import lzma
import zlib
from collections.abc import Callable, Mapping
from typing import Any

from simvehicle.autopilot.parameters import READ_ONCE
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.mavlink.codec import message
from simvehicle.mavlink.services import events
from skytender import mavlink as mav

SCHEME = "mftp://"
GENERAL = "/metadata/general.json.xz"
KINDS: dict[int, str] = {
    mav.COMP_METADATA_TYPE_PARAMETER: "/metadata/parameters.json.xz",
    mav.COMP_METADATA_TYPE_EVENTS: "/metadata/events.json.xz",
}
"""Paths of the files that the general one names, by COMP_METADATA_TYPE."""


def content_of(vehicle: Vehicle, path: str) -> bytes | None:
    """Content of the file of this path; None where there is none."""
    if path == GENERAL:
        kinds = [(kind, path, crc32(_compressed(_MAKERS[kind](vehicle)))) for kind, path in KINDS.items()]
        types = [{"type": kind, "uri": SCHEME + path, "fileCrc": crc} for kind, path, crc in kinds]
        return _compressed({"version": 1, "vendorName": "Skytender", "modelName": "simvehicle", "metadataTypes": types})
    kind = next((kind for kind, other in KINDS.items() if other == path), None)
    return None if kind is None else _compressed(_MAKERS[kind](vehicle))


def component_metadata(vehicle: Vehicle) -> Any:
    """COMPONENT_METADATA."""
    general = content_of(vehicle, GENERAL)
    assert general is not None
    uri = SCHEME + GENERAL
    return message("COMPONENT_METADATA")(time_boot_ms=vehicle.time_ms, file_crc=crc32(general), uri=uri)


def crc32(content: bytes) -> int:
    """MAVLink's CRC32, which begins with 0 and is not inverted at its end."""
    return zlib.crc32(content, 0xFFFFFFFF) ^ 0xFFFFFFFF


def _compressed(content: Mapping[str, Any]) -> bytes:
    return lzma.compress(json.dumps(content).encode(), preset=1)  # the default's encoder takes 94 MB


def _parameters(vehicle: Vehicle) -> dict[str, Any]:
    rows = [
        {
            "name": row.name,
            "type": "Int32" if row.whole else "Float",
            "shortDesc": row.meaning,
            "units": row.units,
            "default": row.default,
            "min": row.least,
            "max": row.most,
            "readOnly": row.name in READ_ONCE,
        }
        for row in vehicle.parameters.table
    ]
    return {"version": 3, "parameters": rows}


_MAKERS: dict[int, Callable[[Vehicle], dict[str, Any]]] = {
    mav.COMP_METADATA_TYPE_PARAMETER: _parameters,
    mav.COMP_METADATA_TYPE_EVENTS: lambda _: events.definitions(),
}
