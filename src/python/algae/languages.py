"""Languages, claims about them, and censuses."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, Optional, Union

from . import _algae, arguments, pages
from .answers import Answer
from .budget import Budget, limits
from .words import Morphism, Word, WordLike, as_word

if TYPE_CHECKING:
    from .systems import LSystem

__all__ = ["Census", "CheckedClaim", "CheckedStatement", "Claim", "Family", "Language", "census", "families", "search",
           "verify"]


class Family(str):
    """A family of languages, by its name: ``REG``, ``CF``, ``0L``, ``D0L``, ``ET0L`` and so on.

    >>> import algae
    >>> bool(algae.Language("/a*/") in algae.Family("regular"))
    True
    """

    def __new__(cls, name: str) -> "Family":
        found = arguments.text("name", name)
        if found not in _algae.families():
            Language("{a}").is_(found)  # raises the error that names the nearest family
        return super().__new__(cls, found)

    def __contains__(self, language: object) -> bool:
        if isinstance(language, Language):
            return bool(language.is_(self))
        return super().__contains__(language)  # type: ignore[operator]

    def __repr__(self) -> str:
        return f"Family({str(self)!r})"


def families() -> list[Family]:
    """The families that `is_` knows by name; others are named like them: "EPDT0L"."""
    return [str.__new__(Family, name) for name in _algae.families()]


class Language:
    """A language: an expression as claims write it.

    ``{a, ab}`` is a finite set, ``/a(ab)*/`` a regular expression, ``L(NAME)`` the language of a system of the gallery or of
    ``systems``. Operators: ``A | B``, ``A & B``, ``A - B``, ``A * B`` (concatenation), ``A ** n``, ``~A`` (complement over the
    letters of the whole expression and ``letters``); ``star``, ``plus``, ``reversed``, ``image`` and ``preimage``.

    >>> from algae import Language
    >>> A = Language("/(a|b)*/") - Language("/a*/")
    >>> A.words(4)
    [Word('b'), Word('ab'), Word('ba'), Word('bb')]
    >>> "aab" in A, "aaa" in A
    (True, False)
    >>> Language("/a(ba)*/") == Language("/(ab)*a/")
    True
    """

    def __init__(self, expression: Union[str, Iterable[WordLike]], *, systems: Optional[Mapping[str, "LSystem"]] = None,
                 letters: Iterable[str] = ()) -> None:
        from .systems import LSystem

        self._systems: dict[str, "LSystem"] = {}
        if systems is not None:
            if not isinstance(systems, Mapping):
                raise arguments.wrong_type("systems", "a dict of names and systems", systems)
            for name, system in systems.items():
                if not isinstance(system, LSystem):
                    raise arguments.wrong_type(f"systems[{name!r}]", "an LSystem", system)
                self._systems[arguments.text("systems: a name", name)] = system
        self._letters = arguments.texts("letters", letters, "a list of letters")
        if isinstance(expression, str):
            self._expression = arguments.text("expression", expression)
        elif isinstance(expression, Iterable) and not isinstance(expression, (bytes, Mapping)):
            words = [as_word(f"expression[{i}]", one) for i, one in enumerate(expression)]
            self._expression = "{" + ", ".join(str(word) for word in words) + "}"
        else:
            raise arguments.wrong_type("expression", "a str as claims write languages, or a list of words", expression)
        self._language: _algae.Language = _algae.read_language(
            self._expression, [(name, system._system) for name, system in self._systems.items()], self._letters)

    @classmethod
    def of_system(cls, system: "LSystem") -> "Language":
        """The language of a system, L(G)."""
        name = re.sub(r"\W", "_", system.name) or "G"
        if not name[0].isalpha():
            name = "G" + name
        return cls(f"L({name})", systems={name: system})

    @property
    def expression(self) -> str:
        """The expression, as claims write it."""
        return self._expression

    @property
    def letters(self) -> list[str]:
        """The letters that may occur in words of the language."""
        return self._language.letters()

    # Operators

    def _with(self, other: "Language") -> tuple[str, str, dict[str, "LSystem"], list[str]]:
        """Both expressions, with names that mean one system each."""
        systems = dict(self._systems)
        text = other._expression
        for name, system in other._systems.items():
            new = name
            number = 2
            while new in systems and systems[new] is not system and systems[new] != system:
                new = f"{name}_{number}"
                number += 1
            if new != name:
                text = re.sub(rf"L\(\s*{re.escape(name)}\s*\)", f"L({new})", text)
            systems[new] = system
        return self._expression, text, systems, sorted({*self._letters, *other._letters})

    def _combined(self, sign: str, other: object) -> "Language":
        if isinstance(other, str):
            other = Language(other)
        if not isinstance(other, Language):
            raise arguments.wrong_type("other", "a Language", other)
        left, right, systems, letters = self._with(other)
        return Language(f"({left}) {sign} ({right})", systems=systems, letters=letters)

    def _made(self, text: str) -> "Language":
        return Language(text, systems=self._systems, letters=self._letters)

    def __or__(self, other: object) -> "Language":
        if not isinstance(other, (Language, str)):
            return NotImplemented
        return self._combined("|", other)

    def __and__(self, other: object) -> "Language":
        if not isinstance(other, (Language, str)):
            return NotImplemented
        return self._combined("&", other)

    def __sub__(self, other: object) -> "Language":
        if not isinstance(other, (Language, str)):
            return NotImplemented
        return self._combined("\\", other)

    def __mul__(self, other: object) -> "Language":
        if not isinstance(other, (Language, str)):
            return NotImplemented
        return self._combined(".", other)

    def __pow__(self, exponent: object) -> "Language":
        times = arguments.count("exponent", exponent, 0, 1000)
        return self._made(" . ".join([f"({self._expression})"] * times) if times else "{ε}")

    def __invert__(self) -> "Language":
        return self._made(f"~({self._expression})")

    def star(self) -> "Language":
        """All products of words of the language, with the empty one."""
        return self._made(f"({self._expression})*")

    def plus(self) -> "Language":
        """All products of one word or more."""
        return self._made(f"({self._expression})+")

    def reversed(self) -> "Language":
        """Each word read backwards."""
        return self._made(f"({self._expression})^R")

    def image(self, morphism: Union[Morphism, Mapping[str, WordLike], str]) -> "Language":
        """The images of the words; the morphism must have an image for each letter.

        >>> Language("/(ab)*/").image({"a": "b", "b": "aa"}).words(3)
        [Word('ε'), Word('baa'), Word('baabaa')]
        """
        return self._made(f"{_braced(morphism)}({self._expression})")

    def preimage(self, morphism: Union[Morphism, Mapping[str, WordLike], str]) -> "Language":
        """The words whose images are in the language."""
        return self._made(f"{_braced(morphism)}^-1({self._expression})")

    # Questions

    def is_(self, family: str, *, allow_empty_axiom: bool = False, timeout: Optional[float] = None,
            budget: Optional[Budget] = None) -> Answer:
        """Whether the language is of a family, or "finite", "infinite", "empty", "regular", "context-free"; with its proof."""
        name = arguments.text("family", family, "the name of a family of languages")
        with limits(timeout, budget, "is") as bounds:
            found = self._language.is_of(str(name), arguments.truth("allow_empty_axiom", allow_empty_axiom), bounds)
        return Answer(found, f"{self._expression} is {name}")

    def member(self, word: WordLike, *, timeout: Optional[float] = None, budget: Optional[Budget] = None) -> Answer:
        """Whether the word is in the language."""
        given = as_word("word", word, self.letters)
        with limits(timeout, budget, "member") as bounds:
            return Answer(self._language.has_word(given._word, bounds), f"{given} in {self._expression}")

    def has_size(self, size: int, *, timeout: Optional[float] = None, budget: Optional[Budget] = None) -> Answer:
        """Whether the language has exactly so many words."""
        wanted = arguments.count("size", size, 0, 10**30)
        with limits(timeout, budget, "size") as bounds:
            return Answer(self._language.has_size(wanted, bounds), f"|{self._expression}| = {wanted}")

    def equal(self, other: "Language", *, timeout: Optional[float] = None, budget: Optional[Budget] = None) -> Answer:
        """Whether both languages have the same words.

        >>> bool(Language("/a(ba)*/").equal(Language("/(ab)*a/")))
        True
        """
        return self._compared("==", other, timeout, budget)

    def subset_of(self, other: "Language", *, timeout: Optional[float] = None, budget: Optional[Budget] = None) -> Answer:
        """Whether each word of the language is one of the other."""
        return self._compared("<=", other, timeout, budget)

    def _compared(self, sign: str, other: "Language", timeout: Optional[float], budget: Optional[Budget]) -> Answer:
        if not isinstance(other, Language):
            raise arguments.wrong_type("other", "a Language", other)
        left, right, systems, letters = self._with(other)
        claim = Claim._about(f"({left}) {sign} ({right})", systems, letters)
        return claim.check(timeout=timeout, budget=budget).statements[0].answer

    def words(self, most: int = 100, *, longest: Optional[int] = None, timeout: Optional[float] = None,
              budget: Optional[Budget] = None) -> list[Word]:
        """The first words, shorter ones first. `listing` says how much of the language they are."""
        listed: list[Word] = self.listing(most, longest=longest, timeout=timeout, budget=budget)["words"]
        return listed

    def listing(self, most: int = 100, *, longest: Optional[int] = None, timeout: Optional[float] = None,
                budget: Optional[Budget] = None) -> dict[str, Any]:
        """The first words, and "whole", "full", "decided" (so many lengths have all their words) and "stopped" (why not more)."""
        length = 1000 if longest is None else arguments.count("longest", longest)
        with limits(timeout, budget, "words") as bounds:
            found = self._language.list_of(length, arguments.count("most", most), bounds)
        return {**found, "words": [Word._of(one) for one in found["words"]]}

    def counts(self, longest: int = 12, *, timeout: Optional[float] = None, budget: Optional[Budget] = None) -> list[int]:
        """How many words of 0, 1, ..., ``longest`` letters there are, as far as that is decided.

        >>> Language("~/(a|b)*bb(a|b)*/").counts(7)
        [1, 2, 3, 5, 8, 13, 21, 34]
        """
        with limits(timeout, budget, "counts") as bounds:
            found: list[int] = self._language.counts_of(arguments.count("longest", longest), bounds)["counts"]
        return found

    def generating_function(self, *, timeout: Optional[float] = None, budget: Optional[Budget] = None) -> Optional[str]:
        """Of a regular language the power series of its counts, as a quotient; None for others."""
        with limits(timeout, budget, "counts") as bounds:
            found: Optional[str] = self._language.counts_of(4, bounds)["function"]
        return found

    def random(self, length: int, count: int = 1, *, seed: int = 1, timeout: Optional[float] = None,
               budget: Optional[Budget] = None) -> list[Word]:
        """Words of a length, each drawn by itself and all equally likely; the same on every machine."""
        with limits(timeout, budget, "random") as bounds:
            return [Word._of(one) for one in self._language.random_words(
                arguments.count("length", length), arguments.count("count", count), arguments.count("seed", seed), bounds)]

    def __contains__(self, word: object) -> bool:
        if not isinstance(word, (str, Word)):
            raise arguments.wrong_type("word", "a word", word)
        return bool(self.member(word))

    def __iter__(self) -> Iterator[Word]:
        """The words, shorter ones first, as long as it is decided which there are."""
        most, seen = 64, 0
        while True:
            found = self.listing(most)
            yield from found["words"][seen:]
            seen = max(seen, len(found["words"]))
            if not found["full"]:
                return
            most *= 4

    def __eq__(self, other: object) -> bool:
        """Whether both have the same words; `Undecided` where that is not decided, and `equal` says why and takes a timeout."""
        if not isinstance(other, Language):
            return NotImplemented
        if self._expression == other._expression and self._systems == other._systems and self._letters == other._letters:
            return True
        return bool(self.equal(other))

    __hash__ = None  # type: ignore[assignment]  # languages that are equal may be written in different ways

    def __str__(self) -> str:
        return self._expression

    def __repr__(self) -> str:
        return f"Language({self._expression!r})"

    def __reduce__(self) -> tuple[Any, ...]:
        return (_unpickled, (self._expression, self._systems, self._letters))

    def _repr_html_(self) -> str:
        found = self.listing(12, timeout=5)
        words = ", ".join(pages.escaped(str(one)) for one in found["words"])
        return f"<code>{pages.escaped(self._expression)}</code> = {{{words}{'' if found['whole'] else ', ...'}}}"


def _unpickled(expression: str, systems: dict[str, "LSystem"], letters: list[str]) -> Language:
    return Language(expression, systems=systems, letters=letters)


def _braced(morphism: Union[Morphism, Mapping[str, WordLike], str]) -> str:
    given = morphism if isinstance(morphism, Morphism) else Morphism(morphism)
    return "{ " + "; ".join(f"{letter} -> {image}" for letter, image in given._morphism.images()) + " }"


class CheckedStatement:
    """A statement of a claim and what is known of it."""

    def __init__(self, parts: dict[str, Any]) -> None:
        self.text: str = parts["text"]
        self.purpose: str = parts["purpose"]
        self.line: int = parts["line"]
        self.column: int = parts["column"]
        self.outcome: str = parts["outcome"]
        self.verdict: str = parts["verdict"]
        self.citation: str = parts["citation"]
        self.method: str = parts["method"]
        self.witness: dict[str, str] = dict(parts["witness"])
        self.answer = Answer(parts["answer"], self.text)

    @property
    def argument(self) -> list[str]:
        """The argument in sentences."""
        return self.answer.argument

    def __repr__(self) -> str:
        return f"CheckedStatement({self.text!r}, {self.verdict})"


class CheckedClaim:
    """What a claim comes to: ``verdict`` is "proved", "refuted", "examples", "cited", "vacuous" or "undecided"."""

    def __init__(self, checked: _algae.Checked, title: str) -> None:
        self._checked = checked
        self.title = title
        self.statements = [CheckedStatement(one) for one in checked.statements()]

    @property
    def verdict(self) -> str:
        """The verdict on the theorem, or on all statements where there is none."""
        return self._checked.verdict()

    @property
    def theorem(self) -> Optional[CheckedStatement]:
        """The statement that the title puts into words."""
        place = self._checked.theorem()
        return None if place is None else self.statements[place]

    @property
    def explanation(self) -> str:
        """The claim as a page: definitions, statements, verdicts and arguments."""
        return self._checked.explanation()

    def certificate(self) -> dict[str, Any]:
        """What `verify` checks again by other means."""
        found: dict[str, Any] = json.loads(self._checked.certificate())
        return found

    def latex(self) -> str:
        """The claim as LaTeX."""
        return self._checked.latex()

    def __bool__(self) -> bool:
        """Whether all statements hold; `Undecided` where one is neither shown nor refuted."""
        from .errors import Undecided

        if any(one.outcome == "fails" for one in self.statements):
            return False
        open_ones = [one for one in self.statements if one.outcome == "undecided"]
        if open_ones:
            raise Undecided(f"{open_ones[0].text}: undecided")
        return True

    def __str__(self) -> str:
        return self.explanation

    def __repr__(self) -> str:
        return f"CheckedClaim({self.title!r}, {self.verdict})"

    def _repr_html_(self) -> str:
        parts = [f"<b>{pages.escaped(self.title)}</b>: {pages.verdict(self.verdict)}"]
        for one in self.statements:
            witness = ", ".join(f"{name} = {value}" for name, value in one.witness.items())
            said = f" by {pages.escaped(witness)}" if witness else ""
            parts.append(f"<details><summary>{pages.escaped(one.purpose)} <code>{pages.escaped(one.text)}</code>: "
                         f"{pages.verdict(one.verdict)}{said}</summary>{pages.argument(one.argument)}</details>")
        return "<div>" + "".join(parts) + "</div>"


class Claim:
    """A claim of the theory: the text of a `.claim` file, with its definitions and statements.

    >>> import algae
    >>> claim = algae.Claim('''claim The union of two 0L languages need not be one
    ... theorem {a} | {aa} is not 0L''')
    >>> claim.check().verdict
    'proved'
    """

    def __init__(self, text: str, *, name: str = "claim", systems: Optional[Mapping[str, "LSystem"]] = None,
                 letters: Iterable[str] = ()) -> None:
        from .systems import LSystem

        given = []
        if systems is not None:
            if not isinstance(systems, Mapping):
                raise arguments.wrong_type("systems", "a dict of names and systems", systems)
            for known, system in systems.items():
                if not isinstance(system, LSystem):
                    raise arguments.wrong_type(f"systems[{known!r}]", "an LSystem", system)
                given.append((arguments.text("systems: a name", known), system._system))
        self.text = arguments.text("text", text)
        self._claim: _algae.Claim = _algae.read_claim(self.text, arguments.text("name", name), given,
                                                      arguments.texts("letters", letters, "a list of letters"))

    @classmethod
    def from_file(cls, path: Union[str, "os.PathLike[str]"]) -> "Claim":
        """The claim in a file; systems that it names are those beside it or of the gallery."""
        from .systems import LSystem

        file = arguments.path("path", path)
        with open(file, encoding="utf-8") as given:
            text = given.read()
        folder = os.path.dirname(file) or "."
        beside = {}
        named = re.findall(r"[\w./-]+\.lsys", text) + re.findall(r"^\s*let\s+\w+\s*=\s*\w+\s+([\w./-]+\.\w+)", text, re.M)
        for found in dict.fromkeys(named):  # systems in other programs' formats too
            place = os.path.join(folder, found)
            inside = os.path.realpath(place).startswith(os.path.realpath(folder) + os.sep)
            if inside and os.path.isfile(place):
                beside[found] = LSystem.from_file(place)
        return cls(text, name=file, systems=beside)

    @classmethod
    def _about(cls, statement: str, systems: Mapping[str, "LSystem"], letters: Iterable[str] = ()) -> "Claim":
        """The claim with one statement, in which L(NAME) are languages of systems."""
        from .systems import LSystem, gallery

        lines = ["claim " + statement.replace("\n", " ").replace("{", "(").replace("}", ")")]
        names: dict[str, "LSystem"] = {}
        text = statement
        known = set(gallery())
        named = {name: LSystem(name) for name in re.findall(r"L\(\s*([^\s()]+)\s*\)", statement) if name in known}
        for i, (name, system) in enumerate({**named, **systems}.items()):
            new = f"System_{i}"
            names[name] = system
            text = re.sub(rf"L\(\s*{re.escape(name)}\s*\)", f"L({new})", text)
            family = "IL" if system._system.has_context() else "ET0L"
            lines.append(f"let {new} = {family} {name}")
        return cls("\n".join([*lines, "show " + text]), name="question", systems=names, letters=letters)

    @property
    def title(self) -> str:
        """What the claim says, in words."""
        return self._claim.title()

    @property
    def source(self) -> str:
        """Where it is from."""
        return self._claim.source()

    def check(self, *, instances: int = 100_000, size: int = 10, timeout: Optional[float] = None,
              budget: Optional[Budget] = None) -> CheckedClaim:
        """Decides all statements; those about all values are searched up to so many instances and such a size."""
        with limits(timeout, budget, "check") as bounds:
            found = self._claim.check(arguments.count("instances", instances), arguments.count("size", size), bounds)
        return CheckedClaim(found, self.title)

    def __repr__(self) -> str:
        return f"Claim({self.title!r})"

    def _repr_html_(self) -> str:
        return pages.preformatted(self.text)


def search(statement: str, *, instances: int = 100_000, size: int = 10, systems: Optional[Mapping[str, "LSystem"]] = None,
           timeout: Optional[float] = None, budget: Optional[Budget] = None) -> CheckedStatement:
    """Searches the instances of a statement about all values, or some: the least counterexample or example is its witness.

    >>> import algae
    >>> algae.search("for all 0L languages A, B: A | B is 0L").witness
    {'A': '{a}', 'B': '{aa}'}
    """
    text = arguments.text("statement", statement)
    if "\n" in text.strip():
        raise arguments.wrong_value("statement", "one statement on a line", statement)
    claim = Claim(f"claim question\ntheorem {text.strip()}", name="statement", systems=systems)
    return claim.check(instances=instances, size=size, timeout=timeout, budget=budget).statements[0]


def verify(certificate: Union[Mapping[str, Any], str, CheckedClaim], *, timeout: Optional[float] = None,
           budget: Optional[Budget] = None) -> list[tuple[str, str, str]]:
    """What an independent checker says of a certificate: for each statement its words, the outcome, and what is wrong.

    >>> import algae
    >>> algae.verify(algae.Claim("claim T; show {a, aa} is not 0L").check())[0][1]
    'checked'
    """
    if isinstance(certificate, CheckedClaim):
        certificate = certificate.certificate()
    if isinstance(certificate, Mapping):
        text = json.dumps(certificate)
    else:
        text = arguments.text("certificate", certificate, "a dict, a str or a CheckedClaim")
    with limits(timeout, budget, "verify") as bounds:
        return _algae.verify(text, bounds)


class Census:
    """How many instances of each size there are, and of how many each statement is proved, refuted and undecided."""

    def __init__(self, of: str, columns: list[str], found: dict[str, Any]) -> None:
        self.of = of
        self.columns = columns
        self.sizes: list[int] = [row["size"] for row in found["rows"]]
        self.instances: list[int] = [row["all"] for row in found["rows"]]
        self._verdicts: list[list[list[int]]] = [row["verdicts"] for row in found["rows"]]
        self.first: dict[str, list[str]] = dict(zip(columns, found["first"]))
        self._infinite: list[int] = [row["infinite"] for row in found["rows"]]

    def proved(self, column: str) -> list[int]:
        """Of how many instances of each size the statement is proved."""
        place = self.columns.index(arguments.choice("column", column, self.columns))
        return [row[place][0] for row in self._verdicts]

    def undecided(self, column: str) -> list[int]:
        """Of how many instances of each size it is not decided."""
        place = self.columns.index(arguments.choice("column", column, self.columns))
        return [row[place][2] for row in self._verdicts]

    def rows(self) -> list[dict[str, int]]:
        """A dict for each size."""
        return [{"size": size, "all": count, **{name: row[i][0] for i, name in enumerate(self.columns)}}
                for size, count, row in zip(self.sizes, self.instances, self._verdicts)]

    def to_pandas(self) -> Any:
        """The table as a `pandas.DataFrame`, a row for each size."""
        from .exchange import pandas_table

        return pandas_table(self)

    def __repr__(self) -> str:
        return f"Census({self.of!r}, {self.instances})"

    def _repr_html_(self) -> str:
        return pages.table(["size", "all", *self.columns], [list(row.values()) for row in self.rows()])


def census(of: str, by: Iterable[str] = (), *, first: int = 0, languages: bool = False, timeout: Optional[float] = None,
           budget: Optional[Budget] = None) -> Census:
    """How many systems, languages or words of each size there are, up to renaming, and how many have each property.

    ``by`` are properties, "finite", "growth", families, or statements about X. With ``languages`` finite languages of systems are
    counted, each once.

    >>> import algae
    >>> algae.census("D0L systems up to size 6").instances
    [0, 1, 2, 5, 17, 64]
    """
    what = arguments.text("of", of)
    of_systems = "systems" in what
    columns: list[str] = []
    statements: list[str] = []
    language = "L(X)" if of_systems else "X"
    if isinstance(by, str):
        by = [one.strip() for one in by.split(",") if one.strip()]
    for one in arguments.texts("by", by, "a list of properties"):
        if one == "growth" and of_systems:
            for kind in ("zero", "bounded", "polynomial", "exponential"):
                columns.append(kind)
                statements.append(f"growth(X) ~ {kind}")
        elif " " in one or "(" in one:
            columns.append(one)
            statements.append(one)
        else:
            columns.append(one)
            statements.append(f"{language} is {one}")
    with limits(timeout, budget, "census") as bounds:
        found = _algae.census(what, statements, arguments.count("first", first),
                              arguments.truth("languages", languages), bounds)
    return Census(what, columns, found)


