"""What the answers are called, their formulas, their sources, and what is said of them, by key."""

from __future__ import annotations

from dataclasses import dataclass

_EXACT = "closed form: E. T. Whittaker, Analytical Dynamics, §55"
_OLSSON = "M. G. Olsson, Am. J. Phys. 49, 531 (1981), eq. "
_NELSON = "R. A. Nelson and M. G. Olsson, Am. J. Phys. 54, 112 (1986)"
_FOUCAULT = "L. Foucault, Comptes rendus 32, 135 (1851)"
_AVERAGED = "averaged equations, docs/design.md"
_PORTRAIT = (
    "portrait on the sphere: E. O. Schulz-DuBois, Am. J. Phys. 38, 173 (1970), docs/design.md"
)
_HOOKE = "Hooke's law"
_PUSH = "method: R. A. Schumacher and B. Tarbet, arXiv:0902.1829 (2009)"
_NORMAL = "WGS84 normal gravity: NIMA TR8350.2, eq. (4-1), (4-3)"
_GROUND = "aΩ_z − (2/3)(a²/l) Ω_h sin ψ0"
_FADING = "ln(1 + γ(1/a − 1/a0)/(γ/a0 + k))/γ"


@dataclass(frozen=True)
class Entry:
    """What is said of an answer whatever its value; names and notes take facts in braces."""

    group: str
    name: str
    unit: str
    formula: str
    source: str
    note: str = ""


def _group(group: str, rows: dict[str, tuple[str, ...]]) -> dict[str, Entry]:
    return {key: Entry(group, *row) for key, row in rows.items()}


def _tried(key: str, push: str) -> dict[str, tuple[str, ...]]:
    return {
        f"turning_{key}": (
            f"Turning under {push}", "rad/s", "Ω(a, b) − (p/πρ) ab/(a²−b²) cos 2φ", _AVERAGED,
            "φ = {phase:.4g}°, {push:.4g} mm/s, b = {b:.4g} m; without a push {intrinsic:.4g} °/h"),
        f"growth_{key}": (
            f"Growth under {push}", "1/s",
            "p sin 2φ/(2πρ) − γ − ka, ρ² = a² sin²φ + b² cos²φ", _AVERAGED, "of the amplitude"),
        f"amplitude_{key}": (
            f"Amplitude under {push}", "m", "γa + ka² = p cos φ/π", _AVERAGED),
    }  # fmt: skip


PUSHES = {
    "best_push": "the best push",
    "best_pull": "the best pull",
    "early": "a push too early",
    "late": "a push too late",
    "weak": "a push too weak",
    "strong": "a push too strong",
    "given": "the drive given",
}
"""The pushes that are tried; their answers are turning_…, growth_… and amplitude_… ."""

