"""One colour for each vehicle, by its place in the scenario, in every picture: console, page, report and plan.

Distinct to colour-blind readers (Okabe and Ito 2008: hues of different lightness), darkened until each has a contrast
of 3 against white, or lightened until it has 3 against the dark ground. After the last colour the first comes again;
dashes, shapes and names tell those apart.
"""

from __future__ import annotations

LIGHT = ("#0072b2", "#d55e00", "#007a5a", "#aa3377", "#8a6d00", "#4b3fb5", "#5c6670", "#0f7c8c")
DARK = ("#56b4e9", "#ff8c42", "#2fc79f", "#ee8fc6", "#e8c547", "#a79bff", "#c4c4c4", "#6fd9e6")

SOURCES_LIGHT = ("#b9c2cb", "#5b8c2a", "#6b7682", "#c79a00", "#3f6fa0")
SOURCES_DARK = ("#56606b", "#9ccc65", "#8b97a3", "#ffd54f", "#8fb3d9")
"""of energy: initial, received, drawn, given, remaining"""

ALARM_LIGHT, ALARM_DARK = "#800010", "#e03050"
"""Of signs that say dead, silent or failing: apart from every vehicle's colour for normal sight, protanopia,
deuteranopia and tritanopia."""
