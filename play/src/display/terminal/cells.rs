//! Draws pictures with characters: an upper half block, with its colour for the upper pixel and
//! the background's colour for the lower one.
//!
//! Invariant: only the differences from the terminal's contents are written, so a picture that
//! hardly changes needs little bandwidth.

use std::io::Write as _;
use std::ops::Range;

use image::RgbImage;

use super::super::Fit;
use super::texts::Text;

const HALF: &str = "\u{2580}";
const EMPHASIS: [u8; 3] = [255, 215, 135];

/// How colours are encoded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colours {
    /// As red, green and blue.
    True,
    /// As one of 256 numbered colours, in a cube with six steps in each direction.
    Cube,
}

impl Colours {
    /// The colours that the terminal's environment variables announce.
    pub fn of_environment() -> Self {
        match std::env::var("COLORTERM").as_deref() {
            Ok("truecolor" | "24bit") => Self::True,
            _ => Self::Cube,
        }
    }

    /// The nearest colour that the terminal has. Equal results look equal.
    fn shown(self, [red, green, blue]: [u8; 3]) -> Colour {
        match self {
            Self::True => Colour::True([red, green, blue]),
            Self::Cube => {
                Colour::Cube(16 + 36 * cube_step(red) + 6 * cube_step(green) + cube_step(blue))
            }
        }
    }
}

