"""A vehicle's own account of its parameters and events: component metadata, read by MAVFTP. No socket and no clock
here, time is an argument (s).

    ask      MAV_CMD_REQUEST_MESSAGE → COMPONENT_METADATA, which names the general file, or a refusal
    general  FileClient → which file holds what
    files    FileClient, one file after the other

A file may be compressed with xz, and its checksum be that of what it is then or was before: the standard does not say,
and PX4s have both. One that lies on the internet is passed over where the vehicle holds none itself.
[lineage] Component Metadata Protocol, https://mavlink.io/en/services/component_information.html
"""

from __future__ import annotations

import lzma
import re
import zlib
from collections.abc import Collection
from typing import Any

import msgspec

from gcs.mavlink.codec import Message
from gcs.mavlink.command_protocol import CommandLong, CommandTarget, result_name
from gcs.mavlink.ftp.file_client import FileClient
from gcs.mavlink.ftp.requests import FileRequests
from skytender import mavlink as mav

PARAMETER, EVENTS = mav.COMP_METADATA_TYPE_PARAMETER, mav.COMP_METADATA_TYPE_EVENTS
MOST_BYTES = 1 << 25
"""A file that is longer once it is unpacked is given up."""
MOST_FILES = 16
REPEAT_S, TRIES = 1.0, 3
_URI = re.compile(r"mftp://(?:\[;comp=(\d+)\])?(.+)", re.IGNORECASE)


class _NamedFile(msgspec.Struct, rename="camel"):
    type: int
    uri: str
    file_crc: int | None = None
    uri_fallback: str = ""
    file_crc_fallback: int | None = None


class _General(msgspec.Struct, rename="camel"):
    version: int
    metadata_types: list[_NamedFile]


class ParameterMeaning(msgspec.Struct, rename="camel"):
    """Meaning of a parameter, in the vehicle's own words."""

    name: str
    type: str = ""
    short_desc: str = ""
    long_desc: str = ""
    units: str = ""
    default: float | None = None
    min: float | None = None
    max: float | None = None
    reboot_required: bool = False
    read_only: bool = False

    @property
    def text(self) -> str:
        """One line for a person."""
        bounds = [f"{bound:g}" for bound in (self.min, self.max) if bound is not None]
        parts = [
            self.short_desc,
            self.units and f"[{self.units}]",
            "..".join(bounds) if len(bounds) == 2 else "",
            "" if self.default is None else f"default {self.default:g}",
            "after a reboot" if self.reboot_required else "",
        ]
        line = "  ".join(part for part in parts if part)
        return "".join(letter if letter.isprintable() else " " for letter in line)


class _Parameters(msgspec.Struct):
    version: int
    parameters: list[ParameterMeaning]


class MetadataRefused(ValueError):
    """A file that is not what it is said to be; the text says why."""


def unpacked(content: bytes, crc: int | None, path: str) -> bytes:
    """A file's content uncompressed. Raises MetadataRefused."""
    plain = _decompressed(content, path) if path.endswith(".xz") else content
    if crc is not None and crc not in (_checksum(content), _checksum(plain)):
        raise MetadataRefused(f"the checksum of {path} is wrong")
    return plain


def _checksum(content: bytes) -> int:
    """MAVLink's CRC32, which begins and ends with 0."""
    return zlib.crc32(content, 0xFFFFFFFF) ^ 0xFFFFFFFF


def _decompressed(content: bytes, path: str) -> bytes:
    decompressor = lzma.LZMADecompressor(lzma.FORMAT_XZ, memlimit=4 * MOST_BYTES)
    try:
        plain = decompressor.decompress(content, MOST_BYTES)
    except lzma.LZMAError as error:
        raise MetadataRefused(f"{path} cannot be unpacked: {error}") from None
    if not decompressor.eof:
        raise MetadataRefused(f"{path} has more than {MOST_BYTES} bytes, or ends early")
    return plain


def decoded(content: bytes, kind: Any, path: str) -> Any:
    """A file's JSON as an object of a kind. Raises MetadataRefused."""
    try:
        return msgspec.json.decode(content, type=kind)
    except (msgspec.MsgspecError, UnicodeDecodeError) as error:
        raise MetadataRefused(f"{path} is not as the standard has it: {error}") from None


