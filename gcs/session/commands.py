"""Commands of the session's clients, and their answers."""

from __future__ import annotations

from gcs.processes.pace import Pace
from gcs.scenario.document import did_you_mean
from gcs.session.server import ClientRequest, Publisher
from gcs.supervisor.operator import COMMANDS, OperatorReply
from gcs.supervisor.supervisor import Supervisor

CLOCK = ("pause", "resume", "stop")
KNOWN = (*CLOCK, "inspect", *COMMANDS)
REPLAY = ("speed", "seek")


class Clients:
    """Serves the clients of one session."""

    def __init__(self, publisher: Publisher, supervisor: Supervisor, pace: Pace) -> None:
        self._publisher = publisher
        self._supervisor = supervisor
        self._pace = pace
        self._inspects: dict[int, int] = {}

    def serve(self) -> bool:
        """Carry out commands since the last call; True where one stops the session."""
        stop = False
        for request in self._publisher.poll():
            answer = self._obey(request)
            self._publisher.reply(request, answer.taken, answer.text)
            stop = stop or request.content["command"] == "stop"
        if self._inspects:
            clients = self._publisher.clients
            self._inspects = {client: sysid for client, sysid in self._inspects.items() if client in clients}
        wanted = frozenset(self._inspects.values())
        if wanted != self._supervisor.inspection.wanted:
            self._supervisor.inspection.want(wanted)
        return stop

    def _obey(self, request: ClientRequest) -> OperatorReply:
        command = request.content["command"]
        if command in COMMANDS:
            return self._supervisor.obey(request.content)
        if command in CLOCK:
            return self._command_clock(command)
        if command == "inspect":
            return self._inspect(request)
        if command in REPLAY:
            return OperatorReply(False, f"The command {command} is for a replay: this session is being flown.")
        hint = did_you_mean(command[:32], KNOWN) or f"; there are {', '.join(KNOWN)}."
        return OperatorReply(False, f"There is no command '{command[:32]}'{hint}")

    def _command_clock(self, command: str) -> OperatorReply:
        if command == "pause" and self._supervisor.scenario.vehicles.external:
            answer = OperatorReply(False, "The session cannot pause: external vehicles live on the real clock.")
            self._supervisor.note(command, answer)
            return answer
        if command == "pause":
            self._pace.pause()
        elif command == "resume":
            self._pace.resume()
        does = {"pause": "stands still until it is resumed", "resume": "goes on", "stop": "stops"}
        answer = OperatorReply(True, f"The session {does[command]}.")
        self._supervisor.note(command, answer)
        return answer

    def _inspect(self, request: ClientRequest) -> OperatorReply:
        sysid = request.content.get("sysid")
        if sysid is None:
            self._inspects.pop(request.client, None)
            return OperatorReply(True, "No vehicle is inspected for this client.")
        if isinstance(sysid, bool) or not isinstance(sysid, int) or sysid not in self._supervisor.arming:
            return OperatorReply(False, f"There is no vehicle {str(sysid)[:32]} in this session.")
        self._inspects[request.client] = sysid
        return OperatorReply(True, f"Snapshots tell everything that vehicle {sysid} sends.")
