//! The timelines of the SPUs: tiles, waits, and what the MFCs move.

use std::fmt::Write as _;

use maud::{Markup, PreEscaped, html};

use crate::frame::{FrameTimes, Spu, overlap};
use crate::maps::SPU_COLOURS;

/// The width of a timeline in pixels. Activities shorter than a pixel are added up.
const WIDTH: u64 = 1200;
/// The rows of a timeline: where each begins, and its height.
const TILES: (u64, u64) = (0, 16);
const WAITS: (u64, u64) = (18, 14);
const MOVED: (u64, u64) = (34, 16);
/// The height of a timeline, with the space below.
const HEIGHT: u64 = 56;
/// The width of the SPU's name.
const LEFT: u64 = 60;

/// A group of causes for which an SPU sleeps.
struct State {
    /// Its class in the style sheet.
    class: &'static str,
    name: &'static str,
    meaning: &'static str,
    /// The causes; work has none.
    causes: &'static [&'static str],
}

const STATES: [State; 4] = [
    State {
        class: "idle",
        name: "idle",
        meaning: "waits for a frame, or is done with this one",
        causes: &["mailbox", "signal", "event"],
    },
    State {
        class: "dma",
        name: "DMA waits",
        meaning: "waits for DMA",
        causes: &["tag", "list", "queue"],
    },
    State {
        class: "counter",
        name: "counter waits",
        meaning: "waits for the counter of work units",
        causes: &["atomic"],
    },
    State { class: "work", name: "at work", meaning: "works", causes: &[] },
];

/// The part of the page with the timelines.
pub(crate) fn section(times: &FrameTimes) -> Markup {
    let mut text = String::new();
    let height = HEIGHT * times.spus.len() as u64 + 20;
    // Writing to a string can't fail.
    let _ = write!(
        text,
        "<svg class=\"timelines\" width=\"{}\" height=\"{height}\">",
        LEFT + WIDTH + 10
    );
    let most = most_moved(times);
    for (number, spu) in times.spus.iter().enumerate() {
        lane(&mut text, times, number, spu, most);
    }
    axis(&mut text, times, height - 20);
    text.push_str("</svg>");
    let milliseconds = 1e3 * times.cycles as f64 / times.cycles_per_second.max(1) as f64;
    html! {
        section {
            h2 { "The SPUs in time" }
            p {
                "The frame took " strong { (grouped(times.cycles)) " cycles" } ", "
                (format!("{milliseconds:.2}")) " ms at a console's clock, from the first SPU's first "
                "command to the last SPU's last transfer."
            }
            div.scroll { (PreEscaped(text)) }
            p.remark {
                "The upper row of an SPU has its tiles, light and dark in turn. The middle row is what "
                "it does: "
                @for state in &STATES { span.swatch.(state.class) {} " " (state.meaning) ". " }
                "The lower row is what its MFC moves in each pixel's time, "
                span.swatch.in {} " into local store, " span.swatch.out {} " out of it; the "
                "longest bar is " (grouped(most as u64)) " bytes. A pixel is " (grouped(times.cycles.div_ceil(WIDTH))) " cycles; what is "
                "shorter is added up."
            }
            (shares(times))
        }
    }
}

/// The time of each SPU by what it did.
fn shares(times: &FrameTimes) -> Markup {
    html! {
        table {
            thead { tr {
                th { "SPU" } th.n { "tiles" }
                @for state in &STATES { th.n { (state.name) } }
                th.n { "bytes in" } th.n { "bytes out" }
            } }
            tbody { @for (number, spu) in times.spus.iter().enumerate() { tr {
                td { (number) }
                td.n { (spu.tiles.len()) }
                @for part in states(times, spu, 1)[0] {
                    td.n { (format!("{:.1} %", 100.0 * part as f64 / times.cycles as f64)) }
                }
                @for kind in ["get", "put"] { td.n { (grouped(sum(spu, kind))) } }
            } } }
        }
    }
}

/// The most bytes that an SPU moves one way in a pixel's time.
fn most_moved(times: &FrameTimes) -> f64 {
    let kinds = |spu| ["get", "put"].map(|kind| moved(times, spu, kind, WIDTH));
    let all = times.spus.iter().flat_map(kinds).flatten();
    all.fold(1.0, f64::max)
}

/// The bytes that an SPU's transfers of a kind move.
fn sum(spu: &Spu, kind: &str) -> u64 {
    let those = spu.transfers.iter().filter(|transfer| transfer.kind == kind);
    those.map(|transfer| transfer.bytes).sum()
}

/// Where a time is divided: the first and last piece of `pieces` that a range of cycles touches.
fn touched(times: &FrameTimes, pieces: u64, (start, end): (u64, u64)) -> std::ops::Range<u64> {
    let piece = |cycle: u64| (cycle * pieces / times.cycles).min(pieces);
    let first = piece(start).saturating_sub(1);
    first..(piece(end) + 1).min(pieces)
}

/// The cycles of one of `pieces` equal pieces of the frame.
fn piece(times: &FrameTimes, pieces: u64, at: u64) -> (u64, u64) {
    let cycle = |at: u64| times.cycles * at / pieces;
    (cycle(at), cycle(at + 1))
}

