"""A scenario's check list over its external vehicles, without a flight: no vehicle is armed, no mode is changed.

The parts are the session's own, so that a vehicle that passes here passes there. Fence and rally points are uploaded as
a session would. Time is an argument: s since `begin` of the link.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gcs.link.external import ExternalLink
from gcs.mavlink import codec
from gcs.mavlink.codec import Frame
from gcs.mavlink.ids import AUTOPILOT, OUR_HEARTBEAT
from gcs.mavlink.statustext import Texts, chunk_of
from gcs.mavlink.stream_requests import CHECK_S
from gcs.scenario.model import Scenario
from gcs.supervisor.arming_external import FAR_M
from gcs.supervisor.external_fleet import DISTANT_M, ExternalFleet
from gcs.supervisor.factory import make_fleet
from gcs.supervisor.fleet_command_queue import FleetCommandQueue
from gcs.supervisor.preflight import CheckItem, Preflight
from gcs.telemetry.state import VehicleView
from skytender import elementary
from skytender import mavlink as mav

HEARTBEAT_EVERY_S = 1.0
STREAMS_S = CHECK_S + 1.0
"""So long after the first tick the streams have been asked for and counted."""
_SYS_STATUS = codec.msgid("SYS_STATUS")
_STATUSTEXT = codec.msgid("STATUSTEXT")
_PREARM = mav.MAV_SYS_STATUS_PREARM_CHECK
MOST_TEXTS = 3


class GroundCheck:
    """The check lists of a scenario's external vehicles."""

    def __init__(self, scenario: Scenario, link: ExternalLink) -> None:
        self._link = link
        self._expected = scenario.vehicles.external
        self._fleet = make_fleet(scenario)
        self._externals = ExternalFleet(scenario)
        self._preflight = Preflight(scenario, returns_set=False, keeps_plans=False)
        self._queue = FleetCommandQueue(self._expected, dict.fromkeys(self._expected, scenario.station.ids))
        self._heartbeat_s = -HEARTBEAT_EVERY_S
        self._ready: dict[int, bool | None] = {}
        """whether SYS_STATUS says that it could be armed; None: it does not know that"""
        self._ready_since_s = 0.0
        """when the last that could not be armed could"""
        self._texts: dict[int, list[str]] = {}
        self._chunks: dict[int, Texts] = {}
        self._received = {sysid for sysid, _ in link.joined}
        self._now_s = 0.0

    def tick(self, now_s: float, unix_us: int) -> None:
        """Take what has come, and send what is due; `unix_us` is the time by our clock."""
        self._now_s = now_s
        delivered = {key[0]: frames for key, frames in self._link.collect().items()}
        self._received |= delivered.keys()
        for frames in delivered.values():
            self._fleet.ingest_all(frames, now_s)
            self._read(frames)
        offsets_s, rebooted = self._link.offsets_s(), self._link.pop_rebooted()
        self._externals.receive(delivered, offsets_s, rebooted, self._fleet, now_s)
        self._preflight.receive(delivered, unix_us, now_s, now_s)
        for sysid, ack in self._fleet.pop_acks():
            for result in self._queue.on_ack(sysid, ack, now_s):
                self._externals.settles(sysid, result, now_s)
        snapshot = self._fleet.snapshot(now_s)
        commands, messages = self._externals.decide(snapshot)
        for sysid, more in (*messages.items(), *self._preflight.decide(snapshot).items()):
            self._queue.put(sysid, more)
        self._queue.ask([command for command in commands if command.sysid in self._received], now_s)
        greets = now_s - self._heartbeat_s >= HEARTBEAT_EVERY_S
        self._heartbeat_s = now_s if greets else self._heartbeat_s
        for sysid in sorted(self._received):
            for result in self._queue.poll(sysid, now_s):
                self._externals.settles(sysid, result, now_s)
            self._link.grant((sysid, AUTOPILOT), [*([OUR_HEARTBEAT] if greets else ()), *self._queue.pop(sysid)], ())

    @property
    def done(self) -> bool:
        """Whether nothing is open any more for the vehicles that were received."""
        return self._now_s >= STREAMS_S and all(self._preflight.ended(sysid) for sysid in self._received)

    @property
    def ready(self) -> bool:
        """Whether no vehicle reports that it could not be armed. A vehicle that knows its place only now sends it only
        now, so missing streams are judged by a count that began after that."""
        if any(self._ready.get(sysid) is False for sysid in self._received):
            return False
        counted = self._now_s - self._ready_since_s >= CHECK_S + STREAMS_S
        return counted or not any(map(self._externals.missing_streams, self._received))

    def lists(self, waits: Mapping[int, str]) -> dict[int, list[CheckItem]]:
        """Check lists by system id; `waits` are reasons why a vehicle has not been received."""
        snapshot = self._fleet.snapshot(self._now_s)
        links = self._link.links()
        found = {}
        for sysid, rules in self._expected.items():
            if sysid not in self._received:
                why = waits.get(sysid) or "is it switched on, and has it that system id?"
                found[sysid] = [CheckItem("heard", False, f"no HEARTBEAT at {rules.where}: {why}")]
                continue
            items = [CheckItem("heard", True, f"heard at {rules.where}")]
            for one in links.get(sysid, ()):
                if not one.fresh:
                    items.append(CheckItem("link", False, f"not heard at {one.connect}"))
            items += [_origin(snapshot.vehicle(sysid)), *self._preflight.items(sysid)]
            missing = self._externals.missing_streams(sysid)
            text = f"does not send {', '.join(missing)} as often as asked" if missing else "sends what is needed"
            found[sysid] = [*items, CheckItem("streams", not missing, text), self._readiness(sysid)]
        return found

    def _read(self, frames: Sequence[Frame]) -> None:
        for frame in frames:
            if frame.msgid == _SYS_STATUS and frame.compid == AUTOPILOT:
                content = codec.fields(frame)
                knows = content.onboard_control_sensors_present & _PREARM
                ready = bool(content.onboard_control_sensors_health & _PREARM) if knows else None
                if ready and self._ready.get(frame.sysid) is False:
                    self._ready_since_s = self._now_s
                self._ready[frame.sysid] = ready
            elif frame.msgid == _STATUSTEXT and frame.compid == AUTOPILOT:
                self._keep(frame.sysid, self._chunks.setdefault(frame.sysid, Texts()).add(chunk_of(frame), self._now_s))
        for sysid, chunks in self._chunks.items():
            self._keep(sysid, chunks.overdue(self._now_s))

    def _keep(self, sysid: int, whole: Sequence[tuple[int, str]]) -> None:
        texts = self._texts.setdefault(sysid, [])
        for _, text in whole:
            if "arm" in text.lower() and text not in texts:
                del texts[: -MOST_TEXTS + 1]
                texts.append(text)

    def _readiness(self, sysid: int) -> CheckItem:
        ready = self._ready.get(sysid)
        if ready is None:
            return CheckItem("ready", True, "does not say whether it could be armed")
        if ready:
            return CheckItem("ready", True, "ready to be armed")
        why = "; ".join(self._texts.get(sysid, ())) or "its pre-arm checks do not pass"
        return CheckItem("ready", False, f"not ready to be armed: {why}")


def _origin(view: VehicleView) -> CheckItem:
    if view.origin_offset_ned is None:
        return CheckItem("origin", False, "does not tell where its frame lies (GPS_GLOBAL_ORIGIN, HOME_POSITION)")
    away_m = elementary.norm(view.origin_offset_ned[:2])
    text = f"origin {away_m:.0f} m from the scenario's" if away_m < DISTANT_M else f"origin {away_m / 1e3:.1f} km away"
    return CheckItem("origin", away_m <= FAR_M, text)
