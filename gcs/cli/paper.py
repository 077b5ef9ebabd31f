"""`gcs paper`: the paper's examples flown, and its claims judged."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

from pathlib import Path

import click

from gcs.cli.options import out_option
from gcs.extras import require
from skytender.exit import NOT_DONE


@click.command(short_help="Fly the paper's examples and judge its claims.")
@out_option("A new folder.  [default: paper-TIME]")
@click.option(
    "--only",
    metavar="NAME,NAME",
    help="Some of example1 to example4, example1-literal, example4-energy, pursuit, fig3, fig5 to fig14, loops, "
    "implicit, readings, sensitivity; all by default.",
)
def paper(out: Path | None, only: str | None) -> int:
    """Fly the examples of the paper that the algorithms come from, and judge each of its claims.

    DIR then holds index.html (one page, readable without a network), claims.json, each figure as SVG and PNG, and the
    recorded sessions. What counts as agreement was written down before it was measured; what differs is printed, with
    one of four reasons.

    \b
    Examples:
      gcs paper
      gcs paper --only example2,fig13 --out second

    \b
    Exit status:
      0    the page was made, whatever the claims came to
      1    an example could not be flown, or a file could not be written
      2    bad input; nothing has been done
      130  stopped by Ctrl-C; the sessions flown so far are kept
    """
    from rich.console import Console

    require("gcs paper", {"scipy": "SciPy", "matplotlib": "Matplotlib"}, "paper")
    from gcs.report.paper import make as maker
    from gcs.report.paper import page
    from gcs.report.paper.study import PaperError

    try:
        parts = maker.chosen(only)
    except ValueError as error:
        raise click.UsageError(f"--only: {error}.") from None
    folder = out or maker.default_folder()
    try:
        judged = maker.make(folder, parts, Console(stderr=True))
    except FileExistsError:
        raise click.UsageError(f"{folder} exists already; give --out a folder that does not.") from None
    except PaperError as error:
        click.echo(str(error), err=True)
        return NOT_DONE
    except OSError as error:
        click.echo(f"{error.filename or folder}: {error.strerror}", err=True)
        return NOT_DONE
    for name, later in (("first table", False), ("second table", True)):
        of_table = [one for one in judged if one.claim.later == later]
        for verdict, number in page.counted(of_table).items():
            click.echo(f"{name}, {verdict}: {number}")
            if verdict == "differs":
                for one in of_table:
                    if one.verdict == verdict:
                        click.echo(f"  {one.line}")
    click.echo(f"page: {folder / 'index.html'}")
    return 0
