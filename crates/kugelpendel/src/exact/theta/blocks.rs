//! The trigonometric chart at many times.

use crate::exact::phase::Phase;
use crate::exact::plan::Plan;
use crate::exact::theta::shape::Shape;
use crate::exact::theta::trigonometric::{MAX_DEGREE, Trigonometric};
use crate::given::times::{Quantity, Times};
use crate::numbers::arithmetic::{Arithmetic, FEW_FORMS, product};
use crate::sampling::blocks::half;
use crate::sampling::blocks::{Form, SwingAndFrame, blocks};
use std::f64::consts::{PI, TAU};

/// m, and the rates of ζ and of the frame in rad/s.
#[derive(Clone, Copy)]
pub(crate) struct Scale {
    pub(crate) length: f64,
    pub(crate) swing: f64,
    pub(crate) frame: f64,
}

/// The chart with its degrees and form known to the compiler.
struct Fixed<'a, const DEGREE: usize, const ALPHA: usize, const FROM_ABOVE: bool> {
    chart: &'a Trigonometric,
    scale: Scale,
}

impl<A: Arithmetic, const DEGREE: usize, const ALPHA: usize, const FROM_ABOVE: bool> Form<A>
    for Fixed<'_, DEGREE, ALPHA, FROM_ABOVE>
{
    #[inline(always)]
    fn point<const RATES: bool>(&self, [cos, sin]: [f64; 2], direction: [f64; 2]) -> [f64; 3] {
        let shape = self.chart.at::<A, DEGREE, ALPHA, FROM_ABOVE, RATES>(cos, sin);
        seen_from_outside::<A, RATES>(&shape, direction, self.scale)
    }
}

#[inline(always)]
pub(crate) fn fill_theta<A: Arithmetic>(
    plan: &Plan,
    chart: &Trigonometric,
    quantity: Quantity,
    times: Times<'_>,
    out: &mut [f64],
) {
    let Phase::Periodic { swings, frame, start } = plan.phase else {
        return;
    };
    let scale = Scale { length: plan.length, swing: PI * swings.hi, frame: TAU * frame.hi };
    let angles = SwingAndFrame { swing: half(swings), frame, start: [0.5 * start.hi, plan.turn] };
    let table = plan.rotations.as_deref();
    let degrees = if FEW_FORMS { [MAX_DEGREE; 2] } else { [chart.degree, chart.alpha_degree] };
    macro_rules! fill {
        ($($degree:literal $alpha:literal,)+) => {
            match (degrees[0], degrees[1], chart.from_above) {
                $(
                    ($degree, $alpha, false) => {
                        let form = Fixed::<$degree, $alpha, false> { chart, scale };
                        blocks::<A>(&form, &angles, table, quantity, times, out);
                    }
                    ($degree, $alpha, true) => {
                        let form = Fixed::<$degree, $alpha, true> { chart, scale };
                        blocks::<A>(&form, &angles, table, quantity, times, out);
                    }
                )+
                degree => unreachable!("{degree:?} is not a degree from 1 to {MAX_DEGREE} and α's"),
            }
        };
    }
    fill!(1 0, 1 1, 2 1, 2 2, 3 2, 3 3, 4 3, 4 4,);
}

/// From the turning frame to x, y and z, or to their rates.
#[inline(always)]
pub(crate) fn seen_from_outside<A: Arithmetic, const RATES: bool>(
    shape: &Shape,
    direction: [f64; 2],
    scale: Scale,
) -> [f64; 3] {
    let Scale { length, swing, frame } = scale;
    let (plan, z) = if RATES {
        let x = A::mul_add(swing, shape.x_rate, -(frame * shape.y));
        let y = A::mul_add(swing, shape.y_rate, frame * shape.x);
        ([x, y], -shape.unit * (swing * shape.height_rate))
    } else {
        ([shape.x, shape.y], A::mul_add(-shape.unit, shape.height, length))
    };
    let [x, y] = product::<A>(direction, plan);
    [shape.unit * x, shape.unit * y, z]
}
