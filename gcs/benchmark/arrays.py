"""An instance as arrays, for programs that look at many services at once. SI, NED.

Energies of receivers are held as times: a receiver whose `lands_s` is 80 holds what it draws until then, above the
charge at which it is lost. Paths are sampled each STEP_S and straight between the samples.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gcs.benchmark.format import FormatError, Instance

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

STEP_S = 0.1
MEETS_LATER_S = 0.03
"""A meeting is put later by so much: samples of a path cut its corners, by half a step where it turns back."""
ITERATIONS = 12
LEAST_W = 1e-6
"""A receiver that draws nothing is taken to draw so much, since energies are times here, and one that a transfer cannot
fill to gain so much by it."""
MOST_SAMPLES = 10_000_000
"""[choice] Of all receivers' paths: 240 MB."""


class Arrays:
    """n receivers, m tankers, k bases; tankers come before bases where both are givers. Raises FormatError for an
    instance that lasts too long."""

    def __init__(self, instance: Instance) -> None:
        receivers, tankers, bases = instance.receivers, instance.tankers, instance.bases
        self.instance = instance
        self.horizon_s, self.setup_s, self.rate_w = instance.horizon_s, instance.setup_s, instance.rate_w
        self.n, self.m, self.k = len(receivers), len(tankers), len(bases)
        self.power_w = np.maximum(_of([one.power_w for one in receivers]), LEAST_W)
        self.capacity_j = _of([one.capacity_j for one in receivers])
        self.energy_j = _of([one.energy_j for one in receivers])
        self.holds_j = self.capacity_j - _of([one.lands_at_j for one in receivers])
        """(n,) above the charge at which it is lost"""
        self.lands_s = np.maximum(self.energy_j - self.capacity_j + self.holds_j, 0.0) / self.power_w
        """(n,) without a service"""
        self.off_path_m_s = _of([one.speed_m_s for one in receivers])
        self.speed_m_s = _of([one.speed_m_s for one in tankers])
        self.start_ned = _of([one.position_m for one in tankers]).reshape(-1, 3)
        self.tanker_power_w = _of([one.power_w for one in tankers])
        self.tanker_holds_j = _of([one.capacity_j - one.reserve_j for one in tankers])
        self.spare_j = _of([t.energy_j - t.reserve_j - t.power_w * self.horizon_s for t in tankers])
        """(m,) what each can give if it never stands at a base"""
        self.base_ned = _of([one.position_m for one in bases]).reshape(-1, 3)
        self.stock_j = _of([one.stock_j for one in bases])
        self.base_rate_w = _of([one.rate_w for one in bases])
        latest_s = max([self.horizon_s, *(one.path[-1][0] for one in receivers)])
        if (longest_s := MOST_SAMPLES * STEP_S / max(self.n, 1)) < latest_s:
            most = f"{longest_s:.0f} s of {self.n} receivers at most"
            raise FormatError(f"{instance.name} lasts {latest_s:g} s, and a search takes {most}")
        times = np.arange(0.0, latest_s + 2.0 * STEP_S, STEP_S)
        self._samples = len(times)
        self._places = _of([_sampled(_of(one.path), times) for one in receivers]).reshape(-1, 3)
        legs = np.diff(self._places.reshape(self.n, self._samples, 3), axis=1)
        self.fastest_m_s = float(np.sqrt(np.square(legs).sum(axis=2)).max(initial=0.0)) / STEP_S
        """of any receiver on its path"""

    def at(self, receiver: ArrayLike, time_s: ArrayLike) -> Floats:
        """(…, 3) places of receivers, by index, on their paths; m, NED."""
        where = np.clip(np.asarray(time_s) / STEP_S, 0.0, self._samples - 1.001)
        before = where.astype(np.int64)
        index = np.asarray(receiver) * self._samples + before
        start = self._places[index]
        return np.asarray(start + (self._places[index + 1] - start) * (where - before)[..., None])

    def meets_s(self, receiver: ArrayLike, from_s: ArrayLike, place_ned: Floats, speed_m_s: ArrayLike) -> Floats:
        """(…) when what leaves a place (…, 3) at `from_s` is with a receiver on its path, in the straight line.

        The fixed point of t = from_s + |p(t) - place| / speed, which is one while the receiver is the slower one.
        """
        start = np.asarray(from_s, dtype=np.float64)
        when = start
        for _ in range(ITERATIONS):
            way = self.at(receiver, when) - place_ned
            when = start + np.sqrt(np.square(way).sum(axis=-1)) / speed_m_s
        return np.asarray(when + MEETS_LATER_S)


def net_w(rate_w: ArrayLike, power_w: ArrayLike) -> Floats:
    """By how much the charge of a receiver that draws `power_w` grows each second of a transfer, W."""
    return np.maximum(np.subtract(rate_w, power_w), LEAST_W)


def _sampled(path: Floats, times: Floats) -> Floats:
    """(samples, 3) places on a path (corners, 4); before its first corner and after its last one it stands."""
    when = np.clip(times, path[0, 0], path[-1, 0])
    after = np.clip(np.searchsorted(path[:, 0], when), 1, len(path) - 1) if len(path) > 1 else 0 * times.astype(int)
    before = np.maximum(after - 1, 0)
    lasts_s = path[after, 0] - path[before, 0]
    share = np.where(lasts_s > 0.0, (when - path[before, 0]) / np.where(lasts_s > 0.0, lasts_s, 1.0), 1.0)
    return np.asarray(path[before, 1:] + (path[after, 1:] - path[before, 1:]) * share[:, None])


def _of(numbers: ArrayLike) -> Floats:
    return np.array(numbers, dtype=np.float64)
