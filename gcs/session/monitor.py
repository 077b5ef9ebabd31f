"""Any fleet on the air as a console's source: one address, an observer, the wall clock; nothing to configure.

A monitor is passive: not a byte leaves it. With `control` it is a ground station: a HEARTBEAT each second to
known senders, a request for streams to vehicles that send none, and hold, return and land for one vehicle, in its own
autopilot's way.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, cast

from gcs.link.keys import RefusalNotices
from gcs.link.listener import Listener
from gcs.link.socket import Where
from gcs.mavlink import codec
from gcs.mavlink.autopilots import End
from gcs.mavlink.codec import Frame, Message
from gcs.mavlink.command_protocol import CommandLong, CommandQueue, CommandTarget, Step
from gcs.mavlink.ids import OUR_HEARTBEAT, STATION
from gcs.mavlink.sequence import sequence_numbers
from gcs.mavlink.services import standard_modes, vehicle_events, vehicle_uid
from gcs.mavlink.stream_requests import SilentVehicles, everything
from gcs.scenario.endpoint import Endpoint
from gcs.session.messages import reply_message
from gcs.session.observer import Observer
from gcs.session.order_table import MONITOR_ORDERS
from gcs.telemetry.events import Event, Level

SNAPSHOT_EVERY_S = 0.1
HEARTBEAT_EVERY_S = 1.0
COMMAND_TIMEOUT_S = 1.0
MOST_REFUSED = 64
"""Most duplicate-id warnings: addresses that claim the id of a vehicle at another address."""
SILENT_AFTER_S = 0.5
"""A connection has so long to be made before it is said that it is not."""
GONE_S = 5.0
"""A vehicle may come from another address once the one that it had has been silent for so long."""
ORDERS: Mapping[str, End] = {order.command: cast(End, order.command) for order in MONITOR_ORDERS}
_COMMAND_ACK = codec.msgid("COMMAND_ACK")


class MonitorSource:
    """A console's source that listens at an address. Raises AddressRefused, KeyRefused where it cannot."""

    def __init__(
        self,
        at: Endpoint,
        *,
        control: bool = False,
        key_file: Path | None = None,
        station: tuple[int, int] = STATION,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        """`station`: our ids in what `control` says."""
        self._station = station
        self._listener = Listener(at, key_file, older=True)
        self._refusals = RefusalNotices()
        self._clock = clock
        self._begun_s = clock()
        self._observer = Observer("monitor", at.text)
        self._observer.control = control
        self._control = control
        self._peers: dict[tuple[int, int], tuple[Where, float]] = {}
        """where components of vehicles speak from, and when they did last"""
        self._refused: set[tuple[int, Where]] = set()
        self._uids: dict[tuple[int, Where], str] = {}
        self._queues: dict[int, CommandQueue] = {}
        self._silent_vehicles = SilentVehicles()
        self._modes = standard_modes.ModeRequests()
        self._vehicle_events = vehicle_events.VehicleEvents()
        self._reported_silent: set[int] = set()
        self._numbers = sequence_numbers()
        self._replies: list[Mapping[str, Any]] = []
        self._shown_s = self._beat_s = self._modes_s = -math.inf
        self._at = at
        self._problem = self._silence = ""
        if at.way == "udpout" and not control:
            text = f"Nothing is sent to {at.text}: a vehicle that only answers will not be heard; --control speaks"
            self._observer.add_event(Event(0.0, 0, "warning", text, "link"))

    @property
    def port(self) -> int:
        """The port that it is at."""
        return self._listener.connection.port

    def fileno(self) -> int:
        """For select: readable when something has come."""
        return self._listener.connection.fileno()

    @property
    def connected(self) -> bool:
        """Whether it listens."""
        return self._listener.open

    def receive(self) -> list[Mapping[str, Any]]:
        """Listen; the messages since the last call."""
        t_s = self._clock() - self._begun_s
        for frames, peer in self._listener.receive():
            for frame in frames:
                self._receive(frame, peer, t_s)
        self._report_silent(t_s)
        self._report_connection(t_s)
        gate = self._listener.gate
        for sysid, text in self._refusals.poll(gate.refused, gate.reasons, t_s):
            self._observer.add_event(Event(t_s, sysid, "warning", text, "link"))
        if self._control:
            self._speak(t_s)
        messages, self._replies = self._replies, []
        if self._observer.changed:
            messages.append(self._observer.session())
        if t_s - self._shown_s >= SNAPSHOT_EVERY_S:
            self._shown_s = t_s
            self._observer.look(t_s)
            messages.append(self._observer.snapshot(t_s, speed=1.0, phase="monitoring"))
        return messages

    def send(self, command: Mapping[str, Any]) -> None:
        """Take `inspect`, and with control `hold`, `return` and `land`."""
        ok, text = self._obey(command)
        self._replies.append(reply_message(command.get("id"), ok, text))

    def close(self) -> None:
        """Listen no longer."""
        self._listener.close()

    # in

    def _receive(self, frame: Frame, peer: Where, t_s: float) -> None:
        observer, sender = self._observer, (frame.sysid, frame.compid)
        if frame.msgid == vehicle_uid.VERSION and len(self._uids) < MOST_REFUSED:
            self._uids[frame.sysid, peer] = vehicle_uid.uid_of(codec.fields(frame))
        known = self._peers.get(sender)
        if known is not None and known[0] != peer and t_s - known[1] < GONE_S:
            # A camera or a companion has a port of its own, or two: only a second autopilot is another vehicle.
            if sender == self._autopilot(frame.sysid) and (frame.sysid, peer) not in self._refused:
                self._refuse(frame.sysid, peer, t_s)
            return
        observer.receive(frame, t_s)
        if frame.sysid not in observer.sysids:
            observer.receive_sent(frame)
            return
        self._peers[sender] = (peer, t_s)
        if sender != self._autopilot(frame.sysid):
            return
        self._silent_vehicles.received(frame.sysid, frame.msgid, t_s)
        if frame.msgid == _COMMAND_ACK and (queue := self._queues.get(frame.sysid)) is not None:
            self._follow_up(frame.sysid, queue.on_ack(frame.sysid, frame.compid, codec.fields(frame), t_s), t_s)
        if self._control:
            for severity, text, came_s in self._vehicle_events.receive(*sender, (frame,), t_s):
                observer.add_text(frame.sysid, severity, text, t_s, came_s)

    def _autopilot(self, sysid: int) -> tuple[int, int]:
        return sysid, self._observer.component(sysid)

    def _refuse(self, sysid: int, peer: Where, t_s: float) -> None:
        if len(self._refused) < MOST_REFUSED:
            self._refused.add((sysid, peer))
            places = [peer, self._peers[self._autopilot(sysid)][0]]
            uids = [self._uids.get((sysid, place), "") for place in places]
            text = vehicle_uid.twins(sysid, *[f"{place[0]}:{place[1]}" for place in places], *uids)
            self._observer.add_event(Event(t_s, sysid, "warning", text, "link"))

    def _report_silent(self, t_s: float) -> None:
        for sysid in self._silent_vehicles.due(t_s):
            if t_s - self._peers[self._autopilot(sysid)][1] >= GONE_S:
                continue
            if self._control:
                self._transmit(sysid, [everything(*self._autopilot(sysid))])
            if sysid not in self._reported_silent:
                self._reported_silent.add(sysid)
                done = "they are requested now" if self._control else "they are not requested; --control requests them"
                text = f"Does not tell its position, attitude and state: {done}"
                self._observer.add_event(Event(t_s, sysid, "warning", text, "link"))

    def _report_connection(self, t_s: float) -> None:
        """Report a connection that is broken or mended, or why no vehicle is received, once that can be seen."""
        problem = self._listener.connection.problem
        if problem != self._problem and t_s >= SILENT_AFTER_S:
            self._problem = problem
            level: Level = "warning" if problem else "info"
            text = f"{self._at.text}: {problem}" if problem else f"{self._at.text} is there"
            self._observer.add_event(Event(t_s, 0, level, text, "link"))
        silence = "" if problem or self._peers or t_s < GONE_S else self._listener.silence
        if silence != self._silence:
            self._silence = silence
            if silence:
                self._observer.add_event(Event(t_s, 0, "warning", f"{self._at.text}: {silence}", "link"))

    # out, with control only

    def _obey(self, command: Mapping[str, Any]) -> tuple[bool, str]:
        word, sysid = command.get("command"), command.get("sysid")
        known = isinstance(sysid, int) and not isinstance(sysid, bool) and sysid in self._observer.sysids
        if word == "inspect":
            if sysid is not None and not known:
                return False, f"No vehicle {sysid} has been heard."
            self._observer.inspection.want(() if sysid is None else (cast(int, sysid),))
            return True, "" if sysid is None else f"Snapshots tell everything that vehicle {sysid} sends."
        if not isinstance(word, str) or word not in ORDERS:
            return False, f"A monitor knows hold, return, land and inspect, not {word}."
        if not self._control:
            return False, "This monitor only watches; start it with --control to give orders."
        if not known:
            return False, f"No vehicle {sysid} has been heard."
        return self._order(cast(int, sysid), ORDERS[word])

    def _order(self, sysid: int, end: End) -> tuple[bool, str]:
        t_s = self._clock() - self._begun_s
        view = self._observer.view(t_s).vehicle(sysid)
        if not view.armed:
            return True, f"{view.label} is not armed, and stays where it is."
        number, params = view.ending(end)
        queue = self._queues.setdefault(sysid, CommandQueue(*self._station))
        order = CommandLong(CommandTarget(*self._autopilot(sysid)), number, params)
        self._transmit(sysid, queue.send(order, t_s, COMMAND_TIMEOUT_S, token=end))
        self._observer.add_event(Event(t_s, sysid, "info", f"Operator: {end}", "operator"))
        return True, f"{view.label} is ordered to {end}; its answer is shown."

    def _speak(self, t_s: float) -> None:
        if t_s - self._beat_s >= HEARTBEAT_EVERY_S:
            self._beat_s = t_s
            raw = codec.frame(OUR_HEARTBEAT, next(self._numbers), *self._station)
            to = self._listener.connection.to
            peers = {to} if to is not None else {peer for peer, _ in self._peers.values()}
            for peer in sorted(peers, key=str):
                self._listener.send(raw, peer)
        if t_s - self._modes_s >= standard_modes.EACH_WITHIN_S:
            self._modes_s = t_s
            self._ask_for_modes(t_s)
            self._ask_for_metadata(t_s)
        for sysid, queue in self._queues.items():
            self._follow_up(sysid, queue.poll(t_s), t_s)
        for sysid in self._observer.sysids:
            if messages := self._vehicle_events.poll(sysid, t_s):
                self._transmit(sysid, messages)

    def _ask_for_modes(self, t_s: float) -> None:
        for view in self._observer.view(t_s).vehicles:
            if view.last_received_s < 0.0 or self._autopilot(view.sysid) not in self._peers:
                continue
            index = self._modes.due(view.sysid, view.profile, view.custom_mode, view.listed_modes, t_s)
            if index is not None:
                target = CommandTarget(*self._autopilot(view.sysid))
                self._transmit(view.sysid, [CommandLong(target, *standard_modes.asked(index)).message(0)])

    def _ask_for_metadata(self, t_s: float) -> None:
        """Ask each vehicle for the texts of its events. Report lost events."""
        for view in self._observer.view(t_s).vehicles:
            sysid, component = self._autopilot(view.sysid)
            if (sysid, component) in self._peers and self._vehicle_events.due(sysid, t_s, armed=view.armed):
                number, params = vehicle_events.ASKED
                self._transmit(sysid, [CommandLong(CommandTarget(sysid, component), number, params).message(0)])
            if text := self._vehicle_events.losses(sysid, t_s):
                self._observer.add_event(Event(t_s, sysid, "warning", text, "link"))

    def _follow_up(self, sysid: int, step: Step, t_s: float) -> None:
        self._transmit(sysid, step.messages)
        for result in step.results:
            if result.outcome == "timeout":
                what = str(result.token).capitalize()
                text = f"{what} was not acknowledged, though it was sent {result.attempts} times"
                self._observer.add_event(Event(t_s, sysid, "warning", text, "ack"))

    def _transmit(self, sysid: int, messages: list[Message]) -> None:
        peer = self._peers[self._autopilot(sysid)][0]
        for message in messages:
            self._listener.send(codec.frame(message, next(self._numbers), *self._station), peer)
