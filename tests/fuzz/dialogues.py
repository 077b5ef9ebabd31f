"""Dialogues with one vehicle that are attacked: logs, files, parameters, plans, metadata, events; and a signed link."""

from __future__ import annotations

import contextlib
import json
import struct
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from hostile import REAL, WHOLE, Hostile

from gcs.link.keys import SignatureGate, new_key
from gcs.mavlink import codec
from gcs.mavlink.autopilots import ARDUCOPTER, PX4
from gcs.mavlink.codec import Frame, Message
from gcs.mavlink.ftp.requests import ACK, BURST, LIST, NAK, OPEN, READ, RESET
from gcs.mavlink.log_client import LogClient, LogEntry
from gcs.mavlink.metadata.client import MetadataClient
from gcs.mavlink.metadata.event_words import EventDefinitions
from gcs.mavlink.metadata.reported_events import ReportedEvents
from gcs.mavlink.parameters.client import ParameterClient
from gcs.mavlink.plans.client import PlanClient
from gcs.mavlink.plans.items import PlanItem
from skytender.signing import UNSIGNED

_FTP = struct.Struct("<HBBBBBxI")
EVENTS = json.dumps({
    "version": 2, "components": {"1": {"namespace": "a", "enums": {"b_t": {"type": "uint8_t", "is_bitfield": True}},
    "event_groups": {
        "default": {"events": {"1": {"name": "c", "message": "{1} {2:.1m} <a>{3}", "arguments": [
            {"name": "d", "type": "b_t"}, {"name": "e", "type": "float"}, {"name": "f", "type": "uint64_t"}]}}},
        "arming_check": {"events": {"2": {"name": "g", "message": "{1}", "type": "summary", "arguments": [
            {"name": "h", "type": "uint64_t"}]}, "3": {"name": "i", "message": "j"}}},
    }}},
}).encode()  # fmt: skip
LIVES = 400
"""Messages that a dialogue hears before another one takes its place."""


def new_clients() -> list[Any]:
    """A dialogue of each kind with vehicle 7, begun."""
    logs = LogClient(7, 1, PX4.log_folders)
    logs.list_logs()
    logs.download([LogEntry(1, 700, 0), LogEntry(2, 1 << 28, 0)])
    by_ranges = LogClient(7, 1, None)
    by_ranges.download([LogEntry(1, 900, 0)])
    reading, writing = ParameterClient(7, 1, ARDUCOPTER), ParameterClient(7, 1, PX4)
    reading.read_all()
    writing.write({"MPC_XY_CRUISE": 3.0, "SIM_BAT_CAP_J": 1.0})
    writing.read_all()
    plan = PlanClient(7, 1, 1, [PlanItem(5001, 0, 4.0, n, n, 0.0) for n in range(4)])
    mission = PlanClient(7, 1, 0, [PlanItem(16, 3, 4.0, n, n, 0.0) for n in range(4)], ARDUCOPTER.plans)
    reported = ReportedEvents(7, 1)
    reported.definitions = EventDefinitions(EVENTS)
    plans = [plan, mission, PlanClient(7, 1, 1, None)]
    return [logs, by_ranges, reading, writing, *plans, MetadataClient(7, 1), reported]


