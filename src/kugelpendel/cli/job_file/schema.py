"""What a job file and a design file may say: their one declaration.

From it come what the reader allows and asks for, the help of the command line, and the tables of
README.md and docs. Nothing heavy is imported here, since the help is to answer at once.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from kugelpendel.cli.job_file.kinds import (
    ACCELERATION,
    ANGLE,
    DECAY,
    DENSITY,
    EXPANSION,
    LATITUDE,
    LENGTH,
    MASS,
    PRESSURE,
    QUADRATIC,
    RATE,
    SPEED,
    TIME,
    Kind,
)


@dataclass(frozen=True)
class Vector:
    """Three quantities of one kind."""

    kind: Kind


@dataclass(frozen=True)
class Choice:
    """One of a few words."""

    choices: tuple[str, ...]


@dataclass(frozen=True)
class Number:
    """A number without a unit."""

    example: float


@dataclass(frozen=True)
class Truth:
    """True or false."""


@dataclass(frozen=True)
class Several:
    """One or several words, or quantities of one kind, which may also be a range."""

    holds: Kind | str


@dataclass(frozen=True)
class Key:
    """One line of a file.

    Attributes
    ----------
    name
        Left of the equals sign.
    holds
        What stands right of it.
    text
        What it means.
    default
        What is taken where the line is missing, in SI; None for none.
    unless
        The same in words, where the number alone does not tell.
    needed
        Whether the line must be there.
    example
        A value to paste; that of the kind unless given.
    """

    name: str
    holds: Kind | Vector | Choice | Number | Truth | Several
    text: str = ""
    default: float | str | bool | None = None
    unless: str = ""
    needed: bool = False
    example: str = ""


@dataclass(frozen=True)
class Way:
    """One of the kinds of a section that has several, with the keys that belong to it."""

    word: str
    keys: tuple[str, ...]
    text: str


@dataclass(frozen=True)
class Section:
    """One table of a file.

    Attributes
    ----------
    name
        In brackets.
    keys
        All that it may have.
    one_of
        Alternatives of which a file may have one: keys, or several that go together.
    ways
        Where the word of the key ``kind`` decides which others there are.
    needed
        Whether the table must be there.
    """

    name: str
    keys: tuple[Key, ...]
    one_of: tuple[tuple[str, ...], ...] = ()
    ways: tuple[Way, ...] = ()
    needed: bool = False

    def key(self, name: str) -> Key:
        """The key of a name."""
        return next(key for key in self.keys if key.name == name)


@dataclass(frozen=True)
class FileSchema:
    """One sort of file: its sections, and the lines of the example that is shown for it."""

    sections: tuple[Section, ...]
    example: dict[str, dict[str, str]] = field(default_factory=dict[str, dict[str, str]])

    def section(self, name: str) -> Section:
        """The section of a name."""
        return next(section for section in self.sections if section.name == name)


PENDULUM = Section(
    "pendulum",
    (
        Key("length", LENGTH, "from the support to the bob", needed=True, example='"67 m"'),
        Key("gravity", ACCELERATION, unless="9.80665 m/s², or that of the site,"),
        Key("mass", MASS, "scales the tension", unless="1 kg, or that of the bob,"),
    ),
    needed=True,
)

LAUNCH = Section(
    "launch",
    (
        Key(
            "kind",
            Choice(("ellipse", "apsides", "plane", "angles", "state", "at_rest")),
            "one of the following, each with its keys",
            needed=True,
        ),
        Key("a", LENGTH, needed=True),
        Key("b", LENGTH, needed=True),
        Key("azimuth", ANGLE, default=0.0),
        Key("x", LENGTH, needed=True),
        Key("y", LENGTH, needed=True),
        Key("vx", SPEED, needed=True),
        Key("vy", SPEED, needed=True),
        Key("theta", ANGLE, needed=True),
        Key("phi", ANGLE, default=0.0),
        Key("theta_rate", RATE, default=0.0),
        Key("phi_rate", RATE, default=0.0),
        Key("position", Vector(LENGTH), needed=True),
        Key("velocity", Vector(SPEED), needed=True),
    ),
    ways=(
        Way(
            "ellipse",
            ("a", "b", "azimuth"),
            "displaced by a, then pushed sideways with the speed b·√(g/l)",
        ),
        Way(
            "apsides",
            ("a", "b", "azimuth"),
            "exact turning radii below the support; starts at the outer one",
        ),
        Way("plane", ("x", "y", "vx", "vy"), "seen from above, below the support"),
        Way(
            "angles",
            ("theta", "phi", "theta_rate", "phi_rate"),
            "theta from the downward vertical",
        ),
        Way("state", ("position", "velocity"), "`[x, y, z]` each, from the support, z down"),
        Way("at_rest", ("theta", "phi"), "let go without a push"),
    ),
    needed=True,
)

OUTPUT = Section(
    "output",
    (
        Key("duration", TIME, "how long", needed=True),
        Key("step", TIME, "time between the rows of the track", example='"0.1 s"'),
        Key("samples", Number(1000), "how many rows"),
        Key("format", Choice(("csv", "netcdf", "parquet")), "of the track", default="csv"),
        Key("figure", Truth(), "whether one is drawn", default=True),
    ),
    one_of=(("step",), ("samples",)),
    needed=True,
)

SITE = Section(
    "site",
    (
        Key(
            "latitude",
            LATITUDE,
            "positive in the north; also `48.85 N` or `48°51′N`, in quotes",
            needed=True,
            example='"48.85 deg"',
        ),
        Key("gravity", ACCELERATION, unless="WGS84 normal gravity there"),
        Key("height", LENGTH, "above the ellipsoid", default=0.0, example='"35 m"'),
    ),
)

DRAG = Section(
    "drag",
    (
        Key("linear", DECAY, "γ: the amplitude falls as e^(−γt)", default=0.0),
        Key("quality", Number(800), "Q of a small swing"),
        Key("half_life", TIME, "time in which the amplitude halves", example='"2 h"'),
        Key(
            "from_bob",
            Truth(),
            "an estimate of both kinds of drag from ball and air; needs `[bob]`",
            default=False,
        ),
        Key(
            "thread_diameter",
            LENGTH,
            "with from_bob only: the thread's drag comes to that of the ball",
            default=0.0,
            example='"1 mm"',
        ),
        Key("quadratic", QUADRATIC, "c, as in −c|v|v; not with from_bob", default=0.0),
    ),
    one_of=(("linear",), ("quality",), ("half_life",), ("from_bob",)),
)

SUSPENSION = Section(
    "suspension",
    (
        Key(
            "anisotropy",
            RATE,
            "δ: frequency along the axis less that across it",
            default=0.0,
            example='"4e-6 rad/s"',
        ),
        Key("period_along", TIME, "period of a swing along the axis", example='"8.97 s"'),
        Key("period_across", TIME, "and of one across it", example='"8.98 s"'),
        Key("axis", ANGLE, "azimuth of the axis", default=0.0),
        Key(
            "damping_anisotropy",
            DECAY,
            "Δγ: decay rate along its axis less that across it",
            default=0.0,
            example='"1e-6 1/s"',
        ),
        Key("damping_axis", ANGLE, "azimuth of that axis", default=0.0),
    ),
    one_of=(("anisotropy",), ("period_along", "period_across")),
)

BOB = Section(
    "bob",
    (
        Key("radius", LENGTH, "of a ball; size, buoyancy and air change the period"),
        Key("diameter", LENGTH, "of the ball", example='"20 cm"'),
        Key("density", DENSITY, "mass over volume", needed=True),
        Key("thread_mass", MASS, "of thread or wire", default=0.0, example='"100 g"'),
        Key(
            "air_density",
            DENSITY,
            "of the air around",
            default=1.204,
            unless="1.204 kg/m³",
            example='"1.204 kg/m^3"',
        ),
    ),
    one_of=(("radius",), ("diameter",)),
)

DRIVE = Section(
    "drive",
    (
        Key(
            "push",
            SPEED,
            "a sudden change of velocity away from the axis, once in each half swing; negative "
            "inwards",
            needed=True,
            example='"0.3 mm/s"',
        ),
        Key("phase", ANGLE, "when: phase/ω0 after the closest approach", example='"25 deg"'),
        Key("radius", LENGTH, "on the way out at this distance from the axis", example='"20 cm"'),
    ),
    one_of=(("phase",), ("radius",)),
)

FORCES = (SITE, DRAG, SUSPENSION, BOB, DRIVE)
"""What acts on a real pendulum; without any of them it is an ideal one."""

SWING = Section(
    "swing",
    (
        Key("a", LENGTH, "amplitude, as seen from a frame that does not turn", needed=True),
        Key("b", LENGTH, "half-width, positive counter-clockwise", default=0.0),
        Key("azimuth", ANGLE, "of the swing", default=0.0),
    ),
    needed=True,
)

WIRE = Section(
    "wire",
    (
        Key("diameter", LENGTH, "of the wire", needed=True, example='"1.5 mm"'),
        Key("young", PRESSURE, "modulus of elasticity", default=2.0e11, unless="200 GPa"),
        Key("expansion", EXPANSION, "with heat", default=1.2e-5, unless="1.2e-5 1/K"),
    ),
)

QUESTIONS = Section(
    "questions",
    (
        Key(
            "share",
            Number(0.01),
            "of the Foucault rate that an error may take",
            default=0.01,
        ),
        Key("after", TIME, "time after which the amplitude is asked", 3600.0, "1 h"),
        Key("radius", LENGTH, "radius to pass, such as a coil's", example='"20 cm"'),
        Key("time", TIME, "time after the closest approach", example='"0.5 s"'),
    ),
)

JOB = FileSchema(
    (PENDULUM, LAUNCH, OUTPUT, *FORCES),
    {
        "pendulum": {"length": '"67 m"', "mass": '"28 kg"'},
        "launch": {"kind": '"ellipse"', "a": '"3 m"', "b": '"1 cm"'},
        "output": {"duration": '"1 h"', "step": '"0.1 s"'},
    },
)

IDEAL_JOB = FileSchema((PENDULUM, LAUNCH, OUTPUT), JOB.example)
"""A job that nothing but gravity acts on."""

DESIGN = FileSchema(
    (PENDULUM, SWING, *FORCES, WIRE, QUESTIONS),
    {
        "pendulum": {"length": '"20 m"', "mass": '"60 kg"'},
        "swing": {"a": '"1 m"', "b": '"5 mm"'},
        "site": {"latitude": '"50 deg"'},
        "drag": {"half_life": '"3 h"'},
        "suspension": {"anisotropy": '"1e-6 rad/s"'},
        "bob": {"diameter": '"24 cm"', "density": '"7860 kg/m^3"'},
        "drive": {"push": '"1 mm/s"', "radius": '"10 cm"'},
        "wire": {"diameter": '"1.5 mm"'},
        "questions": {"share": "0.01", "after": '"1 h"', "radius": '"20 cm"', "time": '"0.5 s"'},
    },
)
