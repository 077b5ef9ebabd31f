"""One address of external vehicles: its connection, its key, and its senders."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from gcs.link.addresses import open_connection
from gcs.link.connection import Channel
from gcs.link.diagnosis import Diagnosis
from gcs.link.keys import SignatureGate
from gcs.link.socket import Where
from gcs.mavlink import codec
from gcs.mavlink.codec import Message
from gcs.mavlink.sequence import sequence_numbers
from gcs.scenario.endpoint import address

RADIO_FULL_PERCENT = 20
"""So little room in a telemetry radio's buffer: from there on it tells autopilots to send less, or loses frames."""
RADIO_WEAK = 15
"""So little between signal and noise at either end, in the radio's own steps (SiK: about half a dB each)."""


@dataclass(eq=False)
class OpenAddress:
    """One address."""

    connection: Channel
    station: tuple[int, int]
    """our system and component id there"""
    gate: SignatureGate
    diagnosis: Diagnosis
    numbers: dict[Where, Iterator[int]] = field(default_factory=dict)
    speakers: set[Where] = field(default_factory=set)
    """addresses of vehicles"""
    unknown_senders: set[Where] = field(default_factory=set)
    """senders of MAVLink 1: some autopilots change to MAVLink 2 when they receive it"""
    radio: str = ""
    """problem of a telemetry radio on the way, by its last RADIO_STATUS, in words; empty where there is none"""
    radio_said_s: float = -math.inf

    @property
    def hearers(self) -> set[Where]:
        """Addresses to let know that a ground station is here."""
        to = self.connection.to
        return {to} if to is not None else self.speakers | self.unknown_senders | self.connection.senders

    def send(self, message: Message | bytes, address: Where) -> bytes:
        """Send a message, or a frame as it is, to a peer there; the frame."""
        numbers = self.numbers.setdefault(address, sequence_numbers())
        raw = message if isinstance(message, bytes) else codec.frame(message, next(numbers), *self.station)
        raw = self.gate.signed(raw)
        self.connection.send(raw, address)
        return raw


def open_address(connect: str, key_file: str | None, link_id: int, station: tuple[int, int]) -> OpenAddress:
    """Open an address of a scenario. Raises AddressRefused, KeyRefused.

    link_id: of our signatures there: a vehicle with two links takes each stream's time stamps in their order.
    """
    at = address(connect)
    assert at is not None  # as the scenario has checked
    gate = SignatureGate(Path(key_file) if key_file else None, link_id)
    return OpenAddress(open_connection(at, alone=True), station, gate, Diagnosis(at))


def radio_in_words(status: Any) -> str:
    """Words about a RADIO_STATUS that a person should know of; empty where all is well."""
    if status.txbuf <= RADIO_FULL_PERCENT:
        return f"its radio has {status.txbuf} % of its buffer left: fewer vehicles behind it, or a faster air rate"
    ends = (("here", status.rssi, status.noise), ("at the other end", status.remrssi, status.remnoise))
    for where, signal, noise in ends:
        if 0 < signal < 255 and 0 < noise < 255 and signal - noise < RADIO_WEAK:
            return f"its radio's signal {where} is weak: {signal}, noise {noise}"
    return ""
