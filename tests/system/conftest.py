"""What tests of the page share."""

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser
from web import CHROMIUM, MISSING, chromium


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    """One for a file: while it runs, nothing else in this process has an event loop."""
    if CHROMIUM is None:
        pytest.skip(MISSING)
    with chromium() as browser:
        yield browser
