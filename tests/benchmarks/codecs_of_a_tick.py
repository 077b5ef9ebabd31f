"""Figure 1: frames as sessions, replays and reports read them, set points as sessions write them, and what signing
adds to both, against pymavlink on the same bytes in the same rounds."""

from __future__ import annotations

import itertools
import random
import secrets
import socket
import tempfile
from pathlib import Path

import numpy as np
from measure import Figure, Prepared, cpu_times
from pymavlink.dialects.v20 import common

from gcs.link.bundles import Bundles, Recipients
from gcs.link.keys import LinkSigning
from gcs.link.link import Key, TickGrants
from gcs.link.lockstep import LockstepLink
from gcs.mavlink import codec
from gcs.mavlink.datagram import runs_of
from gcs.mavlink.ids import AUTOPILOT, STATION
from gcs.mavlink.sequence import TickCollector
from gcs.mavlink.setpoints import SetPoints
from gcs.recording import tlog_reader
from gcs.recording.recorder import TLOG, Recorder
from gcs.recording.session_folder import Gathering, Recorded
from gcs.scenario.file import find, load
from gcs.supervisor.factory import make_fleet
from gcs.supervisor.grants import OwnFrames
from gcs.supervisor.supervisor import Supervisor
from gcs.telemetry.columns import FleetColumns
from skytender.key_files import read_key

VEHICLES = 254
TICKS, PERIOD_MS = 32, 100
MOST_SIGNING_US = 3.0
PORT = 20_000


def hot_frames() -> list[bytes]:
    """One tick of a full fleet: the six hot messages of each vehicle."""
    rng = random.Random(1)
    frames = []
    for sysid in range(1, VEHICLES + 1):
        mav = common.MAVLink(None, srcSystem=sysid, srcComponent=1)
        n, e, d, *rest = [rng.uniform(-50.0, 50.0) for _ in range(6)]
        for message in (
            common.MAVLink_heartbeat_message(2, 12, 217, 6 << 16, 4, 3),
            common.MAVLink_attitude_message(61_200, 0.1 * n, 0.01 * e, 0.01 * d, *rest),
            common.MAVLink_local_position_ned_message(61_200, n, e, d, *rest),
            common.MAVLink_global_position_int_message(61_200, 473977420, 85455940, 500_000, 12_000, 12, -3, 5, 9000),
            common.MAVLink_battery_status_message(
                0, 0, 1, 32767, [4000] * 4 + [65535] * 6, 1310, 100, 50 + sysid, 80, 100, 1
            ),
            common.MAVLink_named_value_float_message(61_200, b"CtlEffort", abs(n)),
        ):
            frames.append(bytes(message.pack(mav)))
            mav.seq = (mav.seq + 1) % 256
    return frames


class Flown:
    """A supervisor of the shipped fleet and its link, sent the datagrams of one tick after the other: what they do with
    them from the socket on, up to the snapshot."""

    def __init__(self, ticks: list[list[bytes]]) -> None:
        self._link = LockstepLink()
        self._ticks = ticks
        self._tick = 0
        self._keys: list[Key] = [(sysid, 1) for sysid in range(1, VEHICLES + 1)]
        self._sockets = [socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in self._keys]
        self._link.expect(self._keys)
        for key, one in zip(self._keys, self._sockets, strict=True):
            one.connect(("127.0.0.1", self._link.port))
            hello = [codec.frame(codec.message("HEARTBEAT", type=2, autopilot=12, base_mode=0, custom_mode=0,
                     system_status=3), 0, *key), codec.encode("SYSTEM_TIME", 1, *key,
                     time_unix_usec=self._link.secret, time_boot_ms=0)]  # fmt: skip
            one.send(b"".join(hello))
        self._link.listen(0.0)
        scenario = load(find("fleet"))
        assert {(v.sysid, 1) for v in scenario.vehicles.all} == set(self._keys)
        self.supervisor = Supervisor(scenario, self._link, Recorder(Path(tempfile.mkdtemp())))

    def send(self) -> None:
        """The vehicles' answers to the next tick; after the last the first again, its numbers new."""
        link, at = self._link, self._tick % TICKS
        self._tick += 1
        if at == 0:
            for key in self._keys:
                link._peers[key].collector = TickCollector(*key)
            link._enrolled = False
        for key, one, datagram in zip(self._keys, self._sockets, self._ticks[at], strict=True):
            link._peers[key].collector.begin(PERIOD_MS * (at + 1))
            one.send(datagram)
        link._awaited.update(self._keys)

    def receive(self) -> None:
        """Take them in."""
        arrived = self.supervisor._receive(self._link.answers(lambda: None), 0.1 * self._tick).frames
        assert len(arrived) == 7 * VEHICLES
        self.supervisor.fleet.snapshot(0.1 * self._tick)


