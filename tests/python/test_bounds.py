"""Real work obeys its bounds, leaves the interpreter's lock free, and stops at Ctrl-C: operators too."""

import os
import signal
import threading
import time

import pytest

import algae
from algae import Budget, LSystem, Morphism, Word

LETTERS = 2 * 10**7
FIBONACCI = Morphism("a -> ab, b -> a")
PLANT = LSystem("bush-3d")


@pytest.fixture(scope="module")
def long():
    return Word("ab") * (LETTERS // 2)


WORK = {
    "count": lambda long, path: long.count("aba"),
    "find": lambda long, path: long.find("bb"),
    "in": lambda long, path: "bb" in long,
    "+": lambda long, path: long + "a",
    "*": lambda long, path: Word("abaab") * (LETTERS // 4),
    "==": lambda long, path: long == long[:],
    "slice": lambda long, path: long[::-1],
    "counts": lambda long, path: long.counts(),
    "str": lambda long, path: str(long),
    "uint8": lambda long, path: long.array("uint8"),
    "image": lambda long, path: FIBONACCI(long),
    "compose": lambda long, path: Morphism({"a": long, "b": "a"}) * FIBONACCI,
    "power": lambda long, path: FIBONACCI**34,
    "values": lambda long, path: LSystem("a -> ab, b -> a").growth().values(40_000),
    "figure in space": lambda long, path: PLANT.draw(6),
    "mesh": lambda long, path: PLANT.mesh(5).save(path / "plant.obj"),
    "page of a mesh": lambda long, path: PLANT.mesh(5)._repr_html_(),
}


@pytest.mark.parametrize("name", WORK)
def test_the_time_of_a_block_bounds_all_that_is_done_in_it(name, long, tmp_path):
    with pytest.raises(algae.Timeout), Budget(timeout=1e-6):
        WORK[name](long, tmp_path)
    assert not list(tmp_path.iterdir())
    assert Word("a") + "b" == "ab"  # the bound ended with the block


@pytest.mark.parametrize("name", ["count", "find", "+", "*", "slice", "counts", "uint8", "image", "compose", "power"])
def test_letters_and_memory_are_bounded(name, long, tmp_path):
    if name in ("+", "*", "slice", "image", "compose", "power"):
        with pytest.raises(algae.BoundReached, match="allowed by letters=") as caught, Budget(letters=10**6):
            WORK[name](long, tmp_path)
        assert caught.value.bound == "letters"
    if name in ("+", "*", "slice", "image", "compose", "power", "uint8"):
        with pytest.raises(algae.BoundReached) as caught, Budget(memory=10**6):
            WORK[name](long, tmp_path)
        assert caught.value.bound == "memory"
    else:
        with Budget(memory=10**6):
            WORK[name](long, tmp_path)  # needs no memory that grows with the word


@pytest.mark.parametrize("name", ["count", "find", "+", "*", "slice", "counts", "str", "image", "power"])
def test_other_threads_go_on_during_real_work(name, long, tmp_path):
    ticks = 0
    ends = threading.Event()

    def tick():
        nonlocal ticks
        while not ends.is_set():
            ticks += 1
            time.sleep(0.0005)

    thread = threading.Thread(target=tick)
    thread.start()
    try:
        most = 0
        for _ in range(5):  # where the lock is held there is at most a tick at each end of the call
            before = ticks
            WORK[name](long, tmp_path)
            most = max(most, ticks - before)
    finally:
        ends.set()
        thread.join()
    assert most > 4


ENDLESS = {
    "values": lambda path: LSystem("a -> ab, b -> a").growth().values(10**7),
    "figure in space": lambda path: PLANT.draw(30),
    "mesh": lambda path: PLANT.mesh(30),
    # hours of strokes one by one: those of a picture that is drawn by blocks are over too soon
    "picture": lambda path: LSystem("axiom F(1); F(x) -> F(x/2)+F(x/2)--F(x/2); angle 45.5").draw(20),
}


@pytest.mark.parametrize("name", ENDLESS)
def test_ctrl_c_stops_real_work(name, tmp_path):
    sent = []

    def send():
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(0.3, send)
    timer.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            ENDLESS[name](tmp_path)
    finally:
        timer.cancel()  # or it would interrupt another test
        timer.join()
    assert time.monotonic() - sent[0] < 10
    assert FIBONACCI("ab") == "aba"


def test_several_pieces_of_work_of_one_call_share_its_time():
    """The second scene of a figure in space began with a time of its own."""
    limits = algae._algae.Limits(0.2)
    begin = time.monotonic()
    for _ in range(3):
        with pytest.raises(algae.Timeout):
            algae._algae.work_for(limits)
    assert time.monotonic() - begin < 0.5


def test_blocks_stand_within_blocks_and_only_narrow():
    with Budget(letters=100):
        with Budget(letters=1000):
            with pytest.raises(algae.BoundReached, match="more than the 100 allowed"):
                Word("a") * 101
        with pytest.raises(algae.BoundReached, match="more than the 10 allowed"):
            LSystem("a -> aa").derive(6, budget=Budget(letters=10))
        told = []

        def work():
            told.append(len(Word("a") * 1000))

        thread = threading.Thread(target=work)  # a block is of its own thread
        thread.start()
        thread.join()
        assert told == [1000]
    assert len(Word("a") * 1000) == 1000


def test_a_block_s_progress_is_told():
    told = []
    with pytest.raises(algae.Timeout), Budget(timeout=0.7, progress=told.append):
        LSystem("a -> ab, b -> a").growth().values(10**7)
    assert told
