//! Places the overlay's parts on a display. The unit is whatever the display is made of: pixels, or
//! the characters of a terminal.
//!
//! Invariants: a part that doesn't fit is moved inwards and cut off, never placed outside. Labels
//! cover neither a panel nor one another.

use cellray::game::{PlacedLabel, Side};
use textwrap::Options;

use crate::overlay::{Line, Overlay};

/// Where a panel is placed, if it fits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    TopLeft,
    TopRight,
    Centre,
    Bottom,
}

/// A rectangle with some lines of text.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Where it is placed.
    pub anchor: Anchor,
    /// The lines, none longer than the display is wide.
    pub lines: Vec<Line>,
    /// Loads to draw as bars below the lines, 0 to 1.
    pub loads: Vec<f32>,
    /// 0 for invisible to 1.
    pub opacity: f32,
}

impl Panel {
    fn new(anchor: Anchor, lines: Vec<Line>) -> Self {
        Self { anchor, lines, loads: Vec::new(), opacity: 1.0 }
    }
}

/// A display as a grid of characters, in the display's units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grid {
    /// The display's width and height.
    pub area: (usize, usize),
    /// A character's width and height.
    pub cell: (usize, usize),
    /// The space between a panel's sides and its text, across and down.
    pub margin: (usize, usize),
    /// The width and height of the bar for a load; the width includes the space beside it.
    pub bar: (usize, usize),
    /// The left and top of the picture, and its width and height.
    pub picture: Rectangle,
}

impl Grid {
    /// The number of characters in the longest line that fits.
    fn columns(&self) -> usize {
        let width = self.area.0.saturating_sub(4 * self.margin.0);
        (width / self.cell.0).max(1)
    }

    fn size(&self, panel: &Panel) -> (usize, usize) {
        let longest = panel.lines.iter().map(|line| line.text.chars().count());
        let bars = panel.loads.len() * self.bar.0;
        let width = (longest.max().unwrap_or(0) * self.cell.0).max(bars);
        let below = match panel.loads.len() {
            0 => 0,
            _ => self.bar.1 + self.margin.1,
        };
        let height = panel.lines.len() * self.cell.1 + below;
        (width + 2 * self.margin.0, height + 2 * self.margin.1)
    }
}

/// A panel and its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed {
    pub panel: Panel,
    /// Its left and its top.
    pub corner: (usize, usize),
    /// Its width and height, no larger than the display.
    pub size: (usize, usize),
}

impl Placed {
    fn overlaps(&self, other: &Self) -> bool {
        overlap((self.corner, self.size), (other.corner, other.size))
    }
}

/// A left and a top, and a width and a height.
pub type Rectangle = ((usize, usize), (usize, usize));

fn overlap((corner, size): Rectangle, (other, others): Rectangle) -> bool {
    let meets = |from: usize, length: usize, other: usize, others: usize| {
        from < other + others && other < from + length
    };
    meets(corner.0, size.0, other.0, others.0) && meets(corner.1, size.1, other.1, others.1)
}

/// A label and its place on a display.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LabelAt {
    /// The text, shortened to fit.
    pub text: String,
    /// Red, green and blue.
    pub colour: [u8; 3],
    /// The left and the top of the first character.
    pub corner: (usize, usize),
    /// The width and height of the text.
    pub size: (usize, usize),
}

