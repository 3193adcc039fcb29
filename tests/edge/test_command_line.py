"""The command line: exit status, one clear line, nothing left behind. No actuator is needed here."""

from __future__ import annotations

import contextlib
import errno
import gc
import io
import json
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from varistiff.core.errors import InputError
from varistiff.design.design import Design
from varistiff.sections.section import _kept

COMMANDS = ("analyse", "evaluate", "simulate", "reproduce", "validate", "schema", "materials", "verify")


def names(directory: Path) -> list[str]:
    return sorted(path.name for path in directory.iterdir())


@pytest.fixture
def stalled(monkeypatch: pytest.MonkeyPatch) -> Callable[[Callable[[], object]], None]:
    """Let the computation of ``evaluate`` do something else."""

    def install(action: Callable[[], object]) -> None:
        monkeypatch.setattr(Design, "evaluate", lambda *_: action())

    return install


def test_help_is_the_same_as_the_commands_own(run: Callable[..., Any], monkeypatch: pytest.MonkeyPatch) -> None:
    import typer

    from varistiff.cli.app import app

    shown = run("--help")
    assert shown.status == 0
    monkeypatch.setenv("COLUMNS", "80")
    own = io.StringIO()
    with contextlib.redirect_stdout(own):
        typer.main.get_command(app)(["--help"], prog_name="varistiff", standalone_mode=False)
    assert shown.out == own.getvalue()
    for command in COMMANDS:
        assert f"\n  {command} " in shown.out
        assert run(command, "--help").status == 0


