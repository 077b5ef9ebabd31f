"""Capture the golden frames anew: `python tests/wire/golden/capture.py`, some two minutes; needs `.venv-peers`.

Each file beside this one holds frames as one peer put them on the wire, the first of each kind, with the fields as
pymavlink read them then: what MAVSDK's client says to our vehicle, what MAVSDK's server plugins say, and what
pymavlink writes.
"""

from __future__ import annotations

import json
import select
import socket
import subprocess
import sys
import time
from collections.abc import Iterable
from contextlib import ExitStack
from pathlib import Path
from typing import Any

from pymavlink.dialects.v20 import common as mav

HERE = Path(__file__).parent
ROOT = HERE.parents[2]
TESTS = ROOT / "tests"
PEERS = str(ROOT / ".venv-peers" / "bin" / "python")
sys.path.insert(0, str(TESTS / "support"))

from ports import free_port  # noqa: E402
from station import POSITION, Station  # noqa: E402

SCENES = ("flight", "offboard", "mission", "follow", "failures")
TELL_APART = ("command", "type_mask", "coordinate_frame", "param_type", "mission_type")
REPACKED = {"HEARTBEAT", "HOME_POSITION"}
"""What tests/peers/mavsdk_vehicle.py puts right in MAVSDK's frames is not MAVSDK's."""


def keep(file: str, peer: str, datagrams: Iterable[bytes], but: frozenset[str] | set[str] = frozenset()) -> None:
    """The first frame of each kind, where a command or a mask makes a kind of its own."""
    kept: dict[tuple[Any, ...], dict[str, Any]] = {}
    reader = mav.MAVLink(None)
    reader.robust_parsing = True
    for datagram in datagrams:
        for message in reader.parse_buffer(datagram) or []:
            name = message.get_type()
            kind = (name, *(getattr(message, field, None) for field in TELL_APART))
            if name in but or name == "BAD_DATA" or name.startswith("UNKNOWN") or kind in kept:
                continue
            fields = {field: getattr(message, field) for field in message.get_fieldnames()}
            ids = [message.get_srcSystem(), message.get_srcComponent(), message.get_seq()]
            kept[kind] = {"name": name, "hex": message.get_msgbuf().hex(), "from": ids, "fields": fields}
    lines = ",\n".join(json.dumps(kept[kind]) for kind in sorted(kept, key=str))
    (HERE / file).write_text(f'{{"by": {json.dumps(peer)}, "frames": [\n{lines}\n]}}\n', encoding="utf-8")
    print(f"{file}: {len(kept)} frames of {peer}")


def mavsdk_client() -> list[bytes]:
    """What MAVSDK sends a vehicle of ours in each scene, taken between them."""
    heard: list[bytes] = []
    for scene in SCENES:
        with ExitStack() as stack:
            near, far = (stack.enter_context(socket.socket(socket.AF_INET, socket.SOCK_DGRAM)) for _ in range(2))
            for each in (near, far):
                each.bind(("127.0.0.1", 0))
            port = free_port()
            connect = f"udpout:127.0.0.1:{near.getsockname()[1]}"
            program = "from simvehicle.cli import main; main()"
            vehicle = [sys.executable, "-c", program, "--sysid", "1", "--connect", connect]
            script = [PEERS, str(TESTS / "peers" / "with_mavsdk.py"), str(port), scene]
            flown = stack.enter_context(subprocess.Popen(vehicle, stdout=subprocess.DEVNULL))
            client = stack.enter_context(subprocess.Popen(script, stdout=subprocess.DEVNULL))
            stack.callback(flown.kill)
            stack.callback(client.kill)
            peer = None
            while client.poll() is None:
                for ready in select.select([near, far], [], [], 0.2)[0]:
                    datagram, sender = ready.recvfrom(65536)
                    if ready is near:
                        peer = sender
                        far.sendto(datagram, ("127.0.0.1", port))
                    elif peer is not None:
                        heard.append(datagram)
                        near.sendto(datagram, peer)
            assert client.returncode == 0, scene
    return heard


def vehicle_says(*argv: str) -> list[bytes]:
    """What a scripted vehicle says to a station that asks for everything."""
    with Station(9) as station:
        connect = ["--sysid", "9", "--connect", f"udpout:127.0.0.1:{station.port}", "--refuse-arming-s", "0.5"]
        with subprocess.Popen([*argv, *connect], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL) as vehicle:
            station.hear("HEARTBEAT")
            station.command(mav.MAV_CMD_COMPONENT_ARM_DISARM, 1, until=None)
            station.send(mav.MAVLink_request_data_stream_message(9, 1, mav.MAV_DATA_STREAM_ALL, 4, 1))
            station.send(mav.MAVLink_param_request_list_message(9, 1))
            station.send(mav.MAVLink_mission_request_list_message(9, 1))
            station.send(mav.MAVLink_mission_count_message(9, 1, 1, 0))
            station.send(mav.MAVLink_timesync_message(0, 5))
            for msgid in (mav.MAVLINK_MSG_ID_AUTOPILOT_VERSION, mav.MAVLINK_MSG_ID_EXTENDED_SYS_STATE):
                station.command(mav.MAV_CMD_REQUEST_MESSAGE, msgid, until=None)
            station.aim(POSITION, (1.0, 2.0, -3.0))
            end_s = time.monotonic() + 3.0
            while time.monotonic() < end_s:
                station.hear("HEARTBEAT")
            vehicle.communicate(timeout=10.0)
            return station.datagrams


if __name__ == "__main__":
    version = "4.1.0"
    keep("pymavlink.json", "pymavlink 2.4.50", vehicle_says(sys.executable, str(TESTS / "peers" / "arducopter.py")))
    server = vehicle_says(PEERS, str(TESTS / "peers" / "mavsdk_vehicle.py"))
    keep("mavsdk_vehicle.json", f"MAVSDK {version}, server plugins", server, but=REPACKED)
    keep("mavsdk_client.json", f"MAVSDK {version}, client", mavsdk_client())
