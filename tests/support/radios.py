"""Between stand-in vehicles, which speak UDP, and other kinds of links: TCP both ways, a cable, a router of many."""

from __future__ import annotations

import contextlib
import os
import pty
import select
import socket
import termios
import threading
import time
import tty
from pathlib import Path
from typing import Self

from ports import free_port

BITS_PER_BYTE = 10
"""start, eight, stop"""
BUFFER_BYTES = 2048
"""What a radio keeps that has not gone out yet; the rest is lost."""
_PIECE = 512


class Relay:
    """Passes on what vehicles say to a near UDP port, and back to all of them; a thread until `close`.

    `wait_s` is how often it looks after what is due. Subclasses have the far side: `_far` descriptors to read,
    `_read(fd)` and `_write(data)`.
    """

    wait_s = 0.2

    def __init__(self) -> None:
        self._near = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._near.bind(("127.0.0.1", 0))
        self._near.setblocking(False)
        self.port = int(self._near.getsockname()[1])
        self._vehicles: set[tuple[str, int]] = set()
        self._stop, self._stopped = socket.socketpair()
        self._lock = threading.Lock()
        self._thread = threading.Thread(target=self._live, daemon=True)

    def __enter__(self) -> Self:
        self.start()
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def start(self) -> None:
        self._thread.start()

    def close(self) -> None:
        self._stop.close()
        self._thread.join()
        for one in (self._near, self._stopped):
            one.close()

    def _far(self) -> list[int]:
        return []

    def _read(self, descriptor: int) -> bytes:
        return b""

    def _write(self, data: bytes) -> None: ...

    def _tend(self) -> None: ...

    def _live(self) -> None:
        while True:
            with self._lock:
                far = self._far()
            with contextlib.suppress(OSError, ValueError):
                ready = select.select([self._near, self._stopped, *far], [], [], self.wait_s)[0]
                if self._stopped in ready:
                    return
                with self._lock:
                    self._exchange(ready)

    def _exchange(self, ready: list[object]) -> None:
        self._tend()
        if self._near in ready:
            with contextlib.suppress(BlockingIOError):
                while True:
                    data, vehicle = self._near.recvfrom(65536)
                    self._vehicles.add(vehicle)
                    self._write(data)
        for descriptor in self._far():
            if descriptor in ready and (data := self._read(descriptor)):
                for vehicle in self._vehicles:
                    self._near.sendto(data, vehicle)


class Router(Relay):
    """All vehicles behind one UDP address."""

    def __init__(self, to: tuple[str, int]) -> None:
        super().__init__()
        self._socket = socket.socket(socket.AF_INET6 if ":" in to[0] else socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.connect(to)
        self._socket.setblocking(False)

    def close(self) -> None:
        super().close()
        self._socket.close()

    def _far(self) -> list[int]:
        return [self._socket.fileno()]

    def _read(self, descriptor: int) -> bytes:
        return self._socket.recv(65536)

    def _write(self, data: bytes) -> None:
        self._socket.send(data)


class Tcp(Relay):
    """A simulator's TCP port (to: None), or one that connects to where the ground station listens."""

    def __init__(self, to: tuple[str, int] | None = None) -> None:
        super().__init__()
        self._to = to
        self.far_port = 0 if to else free_port()
        self._server = None if to else socket.create_server(("127.0.0.1", self.far_port))
        self._stream: socket.socket | None = None
        self.cut = False

    def pull(self) -> None:
        """Drop the connection, and have none until `plug`."""
        with self._lock:
            self.cut = True
            if self._stream is not None:
                self._stream.close()
                self._stream = None
            if self._server is not None:
                self._server.close()

    def plug(self) -> None:
        """Let it be made again."""
        with self._lock:
            self.cut = False
            if self._server is not None:
                self._server = socket.create_server(("127.0.0.1", self.far_port))

    def close(self) -> None:
        super().close()
        for one in (self._stream, self._server):
            if one is not None:
                one.close()

    def _far(self) -> list[int]:
        servers = [self._server.fileno()] if self._server is not None and not self.cut else []
        return servers + ([self._stream.fileno()] if self._stream is not None else [])

    def _tend(self) -> None:
        if self._to is not None and self._stream is None and not self.cut:
            with contextlib.suppress(OSError):
                self._stream = socket.create_connection(self._to)

    def _read(self, descriptor: int) -> bytes:
        if self._server is not None and descriptor == self._server.fileno():
            self._stream, _ = self._server.accept()
            return b""
        assert self._stream is not None
        return self._stream.recv(_PIECE)

    def _write(self, data: bytes) -> None:
        if self._stream is not None:
            with contextlib.suppress(OSError):
                self._stream.sendall(data)


class Cable(Relay):
    """A serial device, a pty pair, with the throughput of its baud rate both ways. Who opens it at another rate reads
    and writes noise, as on a wire."""

    wait_s = 0.02

    def __init__(self, device: Path, baud: int) -> None:
        super().__init__()
        self.device, self.baud = device, baud
        self._master = -1
        self._waiting = b""
        self._read_budget = self._write_budget = 0.0
        self._budget_s = time.monotonic()
        self.passed = self.lost = 0
        """bytes to the ground station: that went, and for which there was no room"""
        self.plug()

    def plug(self) -> None:
        """The device is there."""
        with self._lock:
            self._master, slave = pty.openpty()
            tty.setraw(slave)
            name = os.ttyname(slave)
            os.close(slave)
            os.set_blocking(self._master, False)
            self.device.symlink_to(name)

    def pull(self) -> None:
        """The device is gone, as when its plug is pulled."""
        with self._lock:
            self.device.unlink()
            os.close(self._master)
            self._master = -1
            self._waiting = b""

    def close(self) -> None:
        super().close()
        if self._master >= 0:
            os.close(self._master)

    def _far(self) -> list[int]:
        return [self._master] if self._master >= 0 and self._read_budget >= 1.0 else []

    def _noisy(self, data: bytes) -> bytes:
        speed = termios.tcgetattr(self._master)[4]
        rate = getattr(termios, f"B{self.baud}")
        return data if speed == rate else bytes((byte * 37 + 11) & 0x7F for byte in data)

    def _tend(self) -> None:
        now_s = time.monotonic()
        more = (now_s - self._budget_s) * self.baud / BITS_PER_BYTE
        self._budget_s = now_s
        self._read_budget = min(self._read_budget + more, BUFFER_BYTES)
        self._write_budget = min(self._write_budget + more, BUFFER_BYTES)
        if self._master < 0 or not self._waiting:
            return
        piece = self._waiting[: int(self._write_budget)]
        with contextlib.suppress(OSError):
            sent = os.write(self._master, self._noisy(piece)) if piece else 0
            self._waiting = self._waiting[sent:]
            self._write_budget -= sent
            self.passed += sent

    def _read(self, descriptor: int) -> bytes:
        with contextlib.suppress(OSError):
            data = os.read(self._master, max(1, min(_PIECE, int(self._read_budget))))
            self._read_budget -= len(data)
            return self._noisy(data)
        self._read_budget = 0.0  # nobody has it open
        return b""

    def _write(self, data: bytes) -> None:
        if len(self._waiting) + len(data) > BUFFER_BYTES:
            self.lost += len(data)
        elif self._master >= 0:
            self._waiting += data
