"""Output of `gcs run`: on the terminal, and in any case into the session's folder."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from gcs.session.plain_text import PlainView, View, clean

FILE = "session.log"


class VerboseView(PlainView):
    """The plain view, with a line for each vehicle under each line of progress."""

    def _print_progress(self, now_s: float) -> None:
        super()._print_progress(now_s)
        assert self._last is not None
        for vehicle in self._last["vehicles"]:
            self._write(_line(vehicle))


def _line(vehicle: Mapping[str, Any]) -> str:
    n, e, d = vehicle["p_ned"] or (float("nan"),) * 3
    state = vehicle["mode"] if vehicle["alive"] else "dead"
    line = f"{'':12}{clean(vehicle['label']):<12} {clean(state):<9} N {n:7.2f}  E {e:7.2f}  {0.0 - d:6.2f} m high"
    line += f"  {vehicle['speed_m_s']:5.2f} m/s  {100.0 * vehicle['battery']:5.1f} %"
    return f"{line}  {clean(vehicle['note'])}".rstrip()


class _Both(View):
    def __init__(self, shown: View, kept: View) -> None:
        self._shown, self._kept = shown, kept

    def show(self, snapshot: Any) -> None:
        self._kept.show(snapshot)
        self._shown.show(snapshot)

    def tick(self, now_s: float) -> None:
        self._kept.tick(now_s)
        self._shown.tick(now_s)

    def close(self) -> None:
        self._kept.close()
        self._shown.close()


@contextmanager
def logged(view: View, echo: Callable[[str], object], folder: Path) -> Iterator[tuple[View, Callable[[str], object]]]:
    """The view and the teller, all of it also written to FOLDER/session.log as lines; a full disk ends only that."""
    try:
        log = (folder / FILE).open("w", encoding="utf-8", buffering=1, errors="replace")
    except OSError:
        yield view, echo
        return

    def keep(line: str) -> None:
        with contextlib.suppress(OSError):
            log.write(line + "\n")

    def both(line: str) -> None:
        keep(line)
        echo(line)

    try:
        yield _Both(view, PlainView(keep)), both
    finally:
        with contextlib.suppress(OSError):  # closing tries once more to write what a full disk has not taken
            log.close()
