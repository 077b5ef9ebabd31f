"""The report's tables as HTML: refuellings, link, vehicles, and how to reproduce the session."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape
from typing import Any

import numpy as np

from gcs.report.findings import Findings, finite
from gcs.scenario.plugins import named, policy_of
from gcs.supervisor import script
from gcs.supervisor.recorded_objects import PROGRAM
from skytender.processes import printable

ORDERS = ("command", "taken", "said")


def _table(caption: str, heads: Sequence[str], rows: Iterable[Sequence[Any]], words: Sequence[str] = ()) -> str:
    """A table that sorts; columns named in `words` hold words, the others numbers."""
    kinds = [' class="word"' if head in words else "" for head in heads]
    head = "".join(f'<th scope="col"{kind}>{escape(name)}</th>' for name, kind in zip(heads, kinds, strict=True))
    body = "".join(
        "<tr>" + "".join(f"<td{kind}>{escape(_cell(v))}</td>" for v, kind in zip(row, kinds, strict=True)) + "</tr>"
        for row in rows
    )
    if not body:
        return ""
    return (
        f'<div class="scroll" tabindex="0" role="region" aria-label="{escape(caption)}"><table class="sorts">'
        f"<caption>{escape(caption)}</caption><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>"
    )


def _cell(value: Any) -> str:
    if value is None:
        return "–"
    return f"{value:.2f}" if isinstance(value, float) else str(value)


def _time(value: float | None) -> str | None:
    return None if value is None else f"{value:.1f}"


def services(found: Findings) -> str:
    """Each refuelling, step by step."""
    rows = []
    for s in found.services:
        bids = sorted(s.bids.items(), key=lambda bid: -bid[1])
        reported = " · ".join(f"{sysid}: {bid:.2f}" for sysid, bid in bids[:4]) + (" …" if len(bids) > 4 else "")
        times = (_time(s.decided_at_s), _time(s.joined_at_s), _time(s.start_s), _time(s.end_s))
        rows.append((s.receiver, s.giver, s.by, *times, f"{s.energy_j:.0f}", s.reason, reported))
    heads = (
        "receiver",
        "served by",
        "decided by",
        "decided (s)",
        "joined (s)",
        "transfer (s)",
        "done (s)",
        "energy (J)",
        "ended",
        "bids",
    )
    return _table(
        "Each refuelling, with the highest bids (τ)", heads, rows, ("served by", "decided by", "ended", "bids")
    )


def bases(found: Findings) -> str:
    """Each base's ledger; empty where there is none."""
    keys = ("initial_j", "given_j", "lost_j", "remaining_j")
    rows = [
        (base.name, *(f"{getattr(base, key):.0f}" for key in keys))
        for base in (found.summary.bases if found.summary else ())
    ]
    heads = ("base", "initial (J)", "given (J)", "lost (J)", "remaining (J)")
    return _table("Each base: initial = given + remaining", heads, rows, ("base",))


def link(found: Findings) -> str:
    """The session's counts of frames; empty without a summary."""
    if found.summary is None:
        return ""
    counts = found.summary.link
    names = ("received", "sent", "lost", "malformed", "overflowed", "command_retries")
    reported = (
        "frames received",
        "frames sent",
        "lost (gaps)",
        "malformed",
        "dropped by the system",
        "commands sent again",
    )
    return _table("The session's link, frames", reported, [[getattr(counts, name) for name in names]])


