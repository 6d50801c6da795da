"""algae: L-systems derived exactly, decided, measured and drawn.

>>> import algae
>>> fibonacci = algae.LSystem("a -> ab, b -> a")
>>> fibonacci.word(1000)[10**100 : 10**100 + 20]
Word('ababaabaababaababaab')
>>> fibonacci.growth().rate
Algebraic('(1+sqrt(5))/2')
>>> bool(algae.Language("{a, aa}").is_("0L"))
False

Systems are `LSystem`, words `Word`, morphisms `Morphism`, languages `Language`, statements about them `Claim`. Long work takes
``timeout=`` in seconds and ``budget=``, a `Budget`; Ctrl-C stops it. Errors are `Error` and `NotationError`.
"""

from . import exchange
from ._algae import version as __version__
from .answers import Answer, Comparison, Finite, Membership
from .budget import Budget, ProgressBar
from .errors import BoundReached, Error, Finding, NotationError, Stopped, Timeout, Undecided
from .figures import Mesh, Picture, Tree
from .languages import (Census, CheckedClaim, CheckedStatement, Claim, Family, Language, census, families, search,
                        verify)
from .magics import load_ipython_extension, sliders
from .numbers import Algebraic, Dimension
from .systems import Generation, Growth, LSystem, Measured, Recurrence, gallery, realise
from .words import Morphism, Word

__all__ = [
    "Algebraic", "Answer", "BoundReached", "Budget", "Census", "CheckedClaim", "CheckedStatement", "Claim", "Comparison",
    "Dimension", "Error", "Family", "Finding", "Finite", "Generation", "Growth", "LSystem", "Language", "Measured", "Membership",
    "Mesh", "Morphism", "NotationError", "Picture", "ProgressBar", "Recurrence", "Stopped", "Timeout", "Tree", "Undecided", "Word",
    "__version__", "census", "exchange", "families", "gallery", "load_ipython_extension", "realise", "search", "sliders", "verify",
]
