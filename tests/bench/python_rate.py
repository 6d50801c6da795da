"""How fast the package gives a curve of 10^7 points and the letters of a long word, beside copies of memory, and beside L-Py and Sage where
they are installed. All ratios are of one run."""

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


def main():
    dragon = algae.LSystem("dragon")
    n = 23  # 2^23 segments
    points = dragon.points(n)
    arrive = seconds(lambda: dragon.points(n), 2)
    copy = seconds(lambda: points.copy())
    again = seconds(lambda: dragon.derive(5).array())
    print(f"{len(points):,} points of the dragon curve: {arrive:.3f} s, {len(points) / arrive / 1e6:.0f} million a second")
    print(f"a copy of the same array by numpy: {copy:.3f} s; ratio {arrive / copy:.1f}")
    print(f"a small word as an array: {again * 1e6:.0f} microseconds")
    fibonacci = algae.LSystem("a -> ab, b -> a")
    length = fibonacci.length(33)
    derived = seconds(lambda: fibonacci.derive(33))
    word = fibonacci.derive(33)
    array = seconds(lambda: word.array())
    print(f"{length:,} letters of the Fibonacci word: {derived:.3f} s, as an array {array * 1e6:.0f} microseconds")

    def plain():
        rules, text = {"a": "ab", "b": "a"}, "a"
        for _ in range(33):
            text = "".join(map(rules.__getitem__, text))

    slow = seconds(plain, 1)
    print(f"the same in plain Python: {slow:.3f} s; ratio {slow / derived:.1f}")
    if importlib.util.find_spec("sage") is not None:
        from sage.all import WordMorphism

        morphism = WordMorphism("a->ab,b->a")
        sage = seconds(lambda: morphism("a", 25), 1)
        mine = seconds(lambda: fibonacci.derive(25))
        print(f"Sage's WordMorphism, 25 steps: {sage:.3f} s; ratio {sage / mine:.0f}")
    else:
        print("Sage is not installed: not compared")
    if importlib.util.find_spec("openalea") is not None and importlib.util.find_spec("openalea.lpy") is not None:
        from openalea.lpy import Lsystem

        system = Lsystem()
        system.setCode("Axiom: F\nderivation length: 8\nproduction:\nF --> F+F--F+F\nendlsystem\n")
        theirs = seconds(lambda: system.derive(), 1)
        mine = seconds(lambda: algae.LSystem("koch").derive(8))
        print(f"L-Py derives generation 8 of Koch's curve: {theirs:.3f} s; ratio {theirs / mine:.0f}")
    else:
        print("L-Py is not installed: not compared")
    assert numpy.isfinite(points).all()


main()
