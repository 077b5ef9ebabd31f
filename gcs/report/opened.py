"""Recordings from Python:

    flight = gcs.open("sessions/demo-20260101-120000")
    flight["LOCAL_POSITION_NED"].groupby("sysid")["z_ned_m"].min()
    flight.plot("battery")

The tables are those of `gcs export`; in a notebook a recording is shown as its report.
"""

from __future__ import annotations

import os
from collections.abc import Collection, Iterator, Mapping
from contextlib import contextmanager
from functools import cached_property
from html import escape
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcs.extras import missing
from gcs.recording.export import ExportError, export
from gcs.recording.importing import ImportFailed, beside
from gcs.recording.session_folder import NoSession, Recorded, read, read_recording
from gcs.recording.summary import Summary
from gcs.recording.tables import Column
from gcs.report import page, plots
from gcs.report.charts import Charts
from gcs.report.findings import Findings, ServiceFinding
from gcs.scenario.document import did_you_mean, path_of
from gcs.scenario.model import Scenario

ENERGY, SERVICES = "energy", "services"
HEIGHT_PX = 720


class RecordingError(ValueError):
    """A recording that cannot be read; the text says which and why."""


class Recording(Mapping[str, Any]):
    """Tables of a session's folder or of recordings, by name; `gcs.open` makes it.

    Each is a pandas.DataFrame: `table(name)` gives its columns to NumPy and polars without pandas. As `gcs export`
    writes them: one for each message by its name, decisions_KIND, truth and truth_thrust, with columns in SI that say
    so and time_s since the start. Beside those `energy` has time_s, sysid, remaining_j and capacity_j after each report
    of a battery, and `services` a row for each refuelling. `problems`: what could not be read, a sentence each.
    """

    def __init__(self, paths: list[Path], tables: Mapping[str, dict[str, Column]], problems: list[str]) -> None:
        self.problems = problems
        self._paths = paths
        self._tables = tables

    def __getitem__(self, name: str) -> Any:
        try:
            import pandas as pd  # type: ignore[import-untyped, import-not-found, unused-ignore]  # noqa: PLC0415 - an extra
        except ModuleNotFoundError:
            raise missing("a table as DataFrame", "pandas", "pandas") from None
        return pd.DataFrame(self.table(name))

    def __iter__(self) -> Iterator[str]:
        yield from self._tables
        yield from (name for name in (ENERGY, SERVICES) if name not in self._tables)

    def __len__(self) -> int:
        return len({*self._tables, ENERGY, SERVICES})

    def table(self, name: str) -> dict[str, Column]:
        """Columns (k,) of a table by their names, arrays of numbers or booleans or lists of text; of booleans that not
        every row has a list, None in the others. Raises KeyError."""
        if name == ENERGY:
            return self._energy
        if name == SERVICES:
            return self._services
        if name not in self._tables:
            raise KeyError(f"{name}: the tables are {', '.join(self)}")
        return self._tables[name]

    @property
    def summary(self) -> Summary | None:
        """summary.json of a session; None without it."""
        return self.findings.summary

    @property
    def scenario(self) -> Scenario | None:
        """Scenario of a session; None without it."""
        return self.findings.scenario

    @property
    def figures(self) -> list[str]:
        """Names that `plot` takes."""
        return [plots.PATHS, *self._panels]

    def plot(self, figure: str = plots.PATHS, sysid: int | Collection[int] | None = None) -> Any:
        """Draw a figure of the report with matplotlib; (k,) its Axes.

        figure: one of `figures`. sysid: of which vehicles; all without it. Raises ValueError, MissingExtra without
        matplotlib.
        """
        if figure not in self.figures:
            raise ValueError(f"{figure!r} is no figure; the figures are {', '.join(self.figures)}")
        known = {vehicle.sysid for vehicle in self.findings.vehicles}
        chosen = known if sysid is None else {sysid} if isinstance(sysid, int) else set(sysid)
        if strange := chosen - known:
            raise ValueError(
                f"{min(strange)} is no vehicle here; the vehicles are {', '.join(map(str, sorted(known)))}"
            )
        if figure == plots.PATHS:
            return plots.plot_paths(self.findings, chosen)
        return plots.plot_panels(self._panels[figure], chosen)

    @cached_property
    def findings(self) -> Findings:
        """Findings that the report shows."""
        return Findings(self._recorded())

    def _recorded(self) -> Recorded:
        with _refusals(), beside(self._paths) as opened:
            return read(opened.path) if opened.path.is_dir() else read_recording(opened.path, self._paths[0])

    @cached_property
    def _panels(self) -> dict[str, Any]:
        return Charts(self.findings).panels()

    @cached_property
    def _energy(self) -> dict[str, Column]:
        batteries = self.findings.batteries.items()
        counts = [len(one.remaining.t_s) for _, one in batteries]
        return {
            "time_s": _joined([one.remaining.t_s for _, one in batteries]),
            "sysid": np.repeat([sysid for sysid, _ in batteries], counts).astype(np.int64),
            "remaining_j": _joined([one.remaining.values for _, one in batteries]),
            "capacity_j": np.repeat([one.capacity_j for _, one in batteries], counts).astype(np.float64),
        }

    @cached_property
    def _services(self) -> dict[str, Column]:
        services = self.findings.services
        names = [name for name in ServiceFinding.__struct_fields__ if name != "bids"]
        return {name: [getattr(one, name) for one in services] for name in names}

    def __repr__(self) -> str:
        names = " + ".join(path.name for path in self._paths)
        return f"<Recording of {names}, {len(self)} tables>"

    def _repr_html_(self) -> str:
        # Sandboxed: the page runs its own script, and reaches nothing of the notebook.
        content = escape(page.text(self.findings), quote=True)
        return (
            f'<iframe sandbox="allow-scripts allow-downloads" srcdoc="{content}" title="{escape(repr(self))}" '
            f'style="width: 100%; height: {HEIGHT_PX}px; border: 0"></iframe>'
        )


