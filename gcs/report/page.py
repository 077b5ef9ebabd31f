"""report.html: one file that needs no network and opens on the flight, the verdict above it; it is the page of a live
flight (`gcs.web`) with the recording inside, which it plays and draws.

Script and series are compressed; browsers unpack them themselves (DecompressionStream, since 2023). The page's policy
names by hash what may run and fetches nothing.
"""

from __future__ import annotations

import gc
import math
import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from datetime import UTC, datetime
from functools import cache
from html import escape
from pathlib import Path
from string import Template

from gcs.recording.importing import opened
from gcs.recording.series import Series
from gcs.recording.session_folder import read, read_recording
from gcs.recording.summary import Nearness
from gcs.report import tables
from gcs.report.charts import Charts
from gcs.report.findings import NOT_ENDED, Findings
from gcs.report.pack import packed
from gcs.scenario.goal import metres
from gcs.web import document
from skytender.processes import printable

FILE = document.REPORT_FILE
READ, MEASURED = 0.8, 0.9
FLIGHT, OUTCOME = "paths", ("outcome", "Outcome", "")
MOST_NAMED = 40
BAND = (
    "In figures over time the coloured ground goes from the least to the greatest value of all vehicles, dotted is "
    "their median; lines are of those drawn singly."
)
_MARKS = {"bad": "✗", "warn": "!", "note": "·"}
_PAGE = Template("""<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="$policy">
<meta name="color-scheme" content="light dark"><title>$title</title><link rel="icon" href="data:,"><style>$style</style>
</head><body class="report">
<header>
<p class="soft small">Session report</p>
<div class="title"><h1>$title</h1><p class="verdict $verdict_level">$verdict</p></div>
<p class="soft">$about</p>
$missing
<nav aria-label="sections">$links</nav>
</header>
<main>
$flight
<section id="outcome"><h2>Outcome</h2>
$problems
$goal
$cards
</section>
<fieldset class="picker"><legend>$picker</legend></fieldset>
$band
$sections
</main>
<footer class="soft small"><p>Made by gcs report on $when. Lines are drawn by the smallest and largest value of each
$bucket_s; every value is in session.tlog.</p></footer>
<noscript><p class="verdict bad">The figures need JavaScript; the text and the tables do not.</p></noscript>
<script type="application/json" id="config">$config</script>
<script type="application/json" id="model">$model</script>
<script type="text/plain" id="series">$series</script>
<script type="text/plain" id="page">$script</script>
<script>$loader</script>
</body></html>
""")
LOADER = """(async () => {
  const text = atob(document.getElementById("page").textContent.trim());
  const bytes = Uint8Array.from(text, (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  const script = document.createElement("script");
  script.textContent = await new Response(stream).text();
  document.head.append(script);
})().catch((problem) => {
  for (const one of document.querySelectorAll(".waiting")) {
    one.textContent = `This browser cannot draw the figures (${problem.message}).`;
  }
});"""


@contextmanager
def _uncollected() -> Iterator[None]:
    """Collect no garbage in this context."""
    collects = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if collects:
            gc.enable()


def make(source: Path, out: Path | None = None, progress: Callable[[str, float], object] = lambda *_: None) -> Path:
    """Make the report of a session's folder, in it, or of a recording, beside it, or at `out`; where it lies. An older
    one is replaced, whole.

    `progress` is given what is done and how much of all, 0 to 1. Raises NoSession, ImportFailed, OSError.
    """
    alone = source.is_file()
    target = out or (source.with_name(f"{source.name}.html") if alone else source / FILE)
    progress("reading", 0.0)
    with _uncollected():  # what is read stays, and to look through it again and again is a tenth of the time

        def told(share: float) -> None:
            progress("reading", READ * share)

        if alone:
            with opened(source) as recording:
                recorded = read_recording(recording.path, source, told)
                recorded.problems[:0] = recording.problems
        else:
            recorded = read(source, told)
        progress("measuring", READ)
        findings = Findings(recorded)
        progress("drawing", MEASURED)
        content = text(findings)
    beside = target.with_name(f".{target.name}.{os.getpid()}")
    try:
        beside.write_text(content, encoding="utf-8")
        beside.replace(target)
    except BaseException:
        beside.unlink(missing_ok=True)
        raise
    progress("done", 1.0)
    return target


