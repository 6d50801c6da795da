"""To and from other programs: Sage, sympy, networkx, pandas, L-Py. None of them is needed until its function is called."""

from __future__ import annotations

import ast
import re
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Optional, Union

from . import arguments
from .errors import Error
from .words import Morphism, Word, WordLike

if TYPE_CHECKING:
    from .figures import Tree
    from .languages import Census
    from .numbers import Algebraic
    from .systems import Growth, LSystem

__all__ = ["from_lpy", "from_sage", "networkx_graph", "pandas_table", "sympy_expression", "sympy_matrix", "to_lpy", "to_sage"]


def _needed(name: str) -> Any:
    import importlib

    try:
        return importlib.import_module(name)
    except ImportError:
        raise ImportError(f"{name} is not installed (Debian: apt-get install python3-{name})") from None


# Sage

def to_sage(morphism: Union[Morphism, "LSystem"]) -> str:
    """What Sage's `WordMorphism` takes.

    >>> from algae import Morphism
    >>> from algae.exchange import to_sage
    >>> to_sage(Morphism({"a": "ab", "b": "a"}))
    'a->ab,b->a'
    """
    given = _morphism_of(morphism)
    parts = []
    for letter, image in given.images.items():
        if any(len(one) != 1 or one in ",->" for one in (letter, *image.letters)):
            raise Error(f"Sage's strings have letters of one character; expected one, found {letter} -> {image}; "
                        "WordMorphism takes a dict: {letter: image.letters}")
        parts.append(f"{letter}->{''.join(image.letters)}")
    return ",".join(parts)


def from_sage(morphism: Any) -> Morphism:
    """The morphism of a `WordMorphism`, or of its string 'a->ab,b->a' or 'WordMorphism: a->ab, b->a'."""
    if isinstance(morphism, str):
        text = arguments.text("morphism", morphism).strip()
        if text.startswith("WordMorphism:"):
            text = text[len("WordMorphism:"):]
        images = {}
        for part in text.split(","):
            if "->" not in part:
                raise Error(f"morphism: expected 'letter->word', found {part.strip()!r}")
            letter, image = part.split("->", 1)
            images[letter.strip()] = Word(list(image.strip()))
        return Morphism(images)
    if hasattr(morphism, "domain") and hasattr(morphism, "image"):
        return Morphism({str(letter): Word([str(one) for one in morphism.image(letter)])
                         for letter in morphism.domain().alphabet()})
    if isinstance(morphism, Mapping):
        return Morphism({str(letter): Word([str(one) for one in image]) for letter, image in morphism.items()})
    raise arguments.wrong_type("morphism", "a WordMorphism of Sage, its string, or a dict", morphism)


def _morphism_of(given: Any) -> Morphism:
    from .systems import LSystem

    if isinstance(given, Morphism):
        return given
    if isinstance(given, LSystem):
        return given.morphism
    raise arguments.wrong_type("morphism", "a Morphism or an LSystem", given)


# sympy

def sympy_matrix(of: Union["Growth", Morphism]) -> Any:
    """The growth matrix as a `sympy.Matrix` of integers."""
    sympy = _needed("sympy")
    matrix = of.matrix() if isinstance(of, Morphism) else of.matrix
    return sympy.Matrix([[int(one) for one in row] for row in matrix])


def sympy_expression(of: Union["Algebraic", "Growth"]) -> Any:
    """A number as a root that sympy computes with, or of a growth the length of generation n as an expression in n.

    The expression of a growth is a sum over the roots of its recurrence, which sympy solves; where the first values stand outside
    the recurrence it holds from there on.
    """
    from .numbers import Algebraic
    from .systems import Growth

    sympy = _needed("sympy")
    if isinstance(of, Algebraic):
        rational = of.rational
        if rational is not None:
            return sympy.Rational(rational.numerator, rational.denominator)
        polynomial = of.minimal_polynomial
        if polynomial is None:
            raise Error("the minimal polynomial of the number was not worked out; n(digits) gives its digits")
        x = sympy.Symbol("x")
        whole = sympy.Poly(list(reversed(polynomial)), x)
        about = sympy.Rational(str(of.n(60)))
        roots = [one for one in sympy.Poly(whole).real_roots() if abs(sympy.N(one - about, 80)) < sympy.Rational(1, 10**50)]
        if len(roots) != 1:
            raise Error("the number is not told from other roots of its polynomial")
        return roots[0]
    if isinstance(of, Growth):
        n, z = sympy.Symbol("n", integer=True, nonnegative=True), sympy.Symbol("z")
        recurrence = of.recurrence
        first = recurrence.exceptions
        values = recurrence.initial[first:]
        solutions: dict[Any, int] = sympy.roots(sympy.Poly(list(reversed(recurrence.polynomial)), z))
        if sum(solutions.values()) != recurrence.order:
            raise Error(f"sympy writes no roots of the recurrence {recurrence.text}")
        unknown: list[Any] = []
        form: Any = sympy.Integer(0)
        for root, times in solutions.items():
            for power in range(times):
                constant = sympy.Symbol(f"c{len(unknown)}")
                unknown.append(constant)
                form += constant * n**power * root**n
        equations = [sympy.Eq(form.subs(n, first + i), value) for i, value in enumerate(values)]
        solved = sympy.solve(equations, unknown, dict=True)
        return sympy.simplify(form.subs(solved[0])) if solved else form
    raise arguments.wrong_type("of", "an Algebraic or a Growth", of)


