"""MAVLink's definitions against pymavlink's; what the codecs make of them is held in tests/wire."""

import pytest
from mavlink_definitions import FILE, made

from skytender import mavlink


def test_the_definitions_are_pymavlinks() -> None:
    assert FILE.read_text(encoding="utf-8") == made(), "run tests/support/mavlink_definitions.py"


def test_a_number_that_the_dialect_lacks_is_an_error_with_its_name() -> None:
    with pytest.raises(AttributeError, match="no MAV_TYPE_NONE"):
        _ = mavlink.MAV_TYPE_NONE