def text(findings: Findings) -> str:
    """The page."""
    charts = Charts(findings)
    model = charts.model()
    made = [one for one in _sections(findings, {*model["figures"], *(["flight"] if model["flight"] else [])}) if one]
    flight, sections = [one for one in made if one[0] == FLIGHT], [one for one in made if one[0] != FLIGHT]
    recorded = findings.recorded
    name = findings.scenario.name if findings.scenario else printable(recorded.folder.resolve().name)
    picker = "Drawn singly:" if charts.many else "Vehicles:"
    style, script = document.built(document.STYLE), document.built(document.SCRIPT)
    allowed = " ".join(document.source_hash(one) for one in (LOADER, script))
    policy = (
        f"default-src 'none'; script-src {allowed}; style-src {document.source_hash(style)}; img-src data: blob:; "
        "base-uri 'none'; form-action 'none'"
    )
    level = "warn" if findings.summary is None else "good" if findings.summary.outcome == "met" else "bad"
    return _PAGE.substitute(
        title=escape(name),
        style=style,
        policy=policy,
        about=escape(_about(findings)),
        verdict=escape(findings.outcome),
        verdict_level=level,
        problems=_problems(findings),
        goal=_goal(findings),
        missing=_missing(recorded.problems),
        cards=_cards(findings),
        links="".join(f'<a href="#{part}">{escape(title)}</a>' for part, title, _ in (*flight, OUTCOME, *sections)),
        picker=picker,
        band=f'<p class="soft small">{BAND}</p>' if charts.many else "",
        flight="".join(map(_section, flight)),
        sections="\n".join(map(_section, sections)),
        when=datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC"),
        bucket_s=f"{charts.end_s / charts.buckets:.2g} s",
        config=document.as_json(document.config("report")),
        model=document.as_json(model),
        series=charts.pack.text(),
        script=_packed_script(),
        loader=LOADER,
    )


@cache
def _packed_script() -> str:
    return packed(document.built(document.SCRIPT).encode())


# the head


def _about(found: Findings) -> str:
    counts: dict[str, int] = {}
    for vehicle in found.vehicles:
        counts[vehicle.role] = counts.get(vehicle.role, 0) + 1
    fleet = ", ".join(f"{n} {role}{'' if n == 1 else 's'}" for role, n in counts.items()) or "no vehicle is known"
    words = [f"{fleet}; {found.end_s:.1f} s flown"]
    if found.summary is not None:
        pace = "in lockstep" if found.summary.clock == "lockstep" else f"on the clock at speed {found.summary.speed:g}"
        faster = found.summary.speed_achieved
        words.append(f"{pace}, {faster:.{0 if faster >= 10 else 1}f} times as fast as the wall clock")
    if found.scenario is not None and found.scenario.description:
        words.insert(0, found.scenario.description)
    return ". ".join(words).replace(". in", ", in").replace(". on", ", on") + "."


def _problems(found: Findings) -> str:
    problems = found.problems
    if not problems:
        return '<p class="good">Nothing went wrong in flight.</p>' if found.tracks else ""
    items = "".join(
        f'<li class="{p.level}">{_MARKS[p.level]} <span>{escape(p.text)}</span></li>' for p in problems[:MOST_NAMED]
    )
    if len(problems) > MOST_NAMED:
        items += f'<li class="note"><span>and {len(problems) - MOST_NAMED} more</span></li>'
    return f'<ul class="problems" aria-label="what went wrong">{items}</ul>'


def _goal(found: Findings) -> str:
    if not found.parts:
        return ""
    words = {True: ("good", "✓ reached"), False: ("bad", "✗ not reached"), None: ("warn", "? not known")}
    rows = "".join(
        f'<tr><td class="{words[part.met][0]}">{words[part.met][1]}</td><td>{escape(part.wanted)}</td>'
        f"<td>{escape(part.reached)}</td></tr>"
        for part in found.parts
    )
    return f'<table class="goal"><tr><td></td><th>goal</th><th>what was reached</th></tr>{rows}</table>'


def _missing(problems: Sequence[str]) -> str:
    if not problems:
        return ""
    items = "".join(f"<li>{escape(problem)}</li>" for problem in problems)
    return f'<div class="missing"><b>What this report could not show, or not wholly</b><ul>{items}</ul></div>'


def _cards(found: Findings) -> str:
    cards: list[tuple[str, str, str]] = []
    summary, near = found.summary, found.nearness
    reported: dict[Nearness, Series] = {
        "separation": near.separation,
        "clearance": near.clearance,
        "traffic": near.traffic,
    }
    for name, line in reported.items():
        nearest, least = found.closest(name), found.least(line)
        words = f"least distance to {name}" if name == "traffic" else f"least {name}"
        if nearest is not None:
            cards.append((words, metres(nearest.m, found.limits.get(name, -math.inf)), nearest.who))
        elif least:
            cards.append((words, f"{least[0]:.2f} m", f"at {least[1]:.1f} s, as reported"))
    pursuers = {v.sysid for v in found.vehicles if v.role != "tanker"}
    errors = {s: error for s, error in found.greatest_errors.items() if s in pursuers}
    if errors:
        worst = max(errors, key=lambda sysid: errors[sysid])
        cards.append(("greatest tracking error", f"{errors[worst]:.2f} m", f"vehicle {worst} (tankers excluded)"))
    lowest = {s: float(b.values.min()) for s, b in found.battery_percent.items() if len(b.values)}
    if lowest:
        whose = min(lowest, key=lambda sysid: lowest[sysid])
        cards.append(("lowest battery", f"{lowest[whose]:.0f} %", f"vehicle {whose}"))
    if found.services:
        moved = sum(s.energy_j for s in found.services)
        open_now = sum(s.reason == NOT_ENDED for s in found.services)
        under_way = f", {open_now} not ended" if open_now else ""
        cards.append(("refuellings", str(found.refuelled), f"{moved / 1e3:.1f} kJ moved{under_way}"))
    if summary is not None:
        cards.append(("frames lost", str(summary.link.lost), f"of {summary.link.received} received"))
    items = "".join(
        f"<div><dt>{escape(t)}</dt><dd>{escape(v)}<small>{escape(s)}</small></dd></div>" for t, v, s in cards
    )
    return f'<dl class="cards">{items}</dl>' if cards else ""


