"""Bundles that are made for all vehicles at once, against the same bundles made one by one."""

import contextlib
import math
import random
import socket
from itertools import chain

import numpy as np
import pytest

from gcs.link.bundles import Recipients
from gcs.link.link import Key, TickGrants
from gcs.link.lockstep import LockstepLink
from gcs.mavlink import codec
from gcs.mavlink.codec import Message
from gcs.mavlink.ids import TRAFFIC
from gcs.mavlink.setpoints import PlacedSetPoints

COMMAND = codec.message(
    "COMMAND_LONG", target_system=1, target_component=1, command=400, confirmation=0,
    param1=1.0, param2=0.0, param3=0.0, param4=0.0, param5=0.0, param6=0.0, param7=0.0,
)  # fmt: skip
LONG = codec.message("STATUSTEXT", severity=6, text="x" * 50)


SPECIAL = (0.0, -0.0, 1e-46, -3e-39, 3.4028234e38, math.inf, -math.inf, 16777217.0)


def number(draw: random.Random) -> float:
    return draw.choice(SPECIAL) if draw.random() < 0.1 else draw.uniform(-50.0, 50.0)


class Field:
    """A link and its vehicles' sockets, `addresses` as numbers: what each receives is read by this test."""

    def __init__(self, addresses: dict[Key, tuple[int, int]]) -> None:
        self.link, self.numbers = LockstepLink(), dict.fromkeys(addresses, 2)
        places = {place for place, _ in addresses.values()}
        self.sockets = {place: socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for place in places}
        for one in self.sockets.values():
            one.connect(("127.0.0.1", self.link.port))
            one.setblocking(False)
        self.addresses = addresses
        self.link.expect(addresses)
        beat = codec.message("HEARTBEAT", type=2, autopilot=12, base_mode=0, custom_mode=0, system_status=3)
        for key, (place, shared) in addresses.items():
            stamp = codec.message("SYSTEM_TIME", time_unix_usec=self.link.secret, time_boot_ms=shared)
            self.sockets[place].send(codec.frame(beat, 0, *key) + codec.frame(stamp, 1, *key))
        self.link.listen(0.0)
        assert self.link.joined == set(addresses)

    def received(self) -> dict[int, list[bytes]]:
        """Datagrams that have come since the last call, by place."""
        found: dict[int, list[bytes]] = {place: [] for place in self.sockets}
        for place, one in self.sockets.items():
            with contextlib.suppress(BlockingIOError):
                while True:
                    found[place].append(one.recv(1 << 16))
        return found

    def answered(self, keys: list[Key], t_ms: int) -> None:
        end = codec.message("SYSTEM_TIME", time_unix_usec=0, time_boot_ms=t_ms)
        for key in keys:
            self.sockets[self.addresses[key][0]].send(codec.frame(end, self.numbers[key], *key))
            self.numbers[key] = (self.numbers[key] + 1) % 256
        assert {key for some, _ in self.link.answers(pytest.fail) for key in some} == set(keys)

    def close(self) -> None:
        self.link.close()
        for one in self.sockets.values():
            one.close()


@pytest.mark.parametrize("seed", range(2))
def test_datagrams_and_frames_are_those_made_one_by_one(seed: int) -> None:
    """Processes of several vehicles and of one, whose ids lie among each other's; some vehicles leave."""
    draw = random.Random(seed)
    keys = sorted((sysid, 1) for sysid in draw.sample(range(1, 255), 60))
    addresses = {key: (n // 25 if seed % 2 else draw.randrange(3), 1) for n, key in enumerate(keys)}
    addresses |= {key: (1000 + key[0], 0) for key in draw.sample(keys, 10)}
    addresses[TRAFFIC] = (2000, 0)
    at_once, single = Field(addresses), Field(addresses)
    for tick in range(270):  # past 255
        t_ms = 100 * tick
        there = sorted(at_once.link.joined)
        if tick % 50 == 49:
            gone = draw.choice(there)
            at_once.link.leave(gone)
            single.link.leave(gone)
            there.remove(gone)
        steered = [key[0] for key in there if key != TRAFFIC and draw.random() < (1.0 if tick % 3 else 0.9)]
        values = np.array([[number(draw) for _ in range(6)] for _ in steered]).reshape(-1, 6)
        points = PlacedSetPoints(max(t_ms - 100, 0), tuple(steered), values)
        more: dict[Key, tuple[list[Message], list[bytes], bytes]] = {}
        for key in there if tick % 4 == 0 else ():
            if draw.random() < 0.05:
                relayed = [codec.frame(LONG, 7, 3, 1)] * draw.choice([0, 0, 2])
                messages = [COMMAND] * draw.choice([0, 1, 3]) + [LONG] * draw.choice([0, 0, 40])
                more[key] = messages, relayed, codec.frame(LONG, 8, 4, 1) * draw.choice([0, 0, 20])
        heartbeat_due = {key[0] for key in there if key != TRAFFIC and (tick % 10 == 0 or draw.random() < 0.01)}
        grants = TickGrants(t_ms, 1_767_225_600_000_000 + 1000 * t_ms, there, heartbeat_due, points, more)
        one_by_one = [single.link.grant(key, t_ms, grants.unix_us, *grants.content(key)) for key in there]
        assert at_once.link.grant_all(grants) == list(chain.from_iterable(one_by_one))
        for field in (at_once, single):
            field.link.flush()
        assert at_once.received() == single.received()
        for field in (at_once, single):
            field.link.repeat()
        assert at_once.received() == single.received()
        for field in (at_once, single):
            field.answered(there, t_ms)
    at_once.close()
    single.close()


@pytest.mark.parametrize("value", [3.5e38, -1e39, 3.40282357e38])
def test_a_set_point_that_no_frame_can_hold_is_refused_as_the_codec_does(value: float) -> None:
    values = np.zeros((2, 6))
    values[1, 4] = value
    keys = [(7, 1), (8, 1)]
    recipients = Recipients(keys, [b"", b""], [("127.0.0.1", 1), ("127.0.0.1", 2)])
    with pytest.raises(ValueError, match=r"^SET_POSITION_TARGET_LOCAL_NED\.vy cannot be "):
        recipients.bundled((), TickGrants(0, 0, keys, (), PlacedSetPoints(0, (7, 8), values), {}))
