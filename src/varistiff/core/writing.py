"""Results appear whole or not at all: written beside their target, then renamed onto it."""

from __future__ import annotations

import contextlib
import errno
import os
import secrets
import shutil
import stat
from collections.abc import Iterator
from pathlib import Path
from typing import TextIO

from varistiff.core.errors import InputError
from varistiff.core.textfile import printable_path, reason

_EARLIER = "earlier"
_DISK = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EROFS)  # what a write says, without naming the file


@contextlib.contextmanager
def staged_file(target: str | os.PathLike[str], *, option: str = "--output") -> Iterator[TextIO]:
    """Give a text stream whose content becomes ``target`` when the block ends well.

    On any failure, an interruption included, nothing is left beside the target, which is as it was; or new, where
    the interruption came after the swap. A target that is a device or a pipe is written to directly. An error of
    the block that is not about the output passes unchanged.

    Parameters
    ----------
    option : that names the target on the command line

    Raises
    ------
    InputError : the target cannot be written, or the disk is full
    """
    with _explained(target, option):
        if _is_special(Path(target)):  # asked first: /dev/stdout as a pipe resolves to a path that is none
            with Path(target).open("w", encoding="utf-8", newline="") as stream, _block(Path(target)):
                yield stream
            return
        final = Path(os.path.realpath(target))
        if final.is_dir():
            raise InputError("is a directory; allowed is the name of a file", file=printable_path(str(target)))
        temporary = _beside(final)
        with _parents(final):
            try:
                try:
                    with temporary.open("x", encoding="utf-8", newline="") as stream:
                        with _block(temporary):
                            yield stream
                        stream.flush()
                        os.fsync(stream.fileno())
                    temporary.replace(final)
                finally:
                    temporary.unlink(missing_ok=True)
            except BaseException:
                temporary.unlink(missing_ok=True)  # again: a signal may have cut the first one short
                raise


@contextlib.contextmanager
def staged_directory(target: str | os.PathLike[str]) -> Iterator[Path]:
    """Give an empty directory that becomes ``target`` when the block ends well.

    A directory that is there already is replaced as a whole: the caller makes sure that it may be. On any failure,
    an interruption included, nothing is left beside the target, which is as it was; or new, where the interruption
    came after the swap. An error of the block that is not about the output passes unchanged.

    Raises
    ------
    InputError : the target cannot be written, or the disk is full
    """
    with _explained(target, "--output"):
        if Path(target).exists() and not Path(target).is_dir():
            raise InputError("is a file; allowed is the name of a directory", file=printable_path(str(target)))
        final = Path(os.path.realpath(target))
        if final.is_dir() and not os.access(final, os.W_OK):  # said before the block, not after
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), str(final))
        staging = _beside(final)
        fresh = staging / "fresh"
        with _parents(final):
            try:
                try:
                    staging.mkdir()
                    fresh.mkdir()
                    with _block(staging):
                        yield fresh
                    if final.is_dir():
                        final.rename(staging / _EARLIER)
                    fresh.rename(final)
                finally:
                    _settle(staging, final)
            except BaseException:
                _settle(staging, final)  # again: a signal may have cut the first one short
                raise


def _settle(staging: Path, final: Path) -> None:
    """Bring back what stepped aside, unless its successor stands, and remove the rest."""
    earlier = staging / _EARLIER
    if earlier.exists() and not final.exists():
        try:
            earlier.rename(final)
        except OSError as error:
            shown = printable_path(str(earlier))
            raise InputError(f"cannot be put back: {reason(error)}; it is in {shown}", file=str(final)) from None
    for _ in range(2):  # a signal inside rmtree may surface as an OSError of its own
        with contextlib.suppress(OSError):
            shutil.rmtree(staging, ignore_errors=True)


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


def _is_special(path: Path) -> bool:
    try:
        mode = path.stat().st_mode
    except FileNotFoundError:
        return False
    return not (stat.S_ISREG(mode) or stat.S_ISDIR(mode))


def _beside(path: Path) -> Path:
    return path.with_name(f".{path.name[:50]}.{secrets.token_hex(4)}.part")


@contextlib.contextmanager
def _parents(path: Path) -> Iterator[None]:
    """Make the missing parents of a path, and take them away again on failure if nothing is in them."""
    missing = [parent for parent in path.parents if not parent.exists()]
    try:
        for parent in reversed(missing):
            parent.mkdir(exist_ok=True)  # another run may have made it meanwhile
        yield
    except BaseException:
        for parent in missing:
            with contextlib.suppress(OSError):
                parent.rmdir()
        raise


class _PassedError(Exception):
    """Carries an error of the block past the explanation of ours."""

    def __init__(self, error: OSError) -> None:
        self.error = error


@contextlib.contextmanager
def _block(output: Path) -> Iterator[None]:
    try:
        yield
    except OSError as error:
        unnamed = error.filename is None and error.errno in _DISK
        if unnamed or (error.filename is not None and _is_under(os.fsdecode(error.filename), output)):
            raise
        raise _PassedError(error) from None


def _is_under(name: str, output: Path) -> bool:
    return Path(name) == output or output in Path(name).parents


@contextlib.contextmanager
def _explained(target: str | os.PathLike[str], option: str) -> Iterator[None]:
    try:
        yield
    except _PassedError as passed:
        raise passed.error from passed.error.__cause__
    except BrokenPipeError:  # the reader of the pipe has what it wanted
        raise
    except OSError as error:
        file = printable_path(os.fspath(target))
        raise InputError(f"cannot be written: {reason(error)}; choose another {option}", file=file) from None
