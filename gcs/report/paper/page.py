"""index.html: one file, readable without a network; every claim beside the paper's own value."""

from __future__ import annotations

import base64
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path
from string import Template

from gcs.report.paper.claims import Judged, shown
from gcs.report.paper.study import Table

MARKS = {"agrees": "yes", "differs": "no", "cannot be compared": "open"}
_STYLE = """
:root { color-scheme: light; }
body { font: 15px/1.5 system-ui, sans-serif; color: #1c1c1c; background: #fff; max-width: 66rem; margin: 2rem auto;
       padding: 0 1rem; }
h1 { font-size: 1.7rem; margin-bottom: .2rem; } h2 { margin-top: 3rem; border-bottom: 1px solid #ddd; }
table { border-collapse: collapse; width: 100%; font-size: 13px; margin: 1rem 0; }
caption { text-align: left; font-weight: 600; padding: .3rem 0; }
th, td { text-align: left; vertical-align: top; padding: .35rem .5rem; border-bottom: 1px solid #e4e4e4; }
th { background: #f6f6f6; } .wide { overflow-x: auto; }
table.claims { table-layout: fixed; } table.claims td { overflow-wrap: anywhere; }
table.numbers td { font-variant-numeric: tabular-nums; }
.criterion { color: #555; font-size: 12px; }
.verdict { font-weight: 600; }
.yes { color: #00664b; } .no { color: #a83c00; } .open { color: #555; }
.count { display: inline-block; margin-right: 1.5rem; } .count b { font-size: 1.5rem; margin-right: .35rem; }
figure { margin: 1.2rem 0; } figure img { width: 100%; } figcaption { font-size: 13px; color: #444; }
nav a { margin-right: .9rem; } a { color: #0a58a0; }
"""
_PAGE = Template("""<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>The paper, claim by claim</title><style>$style</style></head><body>
<h1>The paper, claim by claim</h1>
<p>Y. Yang, L. Liao, H. Yang, S. Li, <i>An Optimal Control Strategy for Multi-UAVs Target Tracking and Cooperative
Competition</i>, IEEE/CAA Journal of Automatica Sinica 8(12), 2021. Its examples were flown by vehicle processes over
MAVLink, in lockstep, and measured from the recorded sessions. What each claim is, and what would count as agreement,
was written down before anything was measured. The paper's displayed equations, the entries of Table I and its curves
are lost; what of a claim is therefore not the paper's stands beside it. A second table was added later: other
readings, what can be proved wrong, what the text does not determine, and claims that the first one lacks. Where a claim
differs the reason is given: the paper contradicts itself, the text does not determine it, the criterion is ours, or
none of these, a real difference.</p>
<p>First table: $counts</p>
<p>Second table: $later_counts</p>
<p>$reasons</p>
<nav>$links</nav>
$parts
<p class="criterion">Made by gcs paper on $when in $wall s. Sessions lie in sessions/, figures as SVG and PNG beside
this page, the claims in claims.json.</p>
</body></html>
""")


@dataclass(frozen=True)
class Image:
    """A figure on the page: its SVG file and the sentence under it."""

    svg: Path
    caption: str


@dataclass(frozen=True)
class Section:
    """One part of the page."""

    part: str
    title: str
    claims: Sequence[Judged]
    images: Sequence[Image]
    tables: Sequence[Table]


def write(path: Path, sections: Sequence[Section], *, when: str, wall_s: float) -> None:
    """Write the page. Raises OSError."""
    judged = [one for section in sections for one in section.claims]
    first, later = ([one for one in judged if one.claim.later == is_later] for is_later in (False, True))
    why = Counter(one.reason.reason for one in judged if one.reason is not None)
    told = "; ".join(f"{escape(reason)}: {number}" for reason, number in why.most_common())
    text = _PAGE.substitute(
        style=_STYLE,
        counts="".join(_count(verdict, number) for verdict, number in counted(first).items()),
        later_counts="".join(_count(verdict, number) for verdict, number in counted(later).items()),
        reasons=f"Differences: {told}" if why else "",
        links="".join(f'<a href="#{section.part}">{escape(section.title)}</a>' for section in sections),
        parts="\n".join(map(_section, sections)),
        when=escape(when),
        wall=f"{wall_s:.0f}",
    )
    path.write_text(text, encoding="utf-8")


def _count(verdict: str, number: int) -> str:
    return f'<span class="count {MARKS[verdict]}"><b>{number}</b>{verdict}</span>'


def _section(section: Section) -> str:
    parts = [f'<h2 id="{section.part}">{escape(section.title)}</h2>']
    for is_later, name in ((False, "First table"), (True, "Second table")):
        if rows := [one for one in section.claims if one.claim.later == is_later]:
            parts.append(_claims(name, rows))
    parts += map(_image, section.images)
    parts += map(_table, section.tables)
    return "\n".join(parts)


def _claims(caption: str, claims: Sequence[Judged]) -> str:
    widths = (8, 31, 16, 12, 10, 23)
    columns = "".join(f'<col style="width:{width}%">' for width in widths)
    names = ("figure", "claim, and how it is measured", "the paper", "measured", "verdict", "why")
    head = "".join(f"<th>{name}</th>" for name in names)
    body = "".join(map(_claim, claims))
    start = f'<table class="claims"><caption>{caption}</caption><colgroup>{columns}</colgroup>'
    return f"{start}<tr>{head}</tr>{body}</table>"


def _claim(one: Judged) -> str:
    claim = one.claim
    ours = f'<div class="criterion">not the paper\'s: {escape(claim.ours)}</div>' if claim.ours else ""
    reason = one.reason and f'<div class="criterion"><b>{one.reason.reason}</b>: {escape(one.reason.because)}</div>'
    cells = (
        escape(claim.figure),
        f'{escape(claim.claim)}<div class="criterion">{escape(claim.criterion)}</div>',
        f'{escape(claim.paper)}{ours}<div class="criterion">tolerance: {escape(claim.tolerance)}</div>',
        escape(shown(one.value)),
        f'<span class="verdict {MARKS[one.verdict]}">{one.verdict}</span>',
        f"{escape(one.why)}{reason or ''}",
    )
    return f"<tr>{''.join(f'<td>{cell}</td>' for cell in cells)}</tr>"


def _image(image: Image) -> str:
    data = base64.b64encode(image.svg.read_bytes()).decode("ascii")
    caption = escape(image.caption)
    embedded = f'<img alt="{caption}" src="data:image/svg+xml;base64,{data}">'
    return f"<figure>{embedded}<figcaption>{caption}</figcaption></figure>"


def _table(table: Table) -> str:
    head = "".join(f"<th>{escape(name)}</th>" for name in table.columns)
    body = "".join(f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in row)}</tr>" for row in table.rows)
    caption = f"<caption>{escape(table.caption)}</caption>"
    return f'<div class="wide"><table class="numbers">{caption}<tr>{head}</tr>{body}</table></div>'


def counted(judged: Sequence[Judged]) -> Mapping[str, int]:
    """Number of claims with each verdict."""
    return {verdict: sum(one.verdict == verdict for one in judged) for verdict in MARKS}