def answers() -> list[list[bytes]]:
    """Ticks of the full fleet: each vehicle's answer of the six hot messages and SYSTEM_TIME, one datagram."""
    hot = [codec.split(frame).frames[0] for frame in hot_frames()]
    said = [(frame.msgid, codec.fields(frame)) for frame in hot]
    ticks = []
    for tick in range(TICKS):
        now = {"time_boot_ms": PERIOD_MS * (tick + 1)}
        messages = [
            codec.Message(msgid, tuple(fields._replace(**now) if now.keys() <= set(fields._fields) else fields))
            for msgid, fields in said
        ]
        end = codec.Message(codec.msgid("SYSTEM_TIME"), (0, now["time_boot_ms"]))
        first = 2 + 7 * tick
        ticks.append(
            [
                b"".join(
                    codec.frame(message, (first + k) % 256, sysid, 1)
                    for k, message in enumerate([*messages[6 * (sysid - 1) : 6 * sysid], end])
                )
                for sysid in range(1, VEHICLES + 1)
            ]
        )
    return ticks


def recorded(folder: Path, ticks: list[list[bytes]]) -> None:
    """The same as a session's recording."""
    with Recorder(folder) as recorder:
        for tick, datagrams in enumerate(ticks):
            frames = [frame.raw for datagram in datagrams for frame in codec.split(datagram).frames]
            recorder.frames(1_767_225_600_000_000 + 100_000 * tick, frames)


def reading() -> list[Figure]:
    """Frames in."""
    ticks = answers()
    count = 7 * VEHICLES
    flown, peer = Flown(ticks), common.MAVLink(None)
    peer.robust_parsing = False
    folder = Path(tempfile.mkdtemp())
    recorded(folder, ticks)
    fleet, as_flown = make_fleet(load(find("fleet"))), make_fleet(load(find("fleet")))
    flown_s = itertools.count()

    def read() -> None:
        now_s = 100.0 + 0.1 * next(flown_s)
        for datagram in ticks[0]:
            for run in runs_of(datagram) or ():
                as_flown.ingest_all(run, now_s)

    def decode() -> None:
        for datagram in ticks[0]:
            for frame in codec.split(datagram).frames:
                codec.fields(frame)

    def replay() -> None:
        for t_us, frame in tlog_reader.read(folder / TLOG):
            fleet.ingest(frame, 1e-6 * t_us)

    def report() -> None:
        gathering = Gathering(Recorded(folder))
        for chunk in tlog_reader.read(folder / TLOG).chunks():
            gathering.add(chunk)
        gathering.finish()

    read()
    for view, datagram in zip(as_flown.snapshot(100.0).vehicles, ticks[0], strict=True):
        told = {message.get_type(): message for message in peer.parse_buffer(datagram)}
        attitude, motion = told["ATTITUDE"], told["LOCAL_POSITION_NED"]
        assert (view.roll_rad, view.pitch_rad) == (attitude.roll, attitude.pitch)
        assert (view.p_local_ned, view.v_ned) == ((motion.x, motion.y, motion.z), (motion.vx, motion.vy, motion.vz))
        assert (view.custom_mode, view.armed) == (told["HEARTBEAT"].custom_mode, True)
        assert view.energy_source == "energy_consumed"
        assert view.control_effort == told["NAMED_VALUE_FLOAT"].value

    tick_s, read_s, decode_s, replay_s, report_s, peer_s = cpu_times(
        Prepared(flown.send, flown.receive), read, decode, replay, report,
        lambda: [peer.parse_buffer(datagram) for datagram in ticks[0]],
    )  # fmt: skip
    unit, other, theirs = "messages/CPU s", "pymavlink parse_buffer", count / peer_s
    return [
        Figure(1, "live: socket → link → fleet → snapshot", count / tick_s, unit, 9.0, False, True, other, theirs),
        Figure(1, "  of it datagram → fleet, decode as flown", count / read_s, unit, 9.0, False, True, other, theirs),
        Figure(1, "split and decode of any message", count / decode_s, unit, 4.0, False, True, other, theirs),
        Figure(1, "replay: tlog → fleet", TICKS * count / replay_s, unit, 1.3, False, True, other, theirs),
        Figure(1, "report: tlog → tables", TICKS * count / report_s, unit, 15.0, False, True, other, theirs),
        Figure(1, "a tick of 254 vehicles heard, at 10 Hz", 100.0 * tick_s / (1e-3 * PERIOD_MS), "% of a core"),
    ]


