"""Options that several commands of `gcs campaign` have, and the plan that a file or folder names."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from gcs.cli.options import Refused, out_option
from gcs.cli.trust import TRUST, allow

if TYPE_CHECKING:
    from gcs.campaign.plan import Plan

SEED = click.option("--seed", type=click.IntRange(0), metavar="N", help="Instead of the file's.")
OUT = out_option("A new folder.  [default: campaigns/NAME-TIME]")
FOLDER = click.argument("folder", metavar="DIR", type=click.Path(path_type=Path, file_okay=False))


def _scheduler(ctx: click.Context, param: click.Parameter, value: str | None) -> str | None:
    """The callback of --scheduler: an address that has TLS, with certificates for it."""
    if value is not None:
        from gcs.campaign.cluster import EngineError, check_scheduler

        try:
            check_scheduler(value)
        except EngineError as error:
            raise click.BadParameter(f"{error}.", ctx, param) from None
    return value


SCHEDULER = click.option(
    "--scheduler",
    callback=_scheduler,
    metavar="ADDRESS",
    help="Fly on the workers of this Dask scheduler, by mutual TLS, such as tls://HOST:8786.",
)
WORKERS = click.option(
    "--workers", type=click.IntRange(1, 1024), metavar="N", help="Workers on this machine.  [default: one per core]"
)
PLAIN = click.option("--plain", is_flag=True, help="Lines of text instead of a progress line.")
QUIET = click.option("--quiet", "-q", is_flag=True, help="Say only what goes wrong.")


def flown(command: Callable[..., Any]) -> Callable[..., Any]:
    """The options of every command that flies a campaign's sessions."""
    return SCHEDULER(WORKERS(PLAIN(QUIET(TRUST(command)))))


def planned(file: str, sessions: int | None, seed: int | None, *, trust: bool) -> Plan:
    """The plan of a campaign's file or name, its first sessions checked."""
    from gcs.campaign import file as files
    from gcs.campaign.plan import make
    from gcs.scenario.model import ScenarioError

    try:
        path = files.find(file)
        loaded = files.load(path)
        changes: dict[str, Any] = {} if sessions is None else {"sessions": sessions}
        changes |= {} if seed is None else {"seed": seed}
        return _allowed(file, make(loaded.model_copy(update=changes), [path.parent]), trust=trust)
    except ScenarioError as error:
        raise Refused(str(error)) from None


def _allowed(name: str, plan: Plan, *, trust: bool) -> Plan:
    """The plan, its first sessions checked, once it may use what it names. Raises ScenarioError, Refused."""
    from gcs.campaign.plan import NotAllowed

    try:
        return plan.checked()
    except NotAllowed as asks:
        allow(name, asks.named, plan.trusted_by, trust=trust)
        return replace(plan, trusted=True).checked()


def found(folder: Path, *, trust: bool | None = None, resumed: bool = False) -> Plan:
    """The plan in a campaign's folder, broken parts of its table named; with `trust`, once it may use what it names;
    to be `resumed`, with the code by which its sessions were flown."""
    from gcs.campaign import table
    from gcs.campaign.plan import read
    from gcs.scenario.model import ScenarioError

    try:
        plan = read(folder)
        if resumed:
            plan.refuse_changed_code(plan.sources)
        for path in table.broken(folder, plan.campaign):
            why = f"no rows can be read from it; gcs campaign resume {folder} sets it aside and flies them again"
            click.echo(f"gcs: {path}: {why}", err=True)
    except (OSError, ValueError, KeyError):
        raise Refused(f"{folder} holds no campaign: give the folder that gcs campaign run named") from None
    except ScenarioError as error:
        raise Refused(str(error)) from None
    try:
        return plan if trust is None else _allowed(str(folder), plan, trust=trust)
    except ScenarioError:  # its rows say why they cannot be flown
        return plan