def test_help_imports_nothing_slow() -> None:
    """The time that it takes is measured in benchmarks/; here is what keeps it short."""
    script = (
        "import sys; from varistiff.cli.main import main; main(['--help']); "
        "sys.exit(', '.join({'typer', 'numpy', 'jax', 'pydantic', 'matplotlib'} & set(sys.modules)) or 0)"
    )
    done = subprocess.run([sys.executable, "-c", script], check=False, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")


def imported_of(slow: set[str], statement: str, *arguments: str) -> str:
    """Which of the slow modules a fresh process has imported after a statement."""
    script = f"import sys; {statement}; sys.exit(', '.join(sorted({slow!r} & set(sys.modules))) or 0)"
    done = subprocess.run([sys.executable, "-c", script, *arguments], check=False, capture_output=True, text=True)
    return done.stderr.strip() if done.returncode else ""


def test_one_kind_does_not_import_what_another_needs(
    tmp_path: Path, points: Path, example: Callable[[str], str]
) -> None:
    design = make(tmp_path, "beam.yaml", example("roller_beam").encode())
    points.write_text("deflection,setting\n0.1,0.3\n", encoding="utf-8")
    slow = {"scipy.linalg", "scipy.special", "pandas", "xarray", "matplotlib", "rich", "shapely"}
    slow.add("varistiff.actuators.torsion_tube")
    evaluated = "from varistiff.cli.main import main; main(sys.argv[1:])"
    found = imported_of(slow, evaluated, "evaluate", str(design), str(points), "--output", str(tmp_path / "out.csv"))
    assert (tmp_path / "out.csv").exists()
    assert found.splitlines()[1:] == []  # after the count of points


def test_pictures_without_a_section_do_without_scipy() -> None:
    drawn = "import varistiff.report.analyse, varistiff.report.figures, varistiff.report.mechanism.roller_beam"
    assert imported_of({"scipy.ndimage", "scipy.linalg"}, drawn) == ""


def test_a_quick_command_leaves_garbage_lying_and_others_do_not(
    run: Callable[..., Any], series: Path, points: Path, stalled: Callable[..., None], monkeypatch: pytest.MonkeyPatch
) -> None:
    collecting: list[bool] = []

    def note(*_: object, **__: object) -> None:
        collecting.append(gc.isenabled())
        raise InputError("enough")

    stalled(note)
    assert run("evaluate", series, points, "--output", series.parent / "out.csv").status == 2
    monkeypatch.setattr("varistiff.report.verify.verify", note)
    assert run("verify", series).status == 2
    assert collecting == [False, True]
    assert gc.isenabled()


def test_every_command_and_option_says_what_it_does() -> None:
    import typer

    from varistiff.cli.app import app

    command: Any = typer.main.get_command(app)
    assert set(command.commands) == set(COMMANDS)
    for each in command.commands.values():
        assert each.help
        for parameter in each.params:
            assert parameter.help


@pytest.mark.parametrize(
    "arguments, said",
    [
        ([], "Missing command"),
        (["evaluat"], "No such command 'evaluat'"),
        (["validate"], "Missing argument"),
        (["evaluate", "a.yaml", "b.csv"], "Missing option '--output'"),
        (["evaluate", "a.yaml"], "Missing"),
        (["schema", "--outpt"], "No such option"),
        (["--nothing"], "No such option"),
    ],
)
def test_wrong_usage_is_one_line(run: Callable[..., Any], arguments: list[str], said: str) -> None:
    result = run(*arguments)
    assert result.status == 2
    assert said in result.line
    assert result.out == ""


def test_validate_checks_every_file(run: Callable[..., Any], series: Path, tmp_path: Path) -> None:
    assert run("validate", series, series).out.count(": ok: Series elastic joint (series_elastic), hash ") == 2
    wrong = tmp_path / "wrong.yaml"
    wrong.write_text(series.read_text().replace("160 N*m/rad", "160 N*m"))
    result = run("validate", wrong, series)
    assert result.status == 2
    assert result.line.startswith(f"varistiff: {wrong}: actuator.stiffness: ")
    assert result.out.count(": ok: ") == 1


def test_validate_refuses_what_evaluate_would(
    run: Callable[..., Any], tmp_path: Path, example: Callable[[str], str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def unsolvable(_: object) -> None:
        raise InputError("walls are too thin; allowed are thicker ones")

    monkeypatch.setattr("varistiff.sections.solved.solved_properties", unsolvable)
    monkeypatch.setattr("varistiff.sections.section._kept", _kept.__wrapped__)
    design = make(tmp_path, "tube.yaml", example("splined_tube").encode())
    result = run("validate", design)
    assert result.status == 2
    assert result.line == f"varistiff: {design}: actuator.section: walls are too thin; allowed are thicker ones"
    assert result.out == ""


def test_schema_is_json_and_materials_are_listed(run: Callable[..., Any], tmp_path: Path) -> None:
    assert json.loads(run("schema").out)["title"] == "varistiff design"
    assert "spring_steel_1075" in run("materials").out
    assert "EN 10132-4" in run("materials", "--sources").out
    own = tmp_path / "own.yaml"
    own.write_text("bronze: {youngs_modulus: 110 GPa, source: test}\n")
    assert "bronze" in run("materials", "--materials", own).out
    own.write_text("bronze: {youngs_modulus: 110, source: test}\n")
    assert run("materials", "--materials", own).line.endswith("for example 194 GPa")


def make(tmp_path: Path, name: str, data: bytes) -> Path:
    path = tmp_path / name
    path.write_bytes(data)
    return path


@pytest.mark.parametrize("command", ["validate", "evaluate", "analyse"])
@pytest.mark.parametrize(
    "data, said",
    [
        (b"", "is empty"),
        (b"\x7fELF\x00\x00", "is a binary file"),
        (b"a: &a [*a]", "YAML anchors"),
        (b"name: x\nactuator: {kind: maccepas}", 'did you mean "maccepa"'),
        (b"name: x\nactuator: {kind: series_elastic, stiffness: 160}", "160 has no unit"),
        (b"\xff\xfea", "is not UTF-8"),
        (b"name: x\n---\nname: y\n", "holds 2 designs (x, y)"),
    ],
)
def test_a_wrong_design_is_exit_status_two(
    run: Callable[..., Any], tmp_path: Path, points: Path, command: str, data: bytes, said: str
) -> None:
    design = make(tmp_path, "design.yaml", data)
    output = tmp_path / "output"
    more = {"validate": [], "evaluate": [points, "--output", output], "analyse": ["--output", output]}[command]
    result = run(command, design, *more)
    assert result.status == 2
    assert result.line.startswith(f"varistiff: {design}: ")
    assert said in result.line
    assert names(tmp_path) == ["design.yaml", "points.csv"]


def test_a_design_of_100_megabytes(run: Callable[..., Any], tmp_path: Path) -> None:
    path = tmp_path / "design.yaml"
    with path.open("wb") as stream:
        stream.truncate(100_000_000)
    assert "is too large (100.0 MB); allowed are 1 MB" in run("validate", path).line


@pytest.mark.parametrize("text", ["deflection,setting\n0.1,two\n", "setting\n1\n", "", "deflection\n0.1\nnan\n"])
def test_a_wrong_points_file_leaves_nothing(run: Callable[..., Any], series: Path, text: str) -> None:
    points = make(series.parent, "points.csv", text.encode())
    result = run("evaluate", series, points, "--output", series.parent / "out.csv")
    assert result.status == 2
    assert result.line.startswith(f"varistiff: {points}: ")
    assert names(series.parent) == ["points.csv", "series.yaml"]


def test_the_output_is_tried_before_anything_is_computed(
    run: Callable[..., Any], series: Path, points: Path, stalled: Callable[..., None]
) -> None:
    stalled(lambda: pytest.fail("computed"))
    for output, said in [
        (series / "out.csv", "cannot be written: not a directory"),
        (series.parent, "is a directory"),
        (series, "is the design itself"),
        (points, "is the points itself"),
    ]:
        result = run("evaluate", series, points, "--output", output)
        assert result.status == 2
        assert said in result.line
    assert names(series.parent) == ["points.csv", "series.yaml"]


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_an_interrupted_run_leaves_nothing(
    run: Callable[..., Any], series: Path, points: Path, stalled: Callable[..., None], number: signal.Signals
) -> None:
    stalled(lambda: (os.kill(os.getpid(), number), time.sleep(5.0)))
    handlers = signal.getsignal(signal.SIGINT), signal.getsignal(signal.SIGTERM)
    result = run("evaluate", series, points, "--output", series.parent / "new" / "out.csv")
    assert result.status == 2
    assert result.line == "varistiff: interrupted"
    assert names(series.parent) == ["points.csv", "series.yaml"]
    assert handlers == (signal.getsignal(signal.SIGINT), signal.getsignal(signal.SIGTERM))


def test_an_interruption_after_the_swap_claims_nothing(
    run: Callable[..., Any], series: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    empty = make(series.parent, "empty.csv", b"deflection\n")
    whole = Path.replace

    def replace(self: Path, to: Path) -> Path:
        done = whole(self, to)
        os.kill(os.getpid(), signal.SIGINT)
        return done

    monkeypatch.setattr(Path, "replace", replace)
    result = run("evaluate", series, empty, "--output", series.parent / "new" / "out.csv")
    assert result.status == 2
    assert result.line == "varistiff: interrupted"
    assert (series.parent / "new" / "out.csv").read_text().startswith("deflection,")
    assert names(series.parent / "new") == ["out.csv"]


def test_an_input_that_vanishes_is_not_blamed_on_the_output(
    run: Callable[..., Any], series: Path, points: Path, stalled: Callable[..., None]
) -> None:
    stalled(lambda: (series.parent / "vanished").read_text())
    result = run("evaluate", series, points, "--output", series.parent / "out.csv")
    assert result.status == 1
    assert "vanished" in result.line
    assert "--output" not in result.line
    assert names(series.parent) == ["points.csv", "series.yaml"]


def test_a_pipe_as_output(series: Path) -> None:
    empty = make(series.parent, "empty.csv", b"deflection\n")
    command = [sys.executable, "-m", "varistiff.cli", "evaluate", str(series), str(empty), "--output", "/dev/stdout"]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("deflection,setting,status,")


def test_a_full_disk_elsewhere_is_named(
    run: Callable[..., Any], series: Path, points: Path, stalled: Callable[..., None]
) -> None:
    def full() -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), "/elsewhere/kernel")

    stalled(full)
    result = run("evaluate", series, points, "--output", series.parent / "out.csv")
    assert result.status == 2
    assert result.line == "varistiff: /elsewhere/kernel cannot be written: no space left on device"


def test_a_failure_of_varistiff_says_how_to_report_it(
    run: Callable[..., Any],
    series: Path,
    points: Path,
    stalled: Callable[..., None],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.delenv("VARISTIFF_DEBUG", raising=False)
    stalled(lambda: 1 // 0)
    result = run("evaluate", series, points, "--output", series.parent / "out.csv")
    assert result.status == 1
    assert result.line.startswith("varistiff: varistiff itself failed (ZeroDivisionError: ")
    assert "please report it" in result.line
    assert names(series.parent) == ["points.csv", "series.yaml"]
    monkeypatch.setenv("VARISTIFF_DEBUG", "1")
    result = run("evaluate", series, points, "--output", series.parent / "out.csv")
    assert result.status == 1
    assert "Traceback" in result.err


def test_a_full_disk_under_the_output_or_standard_output(
    run: Callable[..., Any], series: Path, points: Path, stalled: Callable[..., None]
) -> None:
    stalled(lambda: pytest.fail("computed"))
    empty = make(series.parent, "empty.csv", b"deflection\n")
    result = run("evaluate", series, empty, "--output", "/dev/full")
    assert result.status == 2
    assert "no space left" in result.line
    with open("/dev/full", "w") as full:  # noqa: PTH123 - a device, and subprocess wants a file
        done = subprocess.run(
            [sys.executable, "-m", "varistiff.cli", "schema"], stdout=full, stderr=subprocess.PIPE, text=True
        )
    assert done.returncode == 2
    assert done.stderr == "varistiff: the output cannot be written: no space left on device\n"


def test_a_reader_that_has_enough_is_no_failure() -> None:
    schema = subprocess.Popen(
        [sys.executable, "-m", "varistiff.cli", "schema"], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    assert schema.stdout is not None
    assert schema.stderr is not None
    schema.stdout.close()
    assert schema.stderr.read() == b""
    schema.stderr.close()
    assert schema.wait() == 0


def test_the_command_works_outside_the_main_thread(run: Callable[..., Any]) -> None:
    statuses: list[int] = []
    thread = threading.Thread(target=lambda: statuses.append(run("schema").status))
    thread.start()
    thread.join()
    assert statuses == [0]


def test_a_line_break_in_a_name_stays_on_one_line(run: Callable[..., Any], tmp_path: Path) -> None:
    result = run("validate", tmp_path / "a\nb\x1b[31m.yaml")
    assert result.status == 2
    assert "a?b?[31m.yaml" in result.line


def test_the_public_names_are_there() -> None:
    import varistiff

    for name in varistiff.__all__:
        assert getattr(varistiff, name) is not None
    assert set(varistiff.__all__) <= set(dir(varistiff))
    assert varistiff.InputError is InputError
    with pytest.raises(AttributeError, match="no attribute 'laod'"):
        varistiff.laod  # noqa: B018 - the access is the test
