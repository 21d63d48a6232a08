"""What a builder asks: each answer with its formula, its source and its check by `RealMotion`."""

from kugelpendel.builder._answer import DesignAnswer as DesignAnswer
from kugelpendel.builder._answer import DesignCheck as DesignCheck
from kugelpendel.builder._design import Design as Design
from kugelpendel.builder._design import design as design
