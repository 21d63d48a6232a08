"""What a builder asks: each answer with its formula, its source and its check by `RealMotion`."""

from ._answer import Answer as Answer
from ._answer import Check as Check
from ._design import Design as Design
from ._design import design as design