/// Places labels where they cover neither panels nor earlier labels, and leaves out the others.
pub fn place_labels(labels: &[PlacedLabel], panels: &[Placed], grid: Grid) -> Vec<LabelAt> {
    let mut all: Vec<LabelAt> = Vec::new();
    let ((left, top), (width, height)) = grid.picture;
    for label in labels {
        let most = grid.area.0 / grid.cell.0;
        let text: String = label.text.chars().take(most).collect();
        let size = (text.chars().count() * grid.cell.0, grid.cell.1);
        if text.is_empty() || size.1 > grid.area.1 {
            continue;
        }
        let along = |part: f32, from: usize, length: usize| from + (part * length as f32) as usize;
        let (x, y) = (along(label.place[0], left, width), along(label.place[1], top, height));
        // Half a character is free between a text and its place.
        let gap = grid.cell.0 / 2;
        let (across, down) = (x.saturating_sub(size.0 / 2), y.saturating_sub(size.1 / 2));
        let corner = match label.side {
            Side::Over => (across, down),
            Side::Left => (x.saturating_sub(size.0 + gap), down),
            Side::Right => (x + gap, down),
            Side::Above => (across, y.saturating_sub(size.1)),
            // In a terminal the place itself is as large as a character.
            Side::Below => (across, y + 1),
        };
        let corner = (corner.0.min(grid.area.0 - size.0), corner.1.min(grid.area.1 - size.1));
        let is_free = panels
            .iter()
            .map(|panel| (panel.corner, panel.size))
            .chain(all.iter().map(|label| (label.corner, label.size)))
            .all(|other| !overlap((corner, size), other));
        if is_free {
            all.push(LabelAt { text, colour: label.colour, corner, size });
        }
    }
    all
}

/// The panels of the overlay's words: status, help, and why nothing moves.
pub fn words(overlay: &Overlay) -> Vec<Panel> {
    let status = overlay.status.iter().map(|line| line.as_str().into());
    let notice = overlay.notice.iter().map(Line::heading);
    let mut panels = vec![
        Panel::new(Anchor::TopRight, status.collect()),
        Panel::new(Anchor::Centre, overlay.help.clone()),
        Panel::new(Anchor::Centre, notice.collect()),
    ];
    panels.retain(|panel| !panel.lines.is_empty());
    panels
}

/// The panels of the whole overlay.
pub fn panels(overlay: &Overlay) -> Vec<Panel> {
    let mut panels = Vec::new();
    if !overlay.speeds.is_empty() || !overlay.loads.is_empty() {
        let lines = overlay.speeds.iter().map(|line| line.as_str().into());
        panels.push(Panel {
            loads: overlay.loads.clone(),
            ..Panel::new(Anchor::TopLeft, lines.collect())
        });
    }
    panels.extend(words(overlay));
    if let Some((message, opacity)) = &overlay.message {
        panels.push(Panel {
            opacity: *opacity,
            ..Panel::new(Anchor::Bottom, vec![message.as_str().into()])
        });
    }
    panels
}

/// Places panels, the most important last. A panel that would cover an earlier one goes below it,
/// or above it at the bottom. If it doesn't fit there either, the earlier one is left out.
pub fn place(panels: Vec<Panel>, grid: Grid) -> Vec<Placed> {
    let mut all: Vec<Placed> = Vec::new();
    for panel in panels {
        let panel = fitted(panel, grid);
        let (width, height) = grid.size(&panel);
        let size = (width.min(grid.area.0), height.min(grid.area.1));
        let free = (grid.area.0 - size.0, grid.area.1 - size.1);
        let inset = |free: usize, margin: usize| margin.min(free);
        let (near, far) = (
            (inset(free.0, grid.margin.0), inset(free.1, grid.margin.1)),
            (free.0.saturating_sub(grid.margin.0), free.1.saturating_sub(grid.margin.1)),
        );
        let corner = match panel.anchor {
            Anchor::TopLeft => near,
            Anchor::TopRight => (far.0, near.1),
            Anchor::Centre => (free.0 / 2, free.1 / 2),
            Anchor::Bottom => (free.0 / 2, far.1),
        };
        let mut placed = Placed { panel, corner, size };
        for earlier in &all {
            if !placed.overlaps(earlier) {
                continue;
            }
            let gap = grid.margin.1;
            placed.corner.1 = match placed.panel.anchor {
                Anchor::Bottom => earlier.corner.1.saturating_sub(size.1 + gap),
                _ => (earlier.corner.1 + earlier.size.1 + gap).min(free.1),
            };
        }
        all.retain(|earlier| !placed.overlaps(earlier));
        all.push(placed);
    }
    all
}

