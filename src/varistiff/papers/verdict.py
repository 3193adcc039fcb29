"""What the board says of a claim."""

from __future__ import annotations

from enum import StrEnum


class Verdict(StrEnum):
    """Verdict on one printed statement; all but ``unexpected`` are what the claim expects.

    Members carry their meaning; ``str`` gives the word that tables and files use.
    """

    REPRODUCED = "reproduced", "agrees, from published inputs alone"
    CONTRADICTED = "contradicted", "the paper disagrees with itself or with mechanics, and a test proves it"
    UNDERDETERMINED = "underdetermined", "inputs are unpublished; what was assumed is said"
    FITTED = "fitted", "agrees, but an input was fitted to it, so it counts as nothing reproduced"
    INPUT = "input", "a datum that the paper starts from; nothing to compute"
    NOT_RUN = "not_run", "needs an extra that is not installed"
    UNEXPECTED = "unexpected", "agreement or disagreement differs from what is expected: look here first"

    meaning: str

    def __new__(cls, word: str, meaning: str) -> Verdict:
        """Make a member from its word and its meaning."""
        member = str.__new__(cls, word)
        member._value_ = word
        member.meaning = meaning
        return member
