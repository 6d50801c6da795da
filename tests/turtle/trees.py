"""Honda's and Aono and Kunii's trees by plain rotation matrices: the numbers that trees_test.cpp compares.

Usage: python3 trees.py > trees.txt

Words are Python lists of (symbol, parameters), the turtle a matrix whose columns are heading, left and up, turned by the
matrices of the document, [H' L' U'] = [H L U] R. Nothing is shared with the C++ code.
"""

import math


def multiply(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def about_up(degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return [[c, -s, 0], [s, c, 0], [0, 0, 1]]


def about_left(degrees):  # positive: down
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return [[c, 0, s], [0, 1, 0], [-s, 0, c]]


def about_heading(degrees):  # positive: \, to the left
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return [[1, 0, 0], [0, c, s], [0, -s, c]]


def levelled(frame):
    """L' = V x H / |V x H| with V = (0, 0, 1), U' = H x L'."""
    h = [frame[i][0] for i in range(3)]
    size = math.sqrt(h[0] ** 2 + h[1] ** 2)
    left = [-h[1] / size, h[0] / size, 0]
    up = [h[1] * left[2] - h[2] * left[1], h[2] * left[0] - h[0] * left[2], h[0] * left[1] - h[1] * left[0]]
    return [[h[i], left[i], up[i]] for i in range(3)]


TURNS = {
    "+": lambda a: about_up(a), "-": lambda a: about_up(-a),
    "&": lambda a: about_left(a), "^": lambda a: about_left(-a),
    "\\": lambda a: about_heading(a), "/": lambda a: about_heading(-a),
}


def walk(word):
    """The strokes of a word, each (from, to, width)."""
    frame, here, width = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], [0.0, 0.0, 0.0], None
    saved, strokes = [], []
    for symbol, *parameters in word:
        if symbol in TURNS:
            frame = multiply(frame, TURNS[symbol](parameters[0]))
        elif symbol == "@":
            frame = levelled(frame)
        elif symbol == "!":
            width = parameters[0]
        elif symbol == "F":
            there = [here[i] + parameters[0] * frame[i][0] for i in range(3)]
            strokes.append((here, there, width))
            here = there
        elif symbol == "[":
            saved.append((frame, here, width))
        elif symbol == "]":
            frame, here, width = saved.pop()
    return strokes


def honda(r1, r2, a0, a2, d, wr):
    def a(l, w):
        return [("!", w), ("F", l), ("[",), ("&", a0), ("B", r2 * l, wr * w), ("]",), ("/", d), ("A", r1 * l, wr * w)]

    def b(l, w):
        return [("!", w), ("F", l), ("[",), ("-", a2), ("@",), ("C", r2 * l, wr * w), ("]",), ("C", r1 * l, wr * w)]

    def c(l, w):
        return [("!", w), ("F", l), ("[",), ("+", a2), ("@",), ("B", r2 * l, wr * w), ("]",), ("B", r1 * l, wr * w)]

    return {"A": a, "B": b, "C": c}


def aono_kunii(r1, r2, a1, a2, wr):
    def a(l, w):
        return [("!", w), ("F", l), ("[",), ("&", a1), ("B", r1 * l, wr * w), ("]",), ("/", 180),
                ("[",), ("&", a2), ("B", r2 * l, wr * w), ("]",)]

    def b(l, w):
        return [("!", w), ("F", l), ("[",), ("+", a1), ("@",), ("B", r1 * l, wr * w), ("]",),
                ("[",), ("-", a2), ("@",), ("B", r2 * l, wr * w), ("]",)]

    return {"A": a, "B": b}


TREES = {
    "honda-a": honda(0.9, 0.8, 45, 45, 137.5, 0.707),
    "honda-b": honda(0.9, 0.7, 30, -30, 137.5, 0.707),
    "aono-kunii-a": aono_kunii(0.9, 0.8, 35, 35, 0.707),
    "aono-kunii-b": aono_kunii(0.9, 0.8, 20, 50, 0.707),
}


def main():
    print("# name generation modules segments length thinnest low high")
    for name, rules in TREES.items():
        word = [("^", 90), ("A", 1, 0.04)]
        for generation in range(11):
            strokes = walk(word)
            if strokes:
                points = [point for stroke in strokes for point in stroke[:2]]
                numbers = [math.fsum(math.dist(*stroke[:2]) for stroke in strokes), min(stroke[2] for stroke in strokes)]
                numbers += [choose(point[i] for point in points) for choose in (min, max) for i in range(3)]
                print(name, generation, len(word), len(strokes), *(repr(number) for number in numbers))
            word = [part for module in word
                    for part in (rules[module[0]](*module[1:]) if module[0] in rules else [module])]


if __name__ == "__main__":
    main()
