"""Workers of a campaign on other machines, by a Dask scheduler that is reached by mutual TLS.

A scheduler and its workers run the code that they are sent, as their user. So connections without such a certificate
are refused.
"""

from __future__ import annotations

import contextlib
import os
import queue
from concurrent.futures import CancelledError
from typing import Any

from gcs.campaign import worker
from gcs.campaign.plan import Plan, PlannedRow
from gcs.campaign.pool import DEATHS, died
from gcs.extras import missing
from gcs.supervisor.summarise import versions

AHEAD = 3
"""Rows handed out for each that a worker can fly at once."""
CONNECT_WITHIN_S = 20.0
SETTINGS = {
    "distributed.scheduler.allowed-failures": DEATHS,
    "distributed.comm.timeouts.connect": CONNECT_WITHIN_S,
    "distributed.admin.log-length": 100,
}
TLS = "tls://"


class EngineError(RuntimeError):
    """A campaign that cannot go on; the text says why, and rows that were written stay."""


def check_scheduler(address: str) -> None:
    """Raises EngineError for an address that is not to be spoken to, MissingExtra without Dask."""
    if not address.startswith(TLS):
        raise EngineError(
            f"{address} is no address of a scheduler with TLS, such as {TLS}HOST:8786: without it all who reach its "
            "port run code here and there"
        )
    given = _security().get_tls_config_for_role("client")
    wanting = [name for name in ("ca_file", "cert", "key") if not given.get(name)]
    if wanting:
        raise EngineError(
            f"{address} needs certificates on both sides: name them under distributed.comm.tls in Dask's configuration "
            f"(here {' and '.join(wanting)} is missing; docs/how-to/campaigns.md)"
        )


class Cluster:
    """A client of a scheduler that runs; its context's end leaves nothing of ours behind."""

    def __init__(self, plan: Plan, scheduler: str) -> None:
        self._plan, self._address = plan, scheduler
        self._closing = contextlib.ExitStack()
        self._came: queue.Queue[Any] = queue.Queue()
        self._flying: dict[str, PlannedRow] = {}

    def __enter__(self) -> Cluster:
        check_scheduler(self._address)
        import dask  # noqa: PLC0415 - an extra
        from distributed import Client  # noqa: PLC0415

        with contextlib.ExitStack() as stack:
            stack.enter_context(dask.config.set(SETTINGS))
            _quieten_dask()
            try:
                self._client = stack.enter_context(
                    Client(self._address, timeout=CONNECT_WITHIN_S, security=_security())
                )
            except (OSError, ValueError, TimeoutError) as error:
                why = " ".join(str(error).split())
                raise EngineError(f"no scheduler can be reached at {self._address}: {why}") from None
            _check_workers(self._client)
            self._closing = stack.pop_all()
        return self

    def __exit__(self, *_: object) -> None:
        self._closing.close()

    @property
    def dashboard(self) -> str:
        """Address of Dask's own page; empty where there is none."""
        served = self._client.scheduler_info().get("services", {})
        return str(self._client.dashboard_link) if "dashboard" in served else ""

    @property
    def count(self) -> int:
        """Number of rows that can be flown at once. Raises EngineError where the scheduler does not answer."""
        try:
            return sum(self._client.nthreads().values())
        except (OSError, TimeoutError, RuntimeError, ValueError):
            raise EngineError("the scheduler is lost") from None

    @property
    def room(self) -> int:
        """Rows that can be under way at once. Raises EngineError."""
        return AHEAD * max(self.count, 1)

    def submit(self, row: PlannedRow) -> None:
        """Hand out a row."""
        key = f"row-{row.number}-{os.urandom(4).hex()}"
        future = self._client.submit(worker.fly_row, self._plan, row, pure=False, key=key)
        self._flying[future.key] = row
        future.add_done_callback(self._came.put)

    def collect(self, within_s: float) -> list[dict[str, Any]]:
        """The row that has come within so long, if one has. Raises EngineError."""
        with contextlib.suppress(queue.Empty):
            future = self._came.get(timeout=within_s)
            if future.key in self._flying:
                return [result(self._plan, future, self._flying.pop(future.key))]
        return []


def result(plan: Plan, future: Any, row: PlannedRow) -> dict[str, Any]:
    """The row that was flown, or why it was not. Raises EngineError where the scheduler has gone, with it or before."""
    from distributed.scheduler import KilledWorker  # noqa: PLC0415 - an extra

    try:
        if future.status == "finished":
            flown: dict[str, Any] = future.result()
            future.release()
            return flown
        error = None if future.status in ("cancelled", "lost") else future.exception()
    except (OSError, CancelledError):  # it went while the result was on its way
        error = None
    if error is None:
        raise EngineError("the scheduler is lost")
    why = died(DEATHS) if isinstance(error, KilledWorker) else f"the worker failed: {type(error).__name__}: {error}"
    return worker.failed(plan, row, " ".join(why.split()))


def _security() -> Any:
    """TLS and the certificates that Dask's configuration names. Raises MissingExtra."""
    try:
        from distributed.security import Security  # noqa: PLC0415 - an extra
    except ImportError:
        raise missing("a campaign on other machines", "Dask", "campaign") from None
    return Security(require_encryption=True)


def _check_workers(client: Any) -> None:
    """Raises EngineError unless there are workers, all with the versions that we have."""
    try:
        client.wait_for_workers(1, timeout=CONNECT_WITHIN_S)
        found = client.run(versions)
    except TimeoutError:
        raise EngineError("the scheduler has no workers; start some with `dask worker ADDRESS --nthreads 1`") from None
    except Exception as error:
        raise EngineError(f"a worker cannot load Skytender: {type(error).__name__}: {error}") from None
    ours = versions()
    for address, theirs in found.items():
        for package, wanted in ours.items():
            if theirs.get(package) != wanted:
                has = theirs.get(package)
                raise EngineError(f"the worker {address} has {package} {has}, not {wanted}: install the same there")


def _quieten_dask() -> None:
    """Dask's own words about lost workers and schedulers are reported by us."""
    import logging  # noqa: PLC0415

    for name in list(logging.root.manager.loggerDict):
        if name.split(".")[0] in ("distributed", "tornado", "asyncio"):
            logging.getLogger(name).setLevel(logging.CRITICAL + 1)
