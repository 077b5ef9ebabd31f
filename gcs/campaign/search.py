"""The worst case of a campaign: Optuna searches what it draws for the least or greatest value of a measure.

Trials are asked for in batches and reported in order of their numbers, so that the same search flies the same trials
with any number of workers, and goes on where it stopped. Its table has a row per trial.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from gcs.campaign import draws, table
from gcs.campaign.model import Draw
from gcs.campaign.plan import Plan, PlannedRow, RowError

EXPLORED_SHARE = 0.3
STEP = 0.03
"""First step of CMA-ES about the worst trial so far, as a share of each range [choice].

Three points that cross on straight lines, 13 numbers drawn: 200 trials came nearer to a collision than 1,000
draws in six of six seeds with 0.03, in four with 0.1, and in four by TPE alone.
"""
WORST = 1e9
"""Of a trial without a value: as far from what is searched for as can be."""


class Search:
    """One search: an iterator of rows for the engine, None while those in the air have to be awaited."""

    def __init__(self, plan: Plan, folder: Path) -> None:
        assert plan.campaign.search is not None
        self._plan, self._rules = plan, plan.campaign.search
        self._measure = str(self._rules.minimise or self._rules.maximise)
        self._optuna = _optuna()
        self._study = self._optuna.create_study(sampler=self._sampler())
        self._results: dict[int, float] = {}
        self._trials: dict[int, PlannedRow] = {}
        for row in table.read(folder, plan.campaign).to_pylist():
            self.add(row)

    def add(self, row: dict[str, Any]) -> None:
        """Take in a flown row."""
        value = row.get(self._measure)
        sign = 1.0 if self._rules.minimise is not None else -1.0
        known = isinstance(value, float | int) and not row["error"] and math.isfinite(value)
        self._results[row["row"]] = sign * float(value or 0.0) if known else WORST

    def rows(self) -> Iterator[PlannedRow | None]:
        """The trials to be flown."""
        for first in range(0, self._rules.trials, self._rules.batch):
            if self._rules.sampler == "sobol_cmaes" and first - self._rules.batch < self._explored <= first:
                self._study.sampler = self._descent()
            trials = [self._study.ask() for _ in range(first, min(first + self._rules.batch, self._rules.trials))]
            for trial in trials:
                row = self._row(trial)
                if trial.number not in self._results:
                    yield row
            while any(trial.number not in self._results for trial in trials):
                yield None
            for trial in trials:
                self._study.tell(trial, self._results[trial.number])

    def row(self, number: int) -> PlannedRow:
        """The trial of a number. Raises RowError where it follows from some that have not been flown."""
        ahead = self.rows()
        while number not in self._trials and next(ahead, None) is not None:
            pass
        if number not in self._trials:
            raise RowError(f"trial {number} follows from trials before it that have not been flown")
        return self._trials[number]

    def _row(self, trial: Any) -> PlannedRow:
        campaign = self._plan.campaign
        values = dict(self._plan.row(0).values)
        for key, draw in campaign.draw.items():
            if draw.random is None:
                values[key] = _suggested(trial, key, draw)
        row = PlannedRow(trial.number, trial.number, 0, draws.seed_of(campaign.seed, trial.number), values)
        self._trials[trial.number] = row
        return row

    @property
    def _explored(self) -> int:
        """Trials of the first part of sobol_cmaes."""
        return math.ceil(EXPLORED_SHARE * self._rules.trials)

    def _sampler(self) -> Any:
        samplers, seed = self._optuna.samplers, self._plan.campaign.seed % (1 << 32)
        if self._rules.sampler == "cmaes":
            return samplers.CmaEsSampler(seed=seed)
        if self._rules.sampler == "tpe":
            return samplers.TPESampler(seed=seed, multivariate=True)
        return samplers.QMCSampler(qmc_type="sobol", scramble=True, seed=seed)

    def _descent(self) -> Any:
        """CMA-ES about the worst trial so far; what has no order is suggested by TPE."""
        samplers, seed = self._optuna.samplers, self._plan.campaign.seed % (1 << 32)
        others = samplers.TPESampler(seed=seed, multivariate=True)
        draws, best = self._plan.campaign.draw, self._study.best_params
        ordered = {key: value for key, value in best.items() if draws[key].choice is None}
        if not ordered:
            return others
        return samplers.CmaEsSampler(
            seed=seed, x0=ordered, sigma0=STEP, popsize=max(self._rules.batch, 5), independent_sampler=others
        )


def _suggested(trial: Any, key: str, draw: Draw) -> Any:
    """A trial's value of a key; numbers by their share of the distribution."""
    if draw.choice is not None:
        return draw.choice[trial.suggest_categorical(key, list(range(len(draw.choice))))]
    if draw.integers is not None:
        return trial.suggest_int(key, *draw.integers)
    return draws.scaled(draw, trial.suggest_float(key, 0.0, 1.0))


def _optuna() -> Any:
    import optuna  # noqa: PLC0415 - an extra, which the command has required

    optuna.logging.set_verbosity(optuna.logging.ERROR)
    warnings.filterwarnings("ignore", category=optuna.exceptions.ExperimentalWarning)
    # Optuna 6, which pyproject.toml keeps out, has no place to start a descent from but trials of its own.
    warnings.filterwarnings("ignore", message=r".*(x0|sigma0)", category=FutureWarning)
    return optuna
