//! The page as a whole.

use maud::{DOCTYPE, Markup, PreEscaped, html};

use crate::frame::FrameTimes;
use crate::{InspectError, Inspection, Statistic, kernels, maps, timelines};

const STYLE: &str = include_str!("style.css");

pub(crate) fn page(inspection: &Inspection) -> Result<String, InspectError> {
    let times = FrameTimes::new(inspection)?;
    let (width, height) = inspection.size;
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { "A frame of " (inspection.scene) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                h1 { "A frame of " code { (inspection.scene) } }
                p {
                    (width) "x" (height) " pixels on " (times.spus.len()) " SPUs. All times are "
                    "simulated cycles, the same in every run."
                }
                (maps::section(inspection, &times)?)
                (timelines::section(&times))
                (kernels::section(inspection)?)
                (statistics(inspection.statistics))
            }
        }
    };
    Ok(page.into_string())
}

/// The sums of the frame: what was done, and what was skipped and why.
fn statistics(statistics: &[Statistic]) -> Markup {
    let mut groups: Vec<&str> = statistics.iter().map(|it| it.group).collect();
    groups.dedup();
    html! {
        section {
            h2 { "Work done and work skipped" }
            table { @for group in groups {
                tbody {
                    tr { th colspan="3" { (group) } }
                    @for it in statistics.iter().filter(|it| it.group == group) {
                        tr { td { (it.name) } td.n { (it.value) } td { (it.meaning) } }
                    }
                }
            } }
        }
    }
}
