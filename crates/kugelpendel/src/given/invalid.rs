//! What is said when a pendulum, a launch or a request makes no sense.

use std::fmt;

/// A sentence: what was wrong, the value seen, the way out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Invalid(pub String);

impl fmt::Display for Invalid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Invalid {}

/// `Err(Invalid(format!(…)))` unless the condition holds.
macro_rules! require {
    ($condition:expr, $($sentence:tt)+) => {
        // A NaN fails every condition, which is what is wanted.
        let holds: bool = $condition;
        if !holds {
            return Err($crate::given::invalid::Invalid(format!($($sentence)+)));
        }
    };
}
pub(crate) use require;
