"""`gcs.parallel_env`: environments, whose packages are an extra, are imported when one is made."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import os
    from collections.abc import Iterable
    from typing import Unpack

    from gcs.environments.options import Options
    from gcs.environments.parallel import ParallelSessionEnv
    from gcs.scenario.model import Scenario


def parallel_env(
    scenario: str | os.PathLike[str] | Scenario, agents: Iterable[int] | None = None, **options: Unpack[Options]
) -> ParallelSessionEnv:
    """Sessions in lockstep as an environment of many agents, PettingZoo's ParallelEnv.

    scenario: a file, the name of a shipped one, or a `Scenario`. agents: system ids of vehicles that are agents; every
    pursuer without it, and all other vehicles are the planner's. options: `gcs.environments.options.Options`.

    Raises ValueError and TypeError for options, MissingExtra without the extra `learn`, and what `gcs.Session` raises
    of the scenario.
    """
    from gcs.environments.parallel import ParallelSessionEnv  # noqa: PLC0415 - an extra

    return ParallelSessionEnv(scenario, agents, **options)