def numbers(found: Findings) -> str:
    """A row for each vehicle."""
    summary = found.summary
    of = {v.sysid: v for v in summary.vehicles} if summary else {}
    rows = []
    for vehicle in found.vehicles:
        sysid = vehicle.sysid
        reported = of.get(sysid)
        energy = reported.energy if reported else None
        error = found.greatest_errors.get(sysid)
        battery = found.battery_percent.get(sysid)
        link = found.links.get(sysid)
        whole = ("initial_j", "drawn_j", "received_j", "given_j", "lost_j", "remaining_j")
        rows.append(
            (
                vehicle.label,
                vehicle.role,
                (reported.final_mode_name or reported.final_mode) if reported else None,
                f"{reported.path_length_m:.1f}" if reported else None,
                f"{error:.3f}" if error is not None else None,
                _top_speed(found, sysid),
                f"{reported.control_effort:.0f}" if reported else None,
                *(f"{getattr(energy, name):.0f}" if energy else None for name in whole),
                f"{battery.values.min():.1f}" if battery is not None and len(battery.values) else None,
                int(link.lost.values[-1]) if link is not None else None,
                finite(link.longest_silence_s) if link is not None else None,
            )
        )
    heads = (
        *("vehicle", "role", "final mode", "path (m)", "greatest error (m)", "top speed (m/s)", "control effort"),
        *("initial (J)", "drawn (J)", "received (J)", "given (J)", "lost (J)", "remaining (J)"),
        *("lowest battery (%)", "frames lost", "longest silence (s)"),
    )
    return _table("Each vehicle", heads, rows, ("vehicle", "role", "final mode"))


def _top_speed(found: Findings, sysid: int) -> float | None:
    """m/s, while its battery was not empty: with an empty one it falls. None where no speed is known."""
    if sysid not in found.speeds:
        return None
    speed, battery = found.speeds[sysid], found.batteries.get(sysid)
    counts = np.isfinite(speed.values) & (True if battery is None else ~battery.is_empty(speed.t_s))
    return float(speed.values[counts].max()) if counts.any() else None


def again(found: Findings) -> str:
    """How to fly the session again, and the digest that shows it is the same."""
    folder, summary = found.recorded.folder.resolve(), found.summary
    parts = []
    if found.scenario is not None:
        pace = " --lockstep" if found.scenario.clock.mode == "lockstep" else ""
        command = f"gcs run {printable(folder.name)}/scenario.yaml{pace} --seed {found.scenario.seed} --out again"
        parts.append(
            f"<p>With the same versions, from beside the session's folder:</p><pre><code>{escape(command)}</code></pre>"
        )
        if code := " and ".join(policy_of(key, name) for key, name, _ in named(found.scenario)):
            parts.append(
                f"<p>The scenario names code, {escape(code)}, which is not in the session's folder. Where Python does "
                "not find its module, copy that to where you call the command, or name the folder that has it in "
                "PYTHONPATH. The command asks before it runs the code.</p>"
            )
    if any(d["kind"] in {PROGRAM, *script.KINDS} for d in found.recorded.decisions):
        decided = f"gcs replay {printable(folder.name)} --decide"
        parts.append(
            "<p>A program in Python took part; without it the flight is another. What it did, and its own planner and "
            f"policy answered, is recorded: <code>{escape(decided)}</code> decides again with that.</p>"
        )
    orders = [d for d in found.recorded.decisions if d["kind"] == "operator"]
    if orders:
        rows_of = [(f"{d['t_s']:.1f}", d["command"], "yes" if d["taken"] else "no", d["text"]) for d in orders]
        table = _table("What the operator commanded", ("at (s)", "command", "taken", "said"), rows_of, ORDERS)
        parts.append(f"<p>An operator took part; without the same orders the flight is another.</p>{table}")
    if summary is not None:
        same = (
            "The digest in again/summary.json is then the one below."
            if summary.digest
            else "There is no digest: vehicles took part whose flight never repeats."
        )
        parts.append(f"<p>{same}</p>")
        facts = [("scenario", summary.scenario), ("seed", summary.seed), ("clock", summary.clock)]
        facts += [("digest", summary.digest), *summary.versions.items()]
        rows = "".join(f"<tr><th>{escape(k)}</th><td>{escape(str(v))}</td></tr>" for k, v in facts)
        parts.append(f'<table class="goal">{rows}</table>')
    if found.scenario is not None:
        source = (found.recorded.folder / "scenario.yaml").read_text(encoding="utf-8", errors="replace")
        parts.append(f"<details><summary>scenario.yaml, as flown</summary><pre>{escape(source)}</pre></details>")
    return "".join(parts)
