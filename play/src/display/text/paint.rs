//! Draws the overlay in pixels.

use cellray::framebuffer::PixelFormat;

use super::font::{Font, WHOLE};
use super::layout::{Grid, LabelAt, Placed, Rectangle, panels, place, place_labels};
use crate::overlay::{Line, Overlay};

/// The colour of letters.
pub const INK: [u8; 3] = [255; 3];
/// The colour of emphasised letters.
pub const EMPHASIS: [u8; 3] = [255, 205, 110];
/// The colour of the loaded part of a bar.
pub const LOAD: [u8; 3] = [0x40, 0xE0, 0x60];
/// The colour of the rest of a bar.
pub const ROOM: [u8; 3] = [0x30; 3];
/// The share of black in the background of text, in parts of [`WHOLE`].
const SHADE: u32 = 191;
/// The width of the dark edge around the letters of labels, which have no dark background.
const EDGE: usize = 1;
/// This many lines of text fill the height of a display, and as many characters its width: enough
/// for the help, and large enough to be read from afar.
const LINES: usize = 40;
const COLUMNS: usize = 64;
/// The minimum and the maximum height of a line in pixels. Smaller letters can't be read.
const HEIGHTS: (usize, usize) = (10, 80);

/// Pixels to draw on: big-endian words, as an SPU stores them.
pub struct Canvas<'a> {
    pub words: &'a mut [u32],
    /// The number of words from a row to the next.
    pub stride: usize,
    /// The width and height in pixels.
    pub area: (usize, usize),
    /// The positions of the channels.
    pub format: PixelFormat,
}

impl Canvas<'_> {
    /// Mixes a colour into a pixel. `part` is the colour's share, 0 to [`WHOLE`].
    fn mix(&mut self, (x, y): (usize, usize), colour: [u8; 3], part: u32) {
        if x >= self.area.0 || y >= self.area.1 {
            return;
        }
        if let Some(word) = self.words.get_mut(y * self.stride + x) {
            let before = self.format.channels(u32::from_be(*word));
            let mixed = [0, 1, 2].map(|channel| {
                let (from, to) = (u32::from(before[channel]), u32::from(colour[channel]));
                ((from * (WHOLE - part) + to * part + WHOLE / 2) / WHOLE) as u8
            });
            *word = self.format.word(mixed).to_be();
        }
    }
}

/// Where the parts of an overlay are drawn.
pub struct Layout {
    panels: Vec<Placed>,
    labels: Vec<LabelAt>,
}

impl Layout {
    /// The pixels that are drawn on.
    pub fn rectangles(&self) -> impl Iterator<Item = Rectangle> {
        let panels = self.panels.iter().map(|panel| (panel.corner, panel.size));
        let labels = self.labels.iter().map(|label| {
            let ((left, top), (width, height)) = (label.corner, label.size);
            let corner = (left.saturating_sub(EDGE), top.saturating_sub(EDGE));
            (corner, (width + 2 * EDGE, height + 2 * EDGE))
        });
        panels.chain(labels)
    }
}

/// Draws overlays, and keeps the letters of the last size.
#[derive(Default)]
pub struct Painter {
    font: Option<Font>,
}

impl Painter {
    /// Where the parts of an overlay are drawn on a display of this size, with a picture that
    /// fills this part of it.
    pub fn place(&mut self, overlay: &Overlay, area: (usize, usize), picture: Rectangle) -> Layout {
        let (width, height) = self.font(area).cell;
        let grid = Grid {
            area,
            cell: (width, height),
            margin: (width, height / 3),
            bar: (2 * width, 5 * height / 2),
            picture,
        };
        let panels = place(panels(overlay), grid);
        Layout { labels: place_labels(&overlay.labels, &panels, grid), panels }
    }

    /// Draws an overlay over a picture that fills this part of the canvas.
    pub fn paint(&mut self, overlay: &Overlay, picture: Rectangle, canvas: &mut Canvas<'_>) {
        let Layout { panels, labels } = self.place(overlay, canvas.area, picture);
        let font = self.font(canvas.area);
        labels.iter().for_each(|label| name(label, font, canvas));
        panels.iter().for_each(|panel| draw(panel, font, canvas));
    }

