"""Return parameters of one vehicle whose autopilot is not ours: set before it is armed, put back at the end.

1. A parameter that it has is read, written where it differs, and read back (ParameterClient).
2. What has several names by versions is asked for by all; once it has answered to one, the others are dropped.
3. What it does not have is left out and named, but for the height: without that its list fails.
4. Heights count from its home, which may lie higher or lower than the scenario's height 0.
5. Put back is what it had before, where it was written; what the scenario sets for it is not touched.
"""

from __future__ import annotations

import math
from collections.abc import Collection
from typing import Any, NamedTuple

from gcs.mavlink.autopilots import Profile
from gcs.mavlink.codec import Message
from gcs.mavlink.ids import AUTOPILOT
from gcs.mavlink.parameters.client import ParameterClient, ParameterResult
from gcs.mavlink.parameters.returns import TABLES, Homecoming, ReturnParameter
from gcs.mavlink.parameters.value import ParameterValue
from gcs.planner.foreign_returns import ForeignReturn
from gcs.telemetry.state import VehicleView

MESSAGES = frozenset({"PARAM_VALUE", "PARAM_ERROR"})
HOME_WITHIN_S = 10.0
"""A home that has not been reported for so long is taken to lie at the scenario's height 0."""
LEAST_HEIGHT_M = 1.0


class ReturnVerdict(NamedTuple):
    """End of the setting, as an entry of the check list."""

    passed: bool
    text: str


class ReturnSetting:
    """The dialogue with one vehicle."""

    def __init__(
        self, sysid: int, plan: ForeignReturn, given: Collection[str] = (), *, external: bool, dry_run: bool = False
    ) -> None:
        """`given`: parameters that the scenario sets for it. `external`: it lives on after the session. `dry_run`:
        nothing is written."""
        self.sysid = sysid
        self.verdict: ReturnVerdict | None = None
        """None while it is under way"""
        self._plan, self._given = plan, given
        self._external, self._dry_run = external, dry_run
        self._rows: tuple[ReturnParameter, ...] = ()
        self._height_m = math.nan
        self._client: ParameterClient | None = None
        self._back: ParameterClient | None = None
        self._begun_s = math.inf

    @property
    def before(self) -> dict[str, ParameterValue]:
        """Values before, of those that were written."""
        return {} if self._client is None or not self._external else self._client.written

    @property
    def putting_back(self) -> bool:
        """Whether that has begun and not ended."""
        return self._back is not None and not self._back.done

    def receive(self, name: str, content: Any, now_s: float) -> None:
        """Take a message of this vehicle's: its name and fields."""
        client = self._back if self._back is not None else self._client
        if client is not None:
            client.receive(name, content, now_s)

    def poll(self, view: VehicleView, now_s: float) -> list[Message]:
        """Messages that set its parameters."""
        if self.verdict is not None:
            return []
        self._begun_s = min(self._begun_s, now_s)
        if self._client is None:
            if view.ground_down_m is None and now_s - self._begun_s < HOME_WITHIN_S:
                return []
            self._client = self._begin(view)
        for row in self._rows:
            if any(name in self._client.known for name in row.names):
                self._client.leave(name for name in row.names if name not in self._client.known)
        messages = self._client.poll(now_s)
        if self._client.done:
            self.verdict = self._judge(self._client.results)
        return messages

    def put_back(self, profile: Profile) -> None:
        """Begin to give it back what it had."""
        if self._back is None and self.before:
            self._back = ParameterClient(self.sysid, AUTOPILOT, profile)
            self._back.write({name: value.number for name, value in self.before.items()})

    def poll_back(self, now_s: float) -> list[Message]:
        """Messages that put its parameters back."""
        return [] if self._back is None else self._back.poll(now_s)

    def kept(self) -> list[str]:
        """Names of parameters that have not been put back."""
        if self._back is None:
            return []
        put = {result.name for result in self._back.results if result.outcome in ("set", "kept")}
        return [name for name in self.before if name not in put]

    def _begin(self, view: VehicleView) -> ParameterClient:
        self._height_m = max(self._plan.height_m + (view.ground_down_m or 0.0), LEAST_HEIGHT_M)
        plan = self._plan
        home = Homecoming(self._height_m, plan.begins_after_s, plan.waits_s, plan.holds_after_s)
        client = ParameterClient(self.sysid, AUTOPILOT, view.profile, dry_run=self._dry_run)
        table = TABLES.get(view.profile.mode_table, ())
        self._rows = tuple(row for row in table if not any(name in self._given for name in row.names))
        client.write({name: number for row in self._rows for name, number in row.numbers(home).items()})
        return client

    def _judge(self, results: list[ParameterResult]) -> ReturnVerdict:
        if not self._rows:
            return ReturnVerdict(
                True, "return height not set: its autopilot has no parameter for it that is known here"
            )
        answers = {result.name: result for result in results if result.outcome != "unknown"}
        if not answers:
            return ReturnVerdict(False, "return height not set: it does not answer about its parameters")
        missing = []
        for row in self._rows:
            result = next((answers[name] for name in row.names if name in answers), None)
            if result is None:
                if row.is_height:
                    return ReturnVerdict(False, f"return height not set: it has no {' or '.join(row.names)}")
                missing.append(row.names[0])
            elif result.outcome in ("refused", "silent"):
                how = "refused" if result.outcome == "refused" else "not read back"
                return ReturnVerdict(False, f"return parameter {result.name} {how}: {result.why}")
        outcomes = {result.outcome for result in answers.values()}
        done = "set and read back" if "set" in outcomes else "would be set" if "would" in outcomes else "there already"
        height = any(row.is_height for row in self._rows)
        what = f"return height {self._height_m:.1f} m" if height else "return parameters"
        return ReturnVerdict(True, f"{what} {done}" + (f" (it has no {', '.join(missing)})" if missing else ""))
