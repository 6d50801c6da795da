"""Random calls with random arguments: each gives an answer or one of the package's exceptions, and none ends the interpreter.

ALGAE_RANDOM_CALLS says how many, ALGAE_RANDOM_SEED where they begin: `tools/python asan 100000` shares so many among processes, each with a seed of its own,
under the address sanitizer. Where ALGAE_RANDOM_TALLY names a file, what was called and what came of it is written to it.
"""

import contextlib
import inspect
import io
import json
import math
import os
import tempfile
from collections import Counter
from fractions import Fraction

from hypothesis import HealthCheck, given, seed, settings, strategies as st

import algae
from algae import Budget, Claim, Language, LSystem, Morphism, Word, exchange

CALLS = int(os.environ.get("ALGAE_RANDOM_CALLS", "2000"))
SEED = int(os.environ.get("ALGAE_RANDOM_SEED", "1"))
BUDGET = Budget(timeout=1, letters=20_000, memory=50_000_000, progress=False)
OUTCOMES = Counter()

STRANGE = st.one_of(st.none(), st.booleans(), st.integers(), st.integers(-3, 12), st.floats(), st.fractions(), st.text(max_size=8),
                    st.binary(max_size=4), st.lists(st.integers(0, 5), max_size=3), st.just(10**40), st.just("koch"),
                    st.sampled_from(["a", "ab", "ε", "F[+F]", "A(1,x)", "0L", "svg", "regular", "a -> ab, b -> a", "{a}", "/a*/"]))
SMALL = st.integers(0, 6)
WORD = st.one_of(st.text("abF+-", max_size=5), st.sampled_from(["F[+F]b", "a[b]", "]"]))
RULES = st.dictionaries(st.sampled_from("abF"), st.one_of(WORD, st.lists(WORD, min_size=1, max_size=2)), min_size=1, max_size=3)
GOOD_SOURCES = st.one_of(RULES, st.sampled_from(["koch", "fibonacci", "bush-3d", "anabaena", "all-powers", "thue-morse", "plant-f", "building"]),
                         st.sampled_from(algae.gallery()))
SOURCES = st.one_of(st.text("abF->,;:()x<1+[] \n", max_size=30), STRANGE)
GOOD_EXPRESSIONS = st.sampled_from(["{a, aa}", "/a(ab)*/", "L(fibonacci)", "{a^n b^n : n >= 0}", "~{a}", "{}", "/(a|b)*/"])
EXPRESSIONS = st.one_of(st.text("ab{}/|&*~(),. ", max_size=15), STRANGE)
N = (SMALL,)
SYSTEM_CALLS = {"derive": N, "length": N, "lengths": N, "counts": N, "count_table": N, "growth": (), "factor_complexity": N,
                "member": (WORD,), "finite": (), "letter": (SMALL, SMALL), "word": N, "words": N, "dimension": (), "draw": N, "facts": N,
                "points": N, "strokes": N, "segments": N, "tree": N, "expected": N, "distribution": N, "boxes": N, "unmet": (),
                "length_bounds": N, "converted": (st.sampled_from(["cpfg", "fractint", "jflap", "maple", "walnut"]),),
                "equal": (st.sampled_from([LSystem("fibonacci"), LSystem("a -> aa"), LSystem("koch")]),
                          st.sampled_from(["language", "sequence", "growth"])),
                "mesh": (st.integers(0, 3),), "measure": (st.integers(0, 5), st.sampled_from(["boxes", "divider", "mass", "correlation"])),
                "dimension_bounds": (st.sampled_from([1, Fraction(1, 10)]),), "growth_graph": (), "factors": (), "factor_report": N,
                "to_dict": (), "with_constants": ()}
GROWTH_CALLS = {"values": (st.integers(0, 60),), "to_dict": (), "latex": (st.sampled_from(["all", "matrix", "form", "rate"]),)}
WORD_CALLS = {"count": (WORD,), "find": (WORD, SMALL), "counts": (), "array": (st.sampled_from(["uint8", "uint32"]),), "analysis": (),
              "reversed": (), "is_palindrome": (), "__add__": (WORD,), "__mul__": N, "__getitem__": (st.one_of(st.integers(-9, 9), st.slices(6)),)}
MORPHISM_CALLS = {"__call__": (st.text("ab", max_size=6),), "compose": (st.just(Morphism("a -> ba, b -> b")),), "power": (st.integers(0, 12),),
                  "matrix": (), "is_erasing": (), "system": (st.sampled_from(["a", "ab"]),)}
