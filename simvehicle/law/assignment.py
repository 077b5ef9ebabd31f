"""Rows matched to columns at the least sum of costs, by shortest augmenting paths with dual prices (R. Jonker,
A. Volgenant, Computing 38, 1987) [lineage]."""

from __future__ import annotations

import math
from collections.abc import Sequence


def least_cost_columns(cost: Sequence[Sequence[float]]) -> list[int]:
    """The column of each row of a finite matrix (n, m) with n <= m. Of equal sums always the same one."""
    m = len(cost[0]) if cost else 0
    row_price, column_price = [0.0] * len(cost), [0.0] * m
    row_of: list[int | None] = [None] * m
    for start in range(len(cost)):
        way, before = [math.inf] * m, [0] * m  # cost of the shortest path to each column, and the column ahead of it
        reached: list[int] = []
        row, column, length = start, -1, 0.0
        while True:
            nearest = -1
            for j in range(m):
                if j in reached:
                    continue
                onward = length + cost[row][j] - row_price[row] - column_price[j]
                if onward < way[j]:
                    way[j], before[j] = onward, column
                if nearest < 0 or way[j] < way[nearest]:
                    nearest = j
            column, length = nearest, way[nearest]
            taken = row_of[column]
            if taken is None:
                break
            reached.append(column)
            row = taken
        row_price[start] += length
        for j in reached:
            owner = row_of[j]
            assert owner is not None
            row_price[owner] += length - way[j]
            column_price[j] -= length - way[j]
        while before[column] >= 0:
            row_of[column] = row_of[before[column]]
            column = before[column]
        row_of[column] = start
    found = {row: j for j, row in enumerate(row_of) if row is not None}
    return [found[i] for i in range(len(cost))]
