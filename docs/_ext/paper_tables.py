"""The generated parts of the papers' pages: boards, equations and our figures."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any

from varistiff.papers.claim import Role
from varistiff.papers.equation import load_equations
from varistiff.papers.finding import Finding
from varistiff.papers.paper_figure import PaperFigure, load_figures
from varistiff.papers.registry import PAPERS, paper_file
from varistiff.papers.reproduce import counts, reproduce
from varistiff.papers.verdict import Verdict
from varistiff.report.reproduction.drawings import draw_all
from varistiff.report.reproduction.table import HEADER, line, summary
from varistiff.report.style import Drawing


@cache
def board(paper: str) -> tuple[Finding, ...]:
    """Compute the board of a paper, once a build."""
    return tuple(reproduce([paper]))


@cache
def drawings(paper: str) -> tuple[tuple[PaperFigure, Drawing], ...]:
    """Draw our figures of a paper, once a build."""
    return tuple(draw_all(paper))


def scoreboard(paper: str) -> str:
    """Return the results of a paper, with the reasons, and its inputs."""
    findings = board(paper)
    results = [finding for finding in findings if finding.claim.role is Role.RESULT]
    inputs = [finding for finding in findings if finding.claim.role is Role.INPUT]
    rows = []
    for finding in results:
        said = line(finding)
        what = _plain(f"{said.what}. {said.reason}" if said.reason else said.what)
        computed = said.computed
        if finding.difference is not None:
            computed = f"{computed}; off by {said.difference}, allowed {said.tolerance}"
        rows.append((_plain(said.where), what, _plain(said.published), _plain(computed), said.verdict))
    given = [tuple(map(_plain, line(finding).cells[:3])) for finding in inputs]
    return "\n\n".join(
        [
            summary(findings),
            _wide(("where", "what", "published", "computed", "verdict"), (15, 41, 15, 15, 14), rows),
            "The paper starts from these numbers:",
            _wide(HEADER[:3], (30, 50, 20), given),
        ]
    )


def equations(paper: str) -> str:
    """Return the equations of a paper: what implements them, and the corrected ones."""
    rows = []
    for equation in load_equations(paper):
        names = ", ".join(f"`{name.partition(':')[2]}`" for name in equation.implemented_by)
        rows.append((equation.number, equation.what, names, equation.correction or "as printed"))
    return _table(("number", "what", "in varistiff", "standing"), rows)


def figures(paper: str) -> str:
    """Return our figures, each with what the paper's shows; and why there is none of the others."""
    drawn = {figure.number: drawing for figure, drawing in drawings(paper)}
    parts = []
    for figure in load_figures(paper):
        if figure.number in drawn:
            drawing = drawn[figure.number]
            path = f"../figures/generated/paper_{paper}_{drawing.name}.svg"
            image = f"```{{image}} {path}\n:alt: {drawing.title}\n```"
            parts.append(f"**{figure.number}.** {_sentence(figure.shows)} {drawing.caption}\n\n{image}")
        else:
            parts.append(f"**{figure.number}.** {_sentence(figure.shows)} Not drawn: {figure.reason}")
    return "\n\n".join(parts)


def _sentence(text: str) -> str:
    return f"{text.rstrip('.')}."


def overview() -> str:
    """Return how many results of each paper have each verdict."""
    verdicts = [verdict for verdict in Verdict if verdict is not Verdict.INPUT]
    rows = []
    for paper in PAPERS:
        found = counts(board(paper))
        rows.append((f"[{paper}]({paper}.md)", *(str(found[verdict]) for verdict in verdicts)))
    return _table(("paper", *(verdict.value.replace("_", " ") for verdict in verdicts)), rows)


def verdicts() -> str:
    """Return what each verdict means."""
    rows = [(f"`{verdict.value}`", verdict.meaning) for verdict in Verdict]
    return _table(("verdict", "meaning"), rows)


def reading(paper: str) -> str:
    """Return the design file of a paper's corrected reading."""
    return f"```yaml\n{paper_file(paper, 'corrected_reading.yaml').read_text(encoding='utf-8')}```"


def draw_figures(app: Any) -> None:
    """Write our figures of every paper."""
    generated = Path(app.srcdir) / "figures" / "generated"
    generated.mkdir(exist_ok=True)
    for paper in PAPERS:
        for _, drawing in drawings(paper):
            (generated / f"paper_{paper}_{drawing.name}.svg").write_text(drawing.svg(), encoding="utf-8")


def _table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    cells = [header, ("---",) * len(header), *rows]
    return "\n".join(f"| {' | '.join(cell.replace(chr(10), ' ') for cell in row)} |" for row in cells)


def _wide(header: Sequence[str], widths: Sequence[int], rows: Sequence[Sequence[str]]) -> str:
    """Return a table whose columns have widths of their own."""
    lines = ["```{list-table}", ":header-rows: 1", f":widths: {' '.join(map(str, widths))}", ""]
    for row in (header, *rows):
        for number, cell in enumerate(row):
            lines.append(f"{'  -' if number else '* -'} {cell}")
    return "\n".join([*lines, "```"])


def _plain(text: str) -> str:
    """Keep what is plain text from being read as markup."""
    for sign in "\\|*_`$<>[]~":
        text = text.replace(sign, f"\\{sign}")
    return text
