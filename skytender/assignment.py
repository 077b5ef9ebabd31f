"""Rows matched to columns at the least sum of costs: shortest augmenting paths with dual prices.

D. F. Crouse, IEEE Transactions on Aerospace and Electronic Systems 52 (4), 2016, section II, for matrices of any shape.
Of equal sums it finds the one that scipy's `linear_sum_assignment` finds: of columns that are equally near, the lowest,
and one that is free before one that is taken.
"""

from __future__ import annotations

import numpy as np
from cython.cimports.libc.math import INFINITY
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]


def least_cost(cost: FloatArray) -> tuple[IntArray, IntArray]:
    """Rows, ascending, and the column of each, for as many as the shorter side of `cost` (n, m) has.

    Raises ValueError for a cost that is not finite.
    """
    if not np.isfinite(cost).all():
        raise ValueError("a cost of an assignment is not finite")
    n, m = cost.shape
    if n <= m:
        return np.arange(n), _columns(np.ascontiguousarray(cost, dtype=np.float64))
    rows = _columns(np.ascontiguousarray(cost.T, dtype=np.float64))
    columns = np.argsort(rows, kind="stable")
    return rows[columns], columns


def _columns(cost: FloatArray) -> IntArray:
    """The column of each row; there are no more rows than columns."""
    n, m = cost.shape
    column_of, row_of = np.full(n, -1), np.full(m, -1)
    before, left, reached = np.empty((3, m), np.int64)
    _match(cost, np.zeros(n), np.zeros(m), column_of, row_of, before, left, reached, np.empty(m))
    return column_of


def _match(
    cost: FloatArray, row_price: FloatArray, column_price: FloatArray, column_of: IntArray, row_of: IntArray,
    before: IntArray, left: IntArray, reached: IntArray, way: FloatArray,
) -> None:  # fmt: skip
    """Fill column_of (n,) and row_of (m,), -1 at first; prices are 0 at first, and the rest, (m,) each, is scratch:
    `before` is the row from which the shortest path, `way` long, enters a column."""
    n, m = cost.shape[0], cost.shape[1]
    for start in range(n):
        for j in range(m):
            way[j], reached[j], left[j] = INFINITY, 0, m - 1 - j
        row, length, count = start, 0.0, m
        while True:
            nearest = -1
            for k in range(count):
                j = left[k]
                onward = length + cost[row, j] - row_price[row] - column_price[j]
                if onward < way[j]:
                    way[j], before[j] = onward, row
                if nearest < 0 or way[j] < way[left[nearest]] or (way[j] == way[left[nearest]] and row_of[j] < 0):
                    nearest = k
            column = left[nearest]
            length = way[column]
            reached[column] = 1
            count -= 1
            left[nearest] = left[count]
            if row_of[column] < 0:
                break
            row = row_of[column]
        row_price[start] += length
        for j in range(m):
            if reached[j]:
                if row_of[j] >= 0:
                    row_price[row_of[j]] += length - way[j]
                column_price[j] -= length - way[j]
        while True:
            row = before[column]
            row_of[column] = row
            column_of[row], column = column, column_of[row]
            if row == start:
                break
