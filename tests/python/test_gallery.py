"""The package against the command's JSON, for every system of the gallery."""

import numpy
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


def compared(compare):
    """How many systems of the gallery were compared: `compare(name)` gives nothing where there is nothing to compare, and fails where values
    differ. What failed is named by its system."""
    made, wrong = 0, []
    for name in algae.gallery():
        try:
            made += compare(name) is not None
        except AssertionError as error:
            wrong.append(f"{name}: {error}")
        except (algae.Error, algae.Stopped) as error:
            wrong.append(f"{name}: {type(error).__name__}: {error}")
    assert not wrong, "\n\n".join(wrong)
    return made


def test_systems_are_what_the_command_says(command):
    def compare(name):
        system, theirs = LSystem(name), command("show", name, "--json")
        assert system.to_dict() == theirs
        assert list(system.alphabet) == theirs["alphabet"] and system.rules == theirs["rules"] and system.axiom == theirs["axiom"]
        assert LSystem.from_text(system.text, name=name) == system
        return True

    assert compared(compare) == len(algae.gallery())


def test_words_are_those_of_the_command(command):
    """Of systems that the command does not derive, such as shape rules, the package derives no word either."""
    refused = []

    def compare(name):
        system, found = LSystem(name), None
        for n in (0, 1, 2):
            theirs = command("derive", name, "-n", str(n), "--json")
            if theirs is None or "words" not in theirs:
                with pytest.raises((algae.Error, algae.Stopped)):
                    system.derive(n, budget=BUDGET)
                if name not in refused:
                    refused.append(name)
                continue
            found = str(system.derive(n, budget=BUDGET))
            assert found == theirs["words"][0]
        return found

    assert compared(compare) > 0.9 * len(algae.gallery()), refused


def test_growth_is_that_of_the_command(command):
    def compare(name):
        system = LSystem(name)
        if not system.is_deterministic:
            with pytest.raises(algae.Error):
                system.growth(timeout=60)
            return None
        growth, theirs = system.growth(budget=BUDGET), command("growth", name, "--json")
        assert growth.to_dict() == theirs
        assert all(same(mine, one) for mine, one in zip(growth.lengths, theirs["lengths"]))
        assert growth.closed_form == theirs["closed_form"] and growth.kind == theirs["class"] and growth.degree == theirs["degree"]
        if isinstance(theirs["matrix"], list):
            assert growth.matrix.tolist() == [[int(one) for one in row] for row in theirs["matrix"]]
        far = command("growth", name, "-n", "60..61", "--json")["lengths"]
        assert all(same(mine, one) for mine, one in zip(system.lengths(61, first=60), far))
        return True

    assert compared(compare) > 0.5 * len(algae.gallery())


def test_factors_are_those_of_the_command(command):
    """The values up to a length; what holds for all lengths is proved by the command alone."""
    def compare(name):
        system, theirs = LSystem(name), command("words", name, "--to", "10", "--json")
        if not system.is_deterministic:
            assert theirs is None
            return None
        mine = system.factor_report(10)
        for key in set(theirs) - {"not_proved", "critical_exponent", "closed_under_reversal"}:
            if key in ("rich", "pure_point_spectrum"):
                assert mine[key] is None or mine[key] == theirs[key], key
            elif key.endswith("_complexity") and theirs[key]:
                assert mine[key]["values"] == theirs[key]["values"]
            else:
                assert mine[key] == theirs[key], key
        return True

    assert compared(compare) > 0.5 * len(algae.gallery())


def test_finiteness_is_that_of_the_command(command):
    def compare(name):
        theirs = command("finite", name, "--timeout", "5", "--json")
        if theirs is None:
            with pytest.raises((algae.Error, algae.Stopped)):
                LSystem(name).finite(timeout=5)
            return None
        assert LSystem(name).finite(timeout=60).to_dict() == theirs
        return True

    assert compared(compare) > 0.5 * len(algae.gallery())


def test_figures_are_those_of_the_command(command, tmp_path):
    """The command draws nothing where there is no segment, a table where the file says so, and asks for a seed as the package does."""
    apart = []

    def compare(name):
        system = LSystem(name)
        shown = system.shown_generations
        n = min(shown[1], 2) if shown else 2
        try:
            mine = system.facts(n, budget=BUDGET)
        except algae.Error as error:
            assert "say seed=S" in str(error)
            assert command("draw", name, "-n", str(n), "--json", "-o", str(tmp_path / "figure.png")) is None
            apart.append(name)
            return None
        seed = ("--seed", str(mine["seed"])) if "seed" in mine else ()
        theirs = command("draw", name, "-n", str(n), *seed, "--json", "-o", str(tmp_path / "figure.png"), "--width", "300")
        if theirs is None:
            assert mine["segments"] == 0 or "\npicture table\n" in system.text
            apart.append(name)
            return None
        assert set(mine) - {"seed"} == {"generation", "segments", "bounding_box", "end", "exact", "rounded"}
        assert all(mine[key] == theirs[key] for key in mine)
        segments = system.segments(n, budget=BUDGET)
        assert len(segments) == int(theirs["segments"])
        if len(segments) > 0 and segments.shape[2] == 2:  # polygons may reach farther
            low, high = segments.min((0, 1)), segments.max((0, 1))
            box = mine["bounding_box"]
            assert (low > numpy.array(box["min"]) - 1e-9).all() and (high < numpy.array(box["max"]) + 1e-9).all()
        return True

    assert compared(compare) + len(apart) == len(algae.gallery())
    assert len(apart) < 0.3 * len(algae.gallery()), apart


def test_dimensions_are_those_of_the_command(command):
    theirs = {row["name"]: row for row in command("dimension", "--table", "--quick", "--timeout", "600", "--json")}

    def compare(name):
        assert LSystem(name).dimension(timeout=300).to_dict() == theirs[name]
        return True

    assert compared(compare) == len(theirs) == len(algae.gallery())


def test_trees_are_those_of_the_command(command, tmp_path):
    def compare(name):
        theirs = command("tree", name, "-n", "2", "--json", "-o", str(tmp_path / "tree.dot"))
        if theirs is None or "error" in theirs:  # too large for both, too
            with pytest.raises((algae.Error, algae.Stopped)):
                LSystem(name).tree(2, timeout=60)
            return None
        system = LSystem(name)
        seed = 1 if system.to_dict()["stochastic"] else None  # as the command picks
        mine = system.tree(2, seed=seed)
        assert (len(mine.nodes), len(mine.edges)) == (theirs["nodes"], theirs["edges"])
        return True

    assert compared(compare) > 0.5 * len(algae.gallery())


def test_a_figure_of_rounded_parameters_says_why(command, tmp_path):
    """`facts`, `draw` and a mesh had no word of it, where the command says `rounded`."""
    for text, end in (("axiom A(1.0001); A(x) -> +F(x)A(x*x)", "svg"), ("axiom A(1.0001); A(x) -> &F(x)A(x*x)", "obj"),
                      ("axiom A(1.0001); A(x) -> &F(x)A(x*x)", "html")):
        theirs = command("draw", text, "-n", "14", "--json", "-o", str(tmp_path / f"figure.{end}"))
        assert "has more than 10,000 digits" in theirs["rounded"]
        system = LSystem(text)
        assert theirs["rounded"].split(": ", 1)[1] in system.draw(14, format=end).facts["rounded"]
        assert theirs["rounded"].split(": ", 1)[1] in system.facts(14)["rounded"]
        assert system.facts(2)["rounded"] is None and system.draw(2, format=end).facts["rounded"] is None


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
