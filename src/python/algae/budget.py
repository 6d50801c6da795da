"""What work may use, and whom it tells how far it is."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from typing import Optional, Union

from . import _algae, arguments

__all__ = ["Budget", "ProgressBar"]

Tell = Callable[[Optional[float]], None]


class ProgressBar:
    """A bar on standard error: how far the work is, where that is known, and how many seconds it has taken.

    Nothing is shown of work that takes less than a second.
    """

    def __init__(self, label: str = "algae") -> None:
        self.label = arguments.text("label", label)
        self._since = time.monotonic()
        self._shown = False

    def __call__(self, done: float | None) -> None:
        seconds = time.monotonic() - self._since
        if seconds < 1:
            return
        if done is None:
            line = f"{self.label}: {seconds:.0f} s"
        else:
            filled = round(30 * min(max(done, 0), 1))
            line = f"{self.label}: [{'#' * filled}{'.' * (30 - filled)}] {100 * done:3.0f} %  {seconds:.0f} s"
        sys.stderr.write("\r" + line)
        sys.stderr.flush()
        self._shown = True

    def close(self) -> None:
        """Takes the bar away."""
        if self._shown:
            sys.stderr.write("\r" + " " * 70 + "\r")
            sys.stderr.flush()
        self._shown = False


def is_watched() -> bool:
    """Whether somebody looks at standard error: a terminal, or a notebook."""
    try:
        if sys.stderr is not None and sys.stderr.isatty():
            return True
    except (AttributeError, ValueError):
        return False
    return "ipykernel" in sys.modules


class Budget:
    """Bounds of work: ``timeout`` in seconds, ``letters`` of a word that may be written out, ``memory`` in bytes.

    ``progress`` is called now and then with a number from 0 to 1, or None where it is not known how far the work is; True is a
    ``ProgressBar``, False nothing, and None a bar where somebody looks at standard error.

    >>> import algae
    >>> algae.LSystem("a -> ab, b -> a").derive(100, budget=algae.Budget(letters=1000))
    Traceback (most recent call last):
    ...
    algae.errors.BoundReached: generation 100 has 927372692193078999176 letters, more than the 1000 allowed by letters=; a slice of word(n) gives any part of it, length(n) its length, draw(n) its picture
    """

    def __init__(
        self,
        timeout: float | None = None,
        letters: int | None = None,
        memory: int | None = None,
        progress: Union[Tell, bool, None] = None,
    ) -> None:
        self.timeout = arguments.optional_real("timeout", timeout, "seconds, a number above 0", 0)
        self.letters = arguments.optional_count("letters", letters)
        self.memory = arguments.optional_count("memory", memory)
        if progress is not None and not isinstance(progress, bool) and not callable(progress):
            raise arguments.wrong_type("progress", "a function, True, False or None", progress)
        self.progress = progress

    def __repr__(self) -> str:
        said = [f"{name}={getattr(self, name)!r}" for name in ("timeout", "letters", "memory", "progress")
                if getattr(self, name) is not None]
        return f"Budget({', '.join(said)})"


class limits:
    """The bounds of one call, for the library; takes a bar away when the call ends."""

    def __init__(self, timeout: float | None, budget: Budget | None, label: str) -> None:
        if budget is not None and not isinstance(budget, Budget):
            raise arguments.wrong_type("budget", "a Budget", budget)
        seconds = arguments.optional_real("timeout", timeout, "seconds, a number above 0", 0)
        if seconds is None and budget is not None:
            seconds = budget.timeout
        wish = budget.progress if budget is not None else None
        self._bar: ProgressBar | None = None
        tell: Tell | None = None
        if wish is True or (wish is None and is_watched()):
            tell = self._bar = ProgressBar(label)
        elif callable(wish):
            tell = wish
        self._limits = _algae.Limits(
            seconds,
            budget.letters if budget is not None else None,
            budget.memory if budget is not None else None,
            tell,
        )

    def __enter__(self) -> _algae.Limits:
        return self._limits

    def __exit__(self, *raised: object) -> None:
        if self._bar is not None:
            self._bar.close()


NONE = _algae.Limits()
