"""What ``varistiff reproduce`` does and prints."""

from __future__ import annotations

import shutil
import sys
from collections.abc import Sequence
from enum import StrEnum
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from varistiff.papers.finding import Finding

DONE, FAILED = 0, 1
WIDTH = 150  # of the table where the output is no terminal
SHARES = {"where": 4, "what": 10, "published": 4, "computed": 3, "difference": 3, "tolerance": 3}  # of its width


class Format(StrEnum):
    """What standard output gets."""

    TABLE = "table"
    JSON = "json"
    CSV = "csv"


def report_board(paper: str | None, *, shape: Format, directory: str | None) -> int:
    """Compute the board, write and print it.

    Parameters
    ----------
    paper : key of one paper, None for all
    shape : what standard output gets
    directory : for files and figures, None for none

    Returns
    -------
    Exit status: 0, or 1 where a claim differs from what is expected of it.

    Raises
    ------
    InputError : no such paper, or the directory cannot be written
    """
    from varistiff.core.writing import check_directory
    from varistiff.papers.registry import PAPERS, check_paper
    from varistiff.papers.reproduce import reproduce
    from varistiff.report.reproduction.table import summary, unexpected

    papers = PAPERS if paper is None else (check_paper(paper),)
    if directory is not None:
        from varistiff.report.reproduction.write import check_output

        check_output(directory)
        check_directory(directory)
    tell = _tell if sys.stderr.isatty() else _say_nothing
    findings = reproduce(papers, tell=tell)
    if directory is not None:
        from varistiff.report.reproduction.write import write_board

        write_board(findings, directory, tell=tell)
    _wipe(tell)
    _print(findings, shape)
    if shape is Format.TABLE:
        print(summary(findings))
    if directory is not None:
        print(f"Results are in {directory}", file=sys.stdout if shape is Format.TABLE else sys.stderr)
    wrong = unexpected(findings)
    for each in wrong:
        print(f"varistiff: {each.paper}, {each.claim.id}: {each.trouble}", file=sys.stderr)
    return FAILED if wrong else DONE


def _print(findings: Sequence[Finding], shape: Format) -> None:
    from varistiff.report.reproduction.records import as_csv, as_json

    if shape is Format.JSON:
        print(as_json(findings), end="")
    elif shape is Format.CSV:
        print(as_csv(findings), end="")
    else:
        _print_tables(findings)


def _print_tables(findings: Sequence[Finding]) -> None:
    from rich import box
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    from varistiff.core.citations import citation
    from varistiff.report.reproduction.table import HEADER, line, of_paper

    width = shutil.get_terminal_size((WIDTH, 24)).columns if sys.stdout.isatty() else WIDTH
    console = Console(width=width, highlight=False)
    for paper in dict.fromkeys(finding.paper for finding in findings):
        table = Table(box=box.HORIZONTALS, show_lines=True, show_edge=False, pad_edge=False)
        for name in HEADER:
            fixed = name == "verdict"
            table.add_column(name, no_wrap=fixed, ratio=None if fixed else SHARES[name])
        for finding in of_paper(findings, paper):
            table.add_row(*map(Text, line(finding).cells))
        console.print(Text(str(citation(paper))))
        console.print(table)
        console.print()


def _tell(what: str) -> None:
    """Write over the line before it."""
    print(f"\r\x1b[Kvaristiff: {what}", end="", file=sys.stderr, flush=True)


def _wipe(tell: object) -> None:
    if tell is _tell:
        print("\r\x1b[K", end="", file=sys.stderr, flush=True)


def _say_nothing(what: str) -> None:
    del what
