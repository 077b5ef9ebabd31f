"""Files that a session left in its folder, read once: each file by itself, so that one that is missing or broken costs
only what it alone holds. `Recorded.problems` says what that is."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pydantic import ValidationError

from gcs.mavlink import codec
from gcs.mavlink.gaps import RecordedGaps
from gcs.mavlink.ids import STATION
from gcs.recording import rotation, tlog_reader, tlog_walk
from gcs.recording import summary as summaries
from gcs.recording.decision_types import COMPETITION, holds_what_is_read
from gcs.recording.decisions_reader import COLUMNS, DecisionLines
from gcs.recording.missing import CHANGES_ONLY
from gcs.recording.recorder import DECISIONS, TLOG
from gcs.recording.summary import Summary
from gcs.scenario.file import load
from gcs.scenario.model import Scenario, ScenarioError
from gcs.scenario.parts.world import Worlds
from skytender.frames import CHECKSUM_BYTES, HEADER_BYTES, MAGIC

SCENARIO = "scenario.yaml"
WANTED = {
    "LOCAL_POSITION_NED": ("time_boot_ms", "x", "y", "z", "vx", "vy", "vz"),
    "ATTITUDE": ("time_boot_ms", "roll", "pitch", "yaw"),
    "HEARTBEAT": ("place", "type", "autopilot", "custom_mode", "base_mode"),
    "EXTENDED_SYS_STATE": ("landed_state",),
    "GPS_GLOBAL_ORIGIN": ("latitude", "longitude", "altitude"),
    "BATTERY_STATUS": (
        *("place", "id", "battery_function", "energy_consumed", "battery_remaining", "current_battery", "voltages"),
        "voltages_ext",
    ),
    "SYS_STATUS": ("place", "voltage_battery", "current_battery", "battery_remaining"),
    "NAMED_VALUE_INT": ("place", "name", "value"),
    "PARAM_VALUE": ("place", "param_id", "param_value", "param_type"),
    "STATUSTEXT": ("severity", "text", "id", "chunk_seq"),
    "ADSB_VEHICLE": ("ICAO_address", "lat", "lon", "altitude", "heading", "hor_velocity", "ver_velocity", "callsign"),
}
"""The messages that a report is made from, and the fields that it needs of them; `place`: where in the file."""
FOREIGN = {"GLOBAL_POSITION_INT": ("time_boot_ms", "lat", "lon", "alt", "relative_alt", "vx", "vy", "vz")}
"""The same of a recording that is no session's: others know their place by these alone."""
PLACES = [codec.msgid(name) for name in ("LOCAL_POSITION_NED", "GLOBAL_POSITION_INT")]
REPEATED = [codec.msgid(name) for name in ("ATTITUDE", "POSITION_TARGET_LOCAL_NED", "FOLLOW_TARGET")]
"""Messages that say of their sender's health only that they came; one stands for all."""
HEALTH_EVERY_US = 500_000
"""Of each kind that is not kept whole one frame is kept in each time so long."""
_SYSTEM_TIME = codec.msgid("SYSTEM_TIME")
_KIND = np.zeros(256, np.uint8)
_KIND[[*PLACES, _SYSTEM_TIME]] = range(1, 2 + len(PLACES))
_KIND[REPEATED] = 2 + len(PLACES)
"""By message id: a number of each kind of which not every frame is kept; 0 of others."""
_HEADER_1_BYTES, _SIGNATURE_BYTES = 6, 13
MOST_SECONDS = 7 * 86_400
MOST_BINS = 1 << 14
"""Of each vehicle's traffic, ten times what a chart shows: four hours and a half by seconds, longer in longer bins."""
FEWEST_SECONDS, SECONDS_A_FRAME = 3600, 2
"""A recording's rates and losses are counted for so long, and so much longer by each frame in it."""
Progress = Callable[[float], object]


class ServiceLines(NamedTuple):
    """The decisions that begin and end one refuelling; None for one that the files do not hold."""

    decided: dict[str, Any] | None
    served: dict[str, Any] | None


class NoSession(Exception):
    """The folder is no session's; the message is a sentence that names it."""


