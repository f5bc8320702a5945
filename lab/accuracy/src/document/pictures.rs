//! The part of the document about pictures: one table of programs, and one of scenes.

use std::fmt::Write as _;

use oracle::{ULPS, WELL_CONDITIONED};

use super::table::{Table, figure};
use super::{origin, shown};
use crate::output::Document;
use crate::pictures::{ANTIALIASED_CONTRAST, PictureRow, STANDARD, programs};
use crate::plots::Plot;
use crate::run::Results;
use crate::search::KeptRow;
use crate::totals::Total;

/// The goals: the largest excess, and the backward error that 99 % of the wrong pixels do not
/// exceed.
const MOST_EXCESS: f64 = 1.5;
/// As for [`MOST_EXCESS`].
const MOST_ULPS: u32 = 8;

const READING: &str = "
- *wrong*: a channel is off by more than 1/255 from the reference in double precision (`lab/oracle/`).
- *floor*: the wrong pixels of the reference itself if its scene is rounded to singles, and if each ray's point,
  direction and normal are truncated to singles. No tracer with such records can be expected to do better.
- *excess*: wrong pixels over floor. Below a floor of 8 pixels chance decides it, and the table has none.
- *backward error*: the units in the last place by which the numbers of rays must be off for a wrong pixel to be right.
";

/// The text of the part.
pub fn text(document: &Document, plots: &[Plot]) -> String {
    let results = &document.results;
    let mut text = origin(document);
    text.push_str(&shown(plots, "pictures"));
    let totals = results.totals();
    let table = Table::of(
        &totals,
        &[
            ("program", |(name, _)| (*name).to_owned()),
            ("Mcycles", |(_, total)| figure(total.cycles / 1e6)),
            ("wrong, %", |(_, total)| figure(total.percent(total.wrong_pixels))),
            ("excess", |(_, total)| option(total.excess())),
            ("RMSE, 1/255", |(_, total)| figure(total.rmse())),
            ("backward error within 1 ulp, %", |(_, total)| within(total, 1)),
            ("8", |(_, total)| within(total, 8)),
            ("64", |(_, total)| within(total, 64)),
            ("well-conditioned, %", |(_, total)| {
                percent(total.well_conditioned, total.by_ulps.iter().sum())
            }),
        ],
    );
    let floor = totals.first().map_or(0.0, |(_, total)| total.percent(total.floor));
    let scenes = results.pictures_by(STANDARD).count();
    let size = results.pictures.first().map_or((0, 0), |row| (row.width, row.height));
    _ = write!(
        text,
        "\nOne picture of {}x{} of each of {scenes} scenes by six SPUs, with one sample a pixel in \
         linear light. The floor is {} %.\n\n{table}{READING}\
         - *well-conditioned*: turning the ray from the eye by 8 ulp moves no channel by more than \
         1/255: the condition\n  number, change of a channel over angle, is below \
         {WELL_CONDITIONED:.0}. If such a pixel is wrong, the tracer is at fault.\n",
        size.0,
        size.1,
        figure(floor)
    );
    text.push_str(&verdict(results));
    _ = write!(text, "\n{}", scenes_table(results));
    if let Some(KeptRow { scene, wrong_pixels, floor }) = results.kept.first() {
        _ = writeln!(
            text,
            "\nThe worst of {} small scenes that `cellray-bench search` has found \
             (`lab/accuracy/regressions/pictures`): `{scene}`, {wrong_pixels} wrong pixels, floor {floor}.",
            results.kept.len()
        );
    }
    for row in &results.antialiased {
        let share = 100.0 * row.wrong_pixels as f64 / f64::from(row.width * row.height);
        _ = writeln!(
            text,
            "\n`{}` at {}x{} with 16 samples at a contrast of {ANTIALIASED_CONTRAST}, in sRGB: \
             {} wrong pixels, {share:.4} %.",
            row.scene, row.width, row.height, row.wrong_pixels
        );
    }
    text
}

