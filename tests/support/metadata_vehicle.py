"""A scripted vehicle that has component metadata as a PX4 hosts it."""

from __future__ import annotations

import json
import lzma
from typing import Any

import newer
from arducopter_files import Files
from pymavlink.dialects.v20 import common as mav

OUT = mav.MAVLink(None, srcSystem=3, srcComponent=1)
GENERAL = "etc/extras/component_general.json.xz"


def crc32(content: bytes) -> int:
    """As PX4's generate_crc.py counts it, bit by bit."""
    crc = 0
    for byte in content:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ (0xEDB88320 if crc & 1 else 0)
    return crc


class MetadataVehicle:
    """COMPONENT_METADATA, and the files behind it; `ack` is its answer to the request. Checksums are
    those of a PX4 1.18: of the general file's plain content, unless `raw` is given, and of other files as packed."""

    def __init__(self, named: list[dict[str, Any]], files: dict[str, bytes], **general: Any) -> None:
        plain = json.dumps({"version": 1, "metadataTypes": named}).encode()
        raw = general.get("raw") or lzma.compress(plain)
        self.ack = general.get("ack", mav.MAV_RESULT_ACCEPTED)
        self.crc = general.get("crc", crc32(general.get("raw", plain)))
        self.files = Files({GENERAL: raw, **files})

    def hear(self, heard: Any) -> list[Any]:
        if heard.get_type() == "FILE_TRANSFER_PROTOCOL":
            return self.files.hear(heard)
        assert (heard.command, heard.param1) == (mav.MAV_CMD_REQUEST_MESSAGE, 397.0)
        ack = mav.MAVLink_command_ack_message(heard.command, self.ack)
        if self.ack != mav.MAV_RESULT_ACCEPTED:
            return [ack]
        uri = f"mftp://{GENERAL}".encode()
        return [ack, newer.dialect.MAVLink_component_metadata_message(1, self.crc, uri)]
