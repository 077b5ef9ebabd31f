"""Questions about component metadata and events: whether the files that the vehicle names are there, and as the
standard has them; whether events that it defines are numbered, and sent again."""

from __future__ import annotations

from collections.abc import Sequence

from gcs.cli.check.asking import MAVSDK, QGC, command_long, to_vehicle
from gcs.cli.check.dialogue import CheckedVehicle, Question, ReceivedMessage, Verdict
from gcs.cli.check.predicates import OK, answered
from gcs.mavlink.codec import Message
from gcs.mavlink.metadata.client import EVENTS, MetadataClient, MetadataRefused
from gcs.mavlink.metadata.event_words import EventDefinitions
from skytender import mavlink as mav

WITHIN_S, SEQUENCE_WITHIN_S = 60.0, 4.0


class _Reading:
    """The dialogue about metadata with the vehicle that is asked."""

    def __init__(self) -> None:
        self._vehicle: CheckedVehicle | None = None
        self._client = MetadataClient(0, 0)
        self._taken = 0

    @property
    def defines_events(self) -> bool:
        """Whether the metadata holds definitions of events."""
        return EVENTS in self._client.files

    def begin(self, vehicle: CheckedVehicle) -> Sequence[Message]:
        """The first request."""
        self._vehicle, self._client, self._taken = vehicle, MetadataClient(vehicle.sysid, vehicle.compid), 0
        return self.go_on(vehicle)

    def go_on(self, vehicle: CheckedVehicle) -> Sequence[Message]:
        """Messages to send now; the time is that of the last message that came."""
        if vehicle is not self._vehicle:
            return []
        return self._client.poll(max(one.at_s for one in vehicle.latest.values()))

    def judge(self, _: CheckedVehicle, received: Sequence[ReceivedMessage]) -> Verdict | None:
        """Take in what has come."""
        for one in received[self._taken :]:
            self._client.receive(one.name, one.fields, one.at_s)
        self._taken = len(received)
        if not self._client.done:
            return None
        try:
            self._client.parameters()
            if self.defines_events:
                EventDefinitions(self._client.files[EVENTS])
        except MetadataRefused as error:
            return Verdict("wrong", str(error))
        return Verdict("wrong", self._client.problem) if self._client.problem else OK

    def at_end(self, *_: object) -> Verdict:
        """The time is up."""
        return Verdict("missing", self._client.problem or f"not read in {WITHIN_S:g} s")


def metadata() -> list[Question]:
    """Whether the files are there, and as the standard has them; and events."""
    reading = _Reading()
    files = Question(
        "metadata-files",
        "files of its metadata (MAVFTP), whole and as the standard has them",
        {QGC: "shows its parameters without units and meanings", MAVSDK: "component_metadata.get_metadata() has none"},
        reading.judge,
        reading.begin,
        reading.at_end,
        when=lambda vehicle: "" if vehicle.of("COMPONENT_METADATA") else "it names none",
        streams=reading.go_on,
        repeat_s=WITHIN_S,
        tries=1,
    )
    sequence = Question(
        "event-sequence",
        "the number of its last event (CURRENT_EVENT_SEQUENCE)",
        {QGC: "does not notice that it missed one", MAVSDK: "events.subscribe_events() misses lost events"},
        answered("CURRENT_EVENT_SEQUENCE"),
        command_long(mav.MAV_CMD_REQUEST_MESSAGE, mav.MAVLINK_MSG_ID_CURRENT_EVENT_SEQUENCE),
        when=lambda _: "" if reading.defines_events else "it defines no events",
        repeat_s=SEQUENCE_WITHIN_S,
    )
    again = Question(
        "event-again",
        "an event sent again, or that it is kept no longer (REQUEST_EVENT)",
        {QGC: "does not show an event that was lost", MAVSDK: "waits for it, and shows no later one"},
        lambda vehicle, received: (
            answered("EVENT")(vehicle, received) or answered("RESPONSE_EVENT_ERROR")(vehicle, received)
        ),
        _request_last,
        when=lambda vehicle: "" if vehicle.of("CURRENT_EVENT_SEQUENCE") else "it numbers none",
    )
    return [files, sequence, again]


def _request_last(vehicle: CheckedVehicle) -> Sequence[Message]:
    last = vehicle.of("CURRENT_EVENT_SEQUENCE").sequence
    return to_vehicle("REQUEST_EVENT", first_sequence=last, last_sequence=last)(vehicle)
