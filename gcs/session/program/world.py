"""Obstacles and attractors of a session in flight, as its program sees and changes them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Generic, TypeVar, overload

from numpy.typing import ArrayLike

from gcs.scenario.parts import world
from gcs.scenario.parts.surroundings import Attractor, Obstacle

if TYPE_CHECKING:
    from gcs.scenario.model import Scenario

One = TypeVar("One", Obstacle, Attractor)


class Bodies(Sequence[One], Generic[One]):
    """Obstacles, or attractors, that are there now; each has a name. Places are in the common NED frame, m.

    A change holds from the next tick on; one that makes no sense raises ValueError, or SessionError where only the
    session knows that, such as an obstacle inside or within 0.3 m of a vehicle.
    """

    def __init__(self, kind: world.Kind, now: Callable[[], Scenario], change: Callable[[world.Change], None]) -> None:
        """now: gives the present world. change: changes it."""
        self._kind, self._now, self._change = kind, now, change

    def move(self, which: int | str, at_m: ArrayLike) -> None:
        """Let one be elsewhere; `which`: its index or its name.

        at_m: (3,) where its point, its centre, or the middle of its box or cylinder is to be; or (2,), north and east,
        to keep its height. It jumps there: one that is to fly is moved a little in each step.
        """
        self._change(world.move(self._now(), self._kind, which, at_m))

    def add(self, content: One | Mapping[str, Any]) -> One:
        """Add one, and return it: with the keys that a scenario gives it, such as {"sphere_m": (4, 0, -5),
        "radius_m": 0.5}. Without a name it is given one, such as `sphere 3`."""
        self._change(world.addition(self._now(), self._kind, content))
        return self[-1]

    def remove(self, which: int | str) -> None:
        """Take one away; those after it move up. `which`: its index or its name."""
        self._change(world.removal(self._now(), self._kind, which))

    @property
    def _there(self) -> tuple[One, ...]:
        return world.bodies(self._now(), self._kind)

    @overload
    def __getitem__(self, index: int | str) -> One: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[One, ...]: ...
    def __getitem__(self, index: int | str | slice) -> One | tuple[One, ...]:
        return self._there[world.found(self._now(), self._kind, index) if isinstance(index, str) else index]

    def __len__(self) -> int:
        return len(self._there)

    def __iter__(self) -> Iterator[One]:
        return iter(self._there)

    def __repr__(self) -> str:
        return repr(self._there)