LANGUAGE_CALLS = {"is_": (st.sampled_from(["0L", "D0L", "regular", "finite", "T0L"]),), "member": (WORD,), "has_size": N, "words": N,
                  "counts": N, "random": (SMALL, SMALL), "star": (), "reversed": (), "plus": (),
                  "image": (st.just({"a": "ab", "b": "a"}),), "preimage": (st.just({"a": "ab", "b": "a"}),)}
EXPECTED = (algae.Error, algae.Stopped, TypeError, ValueError, IndexError, OverflowError, MemoryError)


class Shell:
    """The part of IPython's shell that the magics ask."""

    def __init__(self):
        self.user_ns, self.magics = {}, {}

    def register_magic_function(self, function, kind, name):
        self.magics[name] = function


SHELL = Shell()
algae.load_ipython_extension(SHELL)
MAGIC_LINES = st.one_of(st.text("xy-=' \"1", max_size=10), st.sampled_from(["x --let c=2", "x --timeout 1", "x", "--let", "x --timeout -"]))
CELLS = {"lsys": st.one_of(st.text("axiomFf->+[]()c= \n", max_size=40), st.sampled_from(["axiom F\nF -> F+F\n", "let c = 1; axiom A(c)"])),
         "claim": st.one_of(st.text("show{}ab|is0L \n", max_size=30), st.sampled_from(["show {a, aa} is not 0L\n", "show {a} = {a}\n"]))}
EXCHANGE = {"to_sage": lambda data, system: exchange.from_sage(exchange.to_sage(system)),
            "to_lpy": lambda data, system: exchange.from_lpy(exchange.to_lpy(system)),
            "from_lpy": lambda data, system: exchange.from_lpy(data.draw(
                st.one_of(st.text("Axiom: F->+\n(x)=1", max_size=40), STRANGE, st.just("Axiom: F\nproduction:\nF --> F+F\nendlsystem\n")))),
            "from_sage": lambda data, system: exchange.from_sage(data.draw(st.one_of(st.text("ab->, ", max_size=20), STRANGE)))}


def called(name, outcome):
    OUTCOMES[outcome] += 1
    OUTCOMES[f"{name} {outcome}"] += 1


def answer_to(thing, calls, data):
    """What a method of the table says, for arguments of which one in four is strange."""
    name = data.draw(st.sampled_from(sorted(calls)))
    OUTCOMES[f"{type(thing).__name__}.{name} called"] += 1
    arguments = [data.draw(STRANGE if data.draw(st.integers(0, 3)) == 0 else one) for one in calls[name]]
    method = getattr(thing, name)
    takes_budget = "budget" in inspect.signature(method).parameters
    found = method(*arguments, budget=BUDGET) if takes_budget else method(*arguments)
    repr(found)
    called(f"{type(thing).__name__}.{name}", "answered")
    return found


