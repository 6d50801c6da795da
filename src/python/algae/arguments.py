"""Checks of arguments: what is wrong is told with the argument's name, what was expected and what was found."""

from __future__ import annotations

import operator
import os
from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import Any

__all__: list[str] = []

LARGEST = 2**63 - 1


def shown(value: object) -> str:
    """The value as a message has it: short, and with its type."""
    text = repr(value)
    if len(text) > 60:
        text = text[:57] + "..."
    return f"{text} ({type(value).__name__})"


def wrong_type(name: str, expected: str, value: object) -> TypeError:
    return TypeError(f"{name}: expected {expected}, found {shown(value)}")


def wrong_value(name: str, expected: str, value: object) -> ValueError:
    return ValueError(f"{name}: expected {expected}, found {shown(value)}")


def integer(name: str, value: object, expected: str = "an int", least: int | None = None, most: int | None = None) -> int:
    """An int, or another number that is one, as those of numpy; bools are none."""
    if isinstance(value, bool) or not hasattr(type(value), "__index__"):
        raise wrong_type(name, expected, value)
    try:
        number = operator.index(value)  # type: ignore[arg-type]
    except TypeError:
        raise wrong_type(name, expected, value) from None
    if (least is not None and number < least) or (most is not None and number > most):
        raise wrong_value(name, expected, number)
    return number


def generation(name: str, value: object) -> int:
    return integer(name, value, "a generation, an int from 0 on", 0, LARGEST)


def count(name: str, value: object, least: int = 0, most: int = LARGEST) -> int:
    upper = f" to {most}" if most != LARGEST else " on"
    return integer(name, value, f"an int from {least}{upper}", least, most)


def optional_count(name: str, value: object, least: int = 0) -> int | None:
    return None if value is None else count(name, value, least)


def text(name: str, value: object, expected: str = "a str") -> str:
    if not isinstance(value, str):
        raise wrong_type(name, expected, value)
    try:
        value.encode("utf-8")
    except UnicodeEncodeError as error:
        raise ValueError(f"{name}: character {error.start} of the text is half of a pair, and no text in UTF-8") from None
    return value


def truth(name: str, value: object) -> bool:
    if not isinstance(value, bool):
        raise wrong_type(name, "True or False", value)
    return value


def real(name: str, value: object, expected: str = "a number", above: float | None = None) -> float:
    if isinstance(value, (bool, str, bytes)):
        raise wrong_type(name, expected, value)
    try:
        number = float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        raise wrong_type(name, expected, value) from None
    except OverflowError:
        raise wrong_value(name, expected, value) from None
    if number != number or number in (float("inf"), float("-inf")) or (above is not None and number <= above):
        raise wrong_value(name, expected, value)
    return number


def optional_real(name: str, value: object, expected: str = "a number", above: float | None = None) -> float | None:
    return None if value is None else real(name, value, expected, above)


def exact(name: str, value: object, expected: str = "an int or a Fraction") -> Fraction:
    """A rational number; a float is exactly what it is."""
    if isinstance(value, Fraction):
        return value
    if isinstance(value, float):
        if value != value or value in (float("inf"), float("-inf")):
            raise wrong_value(name, expected, value)
        return Fraction(value)
    return Fraction(integer(name, value, expected))


def probability(name: str, value: object) -> Fraction:
    """A rational number; a float is the simplest fraction that is this float: 1/3 of 0.333..., so that 1/3 and 2/3 add up to 1."""
    found = exact(name, value, "a probability, a Fraction or a number")
    if isinstance(value, float):
        simple = found.limit_denominator(1_000_000)
        return simple if float(simple) == value else found
    return found


def choice(name: str, value: object, known: Iterable[str]) -> str:
    names = list(known)
    found = text(name, value, "one of " + ", ".join(names))
    if found not in names:
        raise wrong_value(name, "one of " + ", ".join(names), value)
    return found


def path(name: str, value: object) -> str:
    if not isinstance(value, (str, os.PathLike)):
        raise wrong_type(name, "a path", value)
    found = os.fspath(value)
    if not isinstance(found, str):
        raise wrong_type(name, "a path that is a str", value)
    return text(name, found)


def texts(name: str, value: object, expected: str) -> list[str]:
    if isinstance(value, (str, bytes)) or not isinstance(value, Iterable):
        raise wrong_type(name, expected, value)
    return [text(f"{name}[{i}]", one) for i, one in enumerate(value)]


def constants(name: str, value: object) -> list[tuple[str, str]]:
    """Values of constants: numbers, or texts of expressions such as '1/3'."""
    if value is None:
        return []
    if not isinstance(value, Mapping):
        raise wrong_type(name, "a dict of constants and their values", value)
    found = []
    for key, one in value.items():
        constant = text(f"{name}: a name", key)
        if isinstance(one, str):
            found.append((constant, text(f"{name}[{constant!r}]", one)))
        elif isinstance(one, float):
            found.append((constant, repr(real(f"{name}[{constant!r}]", one))))
        else:
            found.append((constant, str(exact(f"{name}[{constant!r}]", one, "a number, or a str such as '1/3'"))))
    return found


def unknown(where: str, given: Mapping[str, Any], known: Iterable[str]) -> None:
    """Raises TypeError where there is an argument that is not known."""
    import difflib

    names = list(known)
    for name in given:
        if name not in names:
            close = difflib.get_close_matches(name, names, 1)
            hint = f"; did you mean {close[0]}?" if close else ""
            raise TypeError(f"{where}: unknown argument {name!r}{hint}; expected {', '.join(names)}")
