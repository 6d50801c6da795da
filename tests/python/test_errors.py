"""Bad input: the argument, what was expected and what was found; places in texts; stops."""

import os
import pickle
import signal
import subprocess
import sys
import threading
import time

import pytest

import algae
from algae import Claim, Language, LSystem, Morphism, Word, _algae

F = LSystem("a -> ab, b -> a")

WRONG_TYPES = [
    (lambda: LSystem(5), "source: expected"),
    (lambda: LSystem({"a": 5}), r"source\['a'\]: expected a word"),
    (lambda: LSystem({5: "a"}), "source: a letter: expected a str, found 5"),
    (lambda: LSystem("a -> ab", let=[]), "let: expected a dict"),
    (lambda: F.derive("x"), "n: expected a generation, an int from 0 on, found 'x' \\(str\\)"),
    (lambda: F.derive(1.5), "n: expected a generation"),
    (lambda: F.derive(True), "n: expected a generation"),
    (lambda: F.derive(3, seed="x"), "seed: expected"),
    (lambda: F.letter(3, "x"), "at: expected a position"),
    (lambda: F.derive(3, timeout="x"), "timeout: expected seconds"),
    (lambda: F.derive(3, budget=3), "budget: expected a Budget"),
    (lambda: F.member(3), "word: expected a Word"),
    (lambda: F.equal("a -> ab"), "other: expected an LSystem"),
    (lambda: F.draw("x"), "n: expected a generation"),
    (lambda: LSystem("koch").draw([1, 3]), r"n: expected a generation, an int from 0 on, or a pair \(first, last\), found \[1, 3\]"),
    (lambda: {Language("{a}")}, "unhashable type: 'Language'"),
    (lambda: F.draw(3, colour="red"), "did you mean colours"),
    (lambda: LSystem("koch").draw(3, width="x"), "width: expected a number above 0"),
    (lambda: LSystem("koch").draw(3, camera=5), "camera: expected"),
    (lambda: F.tree(), "tree: expected a generation n, or a word"),
    (lambda: Word(5), "letters: expected"),
    (lambda: Word("a")["x"], "index: expected"),
    (lambda: Morphism(5), "images: expected"),
    (lambda: Morphism({"a": 5}), r"images\['a'\]: expected a word"),
    (lambda: Language(5), "expression: expected"),
    (lambda: Language("{a}").is_(5), "family: expected"),
    (lambda: Language("{a}").equal("{a}"), "other: expected a Language"),
    (lambda: 3 in Language("{a}"), "word: expected a word"),
    (lambda: Claim(5), "text: expected a str"),
    (lambda: algae.Budget(progress=5), "progress: expected a function"),
    (lambda: algae.census(5), "of: expected a str"),
]


@pytest.mark.parametrize("call,message", WRONG_TYPES)
def test_wrong_types_name_the_argument(call, message):
    with pytest.raises(TypeError, match=message):
        call()


WRONG_VALUES = [
    (lambda: F.derive(-1), "n: expected a generation, an int from 0 on, found -1"),
    (lambda: F.derive(10**30), "n: expected a generation"),
    (lambda: F.lengths(3, first=5), "last: expected 5 or more"),
    (lambda: F.derive(3, timeout=-1), "timeout: expected seconds, a number above 0"),
    (lambda: F.derive(3, timeout=float("nan")), "timeout: expected"),
    (lambda: F.equal(F, "words"), "by: expected one of language, sequence, growth, found 'words'"),
    (lambda: LSystem("koch").draw(3, "x.xyz"), "path: expected a name that ends in"),
    (lambda: LSystem("koch").draw(3, width=-3), "width: expected a number above 0"),
    (lambda: LSystem("kock"), "did you mean 'koch'"),
    (lambda: Word("a(1)"), "has parameters"),
    (lambda: Morphism({"a": "ab", "": "b"}), "a name without blanks"),
    (lambda: Language("{a}").is_("0K"), "0K is no family of languages"),
    (lambda: LSystem("a\ud800"), "half of a pair"),
    (lambda: LSystem({}), "expected rules"),
    (lambda: LSystem({"a": "a\nF"}), "expected a word"),
    (lambda: F.word(3)[::0], "step: expected"),
]


@pytest.mark.parametrize("call,message", WRONG_VALUES)
def test_wrong_values_say_what_was_expected(call, message):
    with pytest.raises(ValueError, match=message):
        call()


