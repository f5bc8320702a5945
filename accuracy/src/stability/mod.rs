//! The stress suite: inputs that single precision is worst at, and the bounds that hold there.
