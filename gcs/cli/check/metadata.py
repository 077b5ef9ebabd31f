"""Questions about component metadata: whether the files that the vehicle names are there, and as the standard has
them."""

from __future__ import annotations

from collections.abc import Sequence

from gcs.cli.check.asking import MAVSDK, QGC
from gcs.cli.check.dialogue import CheckedVehicle, Question, ReceivedMessage, Verdict
from gcs.cli.check.predicates import OK
from gcs.mavlink.codec import Message
from gcs.mavlink.metadata.client import MetadataClient, MetadataRefused

WITHIN_S = 60.0


class _Reading:
    """The dialogue about metadata with the vehicle that is asked."""

    def __init__(self) -> None:
        self._vehicle: CheckedVehicle | None = None
        self._client = MetadataClient(0, 0)
        self._taken = 0

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
        except MetadataRefused as error:
            return Verdict("wrong", str(error))
        return Verdict("wrong", self._client.problem) if self._client.problem else OK

    def at_end(self, *_: object) -> Verdict:
        """The time is up."""
        return Verdict("missing", self._client.problem or f"not read in {WITHIN_S:g} s")


def metadata() -> Question:
    """Whether the files are there, and as the standard has them."""
    reading = _Reading()
    return Question(
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
