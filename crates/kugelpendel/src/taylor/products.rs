//! Coefficients of products of series, which is what the recurrences are made of.

use crate::taylor::layout::Layout;
use crate::taylor::series::{Coefficients, ORDER, Vectors};

/// The k-th coefficient of a product of two vectors, direction by direction.
#[inline(always)]
pub(crate) fn dot<L: Layout>(k: usize, a: &Vectors<L::Vector>, b: &Vectors<L::Vector>) -> L::Vector {
    sum::<L, _>(k, &Directed(a), b)
}

/// Of a scalar and a vector.
#[inline(always)]
pub(crate) fn product<L: Layout>(k: usize, a: &Coefficients<L::Scalar>, b: &Vectors<L::Vector>) -> L::Vector {
    sum::<L, _>(k, &Everywhere(a), b)
}

/// Of two scalars, but for the terms with the k-th coefficient of either.
#[inline(always)]
pub(crate) fn inner_terms<L: Layout>(k: usize, a: &Coefficients<L::Scalar>, b: &Coefficients<L::Scalar>) -> L::Scalar {
    assert!(k <= ORDER);
    let [mut even, mut odd] = [L::same(0.0); 2];
    let mut i = 1;
    while i + 1 < k {
        odd = L::mul_add(a[i], b[k - i], odd);
        even = L::mul_add(a[i + 1], b[k - i - 1], even);
        i += 2;
    }
    if i < k {
        odd = L::mul_add(a[i], b[k - i], odd);
    }
    even + odd
}

/// Of the square of a scalar, but for the terms with the k-th coefficient.
#[inline(always)]
pub(crate) fn inner_square<L: Layout>(k: usize, a: &Coefficients<L::Scalar>) -> L::Scalar {
    assert!(k <= ORDER);
    let [mut even, mut odd] = [L::same(0.0); 2];
    let mut i = 1;
    while i + 1 < k.div_ceil(2) {
        odd = L::mul_add(a[i], a[k - i], odd);
        even = L::mul_add(a[i + 1], a[k - i - 1], even);
        i += 2;
    }
    if i < k.div_ceil(2) {
        odd = L::mul_add(a[i], a[k - i], odd);
    }
    let pairs = even + odd;
    let sum = pairs + pairs;
    if k >= 2 && k.is_multiple_of(2) { L::mul_add(a[k / 2], a[k / 2], sum) } else { sum }
}

/// What the terms of a product are made of: a trait and not a closure, since what is not inlined is not compiled for the
/// processor.
trait TermFactors<L: Layout> {
    fn at(&self, order: usize) -> L::Registers;
}

/// One number for each direction.
struct Directed<'a, V>(&'a Vectors<V>);

impl<L: Layout> TermFactors<L> for Directed<'_, L::Vector> {
    #[inline(always)]
    fn at(&self, order: usize) -> L::Registers {
        L::registers(&self.0[order])
    }
}

/// The same number for all directions.
struct Everywhere<'a, S>(&'a Coefficients<S>);

impl<L: Layout> TermFactors<L> for Everywhere<'_, L::Scalar> {
    #[inline(always)]
    fn at(&self, order: usize) -> L::Registers {
        L::everywhere(self.0[order])
    }
}

/// Σ a_i b_{k−i}; a_k comes last, since it is known last.
#[inline(always)]
fn sum<L: Layout, F: TermFactors<L>>(k: usize, a: &F, b: &Vectors<L::Vector>) -> L::Vector {
    let early = early_terms::<L, F>(k, a, b);
    L::kept(L::mul_add_registers(a.at(k), L::registers(&b[0]), early))
}

/// The same without a_k, in four sums, so that one multiplication need not wait for the other. The sums have names, since
/// those of an array would not stay in registers where the loop is not unrolled.
#[inline(always)]
fn early_terms<L: Layout, F: TermFactors<L>>(k: usize, a: &F, b: &Vectors<L::Vector>) -> L::Registers {
    assert!(k <= ORDER);
    let [mut s0, mut s1, mut s2, mut s3] = [L::everywhere(L::same(0.0)); 4];
    let mut i = 0;
    while i + 4 <= k {
        s0 = L::mul_add_registers(a.at(i), L::registers(&b[k - i]), s0);
        s1 = L::mul_add_registers(a.at(i + 1), L::registers(&b[k - i - 1]), s1);
        s2 = L::mul_add_registers(a.at(i + 2), L::registers(&b[k - i - 2]), s2);
        s3 = L::mul_add_registers(a.at(i + 3), L::registers(&b[k - i - 3]), s3);
        i += 4;
    }
    if i < k {
        s0 = L::mul_add_registers(a.at(i), L::registers(&b[k - i]), s0);
    }
    if i + 1 < k {
        s1 = L::mul_add_registers(a.at(i + 1), L::registers(&b[k - i - 1]), s1);
    }
    if i + 2 < k {
        s2 = L::mul_add_registers(a.at(i + 2), L::registers(&b[k - i - 2]), s2);
    }
    L::add_registers(L::add_registers(s0, s1), L::add_registers(s2, s3))
}

