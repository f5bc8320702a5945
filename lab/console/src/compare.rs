//! A console's report against the model: what differs, row by row.

use std::fmt::Write as _;
use std::path::Path;

use cellray::framebuffer::{Geometry, Memory};
use cellray::spe::Program;
use cellray::{Report, Settings};
use clock::results::model;
use clock::rows;

use crate::Failure;
use crate::corners::{self, FACTS};
use crate::pictures::{self, engine, load};
use crate::report::{CHECKSUM, EMULATED, TITLE, Turning};

/// The path of the list of facts in the sources, for the patch.
const FACTS_FILE: &str = "lab/console/corners.txt";
/// The relative difference that a row may have if nobody has measured it on a console.
const BAND: f64 = 0.10;
/// Seconds of a frame that the PPE and the kernel may add to the SPUs' time.
const PPE: f64 = 1e-3;

/// What a comparison found.
pub struct Comparison {
    /// The text to print.
    pub text: String,
    /// How many rows, corners and pictures differ, and how many steps failed.
    pub differences: u32,
}

/// Compares a report with the model, with the list of facts, and with the pictures of this
/// machine. `folder` has the folder `scenes`. With `frames`, frames a second are compared, too;
/// this process must then run in simulated time.
///
/// # Errors
/// It is no report, its checksum is wrong, or a line can't be read.
pub fn compare(report: &str, folder: &Path, frames: bool) -> Result<Comparison, Failure> {
    check(report)?;
    let mut found = Comparison { text: String::new(), differences: 0 };
    if report.lines().any(|line| line.starts_with(EMULATED)) {
        writeln!(found.text, "note: {EMULATED}: the figures may be an emulator's")?;
    }
    found.rows(report)?;
    found.corners(report)?;
    if report.lines().any(|line| line.starts_with("picture ")) {
        found.pictures(report, &pictures::golden(folder)?)?;
    }
    if frames {
        found.frames(report, folder)?;
    }
    for line in report.lines().filter(|line| line.starts_with("failed: ")) {
        found.differs(line)?;
    }
    writeln!(found.text, "{} differences", found.differences)?;
    Ok(found)
}

/// Checks title and checksum.
fn check(report: &str) -> Result<(), Failure> {
    if !report.starts_with(TITLE) {
        return Err(format!("it does not begin with `{TITLE}`").into());
    }
    let at =
        report.rfind(&format!("\n{CHECKSUM}")).ok_or("it has no checksum: its end is missing")?;
    let (body, last) = report.split_at(at + 1);
    let stated = last.trim_start_matches(CHECKSUM).trim();
    let sum = format!("{:08x}", crc32fast::hash(body.as_bytes()));
    if stated != sum {
        return Err(format!("its checksum is {stated}, but its text has {sum}").into());
    }
    Ok(())
}

impl Comparison {
    fn differs(&mut self, line: &str) -> Result<(), Failure> {
        self.differences += 1;
        Ok(writeln!(self.text, "DIFFERS  {line}")?)
    }

    fn rows(&mut self, report: &str) -> Result<(), Failure> {
        let (model, rows) = (model(), rows::all());
        for (number, line) in report.lines().enumerate() {
            let Some(fields) = line.strip_prefix("clock ") else {
                continue;
            };
            let wrong = |what: &str| format!("line {}: {what}: {line}", number + 1);
            let mut fields = fields.splitn(3, ' ');
            let name = fields.next().unwrap_or_default();
            let value = fields.next().and_then(|value| value.parse::<f64>().ok());
            let value = value.ok_or_else(|| wrong("a row without a figure"))?;
            let unit = fields.next().unwrap_or_default();
            let expected = model.iter().find(|row| row.row == name);
            let expected = expected.ok_or_else(|| wrong("the model has no such row"))?.value;
            let band =
                rows.iter().find(|row| row.name == name).and_then(|row| row.console.as_ref());
            let band = band.map_or(BAND, |console| console.band);
            // A figure that is no number is out of every band.
            let within = (value / expected - 1.0).abs() <= band;
            let band = format!("{:.0} %", 100.0 * band);
            self.row(name, [value, expected], unit, &band, within)?;
        }
        Ok(())
    }

