"""MAVSDK and MAVProxy look on while `gcs` flies vehicles of its own, and MAVSDK lands one."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from onlookers import mavproxy, mavsdk
from ports import free_port
from sessions import Running, small


def test_mavsdk_lands_what_gcs_flies_while_mavproxy_looks_on(peers: Path, tmp_path: Path) -> None:
    sdk, proxy = free_port(), free_port()
    said = small(goal={"duration_s": 20.0, "refuelled_at_least": 0, "lost_at_most": 1}, clock={"mode": "real"})
    said["forward"] = {"to": [f"udpout:127.0.0.1:{sdk}", f"udpout:127.0.0.1:{proxy}"], "control": True}
    with mavproxy(peers, f"udpin:127.0.0.1:{proxy}", tmp_path) as talk, mavsdk(peers, sdk, "looks_on", 1) as pilot:
        pilot.hear("listens")
        running = Running(said, tmp_path, "--json")
        try:
            pilot.hear("sees 1")
            pilot.type("1")
            pilot.hear("landed 1")
            talk.hear("online system 1")
            outcome = running.finish()
        finally:
            running.stop()
    orders: list[Any] = [line for line in outcome.decisions if line["kind"] == "operator"]
    assert ("release", 1) in [(line["command"], line["sysid"]) for line in orders]
    assert any("NAV_LAND to pursuer 1 by 245/190 at udpout:" in line["text"] for line in orders), orders
    assert {1, 101, 201} <= {line["sysid"] for line in outcome.decisions if line["kind"] == "set_point"}
