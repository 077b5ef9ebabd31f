"""Makes skytender/mavlink.json, MAVLink's definitions that both programs read, of pymavlink's and newer.xml: run this
file."""

from __future__ import annotations

import json
from importlib import metadata, resources
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import newer
from pymavlink import mavutil
from pymavlink.dialects.v20 import ardupilotmega, common

FILE = Path(__file__).resolve().parents[2] / "skytender" / "mavlink.json"
ARDUPILOT_MODES = {
    "copter": mavutil.mode_mapping_acm,
    "plane": mavutil.mode_mapping_apm,
    "rover": mavutil.mode_mapping_rover,
    "sub": mavutil.mode_mapping_sub,
    "blimp": mavutil.mode_mapping_blimp,
}


def made() -> str:
    """The file's content: a line for each enumeration, command, message and table of modes."""
    modes = {name: {mode: number for number, mode in table.items()} for name, table in ARDUPILOT_MODES.items()}
    enums = {
        name: ardupilotmega.enums.get(name, {}) | newer.ENUMS.get(name, {})
        for name in (*ardupilotmega.enums, *newer.ENUMS)
    }
    messages = ardupilotmega.mavlink_map | newer.MESSAGES
    modes["main and sub"] = {mode: main << 16 | sub << 24 for mode, (_, main, sub) in mavutil.px4_map.items()}
    parts = {
        "enums": {
            name: {entry.name: value for value, entry in entries.items() if not entry.name.endswith("_ENUM_END")}
            for name, entries in enums.items()
        },
        "commands": {
            command.name: [command.has_location, command.label]
            for command in enums["MAV_CMD"].values()
            if not command.name.endswith("_ENUM_END")
        },
        "messages": {cls.msgname: _message(cls) for _, cls in sorted(messages.items())},
        "modes": modes,
    }
    lines = [f'{{\n"pymavlink": {json.dumps(metadata.version("pymavlink"))}']
    for part, rows in parts.items():
        lines.append(
            f'"{part}": {{\n' + ",\n".join(f'"{name}": {json.dumps(row)}' for name, row in rows.items()) + "\n}"
        )
    return ",\n".join(lines) + "\n}\n"


def _message(cls: Any) -> list[Any]:
    """Id, seed of checksums, whether it is a common message, number of extension fields, and the fields."""
    lengths = dict(zip(cls.ordered_fieldnames, cls.array_lengths, strict=True))
    fields = [
        [name, kind, lengths[name], cls.fieldunits_by_name.get(name, ""), INVALID.get((cls.msgname, name), "")]
        for name, kind in zip(cls.fieldnames, cls.fieldtypes, strict=True)
    ]
    known = cls.id in common.mavlink_map or cls.id in newer.MESSAGES
    return [cls.id, cls.crc_extra, known, len(cls.__init__.__defaults__ or ()), fields]


def _invalid() -> dict[tuple[str, str], str]:
    """How the definitions write the value of a field, by (message, field), that means that it is not known."""
    roots = [ElementTree.parse(newer.DEFINITIONS).getroot()]
    waiting, read = [f"{ardupilotmega.DIALECT}.xml"], set[str]()
    while waiting:
        name = waiting.pop()
        if name in read:
            continue
        read.add(name)
        roots.append(ElementTree.fromstring(resources.files("pymavlink.dialects.v20").joinpath(name).read_bytes()))
        waiting += [include.text or "" for include in roots[-1].iter("include")]
    return {
        (message.get("name", ""), field.get("name", "")): field.get("invalid", "")
        for root in roots
        for message in root.iter("message")
        for field in message.findall("field")
    }


INVALID = _invalid()

if __name__ == "__main__":
    FILE.write_text(made(), encoding="utf-8")
