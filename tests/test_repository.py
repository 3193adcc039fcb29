"""The repository keeps its promises: commands exist, pages are complete, nothing names a machine."""

from __future__ import annotations

import doctest
import re
import shlex
import shutil
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest
import yaml

from varistiff.core.citations import citations
from varistiff.core.status import Status

TEXT = {".py", ".toml", ".md", ".yaml", ".yml", ".cff", ".txt", ".sh", ".html", ".css", ".json", ".cfg", ""}
MADE = {".git", ".venv", ".hypothesis", "results", "_build", "generated", "build", "dist"}
# a path into somebody's account or temporary folder; a host of a package index or on a private network
MACHINE = re.compile(
    r"(?<![\w.])/(?:home|root|Users|tmp|work|mnt|private)/\w"
    r"|\b(?:localhost|127\.0\.0\.1|10\.\d+\.\d+\.\d+|192\.168\.\d+\.\d+)\b"
    r"|--(?:extra-)?index-url|--find-links|file://"
)


def text_files(root: Path) -> Iterator[Path]:
    for path in sorted(root.rglob("*")):
        inside = path.relative_to(root).parts
        if path.is_file() and path.suffix in TEXT and not any(part in MADE or "cache" in part for part in inside):
            yield path


def test_no_file_names_a_machine(root: Path) -> None:
    own = Path(__file__).resolve()
    found = [
        f"{path.relative_to(root)}:{number}: {line.strip()[:120]}"
        for path in text_files(root)
        if path.resolve() != own
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1)
        if MACHINE.search(line)
    ]
    assert found == []


@pytest.mark.parametrize(
    "line",
    ["cd /home/anna/varistiff", "--extra-index-url x", "jax @ file:///x", "see 192.168.1.4", "p = '/tmp/x'"],
)
def test_the_search_for_machines_finds_one(line: str) -> None:
    assert MACHINE.search(line)


def test_constraints_are_pins_and_nothing_else(root: Path) -> None:
    lines = (root / "constraints.txt").read_text(encoding="utf-8").splitlines()
    pin = re.compile(r"[a-z0-9][a-z0-9._-]*==[0-9][0-9a-z.+]*( ; [a-z_]+ [<>=!]+ '[A-Za-z0-9.*]+'.*)?")
    assert [line for line in lines if not pin.fullmatch(line)] == []
    assert len(lines) > 20


def test_constraints_pin_every_dependency(root: Path) -> None:
    project = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    wanted = [
        *project["dependencies"],
        *(name for extra in project["optional-dependencies"].values() for name in extra),
    ]
    names = {re.split(r"[\[<>=~! ]", item, maxsplit=1)[0].lower() for item in wanted}
    pinned = {line.split("==")[0] for line in (root / "constraints.txt").read_text(encoding="utf-8").splitlines()}
    assert names <= pinned


def test_make_has_every_target_that_the_documents_name(root: Path) -> None:
    targets = set(re.findall(r"^([a-z]+):", (root / "Makefile").read_text(encoding="utf-8"), flags=re.MULTILINE))
    pages = [root / "README.md", root / "CONTRIBUTING.md", *(root / "docs").glob("*.md")]
    # a command stands in code: `make x`, or first on a line of a code block
    named = {
        target
        for page in pages
        for target in re.findall(r"(?:^|`)make ([a-z]+)", page.read_text(encoding="utf-8"), flags=re.MULTILINE)
    }
    assert {"analyse", "test"} <= named
    assert named <= targets


