"""The page of a campaign: rates, distributions and paired differences with their uncertainty, and the worst sessions.

One self-contained file. The same table gives the same page.
"""

from __future__ import annotations

import base64
import io
import itertools
import math
from collections.abc import Iterable, Sequence
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure

from gcs.campaign import measures, table
from gcs.campaign.plan import Plan
from gcs.campaign.statistics import ERRORS_STAY, Interval, mean, name_of, numbers, paired, wilson
from gcs.report.paper.figures import sheet, style
from gcs.web.document import source_hash

if TYPE_CHECKING:
    import pyarrow as pa

FILE = "report.html"
WORST = 10
MOST_PAIRS = 12
MOST_LINES = 2000
"""Sessions drawn in the parallel coordinates."""
LESS_IS_WORSE = ("min_separation_m", "min_clearance_m", "lowest_battery", "delivered_j", "refuelled")
MORE_IS_WORSE = (
    *("lost", "lost_somebody", "stuck", "tanker_idle_s", "wait_s", "time_to_goal_s"),
    *("tankers_way_m", "path_length_m", "control_effort", "max_tracking_error_m"),
)
STYLE = """
body{font:15px/1.5 system-ui,sans-serif;max-width:72rem;margin:2rem auto;padding:0 1rem;color:#1b1f24}
table{border-collapse:collapse;margin:.5rem 0 1.5rem}td,th{padding:.25rem .7rem;border-bottom:1px solid #d8dde3}
th{text-align:left}td{font-variant-numeric:tabular-nums}
code{background:#eef1f4;padding:.1rem .3rem;border-radius:3px;white-space:nowrap}
.plot{max-width:100%;height:auto;background:#fff}@media print{body{max-width:none}}
"""


def make(folder: Path, plan: Plan) -> Path:
    """Write the page of what a campaign's folder holds; raises OSError."""
    rows = table.read(folder, plan.campaign)
    path = folder / FILE
    path.write_text(page(folder, plan, rows), encoding="utf-8")
    return path


def page(folder: Path, plan: Plan, rows: pa.Table) -> str:
    """The page as HTML."""
    campaign = plan.campaign
    measured = [name for name in campaign.measured if not measures.is_word(name) and _known(rows, name)]
    about = f"{rows.num_rows} of {plan.rows} sessions, {campaign.combinations} combinations, seed {campaign.seed}"
    parts = [
        f"<h1>{escape(campaign.name)}</h1><p>{escape(campaign.description)}</p><p>{about}.</p>",
        "<h2>Success</h2>",
        _success(plan, rows),
        "<h2>Measures</h2><p>Means with 95 % bootstrap intervals.</p>",
        _means(plan, rows, measured),
        *(_box(plan, rows, name) for name in measured),
    ]
    if campaign.combinations > 1:
        parts += [
            "<h2>Differences</h2><p>Paired: the same draws under both. Intervals are 95 % bootstrap ones; the effect "
            "is the mean difference over its standard deviation; none is better where the interval holds 0; the last "
            "column is how many sessions would tell such an effect from none at 95 % confidence with 80 % power.</p>",
            _differences(plan, rows, measured),
        ]
    parts += ["<h2>Worst sessions</h2>", _worst(folder, plan, rows, measured), _parallel(plan, rows, measured)]
    policy = f"default-src 'none'; img-src data:; style-src {source_hash(STYLE)}; base-uri 'none'; form-action 'none'"
    guard = f'<meta http-equiv="Content-Security-Policy" content="{policy}">'
    head = f'<meta charset="utf-8">{guard}<title>{escape(campaign.name)}</title><style>{STYLE}</style>'
    return f'<!doctype html><html lang="en"><head>{head}</head><body>{"".join(parts)}</body></html>\n'


def worst(rows: pa.Table, measured: Sequence[str]) -> list[dict[str, Any]]:
    """The rows that went worst: errors, then failures, then by the first measure of which less is worse."""
    by = next((name for name in LESS_IS_WORSE if name in measured), None)

    def rank(row: dict[str, Any]) -> tuple[bool, bool, float, int]:
        value = math.inf if by is None or row[by] is None else float(row[by])
        return row["error"] is None, bool(row["ok"]), value, row["row"]

    return sorted(rows.to_pylist(), key=rank)[:WORST]


