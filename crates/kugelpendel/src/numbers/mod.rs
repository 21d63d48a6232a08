//! Arithmetic underneath: vectors of the processor, double-double numbers, angles in turns, elliptic arguments.

pub(crate) mod arithmetic;
pub(crate) mod double_double;
pub(crate) mod elliptic;
pub(crate) mod polynomial;
pub(crate) mod roots;
pub(crate) mod turns;