def blocks(page: Path, language: str) -> list[str]:
    text = page.read_text(encoding="utf-8")
    return re.findall(rf"^```{language}\n(.*?)^```", text, flags=re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize("page", ["README.md", "docs/reference/python.md"])
def test_python_of_a_page_runs(
    root: Path, page: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(root)
    found = blocks(root / page, "python")
    assert found
    exec(compile("\n".join(found), page, "exec"), {"__name__": "page"})
    assert "nan" not in capsys.readouterr().out


def test_python_of_the_tutorial_answers_what_it_says(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(root)
    text = "\n".join(blocks(root / "docs" / "tutorial.md", "pycon"))
    session = doctest.DocTestParser().get_doctest(text, {}, "tutorial", "docs/tutorial.md", 0)
    result = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(session)
    assert result.attempted > 10
    assert result.failed == 0


def test_commands_of_the_tutorial_answer_what_it_says(
    root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from varistiff.cli.main import main

    page = root / "docs" / "tutorial.md"
    shutil.copytree(root / "examples", tmp_path / "examples")
    design = (tmp_path / "examples" / "roller_beam.yaml").read_text(encoding="utf-8")
    (tmp_path / "no_unit.yaml").write_text(design.replace("194 GPa", "194"), encoding="utf-8")
    (points,) = [block for block in blocks(page, "text") if block.startswith("deflection,setting")]
    (tmp_path / "points.csv").write_text(points, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    sessions = blocks(page, "console")
    assert len(sessions) == 3
    for session in sessions:
        command, _, expected = session.partition("\n")
        main(shlex.split(command.removeprefix("$ varistiff ")))
        streams = capsys.readouterr()
        assert streams.out + streams.err == expected


def test_readme_shows_five_lines_of_python(root: Path) -> None:
    (block,) = blocks(root / "README.md", "python")
    assert len([line for line in block.splitlines() if line.strip()]) == 5


def test_pictures_of_the_readme_exist(root: Path) -> None:
    pictures = re.findall(r"!\[[^\]]+\]\(([^)]+)\)", (root / "README.md").read_text(encoding="utf-8"))
    assert pictures
    assert [name for name in pictures if not (root / name).is_file()] == []


def test_changelog_and_citation_know_the_version(root: Path) -> None:
    version = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["project"]["version"]
    assert f"\n## {version}\n" in (root / "CHANGELOG.md").read_text(encoding="utf-8")
    assert yaml.safe_load((root / "CITATION.cff").read_text(encoding="utf-8"))["version"] == version


def test_citation_file_agrees_with_the_citations_of_the_code(root: Path) -> None:
    cff = yaml.safe_load((root / "CITATION.cff").read_text(encoding="utf-8"))
    assert cff["cff-version"] == "1.2.0"
    assert cff["license"] == "Apache-2.0"
    known = {entry.title.lower(): entry for entry in citations().values()}
    assert len(cff["references"]) == 4
    for reference in cff["references"]:
        entry = known[reference["title"].lower()]
        assert (reference["year"], reference.get("doi")) == (entry.year, entry.doi)


def test_licence_is_the_whole_apache_licence(root: Path) -> None:
    text = (root / "LICENSE").read_text(encoding="utf-8")
    assert "Apache License" in text
    assert "Version 2.0, January 2004" in text
    assert "END OF TERMS AND CONDITIONS" in text


@pytest.mark.parametrize(
    "term",
    [
        "deflection",
        "setting",
        "load",
        "tangent stiffness",
        "secant stiffness",
        "adjusting load",
        "energy capacity",
        "active length",
        "elastica",
        "configurational force",
        "status",
        "torsion constant",
    ],
)
def test_glossary_defines(root: Path, term: str) -> None:
    text = (root / "docs" / "glossary.md").read_text(encoding="utf-8")
    entries = text.split("```{glossary}")[1].split("\n```")[0]
    assert re.search(rf"^{term}\n    \S", entries, flags=re.MULTILINE)


def test_every_kind_has_a_theory_and_every_status_a_remedy(root: Path) -> None:
    from varistiff.design.spec import json_schema

    theory = "".join(page.read_text(encoding="utf-8") for page in (root / "docs" / "theory").glob("*.md")).lower()
    kinds = json_schema()["properties"]["actuator"]["discriminator"]["mapping"]
    assert len(kinds) == 6
    for kind in kinds:
        assert kind.replace("_", " ") in theory
    assert all(status.remedy.endswith(".") for status in Status)


def test_every_command_is_documented(root: Path) -> None:
    from typer.main import get_command

    from varistiff.cli.app import app

    page = (root / "docs" / "reference" / "command_line.md").read_text(encoding="utf-8")
    commands = getattr(get_command(app), "commands", {})
    assert {"analyse", "evaluate", "validate", "schema"} <= set(commands)
    for name, command in commands.items():
        assert f"## `varistiff {name}" in page
        assert command.help
        # the options stand in the command's own section
        section = page.split(f"## `varistiff {name}")[1].split("\n## ")[0]
        for parameter in command.params:
            for option in parameter.opts:
                if option.startswith("--") and option != "--help":
                    assert f"`{option}`" in section
