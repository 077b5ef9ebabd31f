"""The check list of every vehicle before it is armed: fence, rally points and return parameters set and read back,
clock compared.

1. What the scenario has no fence or rally points for is not touched on a vehicle.
2. A vehicle that takes no such plan (MAV_MISSION_UNSUPPORTED) passes: that is reported, and it flies without.
3. The clock is that of SYSTEM_TIME, of external vehicles only. One that has no time yet, or does not report it, passes.
   At another speed than 1 only the pace of its own time counts, by `time_boot_ms`, over PACE_OVER_S of the session: a
   simulator has to keep the session's, within PACE_OFF.
4. Whether an external vehicle keeps its fence by itself is read and said, not set (services/fence_switch.py).
5. Return parameters are set on vehicles whose autopilots are not ours, and put back at the end (return_setting.py).
6. A mission that does not read as it was written fails its vehicle whatever `preflight` says: it would fly elsewhere.
7. Until its list has ended a vehicle is not armed; one that fails is not armed at all, unless `preflight: warn`.
Origins are judged where frames are (`arming_external`): one that is too far away is left out.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from gcs.mavlink import codec
from gcs.mavlink.autopilots import SPEED_SETTINGS
from gcs.mavlink.boot_clock import CLOCKS
from gcs.mavlink.codec import Frame, Message
from gcs.mavlink.command_protocol import CommandLong, CommandTarget
from gcs.mavlink.ids import AUTOPILOT, STATION
from gcs.mavlink.parameters.value import ParameterValue
from gcs.mavlink.plans.client import MESSAGES as PLAN_MESSAGES
from gcs.mavlink.plans.client import PlanClient
from gcs.mavlink.plans.items import KINDS, PlanItem, wire_items
from gcs.missions.items import MissionPlan
from gcs.planner.failsafes import foreign_returns_of
from gcs.scenario.model import Scenario
from gcs.scenario.parts.mission import items_of, plan_of
from gcs.supervisor import return_setting
from gcs.supervisor.return_setting import ReturnSetting
from gcs.supervisor.services.fence_switch import FenceSwitch
from gcs.telemetry.events import Event, Level
from gcs.telemetry.state import FleetSnapshot, VehicleView
from skytender import geodesy
from skytender import mavlink as mav

CLOCK_OFF_S = 10.0
"""[choice] Logs and signatures of a vehicle whose clock is farther off belong to another time."""
PACE_OVER_S, PACE_WITHIN_S = 4.0, 30.0
PACE_OFF = 0.1
NO_TIME_BEFORE_S = 1_420_070_400.0
"""2015: a clock before that has not been set."""
ASK_EVERY_S, ASK_TIMES = 0.5, 2
_SYSTEM_TIME = codec.msgid("SYSTEM_TIME")
_PARAMETERS = frozenset(map(codec.msgid, return_setting.MESSAGES))
BEFORE_FILE, PLAN_BEFORE = "parameters-before.param", "plan-before-{}.plan"
"""Files in a session's folder, for `gcs params load` and `gcs mission set`: what vehicles had before the session wrote
it; the second for each system id."""
_WORDS = {
    "kept": "there already",
    "uploaded": "uploaded and read back",
    "unsupported": "not taken: it flies without",
    "refused": "refused",
    "differs": "not kept as it was written",
    "silent": "not answered",
}
_FAILS = frozenset({"refused", "differs", "silent"})
_FAILS_MISSION = _FAILS | {"unsupported"}


class CheckItem(NamedTuple):
    """An entry of a vehicle's check list."""

    key: str
    """fence, switch (of the fence), rally, mission, return, clock, or pace at another speed than 1"""
    passed: bool
    text: str


class _CheckList:
    """One vehicle's."""

    def __init__(
        self,
        sysid: int,
        clients: dict[str, PlanClient],
        homecoming: ReturnSetting | None,
        mission: MissionPlan,
        *,
        external: bool,
        paced: bool,
    ) -> None:
        self.clients = clients
        self.mission = mission
        """which is put into it once its autopilot's habits are known"""
        self.homecoming = homecoming
        self.fence_switch = FenceSwitch(sysid) if external and "fence" in clients else None
        self.items: dict[str, CheckItem] = {}
        self.asks_clock = ASK_TIMES if external and not paced else 0
        self.clock_open = external and not paced
        self.pace_open = external and paced
        self.pace_began: dict[int, tuple[float, float]] = {}
        """(session time, boot time) of its first message of each kind, s"""
        self.due_s = 0.0
        self.ended = False

    @property
    def complete(self) -> bool:
        """Whether nothing of it is open."""
        due = self.clients.keys() | ({"return"} if self.homecoming is not None else set())
        due |= {"mission"} if self.mission.mission else set()
        asked = self.fence_switch is not None and not self.fence_switch.done
        return self.items.keys() >= due and not (self.clock_open or self.pace_open or asked)


