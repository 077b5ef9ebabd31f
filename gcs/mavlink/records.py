"""Messages as rows of arrays: their layout on the wire as numpy reads it."""

from __future__ import annotations

from typing import Any

import numpy as np

from gcs.mavlink.codec import WireLayout


def dtype(layout: WireLayout, taken: frozenset[str] = frozenset()) -> np.dtype[Any]:
    """An uncut payload, little-endian and packed; a field whose name is `taken` comes with a `_` after it."""
    fields: list[Any] = []
    for name, form in zip(layout.record._fields, layout.formats, strict=True):
        label = f"{name}_" if name in taken else name
        if form[-1] == "s":
            fields.append((label, f"S{form[:-1]}"))
        else:
            fields.append((label, f"<{form[-1]}", (int(form[:-1]),) if len(form) > 1 else ()))
    return np.dtype(fields)
