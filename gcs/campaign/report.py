"""The page of a campaign: rates, distributions and paired differences with their uncertainty, and the worst sessions.

One self-contained file. The same table gives the same page.
"""

from __future__ import annotations

import html
import itertools
import json
import math
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from gcs.campaign import measures, table
from gcs.campaign.plan import Plan
from gcs.campaign.statistics import Interval, mean, name_of, numbers, paired, wilson
from gcs.report.page import plotly_js

if TYPE_CHECKING:
    import pyarrow as pa

FILE = "report.html"
WORST = 10
MOST_PAIRS = 12
MOST_LINES = 2000
"""Sessions drawn in the parallel coordinates."""
LESS_IS_WORSE = ("min_separation_m", "min_clearance_m", "lowest_battery", "delivered_j", "refuelled")
STYLE = """
body{font:15px/1.5 system-ui,sans-serif;max-width:72rem;margin:2rem auto;padding:0 1rem;color:#1b1f24}
table{border-collapse:collapse;margin:.5rem 0 1.5rem}td,th{padding:.25rem .7rem;border-bottom:1px solid #d8dde3}
th{text-align:left}td{font-variant-numeric:tabular-nums}code{background:#eef1f4;padding:.1rem .3rem;border-radius:3px}
.plot{height:22rem}@media print{body{max-width:none}}
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
        f"<h1>{_safe(campaign.name)}</h1><p>{_safe(campaign.description)}</p><p>{about}.</p>",
        "<h2>Success</h2>",
        _success(plan, rows),
        "<h2>Measures</h2><p>Means with 95 % bootstrap intervals.</p>",
        _means(plan, rows, measured),
        *(_box(plan, rows, name, i) for i, name in enumerate(measured)),
    ]
    if campaign.combinations > 1:
        parts += [
            "<h2>Differences</h2><p>Paired: the same draws under both. Intervals are 95 % bootstrap ones; the effect "
            "is the mean difference over its standard deviation; the last column is how many sessions would tell such "
            "an effect from none at 95 % confidence with 80 % power.</p>",
            _differences(plan, rows, measured),
        ]
    parts += ["<h2>Worst sessions</h2>", _worst(folder, plan, rows, measured), _parallel(plan, rows, measured)]
    script = f"<script>{plotly_js().decode()}</script>"
    head = f'<meta charset="utf-8"><title>{_safe(campaign.name)}</title><style>{STYLE}</style>{script}'
    return f'<!doctype html><html lang="en"><head>{head}</head><body>{"".join(parts)}</body></html>\n'


def worst(rows: pa.Table, measured: Sequence[str]) -> list[dict[str, Any]]:
    """The rows that went worst: errors, then failures, then by the first measure of which less is worse."""
    by = next((name for name in LESS_IS_WORSE if name in measured), None)

    def rank(row: dict[str, Any]) -> tuple[bool, bool, float, int]:
        value = math.inf if by is None or row[by] is None else float(row[by])
        return row["error"] is None, bool(row["ok"]), value, row["row"]

    return sorted(rows.to_pylist(), key=rank)[:WORST]


def _success(plan: Plan, rows: pa.Table) -> str:
    lines = []
    for number, of in _by_combination(plan, rows):
        ok = rows.take(of)["ok"].to_pylist()
        rate = wilson(sum(map(bool, ok)), len(ok))
        interval = f"{100 * rate.low:.1f} to {100 * rate.high:.1f} %"
        lines.append([name_of(plan, number) or "all", f"{sum(map(bool, ok))} of {len(ok)}", _percent(rate), interval])
    return _table(["", "as expected", "rate", "95 % (Wilson)"], lines)


def _means(plan: Plan, rows: pa.Table, measured: Sequence[str]) -> str:
    lines = []
    for number, of in _by_combination(plan, rows):
        found = [mean(numbers(rows.take(of), name)) for name in measured]
        lines.append([name_of(plan, number) or "all", *(_interval(one) for one in found)])
    return _table(["", *measured], lines)


def _differences(plan: Plan, rows: pa.Table, measured: Sequence[str]) -> str:
    lines = []
    pairs = list(itertools.combinations(range(plan.campaign.combinations), 2))[:MOST_PAIRS]
    for name, (first, second) in itertools.product(measured, pairs):
        found = paired(rows, name, first, second)
        if not found.pairs:
            continue
        distinguished = "yes" if found.difference.low > 0.0 or found.difference.high < 0.0 else "no"
        who = f"{name_of(plan, second)} less {name_of(plan, first)}"
        effect = "-" if math.isnan(found.effect) else f"{found.effect:.2f}"
        needed = "-" if found.sessions_needed is None else str(found.sessions_needed)
        lines.append([name, who, str(found.pairs), _interval(found.difference), distinguished, effect, needed])
    return _table(["measure", "", "pairs", "difference", "differs", "effect", "sessions needed"], lines)


def _worst(folder: Path, plan: Plan, rows: pa.Table, measured: Sequence[str]) -> str:
    lines = []
    for row in worst(rows, measured):
        why = row["error"] or row["fault"] or "as expected"
        values = [_number(row[name]) for name in measured]
        command = f"gcs campaign fly {folder.name} {row['row']}"
        lines.append(
            [str(row["row"]), name_of(plan, row["combination"]), why, *values, f"<code>{_safe(command)}</code>"]
        )
    return _table(["row", "", "why", *measured, "flies it again"], lines, raw_last=True)


def _box(plan: Plan, rows: pa.Table, name: str, number: int) -> str:
    """A measure's distribution by combination."""
    traces = [
        {
            "type": "box",
            "name": name_of(plan, c) or "all",
            "boxpoints": "outliers",
            "y": _finite(numbers(rows.take(of), name)),
        }
        for c, of in _by_combination(plan, rows)
    ]
    return _plot(f"box-{number}", traces, {"title": {"text": name}, "showlegend": False})