class Preflight:
    """The check lists of all vehicles of a session."""

    def __init__(self, scenario: Scenario, *, returns_set: bool = True, keeps_plans: bool = True) -> None:
        """`returns_set`: whether return parameters are written; else it is only said what they would be. `keeps_plans`:
        whether there is a folder for `plans_before`."""
        self._keeps_plans = keeps_plans
        self.enforced = scenario.preflight == "enforce"
        self._speed = scenario.clock.speed if scenario.clock.mode == "real" else 1.0
        self._stations = dict.fromkeys(scenario.vehicles.external, scenario.station.ids)
        plans = {"fence": fence_items(scenario), "rally": rally_items(scenario)}
        returns = foreign_returns_of(scenario)
        self._lists = {
            v.sysid: _CheckList(
                v.sysid,
                {
                    key: PlanClient(
                        v.sysid,
                        AUTOPILOT,
                        KINDS[key],
                        items,
                        station=self._stations.get(v.sysid, STATION),
                        keeps=keeps_plans and v.external is not None,
                    )
                    for key, items in plans.items()
                    if items
                },
                ReturnSetting(
                    v.sysid, returns[v.sysid], v.params, external=v.external is not None, dry_run=not returns_set
                )
                if v.sysid in returns
                else None,
                plan_of(v),
                external=v.external is not None,
                paced=self._speed != 1.0,
            )
            for v in scenario.vehicles.all
            if any(plans.values()) or v.external is not None or v.sysid in returns or items_of(v)
        }
        self._events: list[Event] = []
        self._back: tuple[int, ...] = ()
        """system ids of the vehicles that get back what they had"""
        self.under_way = tuple(self._lists)
        """system ids of the vehicles whose list has not ended"""

    def items(self, sysid: int) -> list[CheckItem]:
        """Entries of a vehicle's list so far."""
        return list(self._lists[sysid].items.values()) if sysid in self._lists else []

    def ended(self, sysid: int) -> bool:
        """Whether the vehicle may be armed as far as its list goes: it has ended, or there is none."""
        return sysid not in self._lists or self._lists[sysid].ended

    def failed(self, sysid: int) -> str:
        """Why a vehicle is not to be armed, as a sentence; empty where it may be."""
        failed = [item for item in self.items(sysid) if not item.passed]
        if not self.ended(sysid):
            return ""
        if wrong := [item.text for item in failed if item.key == "mission"]:
            return f"Does not begin, and is not armed: {wrong[0]}"
        wrong = [item.text for item in failed]
        if not wrong or not self.enforced:
            return ""
        return f"Fails its check list and is not armed: {'; '.join(wrong)} ('preflight: warn' arms it all the same)"

    def receive(self, delivered: Mapping[int, Iterable[Frame]], unix_us: int, now_s: float, said_s: float) -> None:
        """Take what vehicles have said; `unix_us` is the time by our clock, `said_s` that of the session by the wall
        clock, on which external vehicles live: ticks come later than it on a busy machine."""
        for sysid in (*self.under_way, *self._back):
            checks = self._lists[sysid]
            for frame in delivered.get(sysid, ()):
                if (frame.sysid, frame.compid) != (sysid, AUTOPILOT):
                    continue
                if frame.msgid in PLAN_MESSAGES:
                    content = codec.fields(frame)
                    for client in checks.clients.values():
                        client.receive(codec.name(frame.msgid), content, now_s)
                elif frame.msgid in _PARAMETERS:
                    asks: tuple[ReturnSetting | FenceSwitch | None, ...] = (checks.homecoming, checks.fence_switch)
                    for one in asks:
                        if one is not None:
                            one.receive(codec.name(frame.msgid), codec.fields(frame), now_s)
                elif frame.msgid == _SYSTEM_TIME and checks.clock_open:
                    self._clock(checks, codec.fields(frame).time_unix_usec, unix_us)
                elif frame.msgid in CLOCKS and checks.pace_open:
                    self._pace(checks, frame.msgid, codec.fields(frame).time_boot_ms / 1e3, said_s)

    def decide(self, snapshot: FleetSnapshot) -> dict[int, list[Message]]:
        """Messages by system id that advance the lists of vehicles that have been received."""
        now_s, out = snapshot.time_s, {}
        for sysid in self.under_way:
            view, checks = snapshot.vehicle(sysid), self._lists[sysid]
            if not view.alive or view.last_received_s < 0.0:
                continue
            messages = self._ask_clock(sysid, checks, now_s)
            if checks.mission.mission and "mission" not in checks.clients:
                checks.clients["mission"] = self._mission_client(view, checks.mission)
            if checks.pace_open and now_s >= PACE_WITHIN_S:
                checks.pace_open = False
                checks.items["pace"] = CheckItem(
                    "pace", False, "does not tell its own time, by which it would be followed"
                )
            under_way = next(((key, one) for key, one in checks.clients.items() if key not in checks.items), None)
            if under_way is not None:
                messages += self._plan(*under_way, checks, now_s)
            if checks.homecoming is not None and "return" not in checks.items:
                messages += checks.homecoming.poll(view, now_s)
                if (verdict := checks.homecoming.verdict) is not None:
                    checks.items["return"] = CheckItem("return", *verdict)
            if checks.fence_switch is not None and "fence" in checks.items:
                messages += self._switch(checks.fence_switch, view, checks, now_s)
            if messages:
                out[sysid] = messages
            if checks.complete:
                checks.ended = True
                self._report(sysid, checks, now_s)
        self.under_way = tuple(sysid for sysid in self.under_way if not self._lists[sysid].ended)
        return out

    def before(self) -> dict[int, dict[str, ParameterValue]]:
        """Values before the session, of parameters that it has written, by system id and name."""
        settings = {sysid: checks.homecoming for sysid, checks in self._lists.items()}
        return {sysid: one.before for sysid, one in settings.items() if one is not None and one.before}

    def plans_before(self) -> dict[int, dict[int, tuple[PlanItem, ...]]]:
        """Plans of external vehicles that the session has replaced, by system id and MAV_MISSION_TYPE."""
        replaced = {
            sysid: {client.kind: client.replaced for client in checks.clients.values() if client.replaced}
            for sysid, checks in self._lists.items()
        }
        return {sysid: plans for sysid, plans in replaced.items() if plans}

    def begin_putting_back(self, snapshot: FleetSnapshot) -> None:
        """At the end: vehicles get back what they had."""
        self.under_way = ()
        self._back = tuple(self.before())
        for sysid in self._back:
            setting = self._lists[sysid].homecoming
            assert setting is not None
            setting.put_back(snapshot.vehicle(sysid).profile)

    def put_back(self, sysid: int, now_s: float) -> list[Message]:
        """Messages that give a vehicle back what it had."""
        setting = self._lists[sysid].homecoming if sysid in self._back else None
        return [] if setting is None else setting.poll_back(now_s)

    @property
    def putting_back(self) -> bool:
        """Whether a vehicle has not got back yet what it had."""
        settings = (self._lists[sysid].homecoming for sysid in self._back)
        return any(setting is not None and setting.putting_back for setting in settings)

    def report_put_back(self, now_s: float) -> None:
        """Say which parameters have been put back, and which vehicles keep the session's."""
        for sysid in self._back:
            setting = self._lists[sysid].homecoming
            kept = [] if setting is None else setting.kept()
            text = f"Keeps {', '.join(kept)} of this session: {BEFORE_FILE} in its folder has what it had"
            level: Level = "warning" if kept else "info"
            self._events.append(
                Event(now_s, sysid, level, text if kept else "Has its own return parameters again", "session")
            )

    def pop_events(self) -> list[Event]:
        """Events since the last call."""
        taken, self._events = self._events, []
        return taken

    def _mission_client(self, view: VehicleView, mission: MissionPlan) -> PlanClient:
        kind, habits = KINDS["mission"], view.profile.plans
        items = wire_items(mission, kind, habits, view.profile.not_given)
        station = self._stations.get(view.sysid, STATION)
        keeps = self._keeps_plans and view.sysid in self._stations
        return PlanClient(view.sysid, AUTOPILOT, kind, items, habits, station=station, first=1, keeps=keeps)

    def _plan(self, key: str, client: PlanClient, checks: _CheckList, now_s: float) -> list[Message]:
        messages = client.poll(now_s)
        if client.outcome is not None:
            why = f" ({client.why})" if client.why and client.outcome != "unsupported" else ""
            name = "rally points" if key == "rally" else key
            text = f"{name} {_WORDS[client.outcome]}{why}"
            if client.replaced:
                text += f", the one before it is in {PLAN_BEFORE.format(client.sysid)}"
            if key == "mission" and client.outcome == "unsupported":
                text = f"mission not taken: {client.why}"
            fails = _FAILS_MISSION if key == "mission" else _FAILS
            checks.items[key] = CheckItem(key, client.outcome not in fails, text)
        return messages

    def _switch(self, switch: FenceSwitch, view: VehicleView, checks: _CheckList, now_s: float) -> list[Message]:
        """Ask a vehicle that has its fence whether it keeps it."""
        if checks.clients["fence"].outcome not in ("kept", "uploaded"):
            checks.fence_switch = None
            return []
        messages = switch.poll(view, now_s)
        if switch.note:
            checks.items["switch"] = CheckItem("switch", True, switch.note)
        return messages

    def _ask_clock(self, sysid: int, checks: _CheckList, now_s: float) -> list[Message]:
        if not checks.clock_open or now_s < checks.due_s:
            return []
        if not checks.asks_clock:
            checks.clock_open = False
            checks.items.setdefault("clock", CheckItem("clock", True, "clock not reported"))
            return []
        checks.asks_clock -= 1
        checks.due_s = now_s + ASK_EVERY_S
        target = CommandTarget(sysid, AUTOPILOT)
        return [CommandLong(target, mav.MAV_CMD_REQUEST_MESSAGE, (float(_SYSTEM_TIME),)).message(0)]

    def _clock(self, checks: _CheckList, theirs_us: int, ours_us: int) -> None:
        if theirs_us / 1e6 < NO_TIME_BEFORE_S:
            checks.items["clock"] = CheckItem("clock", True, "clock not set yet")
            return
        checks.clock_open = False
        off_s = (theirs_us - ours_us) / 1e6
        side = "ahead of" if off_s > 0.0 else "behind"
        passed = abs(off_s) <= CLOCK_OFF_S
        text = "clock right" if passed else f"clock {abs(off_s):.0f} s {side} ours"
        checks.items["clock"] = CheckItem("clock", passed, text)

    def _pace(self, checks: _CheckList, msgid: int, boot_s: float, said_s: float) -> None:
        """Compare how fast its own time runs with the session's."""
        began_s, booted_s = checks.pace_began.setdefault(msgid, (said_s, boot_s))
        if boot_s < booted_s:  # it has booted
            checks.pace_began[msgid] = said_s, boot_s
        elif said_s - began_s >= PACE_OVER_S:
            checks.pace_open = False
            share = (boot_s - booted_s) / (said_s - began_s)
            runs = f"runs {share * self._speed:.1f} times as fast as real time"
            kept = abs(share - 1.0) <= PACE_OFF
            advice = (
                f", the session {self._speed:g} times: set its simulator's speed ({SPEED_SETTINGS}), or leave out speed"
            )
            checks.items["pace"] = CheckItem("pace", kept, runs + ("" if kept else advice))

    def _report(self, sysid: int, checks: _CheckList, now_s: float) -> None:
        texts = "; ".join(item.text for item in checks.items.values())
        passed = all(item.passed for item in checks.items.values())
        self._events.append(Event(now_s, sysid, "info" if passed else "warning", f"Check list: {texts}", "session"))


