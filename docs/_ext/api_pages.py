"""One page per room that documents every module in it."""

from __future__ import annotations

from pathlib import Path

import varistiff

ROOMS = (
    "core",
    "materials",
    "sections",
    "elastic",
    "actuators",
    "characteristic",
    "dynamics",
    "design",
    "fe",
    "papers",
    "report",
)


def modules(room: str) -> list[str]:
    """Return the dotted names of a room's modules that have something public."""
    folder = Path(str(varistiff.__file__)).parent / room
    files = sorted(path for path in folder.rglob("*.py") if not path.name.startswith("_"))
    return [".".join(["varistiff", room, *path.relative_to(folder).with_suffix("").parts]) for path in files]


def render(room: str) -> str:
    """Return the body of a room's page."""
    blocks = [f"## `{name}`\n\n```{{eval-rst}}\n.. automodule:: {name}\n```" for name in modules(room)]
    return "\n\n".join(blocks)