ANSWERS = {
    **_group("period", {
        "period_small": ("Period of small swings", "s", "T0 = 2π √(l/g)", _NELSON),
        "amplitude_series": (
            "Amplitude, by the series", "1", "θ0²/16 + 11 θ0⁴/3072, sin θ0 = a/l", _NELSON),
        "amplitude_exact": ("Amplitude, exact", "1", "2K(m)/π − 1, m = sin²(θ0/2)", _EXACT),
        "ellipse_width": (
            "Width of the ellipse", "1", "T(a, b)/T0 − T(a, 0)/T0", _EXACT,
            "b²/16l² = {first:.3g} by (26)"),
        "bob_radius": (
            "Bob's radius", "1", "√(1 + (2/5)(r/l)²) − 1 ≈ (1/5)(r/l)²", _NELSON),
        "thread_mass": (
            "Thread's mass", "1", "√((1 + μ/3)/(1 + μ/2)) − 1 ≈ −μ/12, μ = m_t/m", _NELSON),
        "buoyancy": ("Buoyancy", "1", "1/√(1 − β) − 1 ≈ β/2, β = ρ_air/ρ_bob", _NELSON),
        "added_air": (
            "Air that moves along", "1", "√(1 + β/2) − 1 ≈ β/4", _NELSON,
            "half the displaced air"),
        "drag_period": ("Linear drag", "1", "1/√(1 − (γ/ω0)²) − 1 ≈ 1/8Q²", _NELSON),
        "earth_period": ("Turning of the Earth", "1", "1/√(1 + (Ω_z/ω0)²) − 1", _AVERAGED),
        "suspension_period": (
            "Suspension", "1", "−(δ/ω0) cos²(ψ − χ)", _AVERAGED, "at the start"),
        "period": ("Period of the swing", "s", "T0 with all of these", f"{_NELSON}; {_EXACT}"),
        "gravity_standard": (
            "Gravity, against the standard", "1", "√(9.80665 m/s²/g) − 1", _NELSON,
            "in T0 already"),
        "gravity_site": (
            "Gravity, against that of the site", "1", "√(g_site/g) − 1", _NORMAL,
            "normal gravity there is {normal:.6g} m/s²"),
    }),
    **_group("turning", {
        "foucault_rate": (
            "Foucault rate", "rad/s", "−Ω_E sin(latitude), Ω_E = 7.292115e-5 rad/s", _FOUCAULT,
            "against the stars: one turn of the Earth in 86164 s"),
        "foucault_turn": ("One turn by the Earth", "s", "2π/|Ω_z|", _FOUCAULT),
        "foucault_day": ("Turned in 24 h", "rad", "−Ω_z · 86400 s", _FOUCAULT),
        "intrinsic_first": (
            "Intrinsic rate, formula (25)", "rad/s", "(3/8) ω0 ab/l²", f"{_OLSSON}(25)",
            "the same as Puiseux's 3RV/8l², R = a, V = bω0"),
        "intrinsic_exact": (
            "Intrinsic rate, exact", "rad/s", "(ΔΦ − π)/T for the turning radii a and b", _EXACT),
        "intrinsic_ratio": ("Intrinsic over Foucault rate", "1", "Ω(a, b)/Ω_z", _EXACT),
        "largest_b": (
            "Largest b for {percent:g} %", "m", "(8/3) x |Ω_z| l²/(ω0 a)", f"{_OLSSON}(25)"),
        "speed_least": (
            "Sideways speed for {percent:g} %, least", "m/s", f"−bω0 − ({_GROUND}), with that b",
            f"{_OLSSON}(16); {_AVERAGED}", "against the floor; counter-clockwise"),
        "speed_most": (
            "Sideways speed for {percent:g} %, most", "m/s", f"+bω0 − ({_GROUND}), with that b",
            f"{_OLSSON}(16); {_AVERAGED}", "against the floor; counter-clockwise"),
        "release_b": (
            "Ellipse of a release from rest", "m", f"b = ({_GROUND})/ω0", _AVERAGED,
            "seen from a frame that does not turn, where the floor moves"),
        "release_rate": (
            "Rate after a release from rest", "rad/s",
            "−Ω_z (1 − 3a²/8l²) − (1/4)(a/l)³ Ω_h sin ψ0", _AVERAGED, "to first orders in a/l"),
        "release_speed": (
            "Sideways speed for no ellipse", "m/s", f"−({_GROUND})", _AVERAGED,
            "against the floor; counter-clockwise"),
        "share_earth": ("Share of the Earth", "rad/s", "−Ω_z", _FOUCAULT, "at the start"),
        "share_intrinsic": (
            "Share of the ellipse", "rad/s", "(ΔΦ − π)/T for the turning radii a and b", _EXACT,
            "at the start"),
        "share_anisotropy": (
            "Share of the anisotropy", "rad/s", "−δ ab/(a²−b²) cos 2(ψ−χ)", _AVERAGED,
            "at the start"),
        "share_damping": (
            "Share of the damping", "rad/s", "(Δγ/2)(a²+b²)/(a²−b²) sin 2(ψ−χd)", _AVERAGED,
            "at the start"),
        "rate_at_start": ("Rate at the start", "rad/s", "the sum of the shares", _AVERAGED),
    }),
    **_group("decay", {
        "quality_linear": ("Quality of the linear drag", "1", "Q = ω0/2γ", _NELSON),
        "decay_time": ("Decay time of the linear drag", "s", "1/γ", _NELSON, "to 1/e"),
        "quality_now": (
            "Quality at this amplitude", "1", "Q = ω0/2(γ + ka), k = (4/3π) c ω0", _NELSON,
            "linear and quadratic drag; narrow ellipses"),
        "half_time": ("Time to half the amplitude", "s", _FADING, _NELSON),
        "e_time": ("Time to 1/e of the amplitude", "s", _FADING, _NELSON),
        "amplitude_after": (
            "Amplitude after the time asked", "m", "a0 e^(−γt)/(1 + k a0 (1 − e^(−γt))/γ)", _NELSON,
            "t = {time:g} s"),
        "energy_lost": (
            "Energy lost in a swing", "1", "4π (γ + ka)/ω0 = 2π/Q", _NELSON,
            "as a share of the energy"),
        "power_lost": ("Power lost", "W", "m ω0² a² (γ + ka)", _NELSON, "for {mass:g} kg"),
    }),
    **_group("suspension", {
        "stalling_anisotropy": (
            "Anisotropy that may stall this swing", "rad/s",
            "2|Ω_z| max(t − m t²/(1 + t²)), 0 ≤ t ≤ 1, m = μ/2|Ω_z|, "
            "μ = (3/8) ω0 (a²/l²)(1 + 7a²/32l²)", _PORTRAIT,
            "of the angular frequencies; for starts at b = 0"),
        "stalling_period_difference": (
            "The same, of the periods", "s", "2π δ/ω0²", _PORTRAIT),
        "stalling_damping": (
            "Damping anisotropy that stalls", "1/s", "|Δγ| = 2 |Ω_z|", _AVERAGED,
            "of the decay rates; at any amplitude"),
        "critical_amplitude": (
            "Critical amplitude", "m", "m = max((t − x)(1 + 1/t²)), x ≤ t ≤ 1, x = |δ|/2|Ω_z|",
            _PORTRAIT, "for starts at b = 0"),
        "turning_by_anisotropy": (
            "Mean turning by Earth and anisotropy", "rad/s", "±π/T, T once round the orbit; or 0",
            _PORTRAIT),
        "slowest_by_anisotropy": (
            "Slowest turning by the anisotropy", "rad/s",
            "least −Ω_z + μu/2 − uG/2(1−u²) on the orbit", _PORTRAIT),
        "fastest_by_anisotropy": (
            "Fastest turning by the anisotropy", "rad/s", "largest on the orbit", _PORTRAIT),
        "widest_by_anisotropy": (
            "Ellipse that the anisotropy opens", "m",
            "√(a²+b²) sin(½ asin u), largest on the orbit", _PORTRAIT, "on either side"),
        "slowest_by_damping": (
            "Slowest turning by the damping", "rad/s", "−Ω_z ± Δγ/2", _AVERAGED),
        "fastest_by_damping": (
            "Fastest turning by the damping", "rad/s", "−Ω_z ± Δγ/2", _AVERAGED),
        "settled_rate": (
            "Mean turning with all that acts", "rad/s", "the averaged motion, run", _AVERAGED),
    }),
    **_group("drive", {
        "best_phase": (
            "Phase of the best push", "rad", "tan 2φ = 8l²/(3Qa²), Q = ω0/2(γ + ka)",
            f"{_AVERAGED}; {_PUSH}",
            "after the closest approach; it cancels the intrinsic precession"),
        "best_time": (
            "Time of the best push", "s", "φ/ω0", _AVERAGED, "after the closest approach"),
        "best_radius": ("Radius of the best push", "m", "a sin φ", _AVERAGED, "on the way out"),
        "best_push": (
            "Size of the best push", "m/s", "p = πa(γ + ka)/cos φ", _AVERAGED,
            "outwards in every half swing; it holds the amplitude"),
        "best_pull_radius": (
            "Radius of the best pull", "m", "a cos φ", _AVERAGED,
            "on the way in, for a coil that pulls"),
        "best_pull": (
            "Size of the best pull", "m/s", "p = πa(γ + ka)/sin φ", _AVERAGED,
            "inwards in every half swing"),
        **{key: row for name, push in PUSHES.items() for key, row in _tried(name, push).items()},
    }),
    **_group("passage", {
        "passage_time": (
            "Time to pass the radius", "s", "ρ(t) = radius, the closed form solved for t", _EXACT,
            "radius {radius:.6g} m, after the closest approach"),
        "time_within": (
            "Time within the radius", "s", "twice that", _EXACT, "in every half swing"),
        "passage_speed": (
            "Speed at the radius", "m/s", "|v(t)|", _EXACT,
            "radius {radius:.6g} m, after the closest approach"),
        "radius_at": (
            "Radius at the time", "m", "ρ(t)", _EXACT,
            "{time:.6g} s after the closest approach"),
    }),
    **_group("wire", {
        "tension_least": (
            "Least tension", "N", "m (v² + gz)/l", f"{_OLSSON}(5a)",
            "for {mass:g} kg, the wire's own weight not in it"),
        "tension_largest": (
            "Largest tension", "N", "m (v² + gz)/l", f"{_OLSSON}(5a)",
            "for {mass:g} kg, the wire's own weight not in it"),
        "stress": ("Largest stress", "Pa", "F/(πd²/4)", _HOOKE),
        "stretch_rest": ("Stretch at rest", "m", "(m + m_t/2) g l/(E πd²/4)", _HOOKE),
        "stretch_swing": (
            "Stretch from turning point to bottom", "m", "ΔF l/(E πd²/4)", _HOOKE),
        "lengthening": ("Lengthening by a kelvin", "m", "α l", _NELSON),
        "period_kelvin": (
            "Period by a kelvin", "1/K", "α/2", _NELSON, "{daily:.3g} s in a day"),
    }),
}  # fmt: skip
"""Every answer there can be."""

