//! The letters: DejaVu Sans Mono, rasterised once for each size. Whoever passes the program on
//! passes on `play/LICENSE-DEJAVU` too.

use std::collections::HashMap;

use ab_glyph::{Font as _, FontRef, Glyph as Outlined, ScaleFont as _, point};

/// The share of a letter's colour in a pixel is counted in this many steps.
pub const WHOLE: u32 = 255;

/// A letter, rasterised.
#[derive(Debug)]
pub struct Glyph {
    /// The position of its first pixel in the character's cell, which may be outside of it.
    pub corner: (i32, i32),
    /// Its width in pixels.
    pub width: usize,
    /// For each of its pixels, row by row, the share of the letter's colour, 0 to [`WHOLE`].
    pub coverage: Vec<u8>,
}

pub struct Font {
    /// `None` if the crate's font can't be read; then no letter has a pixel.
    font: Option<FontRef<'static>>,
    /// The width and height of a character's cell in pixels.
    pub cell: (usize, usize),
    glyphs: HashMap<char, Glyph>,
}

impl Font {
    /// Letters whose cells are this high, in pixels.
    pub fn new(height: usize) -> Self {
        let font = FontRef::try_from_slice(dejavu::sans_mono::regular()).ok();
        let width = font.as_ref().map_or(1.0, |font| {
            let scaled = font.as_scaled(height as f32);
            scaled.h_advance(scaled.glyph_id('0'))
        });
        Self { font, cell: ((width.round() as usize).max(1), height), glyphs: HashMap::new() }
    }

    /// A letter. One that the font doesn't have is shown as the font's box.
    pub fn glyph(&mut self, letter: char) -> &Glyph {
        let (font, cell) = (&self.font, self.cell);
        let glyphs = &mut self.glyphs;
        glyphs.entry(letter).or_insert_with(|| {
            braille(letter, cell).unwrap_or_else(|| rasterised(font.as_ref(), cell.1, letter))
        })
    }
}

/// The dots of a letter of Braille, row by row, as the bits of its number. They fill its cell, so
/// that games can draw with them; the font has none.
const BRAILLE: [[u32; 2]; 4] = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];

fn braille(letter: char, (width, height): (usize, usize)) -> Option<Glyph> {
    let bits = u32::from(letter).checked_sub(0x2800).filter(|bits| *bits < 0x100)?;
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (4 * y / height, 2 * x / width)));
    let share = |(row, column): (usize, usize)| match bits & BRAILLE[row][column] {
        0 => 0,
        _ => WHOLE as u8,
    };
    Some(Glyph { corner: (0, 0), width, coverage: places.map(share).collect() })
}

fn rasterised(font: Option<&FontRef<'_>>, height: usize, letter: char) -> Glyph {
    let outlined = font.and_then(|font| {
        let scaled = font.as_scaled(height as f32);
        // Whole pixels down, so that all letters of a line stand on the same row.
        let base = scaled.ascent().round();
        let glyph: Outlined =
            scaled.glyph_id(letter).with_scale_and_position(height as f32, point(0.0, base));
        font.outline_glyph(glyph)
    });
    let Some(outlined) = outlined else {
        return Glyph { corner: (0, 0), width: 1, coverage: Vec::new() };
    };
    let bounds = outlined.px_bounds();
    let (width, rows) = (bounds.width() as usize, bounds.height() as usize);
    let mut coverage = vec![0; width * rows];
    outlined.draw(|x, y, part| {
        let pixel = coverage.get_mut(y as usize * width + x as usize);
        if let Some(pixel) = pixel {
            // Colours are mixed by their sRGB values, which makes thin bright strokes on black too
            // dark. A larger part makes up for that. The conversion saturates.
            let part = part * (1.5 - 0.5 * part);
            *pixel = (part * WHOLE as f32).round() as u8;
        }
    });
    Glyph { corner: (bounds.min.x as i32, bounds.min.y as i32), width: width.max(1), coverage }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each bit of a number of Braille is an eighth of the cell.
    #[test]
    fn braille_fills_its_cell() {
        let mut font = Font::new(16);
        let cell = font.cell.0 * 16;
        let mut drawn = |bits: u32| {
            let glyph = font.glyph(char::from_u32(0x2800 + bits).expect("a letter"));
            glyph.coverage.iter().filter(|&&part| part > 0).count()
        };
        assert_eq!((drawn(0), drawn(0xff)), (0, cell));
        assert_eq!((0..8).map(|bit| drawn(1 << bit)).sum::<usize>(), cell);
        assert!((0..8).all(|bit| drawn(1 << bit) >= 16));
    }

    #[test]
    fn letters_fit_their_cells() {
        for height in [10, 14, 18, 27, 54] {
            let mut font = Font::new(height);
            let (width, _) = font.cell;
            assert!(width * 3 > height && width * 3 < height * 2, "{height}");
            for letter in (' '..='~').chain(['\u{1F600}']) {
                let glyph = font.glyph(letter);
                let rows = glyph.coverage.len() / glyph.width;
                let bottom = glyph.corner.1 + rows as i32;
                // The underscore may lie between two lines.
                assert!(glyph.corner.1 >= 0 && bottom <= height as i32 + 1, "{letter}");
                let right = glyph.corner.0 + glyph.width as i32;
                assert!(glyph.corner.0 >= -1 && right <= width as i32 + 1);
                let is_drawn = glyph.coverage.iter().any(|&part| part > 60);
                assert_eq!(is_drawn, letter != ' ', "{letter} {height}");
            }
        }
    }
}