/// Whether the goals are reached by the program that `cellray` takes without options.
fn verdict(results: &Results) -> String {
    let rows: Vec<&PictureRow> = results.pictures_by(STANDARD).collect();
    let measured = rows.iter().filter_map(|row| Some((row, Total::of([*row]).excess()?)));
    let (over, within): (Vec<_>, Vec<_>) = measured.partition(|(_, excess)| *excess > MOST_EXCESS);
    let list = |over: Vec<(&&PictureRow, f64)>| {
        let named = over.iter().map(|(row, excess)| format!("{} {excess:.1}", row.scene));
        named.collect::<Vec<_>>().join(", ")
    };
    let total = Total::of(rows.iter().copied());
    let mut text = format!(
        "\nGoals for *{STANDARD}*. An excess of at most {MOST_EXCESS}: {} of {} scenes with a floor of 8 \
         pixels or more reach it",
        within.len(),
        within.len() + over.len()
    );
    if !over.is_empty() {
        _ = write!(text, ", but not {}", list(over));
    }
    let reached = match total.ulps_of_99_percent() {
        Some(ulps) if ulps <= MOST_ULPS => format!("reached, it is {ulps} ulp"),
        Some(ulps) => format!("missed, it is {ulps} ulp"),
        None => format!("missed, it is more than {} ulp", ULPS[ULPS.len() - 1]),
    };
    let well = total.well_conditioned;
    _ = writeln!(
        text,
        ". A backward error of 99 % of the wrong pixels of at most {MOST_ULPS} ulp: {reached}. No wrong \
         pixel that is well-conditioned: {}.",
        if well == 0 { "reached".to_owned() } else { format!("missed, there are {well}") }
    );
    text
}

/// A row for each scene, which compares the programs.
fn scenes_table(results: &Results) -> Table {
    let of_programs = |what: &str| programs().map(|(name, _)| format!("{what}{name}"));
    let [wrong, cycles] = ["wrong: ", "Mcycles: "].map(of_programs);
    let middle = ["excess", "RMSE", "ulps: 1", "8", "64", "more", "well-conditioned"];
    let head = ["scene", "floor"].into_iter();
    let head = head.chain(wrong.iter().map(String::as_str)).chain(middle);
    let mut table = Table::new(head.chain(cycles.iter().map(String::as_str)));
    for row in results.pictures_by(STANDARD) {
        let of_scene = || {
            let same = |other: &&PictureRow| other.scene == row.scene;
            programs().map(|(name, _)| results.pictures_by(name).find(same))
        };
        let total = Total::of([row]);
        let up_to = |low: u32, high: u32| {
            let pairs = ULPS.iter().zip(row.by_ulps);
            let within = pairs.filter(|(ulps, _)| (low + 1..=high).contains(ulps));
            within.map(|(_, pixels)| pixels).sum::<u64>().to_string()
        };
        let wrong = |row: Option<&PictureRow>| {
            row.map_or_else(String::new, |row| row.wrong_pixels.to_string())
        };
        let cycles =
            |row: Option<&PictureRow>| row.map_or_else(String::new, |row| figure(row.cycles / 1e6));
        let front = [row.scene.clone(), row.floor.to_string()].into_iter();
        let middle = [
            option(total.excess()),
            figure(row.rmse),
            up_to(0, 1),
            up_to(1, 8),
            up_to(8, 64),
            row.by_ulps[ULPS.len()].to_string(),
            row.well_conditioned.to_string(),
        ];
        table.row(front.chain(of_scene().map(wrong)).chain(middle).chain(of_scene().map(cycles)));
    }
    table
}

fn option(value: Option<f64>) -> String {
    value.map_or_else(String::new, |value| format!("{value:.1}"))
}

fn percent(part: u64, whole: u64) -> String {
    if whole == 0 { String::new() } else { figure(100.0 * part as f64 / whole as f64) }
}

/// The share of the explained pixels with a backward error of at most this many units.
fn within(total: &Total, most: u32) -> String {
    let pairs = ULPS.iter().zip(total.by_ulps).filter(|(ulps, _)| **ulps <= most);
    percent(pairs.map(|(_, pixels)| pixels).sum(), total.by_ulps.iter().sum())
}
