"""Words and morphisms."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from typing import Any, Optional, Union, overload

import numpy

from . import _algae, arguments
from .budget import Budget, limits
from .errors import Error

__all__ = ["Morphism", "Parameter", "Word", "WordLike"]

Parameter = Union[int, Fraction, float, str]


class Word:
    """A word: letters over an alphabet, each a name of one or more characters.

    A text is read as the notation writes words: ``F_l`` is one letter, ``ε`` the empty word. Names of ``alphabet`` that are longer
    than one character are read as one letter. A list of names is taken as it is.

    >>> from algae import Word
    >>> w = Word("abaab")
    >>> w[1:4], len(w), w + "ba", w * 2
    (Word('baa'), 5, Word('abaabba'), Word('abaababaab'))
    >>> w.counts(), w.array()
    ({'a': 3, 'b': 2}, array([0, 1, 0, 0, 1], dtype=uint32))
    """

    __slots__ = ("_word",)

    def __init__(self, letters: Union[str, "Word", Iterable[str]] = "", *, alphabet: Iterable[str] = ()) -> None:
        names = arguments.texts("alphabet", alphabet, "a list of names of letters")
        if isinstance(letters, Word):
            self._word: _algae.Word = letters._word
        elif isinstance(letters, str):
            self._word = _algae.Word(arguments.text("letters", letters) or "ε", names)
        else:
            found = arguments.texts("letters", letters, "a str or a list of names of letters")
            self._word = _algae.Word.of_letters(found, names)

    @classmethod
    def _of(cls, word: _algae.Word) -> "Word":
        made = cls.__new__(cls)
        made._word = word
        return made

    @property
    def letters(self) -> list[str]:
        """The names of the letters, one after the other."""
        return self._word.letters()

    @property
    def alphabet(self) -> tuple[str, ...]:
        """All letters that the word is over, numbered as in `array`."""
        return tuple(self._word.alphabet())

    @property
    def modules(self) -> list[tuple[str, tuple[Parameter, ...]]]:
        """The letters with their parameters: exact numbers where they are known exactly.

        >>> import algae
        >>> algae.LSystem("axiom A(1); A(x) -> F(x/2)A(x*3)").derive(2).modules
        [('F', (Fraction(1, 2),)), ('F', (Fraction(3, 2),)), ('A', (9,))]
        """
        if self._word.has_parameters():
            return self._word.modules()
        return [(letter, ()) for letter in self._word.letters()]

    @property
    def has_parameters(self) -> bool:
        """Whether letters carry parameters."""
        return self._word.has_parameters()

    def array(self, dtype: Any = "uint32") -> "numpy.ndarray[Any, Any]":
        """The letters as numbers, places in `alphabet`: uint32 without copying, for reading only, or uint8.

        >>> Word("abaab").array("uint8")
        array([0, 1, 0, 0, 1], dtype=uint8)
        """
        wanted = numpy.dtype(dtype)
        if wanted == numpy.uint32:
            return self._word.array()
        if wanted == numpy.uint8:
            with limits(None, None, "array") as bounds:
                return self._word.bytes(bounds)
        raise arguments.wrong_value("dtype", "uint32 or uint8", dtype)

    def __array__(self, dtype: Any = None) -> "numpy.ndarray[Any, Any]":
        found = self._word.array()
        return found if dtype is None else found.astype(dtype)

    def counts(self, *, timeout: float | None = None, budget: Budget | None = None) -> dict[str, int]:
        """How often each letter of the alphabet occurs.

        >>> Word("abaab").counts()
        {'a': 3, 'b': 2}
        """
        with limits(timeout, budget, "counts") as bounds:
            return dict(zip(self._word.alphabet(), (int(one) for one in self._word.counts(bounds))))

    def count(self, part: "WordLike", *, timeout: float | None = None, budget: Budget | None = None) -> int:
        """How often the word occurs in this one, overlapping occurrences too.

        >>> Word("aaaa").count("aa")
        3
        """
        wanted = as_word("part", part)
        with limits(timeout, budget, "count") as bounds:
            return self._word.count(wanted._word, bounds)

    def find(self, part: "WordLike", start: int = 0, *, timeout: float | None = None, budget: Budget | None = None) -> int:
        """The first position from `start` on where the word occurs; -1 where it does not.

        >>> Word("abaab").find("ab"), Word("abaab").find("ab", 1), Word("abaab").find("bb")
        (0, 3, -1)
        """
        wanted, place = as_word("part", part), arguments.count("start", start)
        with limits(timeout, budget, "find") as bounds:
            return self._word.find(wanted._word, place, bounds)

    def reversed(self) -> "Word":
        """The word read backwards.

        >>> Word("abaab").reversed()
        Word('baaba')
        """
        return self[::-1]

    def is_palindrome(self) -> bool:
        """Whether the word read backwards is the same.

        >>> Word("abaaba").is_palindrome(), Word("abaab").is_palindrome()
        (True, False)
        """
        return self == self[::-1]

    def analysis(self, *, timeout: float | None = None, budget: Budget | None = None) -> dict[str, Any]:
        """Periods, borders, Lyndon factors, palindromes, runs, squares and factors, as `algae words --json` says them.

        >>> Word("abaab").analysis()["periods"]
        [3, 5]
        """
        with limits(timeout, budget, "analysis") as bounds:
            found: dict[str, Any] = json.loads(self._word.report(bounds))
        return found

    def __len__(self) -> int:
        return self._word.size()

    def __iter__(self) -> Iterator[str]:
        return iter(self._word.letters())

    def __contains__(self, part: object) -> bool:
        if not isinstance(part, (str, Word)):
            raise arguments.wrong_type("part", "a letter or a word", part)
        return self.find(part) >= 0

    @overload
    def __getitem__(self, at: int) -> str: ...

    @overload
    def __getitem__(self, at: slice) -> "Word": ...

    def __getitem__(self, at: Union[int, slice]) -> Union[str, "Word"]:
        size = len(self)
        if isinstance(at, slice):
            start, stop, step = at.indices(size)
            with limits(None, None, "slice") as bounds:
                return Word._of(self._word.part(start, step, len(range(start, stop, step)), bounds))
        place = arguments.integer("index", at, "an int or a slice")
        if not -size <= place < size:
            raise IndexError(f"index: the word has {size} letters, and none at {place}")
        return self._word.letter(place % size)

    def __add__(self, other: object) -> "Word":
        if not isinstance(other, (str, Word)):
            return NotImplemented
        right = as_word("other", other)
        with limits(None, None, "word") as bounds:
            return Word._of(self._word.join(right._word, bounds))

    def __radd__(self, other: object) -> "Word":
        if not isinstance(other, str):
            return NotImplemented
        return Word(other) + self

    def __mul__(self, times: object) -> "Word":
        if isinstance(times, bool) or not hasattr(type(times), "__index__"):
            return NotImplemented
        count = max(0, arguments.integer("times", times, most=2**62))
        with limits(None, None, "word") as bounds:
            return Word._of(self._word.repeat(count, bounds))

    __rmul__ = __mul__
    __pow__ = __mul__

    def __eq__(self, other: object) -> bool:
        if isinstance(other, str):
            if self._word.has_parameters():
                return str(self) == other
            try:
                other = Word(other, alphabet=[one for one in self._word.alphabet() if len(one) > 1])
            except (Error, ValueError):
                return False
        if not isinstance(other, Word):
            return NotImplemented
        with limits(None, None, "word") as bounds:
            return self._word.equals(other._word, bounds)

    def __hash__(self) -> int:
        return hash(str(self))

    def __bool__(self) -> bool:
        return len(self) > 0

    def __str__(self) -> str:
        with limits(None, None, "text") as bounds:
            return self._word.text(bounds)

    def __repr__(self) -> str:
        if len(self) <= 80:
            return f"Word({str(self)!r})"
        return f"Word({str(self[:60])!r}..., {len(self)} letters)"

    def __reduce__(self) -> tuple[Any, ...]:
        if self.has_parameters:
            raise TypeError("a word with parameters is not pickled; its text is")
        return (_unpickled, (self.letters, list(self.alphabet)))

    def _repr_latex_(self) -> str:
        return f"${self._word.latex()}$"


WordLike = Union[str, Word]


def _unpickled(letters: list[str], alphabet: list[str]) -> Word:
    return Word(letters, alphabet=alphabet)


def as_word(name: str, value: object, alphabet: Iterable[str] = ()) -> Word:
    """A word of an argument; of a text the names of the alphabet are read as letters."""
    if isinstance(value, Word):
        return value
    if isinstance(value, str):
        return Word(value, alphabet=[one for one in alphabet if len(one) > 1])
    if isinstance(value, (list, tuple)):
        return Word(value)
    raise arguments.wrong_type(name, "a Word, a str or a list of letters", value)


class Morphism:
    """A morphism of free monoids: a letter goes to a word, a word to the images of its letters, one after the other.

    ``f(w)`` is the image, ``f * g`` the morphism that applies g first, ``f ** n`` the n-th power.

    >>> from algae import Morphism
    >>> h = Morphism({"a": "ab", "b": "a"})
    >>> h("abaab"), h ** 3, h * h == h ** 2
    (Word('abaababa'), Morphism({'a': 'abaab', 'b': 'aba'}), True)
    >>> Morphism("a -> ab, b -> a") == h
    True
    """

    __slots__ = ("_morphism",)

    def __init__(self, images: Union[str, Mapping[str, WordLike]]) -> None:
        if isinstance(images, str):
            pairs = _pairs_of_text(arguments.text("images", images))
        elif isinstance(images, Mapping):
            pairs = []
            for letter, image in images.items():
                name = arguments.text("images: a letter", letter)
                if isinstance(image, (list, tuple)):
                    image = Word(image)
                if not isinstance(image, (str, Word)):
                    raise arguments.wrong_type(f"images[{name!r}]", "a word", image)
                pairs.append((name, str(image) or "ε"))
        else:
            raise arguments.wrong_type("images", "a dict of letters and words, or a str such as 'a -> ab, b -> a'", images)
        for name, _ in pairs:
            if not name or any(one.isspace() for one in name):
                raise arguments.wrong_value("images: a letter", "a name without blanks", name)
        self._morphism: _algae.Morphism = _algae.Morphism(pairs)

    @classmethod
    def _of(cls, morphism: _algae.Morphism) -> "Morphism":
        made = cls.__new__(cls)
        made._morphism = morphism
        return made

    @property
    def images(self) -> dict[str, Word]:
        """The image of each letter."""
        return {letter: Word._of(word) for letter, word in self._morphism.words()}

    @property
    def domain(self) -> tuple[str, ...]:
        """The letters that have an image."""
        return tuple(letter for letter, _ in self._morphism.images())

    @property
    def alphabet(self) -> tuple[str, ...]:
        """The letters before and behind the arrows."""
        seen = dict.fromkeys(self.domain)
        for word in self.images.values():
            seen.update(dict.fromkeys(word.letters))
        return tuple(seen)

    def __call__(self, word: WordLike, *, timeout: float | None = None, budget: Budget | None = None) -> Word:
        """The image of a word; ``algae.Error`` if one of its letters has none."""
        given = as_word("word", word, self.alphabet)
        with limits(timeout, budget, "morphism") as bounds:
            return Word._of(self._morphism.image(given._word, bounds))

    def compose(self, first: "Morphism", *, timeout: float | None = None, budget: Budget | None = None) -> "Morphism":
        """The morphism that applies ``first`` and then this one, ``self * first``.

        >>> Morphism("a -> ab, b -> a").compose(Morphism("a -> b, b -> a"))
        Morphism({'a': 'a', 'b': 'ab'})
        """
        if not isinstance(first, Morphism):
            raise arguments.wrong_type("first", "a Morphism", first)
        with limits(timeout, budget, "morphism") as bounds:
            return Morphism._of(self._morphism.compose(first._morphism, bounds))

    def power(self, exponent: int, *, timeout: float | None = None, budget: Budget | None = None) -> "Morphism":
        """The morphism applied so many times, ``self ** exponent``.

        >>> Morphism("a -> ab, b -> a").power(4)
        Morphism({'a': 'abaababa', 'b': 'abaab'})
        """
        left = arguments.count("exponent", exponent)
        result = Morphism({letter: Word([letter]) for letter in self.alphabet if left == 0 or letter in self.domain})._morphism
        power = self._morphism
        with limits(timeout, budget, "morphism") as bounds:
            while left > 0:
                if left & 1:
                    result = power.compose(result, bounds)
                left >>= 1
                if left > 0:
                    power = power.compose(power, bounds)
        return Morphism._of(result)

    def __mul__(self, other: object) -> "Morphism":
        if not isinstance(other, Morphism):
            return NotImplemented
        return self.compose(other)

    def __pow__(self, exponent: int) -> "Morphism":
        return self.power(exponent)

    def matrix(self) -> "numpy.ndarray[Any, Any]":
        """Entry (i, j): how often the j-th letter of the alphabet occurs in the image of the i-th.

        >>> Morphism({"a": "ab", "b": "a"}).matrix()
        array([[1, 1],
               [1, 0]])
        """
        alphabet = self.alphabet
        counts = {letter: image.counts() for letter, image in self.images.items()}
        rows = [[counts[letter].get(other, 0) if letter in counts else int(letter == other) for other in alphabet]
                for letter in alphabet]
        return numpy.array(rows, dtype=numpy.int64).reshape(len(alphabet), len(alphabet))

    def is_erasing(self) -> bool:
        """Whether some image is the empty word."""
        return any(len(word) == 0 for word in self.images.values())

    def system(self, axiom: WordLike) -> Any:
        """The D0L system of this morphism and an axiom, an `LSystem`."""
        from .systems import LSystem

        return LSystem(self.images, axiom=as_word("axiom", axiom, self.alphabet))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Morphism):
            return NotImplemented
        return self.images == other.images

    def __hash__(self) -> int:
        return hash(frozenset(self._morphism.images()))

    def __str__(self) -> str:
        return ", ".join(f"{letter} -> {image}" for letter, image in self._morphism.images())

    def __repr__(self) -> str:
        return f"Morphism({dict(self._morphism.images())!r})"

    def __reduce__(self) -> tuple[Any, ...]:
        return (Morphism, ({letter: word.letters for letter, word in self.images.items()},))

    def _repr_latex_(self) -> str:
        rules = r" \\ ".join(rf"{_algae.Word.of_letters([letter], []).latex()} \mapsto {word._word.latex()}" for letter, word in self.images.items())
        return rf"$\begin{{array}}{{l}}{rules}\end{{array}}$"


def _pairs_of_text(text: str) -> list[tuple[str, str]]:
    pairs = []
    for part in text.replace(";", ",").replace("\n", ",").split(","):
        if not part.strip():
            continue
        arrow = next((sign for sign in ("|->", "->", "→") if sign in part), None)
        if arrow is None:
            raise Error(f"images: expected 'letter -> word', found {part.strip()!r}")
        letter, image = part.split(arrow, 1)
        pairs.append((letter.strip(), image.strip() or "ε"))
    if not pairs:
        raise Error("images: expected 'letter -> word', such as 'a -> ab, b -> a', found nothing")
    return pairs
