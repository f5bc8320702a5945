//! Reciprocals and roots: cycles against error over every fraction that an operand can have.

use kernels::Bench;
use kernels::cases::math::{self, Function, Quantity};
use kernels::cases::spheres::cycles_a_ray;
use kernels::catalogue;
use kernels::measure::host_nanoseconds;
use serde::{Deserialize, Serialize};

use crate::metrics::Summary;
use crate::parallel;

/// A kernel of `math`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RootRow {
    /// The kernel.
    pub kernel: String,
    /// The function that it computes.
    pub quantity: String,
    /// Simulated cycles for each operand of a long array.
    pub cycles_an_operand: f64,
    /// The host interpreter's time for the same, in nanoseconds.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub host_ns_an_operand: Option<f64>,
    /// The number of operands over which errors were measured: all fractions of one or two
    /// octaves.
    pub operands: usize,
    /// The error in ulps.
    pub ulps: Summary,
    /// The first operand with the largest error, in hex.
    pub worst: String,
}

/// Measures all of these kernels.
///
/// # Panics
///
/// Panics if the catalogue lacks one of them.
pub fn measure(with_host_time: bool) -> Vec<RootRow> {
    let mut rows = parallel::map(&math::FUNCTIONS, Bench::new, of_function);
    if with_host_time {
        // One after the other, because parallel runs would slow each other down.
        let mut bench = Bench::new();
        for row in &mut rows {
            row.host_ns_an_operand = host_time(&mut bench, &row.kernel);
        }
    }
    rows
}

fn of_function(bench: &mut Bench, function: &Function) -> RootRow {
    let cycles = cycles_a_ray(bench, function.kernel);
    let accuracy = math::error::accuracy(function);
    let quantity = match function.quantity {
        Quantity::Reciprocal => "1/x",
        Quantity::ReciprocalRoot => "1/sqrt(x)",
        Quantity::Root => "sqrt(x)",
    };
    RootRow {
        kernel: function.kernel.to_owned(),
        quantity: quantity.to_owned(),
        cycles_an_operand: cycles.expect("the catalogue contains the kernel"),
        host_ns_an_operand: None,
        operands: function.quantity.all_fractions().count(),
        ulps: Summary { max: accuracy.largest, mean: accuracy.mean, p999: accuracy.most },
        worst: format!("{:08x}", accuracy.worst),
    }
}

/// The host interpreter's nanoseconds for each ray or operand, for a kernel in the catalogue.
pub(crate) fn host_time(bench: &mut Bench, kernel: &str) -> Option<f64> {
    let kernel = catalogue::kernels().find(|known| known.name == kernel)?;
    host_nanoseconds(bench, kernel)
}
