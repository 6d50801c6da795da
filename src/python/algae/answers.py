"""Answers: what is known of a statement, and how."""

from __future__ import annotations

import json
from typing import Any, Optional

from . import _algae, arguments, pages
from .errors import Undecided
from .words import Word

__all__ = ["Answer", "Comparison", "Finite", "Membership"]


class Answer:
    """What is known of a statement: ``truth`` is "proved", "refuted" or "undecided"; the argument says how.

    ``bool`` of an answer raises ``Undecided`` where neither is known: a bound that was reached is no "no".

    >>> import algae
    >>> answer = algae.Language("{a, aa}").is_("0L")
    >>> answer.truth, bool(answer)
    ('refuted', False)
    >>> print(answer.argument[0])
    {a, aa} is not 0L.
    """

    def __init__(self, answer: _algae.Answer, statement: str = "") -> None:
        if not isinstance(answer, _algae.Answer):
            raise arguments.wrong_type("answer", "what a question gives", answer)
        self._answer = answer
        self.statement = statement

    @property
    def truth(self) -> str:
        """ "proved", "refuted" or "undecided"."""
        return self._answer.truth()

    @property
    def is_proved(self) -> bool:
        """Whether the statement is proved."""
        return self.truth == "proved"

    @property
    def is_refuted(self) -> bool:
        """Whether the opposite is proved."""
        return self.truth == "refuted"

    @property
    def is_undecided(self) -> bool:
        """Whether neither is known."""
        return self.truth == "undecided"

    @property
    def argument(self) -> list[str]:
        """The argument, or what was tried: a sentence or line each."""
        return self._answer.argument()

    def certificate(self) -> Optional[dict[str, Any]]:
        """The proof as a certificate holds it; None where there is none."""
        found: Optional[dict[str, Any]] = json.loads(self._answer.certificate())
        return found

    def latex(self) -> str:
        """The argument as LaTeX."""
        return self._answer.latex()

    def __bool__(self) -> bool:
        if self.is_undecided:
            why = self.argument
            raise Undecided((self.statement + ": " if self.statement else "") + "undecided"
                            + (": " + why[0] if why else ""))
        return self.is_proved

    def __str__(self) -> str:
        return "\n".join([self.truth, *self.argument])

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.truth})"

    def _repr_html_(self) -> str:
        said = f"{pages.escaped(self.statement)}: " if self.statement else ""
        return f"<div>{said}{pages.verdict(self.truth)}{pages.argument(self.argument)}</div>"


class Membership(Answer):
    """Whether a word is in the language of a system: ``step`` is the first generation that has it, ``derivation`` how it is derived."""

    def __init__(self, member: Optional[bool], step: Optional[int], report: str, answer: _algae.Answer) -> None:
        super().__init__(answer)
        self.step = step
        self._report: dict[str, Any] = json.loads(report)

    def to_dict(self) -> dict[str, Any]:
        """What `algae member --json` says."""
        return self._report

    @property
    def derivation(self) -> Optional[list[Word]]:
        """The words from the axiom to the member."""
        steps = self._report.get("derivation")
        if steps is None:
            return None
        if isinstance(steps, dict):
            steps = steps.get("words", steps.get("steps", []))
        return [Word(one if isinstance(one, str) else one["word"]) for one in steps]

    @property
    def reason(self) -> Optional[str]:
        """Why the word is not in the language."""
        found: Optional[str] = self._report.get("reason")
        return found

    @property
    def argument(self) -> list[str]:
        if "argument" in self._report:
            return list(self._report["argument"])
        if self.is_proved:
            return [f"The word is derived in {self.step} steps."]
        return [self.reason or ""]


class Finite:
    """Whether a language is finite; ``count`` is the number of its words where that is known."""

    def __init__(self, finite: Optional[bool], count: Optional[int], report: str) -> None:
        self.is_finite = finite
        self.count = count
        self._report: dict[str, Any] = json.loads(report)

    def to_dict(self) -> dict[str, Any]:
        """What `algae finite --json` says."""
        return self._report

    def __bool__(self) -> bool:
        if self.is_finite is None:
            raise Undecided("whether the language is finite is undecided")
        return self.is_finite

    def __repr__(self) -> str:
        if self.is_finite is None:
            return "Finite(undecided)"
        return f"Finite({self.count} words)" if self.is_finite else "Finite(no: infinite)"


class Comparison:
    """Whether two systems are equal: ``witness`` proves it, or shows a difference."""

    def __init__(self, equal: bool, witness: str, text: str) -> None:
        self.is_equal = equal
        self.witness: dict[str, Any] = json.loads(witness)
        self.text = text

    def to_dict(self) -> dict[str, Any]:
        """What `algae equal --json` says."""
        return {"verdict": "equal" if self.is_equal else "different", "witness": self.witness}

    def __bool__(self) -> bool:
        return self.is_equal

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return f"Comparison({'equal' if self.is_equal else 'different'})"

    def _repr_html_(self) -> str:
        return pages.preformatted(self.text)