def signing() -> list[Figure]:
    """What a key adds to each frame out and in."""
    key_file = Path(tempfile.mkdtemp()) / "key"
    key_file.write_text(secrets.token_hex(32), encoding="ascii")
    key_file.chmod(0o600)
    sender, receiver = LinkSigning(key_file), LinkSigning(key_file)
    plain = hot_frames()
    signed = [codec.split(sender.sign(raw)).frames[0] for raw in plain]
    peer = common.MAVLink(None, srcSystem=255, srcComponent=190)
    peer.signing.secret_key = read_key(key_file)

    def judge() -> None:
        receiver._signing.streams.clear()
        assert all(receiver.judge(frame) == "good" for frame in signed)

    def their_judgement() -> None:
        peer.signing.stream_timestamps.clear()
        assert all(peer.check_signature(bytearray(f.raw), f.sysid, f.compid) for f in signed)

    times = cpu_times(lambda: [sender.sign(raw) for raw in plain], judge, their_judgement)
    sign_us, judge_us, theirs_us = (1e6 * one_s / len(plain) for one_s in times)
    unit, most, peer_name = "µs/frame", MOST_SIGNING_US, "pymavlink check_signature"
    return [
        Figure(1, "sign", sign_us, unit, most, at_most=True),
        Figure(1, "judge a signature", judge_us, unit, most, True, False, peer_name, theirs_us),
    ]


def sending() -> Figure:
    """Frames out: set points of a full fleet, from the planner's to the bundles in which they leave, as sessions make
    them in every tick."""
    rng = random.Random(2)
    keys = [(sysid, AUTOPILOT) for sysid in range(1, VEHICLES + 1)]
    places = [[rng.uniform(-50.0, 50.0) for _ in range(6)] for _ in keys]
    points = SetPoints(tuple(sysid for sysid, _ in keys), np.array(places))
    offsets = [(rng.uniform(-9.0, 9.0), 0.0, 0.0, 0.0) for _ in keys]
    none, rows = np.empty(0), {sysid: row for row, (sysid, _) in enumerate(keys)}
    columns = FleetColumns(points.sysids, rows, 0, none, none, none, none, np.array(offsets))
    own, recipients = OwnFrames(), Recipients(keys, [b""] * VEHICLES, [("127.0.0.1", PORT + key[0]) for key in keys])
    sender = common.MAVLink(None, srcSystem=STATION[0], srcComponent=STATION[1])
    message = common.MAVLink_set_position_target_local_ned_message

    def encode() -> Bundles:
        placed = own.placed(points, columns, 61_200)
        return recipients.bundled((), TickGrants(61_300, 0, keys, (), placed, {}))

    def fields(sysid: int) -> tuple[float, ...]:
        (n, e, d), (north, *_) = points[sysid - 1].p_ned, offsets[sysid - 1]
        return 61_200, sysid, 1, 1, 3520, n - north, e, d, *points[sysid - 1].v_ned, 0.0, 0.0, 0.0, 0.0, 0.0

    theirs = [fields(sysid) for sysid, _ in keys]
    raw, _, spans = encode()
    assert [raw[a:b] for a, b in spans[::2]] == [bytes(message(*values).pack(sender)) for values in theirs]
    encode_s, peer_s = cpu_times(encode, lambda: [message(*values).pack(sender) for values in theirs])
    return Figure(
        1, "encode set points, in bundles", VEHICLES / encode_s, "messages/CPU s", 6.0, False, True, "pymavlink pack",
        VEHICLES / peer_s,
    )  # fmt: skip


def figures() -> list[Figure]:
    """All of them."""
    return [*reading(), sending(), *signing()]
