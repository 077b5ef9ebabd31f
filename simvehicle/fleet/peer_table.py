"""Places and leaders of peers, as their last reports have them: in compiled code, since each of a large fleet receives
all others in every period. NED, SI units."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import cython
from cython.cimports.cpython.bytes import PyBytes_AS_STRING
from cython.cimports.libc import math
from cython.cimports.libc.string import memcpy, memset
from cython.cimports.simvehicle.fleet.peer_table import VEHICLES
from cython.cimports.skytender.messages import (
    LOCAL_POSITION_NED_ID,
    POSITION_TARGET_TYPEMASK_AX_IGNORE,
    POSITION_TARGET_TYPEMASK_AY_IGNORE,
    POSITION_TARGET_TYPEMASK_AZ_IGNORE,
    LocalPositionNed,
    PositionTargetLocalNed,
)

Vec3 = tuple[float, float, float]


class PeerTable:
    """Last reports of up to VEHICLES peers, by system id; times are in ms, negative where nothing has come."""

    _peers: Any
    _period_s: float

    def __init__(self, sysids: Iterable[int], period_s: float) -> None:
        """Reports of others than `sysids` are passed over; `period_s`: for which a leader's acceleration is wanted."""
        memset(cython.address(self._peers[0]), 0, VEHICLES * cython.sizeof(self._peers[0]))
        for sysid in range(VEHICLES):
            self._peers[sysid].place_ms = self._peers[sysid].leader_ms = self._peers[sysid].arrived_ms = -1
        for sysid in sysids:
            self._peers[sysid].known = True
        self._period_s = period_s

    def receive(self, sysid: int, msgid: int, payload: bytes, now_ms: int) -> None:
        """Take in a LOCAL_POSITION_NED, or a POSITION_TARGET_LOCAL_NED that has an acceleration, which may lack zeros
        at its end; older and unreadable ones are passed over."""
        place, leader = cython.declare(LocalPositionNed), cython.declare(PositionTargetLocalNed)
        peer = cython.address(self._peers[sysid])
        if not peer.known:
            return
        if msgid == LOCAL_POSITION_NED_ID:
            memset(cython.address(place), 0, cython.sizeof(LocalPositionNed))
            memcpy(
                cython.address(place), PyBytes_AS_STRING(payload), min(len(payload), cython.sizeof(LocalPositionNed))
            )
            total = place.x + place.y + place.z + place.vx + place.vy + place.vz
            if peer.place_ms <= place.time_boot_ms <= now_ms and math.isfinite(total):
                peer.place_ms, peer.arrived_ms = place.time_boot_ms, now_ms
                peer.p[0], peer.p[1], peer.p[2] = place.x, place.y, place.z
                peer.v[0], peer.v[1], peer.v[2] = place.vx, place.vy, place.vz
            return
        memset(cython.address(leader), 0, cython.sizeof(PositionTargetLocalNed))
        memcpy(
            cython.address(leader), PyBytes_AS_STRING(payload), min(len(payload), cython.sizeof(PositionTargetLocalNed))
        )
        ignored = (
            POSITION_TARGET_TYPEMASK_AX_IGNORE | POSITION_TARGET_TYPEMASK_AY_IGNORE | POSITION_TARGET_TYPEMASK_AZ_IGNORE
        )
        total = (
            leader.x + leader.y + leader.z + leader.vx + leader.vy + leader.vz + leader.afx + leader.afy + leader.afz
        )
        if leader.type_mask & ignored or not peer.leader_ms < leader.time_boot_ms <= now_ms or not math.isfinite(total):
            return
        peer.leader_ms, peer.arrived_ms = leader.time_boot_ms, now_ms
        peer.lp[0], peer.lp[1], peer.lp[2] = leader.x, leader.y, leader.z
        peer.lv[0], peer.lv[1], peer.lv[2] = leader.vx, leader.vy, leader.vz
        peer.rp[0], peer.rp[1], peer.rp[2] = leader.x, leader.y, leader.z
        peer.rv[0], peer.rv[1], peer.rv[2] = leader.vx, leader.vy, leader.vz
        peer.wanted[0] = leader.vx + self._period_s * leader.afx
        peer.wanted[1] = leader.vy + self._period_s * leader.afy
        peer.wanted[2] = leader.vz + self._period_s * leader.afz

    def predict(self, sysid: int, p_ned: Vec3, v_ned: Vec3) -> None:
        """Let a leader be where it must have gone on to since its report."""
        peer = cython.address(self._peers[sysid])
        for i in range(3):
            peer.lp[i], peer.lv[i] = p_ned[i], v_ned[i]

    def worth_looking(
        self, now_ms: int, p_ned: Vec3, v_ned: Vec3, near_m: float, ahead_s: float, silent_s: float
    ) -> list[int]:
        """System ids of peers that come nearer than near_m if both fly straight on for ahead_s, and of those that have
        been silent for longer than silent_s, wherever they are."""
        found = []
        n, e, d = p_ned
        vn, ve, vd = v_ned
        for sysid in range(VEHICLES):
            peer = cython.address(self._peers[sysid])
            if peer.place_ms < 0 and peer.leader_ms < 0:
                continue
            last_ms = max(peer.place_ms, peer.leader_ms)
            led = peer.leader_ms >= peer.place_ms
            p, v = cython.address(peer.lp[0]) if led else cython.address(peer.p[0]), cython.address(peer.v[0])
            if led:
                v = cython.address(peer.lv[0])
            dn, de, dd = p[0] - n, p[1] - e, p[2] - d
            wn, we, wd = v[0] - vn, v[1] - ve, v[2] - vd
            square = wn * wn + we * we + wd * wd
            t_s = 0.0
            if square > 0.0:
                t_s = min(max(-(dn * wn + de * we + dd * wd) / square, 0.0), ahead_s)
            dn, de, dd = dn + t_s * wn, de + t_s * we, dd + t_s * wd
            if now_ms - last_ms > 1e3 * silent_s or dn * dn + de * de + dd * dd < near_m * near_m:
                found.append(sysid)
        return found

    def place(self, sysid: int) -> tuple[int, Vec3, Vec3]:
        """When a peer reported its place, that place, and its velocity."""
        m = cython.address(self._peers[sysid])
        return m.place_ms, (m.p[0], m.p[1], m.p[2]), (m.v[0], m.v[1], m.v[2])

    def leader(self, sysid: int) -> tuple[int, Vec3, Vec3, Vec3]:
        """When a peer reported its leader, where that is, its velocity, and the velocity that it wants."""
        m = cython.address(self._peers[sysid])
        p, v = (m.lp[0], m.lp[1], m.lp[2]), (m.lv[0], m.lv[1], m.lv[2])
        return m.leader_ms, p, v, (m.wanted[0], m.wanted[1], m.wanted[2])

    def arrived(self, sysid: int) -> int:
        """When the last report of a peer came, which may have been long on its way."""
        return self._peers[sysid].arrived_ms

    def newest(self, sysid: int) -> tuple[int, Vec3, Vec3]:
        """Time, place and velocity of a peer's last report of its leader; of its own place where the leader's report is
        missing or a second older."""
        m = cython.address(self._peers[sysid])
        led = m.leader_ms >= 0 and m.leader_ms > m.place_ms - 1000
        if led:
            return m.leader_ms, (m.rp[0], m.rp[1], m.rp[2]), (m.rv[0], m.rv[1], m.rv[2])
        return m.place_ms, (m.p[0], m.p[1], m.p[2]), (m.v[0], m.v[1], m.v[2])