def test_an_error_in_a_text_has_its_place():
    with pytest.raises(algae.NotationError) as caught:
        LSystem.from_text("axiom F\nF -> F+F]--F\nangel 60\n", name="koch.lsys")
    error = caught.value
    assert (error.file, error.line, error.column) == ("koch.lsys", 2, 9)
    assert error.caret == "F -> F+F]--F\n        ^"
    assert [one.line for one in error.findings] == [2, 3]
    assert error.findings[1].suggestion == "angle"
    assert str(error).startswith("koch.lsys:2:9: error: unmatched ']'")
    assert isinstance(error, ValueError) and pickle.loads(pickle.dumps(error)).line == 2


@pytest.mark.parametrize("call", [lambda: algae.verify("\u00b5"), lambda: algae.census("\u00c8 systems"), lambda: algae.verify('{"\U0010f53f'),
                                  lambda: LSystem("\u00e9\u00e9 -> \u00b5(")])
def test_a_message_about_letters_beyond_ascii_is_an_error_of_the_package(call):
    """Messages that were cut within a character were no text, and UnicodeDecodeError came instead."""
    with pytest.raises(algae.Error) as caught:
        call()
    assert str(caught.value)


def test_a_file_that_is_not_there(tmp_path):
    with pytest.raises(algae.Error, match="cannot read"):
        LSystem.from_file(tmp_path / "none.lsys")
    with pytest.raises(algae.Error, match="is a folder"):
        LSystem.from_file(tmp_path)


def test_bounds_are_exceptions_that_name_them():
    with pytest.raises(algae.BoundReached, match="allowed by letters=") as caught:
        F.derive(100, budget=algae.Budget(letters=1000))
    assert caught.value.bound == "letters"
    with pytest.raises(algae.Timeout, match="") as late:
        _algae.work_for(_algae.Limits(0.05))
    assert isinstance(late.value, TimeoutError) and late.value.bound == "time" and str(late.value)


def test_an_undecided_answer_is_neither_yes_nor_no():
    answer = Language("L(fibonacci) & /(aab|a)*b*a*/").is_("D0L", timeout=20)
    if answer.is_undecided:
        with pytest.raises(algae.Undecided):
            bool(answer)
    else:
        assert bool(answer) == answer.is_proved


def test_ctrl_c_is_a_keyboard_interrupt_and_work_goes_on_afterwards():
    for _ in range(3):
        timer = threading.Timer(0.1, lambda: os.kill(os.getpid(), signal.SIGINT))
        timer.start()
        with pytest.raises(KeyboardInterrupt):
            _algae.work_for(_algae.Limits(60.0))
        timer.join()
    assert F.derive(5) == "abaababaabaab"


def test_a_program_s_own_handler_of_signals_decides():
    class Mine(Exception):
        pass

    def handler(*_):
        raise Mine

    before = signal.signal(signal.SIGINT, handler)
    try:
        timer = threading.Timer(0.1, lambda: os.kill(os.getpid(), signal.SIGINT))
        timer.start()
        with pytest.raises(Mine):
            _algae.work_for(_algae.Limits(60.0))
        timer.join()
        assert signal.getsignal(signal.SIGINT) is handler
    finally:
        signal.signal(signal.SIGINT, before)


def test_the_lock_is_free_while_work_goes_on():
    ticks = []
    done = threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.005)

    thread = threading.Thread(target=tick)
    thread.start()
    with pytest.raises(algae.Timeout):
        _algae.work_for(_algae.Limits(0.5))
    done.set()
    thread.join()
    assert len(ticks) > 5


def test_threads_use_distinct_objects_at_once():
    found, errors = {}, []

    def work(number):
        try:
            for i in range(10):
                system = LSystem({"a": "ab" * (number % 3 + 1), "b": "a"})
                found[number, i] = (system.length(20 + i), str(system.growth().rate), len(system.derive(5)))
                system.tree(2).draw()
                LSystem("koch").draw(2)
                Language(f"/(a|b)*/ & {{{'a' * (i + 1)}}}").words(3)
        except Exception as error:
            errors.append(error)

    threads = [threading.Thread(target=work, args=(i,)) for i in range(6)]
    [one.start() for one in threads]
    [one.join() for one in threads]
    assert not errors
    for (number, i), value in found.items():
        assert found[number % 3, i] == value


