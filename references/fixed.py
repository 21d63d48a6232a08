"""Fixed-point numbers: an ``int`` n with ``bits`` stands for n / 2**bits.

All integration runs on Python's integers, so a result is the same on every machine. Elementary
functions come from Arb (python-flint), at ``PRECISION`` bits, far above any fixed-point format used
here.
"""

from flint import arb, ctx, fmpz

PRECISION = 640
DIGITS = 25

ctx.prec = PRECISION


def from_arb(value: arb, bits: int) -> int:
    """Nearest fixed-point number below ``value``, good to one unit of 2**-bits."""
    if value.rad() > arb(2) ** (-bits - 8):
        raise ValueError(f"ball too wide for {bits} bits: {value.str(20)}")
    mantissa, exponent = value.mid().man_exp()
    shift = int(exponent) + bits
    return int(mantissa) << shift if shift >= 0 else int(mantissa) >> -shift


def to_arb(value: int, bits: int) -> arb:
    """The exact value of a fixed-point number."""
    return arb(fmpz(value)) * arb(2) ** -bits


def decimal(value: arb, floor: arb | None = None) -> str:
    """25 significant digits; "0" for what is below ``floor`` in size, the noise around a 0."""
    if floor is not None and abs(value) < floor:
        return "0"
    text = value.str(DIGITS, radius=False)
    return "0" if float(text) == 0.0 and "e" not in text else text
