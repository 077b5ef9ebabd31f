"""A recorded session, or any .tlog, as tables: one per message type, per kind of decision, and of the vehicles' truth.

Each table of a message begins with time_s (since the session's start), sysid, compid and direction (`from` a vehicle,
`to` one), then the message's fields as `gcs.mavlink.field_units` names and converts them; a parameter's value is its
number by the vehicle's encoding. What goes through memory at
once is a stretch of the log, whatever its length.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Collection, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcs.mavlink import field_units
from gcs.mavlink.ids import STATION
from gcs.mavlink.parameters import recorded
from gcs.recording import rotation, tlog_reader
from gcs.recording.decisions_reader import DecisionLines
from gcs.recording.frame_heads import sent_frames
from gcs.recording.missing import CHANGES_ONLY, SCENARIO, passed_over, unread
from gcs.recording.recorder import DECISIONS, TLOG
from gcs.recording.tables import Column, Tables
from gcs.recording.tlog_walk import AT, COMPID, MSGID, SYSID, T_US, Chunk, IntArray
from gcs.recording.truth import record_places
from gcs.scenario.file import load
from gcs.scenario.model import Scenario, ScenarioError
from gcs.telemetry.voltage_watch import VoltageWatches
from skytender import mavlink as mav

Progress = Callable[[float], None]
LINES_AT_ONCE = 1 << 16
NAMED = 5
NAME_LETTERS = 100
TRUTH_BYTES = 1 << 22
MOST_PENDING = 1 << 25
"""No record of a vehicle's truth is longer than so many bytes."""
_RELAYED = np.array([mav.MAVLINK_MSG_ID_FOLLOW_TARGET, mav.MAVLINK_MSG_ID_NAMED_VALUE_INT])
_AXES = ("n", "e", "d")
_TRUTH_NAMES = {
    **{axis: f"{axis}_ned_m" for axis in _AXES},
    **{f"v{axis}": f"v{axis}_ned_m_s" for axis in _AXES},
    **{angle: f"{angle}_rad" for angle in ("roll", "pitch", "yaw")},
    **{f"{angle}_rate": f"{angle}_rate_rad_s" for angle in ("roll", "pitch", "yaw")},
}


class ExportError(Exception):
    """Nothing can be exported; one sentence."""


def export(source: Path, tables: Tables, progress: Progress = lambda _: None) -> list[str]:
    """Write every table of a session's folder or of one .tlog; what could not be read, a sentence each.

    `progress` is given the share that is done. Raises ExportError where there is nothing to export, OSError.
    """
    if source.is_dir():
        return _export_session(source, tables, progress)
    if not source.exists():
        raise ExportError(f"{source} does not exist; give a session's folder or a .tlog file.")
    log = tlog_reader.read(source)
    noticed = _export_frames(log, tables, None, progress)
    if not tables.rows:
        raise ExportError(" ".join(log.problems) or f"{source} holds no MAVLink frame.")
    return log.problems + noticed


def _export_session(folder: Path, tables: Tables, progress: Progress) -> list[str]:
    frames, decisions, truths = folder / TLOG, folder / DECISIONS, sorted(folder.glob("vehicles/*.truth"))
    present = [path for path in (frames, decisions, *truths) if rotation.exists(path)]
    if not present:
        raise ExportError(f"{folder} is no session's folder: it has neither {TLOG} nor {DECISIONS}.")
    problems: list[str] = []
    whole = max(sum(map(rotation.size, present)), 1)
    done = 0

    def part(path: Path) -> Progress:
        begun, size = done, rotation.size(path)
        return lambda share: progress((begun + share * size) / whole)

    for path in (frames, decisions):
        if path not in present:
            problems.append(f"{folder} has no {path.name}: what it held is left out.")
    if frames in present:
        epoch_us = None
        try:
            scenario = load(folder / SCENARIO)
            epoch_us = round(1e6 * scenario.clock.epoch.timestamp())
            problems += _without_truth(folder, scenario, {path.stem for path in truths})
            problems += [CHANGES_ONLY] * (decisions in present and scenario.record.decisions == "changes")
        except (OSError, ScenarioError) as error:
            problems.append(unread(folder / SCENARIO, error, "time_s counts from the first frame."))
        log = tlog_reader.read(frames, session=True)
        noticed = _export_frames(log, tables, epoch_us, part(frames), session=True)
        problems += log.problems + noticed
        done += rotation.size(frames)
    if decisions in present:
        problems += _export_decisions(decisions, tables, part(decisions))
        done += rotation.size(decisions)
    for truth in truths:
        problems += _export_truth(truth, tables, part(truth))
        done += truth.stat().st_size
    return problems


