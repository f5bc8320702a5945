//! cellray.
