"""``varistiff reproduce``: table, JSON, CSV, files, and what wrong input gets."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import pytest

from varistiff.cli.main import main
from varistiff.papers.claim import Claim
from varistiff.papers.finding import judge

FIELDS = {
    "paper", "id", "locator", "quantity", "published", "unit", "computed", "difference", "tolerance", "verdict",
    "reason", "inputs",
}  # fmt: skip
PAPER = "chacon_2011"  # the quickest board


def test_json_is_one_list_of_objects(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["reproduce", PAPER, "--format", "json"]) == 0
    records = json.loads(capsys.readouterr().out)
    assert records
    assert all(record.keys() >= FIELDS for record in records)
    assert {record["paper"] for record in records} == {PAPER}
    assert {record["inputs"] for record in records} <= {"published", "assumed", "fitted"}
    assert not [
        record["id"] for record in records if record["verdict"] == "reproduced" and record["inputs"] != "published"
    ]


def test_files_say_the_same_as_the_table(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    output = tmp_path / "board"
    assert main(["reproduce", PAPER, "--output", str(output)]) == 0
    table = capsys.readouterr().out
    records = json.loads((output / "scoreboard.json").read_text(encoding="utf-8"))
    rows = list(csv.DictReader(io.StringIO((output / "scoreboard.csv").read_text(encoding="utf-8"))))
    assert [row["id"] for row in rows] == [record["id"] for record in records]
    assert [row["verdict"] for row in rows] == [record["verdict"] for record in records]
    reproduced = sum(record["verdict"] == "reproduced" for record in records)
    assert f"{reproduced} reproduced" in table
    page = (output / "scoreboard.html").read_text(encoding="utf-8")
    assert f"{reproduced} reproduced" in page
    pictures = list((output / "figures").glob("*.png"))
    assert page.count("<figure>") == len(pictures) > 0
    assert all(picture.stem.startswith(PAPER) for picture in pictures)  # every paper has a figure 3
    assert "http://" not in page.replace("http://www.w3.org", "")  # nothing is fetched
    assert main(["validate", str(output / f"{PAPER}.yaml")]) == 0


def test_an_unexpected_verdict_gives_status_1_and_a_line(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    claim = Claim.model_validate(
        {
            "id": "one",
            "locator": "Table",
            "quantity": "x y",
            "published": "2",
            "computation": "a.b",
            "expected": "reproduced",
        }
    )
    monkeypatch.setattr("varistiff.papers.reproduce.load_claims", lambda paper: (claim,))
    monkeypatch.setattr("varistiff.papers.reproduce.find", lambda paper, claim: judge(paper, claim, 3.0))
    assert main(["reproduce", PAPER]) == 1
    streams = capsys.readouterr()
    assert streams.err.count("\n") == 1
    assert f"{PAPER}, one" in streams.err
    assert "unexpected" in streams.out


@pytest.mark.parametrize(
    "arguments, said",
    [
        (["wang_2023"], "wang_2024"),
        ([PAPER, "--format", "xml"], "json"),
    ],
)
def test_wrong_input_gets_one_line(arguments: list[str], said: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["reproduce", *arguments]) == 2
    streams = capsys.readouterr()
    assert streams.out == ""
    assert streams.err.count("\n") == 1
    assert said in streams.err


def test_a_directory_of_somebody_else_is_not_replaced(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "thesis.tex").write_text("mine", encoding="utf-8")
    assert main(["reproduce", PAPER, "--output", str(tmp_path)]) == 2
    assert capsys.readouterr().err.count("\n") == 1
    assert (tmp_path / "thesis.tex").read_text(encoding="utf-8") == "mine"
