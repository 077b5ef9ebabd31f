"""`gcs launch` as another ground station meets it."""

from __future__ import annotations

import contextlib
import json
import socket
import subprocess
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import yaml
from pymavlink.dialects.v20 import common as mav
from sessions import GCS


@contextlib.contextmanager
def launched(scenario: Mapping[str, Any], folder: Path) -> Iterator[dict[int, tuple[str, int]]]:
    """The vehicles of a scenario, by system id where each listens; they end with the block."""
    path = folder / "fleet.yaml"
    path.write_text(yaml.safe_dump(dict(scenario)), encoding="utf-8")
    argv = [*GCS, "launch", str(path), "--json", "--until-eof", "--trust"]
    with subprocess.Popen(argv, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        assert process.stdout is not None
        vehicles = json.loads(process.stdout.readline())["vehicles"]
        yield {v["sysid"]: ("127.0.0.1", int(v["address"].rpartition(":")[2])) for v in vehicles}
        process.communicate(timeout=30)


def first_heartbeat(at: tuple[str, int]) -> Any:
    """The first HEARTBEAT that comes from there after one of a ground station."""
    station = mav.MAVLink(None, srcSystem=245, srcComponent=190)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as udp:
        udp.settimeout(20.0)
        udp.connect(at)
        udp.send(bytes(mav.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3).pack(station)))
        while True:
            for message in station.parse_buffer(udp.recv(4096)) or []:
                if message.get_type() == "HEARTBEAT":
                    return message
