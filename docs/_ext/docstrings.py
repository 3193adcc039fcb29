"""Make the docstrings of the code readable to Sphinx without changing how they read in the source."""

from __future__ import annotations

import re
from typing import Any

SECTIONS = {"Parameters", "Returns", "Raises", "Attributes", "Yields"}
ENTRY = re.compile(r"^(\w[\w*, ]*?) : (.+)$")


def prepare(_app: Any, _what: str, _name: str, _obj: Any, _options: Any, lines: list[str]) -> None:
    """Put the words of ``name : words`` below the name, and keep |x| and *.png from being markup."""
    section, literal, ready = "", False, []
    for index, line in enumerate(lines):
        if index + 1 < len(lines) and line and set(lines[index + 1]) == {"-"}:
            section = line
        if line and not line.startswith(" "):
            literal = line.endswith("::")
        if not literal or not line.startswith(" "):
            line = line.replace("|", r"\|").replace("*.", r"\*.")
        entry = ENTRY.match(line) if section in SECTIONS else None
        ready += [entry[1], f"    {entry[2]}"] if entry else [line]
    lines[:] = ready


def setup(app: Any) -> dict[str, Any]:
    """Register before napoleon, which listens with the default priority."""
    app.connect("autodoc-process-docstring", prepare, priority=100)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
