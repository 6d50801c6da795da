"""Numbers that are no ints or fractions: algebraic ones, and dimensions."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from typing import Optional

from . import _algae, arguments
from .budget import Budget, limits

__all__ = ["Algebraic", "Dimension"]


class Algebraic:
    """A real algebraic number, exactly: a rate of growth, or the share of a letter.

    >>> import algae
    >>> phi = algae.LSystem("a -> ab, b -> a").growth().rate
    >>> phi
    Algebraic('(1+sqrt(5))/2')
    >>> phi.minimal_polynomial
    [-1, -1, 1]
    >>> phi.n(30)
    Decimal('1.618033988749894848204586834366')
    >>> phi > 1.6
    True
    """

    __slots__ = ("_number",)

    def __init__(self, number: _algae.Algebraic) -> None:
        if not isinstance(number, _algae.Algebraic):
            raise arguments.wrong_type("number", "a number of a growth or its letters", number)
        self._number = number

    @property
    def minimal_polynomial(self) -> Optional[list[int]]:
        """The coefficients of the irreducible polynomial over the integers, the constant one first.

        None for a share in a field of a degree above 8, which is known by its digits only.
        """
        return self._number.minimal_polynomial()

    @property
    def rational(self) -> Optional[Fraction]:
        """The number itself, if it is rational."""
        return self._number.rational()

    def n(self, digits: int = 15, *, timeout: float | None = None) -> Decimal:
        """Correctly rounded to so many digits after the point."""
        wanted = arguments.count("digits", digits, 0, 1_000_000)
        with limits(timeout, None, "digits") as bounds:
            return Decimal(self._number.decimal(wanted, bounds))

    def __float__(self) -> float:
        rational = self.rational
        return float(rational) if rational is not None else float(self.n(40))

    def __str__(self) -> str:
        return self._number.text()

    def __repr__(self) -> str:
        return f"Algebraic({self._number.text()!r})"

    def _compare(self, other: object) -> int | None:
        if isinstance(other, Algebraic):
            with limits(None, None, "compare") as bounds:
                return self._number.compare(other._number, bounds)
        if isinstance(other, bool) or not isinstance(other, (int, float, Fraction)):
            return None
        if isinstance(other, float) and (other != other or other in (float("inf"), float("-inf"))):
            return None if other != other else (-1 if other > 0 else 1)
        value = Fraction(other)
        rational = self.rational
        if rational is not None:
            return (rational > value) - (rational < value)
        digits = 40
        while digits <= 20_000:
            about = Fraction(self.n(digits))
            apart = Fraction(1, 10**digits)
            if about - value > apart:
                return 1
            if value - about > apart:
                return -1
            digits *= 2
        return None

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, (Algebraic, int, float, Fraction)):
            return NotImplemented
        if isinstance(other, Algebraic):
            mine, others = self.minimal_polynomial, other.minimal_polynomial
            if mine is not None and others is not None and mine != others:
                return False
        elif self.rational is None:
            return False
        return self._compare(other) == 0

    def __hash__(self) -> int:
        rational = self.rational
        return hash(rational) if rational is not None else hash(tuple(self.minimal_polynomial or []))

    def __lt__(self, other: object) -> bool:
        order = self._compare(other)
        if order is None:
            return NotImplemented
        return order < 0

    def __le__(self, other: object) -> bool:
        order = self._compare(other)
        if order is None:
            return NotImplemented
        return order <= 0

    def __gt__(self, other: object) -> bool:
        order = self._compare(other)
        if order is None:
            return NotImplemented
        return order > 0

    def __ge__(self, other: object) -> bool:
        order = self._compare(other)
        if order is None:
            return NotImplemented
        return order >= 0

    def _repr_latex_(self) -> str:
        return f"${self._number.latex()}$"


class Dimension:
    """The dimension of the limit that a system draws, as its rules give it.

    ``status`` is "exact" (the Hausdorff and the box dimension), "upper bound", "unfinished" or "none"; ``conditions`` say what was
    verified, or could not be.

    >>> import algae
    >>> found = algae.LSystem("koch").dimension()
    >>> found.status, str(found), found.n(10)
    ('exact', 'log 4 / log 3', Decimal('1.2618595071'))
    """

    def __init__(self, found: _algae.Dimension) -> None:
        self._found = found

    @property
    def status(self) -> str:
        """ "exact", "upper bound", "unfinished" or "none"."""
        return self._found.status()

    @property
    def is_exact(self) -> bool:
        """Whether it is the dimension and no bound."""
        return self.status == "exact"

    @property
    def almost_surely(self) -> bool:
        """Whether chance has a part in the limit: then the dimension is so with probability 1."""
        return self._found.almost_surely()

    @property
    def formula(self) -> Optional[str]:
        """ "log 4 / log 3"; None where the rules give none."""
        return self._found.text()

    @property
    def rational(self) -> Optional[Fraction]:
        """The number itself, where it is known to be rational."""
        return self._found.rational()

    @property
    def boundary(self) -> Optional[str]:
        """The formula of the dimension of the boundary, where the limit fills an area."""
        return self._found.boundary()

    @property
    def conditions(self) -> list[str]:
        """What was verified, or could not be, in sentences."""
        return self._found.conditions()

    def n(self, digits: int = 15, *, timeout: float | None = None) -> Decimal:
        """Correctly rounded to so many digits after the point; 2 for an upper bound above it, as no figure of the plane has more."""
        wanted = arguments.count("digits", digits, 0, 100_000)
        with limits(timeout, None, "digits") as bounds:
            return Decimal(self._found.decimal(wanted, bounds))

    def to_dict(self) -> dict[str, object]:
        """What `algae dimension --table --quick --json` says of the system."""
        import json

        found: dict[str, object] = json.loads(self._found.report())
        return found

    def __float__(self) -> float:
        return float(self.n(20))

    def __str__(self) -> str:
        return self.formula or "no formula"

    def __repr__(self) -> str:
        return f"Dimension({self.formula!r}, {self.status})"

    def _repr_latex_(self) -> str:
        return f"${self._latex()}$"

    def _latex(self) -> str:
        formula = self._found.latex()
        if self.status == "upper bound" and self.n(1) == 2:  # the formula gives more
            return r"\dim \le 2"
        relation = r"\le" if self.status == "upper bound" else "="
        relation = r"\dim \overset{\text{a.s.}}" + f"{{{relation}}}" if self.almost_surely else rf"\dim {relation}"
        if not formula:
            return r"\text{no formula of the dimension}"
        about = rf" \approx {self.n(12)}" if self.rational is None else ""
        return f"{relation} {formula}{about}"

    def _repr_html_(self) -> str:
        from . import pages

        said = "".join(f"<li>{pages.escaped(one)}</li>" for one in self.conditions)
        return f'{pages.formula(self._latex())}<p>{pages.escaped(self.status)}</p><ul class="tex2jax_ignore mathjax_ignore">{said}</ul>'
