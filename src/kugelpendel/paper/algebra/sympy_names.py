"""SymPy and mpmath, where their missing types are dealt with: what comes from them is Any.

The only module of the project that imports either. `Expr` is the name that annotations use for a
SymPy expression.
"""

# pyright: reportMissingTypeStubs=false

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    Expr = Any
    Abs: Any
    Add: Any
    Dummy: Any
    Function: Any
    I: Any  # noqa: E741 (SymPy's name)
    Integer: Any
    LatexPrinter: Any
    Matrix: Any
    Mul: Any
    Pow: Any
    Rational: Any
    Symbol: Any
    binomial: Any
    cancel: Any
    chebyshevt: Any
    chebyshevu: Any
    cos: Any
    diff: Any
    expand: Any
    expand_trig: Any
    factor: Any
    factorial: Any
    fraction: Any
    mp: Any
    mpc: Any
    mpf: Any
    nan: Any
    pi: Any
    QQ: Any
    prem: Any
    ring: Any
    sin: Any
    solve: Any
    sqrt: Any
    together: Any
    zoo: Any
else:
    from mpmath import mp, mpc, mpf
    from sympy import (
        QQ,
        Abs,
        Add,
        Dummy,
        Expr,
        Function,
        I,
        Integer,
        Matrix,
        Mul,
        Pow,
        Rational,
        Symbol,
        binomial,
        cancel,
        chebyshevt,
        chebyshevu,
        cos,
        diff,
        expand,
        expand_trig,
        factor,
        factorial,
        fraction,
        nan,
        pi,
        prem,
        ring,
        sin,
        solve,
        sqrt,
        together,
        zoo,
    )
    from sympy.printing.latex import LatexPrinter

__all__ = [
    "QQ",
    "Abs",
    "Add",
    "Dummy",
    "Expr",
    "Function",
    "I",
    "Integer",
    "LatexPrinter",
    "Matrix",
    "Mul",
    "Pow",
    "Rational",
    "Symbol",
    "binomial",
    "cancel",
    "chebyshevt",
    "chebyshevu",
    "cos",
    "diff",
    "expand",
    "expand_trig",
    "factor",
    "factorial",
    "fraction",
    "mp",
    "mpc",
    "mpf",
    "nan",
    "pi",
    "prem",
    "ring",
    "sin",
    "solve",
    "sqrt",
    "together",
    "zoo",
]
