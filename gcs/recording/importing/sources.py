"""A recording as a .tlog, whatever it is."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from gcs.recording.importing import dataflash, ulog
from gcs.recording.importing.formats import Form, form_of
from gcs.recording.importing.sample import ImportFailed, Sample
from gcs.recording.importing.tlog_writer import write

_READERS: dict[Form, Callable[[Path], Iterator[Sample]]] = {
    Form.DATAFLASH: dataflash.samples,
    Form.ULOG: ulog.samples,
}


@contextmanager
def opened(source: Path) -> Iterator[Path]:
    """A recording or session that can be read for the while: the source itself where it is one.

    Raises ImportFailed, one sentence, for a file of another kind or that cannot be read as what it is; OSError.
    """
    form = form_of(source) if source.is_file() else Form.TLOG
    if form is Form.TLOG:
        yield source
        return
    if form in (Form.PLAN, Form.WAYPOINTS):
        advice = f"`gcs mission {source}` lists it, and `gcs replay RECORDING --plan {source}` shows it with a flight"
        raise ImportFailed(f"{source} is {form.value}, not a recording: {advice}.")
    if form not in _READERS:
        raise ImportFailed(f"{source} is {form.value}; give a .tlog, .tlog.raw, .rlog, .BIN or .ulg file.")
    with tempfile.TemporaryDirectory(prefix="gcs-import-") as folder:
        target = Path(folder) / source.name
        try:
            count = write(target, _READERS[form](source))
        except (OSError, ImportFailed):
            raise
        except Exception as error:  # pymavlink and pyulog raise all kinds of a broken log
            raise ImportFailed(f"{source} cannot be read as {form.value}: {error}.") from None
        if not count:
            raise ImportFailed(f"{source} is {form.value} without a position, an attitude or a mode.")
        yield target
