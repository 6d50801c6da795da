"""How fast the package gives a curve of 10^7 points and the letters of a long word as arrays of numpy, beside numpy's own copy of as many
bytes, plain Python, and Sage and L-Py where they are installed. All ratios are of one run, each of the best of several tries.

`tools/python bench` runs it. Debian has Sage (sagemath); L-Py is neither in Debian nor a wheel that pip builds without its C++ libraries.
"""

import importlib.util
import time

import numpy

import algae


def seconds(work, times=3):
    best = float("inf")
    for _ in range(times):
        begin = time.perf_counter()
        work()
        best = min(best, time.perf_counter() - begin)
    return best


def line(what, taken, floor, of="numpy's copy"):
    print(f"{what:<58} {taken:10.5f} s   {taken / floor:10.3g} times {of}")


def curves():
    dragon, n = algae.LSystem("dragon"), 23  # 2^23 segments
    points, segments = dragon.points(n), dragon.segments(n)
    assert len(points) == 2**n + 1 and numpy.isfinite(points).all() and (points[1:] == segments[:, 1]).all()
    copy = seconds(points.copy, 5)
    print(f"numpy copies {len(points):,} points, {points.nbytes:,} bytes: {copy:.5f} s, {points.nbytes / copy / 1e9:.1f} GB/s")
    del segments
    arrive = seconds(lambda: dragon.points(n))
    line(f"points({n}) of the dragon curve", arrive, copy)
    line(f"segments({n}), twice as many bytes", seconds(lambda: dragon.segments(n)), copy)
    line("a loop of numpy that makes as many points: cumsum", seconds(lambda: numpy.cumsum(points, axis=0)), copy)
    return arrive / len(points)


def words():
    fibonacci, n = algae.LSystem("a -> ab, b -> a"), 33
    word = fibonacci.derive(n)
    letters, small = word.array(), word.array("uint8")
    assert len(letters) == len(word) == fibonacci.length(n) and letters.base is not None and (letters == small).all()
    copy = seconds(letters.copy, 5)
    print(f"\nnumpy copies {len(letters):,} letters, {letters.nbytes:,} bytes: {copy:.5f} s, {letters.nbytes / copy / 1e9:.1f} GB/s")
    line("the letters of the word as uint32, not copied", seconds(word.array, 9), copy)
    line("as uint8, one byte a letter", seconds(lambda: word.array("uint8")), copy)
    line("how often each letter occurs", seconds(word.counts), copy)
    derived = seconds(lambda: fibonacci.derive(n))
    line(f"derive({n})", derived, copy)

    def plain():
        rules, text = {"a": "ab", "b": "a"}, "a"
        for _ in range(n):
            text = "".join(map(rules.__getitem__, text))
        return text

    line("the same in plain Python", seconds(plain, 1), copy)
    growth = fibonacci.growth()
    print(f"{'a matrix of growth as an array':<58} {seconds(lambda: growth.matrix, 9):10.5f} s")


def beside_sage(a_point):
    if importlib.util.find_spec("sage") is None:
        print("\nSage is not installed: not compared")
        return
    from sage.all import WordMorphism, WordPaths

    fibonacci, n = algae.LSystem("a -> ab, b -> a"), 14
    morphism = WordMorphism(algae.exchange.to_sage(fibonacci))
    assert algae.exchange.from_sage(morphism) == fibonacci.morphism
    assert "".join(morphism("a", n)) == str(fibonacci.derive(n))
    print()
    line(f"Sage's WordMorphism, {n} steps, {fibonacci.length(n):,} letters", seconds(lambda: list(morphism("a", n))),
         seconds(lambda: fibonacci.derive(n).letters, 9), "algae")
    directions, n = algae.Morphism("0 -> 01, 1 -> 21, 2 -> 23, 3 -> 03"), 12  # east, north, west, south
    path = WordPaths("0123", "square_grid")(str(directions.power(n)("0")))
    begin = time.perf_counter()
    found = numpy.array([tuple(one) for one in path.points()], dtype=float)
    taken = time.perf_counter() - begin
    assert len(found) == 2**n + 1 and (numpy.abs(numpy.diff(found, axis=0)).sum(1) == 1).all()
    line(f"Sage's WordPaths, {len(found):,} points of the dragon, each", taken / len(found), a_point, "a point of algae")


def beside_lpy(a_point):
    if importlib.util.find_spec("openalea") is None or importlib.util.find_spec("openalea.lpy") is None:
        print("L-Py is not installed: not compared")
        return
    from openalea.lpy import Lsystem

    system = Lsystem()
    system.setCode("Axiom: F\nderivation length: 8\nproduction:\nF --> F+F--F+F\nendlsystem\n")
    line("L-Py, generation 8 of Koch's curve", seconds(system.derive, 1), seconds(lambda: algae.LSystem("koch").derive(8)), "algae")


def main():
    a_point = curves()
    words()
    beside_sage(a_point)
    beside_lpy(a_point)


main()