def one_call(data):
    kind = data.draw(st.sampled_from(["system", "system", "system", "language", "word", "morphism", "growth", "claim", "census", "verify", "exchange",
                                      "magic", "mesh"]))
    OUTCOMES[f"{kind} called"] += 1
    if kind == "system":
        system = LSystem(data.draw(GOOD_SOURCES if data.draw(st.integers(0, 3)) else SOURCES))
        found = answer_to(system, SYSTEM_CALLS, data)
        if isinstance(found, algae.Generation):
            with BUDGET:  # the last letter of a word of 2^(10^8) letters takes its time
                found[data.draw(st.integers(-5, 10**30))]
        assert LSystem.from_text(system.text) == system
    elif kind == "language":
        language = Language(data.draw(GOOD_EXPRESSIONS if data.draw(st.integers(0, 3)) else EXPRESSIONS))
        answer_to(language, LANGUAGE_CALLS, data)
    elif kind == "word":
        word = Word(data.draw(st.one_of(WORD, STRANGE)))
        word[data.draw(st.one_of(st.integers(-9, 9), st.slices(6), STRANGE))]
        answer_to(word, WORD_CALLS, data)
    elif kind == "morphism":
        rules = st.fixed_dictionaries({"a": st.text("ab", max_size=3), "b": st.text("ab", max_size=3)})
        answer_to(Morphism(data.draw(rules if data.draw(st.integers(0, 3)) else STRANGE)), MORPHISM_CALLS, data)
    elif kind == "growth":
        answer_to(LSystem(data.draw(GOOD_SOURCES)).growth(budget=BUDGET), GROWTH_CALLS, data)
    elif kind == "claim":
        language = data.draw(GOOD_EXPRESSIONS if data.draw(st.integers(0, 3)) else EXPRESSIONS)
        Claim(f"claim T\nshow {language} is 0L").check(budget=BUDGET)
    elif kind == "census":
        good = data.draw(st.integers(0, 3))
        algae.census(data.draw(st.sampled_from(["D0L systems up to size 4", "0L languages up to size 3"]) if good else STRANGE),
                     data.draw(st.sampled_from(["finite", ["growth"], ()]) if good else STRANGE) or (), budget=BUDGET)
    elif kind == "verify":
        certificate = CERTIFICATE.copy()
        if data.draw(st.booleans()):
            certificate[data.draw(st.sampled_from(sorted(certificate)))] = data.draw(st.one_of(st.integers(), st.text(max_size=5), st.none()))
        algae.verify(data.draw(st.one_of(st.just(certificate), st.just(json.dumps(certificate)[:data.draw(st.integers(0, 400))]), STRANGE)),
                     budget=BUDGET)
    elif kind == "exchange":
        name = data.draw(st.sampled_from(sorted(EXCHANGE)))
        EXCHANGE[name](data, LSystem(data.draw(GOOD_SOURCES)))
    elif kind == "mesh":
        mesh = LSystem("bush-3d").mesh(data.draw(st.integers(0, 3)), budget=BUDGET)
        assert mesh.triangles.size == 0 or mesh.triangles.max() < len(mesh.points)
        with tempfile.TemporaryDirectory() as folder:
            mesh.save(os.path.join(folder, "mesh." + data.draw(st.sampled_from(["obj", "stl", "glb", "ply", "x", ""]))), budget=BUDGET)
    else:
        name = data.draw(st.sampled_from(["lsys", "claim"]))
        with BUDGET, contextlib.redirect_stderr(io.StringIO()):
            repr(SHELL.magics[name](data.draw(MAGIC_LINES), data.draw(CELLS[name])))
    called(kind, "answered")


CERTIFICATE = Claim("claim T; show {a, aa} is not 0L").check().certificate()


def make(number, examples):
    """A run of so many calls with a seed of its own."""
    @seed(SEED * 1000 + number)
    @settings(max_examples=examples, deadline=None, suppress_health_check=list(HealthCheck), database=None)
    @given(st.data())
    def calls(data):
        if OUTCOMES["calls"] == CALLS:
            return
        try:
            one_call(data)
        except EXPECTED as error:
            assert (str(error) or isinstance(error, (IndexError, MemoryError))) and not isinstance(error, UnicodeError)
            OUTCOMES[type(error).__name__] += 1
        OUTCOMES["calls"] += 1

    return calls


def test_random_calls():
    """Hypothesis may end a run early, so there are runs until all calls were made."""
    for number in range(100):
        if OUTCOMES["calls"] < CALLS:
            make(number, max(CALLS - OUTCOMES["calls"], 100))()
    if "ALGAE_RANDOM_TALLY" in os.environ:
        with open(os.environ["ALGAE_RANDOM_TALLY"], "w", encoding="utf-8") as out:
            json.dump(OUTCOMES, out, indent=1, sort_keys=True)
    assert OUTCOMES["calls"] == CALLS
    assert OUTCOMES["NotationError"] > 0 and OUTCOMES["TypeError"] > 0
    assert OUTCOMES["answered"] > OUTCOMES["calls"] / 10
    if CALLS >= 2000:
        rare = CALLS < 20_000  # each method has an answer among so many calls, each kind among fewer
        never = [name[:-7] for name in OUTCOMES if name.endswith(" called") and not OUTCOMES[name[:-7] + " answered"]
                 and not (rare and "." in name)]
        assert not never
        tables = {"LSystem": SYSTEM_CALLS, "Language": LANGUAGE_CALLS, "Word": WORD_CALLS, "Morphism": MORPHISM_CALLS, "Growth": GROWTH_CALLS}
        assert rare or all(OUTCOMES[f"{kind}.{name} called"] for kind, names in tables.items() for name in names)


@settings(max_examples=500, deadline=None)
@given(st.integers(-10**30, 10**30), st.integers(1, 10**30))
def test_numbers_go_both_ways(numerator, denominator):
    for value in (numerator, numerator**9, Fraction(numerator, denominator)):
        system = LSystem.from_text("let c = 1; axiom A(c)", let={"c": value})
        found = system.derive(0).modules[0][1][0]
        assert math.isclose(found, value) if isinstance(found, float) else found == value
