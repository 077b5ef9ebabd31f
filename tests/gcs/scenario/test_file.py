"""Shipped scenarios are found by name, files before them, and what is neither is refused with the names."""

from pathlib import Path

import pytest

from gcs.scenario import file
from gcs.scenario.model import ScenarioError


def test_a_shipped_scenario_is_found_by_name_from_anywhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert file.find("demo") == file.shipped_folder() / "demo.yaml"
    assert "demo" in file.shipped_names()


def test_a_file_comes_before_a_shipped_name_and_a_folder_after_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "demo").mkdir()
    assert file.find("demo") == file.shipped_folder() / "demo.yaml"
    (tmp_path / "demo").rmdir()
    (tmp_path / "demo").touch()
    assert file.find("demo") == Path("demo")


@pytest.mark.parametrize("name", ["dmeo", "", "\0", "../pyproject", "x" * 5000])
def test_what_is_neither_file_nor_name_is_refused_with_the_names(name: str) -> None:
    with pytest.raises(ScenarioError, match=r"no such file.*demo") as caught:
        file.find(name)
    assert ("did you mean 'demo'?" in str(caught.value)) == (name == "dmeo")


def test_an_installed_package_finds_the_configs_inside_itself(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    inside = tmp_path / "gcs" / "configs" / "paper"
    inside.mkdir(parents=True)
    (inside / "example1.yaml").touch()
    monkeypatch.setattr(file, "__file__", str(tmp_path / "gcs" / "scenario" / "file.py"))
    assert file.shipped_names() == ("paper/example1",)
    assert file.find("paper/example1") == inside / "example1.yaml"
