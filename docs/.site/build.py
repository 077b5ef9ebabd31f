"""Builds the documentation's site into .docs-site/site/, offline.

    python docs/.site/build.py      # with a Python that has Skytender and what docs/.site/requirements.txt names

The pages of docs/ are copied to .docs-site/docs/, the generated ones are written beside them, and the site is built
from there. A broken link, a missing heading or an object that cannot be documented is a failure.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
DOCS, ROOT = HERE.parent, HERE.parent.parent
STAGE = ROOT / ".docs-site"
BUILDER = ("zensical", "build", "--strict", "--clean")


def main() -> int:
    """The exit status of the first step that failed, or 0."""
    shutil.rmtree(STAGE, ignore_errors=True)
    shutil.copytree(DOCS, STAGE / "docs", ignore=shutil.ignore_patterns(".*", "*.tsv", "*.py"))
    shutil.copy(HERE / "mkdocs.yml", STAGE)
    steps = (
        [sys.executable, str(HERE / "generate.py"), str(STAGE / "docs" / "reference")],
        [sys.executable, "-m", *BUILDER, "--config-file", "mkdocs.yml"],
    )
    for step in steps:
        if status := subprocess.run(step, cwd=STAGE, check=False).returncode:
            return status
    print(STAGE / "site" / "index.html")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
