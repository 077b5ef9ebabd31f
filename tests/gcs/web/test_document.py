"""The page as it was built: of the sources that lie beside it, small, and with the licences of what is inside."""

from __future__ import annotations

import gzip
import hashlib
import re
from pathlib import Path

from gcs.scenario.colours import DARK, LIGHT
from gcs.web import document

WEB = Path(document.__file__).parent
PAGE, BUILT = WEB / "page", WEB / "built"


def luminance(colour: str) -> float:
    """Relative luminance of `#rrggbb` (WCAG 2.2)."""
    shares = [int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in shares]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(a: str, b: str) -> float:
    low, high = sorted((luminance(a), luminance(b)))
    return (high + 0.05) / (low + 0.05)


def test_the_built_page_is_of_these_sources() -> None:
    """gcs/web/page/build.sh was run after the last change."""
    sources = [*sorted(PAGE.glob("*.js")), PAGE / "page.css"]
    told = hashlib.sha256(b"".join(path.read_bytes() for path in sources)).hexdigest()[:16]
    assert document.built(document.SCRIPT).startswith(f"/* of sources {told} */")


def test_the_page_is_small_and_names_its_licences() -> None:
    assert sum(path.stat().st_size for path in BUILT.iterdir()) < 900_000
    assert len(gzip.compress(document.built(document.SCRIPT).encode())) < 250_000
    licences = (BUILT / "LICENSES.txt").read_text(encoding="utf-8")
    for name in ("three", "uplot"):
        assert re.search(rf"^{name} \d+\.\d+\.\d+, https://", licences, re.MULTILINE)
    assert licences.count("Permission is hereby granted") == 2


def test_the_page_builds_no_markup_of_text_and_evaluates_none() -> None:
    for path in PAGE.glob("*.js"):
        assert not re.search(
            r"innerHTML|outerHTML|insertAdjacentHTML|document\.write|\beval\(|new Function", path.read_text()
        )


def test_every_vehicles_colour_stands_out_from_its_ground() -> None:
    assert len(LIGHT) == len(DARK) == len(set(LIGHT)) == len(set(DARK))
    assert min(contrast(colour, "#ffffff") for colour in LIGHT) >= 3.0
    assert min(contrast(colour, "#12161b") for colour in DARK) >= 3.0
