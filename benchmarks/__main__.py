"""Measure everything and rewrite the tables of docs/performance.md between their markers."""

from __future__ import annotations

import os
import platform
import re
from pathlib import Path

from benchmarks import cold_start, maps, roller_contact, sections, simulation
from benchmarks.timing import pin_to_one_core

PAGE = Path(__file__).parents[1] / "docs/performance.md"


def _machine() -> str:
    model = platform.processor() or platform.machine()
    cpu = Path("/proc/cpuinfo")
    if cpu.exists():
        names = re.findall(r"model name\s*:\s*(.+)", cpu.read_text(encoding="utf-8"))
        model = names[0] if names else model
    return f"{model}, Python {platform.python_version()}"


def main() -> None:
    free = {"cold_start": cold_start.table(), "simulation": simulation.table()}  # a batch uses every core
    pin_to_one_core()
    tables = {
        "roller_contact": roller_contact.table(),
        "maps": maps.table(),
        "sections": sections.table(),
        **free,
    }
    text = PAGE.read_text(encoding="utf-8")
    for name, rows in tables.items():
        place = f"Not pinned, {os.cpu_count()} cores" if name in free else "One pinned core"
        block = "\n".join([f"{place}: {_machine()}.", "", *rows])
        print(f"\n{name}\n{block}")
        pattern = re.compile(rf"(<!-- {name} -->\n).*?(<!-- end -->)", re.S)
        text = pattern.sub(lambda found, block=block: found[1] + block + "\n" + found[2], text)
    PAGE.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
