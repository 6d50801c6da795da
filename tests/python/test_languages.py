"""Languages, claims and censuses, against sets of words in plain Python."""

import itertools
import re

import pytest
from hypothesis import given, settings, strategies as st

import algae
from algae import Claim, Language, LSystem, Word

FINITE = st.frozensets(st.text("ab", max_size=3), max_size=4)
LETTERS = ["a", "b"]
ALL = ["".join(one) for size in range(5) for one in itertools.product("ab", repeat=size)]


def language(words):
    return Language([Word(list(one)) for one in sorted(words)], letters=LETTERS)


def found(of):
    return {"".join(one.letters) for one in of.words(1000, longest=4)}


@settings(max_examples=60, deadline=None)
@given(FINITE, FINITE)
def test_operators_are_those_of_sets(left, right):
    A, B = language(left), language(right)
    assert found(A | B) == left | right
    assert found(A & B) == left & right
    assert found(A - B) == left - right
    assert found(A * B) == {one for one in (a + b for a in left for b in right) if len(one) <= 4}
    assert found(~A) == set(ALL) - left
    assert found(A.reversed()) == {one[::-1] for one in left}
    assert A.equal(B).is_proved == (left == right)
    assert A.subset_of(B).is_proved == (left <= right)
    assert A.has_size(len(left)).is_proved


@pytest.mark.parametrize("text", ["a*b", "(ab|b)*", "a(a|b)*b", "(a|b)*bb(a|b)*", "(aa)*b?"])
def test_regular_expressions_are_those_of_python(text):
    expected = {one for one in ALL if re.fullmatch(text, one)}
    of = Language(f"/{text}/", letters=LETTERS)
    assert found(of) == expected
    assert all((one in of) == (one in expected) for one in ALL[1:])
    assert of.counts(4) == [sum(1 for one in expected if len(one) == size) for size in range(5)]
    assert found(of ** 2) == {one for one in (a + b for a in expected for b in expected) if len(one) <= 4}


def test_systems_of_one_name_stay_apart():
    first, second = LSystem("a -> ab, b -> a"), LSystem("a -> aa")
    both = first.language | second.language
    assert str(both) == "(L(system)) | (L(system_2))"
    assert "abaab" in both and "aaaa" in both and "aaa" not in both


def test_an_iterator_goes_through_all_words():
    assert [str(one) for one in itertools.islice(LSystem("a -> aa").language, 4)] == ["a", "aa", "aaaa", "aaaaaaaa"]
    assert [str(one) for one in Language("{a, ab}")] == ["a", "ab"]


def test_random_words_are_of_the_language_and_the_same():
    of = Language("/(a|bb)*/")
    drawn = of.random(20, 5, seed=7)
    assert drawn == of.random(20, 5, seed=7) and all(one in of and len(one) == 20 for one in drawn)


def test_a_claim_and_its_certificate():
    checked = Claim("claim Not closed\ntheorem for all 0L languages A, B: A | B is 0L\nshow {a} is 0L\nrefute {a, aa} is 0L").check()
    assert checked.verdict == "refuted" and not checked
    assert checked.theorem.witness == {"A": "{a}", "B": "{aa}"}
    assert [one.outcome for one in checked.statements] == ["fails", "holds", "holds"]
    outcomes = [outcome for _, outcome, _ in algae.verify(checked)]
    assert outcomes == ["checked"] * 3
    changed = checked.certificate()
    changed["statements"][1]["verdict"] = "refuted"
    assert algae.verify(changed)[1][1] != "checked"
    assert "proof" in checked.latex() and "Not closed" in checked.explanation and "<details>" in checked._repr_html_()


def test_the_claims_of_the_theory(source):
    paths = sorted((source / "theory" / "closure").glob("*.claim"))[:12]
    assert paths
    for path in paths:
        assert Claim.from_file(path).check(timeout=60).verdict in ("proved", "cited", "examples", "undecided")


def test_a_search_has_the_least_counterexample():
    found = algae.search("for all 0L languages A, B: A | B is 0L", timeout=60)
    assert found.verdict == "refuted" and found.witness == {"A": "{a}", "B": "{aa}"}


def test_families_are_containers():
    assert Language("/a*/") in algae.Family("regular")
    assert Language("{a, aa}") not in algae.Family("0L")
    assert "0L" in [str(one) for one in algae.families()]


def test_a_census_by_growth():
    counted = algae.census("D0L systems up to size 6", "growth")
    assert [sum(row[one] for one in counted.columns) for row in counted.rows()] == counted.instances
    assert "<table>" in counted._repr_html_()


def test_the_alphabet_of_a_complement_is_that_of_the_whole_expression():
    A, B = Language("{a}"), Language("{b}")
    assert (~(A | B)).equal(~A & ~B).is_proved
    assert "b" in ~A | B


def test_languages_compare_by_their_words():
    """== compared objects, and languages were not pickled."""
    import pickle

    assert Language("/a(ba)*/") == Language("/(ab)*a/") != Language("/(ab)*/")
    assert Language("L(fibonacci)") == Language.of_system(LSystem("fibonacci", name="other"))
    assert Language("{a}") != 5 and not Language("{a}") == "a"
    again = pickle.loads(pickle.dumps(Language("L(G)", systems={"G": LSystem("a -> aa")})))
    assert again == Language("L(all)", systems={"all": LSystem("a -> aa")}) and again.words(3) == ["a", "aa", "aaaa"]


def test_a_claim_in_a_file_names_systems_of_other_programs(tmp_path):
    """Systems beside a claim were sought with the ending .lsys alone."""
    (tmp_path / "tree.l").write_text("Lsystem: 1\nderivation length: 1\nAxiom: A\nA --> AB\nendlsystem\n")
    (tmp_path / "tree.claim").write_text("claim T\nlet G = D0L tree.l\nshow ABB in L(G)\n")
    assert bool(Claim.from_file(tmp_path / "tree.claim").check())
