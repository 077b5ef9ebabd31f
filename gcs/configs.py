"""Scenarios that ship with the package: `demo` is a name, `./demo.yaml` a file.

They stand in `configs/`: beside the packages in a checkout, inside `gcs` in an installed wheel.
"""

from pathlib import Path

from gcs.yaml_source import Problem, ScenarioError, did_you_mean


def folder() -> Path:
    """Where the shipped scenarios stand."""
    package = Path(__file__).resolve().parent
    inside = package / "configs"
    return inside if inside.is_dir() else package.parent / "configs"


def names() -> tuple[str, ...]:
    """The shipped scenarios' names in alphabetical order, such as `demo` and `paper/example1`."""
    root = folder()
    return tuple(sorted(path.relative_to(root).with_suffix("").as_posix() for path in root.rglob("*.yaml")))


def find(scenario: str) -> Path:
    """The file that `scenario` means: a file of that path if there is one, otherwise the shipped one of that name.

    Whatever else is there (a directory, a device) is returned as it is, for `load` to say what is wrong with it.
    Raises ScenarioError where nothing is.
    """
    path, shipped = Path(scenario), names()
    try:
        if path.is_file():
            return path
        if scenario in shipped:
            return folder() / f"{scenario}.yaml"
        if scenario and path.exists():
            return path
    except (OSError, ValueError):  # a name that the system cannot even look up
        pass
    near = did_you_mean(scenario, shipped)
    message = f"no such file, and no shipped scenario of that name ({', '.join(shipped)}){near}"
    raise ScenarioError([Problem(scenario, None, None, message)])
