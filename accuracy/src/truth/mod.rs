//! What is exactly so of a ray and an object, for the very singles that a kernel is given.