    /// Prints a figure beside the model's. One that is not `within` its band differs.
    fn row(
        &mut self,
        name: &str,
        [value, expected]: [f64; 2],
        unit: &str,
        band: &str,
        within: bool,
    ) -> Result<(), Failure> {
        let error = 100.0 * (value / expected - 1.0);
        let line = format!(
            "{name:<20} {value:>12.3}, model {expected:>12.3} {unit}, {error:+.1} %, band {band}"
        );
        match within {
            true => Ok(writeln!(self.text, "         {line}")?),
            false => self.differs(&line),
        }
    }

    /// Compares the frames of scenes that wait for no screen. Those of games depend on how many the
    /// console has made in its time.
    fn frames(&mut self, report: &str, folder: &Path) -> Result<(), Failure> {
        for (number, line) in report.lines().enumerate() {
            let Some((head, figures)) =
                line.strip_prefix("frames ").and_then(|line| line.split_once(": "))
            else {
                continue;
            };
            let wrong = || format!("line {}: no frames of a scene: {line}", number + 1);
            let words: Vec<_> = head.split(", ").collect();
            let [scene, how, size] = words[..] else { return Err(wrong().into()) };
            if how == "vsync" || scene.starts_with("of ") {
                continue;
            }
            let value = figures.split(' ').next().and_then(|value| value.parse().ok());
            let (value, size) = (value.ok_or_else(wrong)?, size.parse()?);
            let expected = simulated(folder, scene, size)?;
            let [time, model] = [value, expected].map(|rate: f64| 1.0 / rate);
            let within = time >= model * (1.0 - BAND) && time <= model * (1.0 + BAND) + PPE;
            let band = format!("{:.0} % of its time and {:.1} ms", 100.0 * BAND, 1e3 * PPE);
            self.row(scene, [value, expected], "frames/s of the SPUs", &band, within)?;
        }
        Ok(())
    }

    /// Prints what differs as a patch to the list of facts.
    fn corners(&mut self, report: &str) -> Result<(), Failure> {
        let mut patch = String::new();
        for line in report.lines().filter_map(|line| line.strip_prefix("corner ")) {
            let name = line.split(':').next().unwrap_or_default();
            let same = |fact: &&str| fact.split(':').next() == Some(name);
            let known = FACTS.lines().zip(1..).find(|(fact, _)| same(fact));
            let (fact, number) = known.ok_or_else(|| format!("no such corner: {line}"))?;
            if fact != line {
                self.differences += 1;
                writeln!(patch, "@@ -{number} +{number} @@\n-{fact}\n+{line}")?;
            }
        }
        if !patch.is_empty() {
            write!(self.text, "--- a/{FACTS_FILE}\n+++ b/{FACTS_FILE}\n{patch}")?;
        }
        Ok(())
    }

    fn pictures(&mut self, report: &str, golden: &str) -> Result<(), Failure> {
        for line in report.lines().filter(|line| line.starts_with("picture ")) {
            if !golden.lines().any(|known| known == line) {
                self.differs(line)?;
            }
        }
        Ok(())
    }
}

/// Frames a second of the model, for a scene whose eye turns.
fn simulated(folder: &Path, scene: &str, size: Geometry) -> Result<f64, Failure> {
    let mut views = Turning::new(load(folder, scene)?);
    let timeout = Settings::default().timeout;
    let mut engine = engine(Program::tracer(), timeout, Box::new(Memory::new(size)?))?;
    let spus = Settings::default().spus;
    let mut report = Report::new(scene, (size.width, size.height), spus);
    // The first frame finds the costs of tiles.
    engine.render(&views.next()?, &mut |_| ())?;
    report.add(engine.render(&views.next()?, &mut |_| ())?);
    Ok(report.frames_per_second)
}

/// The list of facts as this machine has it.
///
/// # Errors
/// The SPU program fails.
pub fn facts() -> Result<String, Failure> {
    Ok(corners::run()?.iter().map(|corner| format!("{corner}\n")).collect())
}
