"""MAVSDK and MAVProxy look on while `gcs` supervises, and MAVSDK lands one."""

from __future__ import annotations

import socket
import subprocess
from pathlib import Path
from typing import Any

import pytest
from conversation import Conversation
from sessions import Running, small

SCRIPT = Path(__file__).with_name("with_mavsdk.py")
pytestmark = pytest.mark.timeout(110)


def free_port() -> int:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


def test_mavsdk_lands_what_gcs_flies_while_mavproxy_looks_on(peers: Path, tmp_path: Path) -> None:
    sdk, proxy = free_port(), free_port()
    argv = [str(peers / "python"), "-u", str(peers / "mavproxy.py"), f"--master=udpin:127.0.0.1:{proxy}"]
    argv += [f"--state-basedir={tmp_path}", "--aircraft=peer"]
    said = small(goal={"duration_s": 40.0, "refuelled_at_least": 0, "lost_at_most": 1}, clock={"mode": "real"})
    said["forward"] = {"to": [f"udpout:127.0.0.1:{sdk}", f"udpout:127.0.0.1:{proxy}"], "control": True}
    with subprocess.Popen(
        argv, cwd=tmp_path, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT
    ) as mavproxy:
        talk = Conversation(mavproxy)
        running = Running(said, tmp_path, "--json")
        try:
            running.wait_for(lambda seen: all(v["stage"] == "fly" for v in seen["vehicles"]))
            done = subprocess.run(
                [str(peers / "python"), str(SCRIPT), str(sdk), "lands_what_another_flies"],
                capture_output=True, text=True, timeout=60.0, check=False,
            )  # fmt: skip
            assert done.returncode == 0, done.stdout[-1500:] + done.stderr[-3000:]
            talk.hear("online system 1")
            outcome = running.finish()
        finally:
            mavproxy.kill()
            running.stop()
    orders: list[Any] = [line for line in outcome.decisions if line["kind"] == "operator"]
    assert ("release", 1) in [(line["command"], line["sysid"]) for line in orders]
    assert any("NAV_LAND to pursuer 1 by 245/190 at udpout:" in line["text"] for line in orders), orders
    assert {1, 101, 201} <= {line["sysid"] for line in outcome.decisions if line["kind"] == "set_point"}
