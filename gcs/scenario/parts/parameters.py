"""MAVLink parameters that a scenario gives a vehicle of ours, held against the table by which the vehicle takes them.

Another autopilot has parameters of its own, which only it knows.
"""

from collections.abc import Iterator, Mapping

from gcs.scenario.document import Conflict, did_you_mean
from skytender.vehicle.parameters import ROWS, ParameterRow, float32

CAPACITY, CHARGE = "SIM_BAT_CAP_J", "SIM_BAT_INIT_J"


def parameter_conflicts(params: Mapping[str, float], *, capacity_j: float, initial_j: float) -> Iterator[Conflict]:
    """Parameters that the vehicle would refuse at its start; the battery has this capacity and charge without them."""
    wrong = [conflict for name, value in params.items() if (conflict := _conflict(name, value)) is not None]
    yield from wrong
    given = [name for name in (CHARGE, CAPACITY) if name in params]
    capacity_j, initial_j = params.get(CAPACITY, capacity_j), params.get(CHARGE, initial_j)
    if given and not wrong and float32(initial_j) > float32(capacity_j):
        text = f"a battery that holds {capacity_j:g} J ({CAPACITY}) cannot start with {initial_j:g} J ({CHARGE})"
        yield Conflict(("params", given[0]), text)


def _conflict(name: str, value: float) -> Conflict | None:
    row = ROWS.get(name)
    if row is None:
        near = did_you_mean(name.upper(), ROWS)
        return Conflict(("params", name), f"our own vehicles have no parameter {name!r}{near}", at_key=True)
    if not row.least <= value <= row.most:
        return Conflict(("params", name), f"{name} must be {_range(row)}, not {value:.12g}")
    return None


def _range(row: ParameterRow) -> str:
    return f"from {row.least:.12g} to {row.most:.12g} {row.units}".rstrip()
