"""Whole commands in fresh processes, as a user waits for them."""

from __future__ import annotations

import os
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np

import varistiff

IMPORT_JAX = ["-c", "import jax"]
EXAMPLES = Path(__file__).parents[1] / "examples"


def _run(command: list[str], cache: str, rounds: int) -> tuple[float, float]:
    """Median wall and processor seconds of a command; ``cache`` is where it keeps compiled kernels."""
    wall, processor = [], []
    environment = {**os.environ, "VARISTIFF_CACHE": cache}
    for _ in range(rounds):
        before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
        subprocess.run([sys.executable, *command], check=True, capture_output=True, env=environment)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        wall.append(time.perf_counter() - start)
        processor.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return float(np.median(wall)), float(np.median(processor))


def _jobs(folder: Path) -> Iterator[tuple[str, list[str]]]:
    cli = ["-m", "varistiff.cli"]
    yield "`python -c 'import jax'`, for comparison", IMPORT_JAX
    yield "`varistiff --help`", [*cli, "--help"]
    for path in sorted(EXAMPLES.glob("*.yaml")):
        design = varistiff.load(path)
        rng = np.random.default_rng(1)
        d = rng.uniform(*design.deflection_range, 1000)
        s = rng.uniform(*(design.setting_range or (0.0, 0.0)), 1000)
        points = folder / f"{path.stem}.csv"
        lines = [f"{a!r},{b!r}" for a, b in zip(d.tolist(), s.tolist(), strict=True)]
        points.write_text("deflection,setting\n" + "\n".join(lines) + "\n", encoding="utf-8")
        out = str(folder / f"{path.stem}-out.csv")
        yield f"`evaluate` {path.name}, 1000 points", [*cli, "evaluate", str(path), str(points), "--output", out]
        yield f"`analyse` {path.name}", [*cli, "analyse", str(path), "--output", str(folder / path.stem)]


def table() -> list[str]:
    """Rows of the Markdown table: nothing compiled before, and with the kernels of an earlier run."""
    columns = ("command", "cold: wall", "processor", "again: wall", "processor", "cold processor over `import jax`")
    rows = ["| " + " | ".join(columns) + " |", "|---" * len(columns) + "|"]
    with tempfile.TemporaryDirectory() as folder:
        for name, command in _jobs(Path(folder)):
            start, cold = _run(IMPORT_JAX, "off", 1)[1], _run(command, "off", 2)
            _run(command, f"{folder}/kernels", 1)
            again = _run(command, f"{folder}/kernels", 1)
            cells = [f"{seconds:.2f} s" for seconds in (*cold, *again)]
            rows.append("| " + " | ".join([name, *cells, f"{cold[1] / start:.1f}"]) + " |")
    return rows
