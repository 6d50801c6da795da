"""L-systems, the words of their generations, and what their rules say of growth and figures."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from typing import Any, Optional, Union, overload

import numpy

from . import _algae, arguments, pages
from .answers import Comparison, Finite, Membership
from .budget import Budget, limits
from .errors import Error
from .figures import Mesh, Picture, Tree, facts_of, format_of, page_to_turn, wishes_of
from .languages import Language
from .numbers import Algebraic, Dimension
from .words import Morphism, Word, WordLike, as_word

__all__ = ["Generation", "Growth", "LSystem", "Measured", "Recurrence", "gallery", "realise"]

Successor = Union[str, Word, Iterable[str]]
Generations = Union[int, tuple[int, int], None]
PathLike = Union[str, "os.PathLike[str]"]


def gallery() -> list[str]:
    """The names of the systems that come with algae.

    >>> import algae
    >>> "koch" in algae.gallery()
    True
    """
    return [name for name, _ in _algae.gallery()]


def realise(lengths: Union[str, Iterable[int]], *, timeout: Optional[float] = None,
            budget: Optional[Budget] = None) -> "LSystem":
    """A D0L system with these lengths: terms, a recurrence with first values, or a polynomial in n.

    >>> import algae
    >>> algae.realise([1, 1, 2, 3, 5, 8]).lengths(7)
    [1, 1, 2, 3, 5, 8, 13, 21]
    >>> algae.realise("n^2+1").lengths(4)
    [1, 2, 5, 10, 17]
    """
    if isinstance(lengths, str):
        said = arguments.text("lengths", lengths)
    elif isinstance(lengths, Iterable):
        said = ",".join(str(arguments.integer(f"lengths[{i}]", one)) for i, one in enumerate(lengths))
    else:
        raise arguments.wrong_type("lengths", "a str, or a list of ints", lengths)
    with limits(timeout, budget, "realise") as bounds:
        verdict, text, because = _algae.realise(said, bounds)
    if text is None or verdict != "found":
        raise Error(f"no D0L system with these lengths: {because}" if verdict == "impossible"
                    else f"no D0L system with these lengths is known: {because}")
    return LSystem.from_text(text, name="realised")


class LSystem:
    """An L-system: an axiom, rules, and how it is drawn.

    ``source`` is what the command takes for FILE: the path of a file, a name of the gallery, a system typed on a line, or the text of
    a file; or a dict of letters and their successors, where a list stands for a choice and a dict for successors with probabilities.
    ``let`` gives other values to constants, ``settings`` are further lines of the file.

    >>> from algae import LSystem
    >>> LSystem("a -> ab, b -> a").derive(5)
    Word('abaababaabaab')
    >>> LSystem({"F": "F+F--F+F"}, settings={"angle": 60}).kind
    'PD0L'
    >>> LSystem("koch").dimension()
    Dimension('log 4 / log 3', exact)
    """

    def __init__(
        self,
        source: Union[str, "os.PathLike[str]", Mapping[str, Any]],
        *,
        axiom: Union[WordLike, None] = None,
        let: Optional[Mapping[str, Any]] = None,
        settings: Optional[Mapping[str, Any]] = None,
        name: Optional[str] = None,
    ) -> None:
        constants = arguments.constants("let", let)
        called = None if name is None else arguments.text("name", name)
        if isinstance(source, Mapping):
            text = _text_of_rules(source, axiom, settings)
            self._system: _algae.System = _algae.read_system(text, called if called is not None else "system", constants)
            return
        if not isinstance(source, (str, os.PathLike)):
            raise arguments.wrong_type("source", "a str, a path, or a dict of letters and successors", source)
        if settings is not None:
            raise TypeError("settings: is for systems made of a dict; a text says its settings itself")
        if axiom is not None and not isinstance(axiom, (str, Word)):
            raise arguments.wrong_type("axiom", "a Word or a str", axiom)
        if isinstance(source, str):
            self._system = _algae.open_system(arguments.text("source", source), constants, called)
        else:
            self._system = _algae.renamed(_algae.open_file(arguments.path("source", source), constants), called)
        if axiom is not None:
            start = _word_text("axiom", axiom)
            text, replaced = re.subn(r"^axiom .*$", lambda _: f"axiom {start}", self._system.text(), flags=re.M)
            if replaced != 1:
                raise TypeError("axiom: the source has no axiom that could be replaced")
            self._system = _algae.read_system(text, self._system.name() or "system", [])

    @classmethod
    def _of(cls, system: _algae.System) -> "LSystem":
        made = cls.__new__(cls)
        made._system = system
        return made

    @classmethod
    def from_file(cls, path: PathLike, *, let: Optional[Mapping[str, Any]] = None) -> "LSystem":
        """The system in a file: of the notation, or in another program's format by the end of its name."""
        return cls._of(_algae.open_file(arguments.path("path", path), arguments.constants("let", let)))

    @classmethod
    def from_text(cls, text: str, *, name: str = "system", let: Optional[Mapping[str, Any]] = None) -> "LSystem":
        """The system that the text of a file says; ``name`` is what errors call it."""
        return cls._of(_algae.read_system(arguments.text("text", text), arguments.text("name", name),
                                          arguments.constants("let", let)))

    # What it is

    @property
    def name(self) -> str:
        """The name of the file or the gallery's."""
        return self._system.name()

    @property
    def title(self) -> str:
        """The title that the file gives; may be empty."""
        return self._system.title()

    @property
    def source(self) -> str:
        """Where the system is from, as the file says; may be empty."""
        return self._system.source()

    @property
    def kind(self) -> str:
        """The class with the letters of Rozenberg and Salomaa: "PD0L", "(1,0)L", "parametric D0L"."""
        return self._system.class_name()

    @property
    def alphabet(self) -> tuple[str, ...]:
        """The names of all letters, in the order in which they were first written."""
        return tuple(self._system.alphabet())

    @property
    def axiom(self) -> str:
        """The axiom as text."""
        return self._system.axiom()

    @property
    def rules(self) -> list[str]:
        """The rules as text."""
        return self._system.rules()

    @property
    def constants(self) -> dict[str, str]:
        """The constants of `let` and their expressions."""
        return dict(self._system.constants())

    @property
    def angle(self) -> Optional[Fraction]:
        """The angle in degrees, where it is a rational number."""
        return self._system.angle()

    @property
    def shown_generations(self) -> Optional[tuple[int, int]]:
        """The first and the last generation that the file shows."""
        return self._system.shown_generations()

    @property
    def is_deterministic(self) -> bool:
        """Whether it is a D0L system: one successor a letter, without context, parameters and chance."""
        return self._system.is_deterministic()

    @property
    def morphism(self) -> Morphism:
        """The morphism of a D0L system, on all its letters.

        >>> LSystem("a -> ab, b -> a").morphism
        Morphism({'a': 'ab', 'b': 'a'})
        """
        successors = self._system.successors()
        if not self.is_deterministic:
            raise Error(f"{self.name}: expected a D0L system, found one of the class {self.kind}")
        return Morphism({letter: Word._of(words[0]) for letter, words in successors})

    @property
    def text(self) -> str:
        """The canonical text of the file."""
        return self._system.text()

    def to_dict(self) -> dict[str, Any]:
        """What `algae show --json` says."""
        found: dict[str, Any] = json.loads(self._system.report())
        return found

    def with_constants(self, **let: Any) -> "LSystem":
        """The same system with other values of constants.

        >>> LSystem("let c = 2; axiom A(1); A(x) -> A(x*c)").with_constants(c=5).derive(2)
        Word('A(25)')
        """
        return LSystem._of(_algae.read_system(self.text, self.name or "system", arguments.constants("let", let)))

    def converted(self, to: str) -> str:
        """The text in another program's format: "cpfg", "fractint", "jflap" and so on."""
        return self._system.converted(arguments.text("to", to))

    def unmet(self, *, timeout: Optional[float] = None, budget: Optional[Budget] = None) -> list[str]:
        """The lines `expect` of the file that do not hold."""
        with limits(timeout, budget, "expect") as bounds:
            return self._system.unmet(bounds)

    # Words

    def derive(self, n: int, *, seed: Optional[int] = None, tables: str = "", timeout: Optional[float] = None,
               budget: Optional[Budget] = None) -> Word:
        """The word of generation ``n``; of a system with choices the one that the seed picks."""
        with limits(timeout, budget, "derive") as bounds:
            return Word._of(self._system.derive(arguments.generation("n", n), arguments.optional_count("seed", seed),
                                                arguments.text("tables", tables), bounds))

    def word(self, n: int) -> "Generation":
        """The word of generation ``n`` without writing it: slices of it may begin anywhere.

        >>> w = LSystem("a -> ab, b -> a").word(1000)
        >>> w[10**100 : 10**100 + 20]
        Word('ababaabaababaababaab')
        >>> w.length > 10**208
        True
        """
        return Generation(self, arguments.generation("n", n))

    def letter(self, n: int, at: int, *, timeout: Optional[float] = None, budget: Optional[Budget] = None) -> str:
        """The letter of generation ``n`` at a position, counted from 0, of any size."""
        place = arguments.integer("at", at, "a position, an int from 0 on", 0)
        with limits(timeout, budget, "letter") as bounds:
            found = self._system.letters_from(arguments.generation("n", n), place, 1, bounds)
        if found.size() == 0:
            raise IndexError(f"at: generation {n} has no letter at {place}")
        return found.letter(0)

    def length(self, n: int, *, timeout: Optional[float] = None, budget: Optional[Budget] = None) -> int:
        """The exact length of generation ``n``, however long the word is."""
        with limits(timeout, budget, "length") as bounds:
            generation = arguments.generation("n", n)
            if not self.is_deterministic and not self._system.has_context():
                return self._system.derive(generation, None, "", bounds).size()
            return int(_algae.lengths(self._system, generation, generation, bounds)[0])

    def lengths(self, last: int, first: int = 0, *, timeout: Optional[float] = None,
                budget: Optional[Budget] = None) -> list[int]:
        """The lengths of the generations from ``first`` to ``last``.

        >>> LSystem("a -> ab, b -> a").lengths(8)
        [1, 2, 3, 5, 8, 13, 21, 34, 55]
        """
        begin, end = _range("first", first, "last", last)
        with limits(timeout, budget, "lengths") as bounds:
            return _algae.lengths(self._system, begin, end, bounds)

    def counts(self, n: int, *, timeout: Optional[float] = None, budget: Optional[Budget] = None) -> dict[str, int]:
        """How often each letter occurs in generation ``n`` of a D0L system."""
        generation = arguments.generation("n", n)
        with limits(timeout, budget, "counts") as bounds:
            letters, rows = _algae.counts(self._system, generation, generation, bounds)
        return {letter: int(one) for letter, one in zip(letters, rows[0])}

    def count_table(self, last: int, first: int = 0, *, timeout: Optional[float] = None,
                    budget: Optional[Budget] = None) -> tuple[list[str], "numpy.ndarray[Any, Any]"]:
        """The letters and how often they occur, a row for each generation: int64 where all fit, else exact ints."""
        begin, end = _range("first", first, "last", last)
        with limits(timeout, budget, "counts") as bounds:
            letters, rows = _algae.counts(self._system, begin, end, bounds)
        return letters, rows

    def words(self, n: int, longest: Optional[int] = None, *, timeout: Optional[float] = None,
              budget: Optional[Budget] = None) -> list[Word]:
        """All words of generation ``n`` of a system with choices, in shortlex order.

        >>> LSystem({"a": ["a", "aa"]}).words(2)
        [Word('a'), Word('aa'), Word('aaa'), Word('aaaa')]
        """
        with limits(timeout, budget, "words") as bounds:
            return [Word._of(one) for one in self._system.words_of(
                arguments.generation("n", n), arguments.optional_count("longest", longest), bounds)]

    def distribution(self, n: int, *, tables: str = "", timeout: Optional[float] = None,
                     budget: Optional[Budget] = None) -> dict[str, Fraction]:
        """All words of generation ``n`` of a stochastic system with their exact probabilities.

        >>> from fractions import Fraction
        >>> LSystem({"F": {"FF": Fraction(1, 3), "F": Fraction(2, 3)}}).distribution(1)
        {'F': Fraction(2, 3), 'FF': Fraction(1, 3)}
        """
        with limits(timeout, budget, "distribution") as bounds:
            return dict(self._system.distribution(arguments.generation("n", n), arguments.text("tables", tables), bounds))

    def expected(self, n: int, *, timeout: Optional[float] = None, budget: Optional[Budget] = None) -> dict[str, Fraction]:
        """The exact expected number of each letter in generation ``n`` of a stochastic system."""
        with limits(timeout, budget, "expected") as bounds:
            return dict(zip(self.alphabet, self._system.expected(arguments.generation("n", n), bounds)))

    def boxes(self, n: int, *, timeout: Optional[float] = None, budget: Optional[Budget] = None
              ) -> list[tuple[str, tuple[Fraction, Fraction, Fraction], tuple[Fraction, Fraction, Fraction]]]:
        """The boxes of generation ``n`` of shape rules: symbol, lowest corner, sizes."""
        with limits(timeout, budget, "boxes") as bounds:
            return self._system.boxes(arguments.generation("n", n), bounds)

    # Questions

    def growth(self, *, timeout: Optional[float] = None, budget: Optional[Budget] = None) -> "Growth":
        """How the words of a D0L system grow, exactly."""
        with limits(timeout, budget, "growth") as bounds:
            return Growth(_algae.growth(self._system, bounds))

    def length_bounds(self, n: int, *, timeout: Optional[float] = None, budget: Optional[Budget] = None
                      ) -> tuple[list[int], list[int]]:
        """The least and the greatest lengths of generations 0 to ``n`` of an 0L system."""
        with limits(timeout, budget, "lengths") as bounds:
            return _algae.length_bounds(self._system, arguments.generation("n", n), bounds)

    def factors(self, *, timeout: Optional[float] = None, budget: Optional[Budget] = None) -> dict[str, Any]:
        """Factor complexity, its class, repetitions and a locally catenative formula, as `algae growth --words --json`."""
        with limits(timeout, budget, "factors") as bounds:
            found: dict[str, Any] = json.loads(_algae.factors_json(self._system, bounds))
        return found

    def factor_complexity(self, longest: int, *, timeout: Optional[float] = None,
                          budget: Optional[Budget] = None) -> list[int]:
        """How many factors of 0, 1, ..., ``longest`` letters the words of a D0L system have.

        >>> LSystem("thue-morse").factor_complexity(6)
        [1, 2, 4, 6, 10, 12, 16]
        """
        with limits(timeout, budget, "factors") as bounds:
            found = json.loads(_algae.factor_values_json(self._system, arguments.count("longest", longest, 0, 10**6), bounds))
        return [int(one) for one in found["factor_complexity"]["values"]]

    def factor_report(self, longest: int, *, timeout: Optional[float] = None,
                      budget: Optional[Budget] = None) -> dict[str, Any]:
        """Factor, palindromic and Abelian complexity up to a length, and more of the factors, as `algae words --json` says them; what
        holds for all lengths by automata, ``not_proved`` and the critical exponent, only the command proves."""
        with limits(timeout, budget, "factors") as bounds:
            found: dict[str, Any] = json.loads(
                _algae.factor_values_json(self._system, arguments.count("longest", longest, 0, 10**6), bounds))
        return found

    def member(self, word: WordLike, *, timeout: Optional[float] = None, budget: Optional[Budget] = None) -> Membership:
        """Whether a word is in the language, with its derivation.

        >>> found = LSystem("a -> ab, b -> a").member("abaab")
        >>> bool(found), found.step
        (True, 3)
        """
        given = as_word("word", word, self.alphabet)
        with limits(timeout, budget, "member") as bounds:
            return Membership(*_algae.member(self._system, given._word, bounds))

    def finite(self, *, timeout: Optional[float] = None, budget: Optional[Budget] = None) -> Finite:
        """Whether the language is finite, and how many words it has."""
        with limits(timeout, budget, "finite") as bounds:
            return Finite(*_algae.finite(self._system, bounds))

    def equal(self, other: "LSystem", by: str = "language", *, timeout: Optional[float] = None,
              budget: Optional[Budget] = None) -> Comparison:
        """Whether two D0L systems have the same language, the same sequence of words, or the same growth.

        >>> bool(LSystem("a -> ab, b -> a").equal(LSystem("b -> a, a -> ab", axiom="b"), "growth"))
        False
        """
        if not isinstance(other, LSystem):
            raise arguments.wrong_type("other", "an LSystem", other)
        way = arguments.choice("by", by, ("language", "sequence", "growth"))
        decide = {"language": _algae.equal_languages, "sequence": _algae.equal_sequences,
                  "growth": _algae.equal_growths}[way]
        with limits(timeout, budget, "equal") as bounds:
            return Comparison(*decide(self._system, other._system, bounds))

    def is_(self, family: str, *, timeout: Optional[float] = None, budget: Optional[Budget] = None) -> Any:
        """Whether the language is of a family: "regular", "0L", "finite" and so on; an `Answer`."""
        return self.language.is_(family, timeout=timeout, budget=budget)

    @property
    def language(self) -> Language:
        """The language of the system, L(G)."""
        return Language.of_system(self)

    def dimension(self, *, timeout: Optional[float] = None, budget: Optional[Budget] = None) -> Dimension:
        """The dimension of the limit curve, as the rules give it."""
        with limits(timeout, budget, "dimension") as bounds:
            return Dimension(_algae.dimension_of(self._system, bounds))

    def dimension_bounds(self, within: Union[int, float, Fraction] = Fraction(1, 100), *,
                         timeout: Optional[float] = None, budget: Optional[Budget] = None) -> tuple[Fraction, Fraction]:
        """Bounds of the Hausdorff dimension that are proved, so near each other if they come so near."""
        width = arguments.exact("within", within, "a number above 0")
        if width <= 0:
            raise arguments.wrong_value("within", "a number above 0", within)
        with limits(timeout, budget, "dimension") as bounds:
            low, high, _, _ = _algae.dimension_bounds(self._system, width, bounds)
        return low, high

    def measure(self, n: Optional[int] = None, by: str = "boxes", *, seed: Optional[int] = None, tables: str = "",
                timeout: Optional[float] = None, budget: Optional[Budget] = None) -> "Measured":
        """The dimension of the figure of generation ``n``, measured: by boxes, divider, mass, correlation or lacunarity."""
        shown = self._shown(n, seed, tables)
        way = arguments.choice("by", by, ("boxes", "divider", "mass", "correlation", "lacunarity"))
        with limits(timeout, budget, "measure") as bounds:
            return Measured(*_algae.measured(self._system, shown, way, bounds))

    # Figures

    def _generations(self, n: Generations) -> tuple[int, int]:
        if n is None:
            shown = self.shown_generations
            if shown is None:
                raise TypeError(f"n: expected a generation, as {self.name or 'the system'} does not say which one it shows")
            return shown
        if isinstance(n, tuple):
            if len(n) != 2:
                raise arguments.wrong_value("n", "a generation, or a pair (first, last)", n)
            return _range("n[0]", n[0], "n[1]", n[1])
        if isinstance(n, bool) or not hasattr(type(n), "__index__"):
            raise arguments.wrong_type("n", "a generation, an int from 0 on, or a pair (first, last)", n)
        generation = arguments.generation("n", n)
        return generation, generation

    def _shown(self, n: Generations, seed: Optional[int] = None, tables: str = "") -> _algae.Shown:
        first, last = self._generations(n)
        return _algae.Shown(first, last, arguments.optional_count("seed", seed), arguments.text("tables", tables))

    def draw(self, n: Generations = None, path: Optional[PathLike] = None, *, format: Optional[str] = None,
             seed: Optional[int] = None, tables: str = "", timeout: Optional[float] = None,
             budget: Optional[Budget] = None, **wishes: Any) -> Picture:
        """The figure of a generation, or of several, ``n=(0, 4)``, side by side, as pages or as an animation.

        The format is that of the path, or svg: also pdf, png, gif, webp, tex, csv, html and, for figures in space, glb, obj, stl and so
        on. Further arguments: width, height, margin, line_width, font_size, frame_time, colours, background, caption, captions,
        scale_bar, common_scale, panels, camera, facets.
        """
        file = None if path is None else arguments.path("path", path)
        chosen = format_of(file, format)
        shown = self._shown(n, seed, tables)
        wanted = wishes_of(wishes)
        page = None
        with limits(timeout, budget, "draw") as bounds:
            data, texts = _algae.draw(self._system, shown, wanted, chosen, bounds)
            if chosen == "svg" and self._system.leaves_plane() and "camera" not in wishes and file is None:
                page = page_to_turn(self._system, shown, wanted, bounds)
        picture = Picture(data, chosen, facts_of(texts), page)
        if file is not None:
            picture.save(file)
        return picture

    def facts(self, n: Generations = None, *, seed: Optional[int] = None, tables: str = "",
              timeout: Optional[float] = None, budget: Optional[Budget] = None) -> dict[str, Any]:
        """Segments, bounding box and end of a figure, without drawing it."""
        with limits(timeout, budget, "facts") as bounds:
            return facts_of(_algae.facts(self._system, self._shown(n, seed, tables), bounds))[-1]

    def points(self, n: Optional[int] = None, *, seed: Optional[int] = None, tables: str = "",
               timeout: Optional[float] = None, budget: Optional[Budget] = None) -> "numpy.ndarray[Any, Any]":
        """The points that the turtle goes through with the pen down, an array of shape (points, 2).

        Nothing is copied. Where the pen is lifted a new run of points begins, and `strokes` says where.

        >>> LSystem("koch").points(1)[:3]
        array([[0.       , 0.       ],
               [1.       , 0.       ],
               [1.5      , 0.8660254]])
        """
        return self.strokes(n, seed=seed, tables=tables, timeout=timeout, budget=budget)[0]

    def strokes(self, n: Optional[int] = None, *, seed: Optional[int] = None, tables: str = "",
                timeout: Optional[float] = None, budget: Optional[Budget] = None
                ) -> tuple["numpy.ndarray[Any, Any]", "numpy.ndarray[Any, Any]"]:
        """The points, and the place in them where each run begins that is drawn in one go."""
        with limits(timeout, budget, "points") as bounds:
            return _algae.points(self._system, self._shown(n, seed, tables), bounds)

    def segments(self, n: Optional[int] = None, *, seed: Optional[int] = None, tables: str = "",
                 timeout: Optional[float] = None, budget: Optional[Budget] = None) -> "numpy.ndarray[Any, Any]":
        """Both ends of each segment, an array of shape (segments, 2, 2), in space (segments, 2, 3); nothing is copied."""
        with limits(timeout, budget, "segments") as bounds:
            return _algae.segments(self._system, self._shown(n, seed, tables), bounds)

    def mesh(self, n: Optional[int] = None, *, facets: int = 8, seed: Optional[int] = None, tables: str = "",
             timeout: Optional[float] = None, budget: Optional[Budget] = None) -> Mesh:
        """The surface of a figure in space as triangles."""
        shown = self._shown(n, seed, tables)
        with limits(timeout, budget, "mesh") as bounds:
            arrays = _algae.mesh(self._system, shown, arguments.count("facets", facets, 3, 256), bounds)
        return Mesh(arrays, self._system, shown)

    def tree(self, n: Optional[int] = None, *, word: Union[WordLike, None] = None, depth: Optional[int] = None,
             shared: bool = False, seed: Optional[int] = None, tables: str = "", max_nodes: int = 2000,
             timeout: Optional[float] = None, budget: Optional[Budget] = None) -> Tree:
        """The derivation tree of generation ``n``, or of a word of the language."""
        cut = arguments.optional_count("depth", depth)
        most = arguments.count("max_nodes", max_nodes, 1)
        is_shared = arguments.truth("shared", shared)
        with limits(timeout, budget, "tree") as bounds:
            if word is not None:
                if n is not None:
                    raise TypeError("tree: expected n or word, found both")
                given = as_word("word", word, self.alphabet)
                return Tree(_algae.tree_of_word(self._system, given._word, cut, is_shared, most, bounds))
            if n is None:
                raise TypeError("tree: expected a generation n, or a word")
            return Tree(_algae.tree_of(self._system, self._shown(n, seed, tables), cut, is_shared, most, bounds))

    def growth_graph(self, *, timeout: Optional[float] = None, budget: Optional[Budget] = None) -> Tree:
        """The digraph of growth: which letters occur in the successors of which, how often, and their fates."""
        with limits(timeout, budget, "growth") as bounds:
            return Tree(_algae.growth_digraph(self._system, bounds))

    # Others

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, LSystem):
            return NotImplemented
        return self._system.equals(other._system)

    def __hash__(self) -> int:
        return hash(self.text)

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        if self.name in gallery():
            return f"LSystem({self.name!r})"
        rules = ", ".join(self.rules)
        if len(rules) > 60:
            rules = rules[:57] + "..."
        return f"LSystem('axiom {self.axiom}, {rules}')" if len(self.axiom) < 30 else f"LSystem('{rules}')"

    def __reduce__(self) -> tuple[Any, ...]:
        return (_unpickled, (self.text, self.name))

    def _repr_latex_(self) -> str:
        return self._system.latex()

    def _repr_html_(self) -> str:
        figure = ""
        try:
            shown = self.shown_generations
            if shown is not None:
                picture = self.draw(shown[1], timeout=5, width=320.0, budget=Budget(progress=False))
                figure = picture._repr_html_() or pages.svg_element(picture._repr_svg_() or "")
        except Exception:  # a figure that takes too long, or that is none, is left out
            figure = ""
        head = f"<b>{pages.escaped(self.title or self.name)}</b> ({pages.escaped(self.kind)})"
        return f"<div>{head}{figure}{pages.preformatted(self.text)}</div>"