class MetadataClient:
    """The dialogue with one vehicle's component about files of these COMP_METADATA_TYPEs, or all that it has."""

    def __init__(self, sysid: int, compid: int, wanted: Collection[int] | None = None, *, asks: bool = True) -> None:
        """`asks`: it asks for COMPONENT_METADATA itself; else it waits for it."""
        self.sysid, self.compid = sysid, compid
        self.files: dict[int, bytes] = {}
        """content of each that came, unpacked, by COMP_METADATA_TYPE"""
        self.problem = ""
        """why there is none, or why one did not come, in words"""
        self._wanted, self._asks = wanted, asks
        self._requests = FileRequests(sysid, compid)
        self._open: FileClient | None = None
        self._open_kind: int = mav.COMP_METADATA_TYPE_GENERAL
        self._crc: int | None = None
        self._left: list[_NamedFile] = []
        self._tries, self._due_s = 0, 0.0
        self.done = False

    def parameters(self) -> dict[str, ParameterMeaning]:
        """Meanings by name; of a numbered kind the name holds `{n}`. Raises MetadataRefused."""
        path = "the file of its parameters"
        rows = decoded(self.files[PARAMETER], _Parameters, path).parameters if PARAMETER in self.files else []
        return {row.name: row for row in rows}

    def receive(self, name: str, content: Any, now_s: float) -> None:
        """Take a message of this vehicle's: its name and fields."""
        if self.done:
            return
        if self._open is not None:
            self._open.receive(name, content, now_s)
        elif name == "COMPONENT_METADATA":
            self._fetch(_NamedFile(mav.COMP_METADATA_TYPE_GENERAL, content.uri, content.file_crc))
        elif name == "COMMAND_ACK" and self._asks and self._is_refusal(content):
            self._end(f"it has no metadata ({result_name(content.result)})")

    def poll(self, now_s: float) -> list[Message]:
        """Messages to send now."""
        if self.done:
            return []
        if self._open is None:
            return self._ask(now_s) if self._asks else []
        messages = self._open.poll(now_s)
        if self._open.done:
            self._take(self._open)
        return messages

    @staticmethod
    def _is_refusal(ack: Any) -> bool:
        good = (mav.MAV_RESULT_ACCEPTED, mav.MAV_RESULT_IN_PROGRESS)
        return ack.command == mav.MAV_CMD_REQUEST_MESSAGE and ack.result not in good

    def _ask(self, now_s: float) -> list[Message]:
        if now_s < self._due_s:
            return []
        if self._tries >= TRIES:
            self._end("it does not answer a request for COMPONENT_METADATA")
            return []
        self._tries, self._due_s = self._tries + 1, now_s + REPEAT_S
        number = float(mav.MAVLINK_MSG_ID_COMPONENT_METADATA)
        target = CommandTarget(self.sysid, self.compid)
        return [CommandLong(target, mav.MAV_CMD_REQUEST_MESSAGE, (number,)).message(0)]

    def _fetch(self, file: _NamedFile) -> None:
        """Open a file where the vehicle holds it, else the next."""
        for uri, crc in ((file.uri, file.file_crc), (file.uri_fallback, file.file_crc_fallback)):
            match = _URI.fullmatch(uri)
            if match is not None and match[1] in (None, str(self.compid)) and match[2].isascii():
                self._open, self._open_kind, self._crc = FileClient(self._requests, match[2]), file.type, crc
                return
        self.problem = self.problem or f"it names {file.uri!r}, which is no file of its own"
        self._next()

    def _take(self, file: FileClient) -> None:
        """Keep a file that has ended, and go on with the next."""
        self._open = None
        try:
            if file.content is None:
                raise MetadataRefused(file.problem)
            content = unpacked(file.content, self._crc, file.path)
            self.files[self._open_kind] = content
            if self._open_kind == mav.COMP_METADATA_TYPE_GENERAL:
                named = decoded(content, _General, file.path).metadata_types
                self._left = [one for one in named if self._wanted is None or one.type in self._wanted][:MOST_FILES]
        except MetadataRefused as error:
            self.problem = self.problem or str(error)
        self._next()

    def _next(self) -> None:
        if self._left:
            self._fetch(self._left.pop(0))
        else:
            self.done = True

    def _end(self, why: str) -> None:
        self.problem, self.done = why, True
