"""Table of faults: `make faults` flies sessions with something going wrong, and says what is left of each.

A row is one fault at so many random moments, by seed: SIGKILL and SIGSTOP of each kind of process, loss, delay,
blackouts, a full disk. Its columns are the outcomes, the least separation, joules that were lost, how far the recording
reaches beyond the fault, whether every reader opens what was left, and processes that still lived 3 s after the end.

What has been flown is kept, a line of JSON per session, and not flown again: the table can be made in pieces. `--write`
puts it into docs/faults.md. Status 1 where a reader failed or a process was left.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT), str(ROOT / "tests" / "support")]

from sessions import Outcome, Running, all_gone, fly, small  # noqa: E402

from gcs.cli.main import run_argv  # noqa: E402
from gcs.session.replay import Replay, ReplayError  # noqa: E402

DURATION_S = 30.0
IMPAIRED_S = 60.0
SPEED = 4.0
LATEST_S = DURATION_S - 2.0 * SPEED
"""A session tells its time once a second of the wall: no later, or it may have ended."""
AWAY_S = 4.0
"""A process that was stopped goes on after so long, except a vehicle's, which is given up."""
ORPHANS_WITHIN_S = 3.0
PURSUER, TARGET, TANKER = 1, 101, 201
LARGEST_BATTERY_J = 16_700_000.0
"""Nearly the largest that a scenario may have: of so little power it lasts for over 24 h, and nobody needs a tanker."""
PAGE = ROOT / "docs" / "faults.md"
BEGINS, ENDS = "<!-- make faults -->\n", "<!-- /make faults -->\n"
KEPT = ROOT / ".faults.jsonl"


@dataclass
class Flown:
    """What is left of one session."""

    row: str
    number: int
    outcome: str
    separation_m: float | None = None
    lost_j: float = 0.0
    after_s: float | None = None
    """how far the recording reaches beyond the moment of the fault; None where it has no moment"""
    unread: list[str] = field(default_factory=list)
    orphans: int = 0


@dataclass
class Row:
    """One fault, over all its moments."""

    name: str
    flown: list[Flown] = field(default_factory=list)

    def text(self) -> str:
        """The row, as Markdown."""
        outcomes = ", ".join(
            f"{count} {name}" for name, count in Counter(one.outcome for one in self.flown).most_common()
        )
        lost_j = max(one.lost_j for one in self.flown)
        unread, orphans = sum(len(one.unread) for one in self.flown), sum(one.orphans for one in self.flown)
        separation = _least((one.separation_m for one in self.flown), "{:.2f}")
        after = _least((one.after_s for one in self.flown), "{:+.1f}")
        return f"| {self.name} | {outcomes} | {separation} | {lost_j:.0f} | {after} | {unread} | {orphans} |"


def _least(numbers: Iterator[float | None], form: str) -> str:
    known = [number for number in numbers if number is not None]
    return form.format(min(known)) if known else "-"


def judged(row: str, number: int, folder: Path, outcome: Outcome | None, *, fault_s: float | None = None) -> Flown:
    """A session that has ended, by its folder."""
    flown = Flown(row, number, "no summary" if outcome is None or outcome.status != 2 else "refused")
    if (folder / "summary.json").exists():
        summary = Outcome(0, folder, "", "").summary
        flown.outcome, flown.separation_m = summary["outcome"], summary["min_separation_m"]
        flown.lost_j = sum(one["energy"]["lost_j"] for one in summary["vehicles"])
    if folder.exists():
        flown.unread = unread(folder)
        if fault_s is not None and "replay" not in flown.unread:
            with contextlib.suppress(ReplayError):
                flown.after_s = Replay(folder).to_s - fault_s
    return flown


def unread(folder: Path) -> list[str]:
    """Readers that end with an error of the program on what a session left, or do not say what is wrong with it."""
    out = folder.parent / "read"
    failed = []
    for command in (
        ["report", str(folder), "--out", f"{out}.html"],
        ["export", str(folder), "--format", "csv", "--out", str(out)],
        ["replay", str(folder), "--plain", "--speed", "1000"],
    ):
        status, said = called(command)
        nothing = (folder / "session.tlog").stat().st_size == 0 if (folder / "session.tlog").exists() else True
        if status and not (nothing and status == 2 and said):
            print(f"  {command[0]} of {folder}: status {status}, {said[-300:]}", flush=True)
            failed.append(command[0])
    return failed


def called(arguments: list[str]) -> tuple[int, str]:
    """`gcs` with these arguments in a process that has everything loaded; its status, and what it said on stderr."""
    read, write = os.pipe()
    if (pid := os.fork()) == 0:
        os.close(read)
        os.dup2(write, 2)
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        status = 70
        try:
            status = run_argv(arguments)
        finally:
            sys.stderr.flush()
            os._exit(status)
    os.close(write)
    with open(read, encoding="utf-8", errors="replace") as pipe:
        said = pipe.read()
    return os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]), said.strip()