def _unpickled(text: str, name: str) -> LSystem:
    return LSystem.from_text(text, name=name or "system")


def _range(first_name: str, first: object, last_name: str, last: object) -> tuple[int, int]:
    begin, end = arguments.generation(first_name, first), arguments.generation(last_name, last)
    if end < begin:
        raise ValueError(f"{last_name}: expected {begin} or more, which is {first_name}, found {end}")
    if end - begin >= 100_000:
        raise ValueError(f"{last_name}: expected at most 100000 generations, found {end - begin + 1}")
    return begin, end


def _word_text(name: str, value: object) -> str:
    if isinstance(value, Word):
        return str(value)
    if isinstance(value, str):
        text = arguments.text(name, value)
        if "\n" in text or ";" in text or "->" in text:
            raise arguments.wrong_value(name, "a word", value)
        return text.strip() or "ε"
    if isinstance(value, (list, tuple)) and all(isinstance(one, str) for one in value):
        return str(Word(value))
    raise arguments.wrong_type(name, "a word, as a str, a Word or a list of letters", value)


def _text_of_rules(rules: Mapping[str, Any], axiom: Union[WordLike, None], settings: Optional[Mapping[str, Any]]) -> str:
    """The text of a file that says the rules of a dict."""
    if not rules and axiom is None:
        raise ValueError("source: expected rules, found an empty dict")
    lines, names = [], []
    for key, value in rules.items():
        left = arguments.text("source: a letter", key).strip()
        if not left or "\n" in left or ";" in left or "->" in left:
            raise arguments.wrong_value("source: a letter", "a letter, or the left side of a rule", key)
        if left.replace("_", "a").isalnum():
            names.append(left)
        name = f"source[{left!r}]"
        if isinstance(value, Mapping):
            for word, chance in value.items():
                likely = arguments.probability(f"{name}[{word!r}]", chance)
                lines.append(f"{left} -({likely})-> {_word_text(name, word)}")
        elif isinstance(value, (list, tuple, set, frozenset)) and not (isinstance(value, tuple) and not value):
            options = sorted(value, key=str) if isinstance(value, (set, frozenset)) else list(value)
            for one in options:
                lines.append(f"{left} -> {_word_text(name, one)}")
        else:
            lines.append(f"{left} -> {_word_text(name, value)}")
    declared = [one for one in names if len(one) > 1 and not _is_short(one)]
    for value in rules.values():
        for one in (value if isinstance(value, (list, tuple)) else [value]):
            if isinstance(one, Word):
                declared += [letter for letter in one.letters if len(letter) > 1 and not _is_short(letter)]
    start = _word_text("axiom", axiom) if axiom is not None else names[0] if names else None
    if start is None:
        raise TypeError("axiom: expected a word, as the first key of the rules is no letter")
    head = []
    if declared:
        head.append("alphabet " + " ".join(dict.fromkeys(declared)))
    for key, value in (settings or {}).items():
        setting = arguments.text("settings: a name", key)
        said = value if isinstance(value, str) else " ".join(str(one) for one in value) if isinstance(
            value, (list, tuple)) else str(arguments.exact(f"settings[{setting!r}]", value, "a number, a str or a list"))
        if "\n" in setting or "\n" in said:
            raise arguments.wrong_value("settings", "settings without line breaks", {key: value})
        (head if setting in ("let", "title", "source") else lines).append(f"{setting} {said}")
    return "\n".join([*head, f"axiom {start}", *lines]) + "\n"


