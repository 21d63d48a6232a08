//! Exact motion of the spherical pendulum.