/// The panel with its lines broken. If it is too high, it loses its headings and empty lines, and
/// with them the indentation below the headings.
fn fitted(mut panel: Panel, grid: Grid) -> Panel {
    let broken = |lines: &[Line]| {
        let lines = lines.iter().flat_map(|line| wrapped(line, grid.columns()));
        lines.collect::<Vec<_>>()
    };
    let lines = std::mem::take(&mut panel.lines);
    panel.lines = broken(&lines);
    if grid.size(&panel).1 > grid.area.1 {
        let is_row = |line: &&Line| line.emphasised < line.text.chars().count();
        let rows: Vec<_> = lines.iter().filter(is_row).map(Line::flush).collect();
        if !rows.is_empty() {
            panel.lines = broken(&rows);
        }
    }
    panel
}

/// A line as several that are no longer than this. The later ones are indented more than the first.
fn wrapped(line: &Line, columns: usize) -> Vec<Line> {
    let spaces = line.text.len() - line.text.trim_start().len();
    let indent = " ".repeat((spaces + 2).min(columns / 2));
    let options = Options::new(columns).subsequent_indent(&indent);
    let mut left = line.emphasised;
    let parts = textwrap::wrap(&line.text, options);
    let lines = parts.iter().enumerate().map(|(number, text)| {
        let length = text.chars().count();
        let own = if number == 0 { 0 } else { indent.len() };
        let emphasised = if left == 0 { 0 } else { (left + own).min(length) };
        // A space is lost where a line is broken.
        left = left.saturating_sub(length - own.min(length) + 1);
        Line { text: text.to_string(), emphasised }
    });
    lines.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const GRID: Grid = Grid {
        area: (640, 360),
        cell: (6, 12),
        margin: (6, 4),
        bar: (18, 30),
        picture: ((0, 0), (640, 360)),
    };

    fn overlay() -> Overlay {
        Overlay {
            speeds: vec!["60 frames/s are shown here".into(); 5],
            loads: vec![0.5; 6],
            status: vec!["Blue's turn".into(), "3 of 7".into()],
            labels: Vec::new(),
            help: vec!["H: help".into(); 4],
            notice: Some("Paused".into()),
            message: Some(("news".into(), 0.5)),
        }
    }

    #[test]
    fn parts_do_not_overlap() {
        let all = place(panels(&overlay()), GRID);
        assert_eq!(all.len(), 5);
        for (number, placed) in all.iter().enumerate() {
            let free = all[..number].iter().all(|other| !placed.overlaps(other));
            assert!(free, "{placed:?}");
        }
        assert_eq!(all[0].corner, (6, 4));
        assert_eq!(all[1].corner.0 + all[1].size.0, 640 - 6);
        assert_eq!(all[4].corner.1 + all[4].size.1, 360 - 4);
        assert_eq!(all[4].panel.opacity, 0.5);
        // Help is in the middle, to a pixel, and the notice below it.
        let sum = 2 * all[2].corner.0 + all[2].size.0;
        assert!(sum.abs_diff(640) <= 1);
        assert!(all[3].corner.1 > all[2].corner.1 + all[2].size.1);
    }

    #[test]
    fn narrow_display_has_status_below_speeds() {
        let grid = Grid { area: (200, 360), ..GRID };
        let all = place(panels(&overlay()), grid);
        assert!(all[1].corner.1 >= all[0].corner.1 + all[0].size.1);
    }

    #[test]
    fn small_display_shows_only_keys() {
        let grid = Grid { area: (120, 60), ..GRID };
        let mut overlay = overlay();
        overlay.notice = None;
        overlay.message = None;
        let row = |text: &str, emphasised| Line { text: text.into(), emphasised };
        overlay.help = vec![row("  H: help", 4); 4];
        overlay.help.insert(0, Line::heading("chess"));
        let all = place(panels(&overlay), grid);
        let [help] = &all[..] else {
            panic!("{all:?}");
        };
        assert_eq!(help.panel.lines, vec![row("H: help", 2); 4]);
    }

    #[test]
    fn panels_stay_inside_the_area() {
        for area in [(1, 1), (5, 3), (64, 36), (320, 20), (20, 400)] {
            for placed in place(panels(&overlay()), Grid { area, ..GRID }) {
                assert!(placed.corner.0 + placed.size.0 <= area.0, "{placed:?}");
                assert!(placed.corner.1 + placed.size.1 <= area.1, "{placed:?}");
            }
        }
        assert_eq!(place(panels(&Overlay::default()), GRID), []);
    }

    fn label(text: &str, place: [f32; 2], side: Side) -> PlacedLabel {
        PlacedLabel { text: text.into(), place, side, colour: [255, 0, 0] }
    }

    #[test]
    fn labels_are_beside_their_places_in_the_picture() {
        let grid = Grid {
            // Bars at both sides.
            picture: ((100, 0), (440, 360)),
            ..GRID
        };
        let corner = |place, side| {
            let labels = place_labels(&[label("Mars", place, side)], &[], grid);
            labels[0].corner
        };
        // The letters are 24 pixels wide and 12 high.
        for (side, expected) in [
            (Side::Over, (308, 174)),
            (Side::Left, (293, 174)),
            (Side::Right, (323, 174)),
            (Side::Above, (308, 168)),
            (Side::Below, (308, 181)),
        ] {
            assert_eq!(corner([0.5; 2], side), expected, "{side:?}");
        }
        // What doesn't fit is moved inwards.
        assert_eq!(corner([1.0, 1.0], Side::Below), (528, 348));
        assert_eq!(corner([0.0, 0.0], Side::Above), (88, 0));
    }

    #[test]
    fn overlapping_label_is_omitted() {
        let labels = [
            label("Jupiter", [0.5, 0.5], Side::Over),
            label("Saturn", [0.52, 0.51], Side::Over),
            label("Uranus", [0.8, 0.5], Side::Over),
        ];
        let texts = |panels: &[Placed]| {
            let labels = place_labels(&labels, panels, GRID);
            labels.into_iter().map(|label| label.text).collect::<Vec<_>>()
        };
        assert_eq!(texts(&[]), ["Jupiter", "Uranus"]);
        let help = Overlay { notice: Some("Paused".into()), ..Overlay::default() };
        let panels = place(panels(&help), GRID);
        assert_eq!(texts(&panels), ["Uranus"]);
    }

    #[test]
    fn labels_stay_on_the_smallest_displays() {
        let labels = [label("Mercury", [0.9, 0.9], Side::Right)];
        for area in [(1, 1), (5, 12), (7, 40), (64, 36)] {
            let grid = Grid { area, picture: ((0, 0), area), ..GRID };
            for LabelAt { corner, size, .. } in place_labels(&labels, &[], grid) {
                assert!(corner.0 + size.0 <= area.0 && corner.1 + size.1 <= area.1);
            }
        }
    }

    #[test]
    fn long_line_is_broken_between_words() {
        let line =
            Line { text: "  left and right arrow, mouse: aim with care".into(), emphasised: 30 };
        let lines = wrapped(&line, 20);
        let texts: Vec<_> = lines.iter().map(|line| line.text.as_str()).collect();
        let expected = ["  left and right", "    arrow, mouse:", "    aim with care"];
        assert_eq!(texts, expected);
        let emphasised: Vec<_> = lines.iter().map(|line| line.emphasised).collect();
        assert_eq!(emphasised, [16, 17, 0]);
        // What has no space is broken all the same.
        let long = wrapped(&"x".repeat(50).into(), 20);
        assert!(long.iter().all(|line| line.text.len() <= 20), "{long:?}");
    }
}
