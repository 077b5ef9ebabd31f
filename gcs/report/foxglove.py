"""A recording as MCAP, with the schemas that Foxglove shows without set-up; foxglove-sdk writes it. The same topics are
served live by `gcs.report.foxglove_live`.

/tf places every vehicle in the frame `map` (east, north, up; m), /scene draws them with obstacles, rings, paths and
transfers, /location/ID is for a map, /log has the events. /vehicle/ID, /competition and /services are the rows of the
session's socket, as JSON with their JSON Schema, for plots: `/vehicle/3.battery`.
"""

from __future__ import annotations

import importlib.util
import json
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import pymap3d

from gcs.scenario.colours import LIGHT
from gcs.session import message_types
from gcs.session.plain_text import unnamed
from gcs.session.replay import Replay

EVERY_S = 0.1
MISSING = "Foxglove and MCAP need foxglove-sdk, which is not installed: pip install '.[mcap]' in Skytender's checkout."
FRAME = "map"
LEVELS = {"info": "Info", "warning": "Warning", "critical": "Error"}
SIZES_M = {"tanker": (0.9, 0.9, 0.4), "target": (0.5, 0.5, 0.5)}
SIZE_M = (0.7, 0.7, 0.2)
GREY, AMBER = (0.42, 0.46, 0.51, 0.6), (0.85, 0.6, 0.1, 1.0)
Vector = Sequence[float]


def available() -> bool:
    """Whether foxglove-sdk is installed."""
    return importlib.util.find_spec("foxglove") is not None


def export(source: Path, out: Path, progress: Callable[[float], None] = lambda _: None) -> tuple[int, list[str]]:
    """Write a session's folder or a .tlog to the new file `out`: the number of snapshots, and sentences on what could
    not be read. `progress` is given the share that is done. Raises ReplayError, OSError, FileExistsError.
    """
    import foxglove  # noqa: PLC0415 - an extra

    if out.exists():
        raise FileExistsError(17, "exists already and is left as it is", str(out))
    replay = Replay(source, lambda share: progress(0.3 * share))
    scenario = replay.observer.scenario
    topics = Topics(0 if scenario is None else round(1e9 * scenario.clock.epoch.timestamp()))
    count = math.ceil((replay.to_s - replay.from_s) / EVERY_S - 1e-9)
    unfinished = out.with_name(f".{out.name}.unfinished")
    try:
        with foxglove.open_mcap(unfinished, allow_overwrite=True, context=topics.context):
            topics.session(replay.session(), replay.from_s)
            for k in range(count + 1):
                replay.advance(replay.from_s + k * EVERY_S, math.inf)
                if replay.observer.changed:
                    topics.session(replay.session(), replay.t_s)
                topics.snapshot(replay.snapshot(speed=None))
                progress(0.3 + 0.7 * k / max(count, 1))
        unfinished.rename(out)
    finally:
        unfinished.unlink(missing_ok=True)
    return count + 1, replay.problems