@dataclass
class Recorded:
    """A session as its files hold it, or one recording; None or empty for what they do not."""

    folder: Path
    """of the session; the recording's file where there is no more"""
    summary: Summary | None = None
    scenario: Scenario | None = None
    tables: dict[str, NDArray[Any]] = field(default_factory=dict)
    """by message: t_s of the session, sysid, compid and the fields of WANTED, in the order of arrival"""
    decisions: list[dict[str, Any]] = field(default_factory=list)
    """every decision but the set points"""
    set_points: NDArray[np.float64] = field(default_factory=lambda: np.empty((0, COLUMNS)))
    """(n, COLUMNS) in the order of decision; none where only their changes are recorded"""
    traffic_count: dict[int, NDArray[np.int32]] = field(default_factory=dict)
    """by system id: (bins,) frames received in each bin of time, as far as there were any"""
    traffic_lost: dict[int, NDArray[np.int32]] = field(default_factory=dict)
    """the same of gaps in their sequence numbers"""
    traffic_exempt: dict[int, NDArray[np.int32]] = field(default_factory=dict)
    """the same of SYSTEM_TIME among the frames received, which a simulated radio does not lose"""
    traffic_bin_s: int = 1
    """length of those bins: doubled as often as it takes for MOST_BINS to hold all"""
    health_frames: list[tlog_walk.Chunk] = field(default_factory=list)
    """vehicles' frames by which their health and their changes are seen, in µs of the session"""
    begin_s: float = 0.0
    """when the recording begins whose first parts were not kept; 0 of one that is whole"""
    end_s: float = 0.0
    problems: list[str] = field(default_factory=list)

    @cached_property
    def worlds(self) -> Worlds | None:
        """Obstacles, attractors and targets' paths, as they changed in flight; None without a scenario."""
        return None if self.scenario is None else Worlds.recorded(self.scenario, self.decisions)

    @cached_property
    def services(self) -> list[ServiceLines]:
        """The refuellings by their lines: ended ones in the order of their ends, then those under way. A line that
        ends one is of the last that was decided between the same two; vehicles that compete on board decide before the
        session knows it, so that times do not tell."""
        ended: list[ServiceLines] = []
        under_way: list[dict[str, Any]] = []
        for d in self.decisions:
            if d["kind"] == "decided":
                under_way.append(d)
            elif d["kind"] == "served":
                decided = next((one for one in reversed(under_way) if _sides(one) == _sides(d)), None)
                if decided is not None:
                    under_way.remove(decided)
                ended.append(ServiceLines(decided, d))
        return [*ended, *(ServiceLines(one, None) for one in under_way)]


def _sides(line: dict[str, Any]) -> tuple[int, int | None, str | None]:
    return line["receiver"], line["tanker"], line.get("base")


def read(folder: Path, progress: Progress = lambda _: None) -> Recorded:
    """Content of the folder. Raises NoSession where that is no session at all."""
    if not folder.is_dir():
        raise NoSession(f"{folder} is no folder; give the folder of a session, such as gcs run leaves it.")
    if not any(rotation.exists(folder / name) for name in (TLOG, DECISIONS, summaries.FILE)):
        raise NoSession(f"{folder} is no session's folder: it holds none of {TLOG}, {DECISIONS} and {summaries.FILE}.")
    recorded = Recorded(folder)
    _read_summary(recorded)
    _read_scenario(recorded)
    told, log = 0.0, _read_tlog(recorded)
    for share in _read_decisions(recorded):  # by turns: while decisions are read, the recording is walked
        while told < share:
            told = next(log, 1.0)
        progress(0.5 * (share + told))
    for told in log:
        progress(0.5 * (1.0 + told))
    _note_beginning(recorded)
    if not recorded.end_s and recorded.summary is not None:
        recorded.end_s = recorded.summary.sim_time_s
    return recorded


def _note_beginning(recorded: Recorded) -> None:
    gone = [name for name in (TLOG, DECISIONS) if not rotation.begins(recorded.folder / name)]
    if gone:
        begin = f"{' and '.join(gone)} begin{'s' if len(gone) == 1 else ''} at {recorded.begin_s:.1f} s"
        told = "; energies, refuellings, least distances and greatest errors are the whole session's, by summary.json"
        recorded.problems.append(
            f"{begin}, for the parts before were not kept: figures over time, and each vehicle's lowest battery, top "
            f"speed, longest silence and lost frames, are of the time since{told if recorded.summary else ''}."
        )


