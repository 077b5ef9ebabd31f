"""External vehicles of a session, tick by tick: what they need beside what all vehicles do.

Streams are asked for and checked, clocks compared, silence judged, and repetitions suppressed.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Mapping, Sequence
from typing import Any

from gcs.mavlink import codec
from gcs.mavlink.autopilots import STEERABLE, End
from gcs.mavlink.codec import Frame, Message
from gcs.mavlink.command_protocol import CommandRequest, CommandResult, result_in_words
from gcs.mavlink.ids import AUTOPILOT
from gcs.mavlink.services import standard_modes, vehicle_events, vehicle_uid
from gcs.mavlink.services.vehicle_events import VehicleEvents
from gcs.mavlink.stream_requests import CHECK_S, SLOW_SHARE, Ask, StreamRequests, needs
from gcs.scenario.model import Scenario
from gcs.supervisor.arming import Stage
from gcs.supervisor.estimators import Estimators
from gcs.supervisor.services.operator_control import TOKEN as CONTROL
from gcs.supervisor.services.operator_control import OperatorControl
from gcs.telemetry.events import Event, Kind, Level
from gcs.telemetry.fleet import Fleet
from gcs.telemetry.state import FleetSnapshot, VehicleView
from skytender import elementary
from skytender import mavlink as mav

LOST_S = 10.0
"""A vehicle that has been silent for so long is counted as lost, until it reports again."""
SILENT_S = CHECK_S * SLOW_SHARE
"""A silence so long would make every stream look slow."""
SAY_AGAIN_S = 10.0
MOST_SAID = 1000
"""Most different texts of all external vehicles that are shown within SAY_AGAIN_S."""
NO_ORIGIN_S = 5.0
DISTANT_M = 5000.0
"""An origin that is farther from the scenario's is reported: it may be a mistake."""
BEHIND_S = 2.0
"""At another speed than 1: a clock that has fallen so much further behind the session's is reported."""
GROUND_OFF_M = 2.0
"""A home that lies so much higher or lower than the scenario's height 0 is reported."""
STEERED = frozenset({Stage.ARM, Stage.TAKEOFF, Stage.OFFBOARD, Stage.FLY, Stage.MISSION})
BOOTED = "Its clock has begun anew: it has booted"
ENDING, MODES, UID, METADATA = "end", "modes", "uid", "metadata"
UID_EVERY_S, UID_TIMES = 1.0, 3
"""A vehicle is asked so often for its uid: behind one address another may have its id, whose answer may be lost."""
_ENDS: Mapping[End, str] = {"hold": "hold", "return": "return to where it took off", "land": "land"}
_DISARM = (int(mav.MAV_CMD_COMPONENT_ARM_DISARM), (0.0,))


