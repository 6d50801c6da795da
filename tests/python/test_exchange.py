"""To and from Sage's strings, sympy, networkx, pandas and L-Py's strings."""

import pytest

import algae
from algae import LSystem, Morphism, Word
from algae.exchange import from_lpy, from_sage, sympy_expression, sympy_matrix, to_lpy, to_sage
from conftest import needed


def test_sage_strings():
    h = Morphism({"a": "ab", "b": "a"})
    assert from_sage(to_sage(h)) == h == from_sage("WordMorphism: a->ab, b->a")
    assert from_sage({"a": ["a", "b"], "b": ["a"]}) == h
    assert to_sage(LSystem("thue-morse")) == "0->01,1->10"
    with pytest.raises(algae.Error, match="letters of one character"):
        to_sage(Morphism({"F_l": "F_l"}))
    with pytest.raises(TypeError, match="morphism: expected"):
        from_sage(5)

    class Alphabet:
        def alphabet(self):
            return ["a", "b"]

    class WordMorphism:  # the two methods of Sage's that are asked
        def domain(self):
            return Alphabet()

        def image(self, letter):
            return {"a": ["a", "b"], "b": ["a"]}[letter]

    assert from_sage(WordMorphism()) == h


def test_sympy():
    sympy = needed("sympy")
    growth = LSystem("a -> ab, b -> a").growth()
    assert sympy_matrix(growth).charpoly().all_coeffs() == [1, -1, -1]
    assert sympy.simplify(sympy_expression(growth.rate) - (1 + sympy.sqrt(5)) / 2) == 0
    form = sympy_expression(growth)
    n = sympy.Symbol("n", integer=True, nonnegative=True)
    assert [sympy.simplify(form.subs(n, i)) for i in range(6)] == [1, 2, 3, 5, 8, 13]
    assert sympy_expression(LSystem("koch").growth().rate) == 4
    assert sympy_matrix(Morphism("a -> aab, b -> a")) == sympy.Matrix([[2, 1], [1, 0]])


def test_networkx():
    networkx = needed("networkx")
    tree = LSystem("a -> ab, b -> a").tree(4)
    graph = tree.to_networkx()
    assert networkx.is_arborescence(graph) and graph.number_of_nodes() == len(tree.nodes)
    leaves = [graph.nodes[one]["label"] for one in graph if graph.out_degree(one) == 0]
    assert "".join(leaves) == "abaababa"


def test_pandas():
    needed("pandas")
    table = algae.census("D0L systems up to size 5", ["finite"]).to_pandas()
    assert table.index.tolist() == [1, 2, 3, 4, 5] and (table["finite"] <= table["all"]).all()


def test_lpy_strings():
    text = "a = 60\nAxiom: A(1)\nderivation length: 3\nproduction:\nA(x) --> F(x)[+A(x/2)]  # a comment\nendlsystem\n"
    system = from_lpy(text)
    assert str(system.derive(2)) == "F(1)[+F(0.5)[+A(0.25)]]"
    assert from_lpy(to_lpy(system)).derive(2) == system.derive(2)
    assert to_lpy(Word("F[+F]")) == "F[+F]"
    assert from_lpy("angle = 60\nAxiom: F\nproduction:\nF --> *\n").derive(1) == Word()
    for wrong, message in (("Axiom: F\nF :\n  produce FF\n", "line 2"), ("F --> FF", "Axiom"),
                           ("Axiom: F\nderivation length: x\n", "a number of generations")):
        with pytest.raises(algae.Error, match=message):
            from_lpy(wrong)
    with pytest.raises(algae.Error, match="without probabilities"):
        to_lpy(LSystem({"F": {"FF": 0.5, "F": 0.5}}))


def test_what_is_not_installed_is_named(monkeypatch):
    import sys

    monkeypatch.setitem(sys.modules, "sympy", None)
    with pytest.raises(ImportError, match="python3-sympy"):
        sympy_matrix(Morphism("a -> ab, b -> a"))
