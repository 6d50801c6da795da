"""Systems: words, letters far inside, lengths and growth, against plain rewriting and formulas that share no code."""

import math
import pickle
from fractions import Fraction

import numpy
import pytest
from hypothesis import given, settings, strategies as st

import algae
from algae import LSystem

RULES = st.fixed_dictionaries({"a": st.text("abc", max_size=3), "b": st.text("abc", max_size=3), "c": st.text("abc", max_size=2)})


def rewritten(rules, axiom, n):
    for _ in range(n):
        axiom = "".join(rules[one] for one in axiom)
    return axiom


@settings(max_examples=300, deadline=None)
@given(RULES, st.text("abc", min_size=1, max_size=3), st.integers(0, 5), st.integers(0, 20), st.integers(0, 20))
def test_words_letters_and_lengths_are_those_of_rewriting(rules, axiom, n, start, count):
    system = LSystem(rules, axiom=axiom)
    expected = rewritten(rules, axiom, n)
    assert "".join(system.derive(n).letters) == expected
    assert system.length(n) == len(expected)
    assert {name: value for name, value in system.counts(n).items() if value} == {
        one: expected.count(one) for one in set(expected)}
    assert "".join(system.word(n)[start:start + count].letters) == expected[start:start + count]


def fibonacci_letter(k):
    """By the formula of the characteristic word of slope 1 / golden ratio, in whole numbers."""
    def below(m):
        return (math.isqrt(5 * m * m) - m) // 2

    return "a" if below(k + 2) - below(k + 1) == 1 else "b"


@pytest.mark.parametrize("at", [0, 1, 10**20, 10**100, 10**200 + 7])
def test_letters_at_huge_positions(at):
    system = LSystem("a -> ab, b -> a")
    expected = "".join(fibonacci_letter(at + i) for i in range(20))
    assert str(system.word(1000)[at:at + 20]) == expected
    assert system.letter(1000, at) == expected[0]


def test_numbers_beyond_the_digits_that_python_reads_are_exact():
    length = LSystem("a -> ab, b -> a").length(100_000)
    a, b = 0, 1
    bits = bin(100_002)[2:]
    for bit in bits:  # fast doubling
        a, b = a * (2 * b - a), a * a + b * b
        if bit == "1":
            a, b = b, a + b
    assert length == a
    assert LSystem("a -> aa").length(64) == 2**64 and LSystem("a -> aa").length(62) == 2**62
    with pytest.raises(IndexError):
        LSystem("a -> aa").word(100)[2**100]
    assert LSystem("a -> aa").word(100)[-1] == "a"


def test_a_slice_of_a_word_like_that_of_a_str():
    word = LSystem("a -> ab, b -> a").word(6)
    text = str(word)
    for at in (slice(None), slice(2, 5), slice(-3, None), slice(0, 100), slice(5, 2), slice(1, 12, 3), slice(30, 40)):
        assert "".join(word[at].letters) == text[at]
    assert len(word) == len(text) and list(word) == list(text)


def test_the_sources_of_a_system(tmp_path, source):
    by_text = LSystem("F -> F+F--F+F, angle 60")
    by_dict = LSystem({"F": "F+F--F+F"}, settings={"angle": 60})
    assert by_text == by_dict
    path = tmp_path / "my.lsys"
    path.write_text(by_text.text)
    assert LSystem(path) == by_text == LSystem(str(path)) == LSystem.from_file(path) == LSystem.from_text(by_text.text)
    assert LSystem("koch").title == "Koch curve"
    assert pickle.loads(pickle.dumps(by_text)) == by_text


def test_a_name_goes_with_every_source(tmp_path):
    """Systems typed on a line and those of the gallery were read as texts of files."""
    path = tmp_path / "my.lsys"
    path.write_text("axiom a\na -> ab\nb -> a\n")
    for source in ("a -> ab, b -> a", "fibonacci", path, str(path), "axiom a\na -> ab\nb -> a\n", {"a": "ab", "b": "a"}):
        system = LSystem(source, name="x")
        assert system.name == "x" and len(system.derive(5)) in (8, 13)
    with pytest.raises(algae.NotationError, match="^x:1:6: "):
        LSystem("a -> ]b", name="x")
    with pytest.raises(algae.Error, match="no file 'kock'.*did you mean 'koch'"):
        LSystem("kock", name="x")
    with pytest.raises(TypeError, match="name: expected a str, found 5"):
        LSystem("koch", name=5)


