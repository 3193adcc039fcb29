"""Which directory a result may replace."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from varistiff.core.errors import InputError
from varistiff.core.textfile import printable_path

FIGURES = "figures"


def check_replaceable(output: str | os.PathLike[str], *, markers: Sequence[str], files: Sequence[str]) -> None:
    """Refuse a directory with anything in it that an earlier result of the same command did not write.

    Parameters
    ----------
    markers : a directory with all of these files is a result of ours
    files : all that a result may hold, beside ``figures``

    Raises
    ------
    InputError : something else is in it
    """
    target, shown = Path(output), printable_path(os.fspath(output))
    if not target.is_dir():
        return  # missing, or a file: writing says what is wrong with it
    try:
        entries = {entry.name: entry for entry in target.iterdir()}
        foreign = sorted(name for name, entry in entries.items() if not _ours(entry, files))
    except OSError as error:
        raise InputError(f"cannot be read: {error.strerror}; choose another --output", file=shown) from None
    if not entries:
        return
    if foreign or not all(name in entries for name in markers):
        what = f"holds {foreign[0]!r}, which" if foreign else "is not empty and holds no earlier result that"
        raise InputError(
            f"{what} a new result would not replace; allowed is a new or empty directory, or an earlier result",
            file=shown,
        )


def _ours(entry: Path, files: Sequence[str]) -> bool:
    if entry.name == FIGURES and entry.is_dir() and not entry.is_symlink():
        return all(part.suffix in (".svg", ".png") and part.is_file() for part in entry.iterdir())
    return entry.name in files and entry.is_file()
