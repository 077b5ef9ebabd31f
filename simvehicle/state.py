"""Where a vehicle's parameters outlive its process: one small JSON file per vehicle in a folder of the user's."""

from __future__ import annotations

import json
import os
from pathlib import Path


class StateError(ValueError):
    """A state file that cannot be read as one; the text names it."""


class StateFile:
    """The parameters of one vehicle that were ever changed, as SYSID.parameters.json in `folder`, made where missing.

    `values` is what is kept now.
    """

    def __init__(self, folder: Path, sysid: int) -> None:
        """Read what was kept before; raises StateError, and OSError where the folder cannot be used."""
        folder.mkdir(parents=True, exist_ok=True)
        self.path = folder / f"{sysid}.parameters.json"
        self.values: dict[str, float] = {}
        try:
            content = json.loads(self.path.read_text(encoding="utf-8"))
            self.values = {str(name): float(value) for name, value in content.items()}
        except FileNotFoundError:
            pass
        except (ValueError, AttributeError, TypeError) as error:
            raise StateError(f"{self.path} holds no parameters: mend it, or delete it to begin afresh") from error

    def keep(self, name: str, value: float) -> None:
        """Keep one value with the others; the old file stays whole until the new one is. Raises OSError."""
        self.values[name] = value
        new = self.path.with_suffix(".new")
        new.write_text(json.dumps(self.values, indent=1) + "\n", encoding="utf-8")
        os.replace(new, self.path)
