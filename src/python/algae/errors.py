"""What goes wrong: bad input, and work that stopped before its answer.

``Error`` is bad input: its message names the place, what was expected and what was found. ``NotationError`` is an error in a text,
with every finding. ``Stopped`` says nothing about the input: a bound was reached (``BoundReached``, of time ``Timeout``), or an answer is
not decided (``Undecided``). Ctrl-C is Python's own ``KeyboardInterrupt``.
"""

from __future__ import annotations

from typing import Any

__all__ = ["BoundReached", "Error", "Finding", "NotationError", "Stopped", "Timeout", "Undecided"]


class Error(ValueError):
    """Bad input or bad usage."""


class Finding:
    """One thing that is wrong with a text, and where.

    ``line`` and ``column`` count from 1, columns in characters; ``end`` is the column behind what is wrong. ``expected``, ``found`` and
    ``suggestion`` are parts of the message, empty where it says nothing of the kind.
    """

    __slots__ = ("file", "line", "column", "end", "message", "text", "caret", "expected", "found", "suggestion")

    def __init__(self, parts: dict[str, Any]) -> None:
        self.file: str = parts["file"]
        self.line: int = parts["line"]
        self.column: int = parts["column"]
        self.end: int = parts["end"]
        self.message: str = parts["message"]
        self.text: str = parts["text"]
        self.caret: int = parts["caret"]
        self.expected: str = parts["expected"]
        self.found: str = parts["found"]
        self.suggestion: str = parts["suggestion"]

    def __repr__(self) -> str:
        return f"Finding({self.file}:{self.line}:{self.column}: {self.message})"


class NotationError(Error):
    """Everything that is wrong with one text; ``findings`` in order of place, never empty.

    >>> import algae
    >>> try:
    ...     algae.LSystem("axiom F\\nangel 60")
    ... except algae.NotationError as error:
    ...     print(error.line, error.column, error.suggestion)
    2 1 angle
    """

    def __init__(self, message: str, findings: list[dict[str, Any]]) -> None:
        super().__init__(message)
        self.findings = [Finding(one) for one in findings]

    def __reduce__(self) -> tuple[Any, ...]:
        parts = [{name: getattr(one, name) for name in Finding.__slots__} for one in self.findings]
        return (type(self), (str(self), parts))

    @property
    def file(self) -> str:
        """The file or text of the first finding."""
        return self.findings[0].file

    @property
    def line(self) -> int:
        """The line of the first finding, counted from 1; 0 where the text as a whole is meant."""
        return self.findings[0].line

    @property
    def column(self) -> int:
        """The column of the first finding, counted from 1."""
        return self.findings[0].column

    @property
    def caret(self) -> str:
        """The line of the first finding, and a caret below what is wrong."""
        first = self.findings[0]
        return first.text + "\n" + " " * first.caret + "^"

    @property
    def expected(self) -> str:
        """What the first finding expected."""
        return self.findings[0].expected

    @property
    def found(self) -> str:
        """What the first finding found."""
        return self.findings[0].found

    @property
    def suggestion(self) -> str:
        """What may have been meant; empty where nothing is close."""
        return self.findings[0].suggestion


class Stopped(Exception):
    """The work ended without an answer."""


class BoundReached(Stopped):
    """A bound was reached before the answer.

    ``bound`` is "letters", "memory" or "time", which a larger ``Budget`` moves, or "nodes", "digits" or "method".
    """

    def __init__(self, message: str, bound: str) -> None:
        super().__init__(message, bound)
        self.message = message
        self.bound = bound

    def __str__(self) -> str:
        return self.message


class Timeout(BoundReached, TimeoutError):
    """The time given by ``timeout=`` was over before the answer."""


class Undecided(Stopped):
    """An answer was asked for yes or no, and neither is known."""