def fence_items(scenario: Scenario) -> list[PlanItem]:
    """The scenario's fence as items: corners and circles, in degrees by WGS 84."""
    polygons = (mav.MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION, mav.MAV_CMD_NAV_FENCE_POLYGON_VERTEX_EXCLUSION)
    circles = (mav.MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION, mav.MAV_CMD_NAV_FENCE_CIRCLE_EXCLUSION)
    items = []
    frame = int(mav.MAV_FRAME_GLOBAL)
    for side, areas in enumerate((scenario.fence.inside, scenario.fence.outside)):
        for area in areas:
            command = int(circles[side] if area.circle_m is not None else polygons[side])
            places = (area.circle_m,) if area.circle_m is not None else area.polygon_m or ()
            size = float(len(places)) if area.radius_m is None else area.radius_m
            items += [PlanItem(command, frame, size, *_degrees_e7(scenario, place), 0.0) for place in places]
    return items


def rally_items(scenario: Scenario) -> list[PlanItem]:
    """The scenario's rally points as items, at the height of a take-off above home, in whole metres, rounded up: an
    ArduPilot keeps no more."""
    command, frame = int(mav.MAV_CMD_NAV_RALLY_POINT), int(mav.MAV_FRAME_GLOBAL_RELATIVE_ALT)
    height_m = float(math.ceil(max((v.takeoff_m for v in scenario.vehicles.all), default=0.0)))
    return [PlanItem(command, frame, 0.0, *_degrees_e7(scenario, place), height_m) for place in scenario.rally_m]


def _degrees_e7(scenario: Scenario, place: tuple[float, float]) -> tuple[int, int]:
    o = scenario.origin
    lat_deg, lon_deg, _ = geodesy.place_of((*place, 0.0), (o.lat_deg, o.lon_deg, o.alt_m))
    return round(1e7 * lat_deg), round(1e7 * lon_deg)
