"""Sockets at people's addresses; the kernel is the truth."""

import pytest

from gcs.link.socket import AddressRefused, open_udp
from gcs.scenario.endpoint import Endpoint


@pytest.mark.parametrize("host", ["127.0.0.1", "localhost"])
def test_one_listens_and_the_other_finds_it(host: str) -> None:
    listens, _ = open_udp(Endpoint("udpin", host, 0))
    with listens:
        speaks, where = open_udp(Endpoint("udpout", host, listens.getsockname()[1]))
        with speaks:
            speaks.sendto(b"hello", where)
            listens.settimeout(5.0)
            data, peer = listens.recvfrom(100)
            assert (data, peer[1]) == (b"hello", speaks.getsockname()[1])
            with pytest.raises(BlockingIOError):
                speaks.recv(100)


def test_an_address_of_another_machine_is_told_with_what_to_do() -> None:
    with pytest.raises(AddressRefused, match=r"^udpin:203\.0\.113\.7:14550 cannot .* this machine has no such address"):
        open_udp(Endpoint("udpin", "203.0.113.7", 14550))
