"""Whole commands in fresh processes, as a user waits for them."""

from __future__ import annotations

import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

import varistiff

EXAMPLES = Path(__file__).parents[1] / "examples"


def _run(arguments: list[str], rounds: int) -> tuple[float, float]:
    """Median wall and processor seconds of a command."""
    wall, processor = [], []
    for _ in range(rounds):
        before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
        subprocess.run([sys.executable, "-m", "varistiff.cli", *arguments], check=True, capture_output=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        wall.append(time.perf_counter() - start)
        processor.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return float(np.median(wall)), float(np.median(processor))


def table() -> list[str]:
    """Rows of the Markdown table."""
    rows = ["| command | wall | processor |", "|---|---|---|"]
    with tempfile.TemporaryDirectory() as folder:
        jobs: list[tuple[str, list[str], int]] = [("`varistiff --help`", ["--help"], 5)]
        for path in sorted(EXAMPLES.glob("*.yaml")):
            design = varistiff.load(path)
            rng = np.random.default_rng(1)
            d = rng.uniform(*design.deflection_range, 1000)
            s = rng.uniform(*(design.setting_range or (0.0, 0.0)), 1000)
            points = Path(folder) / f"{path.stem}.csv"
            lines = [f"{a!r},{b!r}" for a, b in zip(d.tolist(), s.tolist(), strict=True)]
            points.write_text("deflection,setting\n" + "\n".join(lines) + "\n", encoding="utf-8")
            out = str(Path(folder) / f"{path.stem}-out.csv")
            jobs.append(
                (f"`evaluate` {path.name}, 1000 points", ["evaluate", str(path), str(points), "--output", out], 2)
            )
            jobs.append((f"`analyse` {path.name}", ["analyse", str(path), "--output", f"{folder}/{path.stem}"], 2))
        for name, arguments, rounds in jobs:
            wall, processor = _run(arguments, rounds)
            rows.append(f"| {name} | {wall:.2f} s | {processor:.2f} s |")
    return rows