    /// The letters for a display of this size.
    fn font(&mut self, (width, height): (usize, usize)) -> &mut Font {
        // A character is about half as wide as it is high.
        let wanted = (height / LINES).min(2 * width / COLUMNS);
        let wanted = wanted.clamp(HEIGHTS.0, HEIGHTS.1);
        if self.font.as_ref().is_none_or(|font| font.cell.1 != wanted) {
            self.font = None;
        }
        self.font.get_or_insert_with(|| Font::new(wanted))
    }
}

fn draw(placed: &Placed, font: &mut Font, canvas: &mut Canvas<'_>) {
    let ((left, top), (wide, high)) = (placed.corner, placed.size);
    let (width, height) = font.cell;
    // The conversion saturates.
    let opacity = ((placed.panel.opacity * WHOLE as f32) as u32).min(WHOLE);
    for y in top..top + high {
        for x in left..left + wide {
            canvas.mix((x, y), [0; 3], SHADE * opacity / WHOLE);
        }
    }
    let (left, mut top) = (left + width, top + height / 3);
    for line in &placed.panel.lines {
        write(line, (left, top), font, opacity, canvas);
        top += height;
    }
    let (bar, tall) = (2 * width, 5 * height / 2);
    for (number, &load) in placed.panel.loads.iter().enumerate() {
        let filled = (load.clamp(0.0, 1.0) * tall as f32).round() as usize;
        for y in 0..tall {
            let colour = if y >= tall - filled { LOAD } else { ROOM };
            for x in 0..bar - bar / 4 {
                let place = (left + number * bar + x, top + height / 3 + y);
                canvas.mix(place, colour, opacity);
            }
        }
    }
}

fn write(
    line: &Line,
    corner: (usize, usize),
    font: &mut Font,
    opacity: u32,
    canvas: &mut Canvas<'_>,
) {
    let emphasised = line.emphasised;
    letters(&line.text, corner, font, |number, place, part| {
        let colour = if number < emphasised { EMPHASIS } else { INK };
        canvas.mix(place, colour, part * opacity / WHOLE);
    });
}

/// Draws a label: its letters, over the same letters in black at all sides.
fn name(label: &LabelAt, font: &mut Font, canvas: &mut Canvas<'_>) {
    let LabelAt { text, corner, .. } = label;
    for side in [(0, EDGE), (2 * EDGE, EDGE), (EDGE, 0), (EDGE, 2 * EDGE)] {
        letters(text, *corner, font, |_, (x, y), part| {
            let place = (x + side.0).checked_sub(EDGE);
            if let Some(place) = place.zip((y + side.1).checked_sub(EDGE)) {
                canvas.mix(place, [0; 3], part * SHADE / WHOLE);
            }
        });
    }
    letters(text, *corner, font, |_, place, part| {
        canvas.mix(place, label.colour, part);
    });
}

