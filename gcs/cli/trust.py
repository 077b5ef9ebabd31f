"""Whatever a scenario names beyond its session is asked for once, and remembered (gcs/scenario/parts/trust.py)."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING

import click

from gcs.cli.options import Refused
from gcs.scenario.parts import trust as store

if TYPE_CHECKING:
    from gcs.scenario.parts.reach import Reached

TRUST = click.option(
    "--trust",
    is_flag=True,
    help="Let the scenario use the code, programs, key files, devices and addresses that it names; remembered until "
    "it changes.",
)


def allow(name: str, named: Sequence[Reached], key: str, *, trust: bool) -> None:
    """Return where what the scenario `name` names may be used: by --trust, an earlier answer, or one that is asked for.

    `key` is the scenario's hash. Raises Refused, click.Abort.
    """
    if not named or (not trust and store.remembered(key)):
        return
    if not trust:
        if not (sys.stdin.isatty() and sys.stderr.isatty()):
            raise Refused(str(store.TrustError(name, named, "--trust")))
        click.echo(f"{name} names, and would use as you:", err=True)
        for one in named:
            click.echo(f"  {one.text}", err=True)
        if not click.confirm("Let it, until it changes?", err=True):
            raise Refused(f"{name} may not use what it names; nothing of it has run")
    try:
        store.remember(key, name, named)
    except OSError as error:
        click.echo(f"gcs: the answer cannot be kept in {store.folder()}: {error.strerror}", err=True)