def test_a_callback_s_error_stops_the_work():
    told = []

    def tell(done):
        told.append(done)
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        _algae.work_for(_algae.Limits(60.0, None, None, tell))
    assert len(told) == 1


def test_progress_is_told():
    told = []
    with pytest.raises(algae.Timeout):
        _algae.work_for(_algae.Limits(0.7, None, None, told.append))
    assert len(told) >= 1


def test_objects_may_die_in_any_order():
    script = """
import algae, gc
system = algae.LSystem("koch"); word = system.derive(4); array = word.array(); part = word[3:9]; points = system.points(4)
growth = system.growth(); rate = growth.rate; shares = growth.frequencies
answer = algae.Language("{a, aa}").is_("0L"); tree = system.tree(2)
checked = algae.Claim("claim T; show {a} is 0L").check(); one = checked.statements[0].answer
del system, word, growth, checked; gc.collect()
assert array.sum() > 0 and len(part) == 6 and points.shape[1] == 2 and rate == 4 and answer.argument and one.argument and tree.nodes
import sys; sys.modules.clear()
"""
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr


def test_strange_calls_of_the_module_itself_do_not_end_the_interpreter():
    for name in dir(_algae):
        thing = getattr(_algae, name)
        if not callable(thing) or name in ("Limits",):
            continue
        for given in ((), (None,), (1, 2, 3), ("x",), (object(), object())):
            try:
                thing(*given)
            except Exception:
                pass


def test_objects_that_were_never_made_do_not_end_the_interpreter():
    """Their methods read memory that nobody wrote."""
    script = """
from algae import _algae
made = 0
for name, thing in vars(_algae).items():
    if isinstance(thing, type):
        class Derived(thing):
            def __init__(self):
                pass
        for make in (lambda: thing.__new__(thing), lambda: Derived.__new__(Derived), Derived):
            try:
                make()
            except TypeError:
                made += 1
print(made)
word = _algae.Word("ab", [])
assert word.size() == 2
"""
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    assert int(done.stdout) == 3 * sum(isinstance(one, type) for one in vars(_algae).values()) > 30


def test_a_file_that_cannot_be_written_is_named_as_it_was_asked_for(tmp_path):
    """The message had the name of the file under which a picture is begun."""
    path = tmp_path / "none" / "koch.svg"
    for call in (lambda: LSystem("koch").draw(2, path), lambda: LSystem("koch").draw(2).save(path),
                 lambda: LSystem("bush-3d").mesh(1).save(path.with_suffix(".obj"))):
        with pytest.raises(FileNotFoundError) as caught:
            call()
        assert ".part" not in str(caught.value) and caught.value.filename.startswith(str(path.with_suffix("")))
    (tmp_path / "folder.svg").mkdir()
    with pytest.raises(OSError):
        LSystem("koch").draw(2, tmp_path / "folder.svg")
    assert not list(tmp_path.glob("*.part"))


def test_threads_with_objects_of_their_own_do_all_kinds_of_work():
    """Reading, deciding, drawing and meshes in eight threads at once give what one thread gives."""
    def work(number):
        system = LSystem({"F": "F+F--F+F" if number % 2 else "F-F+F+F-F"}, settings={"angle": 60 if number % 2 else 90})
        told = []
        with algae.Budget(timeout=120, progress=told.append):
            return (system.points(5).sum(), len(system.segments(4)), system.draw(4).data, system.dimension().formula,
                    LSystem("bush-3d").mesh(2).triangles.sum(), str(system.derive(4).counts()), system.factor_complexity(6),
                    algae.census("D0L systems up to size 4", ["finite"]).instances, Word("ab" * number + "a").count("aba"),
                    Claim(f"claim T; show {{{'a' * (number + 1)}, b}} is not 0L").check().verdict,
                    Language("/(ab)*/").random(2 * number, 3, seed=number), (Morphism("a -> ab, b -> a") ** 9)("ab"),
                    LSystem("fibonacci").letter(1000, 10**number), system.tree(2).draw().data, algae.realise([1, 2, 4, 8]).text)

    expected = [work(number) for number in range(8)]
    found: dict = {}

    def run(number):
        try:
            found[number] = [work(number), work(number)]
        except BaseException as error:
            found[number] = error

    threads = [threading.Thread(target=run, args=(i,)) for i in range(8)]
    [one.start() for one in threads]
    [one.join() for one in threads]
    for number in range(8):
        assert found[number] == [expected[number]] * 2
