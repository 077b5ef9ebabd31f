"""Auction algorithm for the assignment problem (D. P. Bertsekas, Annals of Operations Research 14, 1988)."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray


def auction(benefit: ArrayLike, epsilon: float) -> NDArray[np.int64]:
    """Object (m,) of each of m bidders for benefit (m, n), m <= n, finite; the sum is within m·epsilon of the greatest.

    Every bidder without an object bids for the one that is worth most to it at the present prices, and raises its price
    by what it prefers it to the second best, and epsilon; whoever held it is without one again.
    """
    worth = np.asarray(benefit, dtype=np.float64)
    bidders, objects = worth.shape
    if bidders > objects:
        raise ValueError(f"auction: {bidders} bidders for {objects} objects; there must be at least as many objects")
    price, holder, held = np.zeros(objects), np.full(objects, -1), np.full(bidders, -1)
    without = list(range(bidders))
    while without:
        bidder = without.pop()
        net = worth[bidder] - price
        best = int(net.argmax())
        second = float(np.delete(net, best).max()) if objects > 1 else float(net[best])
        price[best] += float(net[best]) - second + epsilon
        if holder[best] >= 0:
            held[holder[best]] = -1
            without.append(int(holder[best]))
        holder[best], held[bidder] = bidder, best
    return held
