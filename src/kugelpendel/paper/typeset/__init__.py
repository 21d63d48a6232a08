"""How a formula is set: read from LaTeX, broken into lines, written as MathML, Unicode or LaTeX."""
