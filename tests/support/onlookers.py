"""Other ground stations, which a session forwards to: pymavlink's in a thread, MAVProxy and MAVSDK as the programs
that they are."""

from __future__ import annotations

import contextlib
import socket
import subprocess
import threading
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

from conversation import Conversation
from pymavlink.dialects.v20 import common as mav

SCENES = Path(__file__).resolve().parents[1] / "peers" / "with_mavsdk.py"


class PymavlinkStation:
    """Hears what is forwarded to it, in a thread, and tells a vehicle that flies to land, as QGroundControl does: from
    255/190. `lands` may be set while it lives; None: it looks on."""

    def __init__(self, lands: int | None) -> None:
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4 << 20)
        self._socket.bind(("127.0.0.1", 0))
        self.address = f"udpout:127.0.0.1:{self._socket.getsockname()[1]}"
        self.lands = lands
        self._mav = mav.MAVLink(None, srcSystem=255, srcComponent=190)
        self._mav.robust_parsing = True
        self._thread = threading.Thread(target=self._live)
        self.heard: Counter[tuple[int, str]] = Counter()
        self.acked: list[tuple[int, int, int]] = []
        """(vehicle, result, addressee) of each acknowledgement of a landing"""
        self.orders = 0
        self._thread.start()

    def _live(self) -> None:
        while True:
            datagram, to = self._socket.recvfrom(65536)
            if not datagram:
                return
            for message in self._mav.parse_buffer(datagram) or []:
                sysid, name = message.get_srcSystem(), message.get_type()
                self.heard[sysid, name] += 1
                if name == "COMMAND_ACK" and message.command == mav.MAV_CMD_NAV_LAND:
                    self.acked.append((sysid, message.result, message.target_system))
                if (sysid, name) == (self.lands, "LOCAL_POSITION_NED") and message.z < -2.0 and not self.acked:
                    self.orders += 1
                    land = mav.MAVLink_command_long_message(
                        sysid, 1, mav.MAV_CMD_NAV_LAND, self.orders & 0xFF, 0, 0, 0, 0, 0, 0, 0
                    )
                    self._socket.sendto(bytes(land.pack(self._mav)), to)

    def close(self) -> None:
        self._socket.sendto(b"", self._socket.getsockname())
        self._thread.join()
        self._socket.close()


@contextlib.contextmanager
def pymavlink_station(lands: int | None = None) -> Iterator[PymavlinkStation]:
    """One that ends with the block."""
    one = PymavlinkStation(lands)
    try:
        yield one
    finally:
        one.close()


@contextlib.contextmanager
def mavproxy(peers: Path, master: str, folder: Path) -> Iterator[Conversation]:
    """MAVProxy at an address of its own grammar, such as `udpin:127.0.0.1:14550`, with its files in a folder."""
    argv = [str(peers / "mavproxy.py"), f"--master={master}", f"--state-basedir={folder}", "--aircraft=peer"]
    with _talking(peers, argv, folder) as talk:
        yield talk


@contextlib.contextmanager
def mavsdk(peers: Path, port: int, scene: str, *sysids: int) -> Iterator[Conversation]:
    """A scene of `with_mavsdk.py` with the vehicles that come to a port."""
    with _talking(peers, [str(SCENES), str(port), scene, *map(str, sysids)], None) as talk:
        yield talk


@contextlib.contextmanager
def _talking(peers: Path, argv: Sequence[str], folder: Path | None) -> Iterator[Conversation]:
    with subprocess.Popen(
        [str(peers / "python"), "-u", *argv],
        cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
    ) as process:  # fmt: skip
        try:
            yield Conversation(process)
        finally:
            process.kill()
