"""The one exception that a user is meant to see."""

from __future__ import annotations


class InputError(ValueError):
    """The input is wrong: one line that says file, field, what is wrong and what is allowed.

    Parameters
    ----------
    problem : what is wrong and what is allowed, one clause without a full stop
    file : path of the offending file, as the user wrote it
    field : dotted path of the offending field (or ``row 7, column setting``)
    """

    def __init__(self, problem: str, *, file: str | None = None, field: str | None = None) -> None:
        self.problem = problem
        self.file = file
        self.field = field
        super().__init__(": ".join(part for part in (file, field, problem) if part))

    def located(self, *, file: str | None = None, field: str | None = None) -> InputError:
        """Return the same error with missing location parts filled in."""
        return InputError(self.problem, file=self.file or file, field=self.field or field)