/// For each of `pieces` equal pieces of the frame, its cycles by what the SPU did, in the order of
/// [`STATES`]. The time before its first command and after its last one is idle, asleep or not.
fn states(times: &FrameTimes, spu: &Spu, pieces: u64) -> Vec<[u64; 4]> {
    let mut states = vec![[0; 4]; pieces as usize];
    let first = spu.transfers.iter().map(|first| first.start).min();
    let last = spu.transfers.iter().map(|last| last.end).max();
    let (first, last) = (first.unwrap_or(times.cycles), last.unwrap_or(0));
    let mut add = |(start, end): (u64, u64), state: usize| {
        for at in touched(times, pieces, (start, end)) {
            states[at as usize][state] += overlap((start, end), piece(times, pieces, at));
        }
    };
    add((0, first), 0);
    add((last.max(first), times.cycles), 0);
    for sleep in &spu.sleeps {
        let among = |state: &State| state.causes.contains(&sleep.cause.as_str());
        let state = STATES.iter().position(among).unwrap_or(0);
        let within = (sleep.start.max(first), sleep.end.min(last));
        add(within, state);
    }
    for (at, state) in states.iter_mut().enumerate() {
        let (from, to) = piece(times, pieces, at as u64);
        state[3] = (to - from).saturating_sub(state.iter().sum());
    }
    states
}

/// For each of `pieces` equal pieces of the frame, the bytes that transfers of a kind move, each
/// at a steady rate.
fn moved(times: &FrameTimes, spu: &Spu, kind: &str, pieces: u64) -> Vec<f64> {
    let mut moved = vec![0.0; pieces as usize];
    for transfer in spu.transfers.iter().filter(|it| it.kind == kind) {
        let range = (transfer.start, transfer.end);
        let rate = transfer.bytes as f64 / (transfer.end - transfer.start).max(1) as f64;
        for at in touched(times, pieces, range) {
            moved[at as usize] += rate * overlap(range, piece(times, pieces, at)) as f64;
        }
    }
    moved
}

fn lane(text: &mut String, times: &FrameTimes, number: usize, spu: &Spu, most: f64) {
    let y = HEIGHT * number as u64;
    let x = |cycle: u64| LEFT as f64 + cycle as f64 * WIDTH as f64 / times.cycles as f64;
    let _ = write!(text, "<text x=\"0\" y=\"{}\">SPU {number}</text>", y + 13);
    let colour = SPU_COLOURS[number % SPU_COLOURS.len()];
    for (at, tile) in spu.tiles.iter().enumerate() {
        let _ = write!(
            text,
            "<rect x=\"{:.1}\" y=\"{}\" width=\"{:.1}\" height=\"{}\" fill=\"{colour}\" opacity=\"{}\"><title>tile {}: {} cycles from {}, {} asleep</title></rect>",
            x(tile.start),
            y + TILES.0,
            x(tile.end) - x(tile.start),
            TILES.1,
            if at % 2 == 0 { "1" } else { ".6" },
            tile.number,
            grouped(tile.cycles()),
            grouped(tile.start),
            grouped(tile.slept)
        );
    }
    draw_states(text, times, spu, y + WAITS.0);
    draw_bytes(text, times, spu, y + MOVED.0, most);
}

/// The SPU's states as bars, each of which has its share of the pixel's height.
fn draw_states(text: &mut String, times: &FrameTimes, spu: &Spu, y: u64) {
    let mut paths: [String; 4] = Default::default();
    for (at, parts) in states(times, spu, WIDTH).into_iter().enumerate() {
        let whole = parts.iter().sum::<u64>().max(1) as f64;
        let mut top = y as f64;
        for (path, part) in paths.iter_mut().zip(parts) {
            if part > 0 {
                let height = WAITS.1 as f64 * part as f64 / whole;
                let _ = write!(path, "M{} {top:.1}v{height:.1}", column(at));
                top += height;
            }
        }
    }
    for (path, state) in paths.iter().zip(&STATES) {
        draw(text, state.class, path);
    }
}

/// The bytes of each pixel's time: in upwards from the middle, out downwards.
fn draw_bytes(text: &mut String, times: &FrameTimes, spu: &Spu, y: u64, most: f64) {
    let half = MOVED.1 as f64 / 2.0;
    let middle = y + MOVED.1 / 2;
    for (kind, class, sign) in [("get", "in", "-"), ("put", "out", "")] {
        let mut path = String::new();
        for (at, bytes) in moved(times, spu, kind, WIDTH).into_iter().enumerate() {
            if bytes > 0.0 {
                let height = (half * bytes / most).clamp(0.5, half);
                let _ = write!(path, "M{} {middle}v{sign}{height:.1}", column(at));
            }
        }
        draw(text, class, &path);
    }
}

/// The middle of a column of pixels.
fn column(at: usize) -> f64 {
    LEFT as f64 + at as f64 + 0.5
}

fn draw(text: &mut String, class: &str, path: &str) {
    if !path.is_empty() {
        let _ = write!(text, "<path class=\"{class}\" d=\"{path}\"/>");
    }
}

fn axis(text: &mut String, times: &FrameTimes, y: u64) {
    for tenth in 0..=10 {
        let x = LEFT + WIDTH * tenth / 10;
        let cycle = grouped(times.cycles * tenth / 10);
        let anchor = if tenth == 10 { "end" } else { "middle" };
        let _ = write!(
            text,
            "<path class=\"tick\" d=\"M{x} 0V{y}\"/><text x=\"{x}\" y=\"{}\" text-anchor=\"{anchor}\">{cycle}</text>",
            y + 14
        );
    }
}

/// A number with a thin space between thousands.
pub(crate) fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            text.push('\u{2009}');
        }
        text.push(digit);
    }
    text
}