def read_recording(source: Path, name: Path, progress: Progress = lambda _: None) -> Recorded:
    """Content of one recording, reported under another name. Raises NoSession where it holds no frame, OSError."""
    recorded = Recorded(name)
    log = tlog_reader.read(source)
    gathering = Gathering(recorded, (*WANTED, *FOREIGN))
    for chunk in log.chunks():
        gathering.add(chunk)
        progress(chunk.read_share)
    gathering.finish()
    if not recorded.traffic_count:
        raise NoSession(" ".join(log.problems) or f"{name} holds no vehicle's frame.")
    recorded.problems += log.problems
    return recorded


def _read_summary(recorded: Recorded) -> None:
    path = recorded.folder / summaries.FILE
    lost = "the outcome, the digest and the link's counts are not known"
    try:
        recorded.summary = Summary.model_validate_json(path.read_bytes())
    except FileNotFoundError:
        recorded.problems.append(f"{path.name} is missing, as after a session that was killed: {lost}.")
    except OSError as error:
        recorded.problems.append(f"{path.name} cannot be read ({error.strerror}): {lost}.")
    except ValidationError as error:
        first = error.errors()[0]
        where = ".".join(map(str, first["loc"])) or "the whole"
        recorded.problems.append(f"{path.name} is not as it should be ({where}: {first['msg']}): {lost}.")


def _read_scenario(recorded: Recorded) -> None:
    path = recorded.folder / SCENARIO
    lost = "goal, obstacles, roles and capacities are not known"
    try:
        recorded.scenario = load(path)
    except ScenarioError as error:
        why = "is missing" if not path.exists() else f"cannot be read ({str(error).splitlines()[0]})"
        recorded.problems.append(f"{path.name} {why}: {lost}.")


def _read_decisions(recorded: Recorded) -> Iterator[float]:
    """Take in the folder's decisions; the share that has been read, again and again; problems are noted."""
    shares: list[float] = []
    lines = DecisionLines(recorded.folder / DECISIONS, shares.append)
    points: list[NDArray[np.float64]] = []
    foreign = 0
    changes_only = recorded.scenario is not None and recorded.scenario.record.decisions == "changes"
    try:
        for some, others in lines.blocks(set_points=not changes_only):
            points.append(some)
            for line in others:
                record = line.record()
                if not record or not holds_what_is_read(line.kind, line.raw):
                    foreign += 1
                    continue
                if line.kind == "competition":  # one a tick, with numbers of every vehicle
                    record = {key: record[key] for key in COMPETITION if key in record}
                recorded.decisions.append({**record, "t_s": line.t_s})
            yield from shares[-1:]
    except OSError as error:
        why = "is missing" if isinstance(error, FileNotFoundError) else f"cannot be read ({error.strerror})"
        recorded.problems.append(f"{DECISIONS} {why}: plan, tracking error and competition cannot be shown.")
    else:
        recorded.problems += [CHANGES_ONLY] * changes_only
    if broken := foreign + lines.passed_over:
        lines_are = "1 line that is" if broken == 1 else f"{broken} lines that are"
        recorded.problems.append(f"{DECISIONS} has {lines_are} no decision, cut short or foreign; passed over.")
    if points:
        recorded.set_points = np.concatenate(points)


def _read_tlog(recorded: Recorded) -> Iterator[float]:
    """The same of the folder's recording."""
    gathering = Gathering(recorded)
    path = recorded.folder / TLOG
    try:
        log = tlog_reader.read(path, session=True)
        for chunk in log.chunks():
            gathering.add(chunk)
            yield chunk.read_share
        recorded.problems += log.problems
    except OSError as error:
        why = "is missing" if isinstance(error, FileNotFoundError) else f"cannot be read ({error.strerror})"
        recorded.problems.append(f"{TLOG} {why}: paths, speeds, batteries, distances and link cannot be shown.")
    gathering.finish()
    if not rotation.begins(path):
        recorded.begin_s = gathering.begin_s


