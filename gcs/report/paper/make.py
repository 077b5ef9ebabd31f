"""`gcs paper`: fly the examples, measure, judge, and write the page.

scenario → `gcs run` → recorded session ┐
`simvehicle paper` → its numbers        ├→ studies → claims judged → figures, claims.json, index.html
planner and competition alone           ┘
"""

from __future__ import annotations

import shutil
import subprocess
import time
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import Any

from numpy.typing import NDArray
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

from gcs.processes.python import start_python
from gcs.report.paper import (
    claims,
    examples,
    figures,
    flown,
    loop,
    page,
    races,
    readings,
    robustness,
    sensitivity,
    session,
    theory,
    vehicle,
)
from gcs.report.paper.claims import Claim, Judged, Reason
from gcs.report.paper.study import Measurement, PaperError, Study
from gcs.scenario import file
from gcs.scenario.file import load
from gcs.scenario.model import Scenario

EXAMPLES = {
    "example1": examples.example1,
    "example2": examples.example2,
    "example3": examples.example3,
    "example4": examples.example4,
    "example1-literal": flown.literal,
    "example4-energy": loop.example4_energy,
    "pursuit": loop.pursuit,
}
"""Parts that are flown, each as the scenario of its name."""
RACES = {"fig13": robustness.fig13, "fig14": robustness.fig14, "readings": readings.readings}
THEORY = {"fig3": theory.fig3, "fig6": theory.fig6, "loops": theory.loops}
TITLES = {
    "example1": "Example 1: five speeds (Figs. 7, 8)",
    "example2": "Example 2: three starts (Fig. 9)",
    "example3": "Example 3: fifteen vehicles (Fig. 10)",
    "example4": "Example 4: refuelling (Fig. 11)",
    "fig3": "Fuzzy escape (Fig. 3)",
    "fig5": "Differentiator (Fig. 5)",
    "fig6": "Norms (Fig. 6)",
    "loops": "Order of the loops (Section III-B)",
    "fig12": "Differentiators compared (Fig. 12)",
    "implicit": "Chattering, and why implicit",
    "noise": "Differentiators in flight, on an estimate that errs",
    "fig13": "Noise (Fig. 13)",
    "fig14": "Delay (Fig. 14)",
    "readings": "Other readings of the competition (Figs. 10, 13, 14)",
    "example1-literal": "Example 1, eqs. 4 and 17 to the letter",
    "pursuit": "The loop closed: a moving target",
    "example4-energy": "The loop closed: Example 4 by control energy",
    "sensitivity": "What the text does not determine (Examples 2, 3, 4)",
}
SENSITIVITY = "sensitivity"
AT_ONCE = 2
"""Sessions and programs that run beside each other: a lockstep session leaves a second core half idle."""
ALIASES = {"fig7": "example1", "fig8": "example1", "fig9": "example2", "fig10": "example3", "fig11": "example4"}
PARTS = tuple(TITLES)
LOOSE = ("pursuit",)
"""Scenarios that do not lie in `paper/`."""
OWN, UNPRINTED = "the vehicle's own figures", "what is not printed: flown"
UNFINISHED = ("lost", "interrupted", "duration")


def chosen(only: str | None) -> list[str]:
    """The parts that `--only` names, in the page's order; all without it. Raises ValueError with the known names."""
    if only is None:
        return list(PARTS)
    names = [name.strip() for name in only.split(",")]
    for name in names:
        if name not in TITLES and name not in ALIASES:
            raise ValueError(f"there is no part '{name}'; choose from {', '.join((*PARTS, *ALIASES))}")
    wanted = {ALIASES.get(name, name) for name in names}
    return [part for part in PARTS if part in wanted]


def default_folder() -> Path:
    """A new folder's name, by the time."""
    return Path(f"paper-{datetime.now().astimezone():%Y%m%d-%H%M%S}")


