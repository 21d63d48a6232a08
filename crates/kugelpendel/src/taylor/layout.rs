//! How the numbers of a step lie in the processor's registers: the directions of space of one case side by side, or several
//! cases, each in its lane. The recurrences are written once for both, and do the same operations in the same order.

use crate::numbers::arithmetic::Arithmetic;
use crate::numbers::lanes::{Lanes, Number};
use std::marker::PhantomData;

/// x, y, z of one case and a fourth number that is zero, so that a vector fills a register.
pub(crate) type Vector = [f64; 4];

pub(crate) trait Layout {
    /// One number of each case.
    type Scalar: Number;
    /// x, y, z of each case, as they are kept.
    type Vector: Copy;
    /// The same in the registers, where long sums of products are made.
    type Registers: Copy;
    /// Whether the orders of a series are written out one by one, known to the compiler: one case waits for its results,
    /// and straight lines shorten the wait; with several it is the lines that would be waited for.
    const WRITTEN_OUT: bool;

    fn same(value: f64) -> Self::Scalar;
    fn mul_add(a: Self::Scalar, b: Self::Scalar, c: Self::Scalar) -> Self::Scalar;
    fn sqrt(value: Self::Scalar) -> Self::Scalar;
    fn abs(value: Self::Scalar) -> Self::Scalar;
    fn max(a: Self::Scalar, b: Self::Scalar) -> Self::Scalar;

    fn vector(parts: [Self::Scalar; 3]) -> Self::Vector;
    fn parts(vector: &Self::Vector) -> [Self::Scalar; 3];
    fn times(vector: &Self::Vector, factor: Self::Scalar) -> Self::Vector;
    /// sum + factor·term, rounded twice.
    fn plus(sum: Self::Vector, term: Self::Vector, factor: Self::Scalar) -> Self::Vector;

    fn registers(vector: &Self::Vector) -> Self::Registers;
    /// The same number in all directions.
    fn everywhere(value: Self::Scalar) -> Self::Registers;
    fn kept(registers: Self::Registers) -> Self::Vector;
    fn mul_add_registers(a: Self::Registers, b: Self::Registers, c: Self::Registers) -> Self::Registers;
    fn add_registers(a: Self::Registers, b: Self::Registers) -> Self::Registers;
}

/// One case, its directions side by side; in a loop over the orders where it is rare, for the same bits in less code.
pub(crate) struct Alone<A, const WRITTEN_OUT: bool = true>(PhantomData<A>);

impl<A: Arithmetic, const WRITTEN_OUT: bool> Layout for Alone<A, WRITTEN_OUT> {
    type Scalar = f64;
    type Vector = Vector;
    type Registers = A::Lanes;
    // A page has to be loaded before it computes: there the code is kept small.
    const WRITTEN_OUT: bool = WRITTEN_OUT && !cfg!(target_arch = "wasm32");

    #[inline(always)]
    fn same(value: f64) -> f64 {
        value
    }
    #[inline(always)]
    fn mul_add(a: f64, b: f64, c: f64) -> f64 {
        A::mul_add(a, b, c)
    }
    #[inline(always)]
    fn sqrt(value: f64) -> f64 {
        value.sqrt()
    }
    #[inline(always)]
    fn abs(value: f64) -> f64 {
        value.abs()
    }
    #[inline(always)]
    fn max(a: f64, b: f64) -> f64 {
        a.max(b)
    }
    #[inline(always)]
    fn vector([x, y, z]: [f64; 3]) -> Vector {
        [x, y, z, 0.0]
    }
    #[inline(always)]
    fn parts(&[x, y, z, _]: &Vector) -> [f64; 3] {
        [x, y, z]
    }
    #[inline(always)]
    fn times(vector: &Vector, factor: f64) -> Vector {
        // Written out: `map` and `from_fn` of arrays are not always inlined.
        let [x, y, z, w] = *vector;
        [x * factor, y * factor, z * factor, w * factor]
    }
    #[inline(always)]
    fn plus(sum: Vector, term: Vector, factor: f64) -> Vector {
        let ([sx, sy, sz, sw], [tx, ty, tz, tw]) = (sum, term);
        [sx + factor * tx, sy + factor * ty, sz + factor * tz, sw + factor * tw]
    }
    #[inline(always)]
    fn registers(vector: &Vector) -> A::Lanes {
        A::lanes(vector)
    }
    #[inline(always)]
    fn everywhere(value: f64) -> A::Lanes {
        A::same(value)
    }
    #[inline(always)]
    fn kept(registers: A::Lanes) -> Vector {
        A::array(registers)
    }
    #[inline(always)]
    fn mul_add_registers(a: A::Lanes, b: A::Lanes, c: A::Lanes) -> A::Lanes {
        A::mul_add_lanes(a, b, c)
    }
    #[inline(always)]
    fn add_registers(a: A::Lanes, b: A::Lanes) -> A::Lanes {
        A::add_lanes(a, b)
    }
}

/// Several cases, each in its lane.
pub(crate) struct Several<L>(PhantomData<L>);

impl<L: Lanes> Layout for Several<L> {
    type Scalar = L;
    type Vector = [L; 3];
    type Registers = [L; 3];
    const WRITTEN_OUT: bool = false;

    #[inline(always)]
    fn same(value: f64) -> L {
        L::same(value)
    }
    #[inline(always)]
    fn mul_add(a: L, b: L, c: L) -> L {
        a.mul_add(b, c)
    }
    #[inline(always)]
    fn sqrt(value: L) -> L {
        value.sqrt()
    }
    #[inline(always)]
    fn abs(value: L) -> L {
        value.abs()
    }
    #[inline(always)]
    fn max(a: L, b: L) -> L {
        a.max(b)
    }
    #[inline(always)]
    fn vector(parts: [L; 3]) -> [L; 3] {
        parts
    }
    #[inline(always)]
    fn parts(vector: &[L; 3]) -> [L; 3] {
        *vector
    }
    #[inline(always)]
    fn times([x, y, z]: &[L; 3], factor: L) -> [L; 3] {
        [*x * factor, *y * factor, *z * factor]
    }
    #[inline(always)]
    fn plus(sum: [L; 3], term: [L; 3], factor: L) -> [L; 3] {
        [sum[0] + factor * term[0], sum[1] + factor * term[1], sum[2] + factor * term[2]]
    }
    #[inline(always)]
    fn registers(vector: &[L; 3]) -> [L; 3] {
        *vector
    }
    #[inline(always)]
    fn everywhere(value: L) -> [L; 3] {
        [value; 3]
    }
    #[inline(always)]
    fn kept(registers: [L; 3]) -> [L; 3] {
        registers
    }
    #[inline(always)]
    fn mul_add_registers(a: [L; 3], b: [L; 3], c: [L; 3]) -> [L; 3] {
        [a[0].mul_add(b[0], c[0]), a[1].mul_add(b[1], c[1]), a[2].mul_add(b[2], c[2])]
    }
    #[inline(always)]
    fn add_registers(a: [L; 3], b: [L; 3]) -> [L; 3] {
        [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
    }
}