def open(
    source: str | os.PathLike[str], *others: str | os.PathLike[str], only: Collection[str] | None = None
) -> Recording:
    """Read a session's folder or a recording (.tlog, .tlog.raw, .rlog, ArduPilot's .BIN, PX4's .ulg) into tables.

    others: recordings beside it, as in `gcs replay`. only: names of the tables that are kept, for long recordings; all
    without it. What cannot be read is in `problems`. Raises RecordingError where nothing can be, ValueError where
    `only` names no table of it.
    """
    wanted = "a session's folder or a recording"
    paths = [Path(path_of(one, "the source", wanted)) for one in (source, *others)]
    tables = _Gathered(only)
    with _refusals(), beside(paths) as opened:
        problems = opened.problems + export(opened.path, tables)
    there = [*tables.rows, *(name for name in (ENERGY, SERVICES) if name not in tables.rows)]
    if missed := [name for name in only or () if name not in there]:
        known = f"the tables are {', '.join(there)}"
        raise ValueError(f"{missed[0]!r} is no table here; {known}{did_you_mean(str(missed[0]), there)}")
    return Recording(paths, tables.whole(), problems)


@contextmanager
def _refusals() -> Iterator[None]:
    """Raises what readers refuse as RecordingError."""
    try:
        yield
    except (ExportError, ImportFailed, NoSession) as error:
        raise RecordingError(str(error)) from None
    except OSError as error:
        raise RecordingError(f"{error.filename}: {error.strerror}") from None


class _Gathered:
    """Tables in memory, as `gcs.recording.tables.Tables`."""

    def __init__(self, only: Collection[str] | None) -> None:
        self.rows: dict[str, int] = {}
        self._only = only
        self._parts: dict[str, list[Mapping[str, Column]]] = {}

    def append(self, table: str, columns: Mapping[str, Column]) -> None:
        """As `Tables.append`."""
        self.rows[table] = self.rows.get(table, 0) + len(next(iter(columns.values())))
        if self._only is None or table in self._only:
            self._parts.setdefault(table, []).append(columns)

    def close(self) -> None:
        """As `Tables.close`."""

    def whole(self) -> dict[str, dict[str, Column]]:
        """Each table's columns."""
        return {
            name: {column: _joined([part[column] for part in parts]) for column in parts[0]}
            for name, parts in self._parts.items()
        }


def _joined(parts: list[Any]) -> Column:
    if parts and not isinstance(parts[0], np.ndarray):
        return list(chain.from_iterable(parts))
    whole = np.concatenate([_with_nan(part) for part in parts] or [np.empty(0)])
    return whole.tolist() if whole.dtype == object else whole


def _with_nan(numbers: NDArray[Any]) -> NDArray[Any]:
    """NaN for what is masked; None among booleans, which has no number's place there."""
    masked, data = np.ma.getmaskarray(numbers), np.ma.getdata(numbers)
    unknown: Any = None if data.dtype.kind == "b" else np.nan
    return np.where(masked, unknown, data) if masked.any() else data
