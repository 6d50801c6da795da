"""For notebooks: cells that hold a system or a claim, and sliders.

``%load_ext algae`` brings the magics. A cell that begins with ``%%lsys NAME`` holds the text of a system, which becomes the variable
NAME and shows itself; ``%%claim NAME`` a claim, which is checked. Errors stand below the cell, with line, column and caret.
"""

from __future__ import annotations

import re
import shlex
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Optional

from . import arguments, pages
from .errors import Error, NotationError, Stopped

if TYPE_CHECKING:
    from .systems import LSystem

__all__ = ["load_ipython_extension", "sliders"]


class _Failed:
    """What is wrong with a cell."""

    def __init__(self, message: str) -> None:
        self.message = message

    def __repr__(self) -> str:
        return self.message

    def _repr_html_(self) -> str:
        return pages.error(self.message)


def _name_of(line: str, usual: str, known: tuple[str, ...]) -> tuple[str, dict[str, str]]:
    """The variable and what stands behind it: `--let a=3`, `--timeout 5`. `known` are the options without their dashes."""
    try:
        parts = shlex.split(line)
    except ValueError:
        raise Error(f"expected a quote that closes the one in {line.strip()!r}") from None
    options: dict[str, str] = {}
    names = []
    at = 0
    while at < len(parts):
        if parts[at].startswith("--"):
            option = parts[at][2:]
            if option not in known:
                raise Error(f"expected --{' or --'.join(known)}, found {parts[at]!r}")
            if at + 1 == len(parts):
                raise Error(f"{parts[at]}: expected a value behind it")
            options[option] = parts[at + 1]
            at += 2
        else:
            names.append(parts[at])
            at += 1
    if len(names) > 1:
        raise Error(f"expected one name of a variable, found {' '.join(names)}")
    name = names[0] if names else usual
    if not name.isidentifier():
        raise Error(f"expected the name of a variable, found {name!r}")
    return name, options


def _seconds(options: dict[str, str]) -> Optional[float]:
    if "timeout" not in options:
        return None
    try:
        return arguments.real("--timeout", float(options["timeout"]), "seconds, a number above 0", 0)
    except ValueError:
        raise Error(f"--timeout: expected seconds, a number above 0, found {options['timeout']!r}") from None


def lsys_cell(line: str, cell: str) -> tuple[str, Any]:
    """The variable of a cell ``%%lsys`` and its system, or what is wrong with it."""
    from .systems import LSystem

    name, options = _name_of(line, "system", ("let",))
    let = {}
    for one in options.get("let", "").split(","):
        if one:
            if "=" not in one:
                raise Error(f"--let: expected NAME=VALUE, found {one!r}")
            key, value = one.split("=", 1)
            let[key.strip()] = value.strip()
    try:
        return name, LSystem.from_text(cell, name=name, let=let)
    except NotationError as error:
        return name, _Failed(str(error))


def claim_cell(line: str, cell: str, systems: dict[str, "LSystem"]) -> tuple[str, Any]:
    """The variable of a cell ``%%claim`` and the checked claim, or what is wrong with it."""
    from .languages import Claim

    name, options = _name_of(line, "claim", ("timeout",))
    timeout = _seconds(options)
    try:
        text = cell if re.search(r"^\s*claim\b", cell, re.M) else f"claim {name}\n{cell}"
        return name, Claim(text, name=name, systems=systems).check(timeout=timeout)
    except NotationError as error:
        return name, _Failed(str(error))
    except (Error, Stopped) as error:
        return name, _Failed(f"{name}: {error}")


def load_ipython_extension(ipython: Any) -> None:
    """What ``%load_ext algae`` calls."""
    from .systems import LSystem

    def shown(name: str, value: Any) -> Any:
        if not isinstance(value, _Failed):
            ipython.user_ns[name] = value
        return value

    def lsys(line: str, cell: Optional[str] = None) -> Any:
        if cell is None:
            try:
                return LSystem(line.strip())
            except Error as error:
                return _Failed(f"%lsys: {error}")
        try:
            return shown(*lsys_cell(line, cell))
        except Error as error:
            return _Failed(f"%%lsys: {error}")

    def claim(line: str, cell: str) -> Any:
        systems = {name: value for name, value in ipython.user_ns.items()
                   if isinstance(value, LSystem) and not name.startswith("_")}
        try:
            return shown(*claim_cell(line, cell, systems))
        except Error as error:
            return _Failed(f"%%claim: {error}")

    ipython.register_magic_function(lsys, "line_cell", "lsys")
    ipython.register_magic_function(claim, "cell", "claim")


