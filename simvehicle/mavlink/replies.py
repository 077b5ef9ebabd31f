"""Questions that have one answer, whatever the vehicle does: PING, TIMESYNC, FTP. None where none is due."""

from __future__ import annotations

from typing import Any

from simvehicle.mavlink.codec import message

FTP_HEADER_BYTES = 12
FTP_PAYLOAD_BYTES = 251
FTP_NAK = 129
FTP_UNKNOWN_COMMAND = 7


def ping_reply(content: Any, asker: tuple[int, int]) -> Any | None:
    """The echo of a PING to everybody; one that is addressed is itself an echo."""
    if content.target_system != 0:
        return None
    return content._replace(target_system=asker[0], target_component=asker[1])


def timesync_reply(content: Any, unix_us: int) -> Any | None:
    """TIMESYNC: the asker's time returned with the own, in ns; an answer (tc1 not 0) gets none."""
    if content.tc1 != 0:
        return None
    return content._replace(tc1=1000 * unix_us)


def ftp_refusal(content: Any, asker: tuple[int, int]) -> Any:
    """FILE_TRANSFER_PROTOCOL: there are no files, and no operation is known; NAK names the operation refused."""
    asked = bytes(content.payload[:FTP_HEADER_BYTES])
    seq = (int.from_bytes(asked[:2], "little") + 1) & 0xFFFF
    answer = seq.to_bytes(2, "little") + bytes((asked[2], FTP_NAK, 1, asked[3], 0, 0, 0, 0, 0, 0, FTP_UNKNOWN_COMMAND))
    return message("FILE_TRANSFER_PROTOCOL")(
        target_network=0,
        target_system=asker[0],
        target_component=asker[1],
        payload=tuple(answer.ljust(FTP_PAYLOAD_BYTES, b"\0")),
    )
