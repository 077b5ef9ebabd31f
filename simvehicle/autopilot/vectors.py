"""A vector as Python's numbers."""

from collections.abc import Sequence

Vec3 = tuple[float, float, float]


def along(a: Vec3, b: Vec3, share: float) -> Vec3:
    """a + share b."""
    return a[0] + share * b[0], a[1] + share * b[1], a[2] + share * b[2]


def vec(numbers: Sequence[float]) -> Vec3:
    """The first three of some numbers."""
    return numbers[0], numbers[1], numbers[2]
