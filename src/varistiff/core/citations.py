"""Publications that varistiff builds on, by key."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from importlib import resources

from varistiff.core.errors import InputError
from varistiff.core.suggest import unknown


@dataclass(frozen=True, slots=True)
class Citation:
    """A publication.

    Parameters
    ----------
    key : as ``Actuator.references`` names it
    authors, title, source, year : as printed
    doi : digital object identifier, None where it has none or it is not known
    """

    key: str
    authors: str
    title: str
    source: str
    year: int
    doi: str | None = None

    def __str__(self) -> str:
        tail = f" https://doi.org/{self.doi}" if self.doi else ""
        return f"{self.authors} ({self.year}). {self.title}. {self.source}.{tail}"


@cache
def citations() -> dict[str, Citation]:
    """Return every known publication by its key."""
    from varistiff.core.textfile import parse_yaml

    text = resources.files("varistiff.core").joinpath("citations.yaml").read_text(encoding="utf-8")
    (table,) = parse_yaml(text)
    return {key: Citation(key=key, **entry) for key, entry in table.items()}


def citation(key: str) -> Citation:
    """Return one publication.

    Raises
    ------
    InputError : no publication has this key; says the nearest one

    >>> citation("van_ham_2007").year
    2007
    """
    known = citations()
    if key not in known:
        raise InputError(unknown("citation", key, known))
    return known[key]
