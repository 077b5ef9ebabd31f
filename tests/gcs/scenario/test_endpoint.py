"""Addresses as people write them."""

import pytest

from gcs.scenario.endpoint import Endpoint, address


@pytest.mark.parametrize(
    ("text", "at"),
    [
        ("udpin:127.0.0.1:14550", Endpoint("udpin", "127.0.0.1", 14550)),
        ("udpout:drone.local:14580", Endpoint("udpout", "drone.local", 14580)),
        ("udpin:[::1]:14550", Endpoint("udpin", "::1", 14550)),
        ("tcp:localhost:5760", Endpoint("tcp", "localhost", 5760)),
        ("udpin:127.0.0.1:0", Endpoint("udpin", "127.0.0.1", 0)),
        ("tcpin:[fe80::1]:0", Endpoint("tcpin", "fe80::1", 0)),
        ("serial:/dev/ttyUSB0:57600", Endpoint("serial", "/dev/ttyUSB0", 57600)),
        (
            "serial:/dev/serial/by-id/usb-FTDI_x-if00:115200",
            Endpoint("serial", "/dev/serial/by-id/usb-FTDI_x-if00", 115200),
        ),
    ],
)
def test_an_address_is_read_and_written_again_as_it_was(text: str, at: Endpoint) -> None:
    assert address(text) == at
    assert at.text == text


@pytest.mark.parametrize(
    "text",
    [
        "14550", "udpin:127.0.0.1", "udpout:127.0.0.1:0", "tcp:127.0.0.1:0", "udpin:x:70000", "", "udpin:::1:14550",
        "serial:/dev/ttyUSB0", "serial:COM3:57600", "serial:/dev/ttyUSB0:0", "serial:/dev/ttyUSB0:57600:8N1",
    ],
)  # fmt: skip
def test_what_is_no_address_is_none(text: str) -> None:
    assert address(text) is None


def test_a_way_that_is_not_asked_for_is_none() -> None:
    assert address("tcp:127.0.0.1:5760", "udpin", "udpout") is None
