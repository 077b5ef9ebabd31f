"""`simvehicle paper`: the paper's figures that need one vehicle alone."""

# ruff: noqa: PLC0415 - so that help and a bad command line cost no compiler's start

from __future__ import annotations

import sys
from importlib.util import find_spec
from pathlib import Path

import click

from skytender.exit import CANNOT_WRITE


@click.command(short_help="Draw the paper's vehicle-only figures.")
@click.option(
    "--out",
    type=click.Path(path_type=Path, file_okay=False),
    required=True,
    help="Folder for vehicle.json and figures.",
)
@click.option("--only", metavar="NAME,NAME", help="Some of fig5, fig12, implicit, noise; all by default.")
@click.option(
    "--plans",
    type=click.Path(path_type=Path, dir_okay=False, exists=True),
    help="Fly these plans, as gcs paper writes them, instead of drawing: energies.npz.",
)
def paper(out: Path, only: str | None, plans: Path | None) -> None:
    """Measure and draw the paper's figures that need one vehicle alone, as SVG and PNG, numbers in vehicle.json.

    fig5 is the differentiator on 5 sin t, fig12 its comparison with two others, implicit why it is stepped implicitly,
    noise the three in flight on an estimate that errs.
    """
    from simvehicle.paper import energies

    if plans is not None:
        try:
            click.echo(energies.write(energies.read(plans), out))
        except ValueError as error:
            raise click.UsageError(f"--plans: {error}.") from None
        except OSError as error:
            print(f"simvehicle: cannot write {error.filename or out}: {error.strerror}", file=sys.stderr)
            click.get_current_context().exit(CANNOT_WRITE)
        return
    if find_spec("matplotlib") is None:
        raise click.UsageError(
            "figures need Matplotlib, which is not installed: pip install '.[paper]' in Skytender's checkout."
        )
    from simvehicle.paper.studies import STUDIES, make

    names = list(STUDIES) if only is None else [name.strip() for name in only.split(",")]
    for name in names:
        if name not in STUDIES:
            raise click.UsageError(f"--only: there is no figure '{name}'; choose from {', '.join(STUDIES)}.")
    try:
        make(out, names, click.echo)
    except OSError as error:
        print(f"simvehicle: cannot write {error.filename or out}: {error.strerror}", file=sys.stderr)
        click.get_current_context().exit(CANNOT_WRITE)