def _without_truth(folder: Path, scenario: Scenario, found: Collection[str]) -> list[str]:
    """A sentence on the vehicles that should have left their truth and did not."""
    wanted = [str(vehicle.sysid) for vehicle in scenario.vehicles.launched] if scenario.truth else []
    missing = [sysid for sysid in wanted if sysid not in found]
    if not missing:
        return []
    which = f"{', '.join(missing[:NAMED])}{f' and {len(missing) - NAMED} more' if len(missing) > NAMED else ''}"
    return [f"{folder / 'vehicles'} has no truth of vehicle {which}: what they knew themselves is left out."]


# frames


def _export_frames(
    log: tlog_reader.Tlog, tables: Tables, epoch_us: int | None, progress: Progress, *, session: bool = False
) -> list[str]:
    """Sentences on what the frames say that is not as it should be."""
    noticed: list[str] = []
    voltages = VoltageWatches()
    stations = np.zeros(1 << 16, dtype=np.bool_)
    if session:
        stations[_sender(*STATION)] = True
    answered_us = np.full(1 << 16, -1, dtype=np.int64)
    encodings = recorded.Encodings()
    for chunk in log.chunks():
        heads = chunk.heads
        if epoch_us is None and len(heads):
            epoch_us = int(heads[0, T_US])
        _learn_stations(chunk, stations)
        encodings.learn(chunk.table("HEARTBEAT"), chunk.table("AUTOPILOT_VERSION"))
        sent = sent_frames(heads, stations, answered_us if session else answered_us[:0], _RELAYED)
        for msgid in np.unique(heads[:, MSGID]).tolist():
            if (shape := field_units.layout(msgid)) is None:
                _unknown(chunk, msgid, tables, epoch_us or 0, sent)
                continue
            mine = heads[:, MSGID] == msgid
            rows = chunk.table(msgid)
            columns, names = _own_columns(heads[mine], sent[mine], epoch_us or 0), rows.dtype.names or ()
            for column in shape.columns:
                renamed = f"{column.field}_"  # as the table has a field that is named like a column of its own
                columns[column.name] = column.values(rows[renamed if renamed in names else column.field])
            if shape.name in recorded.CARRIERS:
                columns[recorded.FIELD] = encodings.numbers(shape.name, rows)
            tables.append(shape.name, columns)
        told = [
            (rows, (rows["t_us"] - (epoch_us or 0)) / 1e6)
            for rows in (chunk.table("SYS_STATUS"), chunk.table("BATTERY_STATUS"))
        ]
        for sysid, t_s, note in voltages.take(*told[0], *told[1]):
            noticed.append(f"Vehicle {sysid} at {t_s:.1f} s: {note}.")
        progress(chunk.read_share)
    return noticed


def _own_columns(heads: IntArray, sent: NDArray[np.bool_], epoch_us: int) -> dict[str, Column]:
    return {
        "time_s": (heads[:, T_US] - epoch_us) / 1e6,
        "sysid": heads[:, SYSID].astype(np.uint8),
        "compid": heads[:, COMPID].astype(np.uint8),
        "direction": ["to" if one else "from" for one in sent.tolist()],
    }


def _sender(sysid: int, compid: int) -> int:
    return sysid << 8 | compid


def _learn_stations(chunk: Chunk, stations: NDArray[np.bool_]) -> None:
    """Senders whose HEARTBEAT says ground station: what they send goes to vehicles."""
    beats = chunk.table("HEARTBEAT")
    for beat in beats[beats["type"] == mav.MAV_TYPE_GCS]:
        if beat["autopilot"] == mav.MAV_AUTOPILOT_INVALID:
            stations[_sender(int(beat["sysid"]), int(beat["compid"]))] = True