def _answer(hostile: Hostile, asked: list[Message]) -> tuple[str, dict[str, Any]]:
    """An answer such as a vehicle could give to one of the requests, with some of it hostile."""
    rng = hostile.random
    whole, real = rng.choice(WHOLE), rng.choice(REAL)
    kind = rng.randrange(9)
    if kind < 3:
        data = rng.randbytes(rng.choice((0, 1, 4, 239, 239, 251)))
        if rng.random() < 0.3:
            data = rng.choice((b"Ffile\t700\0Dfolder\0S\0", b"\0", b"F\t\0", b"F" + b"9" * 200, struct.pack("<I", 700)))
        number = rng.randrange(1 << 16)
        for message in asked:
            if codec.name(message.msgid) == "FILE_TRANSFER_PROTOCOL" and rng.random() < 0.8:
                request = next(bytes(value) for value in message.values if not isinstance(value, int))
                number = (_FTP.unpack_from(request)[0] + rng.choice((1, 1, 1, 2, 0))) & 0xFFFF
        place = rng.choice((0, 239, 478, 717, 1 << 22, 1 << 31, rng.randrange(1 << 32)))
        opcode, of = rng.choice((ACK, ACK, ACK, NAK, 0)), rng.choice((RESET, OPEN, BURST, READ, LIST))
        head = _FTP.pack(number, rng.choice((0, 0, 0, 9)), opcode, rng.choice((len(data), 255)) & 255, of,
                         rng.randrange(2), place)  # fmt: skip
        return "FILE_TRANSFER_PROTOCOL", {"payload": list((head + data)[:251].ljust(251, b"\0"))}
    if kind == 3:
        return "LOG_ENTRY", {"id": whole & 0xFFFF, "num_logs": rng.choice((0, 1, 3, 65535)), "size": whole & 0xFFFFFFFF}
    if kind == 4:
        at = rng.choice((0, 90, 180, 810, 91, whole & 0xFFFFFFFF))
        return "LOG_DATA", {"id": rng.choice((1, 2)), "ofs": at, "count": rng.choice((0, 1, 90, 255)),
                            "data": list(rng.randbytes(90))}  # fmt: skip
    if kind == 5:
        name = rng.choice(("MPC_XY_CRUISE", "SIM_BAT_CAP_J", "", "x" * 16, f"P{rng.randrange(99)}"))
        return "PARAM_VALUE", {"param_id": name, "param_value": real, "param_type": rng.randrange(256),
                               "param_index": whole & 0xFFFF, "param_count": rng.choice((0, 3, 65535))}  # fmt: skip
    if kind == 6:
        at = {"sequence": rng.choice((0, 1, 2, 40, 65535, whole & 0xFFFF))}
        arguments = list(rng.randbytes(40))
        event = {"id": 1 << 24 | rng.randrange(5), "event_time_boot_ms": whole & 0xFFFFFFFF, "arguments": arguments}
        return rng.choice((
            ("EVENT", at | event), ("CURRENT_EVENT_SEQUENCE", at | {"flags": rng.randrange(2)}),
            ("RESPONSE_EVENT_ERROR", at | {"sequence_oldest_available": whole & 0xFFFF}),
        ))  # fmt: skip
    if kind == 7:
        uri = rng.choice(("mftp://file.xz", "mftp://[;comp=1]file", "https://a/b", "mftp://", "\x7f" * 100))
        return "COMPONENT_METADATA", {"uri": uri, "file_crc": whole & 0xFFFFFFFF}
    name = rng.choice(("MISSION_COUNT", "MISSION_REQUEST_INT", "MISSION_ITEM_INT", "MISSION_ACK", "MISSION_REQUEST"))
    fields: dict[str, Any] = {"mission_type": rng.choice((1, 1, 1, 0, 255))}
    if name == "MISSION_COUNT":
        fields["count"] = rng.choice((0, 4, 4, 65535))
    elif name == "MISSION_ACK":
        fields["type"] = rng.randrange(256)
    else:
        fields["seq"] = rng.choice((0, 1, 2, 3, 4, 65535))
    if name == "MISSION_ITEM_INT":
        fields |= {"x": rng.randrange(5), "y": rng.randrange(5), "z": real, "param1": real, "command": 5001}
    return name, fields


def _filled(name: str) -> dict[str, Any]:
    """Fields of a message, all zero."""
    shape = codec.layout(name)
    zero = {form: "" if form[-1] == "s" else [0] * int(form[:-1]) if len(form) > 1 else 0 for form in shape.formats}
    return {field: zero[form] for field, form in zip(shape.record._fields, shape.formats, strict=True)}


@contextlib.contextmanager
def dialogues(hostile: Hostile) -> Iterator[Callable[[int], None]]:
    """Requests go out as time goes on; what comes back is hostile, and most of it an answer to what was asked."""
    state: dict[str, Any] = {"clients": new_clients(), "heard": 0, "now_s": 0.0}

    def attack(_: int) -> None:
        if state["heard"] >= LIVES:
            state.update(clients=new_clients(), heard=0)
        for _ in range(50):
            state["now_s"] += hostile.random.choice((0.0, 0.01, 0.01, 2.0))
            for client in state["clients"]:
                asked = client.poll(state["now_s"])
                if hostile.random.random() < 0.2:
                    frames = codec.split(hostile.datagram()).frames
                else:
                    name, fields = _answer(hostile, asked)
                    frames = codec.split(codec.encode(name, 0, 7, 1, **_filled(name) | fields)).frames
                for frame in frames:
                    sent_to(client, frame, state["now_s"])
                if isinstance(client, LogClient):
                    assert sum(len(piece.data) for piece in client.pieces) < 1 << 20
                    client.pieces.clear()
        state["heard"] += 50

    yield attack


def sent_to(client: Any, frame: Frame, now_s: float) -> None:
    """Let a dialogue hear a frame, as `FleetClient` does."""
    try:
        name, content = codec.name(frame.msgid), codec.fields(frame)
    except ValueError:  # a message that no dialect of ours holds
        return
    client.receive(name, content, now_s)


@contextlib.contextmanager
def signed_link(hostile: Hostile) -> Iterator[Callable[[int], None]]:
    """A gate with a key, and one without: frames signed with its key, another one or none, whole or mutated."""
    with tempfile.TemporaryDirectory() as folder:
        keys = [Path(folder) / name for name in ("own.key", "other.key")]
        for key in keys:
            new_key(key)
        gate, other, plain = SignatureGate(keys[0]), SignatureGate(keys[1], 1), SignatureGate(None)

        def attack(_: int) -> None:
            rng = hostile.random
            for _ in range(50):
                data = hostile.frame()
                signer = rng.choice((gate, other, plain))
                if not data[2]:
                    data = signer.signed(data)
                if rng.random() < 0.5:
                    data = hostile.mutated(data)
                frames = codec.split(data).frames
                for each in (gate, other):
                    for frame in each.accepted(frames):
                        assert frame.raw[2] & codec.SIGNED or frame.msgid in UNSIGNED
                assert all(not frame.raw[2] & codec.SIGNED for frame in plain.accepted(frames))
            for each in (gate, other, plain):
                each.refused.clear()
                each.reasons.clear()

        yield attack
        for each in (gate, other, plain):
            each.close()