REMARKS = {
    "safe_below": "with less, every straight swing of this amplitude goes round, without drag and "
    "drive",
    "safe_below_amplitude": "a smaller straight swing goes round from every azimuth, without drag "
    "and drive",
    "never_safe": "none: |δ| ≥ 2|Ω_z|, so that straight swings of every size turn back from some "
    "azimuths",
    "wide": "wider than half of a: the formula holds for narrow ellipses, so take any b",
    "round": "without drag and drive it goes round, half a turn in {hours:.4g} h",
    "to_and_fro": "without drag and drive it turns back: to and fro between the azimuths "
    "{west:.4g}° and {east:.4g}°, once in {hours:.4g} h",
    "stands": "without drag and drive it stays as it is",
    "turns_back": "it turns back",
    "stalls": "it stalls",
    "settled_round": "it goes round: {degrees:.4g}° in {hours:.4g} h",
    "settled_to_and_fro": "it does not go round: within a turn of the Earth it stays between the "
    "azimuths {west:.4g}° and {east:.4g}°",
    "settled_stands": "it comes to rest at the azimuth {west:.4g}°",
    "dying": "while the amplitude falls to a tenth, in {hours:.4g} h, it turns by {degrees:.4g}°, "
    "the Earth alone by {alone:.4g}°",
    "settled_after": "looked at {after:.4g} h after the start",
    "changed": "drag and drive change what the clamp alone would do",
    "same": "as the clamp alone would do",
    "takes": "the push takes energy away",
    "pumps": "beyond the length: it pumps without end, and is not run",
    "weight": "with the wire's own weight, at the top",
    "no_weight": "without the wire's own weight",
}
"""What is said where it is so; all of it gives way where the check contradicts the formula."""