def _success(plan: Plan, rows: pa.Table) -> str:
    lines, errors = [], 0
    for number, of in _by_combination(plan, rows):
        ok = of["ok"].to_pylist()
        failed = len(of) - of["error"].null_count
        errors += failed
        rate = wilson(sum(map(bool, ok)), len(ok))
        interval = f"{100 * rate.low:.1f} to {100 * rate.high:.1f} %"
        good = f"{sum(map(bool, ok))} of {len(ok)}"
        lines.append([name_of(plan, number) or "all", good, _percent(rate), interval, str(failed)])
    stay = f"<p>{ERRORS_STAY}</p>" if errors else ""
    return _table(["", "as expected", "rate", "95 % (Wilson)", "errors"], lines) + stay


def _means(plan: Plan, rows: pa.Table, measured: Sequence[str]) -> str:
    lines = []
    for number, of in _by_combination(plan, rows):
        found = [mean(numbers(of, name)) for name in measured]
        lines.append([name_of(plan, number) or "all", *(_interval(one) for one in found)])
    return _table(["", *measured], lines)


def _differences(plan: Plan, rows: pa.Table, measured: Sequence[str]) -> str:
    lines = []
    pairs = list(itertools.combinations(range(plan.campaign.combinations), 2))[:MOST_PAIRS]
    for name, (first, second) in itertools.product(measured, pairs):
        found = paired(rows, name, first, second)
        if not found.pairs:
            continue
        verdict = _better(name, found.difference, name_of(plan, first), name_of(plan, second))
        who = f"{name_of(plan, second)} less {name_of(plan, first)}"
        effect = "-" if math.isnan(found.effect) else f"{found.effect:.2f}"
        needed = "-" if found.sessions_needed is None else str(found.sessions_needed)
        lines.append([name, who, str(found.pairs), _interval(found.difference), verdict, effect, needed])
    return _table(["measure", "", "pairs", "difference", "better", "effect", "sessions needed"], lines)


def _better(measure: str, second_less_first: Interval, first: str, second: str) -> str:
    """Which of two the interval of a difference shows to be better; of other measures only that they differ."""
    if not (second_less_first.low > 0.0 or second_less_first.high < 0.0):
        return "-"
    if measure not in LESS_IS_WORSE + MORE_IS_WORSE:
        return "they differ"
    return second if (second_less_first.low > 0.0) == (measure in LESS_IS_WORSE) else first


def _worst(folder: Path, plan: Plan, rows: pa.Table, measured: Sequence[str]) -> str:
    lines = []
    for row in worst(rows, measured):
        why = row["error"] or row["fault"] or "as expected"
        values = [_number(row[name]) for name in measured]
        command = f"gcs campaign fly {folder.name} {row['row']}"
        lines.append(
            [str(row["row"]), name_of(plan, row["combination"]), why, *values, f"<code>{escape(command)}</code>"]
        )
    return _table(["row", "", "why", *measured, "flies it again"], lines, raw_last=True)


def _box(plan: Plan, rows: pa.Table, name: str) -> str:
    """A measure's distribution by combination: quartiles, whiskers to 1.5 times their distance, outliers."""
    values = {name_of(plan, c) or "all": _finite(numbers(of, name)) for c, of in _by_combination(plan, rows)}
    with style():
        figure, axes = sheet(0.8 + 0.34 * len(values))
        at = axes[0, 0]
        at.boxplot(list(values.values()), orientation="horizontal", tick_labels=list(values), widths=0.6)
        at.invert_yaxis()
        at.set_xlabel(name)
        return _image(figure, f"{name} by combination")