# networkx and pandas

def networkx_graph(tree: "Tree") -> Any:
    """A `networkx.DiGraph` of a derivation tree or a digraph of growth: nodes are numbers with `label` and `generation`."""
    from .figures import Tree

    if not isinstance(tree, Tree):
        raise arguments.wrong_type("tree", "a Tree", tree)
    networkx = _needed("networkx")
    graph = networkx.DiGraph()
    for number, (label, generation) in enumerate(tree.nodes):
        graph.add_node(number, label=label, generation=generation)
    for above, below, label in tree.edges:
        graph.add_edge(above, below, label=label)
    return graph


def pandas_table(census: "Census") -> Any:
    """The table of a census as a `pandas.DataFrame`."""
    from .languages import Census

    if not isinstance(census, Census):
        raise arguments.wrong_type("census", "a Census", census)
    return _needed("pandas").DataFrame(census.rows()).set_index("size")


# L-Py

def to_lpy(word: Union[Word, "LSystem"]) -> str:
    """A word as the string that L-Py's `AxialTree` takes, or a D0L system as the text of an `Lsystem`.

    >>> import algae
    >>> print(algae.exchange.to_lpy(algae.LSystem("axiom F(1); F(x) -> F(x/2)[+F(x)]")))
    Axiom: F(1)
    derivation length: 1
    production:
    F(x) --> F(x/2)[+F(x)]
    endlsystem
    """
    from .systems import LSystem

    if isinstance(word, Word):
        return "" if len(word) == 0 else str(word).replace(" ", "")
    if not isinstance(word, LSystem):
        raise arguments.wrong_type("word", "a Word or an LSystem", word)
    system = word
    facts = system.to_dict()
    if facts["stochastic"] or facts["tables"] or facts["systems"] or facts["environments"]:
        raise Error("L-Py's strings are made of rules without probabilities, tables, systems within and environments")
    last = system.shown_generations[1] if system.shown_generations else 1
    lines = [f"Axiom: {system.axiom.replace('ε', '')}", f"derivation length: {last}", "production:"]
    for rule in system.rules:
        left, right = rule.split(" -> ", 1)
        condition = ""
        if " : " in left:
            left, test = left.split(" : ", 1)
            condition = test.replace("&", " and ").replace("|", " or ").replace("^", "**")
        right = "*" if right == "ε" else right.replace("^", "**") if "(" in right else right
        if condition:
            lines += [f"{left} :", f"  if {_single_equals(condition)}: produce {right}"]
        else:
            lines.append(f"{left} --> {right}")
    return "\n".join([*lines, "endlsystem"])


def _single_equals(condition: str) -> str:
    return re.sub(r"(?<![<>!=])=(?!=)", "==", condition)


def from_lpy(text: str, *, axiom: Optional[WordLike] = None) -> "LSystem":
    """The system of an `Lsystem` string of L-Py whose rules are plain: `Axiom:`, `F(x) --> F(x/2)`, a `derivation length`, and
    constants such as `a = 45` before them. Rules with Python in them are refused.

    >>> import algae
    >>> algae.exchange.from_lpy('''angle = 60
    ... Axiom: F
    ... derivation length: 3
    ... production:
    ... F --> F+F--F+F
    ... endlsystem''').derive(1)
    Word('F+F--F+F')
    """
    from .systems import LSystem

    given = arguments.text("text", text)
    lines: list[str] = []
    head: list[str] = []
    start: Optional[str] = None if axiom is None else str(axiom)
    generation: Optional[int] = None
    for number, raw in enumerate(given.splitlines(), 1):
        line = raw.split("#", 1)[0].rstrip()
        said = line.strip()
        lowered = said.lower()
        if not said or lowered in ("production:", "endlsystem", "decomposition:") or lowered.startswith("from "):
            continue
        if lowered.startswith("axiom:"):
            if start is None:
                start = said[6:].strip()
        elif lowered.startswith("derivation length:"):
            generation = _whole(said.split(":", 1)[1], number)
        elif lowered in ("homomorphism:", "interpretation:"):
            raise Error(f"line {number}: expected rules, found {said!r}; interpretations are not read")
        elif "-->" in said:
            left, right = said.split("-->", 1)
            right = right.strip()
            lines.append(f"{left.strip()} -> {'ε' if right in ('', '*') else right.replace('**', '^')}")
        elif re.fullmatch(r"[A-Za-z_]\w*\s*=[^=].*", said) and not lines:
            name, value = (one.strip() for one in said.split("=", 1))
            try:
                ast.literal_eval(value)
            except (ValueError, SyntaxError):
                raise Error(f"line {number}: expected a number behind {name} =, found {value!r}") from None
            head.append(f"angle {value}" if name == "angle" else f"let {name} = {value}")
        else:
            raise Error(f"line {number}: expected an axiom, a length, a constant or 'A --> w', found {said!r}; "
                        "rules with Python in them are not read")
    if start is None:
        raise Error("expected a line 'Axiom: w', found none")
    lets = [one for one in head if one.startswith("let ")]
    others = [one for one in head if not one.startswith("let ")]
    if generation is not None:
        others.append(f"generation {generation}")
    return LSystem.from_text("\n".join([*lets, f"axiom {start}", *lines, *others]) + "\n", name="lpy")


def _whole(text: str, line: int) -> int:
    try:
        return int(text.strip())
    except ValueError:
        raise Error(f"line {line}: expected a number of generations, found {text.strip()!r}") from None


