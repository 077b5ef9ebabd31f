"""A session without sockets or processes: a supervisor, and a link whose vehicles follow a script."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pymap3d
import pytest

from gcs.link.link import Answers, TickGrants
from gcs.mavlink import codec
from gcs.mavlink.codec import Frame, Message
from gcs.recording.recorder import Recorder
from gcs.scenario.model import Scenario
from gcs.supervisor.supervisor import Supervisor

Key = tuple[int, int]
LAT, LON, ALT = 47.0, 8.0, 400.0


@dataclass
class ScriptedVehicle:
    """Already in the air and in offboard; it is always where its last set point was, and grants every command."""

    sysid: int
    p_local: tuple[float, float, float]
    offset: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """of its own origin from the common one"""
    seq: int = 2
    acks: list[int] = field(default_factory=list)
    more: list[tuple[str, dict[str, Any]]] = field(default_factory=list)
    """messages that it adds to its next answer"""
    energy_hj: int = 0
    custom_mode: int = 6 << 16
    base_mode: int = 0x81

    def hear(self, frames: list[Frame]) -> None:
        for frame in frames:
            if frame.msgid == codec.msgid("COMMAND_LONG"):
                self.acks.append(codec.fields(frame).command)
            elif frame.msgid == codec.msgid("SET_POSITION_TARGET_LOCAL_NED"):
                content = codec.fields(frame)
                self.p_local = (content.x, content.y, content.z)

    def answer(self, t_ms: int) -> list[Frame]:
        lat, lon, alt = (float(x) for x in pymap3d.ned2geodetic(*self.offset, LAT, LON, ALT))
        x, y, z = self.p_local
        told: list[tuple[str, dict[str, Any]]] = [
            ("HEARTBEAT", {"type": 2, "autopilot": 12, "base_mode": self.base_mode, "custom_mode": self.custom_mode,
                           "system_status": 4}),
            ("GPS_GLOBAL_ORIGIN", {
                "latitude": round(1e7 * lat), "longitude": round(1e7 * lon), "altitude": round(1e3 * alt)}),
            ("LOCAL_POSITION_NED", {"time_boot_ms": t_ms, "x": x, "y": y, "z": z, "vx": 0.0, "vy": 0.0, "vz": 0.0}),
            ("EXTENDED_SYS_STATE", {"vtol_state": 0, "landed_state": 2}),
            ("BATTERY_STATUS", {
                "id": 0, "battery_function": 0, "type": 0, "temperature": 0, "voltages": [65535] * 10,
                "current_battery": -1, "current_consumed": -1, "energy_consumed": self.energy_hj,
                "battery_remaining": -1}),
            *self.more,
            *(("COMMAND_ACK", {"command": c, "result": 0, "target_system": 255, "target_component": 190})
              for c in self.acks),
            ("SYSTEM_TIME", {"time_unix_usec": 0, "time_boot_ms": t_ms}),
        ]  # fmt: skip
        self.acks, self.more = [], []
        raws = []
        for name, fields in told:
            raws.append(codec.encode(name, self.seq, self.sysid, 1, **fields))
            self.seq = (self.seq + 1) % 256
        return codec.split(b"".join(raws)).frames


class ScriptedLink:
    """Takes grants and gives answers as `gcs.link.lockstep.LockstepLink` does; `bundles` keeps all that was sent."""

    def __init__(self, vehicles: Sequence[ScriptedVehicle]) -> None:
        self.vehicles = {(vehicle.sysid, 1): vehicle for vehicle in vehicles}
        self.joined: set[Key] = set(self.vehicles)
        self.bundles: list[tuple[int, Key, list[Frame]]] = []
        self.answered: list[list[Frame]] = []
        self.malformed = 0
        self.signature_refusals: dict[int, int] = {}
        self._granted: dict[Key, int] = {}
        self._seq = 0

    def flush(self) -> None:
        pass

    def overflowed(self) -> int:
        return 0

    def links(self) -> dict[int, list[Any]]:
        return {}

    def leave(self, key: Key) -> None:
        self.joined.discard(key)
        self._granted.pop(key, None)

    def grant(
        self, key: Key, t_ms: int, unix_us: int, messages: Sequence[Message], relayed: Sequence[bytes], air: bytes = b""
    ) -> list[bytes]:
        end = codec.message("SYSTEM_TIME", time_unix_usec=unix_us, time_boot_ms=t_ms)
        raws = [codec.frame(m, 0, 255, 190) for m in messages] + [
            *relayed,
            *([air] if air else []),
            codec.frame(end, 0, 255, 190),
        ]
        frames = codec.split(b"".join(raws)).frames
        self.bundles.append((t_ms, key, frames))
        self._granted[key] = t_ms
        self.vehicles[key].hear(frames)
        return raws

    def grant_all(self, grants: TickGrants) -> list[bytes]:
        return [
            raw for key in grants.keys for raw in self.grant(key, grants.t_ms, grants.unix_us, *grants.content(key))
        ]

    def answers(self, idle: Callable[[], None]) -> Iterator[Answers]:
        """The last first: in which order answers come must not matter."""
        answers = {key: self.vehicles[key].answer(t_ms) for key, t_ms in sorted(self._granted.items())}
        self.answered.append([frame for frames in answers.values() for frame in frames])
        for key, frames in reversed(answers.items()):
            yield [key], [frames]

    def unawaited(self) -> dict[Key, list[Frame]]:
        return {}

    def sent(self, name: str, key: Key | None = None) -> list[tuple[int, Any]]:
        """(grant, fields) of every message of a name that the supervisor itself sent."""
        return [
            (t_ms, codec.fields(frame))
            for t_ms, to, frames in self.bundles
            for frame in frames
            if (key is None or to == key) and frame.msgid == codec.msgid(name) and frame.sysid == 255
        ]


@dataclass
class ScriptedSession:
    supervisor: Supervisor
    link: ScriptedLink
    recorder: Recorder
    folder: Path

    def fly(self, ticks: int) -> None:
        for _ in range(ticks):
            self.supervisor.tick(lambda: None)


@pytest.fixture
def scripted(tmp_path: Path) -> Any:
    """A function that makes a session: one pursuer, 1, one target, 101, and a tanker, 201; keys change the scenario."""
    recorders: list[Recorder] = []

    def make(*, start_m: tuple[float, float, float] = (3.0, 0.0, -4.0), offset: Any = (0.0, 0.0, 0.0),
             **changed: Any) -> ScriptedSession:  # fmt: skip
        folder = tmp_path / f"session{len(recorders)}"
        folder.mkdir()
        battery = {"capacity_j": 20_000.0}
        content: dict[str, Any] = {
            "schema": 1, "name": "scripted", "axes": "ned", "origin": {"lat_deg": LAT, "lon_deg": LON, "alt_m": ALT},
            "goal": {"duration_s": 60.0, "pursue": {"within_m": 3.5, "for_s": 1.0}, "refuelled_at_least": 1},
            "clock": {"mode": "lockstep"}, "formation": {"ring_m": 2.0},
            "vehicles": {
                "pursuers": [{"sysid": 1, "start_m": start_m, "airborne": True, "battery": battery}],
                "targets": [{"sysid": 101, "start_m": (0.0, 0.0, -4.0), "airborne": True, "battery": battery,
                             "path_m": [(0.0, 0.0, -4.0), (30.0, 0.0, -4.0)], "speed_m_s": 0.8}],
                "tankers": [{"sysid": 201, "start_m": (-6.0, 0.0, -4.0), "airborne": True, "battery": battery}],
            },
        }  # fmt: skip
        scenario = Scenario.model_validate(content | changed)
        north, east, down = offset
        link = ScriptedLink([
            ScriptedVehicle(1, (start_m[0] - north, start_m[1] - east, start_m[2] - down), offset),
            ScriptedVehicle(101, (0.0, 0.0, -4.0)), ScriptedVehicle(201, (-6.0, 0.0, -4.0)),
        ])  # fmt: skip
        recorder = Recorder(folder)
        recorders.append(recorder)
        supervisor = Supervisor(scenario, link, recorder)  # type: ignore[arg-type]
        supervisor.begin()
        return ScriptedSession(supervisor, link, recorder, folder)

    yield make
    for recorder in recorders:
        recorder.close()