def _parallel(plan: Plan, rows: pa.Table, measured: Sequence[str]) -> str:
    """The draws and what came of them, a line per session: red did not end as expected."""
    shown = rows.slice(0, MOST_LINES)
    drawn = [key for key in (*plan.campaign.vary, *plan.campaign.draw) if key in rows.column_names]
    columns: list[tuple[str, list[float], list[str]]] = []
    for key in [*drawn, *measured]:
        listed = shown[key].to_pylist()
        if any(isinstance(value, list) for value in listed):
            continue
        if all(isinstance(value, int | float) or value is None for value in listed):
            columns.append((key, [math.nan if value is None else float(value) for value in listed], []))
        elif len(words := sorted({str(value) for value in listed})) <= 20:
            columns.append((key, [float(words.index(str(value))) for value in listed], words))
    if len(columns) < 2:
        return ""
    with style():
        figure, axes = sheet(4.0)
        _lines(axes[0, 0], columns, [bool(ok) for ok in shown["ok"].to_pylist()])
        return "<h2>What was drawn</h2>" + _image(figure, "each session's draws and measures, red: not as expected")


def _lines(axes: Axes, columns: Sequence[tuple[str, list[float], list[str]]], ok: Sequence[bool]) -> None:
    """Parallel coordinates: each column from its least, below, to its greatest value."""
    shares = []
    for at, (_, values, words) in enumerate(columns):
        known = [value for value in values if math.isfinite(value)] or [0.0]
        low, span = min(known), max(max(known) - min(known), 1e-12)
        shares.append([(value - low) / span for value in values])
        marks = enumerate(words) if words else ((low, f"{low:.3g}"), (low + span, f"{low + span:.3g}"))
        for value, text in marks:
            axes.annotate(text, (at, (value - low) / span), fontsize=7, ha="center", va="bottom", color="#333333")
    paths = [list(enumerate(line)) for line in zip(*shares, strict=True)]
    for good, colour, alpha in ((True, "#0072b2", 0.35), (False, "#d55e00", 0.8)):
        chosen = [path for path, fine in zip(paths, ok, strict=True) if fine is good]
        axes.add_collection(LineCollection(chosen, colors=colour, alpha=alpha, linewidths=0.7, rasterized=True))
    axes.set_xlim(-0.4, len(columns) - 0.6)
    axes.set_ylim(-0.08, 1.15)
    axes.set_xticks(range(len(columns)), [name for name, _, _ in columns], rotation=20, ha="right")
    axes.set_yticks([])


def _image(figure: Figure, caption: str) -> str:
    """A figure inside the page, as SVG."""
    drawn = io.StringIO()
    figure.savefig(drawn, format="svg", metadata={"Date": None})
    svg = drawn.getvalue()
    content = base64.b64encode(svg[svg.index("<svg") :].encode()).decode()
    return f'<img class="plot" alt="{escape(caption)}" src="data:image/svg+xml;base64,{content}">'


def _by_combination(plan: Plan, rows: pa.Table) -> Iterable[tuple[int, pa.Table]]:
    """Each combination's rows; none of one that has not flown yet."""
    import pyarrow.compute as pc  # noqa: PLC0415 - of the extra

    for number in range(plan.campaign.combinations):
        yield number, rows.filter(pc.field("combination") == number)


def _table(head: Sequence[str], lines: Sequence[Sequence[str]], *, raw_last: bool = False) -> str:
    def cells(line: Sequence[str]) -> str:
        raw = len(line) - 1 if raw_last else len(line)
        return "".join(f"<td>{word if i == raw else escape(word)}</td>" for i, word in enumerate(line))

    heads = "".join(f"<th>{escape(word)}</th>" for word in head)
    return f"<table><tr>{heads}</tr>{''.join(f'<tr>{cells(line)}</tr>' for line in lines)}</table>"


def _known(rows: pa.Table, name: str) -> bool:
    return bool(np.isfinite(numbers(rows, name)).any())


def _finite(values: np.ndarray[Any, Any]) -> list[float]:
    return [float(value) for value in values if math.isfinite(value)]


def _interval(one: Interval) -> str:
    if math.isnan(one.value):
        return "-"
    return f"{one.value:.4g}" + ("" if math.isnan(one.low) else f" ({one.low:.4g} to {one.high:.4g})")


def _percent(one: Interval) -> str:
    return "-" if math.isnan(one.value) else f"{100 * one.value:.1f} %"


def _number(value: Any) -> str:
    return "-" if value is None else f"{value:.4g}"
