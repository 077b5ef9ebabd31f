"""A client's dialogue with a scripted vehicle, without a socket or a clock: pymavlink packs and reads the frames."""

from __future__ import annotations

from typing import Any

from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec

OUT = mav.MAVLink(None, srcSystem=3, srcComponent=1)


def heard(message: codec.Message) -> Any:
    """A client's message as pymavlink reads it from the wire."""
    (one,) = OUT.parse_buffer(codec.frame(message, 0, 255, 190)) or []
    return one


def received(message: Any) -> tuple[str, Any]:
    """Name and fields of a vehicle's message as a client gets them."""
    (frame,) = codec.split(bytes(message.pack(OUT))).frames
    return codec.name(frame.msgid), codec.fields(frame)


def deliver(client: Any, *messages: Any, now_s: float = 0.0) -> None:
    for message in messages:
        client.receive(*received(message), now_s)


def exchange(client: Any, vehicle: Any, now_s: float) -> None:
    """What the vehicle says by itself (`tick`), and its answers (`hear`); `lose` of all messages get lost."""
    lose = getattr(vehicle, "lose", 0.0)

    def comes() -> bool:
        return not lose or vehicle.random.random() >= lose

    answers = vehicle.tick(now_s) if hasattr(vehicle, "tick") else []
    for message in client.poll(now_s):
        if comes():
            answers += vehicle.hear(heard(message))
    deliver(client, *(answer for answer in answers if comes()), now_s=now_s)


def converse(client: Any, vehicle: Any, within_s: float = 300.0, step_s: float = 0.05) -> float:
    """Until the client is done; when that was, s."""
    now_s = 0.0
    while not client.done:
        assert now_s < within_s
        exchange(client, vehicle, now_s)
        now_s += step_s
    return now_s
