"""What a builder asks: each answer with its formula, its source and its check by `RealMotion`."""

from kugelpendel.builder._answer import Answer as Answer
from kugelpendel.builder._answer import Check as Check
from kugelpendel.builder._design import Design as Design
from kugelpendel.builder._design import design as design