class Gathering:
    """Fills what was recorded out of the stretches of a recording, in their order: the tables of the messages `wanted`,
    the end, and the link's counts where these are `counted`. `finish` sets the tables."""

    def __init__(self, recorded: Recorded, wanted: Iterable[str] = tuple(WANTED), *, counted: bool = True) -> None:
        scenario = recorded.scenario
        self._recorded = recorded
        self._epoch_us = round(1e6 * scenario.clock.epoch.timestamp()) if scenario else None
        self._station = scenario.station.sysid if scenario else STATION[0]
        self._pieces: dict[str, list[NDArray[Any]]] = {name: [] for name in wanted}
        self._counted = counted
        self._gaps = RecordedGaps()
        self._frames = 0
        self._begun = False
        self.begin_s = 0.0
        """time of the first frame"""

    def add(self, chunk: tlog_walk.Chunk) -> None:
        """Take in the next stretch."""
        heads = chunk.heads
        if not len(heads):
            return
        epoch_us = self._epoch_us = int(heads[0, tlog_walk.T_US]) if self._epoch_us is None else self._epoch_us
        if not self._begun:
            self._begun, self.begin_s = True, 1e-6 * (int(heads[0, tlog_walk.T_US]) - epoch_us)
        for name, pieces in self._pieces.items():
            pieces.append(_columns(chunk, name, epoch_us))
        self._recorded.end_s = max(self._recorded.end_s, 1e-6 * (int(heads[-1, tlog_walk.T_US]) - epoch_us))
        if self._counted:
            self._count(heads, epoch_us)
            senders = heads[:, tlog_walk.SYSID]
            self._recorded.health_frames.append(
                health_frames(chunk, heads[(senders < STATION[0]) & (senders != self._station)], epoch_us)
            )

    def finish(self) -> None:
        """Set the tables; they are whole once the last stretch has been taken in."""
        tables = self._recorded.tables
        while self._pieces:
            name, pieces = self._pieces.popitem()
            if pieces:
                tables[name] = np.concatenate(pieces)

    def _count(self, heads: NDArray[np.int64], epoch_us: int) -> None:
        """Count frames and gaps bin by bin; a frame that comes again, as relayed ones do, is neither. One that
        comes late makes good its gap in the bin in which it comes."""
        recorded = self._recorded
        second = (heads[:, tlog_walk.T_US] - epoch_us) // 1_000_000
        # Foreign times, years away, must not make a table of years: so few frames do not fill so many seconds.
        self._frames += len(heads)
        most = min(MOST_SECONDS, FEWEST_SECONDS + SECONDS_A_FRAME * self._frames)
        sender = heads[:, tlog_walk.SYSID]
        mine = (sender < STATION[0]) & (sender != self._station) & (second >= 0) & (second < most)
        second, heads = second[mine], heads[mine]
        while len(second) and int(second.max()) // recorded.traffic_bin_s >= MOST_BINS:
            recorded.traffic_bin_s *= 2
            for table in (recorded.traffic_count, recorded.traffic_lost, recorded.traffic_exempt):
                table.update(
                    {
                        sysid: np.add.reduceat(known, range(0, len(known), 2), dtype=np.int32)
                        for sysid, known in table.items()
                    }
                )
        bins = second // recorded.traffic_bin_s
        sysids = heads[:, tlog_walk.SYSID]
        lost, new = self._gaps.count(sysids, heads[:, tlog_walk.COMPID], heads[:, tlog_walk.SEQ])
        begin, end = (int(bins.min()), int(bins.max()) + 1) if len(bins) else (0, 0)
        shape = STATION[0], end - begin
        cells = sysids * shape[1] + (bins - begin)
        exempt = new & (heads[:, tlog_walk.MSGID] == _SYSTEM_TIME)
        frames, *tables = (
            np.bincount(cells, weights, minlength=shape[0] * shape[1]).astype(np.int32).reshape(shape)
            for weights in (None, new, lost, exempt)
        )
        for sysid in np.flatnonzero(frames.any(axis=1)).tolist():
            last = int(np.flatnonzero(frames[sysid])[-1]) + 1
            known = recorded.traffic_count, recorded.traffic_lost, recorded.traffic_exempt
            for table, values in zip(known, tables, strict=True):
                table[sysid] = _added(table.get(sysid), begin, values[sysid, :last])