def _is_short(name: str) -> bool:
    """Whether the notation reads the name as one letter by itself: a letter with a subscript."""
    return len(name) > 2 and name[1] == "_" and name[2:].isalnum() and (len(name) == 3 or name[2:].isdigit())


class Generation:
    """The word of one generation, which is not written out: its length, its letters and its slices.

    Slices go forward, ``w[a:b]``, and are Words; positions may be of any size. ``len`` works as long as Python allows the number;
    ``length`` always does.
    """

    def __init__(self, system: LSystem, n: int) -> None:
        if not isinstance(system, LSystem):
            raise arguments.wrong_type("system", "an LSystem", system)
        self.system = system
        self.n = arguments.generation("n", n)
        self._length: Optional[int] = None

    @property
    def length(self) -> int:
        """The number of letters, exactly."""
        if self._length is None:
            self._length = self.system.length(self.n)
        return self._length

    def __len__(self) -> int:
        return self.length

    def part(self, start: int, stop: int, *, timeout: Optional[float] = None, budget: Optional[Budget] = None) -> Word:
        """The letters from one position up to another."""
        begin = arguments.integer("start", start, "a position, an int from 0 on", 0)
        end = arguments.integer("stop", stop, "a position, an int from 0 on", 0)
        if end <= begin:
            return Word()
        with limits(timeout, budget, "part") as bounds:
            if end - begin > arguments.LARGEST:
                raise OverflowError("stop: a slice of so many letters does not fit any memory")
            try:
                return Word._of(self.system._system.letters_from(self.n, begin, end - begin, bounds))
            except Error:
                if begin < self.length:
                    raise
                return Word()

    @overload
    def __getitem__(self, at: int) -> str: ...

    @overload
    def __getitem__(self, at: slice) -> Word: ...

    def __getitem__(self, at: Union[int, slice]) -> Union[str, Word]:
        if isinstance(at, slice):
            start = 0 if at.start is None else arguments.integer("start", at.start)
            stop = self.length if at.stop is None else arguments.integer("stop", at.stop)
            if start < 0:
                start = max(0, start + self.length)
            if stop < 0:
                stop = max(0, stop + self.length)
            step = 1 if at.step is None else arguments.integer("step", at.step)
            if step < 1:
                raise arguments.wrong_value("step", "an int from 1 on; [::-1] of a slice reads it backwards", step)
            found = self.part(start, stop)
            return found if step == 1 else found[::step]
        place = arguments.integer("index", at, "an int or a slice")
        if place < 0:
            place += self.length
        if place < 0:
            raise IndexError(f"index: the word has {self.length} letters")
        found = self.part(place, place + 1)
        if len(found) == 0:
            raise IndexError(f"index: the word has {self.length} letters, and none at {place}")
        return found[0]

    def counts(self) -> dict[str, int]:
        """How often each letter occurs."""
        return self.system.counts(self.n)

    def write(self) -> Word:
        """The word, written out."""
        return self.system.derive(self.n)

    def __iter__(self) -> Iterator[str]:
        block = 1 << 16
        at = 0
        while True:
            part = self.part(at, at + block)
            yield from part
            if len(part) < block:
                return
            at += block

    def __str__(self) -> str:
        return str(self.write())

    def __repr__(self) -> str:
        return f"Generation({self.system!r}, {self.n})"