# the sections


def _section(one: tuple[str, str, str]) -> str:
    part, title, body = one
    return f'<section id="{part}"><h2>{escape(title)}</h2>{body}</section>'


def _sections(found: Findings, figures: set[str]) -> Iterable[tuple[str, str, str] | None]:
    """(id, title, HTML) of each section; None where there is nothing to show."""

    def figure(name: str, caption: str, kind: str = "") -> str:
        if name not in figures:
            return ""
        holds = "group" if name in ("timeline", "ledger") else "img"
        plot = (
            f'<div class="plot {kind}" data-figure="{name}" role="{holds}" aria-label="{escape(caption)}">'
            '<p class="waiting">drawing …</p></div>'
        )
        return f'<figure class="{kind}">{plot}<figcaption>{escape(caption)}</figcaption></figure>'

    def section(part: str, title: str, *bodies: str) -> tuple[str, str, str] | None:
        return (part, title, "".join(bodies)) if any(bodies) else None

    from_above = (
        "From above, north up, at the end. Rings stand where vehicles began, numbers where they are, crosses and grey "
        "shapes are obstacles; dashed grey: the targets' path as planned; dotted grey: other aircraft."
    )
    flown = "flight" in figures
    yield section(
        FLIGHT,
        "Flight",
        '<div id="app"></div>' if flown else "",
        figure("flight", from_above, kind="only-print") if flown else "",
    )
    yield section(
        "pursuit",
        "Pursuit and tracking",
        figure("target", "How far each pursuer was from its target."),
        figure(
            "error",
            "How far each vehicle was from the path of its latest set points. Tankers show large errors while flying "
            "to a rendezvous.",
        ),
    )
    yield section(
        "motion",
        "Speed, height and attitude",
        _pair(
            figure("motion", "Speed, and height above the scenario's origin."),
            figure("attitude", "Roll, pitch and yaw as reported (NED)."),
        ),
    )
    yield section(
        "energy",
        "Battery and energy ledger",
        figure("battery", "What each battery held, by initial + received − drawn − given; shaded: transfers received."),
        figure("ledger", "Where each vehicle's energy came from, and where it went: the two sides are equal."),
        tables.bases(found),
    )
    yield section(
        "competition",
        "Competition",
        figure(
            "contest",
            "The competition for the tankers: the state v of each competitor, and the leader's share; dotted: a "
            "decision hands a tanker to the vehicle named. Gaps: no vehicle competed.",
        ),
        figure(
            "base-contest",
            "The competition for the places at bases, of vehicles that no tanker can serve, in the same way; dotted: a "
            "decision hands a base to the vehicle named.",
        ),
    )
    yield section(
        "refuelling",
        "Refuelling",
        figure(
            "timeline",
            "Each refuelling from its decision: on the way, in formation (or at the base) until the transfer begins, "
            "the transfer until the service is done.",
        ),
        tables.services(found),
    )
    yield section(
        "distances",
        "Separation and clearance",
        figure(
            "nearness",
            "The least distance of any two vehicles in flight, partners of a refuelling apart; of any vehicle to an "
            "obstacle's surface (a point's centre); and to traffic: by the reported places. Dashed: what the goal "
            "demands; dotted: when it was broken.",
        ),
    )
    yield section("link", "Link", figure("link", _of_the_link(found)), tables.link(found))
    yield section("numbers", "The numbers", tables.numbers(found))
    yield section("again", "How to reproduce it", tables.again(found))


def _pair(*figures: str) -> str:
    there = [one for one in figures if one]
    return f'<div class="pair">{"".join(there)}</div>' if len(there) > 1 else "".join(there)


def _of_the_link(found: Findings) -> str:
    lost = sum(line.values[-1] for line in found.losses.values() if len(line.values))
    gaps = "and gaps in their numbers" if lost else "and not one gap in their numbers"
    return f"Frames heard of each vehicle, {gaps}."
