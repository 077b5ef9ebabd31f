"""What all tests need of their own process, and the order in which they are run."""

import gc
import os
import signal
import tempfile

import newer
import pytest
from hypothesis import HealthCheck, settings

# Where pymavlink is the peer, it reads what its own definitions lack too.
newer.understood()

# The same examples in every run; none is judged by its time, for the first to call a kernel also loads it.
settings.register_profile("ours", derandomize=True, deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("ours")

# A shell that starts the tests in the background lets them ignore SIGINT, and every program under test inherits that.
signal.signal(signal.SIGINT, signal.default_int_handler)

# OpenBLAS starts a thread per core in every process that imports NumPy, a quarter of what starting a session costs; a
# session's matrices are far too small for them, and the tests start hundreds of processes.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


def pytest_configure() -> None:
    """What tests let scenarios use is no answer of whoever runs them, nor of another worker."""
    os.environ["XDG_STATE_HOME"] = tempfile.mkdtemp(prefix="skytender-tests-")


def pytest_collectstart() -> None:
    """What is collected stays to the end: looking it through for garbage takes a sixth of the time."""
    gc.disable()


def pytest_collection_finish() -> None:
    """From here on only what tests make is looked through."""
    gc.freeze()
    gc.enable()


# The longest, what waits for real time beside what computes; the third has little time to spare.
FIRST = (
    "tests/peers/test_mavsdk.py",
    "tests/system/test_safety_external.py",
    "tests/system/test_external.py",
    "tests/system/test_logs.py",
    "tests/system/test_wheel.py",
    "tests/system/test_campaign.py",
    "tests/system/test_docs_pages.py",
    "tests/system/test_readme.py",
    "tests/test_docs.py",
    "tests/test_compiled.py",
)
SESSIONS = ("tests/peers/", "tests/system/")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Long files first, so that none is left for one worker alone at the end; the many short tests fill up."""
    place = {name: k for k, name in enumerate(FIRST)}

    def order(item: pytest.Item) -> tuple[int, bool]:
        file = item.nodeid.partition("::")[0]
        return place.get(file, len(FIRST)), not file.startswith(SESSIONS)

    items.sort(key=order)