/// Calls `ink` with each pixel of a text's letters: the letter's number, the pixel's place, and the
/// letter's share of it in parts of [`WHOLE`].
fn letters(
    text: &str,
    (left, top): (usize, usize),
    font: &mut Font,
    mut ink: impl FnMut(usize, (usize, usize), u32),
) {
    let width = font.cell.0;
    for (number, letter) in text.chars().enumerate() {
        let glyph = font.glyph(letter);
        let (x, y) = (left + number * width, top);
        for (row, parts) in glyph.coverage.chunks(glyph.width).enumerate() {
            for (column, &part) in parts.iter().enumerate().filter(|(_, part)| **part > 0) {
                let place = (x + column).checked_add_signed(glyph.corner.0 as isize);
                let place = place.zip((y + row).checked_add_signed(glyph.corner.1 as isize));
                if let Some(place) = place {
                    ink(number, place, u32::from(part));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cellray::game::{PlacedLabel, Side};

    const GREY: [u8; 3] = [0x80; 3];

    fn painted(overlay: &Overlay, area: (usize, usize)) -> Vec<[u8; 3]> {
        let grey = PixelFormat::ARGB.word(GREY).to_be();
        let mut words = vec![grey; area.0 * area.1];
        let mut canvas =
            Canvas { words: &mut words, stride: area.0, area, format: PixelFormat::ARGB };
        Painter::default().paint(overlay, ((0, 0), area), &mut canvas);
        let colours = words.iter().map(|word| u32::from_be(*word));
        colours.map(|word| PixelFormat::ARGB.channels(word)).collect()
    }

    fn count(pixels: &[[u8; 3]], colour: [u8; 3]) -> usize {
        pixels.iter().filter(|&&pixel| pixel == colour).count()
    }

    #[test]
    fn bar_height_is_load() {
        let overlay = Overlay { loads: vec![0.0, 0.5, 1.0], ..Overlay::default() };
        let area = (480, 480);
        let pixels = painted(&overlay, area);
        let (load, capacity) = (count(&pixels, LOAD), count(&pixels, ROOM));
        assert!(load == capacity && load > 300, "{load} {capacity}");
        assert!(count(&pixels, GREY) > 400 * 400);
    }

    #[test]
    fn message_fades() {
        let message =
            |opacity| Overlay { message: Some(("H: help".into(), opacity)), ..Overlay::default() };
        let brightest = |opacity| {
            let pixels = painted(&message(opacity), (400, 400));
            pixels.iter().flatten().max().copied()
        };
        let darkest = |opacity| {
            let pixels = painted(&message(opacity), (400, 400));
            pixels.iter().flatten().min().copied()
        };
        assert_eq!(darkest(1.0), Some(0x20));
        assert!(brightest(1.0) > Some(0xE0) && brightest(0.3) < brightest(1.0));
        assert!(darkest(0.3) > darkest(1.0));
        assert_eq!(count(&painted(&message(0.0), (400, 400)), GREY), 400 * 400);
    }

    #[test]
    fn label_has_its_colour_and_layout_position() {
        let area = (640, 800);
        let overlay = Overlay {
            labels: vec![PlacedLabel {
                text: "Neptune".into(),
                place: [0.5, 0.25],
                side: Side::Over,
                colour: [255, 0, 0],
            }],
            ..Overlay::default()
        };
        let layout = Painter::default().place(&overlay, area, ((0, 0), area));
        let rectangles: Vec<_> = layout.rectangles().collect();
        let [((left, top), (width, height))] = rectangles[..] else {
            panic!("{rectangles:?}");
        };
        assert!((left + width / 2).abs_diff(320) <= 1 && (top + height / 2).abs_diff(200) <= 1);
        let pixels = painted(&overlay, area);
        let drawn: Vec<_> = (0..pixels.len())
            .filter(|&at| pixels[at] != GREY)
            .map(|at| (at % area.0, at / area.0))
            .collect();
        let within = |&(x, y): &(usize, usize)| {
            (left..left + width).contains(&x) && (top..top + height).contains(&y)
        };
        assert!(drawn.len() > 100 && drawn.iter().all(within));
        let red = pixels.iter().filter(|pixel| pixel[0] > 200 && pixel[1] < 60);
        let dark = pixels.iter().filter(|pixel| pixel.iter().all(|it| *it < 0x50));
        assert!(red.count() > 30 && dark.count() > 30);
    }

    #[test]
    fn oversized_text_is_omitted() {
        let overlay = Overlay {
            speeds: vec!["a long line of text".into(); 9],
            loads: vec![1.0; 6],
            help: vec!["help".into(); 99],
            message: Some(("news".into(), 1.0)),
            ..Overlay::default()
        };
        for area in [(1, 1), (7, 3), (64, 64)] {
            painted(&overlay, area);
        }
        assert_eq!(count(&painted(&Overlay::default(), (9, 9)), GREY), 81);
    }

    #[test]
    fn letter_size_grows_with_display() {
        let mut painter = Painter::default();
        let mut height = |area| painter.font(area).cell.1;
        assert_eq!(height((320, 180)), 10);
        assert_eq!(height((1280, 720)), 18);
        assert_eq!(height((1920, 1080)), 27);
        assert_eq!(height((300, 1080)), 10);
    }
}
