"""Entry point: exit status, one clear line for every failure, and signals. It must import nothing slow.

0 done; 2 the input is wrong (files, fields, options, an output that cannot be written)
or the run was interrupted; 1 varistiff itself failed.
"""

from __future__ import annotations

import gc
import os
import signal
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from types import FrameType

from varistiff.core.errors import InputError

DONE, FAILED, WRONG_INPUT = 0, 1, 2
QUICK = ("analyse", "evaluate")


class Interrupted(BaseException):
    """A signal asked the run to stop; not an Exception, so that nothing on the way takes it for a failure."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit status."""
    try:
        given = list(sys.argv[1:] if arguments is None else arguments)
        with _signals(), _uncollected(given[:1]):
            try:
                status = _command(given)
                sys.stdout.flush()
                return status
            except BrokenPipeError:  # the reader, such as `head`, has what it wanted
                _discard_output()
                return DONE
            except InputError as error:
                return _say(str(error), WRONG_INPUT)
            except OSError as error:
                return _failed_system_call(error)
            except Exception as error:
                return _failed(error)
    except (Interrupted, KeyboardInterrupt):
        return _say("interrupted", WRONG_INPUT)


def _command(arguments: list[str]) -> int:
    if arguments == ["--help"]:  # the same text as the app's own, without the time that importing it takes
        print(Path(__file__).with_name("help.txt").read_text(encoding="utf-8"), end="")
        return DONE
    import typer

    from varistiff.cli.app import app
    from varistiff.core.kernel_cache import keep_compiled_kernels

    keep_compiled_kernels()
    try:
        result = typer.main.get_command(app)(arguments, prog_name="varistiff", standalone_mode=False)
    except typer.Exit as error:
        return int(error.exit_code)
    except typer.Abort:
        raise Interrupted from None
    except SystemExit:  # how typer ends when the reader of standard output has gone
        raise BrokenPipeError from None
    except Exception as error:
        # usage errors by their face: typer brings its own copy of click from version to version
        message = getattr(error, "format_message", None)
        if message is None:
            raise
        raise InputError(f"{_one_line(message())}; see varistiff --help") from None
    return int(result or DONE)


def _failed_system_call(error: OSError) -> int:
    import errno

    if error.errno in (errno.ENOSPC, errno.EDQUOT, errno.EFBIG):
        _discard_output()
        what = error.filename if error.filename is not None else "the output"
        return _say(f"{what} cannot be written: {(error.strerror or 'disk full').lower()}", WRONG_INPUT)
    return _failed(error)


def _failed(error: Exception) -> int:
    if os.environ.get("VARISTIFF_DEBUG"):
        import traceback

        traceback.print_exc()
    what = _one_line(f"{type(error).__name__}: {error}")[:200]
    return _say(
        f"varistiff itself failed ({what}); please report it to the project, with the design "
        "file and what VARISTIFF_DEBUG=1 shows",
        FAILED,
    )


def _say(line: str, status: int) -> int:
    with suppress(OSError):  # nobody can be told
        print(f"varistiff: {_one_line(line)}", file=sys.stderr, flush=True)
    return status


def _one_line(text: str) -> str:
    line = " ".join(text.split())
    return "".join(character if character.isprintable() else "?" for character in line)


def _discard_output() -> None:
    """Let the interpreter's own last flush of standard output succeed."""
    with suppress(OSError, ValueError):  # standard output may be no file, as under a test
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


@contextmanager
def _uncollected(command: list[str]) -> Iterator[None]:
    """Leave cyclic garbage lying: a quick command makes little, and looking for it takes a twelfth of its time."""
    was = gc.isenabled()
    if command and command[0] in QUICK:
        gc.disable()
    try:
        yield
    finally:
        if was:
            gc.enable()


@contextmanager
def _signals() -> Iterator[None]:
    """Turn the first SIGINT or SIGTERM into ``Interrupted``; ignore later ones, so that cleaning up ends."""
    watched = (signal.SIGINT, signal.SIGTERM)

    def stop(number: int, frame: FrameType | None) -> None:
        for each in watched:
            signal.signal(each, signal.SIG_IGN)
        raise Interrupted

    try:
        before = {each: signal.signal(each, stop) for each in watched}
    except ValueError:  # not the main thread: signals are somebody else's
        yield
        return
    try:
        yield
    finally:
        for each, handler in before.items():
            signal.signal(each, handler)
