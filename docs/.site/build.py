"""Builds the documentation's site into .docs-site/site/, offline: `make docs`.

    python docs/.site/build.py [--builder PYTHON] [--into FOLDER]

Needs a Python that has Skytender; `--builder` is the one that has what docs/.site/requirements.txt names, by default
the same. The pages of docs/ are copied to FOLDER/docs/, the generated ones are written beside them, and the site is
built from there. A broken link, a missing heading or an object that cannot be documented is a failure.
"""

from __future__ import annotations

import argparse
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import generate
import yaml

HERE = Path(__file__).resolve().parent
DOCS, ROOT = HERE.parent, HERE.parent.parent
REFERENCE = "reference/"
MISSING = """\
The documentation's builder is not installed in {python}.
Install it with: {python} -m pip install -r docs/.site/requirements.txt"""


def main() -> int:
    """The exit status of the first step that failed, or 0."""
    parser = argparse.ArgumentParser(description="Build the documentation's site.")
    parser.add_argument("--builder", default=sys.executable, metavar="PYTHON", help="a Python that has the builder")
    parser.add_argument("--into", default=ROOT / ".docs-site", type=Path, metavar="FOLDER", help="written anew")
    options = parser.parse_args()
    builder = str(Path(options.builder).absolute())
    if not installed(builder):
        print(MISSING.format(python=options.builder), file=sys.stderr)
        return 2
    stage = options.into.resolve()
    shutil.rmtree(stage, ignore_errors=True)
    shutil.copytree(DOCS, stage / "docs", ignore=shutil.ignore_patterns(".*", "*.py"))
    generate.write(stage / "docs" / "reference")
    config = yaml.safe_load((HERE / "mkdocs.yml").read_text(encoding="utf-8").replace("ROOT", str(ROOT)))
    config["nav"] = with_generated(config["nav"])
    (stage / "mkdocs.yml").write_text(yaml.safe_dump(config, sort_keys=False), encoding="utf-8")
    step = [builder, "-m", "zensical", "build", "--strict", "--clean", "--config-file", "mkdocs.yml"]
    if status := subprocess.run(step, cwd=stage, check=False).returncode:
        return status
    link_citations(stage / "site" / "python-api.html")
    print(stage / "site" / "index.html")
    return 0


def with_generated(navigation: Any) -> Any:
    """The navigation, in which a folder of generated pages stands for all of them in their order."""
    if isinstance(navigation, list):
        return [with_generated(part) for part in navigation]
    if isinstance(navigation, dict):
        return {title: with_generated(part) for title, part in navigation.items()}
    if not navigation.endswith("/"):
        return navigation
    folder = navigation.removeprefix(REFERENCE)
    return [
        {"Overview" if name == f"{folder}index.md" else text.partition("\n")[0].removeprefix("# "): REFERENCE + name}
        for name, text in generate.pages().items()
        if name.startswith(folder) and name.endswith(".md")
    ]


def link_citations(page: Path) -> None:
    """Turn what docstrings cite of docs/ into links."""
    cited = re.compile(r"docs/(?P<page>[a-z/-]+)\.md(?P<anchor>#[a-z0-9-]+)?")

    def link(match: re.Match[str]) -> str:
        anchor = match["anchor"] or ""
        words = (anchor or match["page"]).lstrip("#").replace("-", " ")
        return f'<a href="{match["page"]}.html{anchor}">{words}</a>'

    page.write_text(cited.sub(link, page.read_text(encoding="utf-8")), encoding="utf-8")


def installed(python: str) -> bool:
    """Whether a Python has the builder."""
    asked = [python, "-c", "import mkdocstrings_handlers.python, zensical"]
    try:
        return subprocess.run(asked, capture_output=True, check=False).returncode == 0
    except OSError:
        return False


if __name__ == "__main__":
    raise SystemExit(main())