def signalled(
    row: str, number: int, folder: Path, moment_s: float, whose: Callable[[Running], Any], what: signal.Signals
) -> Flown:
    """A session in which a process gets a signal at a moment."""
    content = small(clock={"mode": "real", "speed": SPEED}, goal={"duration_s": DURATION_S, "refuelled_at_least": 0})
    running = Running(content, folder, "--json")
    outcome, orphans, seen = None, 0, {"t_s": 0.0}
    try:
        seen = running.wait_for(lambda seen: bool(seen["t_s"] >= moment_s))
        family, victim = running.family(), whose(running)
        victim.send_signal(what)
        if what is signal.SIGSTOP:
            subprocess.run(["sleep", str(AWAY_S)], check=True)
            with contextlib.suppress(ProcessLookupError):
                victim.send_signal(signal.SIGCONT)
        outcome = running.finish()
        orphans = len(all_gone(family, ORPHANS_WITHIN_S))
    finally:
        running.stop()
    flown = judged(row, number, running.folder, outcome, fault_s=seen["t_s"])
    flown.orphans = orphans
    return flown


def impaired(row: str, number: int, folder: Path, **changes: Any) -> Flown:
    """A session in lockstep whose scenario is changed, with a seed of its own."""
    content = small(goal={"duration_s": IMPAIRED_S, "refuelled_at_least": 0}, seed=number, **changes)
    outcome = fly(content, folder, "--plain")
    return judged(row, number, outcome.folder, outcome)


def filled(row: str, number: int, folder: Path, size: int) -> Flown:
    """A session on a disk of so many bytes, which becomes full."""
    content = small(goal={"duration_s": DURATION_S, "refuelled_at_least": 0})
    disk = folder / "disk"
    disk.mkdir()
    subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(disk)], check=True)
    try:
        outcome = fly(content, disk, "--plain")
        kept = folder / "kept"
        kept.mkdir()
        if outcome.folder.exists():
            subprocess.run(["cp", "-a", str(outcome.folder), str(kept)], check=True)
        return judged(row, number, kept / outcome.folder.name, outcome)
    finally:
        subprocess.run(["umount", "-l", str(disk)], check=True)


def long(row: str, number: int, folder: Path, hours: float) -> Flown:
    """A session of hours in lockstep, whose batteries last; its outcome says how much faster than the clock it flew."""
    everyone = {"battery": {"capacity_j": LARGEST_BATTERY_J, "hover_w": 50.0, "avionics_w": 10.0}}  # 5.2 MJ a day
    content = small(
        goal={"duration_s": 3600.0 * hours, "refuelled_at_least": 0},
        record={"decisions": "changes", "truth_hz": 1.0, "rotate_mb": 50, "keep": 4},
    )
    for group in ("pursuers", "targets", "tankers"):
        content["vehicles"][group] = [{**one, **everyone} for one in content["vehicles"][group]]
    running = Running(content, folder, "--plain")
    try:
        running.process.communicate()
    finally:
        running.stop()
    flown = judged(row, number, running.folder, Outcome(running.process.returncode, running.folder, "", ""))
    if (running.folder / "summary.json").exists():
        summary = json.loads((running.folder / "summary.json").read_text(encoding="utf-8"))
        flown.outcome += f" (at {summary['speed_achieved']:.0f} times the clock)"
    return flown


def can_mount() -> bool:
    """Whether a small disk can be made here."""
    with tempfile.TemporaryDirectory() as place:
        mounted = subprocess.run(
            ["mount", "-t", "tmpfs", "-o", "size=1m", "tmpfs", place], stderr=subprocess.DEVNULL, check=False
        )
        if mounted.returncode == 0:
            subprocess.run(["umount", place], check=True)
    return mounted.returncode == 0


PROCESSES: dict[str, Callable[[Running], Any]] = {
    "gcs run": lambda session: session.family()[0],
    "supervisor": lambda session: session.named("gcs.session.process"),
    "fork server": lambda session: session.named("fork-server"),
    "pursuer": lambda session: session.vehicle(PURSUER),
    "tanker": lambda session: session.vehicle(TANKER),
}
RADIOS: dict[str, dict[str, Any]] = {
    "10 % of all frames lost": {"radio": {"loss": 0.1}},
    "30 % of all frames lost": {"radio": {"loss": 0.3}},
    "50 % of all frames lost": {"radio": {"loss": 0.5}},
    "0.2 s of delay": {"radio": {"delay_s": 0.2}},
    "0.2 s of delay, 20 % lost": {"radio": {"delay_s": 0.2, "loss": 0.2}},
    "up to 0.4 s of jitter": {"radio": {"jitter_s": 0.4}},
    "0.5 s of delay, no refuelling": {
        "radio": {"delay_s": 0.5},
        "refuelling": {"enabled": False},
        "vehicles": {
            "pursuers": [{"sysid": PURSUER, "start_m": [2.0, 0.0, 0.0], "battery": {"capacity_j": 24000}}],
        },
    },
}
Session = Callable[[str, int, Path], Flown]


