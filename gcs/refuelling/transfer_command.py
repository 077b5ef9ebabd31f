"""MAV_CMD_USER_1, the command that starts and stops a transfer of energy (docs/protocol.md#energy-transfer)."""

from __future__ import annotations

import math
from enum import IntEnum

from pymavlink.dialects.v20 import common as mav

from gcs.mavlink.command_protocol import CommandRequest


class TransferRole(IntEnum):
    """param2: what the vehicle is to do."""

    STOP = 0
    GIVE = 1
    RECEIVE = 2
    SETTLE = 3


def transfer_request(
    sysid: int,
    token: str,
    role: TransferRole,
    *,
    partner: int,
    limit_j: float,
    rate_w: float,
    number: int,
    given_at_start_j: int,
) -> CommandRequest:
    """Order of a transfer for one side.

    partner: system id of the other side. limit_j: whole joules at most; of SETTLE those that the receiver has credited.
    number: the transfer's id.
    given_at_start_j: the giver's counter XferOut when the transfer began.
    """
    params = (partner, role, math.floor(limit_j), rate_w, number, given_at_start_j)
    return CommandRequest(sysid, mav.MAV_CMD_USER_1, tuple(map(float, params)), token)


def inquiry(sysid: int, token: str) -> CommandRequest:
    """Stop of no transfer: who accepts it can take energy."""
    return CommandRequest(sysid, mav.MAV_CMD_USER_1, (), token)
