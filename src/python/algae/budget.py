"""What work may use, and whom it tells how far it is."""

from __future__ import annotations

import html
import sys
import time
from collections.abc import Callable, Iterable
from contextvars import ContextVar
from typing import Any, NamedTuple, Optional, Union

from . import _algae, arguments

__all__ = ["Budget", "ProgressBar"]

Tell = Callable[[Optional[float]], None]


class ProgressBar:
    """A bar on standard error, or in a notebook below the cell: how far the work is, where that is known, and how many seconds it has taken.

    Nothing is shown of work that takes less than a second, and nothing stays when it is done.
    """

    def __init__(self, label: str = "algae") -> None:
        self.label = arguments.text("label", label)
        self._since = time.monotonic()
        self._shown = False
        self._handle: Any = None

    def __call__(self, done: float | None) -> None:
        seconds = time.monotonic() - self._since
        if seconds < 1:
            return
        if done is None:
            line = f"{self.label}: {seconds:.0f} s"
        else:
            filled = round(30 * min(max(done, 0), 1))
            line = f"{self.label}: [{'#' * filled}{'.' * (30 - filled)}] {100 * done:3.0f} %  {seconds:.0f} s"
        self._show(line)
        self._shown = True

    def _show(self, line: str) -> None:
        if not is_notebook():
            sys.stderr.write("\r" + (line or " " * 70 + "\r"))
            sys.stderr.flush()
            return
        from IPython.display import HTML, display

        shown = HTML(f"<pre>{html.escape(line)}</pre>" if line else "")  # standard error would leave a red band
        if self._handle is None:
            self._handle = display(shown, display_id=True)
        else:
            self._handle.update(shown)

    def close(self) -> None:
        """Takes the bar away."""
        if self._shown:
            self._show("")
        self._shown = False


def is_notebook() -> bool:
    """Whether this is a kernel of Jupyter, whose outputs stand below a cell."""
    ipython = sys.modules.get("IPython")
    return "ipykernel" in sys.modules and ipython is not None and hasattr(ipython.get_ipython(), "kernel")


def is_watched() -> bool:
    """Whether somebody looks at standard error: a terminal, or a notebook."""
    try:
        if sys.stderr is not None and sys.stderr.isatty():
            return True
    except (AttributeError, ValueError):
        return False
    return is_notebook()


class _Block(NamedTuple):
    """The bounds of a block of statements, ``with Budget(...):``."""

    deadline: Optional[float]
    letters: Optional[int]
    memory: Optional[int]
    progress: Union[Tell, bool, None]


_BLOCKS: ContextVar[tuple[_Block, ...]] = ContextVar("algae_blocks", default=())


def _least(values: Iterable[Optional[int]]) -> Optional[int]:
    return min((one for one in values if one is not None), default=None)


class Budget:
    """Bounds of work: ``timeout`` in seconds, ``letters`` of a word that may be written out, ``memory`` in bytes.

    ``progress`` is called now and then with a number from 0 to 1, or None where it is not known how far the work is; True is a
    ``ProgressBar``, False nothing, and None a bar where somebody looks at standard error.

    A call takes one as ``budget=``. ``with`` bounds all that is done in a block, operators such as ``f * g`` and ``w + w`` too; its
    timeout is that of the whole block.

    >>> import algae
    >>> algae.LSystem("a -> ab, b -> a").derive(100, budget=algae.Budget(letters=1000))
    Traceback (most recent call last):
    ...
    algae.errors.BoundReached: generation 100 has 927372692193078999176 letters, more than the 1000 allowed by letters=; a slice of word(n) gives any part of it, length(n) its length, draw(n) its picture
    >>> with algae.Budget(letters=1000):
    ...     algae.Morphism("a -> ab, b -> a") ** 100
    Traceback (most recent call last):
    ...
    algae.errors.BoundReached: the composition has 2584 letters, more than the 1000 allowed by letters=
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

    def __enter__(self) -> "Budget":
        deadline = None if self.timeout is None else time.monotonic() + self.timeout
        _BLOCKS.set((*_BLOCKS.get(), _Block(deadline, self.letters, self.memory, self.progress)))
        return self

    def __exit__(self, *raised: object) -> None:
        _BLOCKS.set(_BLOCKS.get()[:-1])

    def __repr__(self) -> str:
        said = [f"{name}={getattr(self, name)!r}" for name in ("timeout", "letters", "memory", "progress")
                if getattr(self, name) is not None]
        return f"Budget({', '.join(said)})"


class limits:
    """The bounds of one call, for the library: its own, and those of the blocks that it stands in. All that is done with them must be done
    within the time. Takes a bar away when the call ends."""

    def __init__(self, timeout: float | None, budget: Budget | None, label: str) -> None:
        if budget is not None and not isinstance(budget, Budget):
            raise arguments.wrong_type("budget", "a Budget", budget)
        seconds = arguments.optional_real("timeout", timeout, "seconds, a number above 0", 0)
        if seconds is None and budget is not None:
            seconds = budget.timeout
        wish = budget.progress if budget is not None else None
        letters = budget.letters if budget is not None else None
        memory = budget.memory if budget is not None else None
        blocks = _BLOCKS.get()
        if blocks:
            now = time.monotonic()
            for block in blocks:
                if block.deadline is not None:
                    left = max(0.0, block.deadline - now)
                    seconds = left if seconds is None else min(seconds, left)
            letters = _least([letters, *(block.letters for block in blocks)])
            memory = _least([memory, *(block.memory for block in blocks)])
            for block in reversed(blocks):
                if wish is None:
                    wish = block.progress
        self._bar: ProgressBar | None = None
        tell: Tell | None = None
        if wish is True or (wish is None and is_watched()):
            tell = self._bar = ProgressBar(label)
        elif callable(wish):
            tell = wish
        self._limits = _algae.Limits(seconds, letters, memory, tell)

    def __enter__(self) -> _algae.Limits:
        return self._limits

    def __exit__(self, *raised: object) -> None:
        if self._bar is not None:
            self._bar.close()
