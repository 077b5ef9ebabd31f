"""What the tests of the console share."""

import pytest
from feed import flight
from pilots import Messages


@pytest.fixture(scope="module")
def flown() -> Messages:
    """The demo up to 48.2 s."""
    return list(flight())
