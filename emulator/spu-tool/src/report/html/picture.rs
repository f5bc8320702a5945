//! The picture of a schedule, as SVG: one path for each kind of mark, which keeps pages small.

use std::fmt::Write as _;

use spu_isa::Pipe;
use spu_isa::timing::Issue;

/// The width of a cycle in pixels.
const WIDTH: u64 = 11;
/// The height of a row in pixels. `style.css` has the same.
const HEIGHT: u64 = 18;
/// The height of the numbers and of the strip of pipes above a picture.
const HEAD: u64 = 32;
/// Every how many cycles a number stands. `style.css` draws its grid at the same distance.
pub(super) const NUMBERED: u64 = 4;

/// The part of a schedule that a picture shows.
pub(super) struct Frame {
    /// The cycle of the first column.
    pub base: u64,
    /// The number of columns, one a cycle.
    pub columns: u64,
    /// The number of rows.
    pub rows: usize,
}

pub(super) struct Entry<'a> {
    /// Its row.
    pub row: usize,
    /// How it issued.
    pub issue: &'a Issue,
    /// Where the operand that it waited for comes from.
    pub link: Option<Link>,
}

/// Where an operand comes from.
#[derive(Clone, Copy)]
pub(super) enum Link {
    /// The instruction in this row.
    Row(usize),
    /// An instruction above the picture, or one of the pass before.
    Above,
}

impl Frame {
    fn x(&self, cycle: u64) -> u64 {
        cycle.saturating_sub(self.base) * WIDTH
    }

    fn y(&self, row: usize) -> u64 {
        row as u64 * HEIGHT
    }

    fn width(&self) -> u64 {
        self.columns * WIDTH
    }
}

/// The paths of one picture, by what they show.
#[derive(Default)]
struct Paths {
    even: String,
    odd: String,
    even_flight: String,
    odd_flight: String,
    waits: String,
    lost: String,
    pairs: String,
    links: String,
    links_above: String,
}

/// Appends a rectangle to a path. Writing to a string can't fail.
fn rectangle(path: &mut String, x: u64, y: u64, width: u64, height: u64) {
    let _ = write!(path, "M{x} {y}h{width}v{height}h-{width}z");
}

fn path(text: &mut String, class: &str, path: &str) {
    if !path.is_empty() {
        let _ = write!(text, "<path class=\"{class}\" d=\"{path}\"/>");
    }
}

/// Starts a picture. Its caller appends the end, `</svg>`.
pub(super) fn open(text: &mut String, frame: &Frame) {
    let (width, height) = (frame.width(), frame.rows as u64 * HEIGHT);
    let _ = write!(text, "<svg width=\"{width}\" height=\"{height}\">");
}

pub(super) fn entries(text: &mut String, frame: &Frame, entries: &[Entry]) {
    let mut paths = Paths::default();
    let mut before: Option<&Entry> = None;
    for entry in entries {
        let issue = entry.issue;
        let (x, y) = (frame.x(issue.cycle), frame.y(entry.row));
        let (issued, flight) = match issue.pipe {
            Pipe::Even => (&mut paths.even, &mut paths.even_flight),
            Pipe::Odd => (&mut paths.odd, &mut paths.odd_flight),
        };
        rectangle(issued, x, y + 2, WIDTH, HEIGHT - 4);
        let in_flight = issue.ready_cycle.saturating_sub(issue.cycle + 1);
        if in_flight > 0 {
            rectangle(flight, x + WIDTH, y + 5, in_flight * WIDTH, HEIGHT - 10);
        }
        let waited = issue.waited_cycles.min(issue.cycle);
        if waited > 0 {
            let from = frame.x(issue.cycle - waited);
            rectangle(&mut paths.waits, from, y + 2, x - from, HEIGHT - 4);
        } else if issue.waited.is_some() {
            let from = frame.x(issue.cycle.saturating_sub(1));
            rectangle(&mut paths.lost, from + 1, y + 6, WIDTH - 2, HEIGHT - 12);
        }
        if let Some(before) = before.filter(|_| issue.dual) {
            let middle = x + WIDTH / 2;
            let (top, bottom) = (frame.y(before.row) + HEIGHT / 2, y + HEIGHT / 2);
            let _ = write!(paths.pairs, "M{middle} {top}V{bottom}");
        }
        match entry.link {
            Some(Link::Row(from)) => {
                let top = frame.y(from) + HEIGHT / 2;
                let _ = write!(paths.links, "M{x} {top}V{y}");
            }
            Some(Link::Above) => {
                let _ = write!(paths.links_above, "M{x} 0V{y}");
            }
            None => {}
        }
        before = Some(entry);
    }
    path(text, "flight e", &paths.even_flight);
    path(text, "flight o", &paths.odd_flight);
    path(text, "wait", &paths.waits);
    path(text, "lost", &paths.lost);
    path(text, "link above", &paths.links_above);
    path(text, "link", &paths.links);
    path(text, "e", &paths.even);
    path(text, "o", &paths.odd);
    path(text, "pair", &paths.pairs);
}

/// Marks the bound of a loop, if it is within the picture.
pub(super) fn bound(text: &mut String, frame: &Frame, cycles: u64) {
    if !(frame.base..=frame.base + frame.columns).contains(&cycles) {
        return;
    }
    let (x, bottom) = (frame.x(cycles), frame.rows as u64 * HEIGHT);
    path(text, "bound", &format!("M{x} 0V{bottom}"));
    let x = x + 3;
    let _ = write!(text, "<text class=\"bound\" x=\"{x}\" y=\"12\">bound {cycles}</text>");
}

/// Marks the cycles after the last instruction in which nothing issues.
pub(super) fn miss(text: &mut String, frame: &Frame, from: u64, cycles: u64) {
    let mut miss = String::new();
    let y = frame.y(frame.rows - 1) + 2;
    rectangle(&mut miss, frame.x(from), y, cycles * WIDTH, HEIGHT - 4);
    path(text, "wait", &miss);
}

/// Draws what stands above a picture: the cycles' numbers, and which pipes issue in each cycle.
pub(super) fn head<'a>(text: &mut String, frame: &Frame, issues: impl Iterator<Item = &'a Issue>) {
    let _ = write!(text, "<svg width=\"{}\" height=\"{HEAD}\">", frame.width());
    let numbered = frame.base.next_multiple_of(NUMBERED)..frame.base + frame.columns;
    // A number needs the width of some columns.
    let fits = |cycle: &u64| cycle + 3 <= frame.base + frame.columns;
    for cycle in numbered.step_by(NUMBERED as usize).filter(fits) {
        let x = frame.x(cycle) + 1;
        let _ = write!(text, "<text x=\"{x}\" y=\"12\">{cycle}</text>");
    }
    let (mut even, mut odd) = (String::new(), String::new());
    for issue in issues {
        let (pipe, y) = match issue.pipe {
            Pipe::Even => (&mut even, HEAD - 14),
            Pipe::Odd => (&mut odd, HEAD - 7),
        };
        rectangle(pipe, frame.x(issue.cycle), y, WIDTH - 1, 6);
    }
    path(text, "e", &even);
    path(text, "o", &odd);
    text.push_str("</svg>");
}
