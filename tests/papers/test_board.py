"""Every claim of every paper gets the verdict that is expected of it, and what the data name exists."""

from __future__ import annotations

import inspect
import re
from importlib import import_module
from pathlib import Path

import pytest

import varistiff
from varistiff.core.citations import citation
from varistiff.papers.claims import load_claims
from varistiff.papers.equation import load_equations
from varistiff.papers.paper_figure import load_figures
from varistiff.papers.registry import PAPERS, computation, paper_file
from varistiff.papers.reproduce import counts, reproduce
from varistiff.papers.verdict import Verdict

COUNTED = (Verdict.REPRODUCED, Verdict.CONTRADICTED, Verdict.UNDERDETERMINED, Verdict.FITTED)


@pytest.mark.parametrize("paper", PAPERS)
def test_every_claim_is_as_expected_and_the_readme_counts_them(root: Path, paper: str) -> None:
    findings = reproduce([paper])
    assert [
        (each.claim.id, each.computed, each.trouble) for each in findings if each.verdict is Verdict.UNEXPECTED
    ] == []
    found = counts(findings)
    assert found[Verdict.NOT_RUN] == 0  # the tests have every extra
    words, cells = readme_row(root, "paper"), readme_row(root, f"`{paper}`")
    assert dict(zip(words, map(int, cells), strict=True)) == {verdict.value: found[verdict] for verdict in COUNTED}


def readme_row(root: Path, first: str) -> list[str]:
    row = re.search(rf"^\| {first} \|(.*)\|$", (root / "README.md").read_text(encoding="utf-8"), flags=re.MULTILINE)
    assert row is not None
    return [cell.strip() for cell in row[1].split("|")]


@pytest.mark.parametrize("paper", PAPERS)
def test_computations_take_the_arguments_that_claims_give(paper: str) -> None:
    computed = [claim for claim in load_claims(paper) if claim.computation is not None]
    assert computed
    for claim in computed:  # bind raises where they do not fit
        inspect.signature(computation(paper, str(claim.computation))).bind(**claim.arguments)


@pytest.mark.parametrize("paper", PAPERS)
def test_every_proof_is_a_test(root: Path, paper: str) -> None:
    proofs = [claim.proof for claim in load_claims(paper)] + [each.proof for each in load_equations(paper)]
    for proof in filter(None, proofs):
        path, _, name = proof.partition("::")
        text = (root / path).read_text(encoding="utf-8")
        assert re.search(rf"^def {name}\(", text, flags=re.MULTILINE), proof


@pytest.mark.parametrize("paper", PAPERS)
def test_every_equation_has_a_function_in_the_public_code(paper: str) -> None:
    equations = load_equations(paper)
    assert equations
    for equation in equations:
        for name in equation.implemented_by:
            module, _, path = name.partition(":")
            found = import_module(module)
            for part in path.split("."):
                assert not part.startswith("_")
                found = getattr(found, part)
            assert inspect.getdoc(found), name


@pytest.mark.parametrize("paper", PAPERS)
def test_every_figure_is_drawn_or_says_why_not(paper: str) -> None:
    ids = {claim.id for claim in load_claims(paper)}
    figures = load_figures(paper)
    assert any(figure.drawn_by for figure in figures)
    for figure in figures:
        assert set(figure.claims) <= ids, figure.number
        if figure.drawn_by is not None:
            module, _, function = figure.drawn_by.rpartition(".")
            assert callable(getattr(import_module(f"varistiff.report.papers.{module or paper}"), function))


@pytest.mark.parametrize("paper", PAPERS)
def test_the_corrected_reading_is_a_design(paper: str, tmp_path: Path) -> None:
    path = tmp_path / "reading.yaml"
    path.write_text(paper_file(paper, "corrected_reading.yaml").read_text(encoding="utf-8"), encoding="utf-8")
    assert paper in varistiff.load(path).actuator.references


@pytest.mark.parametrize("paper", PAPERS)
def test_the_paper_has_its_citation_and_its_page(root: Path, paper: str) -> None:
    assert citation(paper).year == int(paper[-4:])
    page = (root / "docs" / "papers" / f"{paper}.md").read_text(encoding="utf-8")
    for part in ("scoreboard", "equations", "figures"):
        assert f"../generated/paper_{paper}_{part}.md" in page
