//! Arithmetic underneath: vectors of the processor and their lanes, double-double numbers, numbers with derivatives, the
//! arithmetic-geometric mean, angles in turns, elliptic arguments.

pub(crate) mod arithmetic;
pub(crate) mod double_double;
pub(crate) mod dual;
pub(crate) mod elliptic;
pub(crate) mod landen;
pub(crate) mod lanes;
pub(crate) mod polynomial;
pub(crate) mod roots;
pub(crate) mod turns;
