"""A recording as a .tlog, whatever it is."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from errno import EINVAL
from pathlib import Path
from typing import NamedTuple

from gcs.recording.importing import dataflash, ulog
from gcs.recording.importing.formats import Form, form_of
from gcs.recording.importing.sample import ImportFailed, Sample
from gcs.recording.importing.tlog_writer import write

Reader = Callable[[Path, list[str]], Iterator[Sample]]
"""Samples of a log; what it lacks is added to the list once all have been read, without the log's name."""
_READERS: dict[Form, Reader] = {
    Form.DATAFLASH: dataflash.samples,
    Form.ULOG: ulog.samples,
}


class Opened(NamedTuple):
    """A recording or session that can be read, and a sentence on each thing that the source lacks."""

    path: Path
    problems: list[str]


@contextmanager
def opened(source: Path) -> Iterator[Opened]:
    """A recording or session that can be read for the while: the source itself where it is one.

    Raises ImportFailed, one sentence, for a file of another kind or that cannot be read as what it is; OSError.
    """
    form = form_of(source) if source.is_file() else Form.TLOG
    if form is Form.TLOG:
        yield Opened(source, [])
        return
    if form in (Form.PLAN, Form.WAYPOINTS):
        advice = (
            f"`gcs mission show {source}` lists it, and `gcs replay RECORDING --plan {source}` shows it with a flight"
        )
        raise ImportFailed(f"{source} is {form.value}, not a recording: {advice}.")
    if form not in _READERS:
        raise ImportFailed(f"{source} is {form.value}; give a .tlog, .tlog.raw, .rlog, .BIN or .ulg file.")
    with tempfile.TemporaryDirectory(prefix="gcs-import-") as folder:
        target, lacks = Path(folder) / source.name, list[str]()
        try:
            count = write(target, _READERS[form](source, lacks))
        except ImportFailed:
            raise
        except Exception as error:  # pymavlink and pyulog raise all kinds of a broken log
            if isinstance(error, OSError) and error.errno != EINVAL:  # to seek before a file's begin is of the log
                raise
            raise ImportFailed(f"{source} cannot be read as {form.value}: {error}.") from None
        if not count:
            raise ImportFailed(f"{source} is {form.value} without a position, an attitude or a mode.")
        yield Opened(target, [f"{source.name}: {one}." for one in lacks])
