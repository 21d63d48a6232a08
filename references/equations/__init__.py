"""Reference motions of equations that have no closed form."""
