"""Random calls with random arguments: each gives an answer or one of the package's exceptions, and none ends the interpreter.

ALGAE_RANDOM_CALLS says how many; tools/python takes 2,000, and `ALGAE_RANDOM_CALLS=100000 tools/python -k random` more.
"""

import inspect
import math
import os
from collections import Counter
from fractions import Fraction

from hypothesis import HealthCheck, given, settings, strategies as st

import algae
from algae import Budget, Claim, Language, LSystem, Morphism, Word

CALLS = int(os.environ.get("ALGAE_RANDOM_CALLS", "2000"))
BUDGET = Budget(timeout=1, letters=20_000, memory=50_000_000, progress=False)
OUTCOMES = Counter()

STRANGE = st.one_of(st.none(), st.booleans(), st.integers(), st.integers(-3, 12), st.floats(), st.fractions(), st.text(max_size=8),
                    st.binary(max_size=4), st.lists(st.integers(0, 5), max_size=3), st.just(10**40), st.just("koch"),
                    st.sampled_from(["a", "ab", "ε", "F[+F]", "A(1,x)", "0L", "svg", "regular", "a -> ab, b -> a", "{a}", "/a*/"]))
SMALL = st.integers(0, 6)
WORD = st.one_of(st.text("abF+-", max_size=5), st.sampled_from(["F[+F]b", "a[b]", "]"]))
RULES = st.dictionaries(st.sampled_from("abF"), st.one_of(WORD, st.lists(WORD, min_size=1, max_size=2)), min_size=1, max_size=3)
GOOD_SOURCES = st.one_of(RULES, st.sampled_from(["koch", "fibonacci", "bush-3d", "anabaena", "all-powers", "thue-morse", "plant-f"]))
SOURCES = st.one_of(st.text("abF->,;:()x<1+[] \n", max_size=30), STRANGE)
GOOD_EXPRESSIONS = st.sampled_from(["{a, aa}", "/a(ab)*/", "L(fibonacci)", "{a^n b^n : n >= 0}", "~{a}", "{}", "/(a|b)*/"])
EXPRESSIONS = st.one_of(st.text("ab{}/|&*~(),. ", max_size=15), STRANGE)
N = (SMALL,)
SYSTEM_CALLS = {"derive": N, "length": N, "lengths": N, "counts": N, "count_table": N, "growth": (), "factor_complexity": N,
                "member": (WORD,), "finite": (), "letter": (SMALL, SMALL), "word": N, "words": N, "dimension": (), "draw": N, "facts": N,
                "points": N, "strokes": N, "segments": N, "tree": N, "expected": N, "distribution": N, "boxes": N, "unmet": (),
                "length_bounds": N, "converted": (st.sampled_from(["cpfg", "fractint", "jflap", "maple", "walnut"]),)}
LANGUAGE_CALLS = {"is_": (st.sampled_from(["0L", "D0L", "regular", "finite", "T0L"]),), "member": (WORD,), "has_size": N, "words": N,
                  "counts": N, "random": (SMALL, SMALL), "star": (), "reversed": (), "plus": (),
                  "image": (st.just({"a": "ab", "b": "a"}),), "preimage": (st.just({"a": "ab", "b": "a"}),)}
EXPECTED = (algae.Error, algae.Stopped, TypeError, ValueError, IndexError, OverflowError, MemoryError)


def answer_to(thing, calls, data):
    """What a method of the table says, for arguments of which one in four is strange."""
    name = data.draw(st.sampled_from(sorted(calls)))
    arguments = [data.draw(STRANGE if data.draw(st.integers(0, 3)) == 0 else one) for one in calls[name]]
    method = getattr(thing, name)
    takes_budget = "budget" in inspect.signature(method).parameters
    found = method(*arguments, budget=BUDGET) if takes_budget else method(*arguments)
    repr(found)
    OUTCOMES["answered"] += 1
    return found


@settings(max_examples=CALLS, deadline=None, suppress_health_check=list(HealthCheck), database=None, derandomize=True)
@given(st.data())
def random_call(data):
    OUTCOMES["calls"] += 1
    kind = data.draw(st.sampled_from(["system", "system", "language", "word", "claim", "census"]))
    try:
        if kind == "system":
            system = LSystem(data.draw(GOOD_SOURCES if data.draw(st.integers(0, 3)) else SOURCES))
            found = answer_to(system, SYSTEM_CALLS, data)
            if isinstance(found, algae.Generation):
                found[data.draw(st.integers(-5, 10**30))]
            assert LSystem.from_text(system.text) == system
        elif kind == "language":
            language = Language(data.draw(GOOD_EXPRESSIONS if data.draw(st.integers(0, 3)) else EXPRESSIONS))
            answer_to(language, LANGUAGE_CALLS, data)
        elif kind == "word":
            word = Word(data.draw(st.one_of(WORD, STRANGE)))
            word[data.draw(st.one_of(st.integers(-9, 9), st.slices(6), STRANGE))]
            word.array().sum(), word + word, word.counts(), hash(word), Morphism({"a": word})("aa")
        elif kind == "claim":
            Claim("claim T\nshow " + str(data.draw(EXPRESSIONS)) + " is 0L").check(budget=BUDGET)
        else:
            algae.census(data.draw(st.one_of(STRANGE, st.just("D0L systems up to size 4"))), data.draw(STRANGE) or ())
    except EXPECTED as error:
        assert str(error) or isinstance(error, (IndexError, MemoryError))
        OUTCOMES[type(error).__name__] += 1


def test_random_calls():
    random_call()
    assert OUTCOMES["calls"] >= min(CALLS, 1000)
    assert OUTCOMES["NotationError"] > 0 and OUTCOMES["TypeError"] > 0
    assert OUTCOMES["answered"] > OUTCOMES["calls"] / 10


@settings(max_examples=500, deadline=None)
@given(st.integers(-10**30, 10**30), st.integers(1, 10**30))
def test_numbers_go_both_ways(numerator, denominator):
    for value in (numerator, numerator**9, Fraction(numerator, denominator)):
        system = LSystem.from_text("let c = 1; axiom A(c)", let={"c": value})
        found = system.derive(0).modules[0][1][0]
        assert math.isclose(found, value) if isinstance(found, float) else found == value
