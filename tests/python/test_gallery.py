"""The package against the command's JSON, for every system of the gallery."""

import json

import pytest

import algae
from algae import Budget, LSystem

BUDGET = Budget(timeout=60, letters=10**7)


def same(mine, theirs):
    """Whether the values are the same; integers of the command beyond 2^53 are strings."""
    if isinstance(mine, bool) or isinstance(theirs, bool):
        return mine is theirs
    if isinstance(mine, int) and isinstance(theirs, str):
        return str(mine) == theirs
    return mine == theirs


@pytest.mark.parametrize("name", algae.gallery())
def test_a_system_is_what_the_command_says(name, command):
    system = LSystem(name)
    assert system.to_dict() == command("show", name, "--json")
    assert LSystem.from_text(system.text, name=name) == system
    facts = command("show", name, "--json")
    assert list(system.alphabet) == facts["alphabet"] and system.rules == facts["rules"] and system.axiom == facts["axiom"]


@pytest.mark.parametrize("name", algae.gallery())
def test_words_are_those_of_the_command(name, command):
    system = LSystem(name)
    for n in (0, 1, 2):
        theirs = command("derive", name, "-n", str(n), "--json")
        if theirs is None or "words" not in theirs:
            if "shape" not in system.kind:
                with pytest.raises((algae.Error, algae.Stopped)):
                    system.derive(n, budget=BUDGET)
            continue
        assert str(system.derive(n, budget=BUDGET)) == theirs["words"][0]


@pytest.mark.parametrize("name", algae.gallery())
def test_growth_is_that_of_the_command(name, command):
    system = LSystem(name)
    if not system.is_deterministic:
        with pytest.raises(algae.Error):
            system.growth(timeout=60)
        return
    growth = system.growth(budget=BUDGET)
    theirs = command("growth", name, "--json")
    assert growth.to_dict() == theirs
    assert all(same(mine, one) for mine, one in zip(growth.lengths, theirs["lengths"]))
    assert growth.closed_form == theirs["closed_form"] and growth.kind == theirs["class"]
    assert growth.degree == theirs["degree"]
    assert [[int(one) for one in row] for row in growth.matrix.tolist()] == [[int(one) for one in row] for row in theirs["matrix"]] \
        or len(growth.letters) > 0 and "rows" in str(theirs["matrix"])[:10]
    far = command("growth", name, "-n", "60..61", "--json")["lengths"]
    assert all(same(mine, one) for mine, one in zip(system.lengths(61, first=60), far))


@pytest.mark.parametrize("name", algae.gallery())
def test_finiteness_is_that_of_the_command(name, command):
    theirs = command("finite", name, "--timeout", "5", "--json")
    if theirs is None:
        return
    assert LSystem(name).finite(timeout=60).to_dict() == theirs


@pytest.mark.parametrize("name", algae.gallery())
def test_figures_are_those_of_the_command(name, command, tmp_path):
    system = LSystem(name)
    shown = system.shown_generations
    if shown is None:
        return
    n = min(shown[1], 2)
    theirs = command("draw", name, "-n", str(n), "--json", "-o", str(tmp_path / "figure.png"), "--width", "50")
    if theirs is None or "figures" in theirs:
        return
    mine = system.facts(n, budget=BUDGET)
    for key in ("generation", "segments", "bounding_box", "end", "exact"):
        assert mine[key] == theirs[key]
    segments = system.segments(n, budget=BUDGET)
    assert len(segments) == int(theirs["segments"])


def test_dimensions_are_those_of_the_command(command):
    theirs = {row["name"]: row for row in json.loads(json.dumps(command(
        "dimension", "--table", "--quick", "--timeout", "600", "--json")))}
    for name in ("koch", "dragon", "hilbert", "gosper", "sierpinski", "levy", "plant-f"):
        if name in theirs and name in algae.gallery():
            assert LSystem(name).dimension(timeout=60).to_dict() == theirs[name]
    assert len(theirs) == len(algae.gallery())


def test_trees_are_those_of_the_command(command, tmp_path):
    for name in ("fibonacci", "anabaena", "thue-morse", "koch"):
        theirs = command("tree", name, "-n", "3", "--json", "-o", str(tmp_path / "tree.dot"))
        mine = LSystem(name).tree(3)
        assert (len(mine.nodes), len(mine.edges)) == (theirs["nodes"], theirs["edges"])


def test_members_and_comparisons_are_those_of_the_command(command):
    for name, word in (("fibonacci", "abaab"), ("fibonacci", "bb"), ("all-powers", "aaa"), ("thue-morse", "0110")):
        assert LSystem(name).member(word).to_dict() == command("member", name, word, "--json")
    for left, right in (("fibonacci", "thue-morse"), ("fibonacci", "fibonacci")):
        for way in ("language", "sequence", "growth"):
            assert LSystem(left).equal(LSystem(right), way).to_dict() == command("equal", left, right, "--as", way, "--json")


def test_families_are_those_of_the_command(command):
    for family, text in (("0L", "{a, aa}"), ("PD0L", "L(fibonacci)"), ("regular", "/a*/"), ("D0L", "{a, b}"), ("finite", "{a}")):
        theirs = command("is", family, text, "--json")
        answer = algae.Language(text).is_(family)
        assert answer.truth == theirs["verdict"] and answer.argument == theirs["argument"]
        if answer.certificate() is not None:
            assert answer.certificate() == theirs.get("witness", theirs.get("obstruction"))


def test_censuses_are_those_of_the_command(command):
    theirs = command("census", "0L systems up to size 5", "--by", "finite,D0L", "--format", "json")
    mine = algae.census("0L systems up to size 5", ["finite", "D0L"])
    assert mine.instances == [row["all"] for row in theirs["rows"]]
    for name in ("finite", "D0L"):
        assert mine.proved(name) == [row[name]["proved"] for row in theirs["rows"]]


def test_the_version_is_that_of_the_library(source):
    text = (source / "CMakeLists.txt").read_text()
    assert f"project(algae VERSION {algae.__version__} " in text