def jobs(moments: int, seed: int, hours: float) -> Iterator[tuple[str, list[Session]]]:
    """(name, sessions) of each row; the first of more moments are those of fewer."""
    if hours:
        yield f"none, {hours:g} h of session time", [lambda row, n, at: long(row, n, at, hours)]
    for name, whose in PROCESSES.items():
        for what in (signal.SIGKILL, signal.SIGSTOP):
            title = f"{what.name} of {name}"
            stream = random.Random(f"{seed} {title}")
            times = [stream.uniform(0.5, LATEST_S) for _ in range(moments)]
            yield (
                title,
                [lambda row, n, at, t=t, w=whose, s=what: signalled(row, n, at, t, w, s) for t in times],
            )
    for title, changes in RADIOS.items():
        yield title, [lambda row, n, at, c=changes: impaired(row, n, at, **c)] * moments
    for sysid, who in ((PURSUER, "pursuer"), (TANKER, "tanker")):
        dark = [{"fault": "blackout", "sysid": sysid, "between_s": [2.0, 20.0], "for_s": 8.0}]
        yield (
            f"blackout of {who} for 8 s",
            [lambda row, n, at, d=dark: impaired(row, n, at, faults=d)] * moments,
        )
    if can_mount():
        stream = random.Random(f"{seed} full disk")
        sizes = [4096 * stream.randrange(8, 160) for _ in range(moments)]
        yield "full disk", [lambda row, n, at, x=size: filled(row, n, at, x) for size in sizes]
    else:
        print("full disk: not flown, for no small disk can be mounted here (run it as root)", file=sys.stderr)


def flown(row: str, number: int, session: Session) -> Flown:
    """One session, in a folder that goes."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as place:
        try:
            return session(row, number, Path(place))
        except subprocess.TimeoutExpired:
            return Flown(row, number, "too slow")
        except AssertionError:  # it had ended before the moment came: a machine too busy to fly at this pace
            return Flown(row, number, "too late")


def table(rows: list[Row]) -> str:
    """All rows, as Markdown."""
    lines = [
        "| fault | outcomes | least separation (m) | most joules lost | recorded beyond the fault (s) "
        "| readers that failed | left running |",
        "|---|---|---|---|---|---|---|",
        *(row.text() for row in rows if row.flown),
    ]
    return "\n".join(lines) + "\n"


def main() -> int:
    """Fly the table; 0 where everything could be read and nothing was left running."""
    says = argparse.ArgumentParser(description=__doc__)
    says.add_argument("--moments", type=int, default=20, help="random moments of each row")
    says.add_argument("--seed", type=int, default=1)
    says.add_argument("--hours", type=float, default=24.0, help="session time of the one long session; 0: none")
    says.add_argument("--only", default="", help="rows with one of these words, separated by commas")
    says.add_argument("--kept", type=Path, default=KEPT, help="what has been flown, and is not flown again")
    says.add_argument("--again", action="store_true", help="forget what has been flown")
    says.add_argument("--write", action="store_true", help=f"put the table into {PAGE.relative_to(ROOT)}")
    options = says.parse_args()
    if options.again:
        options.kept.unlink(missing_ok=True)
    lines = options.kept.read_text(encoding="utf-8").splitlines() if options.kept.exists() else []
    known = {(one.row, one.number): one for one in (Flown(**json.loads(line)) for line in lines)}
    all_jobs = list(jobs(options.moments, options.seed, options.hours))
    wanted = [job for job in all_jobs if any(word in job[0] for word in options.only.split(","))]
    for number in range(options.moments):  # a moment of every row first: what is stopped early is a smaller table
        for name, sessions in wanted:
            if (name, number) in known or number >= len(sessions):
                continue
            one = known[name, number] = flown(name, number, sessions[number])
            with options.kept.open("a", encoding="utf-8") as kept:
                kept.write(json.dumps(asdict(one)) + "\n")
            print(f"{name}, {number}: {one.outcome}", file=sys.stderr, flush=True)
    rows = [Row(name, [one for one in known.values() if one.row == name]) for name, _ in all_jobs]
    print(table(rows), end="")
    if options.write:
        page = PAGE.read_text(encoding="utf-8")
        before, after = page.index(BEGINS) + len(BEGINS), page.index(ENDS)
        PAGE.write_text(page[:before] + table(rows) + page[after:], encoding="utf-8")
    return 1 if any(one.unread or one.orphans for one in known.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
