"""The exact motion, expanded in powers of its amplitudes.

Units l = 1, ω0 = 1. For turning radii α, β let d = (1 + √(1 − ρ²))/2 at each of them, so that half
its height is ŝ = 1 − d. The third root of the cubic is s_c = 2/r, r = (d_a + d_b − 1)/(d_a d_b).
With s = mean + half range · cos θ between the turning points, time and azimuth from one highest
point to the next are integrals over θ, and their expansions in s/s_c and s/2 are, with
c_n = (2n choose n)/4ⁿ and M_n = Σ_{i+j=n} c_i c_j ŝ_aⁱ ŝ_bʲ, the mean of (s/2)ⁿ,

    1/ω = √r Σ c_n rⁿ M_n,      Ω/ω = αβ/(4√(d_a d_b)) Σ M_n Σ_{k≤n+1} c_k rᵏ.

The harmonics follow from the residue at the double pole of x + iy in the complex plane of time
(the core, exact/spectrum.rs). With the nome q = XY, and from a highest point on,

    x + iy = e^{iΩt} Σ_{k≥0} (−1)ᵏ (P_k e^{i(2k+1)ωt} + N_k e^{−i(2k+1)ωt}),
    P_k = 4ω((2k+1)ω + Ω) X qᵏ/(1 + X² q^{2k}),   N_k = 4ω((2k+1)ω − Ω) Y qᵏ/(1 + Y² q^{2k}),
    s = s_b + Σ_{n≥1} 16ω² n qⁿ/(1 − q^{2n}) (1 − (−1)ⁿ cos 2nωt).

X and Y are found from Σ(−1)ᵏ(P_k + N_k) = α and Σ(P_k − N_k) = β, or from the amplitudes of the
first harmonics, P_0 + N_0 = a and P_0 − N_0 = b. Each step of the iteration fixes two more degrees.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import comb

from kugelpendel.series._power_series import PowerSeries


@dataclass(frozen=True)
class Expansion:
    """All series of the motion, in units of l and ω0, up to one total degree.

    Attributes
    ----------
    frequency, precession
        ω, Ω.
    plan
        Of e^{i(Ω + n ω)t} in x + iy, by n odd.
    height
        Of cos(nωt) in s = 1 − z, by n even.
    """

    frequency: PowerSeries
    precession: PowerSeries
    plan: dict[int, PowerSeries]
    height: dict[int, PowerSeries]


def rates(alpha: PowerSeries, beta: PowerSeries) -> tuple[PowerSeries, PowerSeries]:
    """ω and Ω from the turning radii."""
    degree = len(alpha.parts) - 1
    depths = [((1 - radius * radius).power(1) + 1) / 2 for radius in (alpha, beta)]
    product = depths[0] * depths[1]
    third = (depths[0] + depths[1] - 1) * product.inverse()
    powers = [[alpha.constant(1)] for _ in depths]
    for depth, list_ in zip(depths, powers, strict=True):
        for _ in range(degree // 2):
            list_.append(list_[-1] * (1 - depth))
    scale = alpha * beta
    period = alpha.constant(0)
    azimuth = period
    third_power = powers[0][0]
    partial = third_power  # 4ⁿ Σ_{k≤n} c_k rᵏ
    for n in range(degree // 2 + 1):
        mean = period * 0
        for i in range(n + 1):
            weight = comb(2 * i, i) * comb(2 * (n - i), n - i)
            mean += weight * powers[0][i] * powers[1][n - i]
        mean /= 4**n
        period += comb(2 * n, n) * mean * third_power / 4**n
        third_power *= third
        partial = 4 * partial + comb(2 * n + 2, n + 1) * third_power
        azimuth += scale * mean * partial / 4 ** (n + 2)
    frequency = (period * third.power(1)).inverse()
    return frequency, frequency * azimuth * product.power(-1)


def in_radii(alpha: PowerSeries, beta: PowerSeries) -> Expansion:
    """In powers of the turning radii: two variables, or one and a multiple of it."""
    degree = len(alpha.parts) - 1
    frequency, precession = rates(alpha, beta)
    targets = (alpha + beta) / 2, (alpha - beta) / 2
    poles: list[PowerSeries] = [target / 4 for target in targets]
    for known in range(3, degree + 1, 2):
        poles = [pole.to(known) for pole in poles]
        plan = _plan(frequency, precession, poles)
        for i, target in enumerate(targets):
            poles[i] += (target - _circular(plan, i)) / 4
    return _expansion(beta, frequency, precession, [pole.to(degree) for pole in poles])


def in_harmonics(a: PowerSeries, b: PowerSeries) -> Expansion:
    """In powers of the semi-axes of the ellipse that the first harmonics make, likewise."""
    degree = len(a.parts) - 1
    targets = (a + b) / 2, (a - b) / 2
    poles: list[PowerSeries] = [target / 4 for target in targets]
    alpha, beta = a.to(2), b.to(2)
    for known in range(3, degree + 1, 2):
        frequency, precession = rates(alpha.to(known), beta.to(known))
        poles = [pole.to(known) for pole in poles]
        plan = _plan(frequency, precession, poles)
        for i, target in enumerate(targets):
            poles[i] += (target - plan[(1, -1)[i]]) / 4
        plan = _plan(frequency, precession, poles)
        sums = _circular(plan, 0), _circular(plan, 1)
        alpha, beta = sums[0] + sums[1], sums[0] - sums[1]
    beta = beta.to(degree)
    return _expansion(beta, *rates(alpha.to(degree), beta), [pole.to(degree) for pole in poles])


def _circular(plan: dict[int, PowerSeries], sense: int) -> PowerSeries:
    """(α + β)/2 or (α − β)/2: the harmonics that are in step at highest and at lowest points."""
    first, *rest = (h for n, h in plan.items() if n % 4 == (1, 3)[sense])
    return sum(rest, first)


def _plan(
    frequency: PowerSeries, precession: PowerSeries, poles: list[PowerSeries]
) -> dict[int, PowerSeries]:
    nome = poles[0] * poles[1]
    found: dict[int, PowerSeries] = {}
    for sense, pole in zip((1, -1), poles, strict=True):
        power = pole
        for k in range(len(pole.parts) // 2):
            n = 2 * k + 1
            rate = n * frequency + sense * precession
            found[sense * n] = (
                4 * (-1) ** k * frequency * rate * power * (1 + power * power).inverse()
            )
            power *= nome
    return found


def _expansion(
    beta: PowerSeries, frequency: PowerSeries, precession: PowerSeries, poles: list[PowerSeries]
) -> Expansion:
    square, nome = 16 * frequency * frequency, poles[0] * poles[1]
    power, mean = nome, 1 - (1 - beta * beta).power(1)
    height: dict[int, PowerSeries] = {}
    for n in range(1, len(beta.parts) // 2 + 1):
        weight = n * square * power * (1 - power * power).inverse()
        mean += weight
        height[2 * n] = -((-1) ** n) * weight
        power *= nome
    plan = _plan(frequency, precession, poles)
    return Expansion(frequency, precession, dict(sorted(plan.items())), {0: mean, **height})