def _parallel(plan: Plan, rows: pa.Table, measured: Sequence[str]) -> str:
    """Drawn values and results, a line per session."""
    shown = rows.slice(0, MOST_LINES)
    drawn = [key for key in (*plan.campaign.vary, *plan.campaign.draw) if key in rows.column_names]
    dimensions = []
    for key in [*drawn, *measured]:
        listed = shown[key].to_pylist()
        if any(isinstance(value, list) for value in listed):
            continue
        if all(isinstance(value, int | float) or value is None for value in listed):
            dimensions.append({"label": key, "values": [0.0 if value is None else float(value) for value in listed]})
        elif len(words := sorted({str(value) for value in listed})) <= 20:
            at = [words.index(str(value)) for value in listed]
            dimensions.append({"label": key, "values": at, "tickvals": list(range(len(words))), "ticktext": words})
    if len(dimensions) < 2:
        return ""
    colour = [float(bool(ok)) for ok in shown["ok"].to_pylist()]
    line = {"color": colour, "colorscale": [[0, "#c0392b"], [1, "#2874a6"]], "cmin": 0, "cmax": 1}
    return "<h2>What was drawn</h2>" + _plot(
        "drawn", [{"type": "parcoords", "line": line, "dimensions": dimensions}], {}
    )


def _plot(name: str, traces: Sequence[Any], layout: dict[str, Any]) -> str:
    content = json.dumps([traces, {**layout, "margin": {"t": 60, "r": 40}}]).replace("</", "<\\/")
    return (
        f'<div class="plot" id="{name}"></div><script>{{const [data, layout] = {content};'
        f'Plotly.newPlot("{name}", data, layout, {{responsive: true, displaylogo: false}});}}</script>'
    )


def _by_combination(plan: Plan, rows: pa.Table) -> Iterable[tuple[int, list[int]]]:
    combination = rows["combination"].to_pylist()
    for number in range(plan.campaign.combinations):
        yield number, [i for i, one in enumerate(combination) if one == number]


def _table(head: Sequence[str], lines: Sequence[Sequence[str]], *, raw_last: bool = False) -> str:
    def cells(line: Sequence[str]) -> str:
        raw = len(line) - 1 if raw_last else len(line)
        return "".join(f"<td>{word if i == raw else _safe(word)}</td>" for i, word in enumerate(line))

    heads = "".join(f"<th>{_safe(word)}</th>" for word in head)
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


def _safe(text: str) -> str:
    return html.escape(text)