def test_an_axiom_goes_with_every_source(tmp_path):
    path = tmp_path / "my.lsys"
    path.write_text("axiom a\na -> ab\nb -> a\n")
    for source in ("a -> ab, b -> a", path, str(path), "axiom a\na -> ab\nb -> a\n", {"a": "ab", "b": "a"}):
        assert LSystem(source, axiom="ba").derive(1) == "aab"
    koch = LSystem("koch", axiom="F-F", name="y")
    assert koch.axiom == "F-F" and koch.name == "y" and koch.angle == 60
    with pytest.raises(ValueError, match="axiom: expected a word"):
        LSystem("koch", axiom="F\nF -> FF")


def test_a_dict_with_long_names_choices_and_probabilities():
    plain = LSystem({"Leaf": algae.Word(["Leaf", "Bud"]), "Bud": algae.Word(["Leaf"])}, axiom=algae.Word(["Bud"]))
    assert plain.derive(3).letters == ["Leaf", "Bud", "Leaf"]
    assert [str(one) for one in LSystem({"a": ["a", "ab"], "b": "b"}).words(1)] == ["a", "ab"]
    chances = LSystem({"F": {"FF": Fraction(1, 2), "F": Fraction(1, 2)}})
    assert chances.expected(2) == {"F": Fraction(9, 4)}
    assert sum(chances.distribution(3).values()) == 1


def test_constants_are_replaced():
    system = LSystem("let c = 2; axiom A(1); A(x) -> A(x*c)")
    assert system.constants == {"c": "2"}
    assert system.with_constants(c=Fraction(1, 3)).derive(2).modules == [("A", (Fraction(1, 9),))]
    assert LSystem("let c = 2; axiom A(1); A(x) -> A(x*c)", let={"c": "2^10"}).derive(1).modules == [("A", (1024,))]
    with pytest.raises(algae.Error):
        system.with_constants(d=1)


def test_growth_of_fibonacci():
    growth = LSystem("a -> ab, b -> a").growth()
    assert growth.matrix.tolist() == [[1, 1], [1, 0]]
    assert growth.characteristic_polynomial == [-1, -1, 1]
    assert growth.recurrence.polynomial == [-1, -1, 1] and growth.recurrence.initial == [1, 2]
    assert growth.generating_function == ([1, 1], [1, -1, -1])
    assert growth.values(300)[-1] == LSystem("a -> ab, b -> a").length(299)
    assert growth.is_primitive and growth.kind == "exponential" and growth.degree == 0
    shares = growth.frequencies
    assert shares["a"].minimal_polynomial == [-1, 1, 1]
    assert abs(float(shares["a"]) + float(shares["b"]) - 1) < 1e-15
    assert growth.rate > 1 and growth.rate < 2 and growth.rate != 1 and growth.rate == growth.rate
    assert str(growth.rate.n(5)) == "1.61803"


@pytest.mark.parametrize("rules,letter,polynomial", [
    ("a -> aab, b -> ab", "a", [-1, 1, 1]),
    ("a -> ab, b -> c, c -> a", "a", None),
    ("a -> abb, b -> ab", "a", None),
])
def test_minimal_polynomials_of_shares_have_the_share_as_root(rules, letter, polynomial):
    share = LSystem(rules).growth().frequencies[letter]
    found = share.minimal_polynomial
    assert polynomial is None or found == polynomial
    value = Fraction(share.n(60))
    assert abs(sum(one * value**i for i, one in enumerate(found))) < Fraction(1, 10**50)
    assert math.gcd(*found) == 1 and found[-1] > 0


def test_fractions_are_fractions():
    growth = LSystem("a -> aab, b -> bba").growth()
    assert growth.rate.rational == 3 and growth.frequencies["a"].rational == Fraction(1, 2)
    assert growth.frequencies["a"] == Fraction(1, 2) and growth.rate == 3
    assert LSystem("koch").angle == 60


def test_count_tables():
    letters, table = LSystem("a -> ab, b -> a").count_table(80)
    assert letters == ["a", "b"] and table.dtype == numpy.int64 and table.shape == (81, 2)
    _, large = LSystem("a -> ab, b -> a").count_table(100, 99)
    assert large.dtype == object and large[0].sum() == LSystem("a -> ab, b -> a").length(99)


def test_equality_membership_finiteness():
    a, b = LSystem("a -> ab, b -> a"), LSystem("a -> ab, b -> a", axiom="b")
    assert not a.equal(b) and not a.equal(b, "sequence") and a.equal(a) and a.equal(a, "growth")
    assert a.member("abaab").derivation[-1] == "abaab" and not a.member("bb")
    assert "no" in repr(a.finite()) or not a.finite()
    assert LSystem("a -> b, b -> a").finite().count == 2
    with_context = LSystem("axiom ab; a > b -> aa")
    assert with_context.member("aab").is_proved and with_context.derive(2) == "aaab"


def test_realise():
    assert algae.realise("a(n) = a(n-1) + a(n-2); 2, 3").lengths(4) == [2, 3, 5, 8, 13]
    with pytest.raises(algae.Error):
        algae.realise([1, 0, 5])


