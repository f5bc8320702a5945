//! NFF.