def _payload(chunk: Chunk, at: int) -> bytes:
    begin = at + (10 if chunk.octets[at] == 0xFD else 6)
    return chunk.octets[begin : begin + int(chunk.octets[at + 1])].tobytes()


def _unknown(chunk: Chunk, msgid: int, tables: Tables, epoch_us: int, sent: NDArray[np.bool_]) -> None:
    """Messages of no known dialect: one table of all of them, their payloads as they came."""
    mine = chunk.heads[:, MSGID] == msgid
    heads = chunk.heads[mine]
    columns = _own_columns(heads, sent[mine], epoch_us)
    columns["msgid"] = heads[:, MSGID]
    columns["payload_hex"] = [_payload(chunk, at).hex() for at in heads[:, AT].tolist()]
    tables.append("UNKNOWN", columns)


# decisions


def _export_decisions(path: Path, tables: Tables, progress: Progress) -> list[str]:
    """A table per kind: `decisions_set_point`; what a decision says of each vehicle is a row each in `…_by_vehicle`."""
    shapes: dict[str, tuple[dict[str, type], dict[str, type]]] = {}
    for record in DecisionLines(path):
        _learn(shapes, record)
    lines = DecisionLines(path, progress)
    waiting: dict[str, list[dict[str, Any]]] = {}

    def flush(name: str, types: Mapping[str, type]) -> None:
        rows = waiting.pop(name, [])
        if rows:
            tables.append(name, {key: _typed([row.get(key) for row in rows], kind) for key, kind in types.items()})

    for record in lines:
        name = _table(record)
        plain, vehicles = _flat(record)
        rows = waiting.setdefault(name, [])
        rows.append(plain)
        if shapes[name][1]:
            keys = {key: plain[key] for key in _KEYS if key in plain}
            waiting.setdefault(f"{name}_by_vehicle", []).extend({**keys, **row} for row in vehicles)
        if len(rows) >= LINES_AT_ONCE:
            flush(name, shapes[name][0])
            flush(f"{name}_by_vehicle", shapes[name][1])
    for name, (types, by_vehicle) in shapes.items():
        flush(name, types)
        flush(f"{name}_by_vehicle", by_vehicle)
    return [passed_over(path.name, lines.passed_over)] if lines.passed_over else []


def _table(record: Mapping[str, Any]) -> str:
    return "decisions_" + "".join(c if c.isalnum() else "_" for c in record["kind"][:NAME_LETTERS].lower())


def _flat(record: Mapping[str, Any]) -> tuple[dict[str, Any], list[dict[str, Any]]]:
    """A decision's own row, and the rows of what it says vehicle by vehicle."""
    plain: dict[str, Any] = {"time_s": float(record["t_s"])}
    by_vehicle: dict[int, dict[str, Any]] = {}
    for key, value in record.items():
        if key in ("kind", "t_s"):
            continue
        if isinstance(value, dict) and all(re.fullmatch("[0-9]{1,3}", sysid) for sysid in value):
            for sysid, number in value.items():
                by_vehicle.setdefault(int(sysid), {"sysid": int(sysid)})[key] = _plain(number)
        elif isinstance(value, list) and len(value) == 3 and key.endswith("_ned"):
            stem, unit = (key[:-4], "m_s") if key.startswith("v_") else (key[:-4], "m")
            letter = "v" if unit == "m_s" else "" if stem == "p" else f"{stem}_"
            plain |= {f"{letter}{axis}_ned_{unit}": _plain(x) for axis, x in zip(_AXES, value, strict=True)}
        else:
            plain[key] = _plain(value)
    return plain, [by_vehicle[sysid] for sysid in sorted(by_vehicle)]


def _plain(value: Any) -> Any:
    """A value as a cell has it."""
    return json.dumps(value) if isinstance(value, list | dict) else value


