"""Autopilots' own logs as recordings: a DataFlash log (.BIN) or a ULog (.ulg) as the MAVLink that its vehicle would
have sent, in a .tlog of a temporary folder. What reads a .tlog so reads them all, alone and several as one."""

from __future__ import annotations

from gcs.recording.importing.beside import beside
from gcs.recording.importing.sample import ImportFailed
from gcs.recording.importing.sources import Opened, opened

__all__ = ["ImportFailed", "Opened", "beside", "opened"]