def test_dimension_of_a_random_set():
    found = LSystem("axiom F\nF -(1/2)-> F+F--F+F\nF -(1/2)-> FFF\nangle 60\n").dimension()
    assert found.is_exact and found.almost_surely
    assert found.formula == "log (7/2) / log 3"
    assert found._repr_latex_().startswith(r"$\dim \overset{\text{a.s.}}{=} ")
    assert not LSystem("koch").dimension().almost_surely


def test_dimension():
    found = LSystem("dragon").dimension()
    assert found.is_exact and found.rational == 2 and float(found) == 2.0
    low, high = LSystem("koch").dimension_bounds(Fraction(1, 10))
    assert low <= Fraction(126185950714291487, 10**17) <= high and high - low <= Fraction(1, 10)
    measured = LSystem("koch").measure(6)
    assert measured.low <= 1.2618595 <= measured.high


CPFG = "Lsystem: 1\nderivation length: 2\nAxiom: A\n{rules}endlsystem\n"


def test_a_file_of_cpfg_has_the_files_that_it_includes(tmp_path, command):
    """`open_file` read the one file alone, and refused the line `#include`."""
    inside = tmp_path / "inside"
    (inside / "deep").mkdir(parents=True)
    (tmp_path / "outside.l").write_text("A --> AC\n")
    (inside / "link.l").symlink_to(tmp_path / "outside.l")
    (inside / "rules.l").write_text('A --> AB\n#include "deep/more.l"\n')
    (inside / "deep" / "more.l").write_text("B --> BB\n")
    good = inside / "good.l"
    good.write_text(CPFG.format(rules='#include "rules.l"\n'))
    theirs = command("derive", str(good), "-n", "2", "--json")["words"][0]
    for system in (LSystem(good), LSystem(str(good)), LSystem.from_file(good)):
        assert str(system.derive(2)) == theirs == "ABBB"
    for outside in ("link.l", "../outside.l", "none.l"):
        (inside / "bad.l").write_text(CPFG.format(rules=f'#include "{outside}"\n'))
        with pytest.raises(algae.NotationError, match="expected a file of this name in the folder") as caught:
            LSystem.from_file(inside / "bad.l")
        assert caught.value.line == 4
    (inside / "rules.l").write_text("A --> A)\n")
    with pytest.raises(algae.NotationError) as caught:
        LSystem.from_file(good)
    assert caught.value.file == str(inside / "rules.l") and caught.value.line == 1


def test_a_file_of_cpfg_is_shown_as_the_view_beside_it_says(tmp_path, command):
    (tmp_path / "tree.l").write_text("Lsystem: 1\nderivation length: 3\nAxiom: F\nF --> F[+F]F\nendlsystem\n")
    for angle in (20, 35):
        (tmp_path / "tree.v").write_text(f"angle increment: {angle}\n")
        (tmp_path / "tree.a").write_text("first frame: 0\nlast frame: 2\nstep: 1\n")
        system = LSystem(tmp_path / "tree.l")
        assert system.angle == angle and system.to_dict() == command("show", str(tmp_path / "tree.l"), "--json")
        assert LSystem(tmp_path / "tree.a").shown_generations == (0, 2)
    (tmp_path / "alone.v").write_text("angle increment: 20\n")
    with pytest.raises(algae.Error, match=r"expected it beside this file: alone\.l"):
        LSystem(tmp_path / "alone.v")


def test_an_upper_bound_above_two_is_two():
    """`n` gave the similarity dimension, where the command says 2."""
    found = LSystem({"F": "F+F--F+F"}, settings={"angle": 96}).dimension()
    assert found.status == "upper bound" and found.to_dict()["exact"]["similarity"]["value"] > 2
    assert found.n(10) == 2 == float(found) == found.to_dict()["exact"]["value"]


def test_contexts_between_brackets_are_refused_where_languages_are_asked_for():
    """`finite` and `member` ended the interpreter."""
    tree = LSystem("bracketed-context")
    for call in (tree.finite, lambda: tree.member("ABC"), lambda: tree.is_("finite")):
        with pytest.raises(algae.Error, match="bracketed.context.*with context whose words have brackets"):
            call()


def test_floats_are_probabilities_as_they_are_meant():
    """1/3 and 2/3 as floats did not add up to 1."""
    for first, second in ((1 / 3, 2 / 3), (0.1, 0.9), (Fraction(1, 7), 6 / 7)):
        found = LSystem({"F": {"FF": first, "F": second}}).distribution(1)
        assert sum(found.values()) == 1 and found["FF"] == Fraction(first).limit_denominator(10)
    with pytest.raises(algae.NotationError, match="add up to 9/10"):
        LSystem({"F": {"FF": 0.5, "F": 0.4}})