def _learn(shapes: dict[str, tuple[dict[str, type], dict[str, type]]], record: Mapping[str, Any]) -> None:
    """Note a table's columns and their types; where they vary, the wider one."""
    name = _table(record)
    known = shapes.get(name)
    if known is not None and name == "decisions_set_point":
        return  # the bulk of all lines, and each like the others
    own, by_vehicle = shapes.setdefault(name, ({}, {}))
    plain, vehicles = _flat(record)
    for types, rows in ((own, [plain]), (by_vehicle, vehicles)):
        for row in rows:
            if types is by_vehicle and not by_vehicle:
                by_vehicle |= {key: type(plain[key]) for key in _KEYS if key in plain}
            for key, value in row.items():
                types[key] = _wider(types.get(key), value)


_KEYS = ("time_s", "receiver", "tanker", "target", "pursuer")


def _wider(known: type | None, value: Any) -> type:
    """int, float, bool or str: the type of a column that held `known` so far; of nulls alone it is float."""
    if value is None:
        return float if known in (None, int) else known
    new = type(value)
    if known is None or known is new:
        return new
    return float if {known, new} <= {int, float} else str


def _typed(values: list[Any], kind: type) -> Column:
    if kind is str:
        return ["" if value is None else str(value) for value in values]
    if kind is bool:
        return np.ma.array([bool(value) for value in values], mask=[value is None for value in values])
    numbers = [value if isinstance(value, int | float) else None for value in values]
    if kind is int and all(isinstance(value, int) for value in numbers):
        return np.array(numbers, dtype=np.int64)
    return np.array([np.nan if value is None else value for value in numbers], dtype=np.float64)


# truth


def _export_truth(path: Path, tables: Tables, progress: Progress) -> list[str]:
    """`truth`: what a vehicle knew at each grant; `truth_thrust`: its thrust in each step."""
    with path.open("rb") as file:
        line = file.readline(1 << 16)
        try:
            head = json.loads(line)
            names = [_TRUTH_NAMES.get(name, name) for name in head["state"]] + list(head["energy"])
            sysid, step_s = int(head["sysid"]), float(head["step_s"])
            if not 0 < sysid < 256 or not all(isinstance(name, str) for name in names):
                raise ValueError(sysid)
        except (ValueError, KeyError, TypeError, OverflowError, RecursionError):
            return [f"{path.name} does not begin as a truth file; it is left out."]
        size = max(path.stat().st_size, 1)
        width = 2 + len(names)
        pending = b""
        while block := file.read(TRUTH_BYTES):
            pending += block
            numbers = np.frombuffer(pending[: len(pending) // 8 * 8], dtype="<f8")
            starts = record_places(numbers, width)
            end = int(starts[-1])
            _truth_tables(tables, numbers, starts[:-1], names, sysid, step_s)
            pending = pending[8 * end :]
            progress(file.tell() / size)
            if len(pending) > MOST_PENDING:
                return [f"{path.name} holds a record that cannot be; what follows it is left out."]
    return [f"{path.name} ends inside a record; its last {len(pending)} bytes are left out."] if pending else []


def _truth_tables(
    tables: Tables, numbers: NDArray[np.float64], starts: IntArray, names: list[str], sysid: int, step_s: float
) -> None:
    if not len(starts):
        return
    rows = numbers[starts[:, None] + np.arange(2 + len(names))]
    columns: dict[str, Column] = {"time_s": rows[:, 0], "sysid": np.full(len(rows), sysid, dtype=np.uint8)}
    tables.append("truth", columns | {name: rows[:, 2 + i] for i, name in enumerate(names)})
    steps = rows[:, 1].astype(np.int64)
    total = int(steps.sum())
    if total:
        begun = np.cumsum(steps) - steps
        within = np.arange(total) - np.repeat(begun, steps)
        left = np.repeat(steps, steps) - 1 - within
        thrust = numbers[np.repeat(starts + 2 + len(names), steps) + within]
        with np.errstate(over="ignore", invalid="ignore"):  # a damaged file may say any time
            time_s = np.round(np.repeat(rows[:, 0], steps) - left * step_s, 9)
        tables.append(
            "truth_thrust",
            {"time_s": time_s, "sysid": np.full(total, sysid, dtype=np.uint8), "thrust_body_m_s2": thrust},
        )