def sliders(system: "LSystem", *, generations: Optional[tuple[int, int]] = None, width: float = 400,
            steps: int = 3, **wishes: Any) -> Any:
    """Sliders for the generation, the angle and the constants of a system, with its figure.

    Needs ipywidgets. Without it the pictures of some values are shown below each other: those of the generations, and of the first
    constant half, whole and one and a half times as large.
    """
    from .figures import wishes_of
    from .systems import LSystem

    if not isinstance(system, LSystem):
        raise arguments.wrong_type("system", "an LSystem", system)
    first, last = 0, (system.shown_generations or (0, 4))[1]
    if generations is not None:
        if not isinstance(generations, (tuple, list)):
            raise arguments.wrong_type("generations", "a pair (first, last)", generations)
        if len(generations) != 2:
            raise arguments.wrong_value("generations", "a pair (first, last)", generations)
        first = arguments.generation("generations[0]", generations[0])
        last = arguments.generation("generations[1]", generations[1])
        if last < first:
            raise ValueError(f"generations[1]: expected {first} or more, which is generations[0], found {last}")
    steps = arguments.count("steps", steps, 1)
    width = arguments.real("width", width, "a number above 0", 0)
    wishes_of(wishes)
    values: dict[str, float] = {}
    for name, text in system.constants.items():
        try:
            values[name] = float(Fraction(text))
        except (ValueError, ZeroDivisionError):
            continue
    if system.angle is not None and system.angle != 0:
        values["angle"] = float(system.angle)

    def picture(n: int, **changed: float) -> Any:
        changed_system = system
        let = {name: value for name, value in changed.items() if name in system.constants}
        if let:
            changed_system = changed_system.with_constants(**let)
        if "angle" in changed and "angle" not in system.constants:
            changed_system = with_angle(changed_system, changed["angle"])
        return changed_system.draw(n, width=width, timeout=30, **wishes)

    try:
        import ipywidgets
    except ImportError:
        ipywidgets = None
    if ipywidgets is None:
        from .figures import Picture

        class Sequence:
            """Pictures below each other."""

            def __init__(self, pictures: list[tuple[str, Picture]]) -> None:
                self.pictures = pictures

            def _repr_html_(self) -> str:
                return "".join(f"<figure>{one._repr_html_() or pages.svg_element(one._repr_svg_() or '')}<figcaption>{pages.escaped(said)}"
                               "</figcaption></figure>" for said, one in self.pictures)

        shown = [(f"n = {n}", picture(n)) for n in range(max(first, last - steps + 1), last + 1)]
        for name, value in list(values.items())[:1]:
            for factor in (0.5, 1.5):
                shown.append((f"{name} = {value * factor:g}", picture(last, **{name: value * factor})))
        return Sequence(shown)

    from IPython.display import display

    controls: dict[str, Any] = {"n": ipywidgets.IntSlider(value=last, min=first, max=last, description="n")}
    for name, value in values.items():
        low, high = (0.0, 180.0) if name == "angle" else sorted((0.0, 2 * value)) if value else (-1.0, 1.0)
        controls[name] = ipywidgets.FloatSlider(value=value, min=low, max=high, description=name, continuous_update=False)

    def show(**chosen: Any) -> None:
        display(picture(**chosen))

    return ipywidgets.interactive(show, **controls)


def with_angle(system: "LSystem", angle: float) -> "LSystem":
    """The same system with another angle, in degrees."""
    from .systems import LSystem

    text = re.sub(r"^angle .*\n", "", system.text, flags=re.M)
    return LSystem.from_text(f"{text}angle {angle!r}\n", name=system.name or "system")
