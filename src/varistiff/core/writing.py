"""Results appear whole or not at all: written beside their target, then renamed onto it."""

from __future__ import annotations

import contextlib
import os
import secrets
import shutil
import stat
from collections.abc import Iterator
from pathlib import Path
from typing import TextIO

from varistiff.core.errors import InputError
from varistiff.core.textfile import printable_path, reason


@contextlib.contextmanager
def staged_file(target: str | os.PathLike[str]) -> Iterator[TextIO]:
    """Give a text stream whose content becomes ``target`` when the block ends well.

    On any failure, an interruption included, the target is as it was and nothing is left beside it. A target
    that is a device or a pipe is written to directly.

    Raises
    ------
    InputError : the target cannot be written, or the disk is full
    """
    final = Path(os.path.realpath(target))
    with _explained(target):
        if _is_special(final):
            with final.open("w", encoding="utf-8", newline="") as stream:
                yield stream
            return
        if final.is_dir():
            raise InputError("is a directory; allowed is the name of a file", file=printable_path(str(target)))
        with _parents(final):
            temporary = _beside(final)
            try:
                with temporary.open("x", encoding="utf-8", newline="") as stream:
                    yield stream
                    stream.flush()
                    os.fsync(stream.fileno())
                temporary.replace(final)
            except BaseException:
                temporary.unlink(missing_ok=True)
                raise


@contextlib.contextmanager
def staged_directory(target: str | os.PathLike[str]) -> Iterator[Path]:
    """Give an empty directory whose content moves to ``target`` when the block ends well.

    A target that exists keeps its other files; files of the same name are replaced.

    Raises
    ------
    InputError : the target cannot be written, or the disk is full
    """
    final = Path(os.path.realpath(target))
    with _explained(target):
        if final.exists() and not final.is_dir():
            raise InputError("is a file; allowed is the name of a directory", file=printable_path(str(target)))
        with _parents(final):
            temporary = _beside(final)
            temporary.mkdir()
            try:
                if final.is_dir():  # says early that the directory cannot be written to
                    probe = _beside(final / "probe")
                    probe.touch()
                    probe.unlink()
                yield temporary
                _move(temporary, final)
            finally:
                shutil.rmtree(temporary, ignore_errors=True)


class _DiscardError(Exception):
    """The staged directory was only a trial."""


def check_directory(target: str | os.PathLike[str]) -> None:
    """Find out, before a long computation, that a directory can be written; nothing is left behind.

    Raises
    ------
    InputError : it cannot
    """
    with contextlib.suppress(_DiscardError), staged_directory(target):
        raise _DiscardError


def _move(source: Path, target: Path) -> None:
    if not target.exists():
        source.rename(target)
        return
    for entry in sorted(source.iterdir()):
        destination = target / entry.name
        if entry.is_dir() and destination.is_dir():
            _move(entry, destination)
        else:
            entry.replace(destination)


def _is_special(path: Path) -> bool:
    try:
        mode = path.stat().st_mode
    except FileNotFoundError:
        return False
    return not (stat.S_ISREG(mode) or stat.S_ISDIR(mode))


def _beside(path: Path) -> Path:
    return path.with_name(f".{path.name[:100]}.{secrets.token_hex(4)}.part")


@contextlib.contextmanager
def _parents(path: Path) -> Iterator[None]:
    """Make the missing parents of a path, and take them away again on failure."""
    missing = [parent for parent in path.parents if not parent.exists()]
    made: list[Path] = []
    try:
        for parent in reversed(missing):
            parent.mkdir()
            made.append(parent)
        yield
    except BaseException:
        for parent in reversed(made):
            with contextlib.suppress(OSError):
                parent.rmdir()
        raise


@contextlib.contextmanager
def _explained(target: str | os.PathLike[str]) -> Iterator[None]:
    try:
        yield
    except OSError as error:
        file = printable_path(os.fspath(target))
        raise InputError(f"cannot be written: {reason(error)}; choose another --output", file=file) from None