def make(out: Path, parts: Sequence[str], console: Console) -> list[Judged]:
    """Do these parts in the new folder `out`; every claim of them, judged.

    Raises:
        FileExistsError: `out` is there already.
        OSError: a file cannot be written.
        PaperError: an example did not fly to its end, or `simvehicle paper` failed.
    """
    begun_s = time.monotonic()
    out.mkdir(parents=True)
    to_fly = [name for name in EXAMPLES if name in parts]
    if any(part in RACES for part in parts) and "example3" not in to_fly:
        to_fly.append("example3")
    drawn = [name for name in vehicle.NAMES if name in parts]
    table, reasons = claims.load(), claims.reasons()
    with _progress(console) as progress:
        jobs = len(to_fly) + bool(drawn) + (SENSITIVITY in parts)
        task = progress.add_task("", total=jobs + len(parts) + 1)

        def step(what: str) -> None:
            progress.update(task, description=what, advance=1)

        progress.update(task, description="flying")
        work: dict[str, Callable[[], Any]] = {
            f"{name}: flown": partial(fly, name, out / "sessions" / name) for name in to_fly
        }
        work |= {OWN: partial(_vehicle_figures, out, drawn)} if drawn else {}
        work |= {UNPRINTED: partial(_energies, out)} if SENSITIVITY in parts else {}
        results = _all_done(work, step)
        scenarios: dict[str, Scenario] = {name: results[f"{name}: flown"] for name in to_fly}
        numbers = results.get(OWN, {})
        sections = []
        with figures.style():
            for part in parts:
                progress.update(task, description=f"{part}: measuring")
                if part == SENSITIVITY:
                    study = sensitivity.study(*results[UNPRINTED])
                else:
                    study = _study(part, out, scenarios, numbers)
                sections.append(_section(part, study, out, table, reasons))
                step(f"{part}: measured")
        judged = [one for section in sections for one in section.claims]
        claims.write(judged, out)
        when = f"{datetime.now().astimezone():%Y-%m-%d %H:%M}"
        page.write(out / "index.html", sections, when=when, wall_s=time.monotonic() - begun_s)
        step("written")
    return judged


def fly(name: str, folder: Path) -> Scenario:
    """Fly a shipped example by `gcs run`, the whole program, into `folder`. Raises PaperError with its last words."""
    scenario = name if name in LOOSE else f"paper/{name}"
    options = ("--lockstep", "--plain", "--no-report", "--out", str(folder))
    with start_python("gcs", "run", scenario, *options, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        said, complained = (stream.decode(errors="replace").strip() for stream in process.communicate())
    if not (folder / "summary.json").exists():
        last = (complained or said or "no words").splitlines()[-1]
        raise PaperError(f"{scenario} was not flown to its end (status {process.returncode}): {last}")
    outcome = session.summary(folder)["outcome"]
    if outcome in UNFINISHED:
        raise PaperError(f"{scenario} was not flown to its end ({outcome}); {folder} has what there is")
    return load(file.find(scenario))


def _all_done(work: Mapping[str, Callable[[], Any]], step: Callable[[str], None]) -> dict[str, Any]:
    """Do all of it, AT_ONCE at a time; the results, by name. Raises what the first one that fails does."""
    with ThreadPoolExecutor(AT_ONCE) as pool:
        futures = {pool.submit(job): name for name, job in work.items()}
        try:
            for future in as_completed(futures):
                future.result()
                step(futures[future])
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise
    return {name: future.result() for future, name in futures.items()}


def _energies(out: Path) -> tuple[dict[str, NDArray[Any]], dict[str, list[int]]]:
    """Energies under what is not printed, and the lengths of the plans that were flown for them."""
    inside = out / "sensitivity"
    inside.mkdir()
    plans = inside / "plans.json"
    lengths = sensitivity.write_plans(plans)
    return vehicle.energies(inside, plans), lengths


def _vehicle_figures(out: Path, names: list[str]) -> dict[str, dict[str, object]]:
    """Numbers by figure; the figures' files come to lie in `out`, beside the others."""
    inside = out / "vehicle"
    numbers = vehicle.make(inside, names)
    for name in names:
        for ending in ("svg", "png"):
            shutil.move(inside / f"{name}.{ending}", out / f"{name}.{ending}")
    return numbers


def _study(part: str, out: Path, scenarios: dict[str, Scenario], numbers: dict[str, dict[str, object]]) -> Study:
    if part in EXAMPLES:
        return EXAMPLES[part](scenarios[part], out / "sessions" / part)
    if part in RACES:
        flights = session.flights_of(scenarios["example3"], out / "sessions" / "example3")
        return RACES[part](races.initial_states(flights), races.least_wins(races.efforts(flights)))
    if part in THEORY:
        return THEORY[part]()
    return vehicle.STUDIES[part](numbers[part])


def _section(part: str, study: Study, out: Path, table: Sequence[Claim], reasons: Mapping[str, Reason]) -> page.Section:
    for drawing in study.drawings:
        figures.save(drawing, out)
    images = [page.Image(out / f"{drawing.name}.svg", drawing.caption) for drawing in study.drawings]
    if part in vehicle.CAPTIONS:
        images.append(page.Image(out / f"{part}.svg", vehicle.CAPTIONS[part]))
    unmeasured = Measurement(None)
    of_part = [claim for claim in table if claim.part == part]
    judged = [claims.judge(claim, study.measured.get(claim.id, unmeasured), reasons) for claim in of_part]
    return page.Section(part, TITLES[part], judged, images, study.tables)


def _progress(console: Console) -> Progress:
    columns = (BarColumn(), MofNCompleteColumn(), TimeElapsedColumn(), TextColumn("{task.description}"))
    return Progress(*columns, console=console)