/// The nearest of the cube's six steps: 0, 95, 135, 175, 215, 255.
fn cube_step(channel: u8) -> u8 {
    match channel {
        0..48 => 0,
        48..115 => 1,
        _ => (channel - 35) / 40,
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Colour {
    True([u8; 3]),
    Cube(u8),
}

impl Colour {
    /// Writes the colour as that of the foreground (3) or of the background (4).
    fn write(self, layer: u8, out: &mut Vec<u8>) {
        // Writing to memory can't fail.
        let _ = match self {
            Self::True([red, green, blue]) => write!(out, "\x1b[{layer}8;2;{red};{green};{blue}m"),
            Self::Cube(number) => write!(out, "\x1b[{layer}8;5;{number}m"),
        };
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Cell {
    letter: Option<char>,
    above: Colour,
    below: Colour,
}

/// The contents of the terminal.
#[derive(Debug)]
pub struct Grid {
    colours: Colours,
    size: (u16, u16),
    /// `None` for cells with unknown contents.
    shown: Vec<Option<Cell>>,
    text: Vec<u8>,
    /// The text over the picture: for each cell the letter and its colour.
    letters: Vec<Option<(char, [u8; 3])>>,
}

impl Grid {
    pub fn new(colours: Colours) -> Self {
        Self { colours, size: (0, 0), shown: Vec::new(), text: Vec::new(), letters: Vec::new() }
    }

    /// Forgets the terminal's contents, so that everything is drawn again.
    pub fn forget(&mut self) {
        self.size = (0, 0);
    }

    /// The bytes to write so that the terminal shows the picture, with texts over it. A
    /// later text covers an earlier one.
    pub fn draw(
        &mut self,
        picture: &RgbImage,
        fit: Fit,
        (columns, rows): (u16, u16),
        texts: &[Text],
    ) -> &[u8] {
        self.text.clear();
        if self.size != (columns, rows) {
            self.size = (columns, rows);
            self.shown.clear();
            self.shown.resize(usize::from(columns) * usize::from(rows), None);
        }
        let colour = |x: u16, y: u32| {
            let place = fit.column(u32::from(x)).zip(fit.row(y));
            let pixel = place.map(|(x, y)| picture.get_pixel(x, y).0).unwrap_or_default();
            self.colours.shown(pixel)
        };
        self.letters.clear();
        self.letters.resize(self.shown.len(), None);
        for text in texts.iter().filter(|text| text.row < usize::from(rows)) {
            let across = text.column..usize::from(columns);
            for (x, letter) in across.zip(text.letters.chars()) {
                let ink = if x < text.emphasised { EMPHASIS } else { text.colour };
                self.letters[text.row * usize::from(columns) + x] = Some((letter, ink));
            }
        }
        // The position of the terminal's cursor.
        let mut cursor = None;
        let mut ink = None;
        for y in 0..rows {
            for x in 0..columns {
                let place = usize::from(y) * usize::from(columns) + usize::from(x);
                let cell = match self.letters[place] {
                    Some((letter, ink)) => Cell {
                        letter: Some(letter),
                        above: self.colours.shown(ink),
                        below: self.colours.shown([0; 3]),
                    },
                    None => Cell {
                        letter: None,
                        above: colour(x, 2 * u32::from(y)),
                        below: colour(x, 2 * u32::from(y) + 1),
                    },
                };
                if self.shown[place] == Some(cell) {
                    continue;
                }
                self.shown[place] = Some(cell);
                if cursor != Some((x, y)) {
                    // Writing to memory can't fail.
                    let _ = write!(self.text, "\x1b[{};{}H", y + 1, x + 1);
                }
                let (above, below) = ink.unzip();
                if above != Some(cell.above) {
                    cell.above.write(3, &mut self.text);
                }
                if below != Some(cell.below) {
                    cell.below.write(4, &mut self.text);
                }
                ink = Some((cell.above, cell.below));
                let mut bytes = [0; 4];
                let text = cell.letter.map_or(HALF, |letter| letter.encode_utf8(&mut bytes));
                self.text.extend_from_slice(text.as_bytes());
                // Terminals differ in the cursor's position after the last column.
                cursor = (x + 1 < columns).then_some((x + 1, y));
            }
        }
        &self.text
    }
}

/// A picture as lines of text, `columns` wide, for a terminal that scrolls.
pub fn lines(picture: &RgbImage, columns: u16, colours: Colours) -> Vec<u8> {
    let (width, height) = picture.dimensions();
    let columns = u32::from(columns).clamp(1, width.max(1));
    let rows = (columns * height / width.max(1)).div_ceil(2).max(1);
    let mut text = Vec::new();
    for row in 0..rows {
        for column in 0..columns {
            let colour = |y| {
                let across = part(width, columns, column);
                let down = part(height, 2 * rows, y);
                colours.shown(mean(picture, across, down))
            };
            colour(2 * row).write(3, &mut text);
            colour(2 * row + 1).write(4, &mut text);
            text.extend_from_slice(HALF.as_bytes());
        }
        text.extend_from_slice(b"\x1b[0m\n");
    }
    text
}

/// The pixels of part `number` if there are `parts` of equal size. It is never empty.
fn part(pixels: u32, parts: u32, number: u32) -> Range<u32> {
    let start = number * pixels / parts;
    start..((number + 1) * pixels / parts).max(start + 1)
}

/// The mean colour of a rectangle.
// The resizing functions of the crate image would bring in the C library's `expf` and `sinf`, which
// the console's program may not use: their results differ between systems.
fn mean(picture: &RgbImage, across: Range<u32>, down: Range<u32>) -> [u8; 3] {
    let count = (across.end - across.start) * (down.end - down.start);
    let mut sum = [0; 3];
    for y in down {
        for x in across.clone() {
            for (sum, channel) in sum.iter_mut().zip(picture.get_pixel(x, y).0) {
                *sum += u32::from(channel);
            }
        }
    }
    sum.map(|sum| ((sum + count / 2) / count) as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(pixels: &[[u8; 3]]) -> RgbImage {
        let bytes = pixels.as_flattened().to_vec();
        RgbImage::from_vec(2, pixels.len() as u32 / 2, bytes).expect("whole rows")
    }

    fn draw(grid: &mut Grid, picture: &RgbImage, line: Option<&str>) -> String {
        let fit = Fit::new((2, 4), (2, 4));
        let texts = line.map(|line| Text {
            column: 0,
            row: 1,
            letters: line.to_owned(),
            emphasised: 0,
            colour: [255; 3],
        });
        let texts: Vec<_> = texts.into_iter().collect();
        let text = grid.draw(picture, fit, (2, 2), &texts);
        String::from_utf8(text.to_vec()).expect("text")
    }

    const RED: [u8; 3] = [200, 0, 0];
    const BLUE: [u8; 3] = [0, 0, 99];

    #[test]
    fn picture_lines_keep_proportions() {
        let picture = RgbImage::from_pixel(40, 20, image::Rgb(RED));
        let text = String::from_utf8(lines(&picture, 10, Colours::True)).expect("text");
        let cell = "\x1b[38;2;200;0;0m\x1b[48;2;200;0;0m\u{2580}";
        let line = format!("{}\x1b[0m\n", cell.repeat(10));
        assert_eq!(text, line.repeat(3));
        let narrow = RgbImage::from_pixel(1, 1, image::Rgb(RED));
        assert_eq!(
            lines(&narrow, 80, Colours::Cube).iter().filter(|&&byte| byte == b'\n').count(),
            1
        );
    }

    #[test]
    fn cell_has_two_pixels_and_only_changes_are_written() {
        let mut grid = Grid::new(Colours::True);
        let mut shown = picture(&[RED, RED, BLUE, BLUE, RED, BLUE, RED, BLUE]);
        let first = draw(&mut grid, &shown, None);
        assert_eq!(
            first,
            "\x1b[1;1H\x1b[38;2;200;0;0m\x1b[48;2;0;0;99m\u{2580}\u{2580}\
             \x1b[2;1H\x1b[48;2;200;0;0m\u{2580}\x1b[38;2;0;0;99m\x1b[48;2;0;0;99m\u{2580}"
        );
        assert_eq!(draw(&mut grid, &shown, None), "");
        shown.put_pixel(1, 3, image::Rgb(RED));
        let changed = draw(&mut grid, &shown, None);
        assert_eq!(changed, "\x1b[2;2H\x1b[38;2;0;0;99m\x1b[48;2;200;0;0m\u{2580}");
    }

    #[test]
    fn forgotten_cells_are_written_again() {
        let mut grid = Grid::new(Colours::True);
        let shown = picture(&[RED; 8]);
        let first = draw(&mut grid, &shown, None);
        assert_eq!(draw(&mut grid, &shown, None), "");
        grid.forget();
        assert_eq!(draw(&mut grid, &shown, None), first);
    }

    #[test]
    fn text_on_last_line_is_removed() {
        let mut grid = Grid::new(Colours::Cube);
        let shown = picture(&[RED; 8]);
        let with_text = draw(&mut grid, &shown, Some("abc"));
        assert!(with_text.contains("ab") && !with_text.contains('c'), "{with_text:?}");
        assert_eq!(with_text.matches(HALF).count(), 2);
        assert_eq!(draw(&mut grid, &shown, None).matches(HALF).count(), 2);
    }

    #[test]
    fn colour_cube_step_is_nearest() {
        for channel in 0..=255_u8 {
            let steps = [0, 95, 135, 175, 215, 255_u8];
            let away = |step: u8| steps[usize::from(step)].abs_diff(channel);
            let best = (0..6).map(away).min();
            assert_eq!(Some(away(cube_step(channel))), best, "{channel}");
        }
    }
}
