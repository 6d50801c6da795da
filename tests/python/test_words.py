"""Words and morphisms, against tuples of letters in plain Python."""

import pickle

import numpy
import pytest
from hypothesis import given, settings, strategies as st

import algae
from algae import Morphism, Word

WORDS = st.lists(st.sampled_from(["a", "b", "F_l", "Long1"]), max_size=30)
PLACES = st.one_of(st.none(), st.integers(-40, 40))


@settings(max_examples=500, deadline=None)
@given(WORDS, PLACES, PLACES, st.one_of(st.none(), st.integers(-5, 5).filter(bool)))
def test_slices_are_those_of_lists(letters, start, stop, step):
    assert Word(letters)[start:stop:step].letters == letters[start:stop:step]


@settings(max_examples=300, deadline=None)
@given(WORDS, WORDS, st.integers(0, 5))
def test_operators_are_those_of_lists(left, right, times):
    assert (Word(left) + Word(right)).letters == left + right
    assert (Word(left) * times).letters == left * times
    assert (Word(left) == Word(right)) == (left == right)
    assert Word(left).reversed().letters == left[::-1]
    assert Word(left).counts() == {one: left.count(one) for one in dict.fromkeys(left)}
    places = [i for i in range(len(left) - len(right) + 1) if left[i:i + len(right)] == right]
    assert Word(left).find(Word(right)) == (places[0] if places else -1)
    assert Word(left).count(Word(right)) == len(places)


@settings(max_examples=300, deadline=None)
@given(st.text("ab", max_size=30), st.text("ab", min_size=1, max_size=4), st.integers(0, 35))
def test_places_of_words_that_overlap_themselves(text, part, start):
    places = [i for i in range(len(text) - len(part) + 1) if text[i:i + len(part)] == part]
    word = Word(list(text))
    assert word.count(part) == len(places)
    assert word.find(part, start) == next((one for one in places if one >= start), -1)
    assert word[3:].count(part) == len([one for one in places if one >= 3])


def test_counting_does_not_copy_the_word_for_each_place():
    word = algae.LSystem("a -> ab, b -> a").derive(30)
    assert word.count("a", timeout=20) == word.counts()["a"] == 1346269  # it took a day
    assert word.count("aba" * 100, timeout=20) == 0 and (Word("a") * 10**6).count(Word("a") * 10**5, timeout=20) == 9 * 10**5 + 1


def test_a_letter_that_the_word_does_not_have_is_nowhere():
    assert Word("ab").find("c") == -1 and Word("ab").count(Word(["Long1"])) == 0
    assert Word("ab").find("") == 0 and Word("ab").find("", 2) == 2 and Word("ab").find("", 3) == -1 and Word("ab").count("") == 3


def test_a_long_word_is_shown_in_part():
    latex = (Word("ab") * 10**6)._repr_latex_()
    assert len(latex) < 10_000 and r"\text{(2000000 letters)}" in latex
    assert "letters" not in Word("abaab")._repr_latex_()


@settings(max_examples=200, deadline=None)
@given(WORDS)
def test_texts_are_read_back_and_words_are_pickled(letters):
    word = Word(letters)
    assert Word(str(word), alphabet=["Long1"]) == word
    assert pickle.loads(pickle.dumps(word)) == word
    assert hash(Word(str(word), alphabet=["Long1"])) == hash(word)


def test_the_empty_word():
    assert len(Word()) == 0 and Word() == Word("ε") == Word([]) and str(Word()) == "ε" and not Word()


def test_a_word_is_an_array_without_copying():
    word = Word("abaab") * 1000
    array = word.array()
    assert array.dtype == numpy.uint32 and not array.flags.owndata and not array.flags.writeable
    assert numpy.shares_memory(array, word.array())
    assert numpy.shares_memory(array, word[5:2000].array())
    assert word.array("uint8").dtype == numpy.uint8
    with pytest.raises(ValueError):
        array[0] = 1
    with pytest.raises(ValueError, match="dtype: expected uint32 or uint8"):
        word.array("float64")


def test_an_array_outlives_its_word():
    array = algae.LSystem("a -> ab, b -> a").derive(15).array()
    [algae.Word("b") * 10_000 for _ in range(50)]
    assert "".join("ab"[one] for one in array[:8]) == "abaababa"


@settings(max_examples=200, deadline=None)
@given(st.fixed_dictionaries({"a": st.text("ab", max_size=3), "b": st.text("ab", max_size=3)}),
       st.fixed_dictionaries({"a": st.text("ab", max_size=3), "b": st.text("ab", max_size=3)}), st.text("ab", max_size=8),
       st.integers(0, 4))
def test_morphisms_are_replacements(g, h, word, power):
    def image(rules, text):
        return "".join(rules[one] for one in text)

    def text(of):
        return "".join(of.letters)

    assert text(Morphism(g)(Word(list(word)))) == image(g, word)
    assert text((Morphism(g) * Morphism(h))(Word(list(word)))) == image(g, image(h, word))
    expected = word
    for _ in range(power):
        expected = image(h, expected)
    assert text((Morphism(h) ** power)(Word(list(word)))) == expected


def test_a_letter_without_image_is_named():
    with pytest.raises(algae.Error, match="the letter c has no image"):
        Morphism("a -> ab, b -> a")("abc")


def test_matrix_and_analysis():
    assert Morphism("a -> aab, b -> a").matrix().tolist() == [[2, 1], [1, 0]]
    assert Word("abaab").analysis()["periods"] == [3, 5]


def test_a_word_with_parameters_is_equal_to_its_text():
    word = algae.LSystem("axiom A(1); A(x) -> A(x+1)B(x)").derive(2)
    assert word == "A(3)B(2)B(1)" and word != "A(3)B(2)" and word != "AB" and Word("AB") != "A(1)B(2)"
