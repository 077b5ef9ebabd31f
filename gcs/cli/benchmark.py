"""`gcs benchmark`: refuelling instances, and judgements of schedules."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import itertools
import json
from pathlib import Path

import click

from gcs.cli.author import SET, ScenarioName, load_scenario
from skytender.exit import BAD_INPUT, DONE, NOT_DONE

FILE = click.Path(path_type=Path, dir_okay=False, exists=True)


@click.group(short_help="Make refuelling instances, and judge schedules of them.")
def benchmark() -> None:
    """Refuelling schedules of any program, compared: instances, and an independent verifier.

    The format, the rules and how sessions are turned into instances: docs/refuelling-benchmark.md.
    """


@benchmark.command(short_help="Write the 300 instances into a folder.")
@click.argument("folder", type=click.Path(path_type=Path, file_okay=False))
@click.option("--kind", type=click.Choice(("tankers", "reloads", "bases")), help="Only these 100.")
@click.option("--tuning", is_flag=True, help="300 others of the same kinds, to choose a method's parameters on.")
def make(folder: Path, kind: str | None, tuning: bool) -> int:
    """Write the instances into FOLDER, a JSON file each; the same bytes on every machine.

    \b
    Examples:
      gcs benchmark make instances
      gcs benchmark make others --tuning
      gcs benchmark make instances --kind reloads

    \b
    Exit status:
      0    they were written
      2    FOLDER cannot be written
    """
    from gcs.benchmark.format import raw
    from gcs.benchmark.generator import instances

    count = 0
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for one in instances(tuning):
            if kind in (None, one.kind):
                (folder / f"{one.name}.json").write_bytes(raw(one))
                count += 1
    except OSError as error:
        raise click.UsageError(f"{error.filename or folder} cannot be written: {error.strerror}.") from None
    click.echo(f"{count} instances in {folder}")
    return DONE


@benchmark.command(short_help="Say whether a schedule can be carried out, and which vehicles it loses.")
@click.argument("instance", type=FILE)
@click.argument("schedule", type=FILE)
@click.option("--json", "as_json", is_flag=True, help="The verdict as one JSON object.")
def verify(instance: Path, schedule: Path, as_json: bool) -> int:
    """Judge SCHEDULE, which any program may have made, of INSTANCE.

    \b
    Examples:
      gcs benchmark verify instances/tankers-042.json mine.json
      gcs benchmark verify instances/tankers-042.json mine.json --json

    \b
    Exit status:
      0    it can be carried out
      1    it cannot; the reasons are printed
      2    a file cannot be read
    """
    from gcs.benchmark import format, verifier

    try:
        given, made = format.read(instance, format.Instance), format.read(schedule, format.Schedule)
    except format.FormatError as error:
        click.echo(f"gcs: {error}", err=True)
        return BAD_INPUT
    if made.instance != given.name:
        click.echo(f"gcs: {schedule} is a schedule of {made.instance!r}, and {instance} is {given.name!r}", err=True)
        return BAD_INPUT
    verdict = verifier.verify(format.plain(given), format.plain(made))
    if as_json:
        click.echo(json.dumps(verdict))
        return DONE if verdict["feasible"] else NOT_DONE
    for problem in verdict["problems"]:
        click.echo(problem)
    if verdict["feasible"]:
        lost = ", ".join(f"{one['receiver']} at {one['at_s']:.1f} s" for one in verdict["lost"])
        click.echo(f"feasible: lost {len(verdict['lost'])} of {len(given.receivers)}{f' ({lost})' if lost else ''}")
        click.echo(
            f"delivered {verdict['delivered_j'] / 1e3:.1f} kJ, tankers flew {verdict['way_m']:.1f} m, "
            f"waited {verdict['idle_s']:.1f} s"
        )
    else:
        click.echo(f"not feasible: {len(verdict['problems'])} problems")
    return DONE if verdict["feasible"] else NOT_DONE


@benchmark.command(short_help="Find a schedule, and a proven bound on what any schedule loses.")
@click.argument("instances", type=FILE, nargs=-1, required=True, metavar="INSTANCE...")
@click.option("--seconds", type=click.FloatRange(min=0.1), default=60.0, show_default=True, help="For each instance.")
@click.option("--out", type=click.Path(path_type=Path, dir_okay=False), help="Write the schedule there.")
@click.option(
    "--table",
    type=click.Path(path_type=Path, dir_okay=False),
    help="Append a JSON line for each instance; skip instances that are in the file.",
)
def solve(instances: tuple[Path, ...], seconds: float, out: Path | None, table: Path | None) -> int:
    """Find a schedule of each INSTANCE that the verifier accepts, and prove how many receivers any schedule loses at
    least. Where both are the same, the schedule is an optimum. The limit is processor time of one thread. Where no
    schedule is found that can be carried out, none is written, and the table has `null` for what it loses.

    A bound above 0 needs OR-Tools, of the extra `benchmark`.

    \b
    Examples:
      gcs benchmark solve instances/tankers-042.json --out mine.json
      gcs benchmark solve instances/*.json --seconds 10 --table gaps.jsonl

    \b
    Exit status:
      0    the schedules are proven optima
      1    a gap is left, or no schedule was found
      2    a file cannot be read, or OR-Tools is needed and missing
    """
    from gcs.benchmark import format, gaps
    from gcs.benchmark.solve import solve as solved
    from gcs.extras import MissingExtra

    if out is not None and len(instances) > 1:
        raise click.UsageError("--out takes the schedule of one instance; name one, or leave it out.")
    left = 0
    try:
        known = {one.instance for one in gaps.read(table, gaps.Gap)} if table is not None else set()
        for path in instances:
            given = format.read(path, format.Instance)
            if given.name in known:
                continue
            gap, schedule = solved(given, seconds)
            left += not gap.proven
            if out is not None and gap.upper is not None:
                out.write_bytes(format.raw(schedule))
            if table is not None:
                gaps.add(table, gap)
            found, what = f"lost {gap.upper} of {len(given.receivers)}", f"at least {gap.lower}"
            if gap.upper is None:
                found = "found no schedule that can be carried out"
                what = f"any would lose at least {gap.lower} of {len(given.receivers)}"
            click.echo(f"{gap.instance}: {found}, {'proven' if gap.proven else what}, {gap.cpu_s:.1f} s")
    except (format.FormatError, MissingExtra) as error:
        click.echo(f"gcs: {error}", err=True)
        return BAD_INPUT
    except OSError as error:
        raise click.UsageError(f"{error.filename} cannot be written: {error.strerror}.") from None
    return NOT_DONE if left else DONE


@benchmark.command(short_help="One table of methods on the same instances.")
@click.option("--methods", multiple=True, help="One of them; can be given more than once. All by default.")
@click.option("--seconds", type=click.FloatRange(min=0.1), default=5.0, show_default=True, help="For each instance.")
@click.option("--instances", type=click.Path(path_type=Path, file_okay=False, exists=True), help="A folder of them.")
@click.option(
    "--table",
    "results_file",
    type=click.Path(path_type=Path, dir_okay=False),
    help="Append a JSON line for each result; reuse results that are in the file.",
)
def compare(methods: tuple[str, ...], seconds: float, instances: Path | None, results_file: Path | None) -> int:
    """Let schedulers make a schedule of each instance, judge it, and print one table: how often a method loses a
    receiver, how many it loses, how many more than the proven optimum, energy, way and processor time, which --seconds
    limits. Without --instances, every fifth of the 300.

    \b
    Examples:
      gcs benchmark compare --table results.jsonl
      gcs benchmark compare --methods optimal --methods cp_sat --seconds 10 --instances instances

    \b
    Exit status:
      0    the table was printed
      2    a method or a file is wrong, or a package is missing
    """
    from gcs.benchmark import compare as table
    from gcs.benchmark import format, gaps
    from gcs.extras import MissingExtra, require

    wrong = [one for one in methods if one not in table.METHODS]
    if wrong:
        raise click.UsageError(f"{wrong[0]!r} is no method; there are {', '.join(table.METHODS)}.")
    try:
        require("a table of methods", {"scipy": "SciPy"}, "benchmark")
        files = sorted(instances.glob("*.json")) if instances is not None else []
        if instances is not None and not files:
            raise click.UsageError(f"{instances} has no JSON file of an instance.")
        given = [format.read(path, format.Instance) for path in files] or table.sample()
        rows = gaps.read(results_file, table.Result) if results_file is not None else []
        known = {(row.method, row.instance): row for row in rows if row.seconds == seconds}
        results: dict[str, list[table.Result]] = {}
        for method, one in itertools.product(methods or table.METHODS, given):
            row = known.get((method, one.name)) or table.run(method, one, seconds)
            if results_file is not None and (method, one.name) not in known:
                gaps.add(results_file, row)
            results.setdefault(method, []).append(row)
    except (format.FormatError, MissingExtra) as error:
        click.echo(f"gcs: {error}", err=True)
        return BAD_INPUT
    except OSError as error:
        raise click.UsageError(f"{error.filename} cannot be written: {error.strerror}.") from None
    click.echo("\n".join(table.text(results)))
    return DONE


@benchmark.command(short_help="The instance of a session's start.")
@click.argument("scenario", type=ScenarioName())
@SET
def instance(scenario: str, settings: tuple[str, ...]) -> int:
    """Print the instance of a session of SCENARIO that begins now, for a scheduler of yours.

    \b
    Examples:
      gcs benchmark instance demo >demo.json

    \b
    Exit status:
      0    it was printed
      2    the scenario is wrong
    """
    from gcs.benchmark.format import raw
    from gcs.benchmark.sessions import instance_of

    click.echo(raw(instance_of(load_scenario(scenario, settings))).decode(), nl=False)
    return DONE


@benchmark.command(short_help="The scenario that flies an instance.")
@click.argument("instance", type=FILE)
def scenario(instance: Path) -> int:
    """Print a scenario whose session flies INSTANCE in lockstep.

    A program flies it by a schedule: gcs.Session("scenario.yaml", lockstep=True, policy=Scheduled(schedule)), with
    `Scheduled` of gcs.benchmark.sessions.

    \b
    Examples:
      gcs benchmark scenario instances/tankers-042.json >tight.yaml
      gcs run tight.yaml --lockstep

    \b
    Exit status:
      0    it was printed
      2    the file cannot be read
    """
    from gcs.benchmark import format
    from gcs.benchmark.sessions import document_of
    from gcs.scenario.document import emit

    try:
        click.echo(emit(document_of(format.read(instance, format.Instance))), nl=False)
    except format.FormatError as error:
        click.echo(f"gcs: {error}", err=True)
        return BAD_INPUT
    return DONE