DOUBTED = "the run gives another answer by more than a tenth of {of}: trust it, not the formula"
"""What is said in place of every remark where an answer's own check contradicts it."""

DOUBTED_BASIS = "a run of this very swing contradicts what this rests on: do not rely on it"
"""The same where another answer's check does."""

HOW = {
    "everything": "RealMotion with all that is given but the drive: the first swings, between "
    "turning points",
    "no_ellipse": "RealMotion with the Earth alone, pushed so that no ellipse opens: 10 swings",
    "bare": "RealMotion without Earth, air and suspension: 10 swings",
    "share": "RealMotion without Earth: the b that turns with {percent:g} % of the Foucault rate",
    "first_approach": "RealMotion with the Earth alone: first closest approach",
    "release": "RealMotion with the Earth alone, at rest at the start: 10 swings",
    "start": "RealMotion with all that is given but the drive: the first 3 swings",
    "drag": "RealMotion with the drag alone, at the turning points before and after that time",
    "damping": "RealMotion with the Earth and this damping: 10 swings",
    "anisotropy_run": "RealMotion with the Earth and the anisotropy alone, for {time:.4g} s",
    "damping_run": "RealMotion with the Earth and the damping alone, for {time:.4g} s",
    "push": "RealMotion with the drag as linear and this push: 10 swings",
    "passage": "RealMotion without Earth, air and suspension, counted from its closest approach",
    "tension": "RealMotion without Earth, air and suspension: {samples:.0f} times in a swing",
}
"""What was run."""
