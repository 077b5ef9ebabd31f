"""Table of faults: `make faults` flies sessions with something going wrong, and says what is left of each.

A row is one fault at so many random moments, by seed: SIGKILL and SIGSTOP of each kind of process, loss, delay,
blackouts, a full disk. Its columns are the outcomes, the least separation, joules that were lost, whether every reader
opens what was left, and processes that still lived 3 s after the end. Status 1 where a reader failed or a process was
left.
"""

from __future__ import annotations

import argparse
import random
import signal
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))

from sessions import GCS, Outcome, Running, all_gone, fly, small  # noqa: E402

DURATION_S = 30.0
SPEED = 10.0
AWAY_S = 4.0
"""A process that was stopped goes on after so long, except a vehicle's, which is given up."""
ORPHANS_WITHIN_S = 3.0
PURSUER, TARGET, TANKER = 1, 101, 201


@dataclass
class Row:
    """One fault, over all its moments."""

    name: str
    outcomes: Counter[str] = field(default_factory=Counter)
    separation_m: float = float("inf")
    lost_j: float = 0.0
    unread: int = 0
    orphans: int = 0

    def add(self, folder: Path, outcome: Outcome | None, orphans: int) -> None:
        """Count one session."""
        self.orphans += orphans
        if (folder / "summary.json").exists():
            summary = Outcome(0, folder, "", "").summary
            self.outcomes[summary["outcome"]] += 1
            self.separation_m = min(self.separation_m, summary["min_separation_m"] or float("inf"))
            self.lost_j = max(self.lost_j, sum(one["energy"]["lost_j"] for one in summary["vehicles"]))
        else:
            self.outcomes["no summary" if outcome is None or outcome.status != 2 else "refused"] += 1
        self.unread += sum(not opens for opens in opened(folder))

    def text(self) -> str:
        """The row, as Markdown."""
        outcomes = ", ".join(f"{count} {name}" for name, count in self.outcomes.most_common())
        separation = "-" if self.separation_m == float("inf") else f"{self.separation_m:.2f}"
        return f"| {self.name} | {outcomes} | {separation} | {self.lost_j:.0f} | {self.unread} | {self.orphans} |"


def opened(folder: Path) -> Iterator[bool]:
    """Whether each reader opens what a session left."""
    out = folder.parent / "read"
    for command in (
        ["report", str(folder), "--out", f"{out}.html"],
        ["export", str(folder), "--format", "csv", "--out", str(out)],
        ["replay", str(folder), "--plain", "--speed", "1000"],
    ):
        done = subprocess.run(
            [*GCS, *command], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False
        )
        if done.returncode:
            print(f"  {command[0]} of {folder}: status {done.returncode}, {done.stderr.strip()[-300:]}", flush=True)
        yield done.returncode == 0


def signalled(row: Row, folder: Path, moment_s: float, whose: Callable[[Running], Any], what: signal.Signals) -> None:
    """A session in which a process gets a signal at a moment."""
    content = small(clock={"mode": "real", "speed": SPEED}, goal={"duration_s": DURATION_S, "refuelled_at_least": 0})
    running = Running(content, folder, "--json")
    outcome = None
    try:
        running.wait_for(lambda seen: bool(seen["t_s"] >= moment_s))
        family, victim = running.family(), whose(running)
        victim.send_signal(what)
        if what is signal.SIGSTOP:
            subprocess.run(["sleep", str(AWAY_S)], check=True)
            victim.send_signal(signal.SIGCONT)
        outcome = running.finish()
        orphans = len(all_gone(family, ORPHANS_WITHIN_S))
    finally:
        running.stop()
    row.add(running.folder, outcome, orphans)


def impaired(row: Row, folder: Path, **changes: Any) -> None:
    """A session in lockstep whose scenario is changed."""
    content = small(goal={"duration_s": DURATION_S, "refuelled_at_least": 0}, **changes)
    outcome = fly(content, folder, "--plain")
    row.add(outcome.folder, outcome, 0)


def filled(row: Row, folder: Path, limit: int) -> None:
    """A session none of whose files may grow beyond a limit, as on a full disk."""
    content = small(goal={"duration_s": DURATION_S, "refuelled_at_least": 0})
    outcome = fly(content, folder, "--plain", file_limit=limit)
    row.add(outcome.folder, outcome, 0)


PROCESSES: dict[str, Callable[[Running], Any]] = {
    "gcs run": lambda session: session.family()[0],
    "supervisor": lambda session: session.named("gcs.session.process"),
    "hatch": lambda session: session.named("hatch"),
    "pursuer": lambda session: session.vehicle(PURSUER),
    "tanker": lambda session: session.vehicle(TANKER),
}
OFF = {"enabled": False}


def jobs(moments: int, seed: int) -> Iterator[tuple[str, list[Callable[[Row, Path], None]]]]:
    """(name, sessions) of each row."""
    stream = random.Random(seed)
    for name, whose in PROCESSES.items():
        for what in (signal.SIGKILL, signal.SIGSTOP):
            times = [stream.uniform(0.5, DURATION_S - 2.0) for _ in range(moments)]
            yield (
                f"{what.name} of {name}",
                [lambda row, at, t=t, w=whose, s=what: signalled(row, at, t, w, s) for t in times],
            )
    for loss in (0.1, 0.3, 0.5):
        yield f"{loss:.0%} of all frames lost", [lambda row, at, x=loss: impaired(row, at, radio={"loss": x})]
    yield "0.2 s of delay", [lambda row, at: impaired(row, at, radio={"delay_s": 0.2})]
    yield "0.5 s of delay, no refuelling", [lambda row, at: impaired(row, at, radio={"delay_s": 0.5}, refuelling=OFF)]
    for sysid, who in ((PURSUER, "pursuer"), (TANKER, "tanker")):
        dark = [
            {"fault": "blackout", "sysid": sysid, "between_s": [2.0, 20.0], "for_s": 8.0},
        ]
        yield (
            f"blackout of {who} for 8 s",
            [lambda row, at, k=k, d=dark: impaired(row, at, faults=d, seed=seed + k) for k in range(moments)],
        )
    limits = [stream.randrange(20_000, 300_000) for _ in range(moments)]
    yield "full disk", [lambda row, at, x=limit: filled(row, at, x) for limit in limits]


def main() -> int:
    """Fly the table; 0 where everything could be read and nothing was left running."""
    says = argparse.ArgumentParser(description=__doc__)
    says.add_argument("--moments", type=int, default=20, help="random moments of each row")
    says.add_argument("--seed", type=int, default=1)
    says.add_argument("--only", default="", help="rows with one of these words, separated by commas")
    options = says.parse_args()
    words = options.only.split(",")
    bad = 0
    print("| fault | outcomes | least separation (m) | most joules lost | readers that failed | left running |")
    print("|---|---|---|---|---|---|", flush=True)
    for name, sessions in jobs(options.moments, options.seed):
        if not any(word in name for word in words):
            continue
        row = Row(name)
        for session in sessions:
            with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as place:
                session(row, Path(place))
        bad += row.unread + row.orphans
        print(row.text(), flush=True)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