class Topics:
    """The topics of one session that began at `epoch_ns`; session and snapshot are lines as its socket has them."""

    def __init__(self, epoch_ns: int) -> None:
        from foxglove import Context, channels, messages  # noqa: PLC0415 - as above

        self._epoch_ns = epoch_ns
        self._messages, self.context = messages, Context()
        self._transforms = channels.FrameTransformsChannel("/tf", context=self.context)
        self._entities = channels.SceneUpdateChannel("/scene", context=self.context)
        self._log = channels.LogChannel("/log", context=self.context)
        self._channels: dict[str, Any] = {}
        self._session: Mapping[str, Any] = {}
        self._drawn: set[str] = set()
        """names of what stands"""

    def session(self, line: Mapping[str, Any], t_s: float) -> None:
        """Draw what stands, and name the vehicles."""
        self._session = line
        self._json("/session", "SessionLine", line, self._ns(t_s))
        m = self._messages
        bodies = []
        for shape in line["obstacles"]:
            n, e, _ = shape["centre_ned"]
            high = max(shape["bottom_d"] - shape["top_d"], 0.1)
            pose = m.Pose(
                position=m.Vector3(x=e, y=n, z=-(shape["bottom_d"] + shape["top_d"]) / 2), orientation=_level(m)
            )
            colour = self._colour(GREY)
            across = 2.0 * (shape["radius_m"] or 0.15)
            if shape["kind"] == "box":
                norths, easts = zip(*shape["outline_ne"], strict=True)
                size = m.Vector3(x=max(easts) - min(easts), y=max(norths) - min(norths), z=high)
                parts = {"cubes": [m.CubePrimitive(pose=pose, size=size, color=colour)]}
            elif shape["kind"] == "cylinder":
                size = m.Vector3(x=across, y=across, z=high)
                whole = {"bottom_scale": 1.0, "top_scale": 1.0}
                parts = {"cylinders": [m.CylinderPrimitive(pose=pose, size=size, color=colour, **whole)]}
            else:
                size = m.Vector3(x=across, y=across, z=across)
                parts = {"spheres": [m.SpherePrimitive(pose=pose, size=size, color=colour)]}
            bodies.append(m.SceneEntity(frame_id=FRAME, id=f"obstacle {shape['label']}", **parts))
        for vehicle in line["vehicles"]:
            if vehicle["path_ned"]:
                path = self._line(vehicle["path_ned"], GREY)
                bodies.append(m.SceneEntity(frame_id=FRAME, id=f"path {vehicle['sysid']}", lines=[path]))
            bodies.append(self._body(vehicle))
        drawn = {f"obstacle {shape['label']}" for shape in line["obstacles"]}
        gone = [self._deletion(name, t_s) for name in sorted(self._drawn - drawn)]
        self._drawn = drawn
        self._entities.log(m.SceneUpdate(entities=bodies, deletions=gone), log_time=self._ns(t_s))

    def _deletion(self, name: str, t_s: float) -> Any:
        m = self._messages
        kind = m.SceneEntityDeletionType.MatchingId
        return m.SceneEntityDeletion(timestamp=self._stamp(self._ns(t_s)), type=kind, id=name)

    def snapshot(self, line: Mapping[str, Any]) -> None:
        """One instant."""
        m, t_ns = self._messages, self._ns(line["t_s"])
        stamp = self._stamp(t_ns)
        placed = [row for row in line["vehicles"] if row["p_ned"] is not None]
        transforms = [
            m.FrameTransform(
                timestamp=stamp,
                parent_frame_id=FRAME,
                child_frame_id=_frame(row["sysid"]),
                translation=m.Vector3(x=row["p_ned"][1], y=row["p_ned"][0], z=-row["p_ned"][2]),
                rotation=m.Quaternion(**_attitude(*(row[angle] or 0.0 for angle in _ANGLES))),
            )
            for row in placed
        ]
        self._transforms.log(m.FrameTransforms(transforms=transforms), log_time=t_ns)
        self._entities.log(m.SceneUpdate(entities=list(self._moving(line, stamp))), log_time=t_ns)
        for row in line["vehicles"]:
            self._json(f"/vehicle/{row['sysid']}", "VehicleRow", row, t_ns)
            self._locate(row, stamp, t_ns)
        self._json("/competition", "CompetitionRow", line["competition"], t_ns)
        for service in line["services"]:
            self._json("/services", "ServiceRow", service, t_ns)
        for event in line["events"]:
            level = getattr(m.LogLevel, LEVELS[event["level"]])
            name = unnamed(event["sysid"])
            at = self._stamp(self._ns(event["t_s"]))
            self._log.log(m.Log(timestamp=at, level=level, message=event["text"], name=name), log_time=t_ns)

    def _ns(self, t_s: float) -> int:
        return self._epoch_ns + round(1e9 * t_s)

    def _stamp(self, t_ns: int) -> Any:
        return self._messages.Timestamp(sec=t_ns // 10**9, nsec=t_ns % 10**9)

    def _colour(self, rgba: Vector) -> Any:
        return self._messages.Color(**dict(zip("rgba", rgba, strict=True)))

    def _body(self, vehicle: Mapping[str, Any]) -> Any:
        """A vehicle in its own frame, which /tf moves."""
        m = self._messages
        x, y, z = SIZES_M.get(vehicle["role"], SIZE_M)
        colour = self._colour(_rgba(LIGHT[vehicle["colour"] % len(LIGHT)]))
        nose = m.Pose(position=m.Vector3(x=0.5 * x), orientation=_level(m))
        above = m.Pose(position=m.Vector3(z=0.6), orientation=_level(m))
        return m.SceneEntity(
            frame_id=_frame(vehicle["sysid"]),
            id=f"vehicle {vehicle['sysid']}",
            frame_locked=True,
            cubes=[
                m.CubePrimitive(pose=m.Pose(orientation=_level(m)), size=m.Vector3(x=x, y=y, z=z), color=colour),
                m.CubePrimitive(pose=nose, size=m.Vector3(x=0.3, y=0.12, z=0.12), color=colour),
            ],
            texts=[
                m.TextPrimitive(
                    pose=above,
                    billboard=True,
                    font_size=14,
                    scale_invariant=True,
                    color=colour,
                    text=str(vehicle["sysid"]),
                )
            ],
        )

    def _moving(self, line: Mapping[str, Any], stamp: Any) -> Iterator[Any]:
        """Rings, traffic and transfers, each for as long as one snapshot lasts."""
        m = self._messages
        at = {row["sysid"]: row["p_ned"] for row in line["vehicles"] if row["p_ned"] is not None}
        bases = {base["name"]: base["p_ned"] for base in self._session.get("bases", ())}
        brief = {"timestamp": stamp, "frame_id": FRAME, "lifetime": m.Duration(sec=0, nsec=round(2e9 * EVERY_S))}
        ring_m = self._session.get("ring_m")
        for row in line["vehicles"]:
            if ring_m and row["role"] == "target" and row["sysid"] in at:
                n, e, d = at[row["sysid"]]
                turns = [2.0 * math.pi * k / 48 for k in range(49)]
                around = [(n + ring_m * math.cos(a), e + ring_m * math.sin(a), d) for a in turns]
                yield m.SceneEntity(id=f"ring {row['sysid']}", lines=[self._line(around, GREY)], **brief)
        for service in line["services"]:
            giver = at.get(service["tanker"]) if service["tanker"] is not None else bases.get(service["base"])
            receiver = at.get(service["receiver"])
            if giver is not None and receiver is not None:
                tube = self._line((giver, receiver), AMBER, 5.0 if service["phase"] == "transfer" else 1.5)
                yield m.SceneEntity(id=f"service {service['receiver']}", lines=[tube], **brief)
        for craft in line["traffic"]:
            n, e, d = craft["p_ned"]
            pose = m.Pose(position=m.Vector3(x=e, y=n, z=-d), orientation=_level(m))
            colour = self._colour(AMBER)
            ball = m.SpherePrimitive(pose=pose, size=m.Vector3(x=0.6, y=0.6, z=0.6), color=colour)
            yield m.SceneEntity(id=f"traffic {craft['callsign']}", spheres=[ball], **brief)

    def _line(self, points_ned: Sequence[Vector], rgba: Vector, width_px: float = 1.5) -> Any:
        m = self._messages
        return m.LinePrimitive(
            type=m.LinePrimitiveLineType.LineStrip,
            thickness=width_px,
            scale_invariant=True,
            points=[m.Point3(x=p[1], y=p[0], z=-p[2]) for p in points_ned],
            color=self._colour(rgba),
        )

    def _locate(self, row: Mapping[str, Any], stamp: Any, t_ns: int) -> None:
        origin = self._session.get("origin")
        if origin is None or row["p_ned"] is None:
            return
        from foxglove import channels  # noqa: PLC0415 - as above

        topic = f"/location/{row['sysid']}"
        channel = self._channels.get(topic)
        if channel is None:
            channel = self._channels[topic] = channels.LocationFixChannel(topic, context=self.context)
        lat, lon, alt = pymap3d.ned2geodetic(*row["p_ned"], *origin)
        fix = self._messages.LocationFix(
            timestamp=stamp, frame_id=FRAME, latitude=float(lat), longitude=float(lon), altitude=float(alt)
        )
        channel.log(fix, log_time=t_ns)

    def _json(self, topic: str, kind: str, row: Mapping[str, Any], t_ns: int) -> None:
        from foxglove import Channel  # noqa: PLC0415 - as above

        channel = self._channels.get(topic)
        if channel is None:
            channel = self._channels[topic] = Channel(topic, schema=_schema(kind), context=self.context)
        channel.log(json.dumps(row).encode(), log_time=t_ns)


def _schema(kind: str) -> dict[str, Any]:
    """One type of the session's socket as a JSON Schema of its own."""
    whole = message_types.schema()
    return {**whole["$defs"][kind], "title": f"skytender.{kind}", "$defs": whole["$defs"]}


def _frame(sysid: int) -> str:
    return f"vehicle_{sysid}"


def _rgba(colour: str) -> Vector:
    """`#rrggbb` as shares."""
    return [*(int(colour[k : k + 2], 16) / 255.0 for k in (1, 3, 5)), 1.0]


def _level(messages: Any) -> Any:
    return messages.Quaternion(w=1.0)


_ANGLES = ("roll_rad", "pitch_rad", "heading_rad")
"""One that was not reported is drawn as 0: a transform has no place for an unknown one."""


def _attitude(roll_rad: float, pitch_rad: float, yaw_rad: float) -> dict[str, float]:
    """Roll, pitch and yaw of a body (forward, right, down) in NED as a quaternion of one (forward, left, up) in ENU.

    Forward stays; left and up are the negative of right and down: roll stays, pitch changes its sign, and yaw counts
    from east against the clock (REP 103).
    """
    a, b, c = (math.pi / 2.0 - yaw_rad) / 2.0, -pitch_rad / 2.0, roll_rad / 2.0
    (sa, ca), (sb, cb), (sc, cc) = ((math.sin(x), math.cos(x)) for x in (a, b, c))
    return {
        "w": ca * cb * cc + sa * sb * sc,
        "x": ca * cb * sc - sa * sb * cc,
        "y": ca * sb * cc + sa * cb * sc,
        "z": sa * cb * cc - ca * sb * sc,
    }