/// [`early_terms`] of two products with the same second factor, to the same bits: each of its numbers is loaded once for
/// both, and a quarter of the sums after the other, so that they stay in registers.
#[inline(always)]
pub(crate) fn early_terms_of_two<L: Layout>(
    k: usize,
    vectors: &Vectors<L::Vector>,
    scalars: &Coefficients<L::Scalar>,
    b: &Vectors<L::Vector>,
) -> [L::Registers; 2] {
    assert!(k <= ORDER);
    macro_rules! quarter {
        ($first:literal) => {{
            let [mut one, mut other] = [L::everywhere(L::same(0.0)); 2];
            let mut i = $first;
            while i < k {
                let factor = L::registers(&b[k - i]);
                one = L::mul_add_registers(L::registers(&vectors[i]), factor, one);
                other = L::mul_add_registers(L::everywhere(scalars[i]), factor, other);
                i += 4;
            }
            [one, other]
        }};
    }
    let [[a0, b0], [a1, b1]] = [quarter!(0), quarter!(1)];
    let [one, other] = [L::add_registers(a0, a1), L::add_registers(b0, b1)];
    let [[a2, b2], [a3, b3]] = [quarter!(2), quarter!(3)];
    [L::add_registers(one, L::add_registers(a2, a3)), L::add_registers(other, L::add_registers(b2, b3))]
}

/// Adds the last term of a product of a vector or a scalar, which is given in all directions, with b.
#[inline(always)]
pub(crate) fn with_last_term<L: Layout>(early: L::Registers, last: L::Registers, b: &Vectors<L::Vector>) -> L::Vector {
    L::kept(L::mul_add_registers(last, L::registers(&b[0]), early))
}

/// The k-th coefficient of the square of a vector.
#[inline(always)]
pub(crate) fn square<L: Layout>(k: usize, a: &Vectors<L::Vector>) -> L::Scalar {
    assert!(k <= ORDER);
    let [mut even, mut odd] = [L::everywhere(L::same(0.0)); 2];
    let mut i = 1;
    while i + 1 < k.div_ceil(2) {
        odd = L::mul_add_registers(L::registers(&a[i]), L::registers(&a[k - i]), odd);
        even = L::mul_add_registers(L::registers(&a[i + 1]), L::registers(&a[k - i - 1]), even);
        i += 2;
    }
    if i < k.div_ceil(2) {
        odd = L::mul_add_registers(L::registers(&a[i]), L::registers(&a[k - i]), odd);
    }
    square_of_pairs::<L>(k, L::add_registers(even, odd), a)
}

/// From the products of the coefficients before the middle with those after it, but for the first with the last.
#[inline(always)]
fn square_of_pairs<L: Layout>(k: usize, pairs: L::Registers, a: &Vectors<L::Vector>) -> L::Scalar {
    let mut sum = L::add_registers(pairs, pairs);
    if k >= 2 && k.is_multiple_of(2) {
        sum = L::mul_add_registers(L::registers(&a[k / 2]), L::registers(&a[k / 2]), sum);
    }
    let first = L::registers(&a[0]);
    let first = if k == 0 { first } else { L::add_registers(first, first) };
    total::<L>(&L::kept(L::mul_add_registers(L::registers(&a[k]), first, sum)))
}

/// [`square`], and the early terms of the product with a scalar: each vector is loaded once for both.
#[inline(always)]
pub(crate) fn square_and_early_terms<L: Layout>(
    k: usize,
    a: &Vectors<L::Vector>,
    scalars: &Coefficients<L::Scalar>,
) -> (L::Scalar, L::Registers) {
    assert!(k <= ORDER);
    let zero = L::everywhere(L::same(0.0));
    macro_rules! half {
        ($first:literal) => {{
            let [mut pairs, mut near, mut far] = [zero; 3];
            let mut i = $first;
            while i < k.div_ceil(2) {
                let (one, other) = (L::registers(&a[i]), L::registers(&a[k - i]));
                pairs = L::mul_add_registers(one, other, pairs);
                near = L::mul_add_registers(L::everywhere(scalars[i]), other, near);
                far = L::mul_add_registers(L::everywhere(scalars[k - i]), one, far);
                i += 2;
            }
            (pairs, L::add_registers(near, far))
        }};
    }
    let ((odd, one), (even, other)) = (half!(1), half!(2));
    let mut early = L::add_registers(one, other);
    if k >= 2 && k.is_multiple_of(2) {
        early = L::mul_add_registers(L::everywhere(scalars[k / 2]), L::registers(&a[k / 2]), early);
    }
    if k > 0 {
        early = L::mul_add_registers(L::everywhere(scalars[0]), L::registers(&a[k]), early);
    }
    (square_of_pairs::<L>(k, L::add_registers(even, odd), a), early)
}

/// The sum over the three directions.
#[inline(always)]
pub(crate) fn total<L: Layout>(vector: &L::Vector) -> L::Scalar {
    let [x, y, z] = L::parts(vector);
    (x + y) + z
}
