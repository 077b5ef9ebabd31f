"""Vehicles that agree among themselves: reports of peers, the competition on board, service and flight without a
ground station (docs/protocol/onboard.md#competition-on-board). No message and no socket."""
