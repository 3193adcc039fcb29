"""Say what was meant: the nearest allowed word, and text from users quoted safely."""

from __future__ import annotations

from collections.abc import Iterable

_LONGEST_QUOTE = 40
_LONGEST_WORD = 60
_MOST_LISTED = 30


def quoted(value: object) -> str:
    """Return user input on one line, shortened and without control characters.

    >>> quoted("12 mm")
    '"12 mm"'
    >>> quoted("a" * 100)
    '"aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa..."'
    """
    if isinstance(value, bool):
        return "true" if value else "false"
    if value is None:
        return "nothing"
    if isinstance(value, dict):
        return "a mapping"
    if isinstance(value, list):
        return "a list"
    if isinstance(value, int | float):
        return printable(repr(value))
    return f'"{printable(str(value))}"'


def printable(text: str) -> str:
    """Return text as one short printable line."""
    head = text[: _LONGEST_QUOTE + 1]
    short = head if len(head) <= _LONGEST_QUOTE else head[: _LONGEST_QUOTE - 3] + "..."
    return "".join(character if character.isprintable() else "?" for character in short)


def nearest(word: str, allowed: Iterable[str]) -> str | None:
    """Return the allowed word that is most like ``word``, or None if nothing is near.

    >>> nearest("thicknes", ["width", "thickness"])
    'thickness'
    """
    import difflib

    words = list(allowed)
    folded = {candidate.casefold(): candidate for candidate in reversed(words)}
    meant = word[:_LONGEST_WORD].casefold()
    found = difflib.get_close_matches(meant, folded, n=1, cutoff=0.6)
    if not found and len(meant) >= 3:  # part of a longer name
        found = [candidate for candidate in folded if meant in candidate][:1]
    return folded[found[0]] if found else None


def unknown(what: str, word: object, allowed: Iterable[str]) -> str:
    """Return the clause for a word that is not among the allowed ones, with the nearest match.

    >>> unknown("kind", "macepa", ["maccepa", "roller_beam"])
    'unknown kind "macepa" (did you mean "maccepa"?); allowed: maccepa, roller_beam'
    """
    words = sorted(allowed)
    match = nearest(word, words) if isinstance(word, str) else None
    hint = f' (did you mean "{match}"?)' if match else ""
    listed = ", ".join(words[:_MOST_LISTED]) + (", ..." if len(words) > _MOST_LISTED else "")
    return f"unknown {what} {quoted(word)}{hint}; allowed: {listed}"
