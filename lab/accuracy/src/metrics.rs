//! Statistics of many errors.

use serde::{Deserialize, Serialize};

/// A summary of errors.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// The largest.
    pub max: f64,
    /// The mean.
    pub mean: f64,
    /// The smallest value that 99.9 % of the errors do not exceed.
    pub p999: f64,
}

impl Summary {
    /// The summary of these errors, or `None` if there are none.
    pub fn of(mut errors: Vec<f64>) -> Option<Self> {
        let mean = errors.iter().sum::<f64>() / errors.len() as f64;
        errors.sort_unstable_by(f64::total_cmp);
        Some(Self {
            max: *errors.last()?,
            mean,
            p999: errors[(errors.len() * 999).div_ceil(1000) - 1],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentiles_are_nearest_ranks() {
        // The numbers 1 to 2000 in some order: 99.9 % of them are at most 1998.
        let errors = (0..2000).map(|n| f64::from(n * 1237 % 2000 + 1));
        let summary = Summary::of(errors.collect()).unwrap();
        let expected = Summary { max: 2000.0, mean: 1000.5, p999: 1998.0 };
        assert_eq!(summary, expected);
    }

    #[test]
    fn summary_of_one_error_and_of_none() {
        let summary = Summary::of(vec![3.0]).unwrap();
        assert_eq!((summary.max, summary.mean, summary.p999), (3.0, 3.0, 3.0));
        assert_eq!(Summary::of(Vec::new()), None);
    }
}
