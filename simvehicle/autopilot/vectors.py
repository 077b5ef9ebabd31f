"""A vector as Python's numbers."""

Vec3 = tuple[float, float, float]
