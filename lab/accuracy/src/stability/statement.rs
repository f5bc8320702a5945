//! Bounds that kernels' headers state.
//!
//! Invariant: no number from a header is repeated in this code. If a header no longer contains it,
//! that is an error.

use crate::stability::prelude::*;

/// The bound of an error and its source.
#[derive(Clone, Debug, PartialEq)]
pub struct Bound {
    /// The largest error that is allowed.
    pub value: f64,
    /// The source of the number.
    pub source: String,
}

/// A header does not contain an expected statement.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum StatementError {
    /// There is no such kernel, or its header does not have the project's format.
    #[error("there is no kernel {0} with a header")]
    NoHeader(String),
    /// The number is missing.
    #[error("the header of {kernel} has no number before \"{phrase}\" in its statement of error")]
    NoNumber {
        /// The kernel's name.
        kernel: String,
        /// The words that should follow the number.
        phrase: String,
    },
}

impl Bound {
    /// The first number in a kernel's statement of error.
    pub fn of(kernel: &str) -> Result<Self, StatementError> {
        Self::before(kernel, "")
    }

    /// The number before these words in the statement.
    pub fn before(kernel: &str, phrase: &str) -> Result<Self, StatementError> {
        let value = stated(kernel, phrase)?;
        let source = format!("header of {kernel}");
        Ok(Self { value, source })
    }

    /// No case may be wrong at all.
    pub fn none(source: &str) -> Self {
        Self { value: 0.0, source: source.to_owned() }
    }
}

/// The number before these words in a kernel's statement of error. If the words are empty, the
/// first number.
pub fn stated(kernel: &str, phrase: &str) -> Result<f64, StatementError> {
    let header = Source::find(kernel).and_then(Source::header);
    let header = header.ok_or_else(|| StatementError::NoHeader(kernel.to_owned()))?;
    number_before(&header.error, phrase).ok_or_else(|| StatementError::NoNumber {
        kernel: kernel.to_owned(),
        phrase: phrase.to_owned(),
    })
}

/// Whether a kernel's statement of error contains these words.
pub fn states(kernel: &str, phrase: &str) -> bool {
    let header = Source::find(kernel).and_then(Source::header);
    header.is_some_and(|header| header.error.contains(phrase))
}

fn number_before(text: &str, phrase: &str) -> Option<f64> {
    let number = |word: &str| word.trim_end_matches([',', ';', ':']).parse().ok();
    if phrase.is_empty() {
        return text.split_whitespace().find_map(number);
    }
    let (before, _) = text.split_once(&format!(" {phrase}"))?;
    before.split_whitespace().next_back().and_then(number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn number_is_found_before_phrase() {
        let text = "25 ulp of t, origin up to 30 radii off, ray within 0.995 r of it";
        assert_eq!(number_before(text, ""), Some(25.0));
        assert_eq!(number_before(text, "radii"), Some(30.0));
        assert_eq!(number_before(text, "r of it"), Some(0.995));
        assert_eq!(number_before(text, "miles"), None);
        assert_eq!(number_before("about ulp", "ulp"), None);
    }

    #[test]
    fn missing_statement_names_kernel_and_phrase() {
        let error = Bound::of("isect_nothing").expect_err("no such kernel");
        assert_eq!(error.to_string(), "there is no kernel isect_nothing with a header");
        let error = stated("refract_r16", "furlongs").expect_err("no such number");
        assert!(error.to_string().contains("furlongs"), "{error}");
    }
}
