"""Layout of the main screen's panels, and its keys."""

from __future__ import annotations

from textual.binding import Binding, BindingType

from gcs.console.pages import heading
from gcs.session.order_table import ORDERS

CSS = """
MainScreen { background: $ground; overflow: hidden; }
MainScreen Panel { background: $ground; }
#session, #goal, #trouble, #keys { height: 1; }
#keys { background: $raised; }
#body { height: 1fr; }
.page { display: none; }
#left { width: 1fr; }
#right { width: 60; display: none; padding: 0 0 0 1; }
.page, #recent, #small-map, #small { height: 1fr; }
#course { height: 15; }
#small { display: none; }
"""

KEYS: list[BindingType] = [
    *(Binding(str(i), f"page('{name}')") for i, name in enumerate(heading.PAGES, 1)),
    Binding("tab", "turn(1)"),
    Binding("shift+tab", "turn(-1)"),
    Binding("up", "move(-1, 0)"),
    Binding("down", "move(1, 0)"),
    Binding("left", "move(0, -1)"),
    Binding("right", "move(0, 1)"),
    Binding("shift+up", "pan(1, 0)"),
    Binding("shift+down", "pan(-1, 0)"),
    Binding("shift+left", "pan(0, -1)"),
    Binding("shift+right", "pan(0, 1)"),
    Binding("pageup", "leaf(-1)"),
    Binding("pagedown", "leaf(1)"),
    Binding("home", "end(-1)"),
    Binding("end", "end(1)"),
    Binding("n", "choose(1)"),
    Binding("N", "choose(-1)"),
    Binding("enter", "page('vehicle')"),
    Binding("escape", "page('fleet')"),
    Binding("o", "order_by"),
    Binding("g", "go_to"),
    Binding("d", "look"),
    Binding("e", "fold"),
    Binding("z", "zoom(1)"),
    Binding("Z", "zoom(-1)"),
    Binding("plus,equals_sign", "faster(1)"),
    Binding("minus", "faster(-1)"),
    Binding("space", "play"),
    Binding("c", "follow"),
    Binding("a", "fit"),
    Binding("w", "filter('level')"),
    Binding("k", "filter('kind')"),
    Binding("v", "filter('vehicle')"),
    Binding("0", "filter('none')"),
    Binding("slash", "words"),
    Binding("question_mark", "help"),
    Binding("q", "close"),
    Binding("ctrl+c", "interrupt", priority=True),
    Binding("ctrl+z", "app.suspend_process", priority=True),
    *(Binding(order.key, f"ask('{order.command}')") for order in ORDERS),
]