def health_frames(chunk: tlog_walk.Chunk, heads: NDArray[np.int64], epoch_us: int) -> tlog_walk.Chunk:
    """The frames with these heads (n, 6) by which vehicles' health and changes are seen, alone, in µs since the epoch.

    Of frames that only repeat themselves one in each HEALTH_EVERY_US is kept, and both ends of each longer silence.
    """
    t_us, msgids = heads[:, tlog_walk.T_US], heads[:, tlog_walk.MSGID]
    # By 16 bits and by 8 the order is found in a fifth of the time.
    senders = (heads[:, tlog_walk.SYSID] << 8 | heads[:, tlog_walk.COMPID]).astype(np.uint16)
    kinds = np.where(msgids < len(_KIND), _KIND[np.minimum(msgids, len(_KIND) - 1)], 0)
    thinned = kinds > 0
    kept = ~thinned
    some = np.flatnonzero(thinned)
    some = some[np.argsort(kinds[some], kind="stable")]
    some = some[np.argsort(senders[some], kind="stable")]
    ends = (np.diff(senders[some]) != 0) | (np.diff(kinds[some]) != 0)
    ends |= np.diff(t_us[some] // HEALTH_EVERY_US) != 0
    kept[some[np.append(ends, True)[: len(some)]]] = True
    # SYSTEM_TIME answers a grant also where the radio is out, and ends no silence.
    said = np.flatnonzero(msgids != _SYSTEM_TIME)
    said = said[np.argsort(senders[said], kind="stable")]
    apart = np.flatnonzero((np.diff(senders[said]) != 0) | (np.diff(t_us[said]) > HEALTH_EVERY_US))
    kept[said[apart]] = kept[said[apart + 1]] = True
    kept[said[[0, -1]] if len(said) else said] = True
    return _alone(chunk, heads[kept], epoch_us)


def _alone(chunk: tlog_walk.Chunk, heads: NDArray[np.int64], epoch_us: int) -> tlog_walk.Chunk:
    """The frames with these heads, which are changed, without those between them."""
    octets, at = chunk.octets, heads[:, tlog_walk.AT]
    newer = octets[at] == MAGIC
    sizes = octets[at + 1].astype(np.int64) + CHECKSUM_BYTES + np.where(newer, HEADER_BYTES, _HEADER_1_BYTES)
    sizes += np.where(newer & (octets[at + 2] & 1 > 0), _SIGNATURE_BYTES, 0)
    edges = np.stack([at, at + sizes], axis=1).ravel()
    runs = np.diff(edges, prepend=0, append=len(octets))
    kept = np.repeat(np.arange(len(runs)) % 2 == 1, runs)
    heads[:, tlog_walk.T_US] -= epoch_us
    heads[:, tlog_walk.AT] = np.cumsum(sizes) - sizes
    return tlog_walk.Chunk(octets[kept], heads, 1.0, 0)


def rows_of(keys: NDArray[Any]) -> dict[int, NDArray[np.int64]]:
    """For each key, ascending, the rows where it stands, in their order."""
    order = np.argsort(keys, kind="stable")
    ordered = keys[order]
    parts = np.split(order, np.flatnonzero(ordered[1:] != ordered[:-1]) + 1)
    return {int(keys[rows[0]]): rows for rows in parts if len(rows)}


def _added(table: NDArray[np.int32] | None, begin: int, values: NDArray[np.int32]) -> NDArray[np.int32]:
    """The table (n,), made longer where need be, with these values added from this bin on."""
    end = begin + len(values)
    if table is None or end > len(table):
        longer = np.zeros(end, dtype=np.int32)
        longer[: 0 if table is None else len(table)] = () if table is None else table
        table = longer
    table[begin:end] += values
    return table


def _columns(chunk: tlog_walk.Chunk, message: str, epoch_us: int) -> NDArray[Any]:
    """One message's times in session seconds, senders and wanted fields alone."""
    table = chunk.table(message)
    wanted = WANTED.get(message) or FOREIGN[message]
    names = ("sysid", "compid", *(name for name in wanted if name != "place"))
    own: list[Any] = [("t_s", np.float64)] + [("place", np.int64)] * ("place" in wanted)
    columns = np.empty(len(table), dtype=[*own, *((name, table.dtype[name]) for name in names)])
    columns["t_s"] = 1e-6 * (table["t_us"] - epoch_us)
    if "place" in wanted:
        columns["place"] = chunk.places(message)
    for name in names:
        columns[name] = table[name]
    return columns
