//! The core's face for a web page: C functions over WebAssembly's memory, written by hand, since a module without imports
//! needs no generator of bindings.
//!
//! Numbers of a call go in and out through one fixed place, [`exchange::exchange`]; many of them lie in memory that the page
//! asks for. Motions and traces are handles, which the page gives back. Nothing here computes: it passes on.

pub mod exchange;
pub mod given;
pub mod meaning;
pub mod memory;
pub mod motion;
pub mod plane;
pub mod trace;