class Growth:
    """How the words of a D0L system grow, exactly.

    >>> growth = LSystem("koch").growth()
    >>> growth.closed_form, growth.recurrence.text, growth.kind, growth.rate
    ('(7*4^n - 4)/3', 'a(n) = 5a(n-1) - 4a(n-2)', 'exponential', Algebraic('4'))
    """

    def __init__(self, growth: _algae.Growth) -> None:
        if not isinstance(growth, _algae.Growth):
            raise arguments.wrong_type("growth", "what LSystem.growth gives", growth)
        self._growth = growth

    @property
    def letters(self) -> list[str]:
        """The letters that occur in some generation, in the order of rows and shares."""
        return self._growth.letters()

    @property
    def lengths(self) -> list[int]:
        """The lengths of generations 0 to 10."""
        return self._growth.lengths()

    def values(self, count: int, *, timeout: Optional[float] = None, budget: Optional[Budget] = None) -> list[int]:
        """The first lengths, by the recurrence.

        >>> LSystem("a -> ab, b -> a").growth().values(8)
        [1, 2, 3, 5, 8, 13, 21, 34]
        """
        most = arguments.count("count", count, 0, 10**7)
        with limits(timeout, budget, "values") as bounds:
            return self._growth.values(most, bounds)

    @property
    def matrix(self) -> "numpy.ndarray[Any, Any]":
        """Row i, column j: how often the j-th letter occurs in the successor of the i-th."""
        return self._growth.matrix()

    @property
    def characteristic_polynomial(self) -> list[int]:
        """Coefficients, the constant one first."""
        return self._growth.characteristic()

    @property
    def factors(self) -> list[tuple[list[int], int]]:
        """The irreducible factors of the characteristic polynomial and how often each occurs."""
        return self._growth.characteristic_factors()

    @property
    def minimal_polynomial(self) -> list[int]:
        """Coefficients of the minimal polynomial of the matrix, the constant one first."""
        return self._growth.minimal()

    @property
    def recurrence(self) -> "Recurrence":
        """The shortest recurrence of the lengths."""
        return Recurrence(*self._growth.recurrence())

    @property
    def generating_function(self) -> tuple[list[int], list[int]]:
        """Numerator and denominator, the constant coefficients first."""
        numerator, denominator, _ = self._growth.generating_function()
        return numerator, denominator

    @property
    def closed_form(self) -> str:
        """The length of generation n as a formula."""
        return self._growth.closed_form()

    @property
    def kind(self) -> str:
        """ "zero", "bounded", "polynomial" or "exponential"."""
        return self._growth.kind()

    @property
    def order(self) -> str:
        """ "n^2", "2^n", "((1+sqrt(5))/2)^n"."""
        return self._growth.order()

    @property
    def degree(self) -> int:
        """The power of n beside the power of the rate."""
        return self._growth.degree()

    @property
    def rate(self) -> Algebraic:
        """The rate of exponential growth; 1 for others."""
        return Algebraic(self._growth.rate())

    @property
    def is_primitive(self) -> bool:
        """Whether some power of the morphism sends each letter to a word with all letters."""
        return self._growth.primitivity() is not None

    @property
    def frequencies(self) -> Optional[dict[str, Algebraic]]:
        """The limit of the share of each letter; None where the shares have no limits.

        >>> LSystem("a -> ab, b -> a").growth().frequencies["b"]
        Algebraic('(3-sqrt(5))/2')
        """
        rows = self._growth.frequencies()
        if len(rows) != 1:
            return None
        return {letter: Algebraic(one) for letter, one in zip(self.letters, rows[0])}

    def to_dict(self) -> dict[str, Any]:
        """What `algae growth --json` says."""
        found: dict[str, Any] = json.loads(self._growth.report())
        return found

    def latex(self, part: str = "all") -> str:
        """All of it, or lengths, matrix, recurrence, function, form or rate, as LaTeX."""
        return self._growth.latex(arguments.text("part", part))

    def __str__(self) -> str:
        return self._growth.page()

    def __repr__(self) -> str:
        return f"Growth({self.kind}, {self.order})"

    def _formulas(self) -> list[str]:
        return [self._growth.latex(part).strip() for part in ("recurrence", "form")]

    def _repr_latex_(self) -> str:
        return "\n\n".join(f"$${one}$$" for one in self._formulas())

    def _repr_html_(self) -> str:
        # Notebooks prefer HTML to LaTeX, so the formulas are in it.
        return "".join(pages.formula(one) for one in self._formulas()) + pages.folded("all of the analysis", self._growth.page())


class Recurrence:
    """The shortest recurrence of a sequence: ``polynomial`` (the constant coefficient first, monic), what it starts from, and how many
    first values stand outside."""

    def __init__(self, polynomial: list[int], exceptions: int, initial: list[int], text: str) -> None:
        self.polynomial = polynomial
        self.exceptions = exceptions
        self.initial = initial
        self.text = text

    @property
    def order(self) -> int:
        """How many values before it a value follows from."""
        return len(self.polynomial) - 1

    def __repr__(self) -> str:
        return f"Recurrence({self.text!r})"


class Measured:
    """A dimension that was measured: ``value``, the interval in which the true one is expected, and why; no proof."""

    def __init__(self, estimate: Optional[tuple[float, float, float]], because: str) -> None:
        self.value: Optional[float] = estimate[0] if estimate else None
        self.low: Optional[float] = estimate[1] if estimate else None
        self.high: Optional[float] = estimate[2] if estimate else None
        self.because = because

    def __repr__(self) -> str:
        if self.value is None:
            return f"Measured(None: {self.because})"
        return f"Measured({self.value:.4f}, from {self.low:.4f} to {self.high:.4f})"