class ExternalFleet:
    """All external vehicles of a session."""

    def __init__(self, scenario: Scenario) -> None:
        self.rules = scenario.vehicles.foreign
        wanted = needs(scenario.clock.period_s)
        self.patience_s = max((block.arm_within_s for block in self.rules.values()), default=0.0)
        """how much longer than others their fleets wait until they are in the air"""
        self.streams = {sysid: StreamRequests(sysid, wanted) for sysid in self.rules}
        self._estimators = Estimators(scenario)
        self._modes = standard_modes.ModeRequests()
        self.control = OperatorControl(self.rules, scenario.station)
        self._own_events = VehicleEvents()
        self._texts: list[tuple[int, int, str, float]] = []
        self.lost: set[int] = set()
        self._died: set[int] = set()
        self._last_received_s = dict.fromkeys(self.rules, 0.0)
        self._said_s: dict[tuple[int, str], float] = {}
        self._asks: dict[int, list[Ask]] = {sysid: [] for sysid in self.rules}
        self._origin_noted: set[int] = set()
        self._ground_noted: set[int] = set()
        self._distance_noted: set[int] = set()
        self._handed_back: set[int] = set()
        self._answers: dict[int, str] = {}
        self._events: list[Event] = []
        self._records: list[dict[str, Any]] = []
        self._now_s = 0.0
        self._speed = scenario.clock.speed if scenario.clock.mode == "real" else 1.0
        self._uids: dict[int, dict[str, None]] = {sysid: {} for sysid in scenario.vehicles.external}
        self._uids_asked = dict.fromkeys(self._uids, 0)
        self.ambiguous: dict[int, str] = {}
        """why vehicles are not to be armed: what is sent to them reaches another one too"""
        self._offset_s: dict[int, float] = {}
        """from each one's own time to the session's, as last reported"""

    def receive(
        self,
        delivered: Mapping[int, Sequence[Frame]],
        offsets_s: Mapping[int, float],
        rebooted: Iterable[int],
        fleet: Fleet,
        now_s: float,
    ) -> None:
        """Take what has been delivered at this tick, and what the link knows of the vehicles' clocks."""
        self._now_s = now_s
        for sysid in rebooted:
            self.streams[sysid].restart()
            self._offset_s.pop(sysid, None)
            self._uids.get(sysid, {}).clear()
            self._records.append({"t_s": now_s, "kind": "boot", "sysid": sysid, "text": BOOTED})
            self._note(sysid, "warning", BOOTED)
        for sysid, offset_s in offsets_s.items():
            fleet.set_clock(sysid, offset_s)
            self._watch_pace(sysid, offset_s)
        for sysid, streams in self.streams.items():
            own = [frame for frame in delivered.get(sysid, ()) if frame.compid == mav.MAV_COMP_ID_AUTOPILOT1]
            for frame in own:
                streams.received(frame.msgid, now_s)
            if (flies_on := self._estimators.receive(sysid, own, now_s)) is not None:
                self._events.append(flies_on)
            self._events += self.control.receive(sysid, own, now_s)
            self._compare_uids(sysid, own)
            if sysid in self._uids:
                self._receive_events(sysid, own)
            if own:
                self._last_received_s[sysid] = now_s
                if sysid in self.lost - self._died:
                    self.lost.discard(sysid)
                    streams.restart()
                    fleet.found(sysid)
                    self._note(sysid, "warning", "Heard again: it is not lost")
            elif now_s - self._last_received_s[sysid] >= LOST_S and sysid not in self.lost:
                self.lost.add(sysid)
                fleet.lost(sysid)
                self._note(
                    sysid, "critical", f"No telemetry for {LOST_S:.0f} s: it is counted as lost until it is heard"
                )

    def die(self, sysid: int) -> None:
        """The process of a launched one has ended: it is lost at once, and for good."""
        if sysid in self.rules:
            self.lost.add(sysid)
            self._died.add(sysid)

    def _receive_events(self, sysid: int, frames: Iterable[Frame]) -> None:
        texts = self._own_events.receive(sysid, AUTOPILOT, frames, self._now_s)
        self._texts += [(sysid, *text) for text in texts]
        if lost := self._own_events.losses(sysid, self._now_s):
            self._note(sysid, "warning", lost)

    def _compare_uids(self, sysid: int, frames: Iterable[Frame]) -> None:
        """Notice two vehicles with one id behind one address."""
        uids = self._uids.get(sysid, {})
        for frame in frames:
            if frame.msgid == vehicle_uid.VERSION and (uid := vehicle_uid.uid_of(codec.fields(frame))):
                uids[uid] = None
        if len(uids) > 1 and sysid not in self.ambiguous:
            text = f"Two vehicles say that they are {sysid}, both at {self.rules[sysid].where}, with the uids "
            self.ambiguous[sysid] = text + f"{' and '.join(uids)}: it is not armed, for both would fly"
            self._note(sysid, "critical", self.ambiguous[sysid])

    def _watch_pace(self, sysid: int, offset_s: float) -> None:
        if self._speed == 1.0:
            return
        behind_s = offset_s - self._offset_s.setdefault(sysid, offset_s)
        if abs(behind_s) >= BEHIND_S:
            self._offset_s[sysid] = offset_s
            moved, way = ("fallen", "behind") if behind_s > 0.0 else ("run", "ahead of")
            text = f"Its clock has {moved} {abs(behind_s):.1f} s {way} the session's"
            self._note(sysid, "warning", f"{text}: it does not keep speed {self._speed:g}")

    def relinked(self, sysid: int) -> None:
        """A vehicle has another link: an autopilot sends there what it is asked for there."""
        if sysid in self.streams:
            self.streams[sysid].restart()

    def decide(
        self, snapshot: FleetSnapshot, released: Container[int] = ()
    ) -> tuple[list[CommandRequest], dict[int, list[Message]]]:
        """Commands, and messages by system id, that keep the streams flowing, and control. `released`: vehicles that
        the operator has left to another station."""
        now_s = snapshot.time_s
        commands: list[CommandRequest] = []
        messages: dict[int, list[Message]] = {}
        for sysid, streams in self.streams.items():
            view = snapshot.vehicle(sysid)
            if not view.alive:
                continue
            known = view.origin_offset_ned is not None
            asks, messages[sysid] = streams.poll(now_s, origin_known=known)
            messages[sysid] += self._estimators.requests(sysid, view.profile, now_s)
            times = self._uids_asked.get(sysid, UID_TIMES)
            if times < UID_TIMES and now_s >= UID_EVERY_S * times:
                self._uids_asked[sysid] = times + 1
                commands.append(CommandRequest(sysid, *vehicle_uid.ASKED, UID))
            requests, answers = self.control.decide(sysid, now_s, released=sysid in released)
            commands += requests
            messages[sysid] += answers
            messages[sysid] += self._own_events.poll(sysid, now_s)
            if self._own_events.due(sysid, now_s, armed=view.armed):
                commands.append(CommandRequest(sysid, *vehicle_events.ASKED, METADATA))
            self._asks[sysid] += asks
            if now_s - self._last_received_s[sysid] > SILENT_S:
                streams.count_anew(now_s)
            for sentence, well in streams.check(now_s).items():
                self._note(sysid, "info" if well else "warning", sentence)
            if not known and now_s >= NO_ORIGIN_S and sysid not in self._origin_noted:
                self._origin_noted.add(sysid)
                said = "Does not say where its frame lies (GPS_GLOBAL_ORIGIN, HOME_POSITION): it stays where it is"
                self._note(sysid, "warning", said)
            elif known and sysid in self._origin_noted:
                self._origin_noted.discard(sysid)
                self._note(sysid, "info", "Its frame is known now")
            offset = view.origin_offset_ned
            if offset is not None and elementary.norm(offset[:2]) > DISTANT_M and sysid not in self._distance_noted:
                self._distance_noted.add(sysid)
                away_km = elementary.norm(offset[:2]) / 1e3
                self._note(sysid, "warning", f"Its origin lies {away_km:.1f} km from the scenario's: is that meant?")
            if known and view.ground_down_m is not None and sysid not in self._ground_noted:
                self._ground_noted.add(sysid)
                if abs(view.ground_down_m) >= GROUND_OFF_M:
                    where = "below" if view.ground_down_m > 0.0 else "above"
                    said = (
                        f"Its ground lies {abs(view.ground_down_m):.1f} m {where} the height 0 of the scenario: "
                        "set points stay above both; correct origin.alt_m if that is not so"
                    )
                    self._note(sysid, "warning", said)
            if view.last_received_s >= 0.0:
                index = self._modes.due(sysid, view.profile, view.custom_mode, view.listed_modes, now_s)
                if index is not None:
                    commands.append(CommandRequest(sysid, *standard_modes.asked(index), MODES))
            for ask in self._asks[sysid]:
                commands.append(CommandRequest(sysid, ask.command.command, ask.command.params, ask.token))
            self._asks[sysid] = []
        return commands, messages

    def settles(self, sysid: int, result: CommandResult, now_s: float) -> bool:
        """Take in a command's result; whether it needs no report."""
        token = str(result.token)
        if sysid not in self.rules:
            return False
        if StreamRequests.owns(token):
            self._asks[sysid] += self.streams[sysid].answered(token, result.outcome == "accepted")
            return True
        if token in (MODES, CONTROL, UID, METADATA):
            return True
        if token == ENDING:
            self._answers[sysid] = _answer(result)
        return result.outcome != "accepted" and self.repeats(sysid, token, now_s)

    def repeats(self, sysid: int, text: str, now_s: float) -> bool:
        """Whether an external vehicle says at that time what it has said a moment before, or after."""
        if sysid not in self.rules:
            return False
        if len(self._said_s) >= MOST_SAID:
            self._said_s = {key: said_s for key, said_s in self._said_s.items() if now_s - said_s < SAY_AGAIN_S}
            if len(self._said_s) >= MOST_SAID:
                return True
        said_s = self._said_s.get((sysid, text))
        if said_s is not None and abs(now_s - said_s) < SAY_AGAIN_S:
            return True
        self._said_s[sysid, text] = now_s if said_s is None else max(now_s, said_s)
        return False

    def hand_back(self, snapshot: FleetSnapshot, stages: Mapping[int, Stage]) -> list[CommandRequest]:
        """Commands at the end to vehicles that we steer: they are not steered any more.

        One that another has taken over, or that is on the ground unarmed, is left alone; one that stands armed on
        the ground is disarmed.
        """
        commands = []
        for sysid, rules in self.rules.items():
            view = snapshot.vehicle(sysid)
            if not view.armed:
                continue
            silent_s = snapshot.time_s - self._last_received_s[sysid]
            silent = not view.alive or silent_s > SILENT_S
            if stages[sysid] not in STEERED:
                if not view.landed:
                    text = f"Left in the air in {view.mode_name}: this session does not control it"
                    self._note(sysid, "warning", text, "session")
                continue
            (command, params), order = view.ending(rules.at_end), _ENDS[rules.at_end]
            if view.landed and not silent:
                (command, params), order = _DISARM, "disarm"
            if silent:
                self._note(sysid, "critical", f"May still be flying: {_last_seen(view, silent_s)}", "session")
            else:
                text = f"Ordered to {order}: the session ends and no longer controls it"
                self._note(sysid, "info", text, "session")
            self._handed_back.add(sysid)
            commands.append(CommandRequest(sysid, command, params, ENDING))
        return commands

    def awaits(self, snapshot: FleetSnapshot) -> bool:
        """Whether one that was handed back still says that it follows set points."""
        return bool(self._steered_still(snapshot))

    def report_disobedience(self, snapshot: FleetSnapshot) -> None:
        """Name vehicles that have not obeyed in time at the end, and what they answered."""
        for view in self._steered_still(snapshot):
            answer = self._answers.get(view.sysid, "it has not answered yet")
            state = "on the ground and armed" if view.landed else f"in {view.mode_name}"
            text = f"Still {state} though it is no longer controlled ({answer}): look after it"
            self._note(view.sysid, "critical", text, "session")

    def _steered_still(self, snapshot: FleetSnapshot) -> list[VehicleView]:
        views = map(snapshot.vehicle, sorted(self._handed_back))
        return [view for view in views if view.alive and view.armed and (view.landed or view.mode in STEERABLE)]

    def missing_streams(self, sysid: int) -> list[str]:
        """Names of the messages that do not come as they should; none of a vehicle that is not external."""
        streams = self.streams.get(sysid)
        return [] if streams is None else list(streams.missing)

    def pop_events(self) -> list[Event]:
        """Events since the last call."""
        taken, self._events = self._events, []
        return taken

    def pop_records(self) -> list[dict[str, Any]]:
        """Boots since the last call, as decisions."""
        taken, self._records = self._records, []
        return taken

    def pop_texts(self) -> list[tuple[int, int, str, float]]:
        """(system id, MAV_SEVERITY, text, when it came) of vehicles' own events since the last call."""
        taken, self._texts = self._texts, []
        return taken

    def _note(self, sysid: int, level: Level, text: str, kind: Kind = "link") -> None:
        self._events.append(Event(self._now_s, sysid, level, text, kind))


def _last_seen(view: VehicleView, silent_s: float) -> str:
    """Words about a vehicle that is not received, for people."""
    height = "" if view.height_m is None else f", {view.height_m:.0f} m above its ground"
    return f"not heard for {silent_s:.0f} s, then in {view.mode_name}{height}; it may not hear commands now"


def _answer(result: CommandResult) -> str:
    """Answer to a command, for a person."""
    if result.outcome == "timeout":
        return f"it has not answered {result.attempts} commands"
    if result.outcome == "accepted":
        return "it answered that it would"
    return f"it answered: {result_in_words(result.result or 0)}"
