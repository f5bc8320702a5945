//! Draws the overlay in pixels.
//!
//! Invariant: the overlay is drawn on the display, never into the picture that the SPUs write.

use font8x8::legacy::BASIC_LEGACY;

use crate::overlay::Overlay;

/// The width and height of a letter in pixels.
const LETTER: usize = 8;
/// The distance between lines in pixels.
const LINE: usize = 10;
const MARGIN: usize = 6;
/// The size of the bars for the SPUs' loads in pixels.
const BAR_WIDTH: usize = 14;
const BAR_HEIGHT: usize = 32;

/// The colour of letters.
pub const INK: u32 = 0x00FF_FFFF;
/// The colour of the loaded part of a bar.
pub const LOAD: u32 = 0x0040_E060;
/// The colour of the rest of a bar.
pub const ROOM: u32 = 0x0030_3030;

/// Draws the overlay over pixels with rows of `width`. Parts that don't fit are left out.
pub fn draw(overlay: &Overlay, pixels: &mut [u32], width: usize) {
    let bars = overlay.loads.len() * (BAR_WIDTH + 4);
    let lines: Vec<_> = overlay.lines.iter().chain(&overlay.message).collect();
    let longest = lines.iter().map(|line| line.chars().count() * LETTER);
    let wide = longest.max().unwrap_or(0).max(bars) + 2 * MARGIN;
    let room_for_bars = match bars {
        0 => 0,
        _ => MARGIN + BAR_HEIGHT,
    };
    let high = lines.len() * LINE + 2 * MARGIN + room_for_bars;
    let mut canvas = Canvas { pixels, width };
    for y in 0..high {
        (0..wide).for_each(|x| canvas.darken(x, y));
    }
    for (number, line) in lines.iter().enumerate() {
        canvas.text(MARGIN, MARGIN + number * LINE, line);
    }
    let top = lines.len() * LINE + 2 * MARGIN;
    for (number, &load) in overlay.loads.iter().enumerate() {
        let left = MARGIN + number * (BAR_WIDTH + 4);
        let filled = (load.clamp(0.0, 1.0) * BAR_HEIGHT as f32).round() as usize;
        for y in 0..BAR_HEIGHT {
            let colour = if y >= BAR_HEIGHT - filled { LOAD } else { ROOM };
            (0..BAR_WIDTH).for_each(|x| canvas.set(left + x, top + y, colour));
        }
    }
}

struct Canvas<'a> {
    pixels: &'a mut [u32],
    width: usize,
}

impl Canvas<'_> {
    fn at(&mut self, x: usize, y: usize) -> Option<&mut u32> {
        let inside = x < self.width;
        self.pixels.get_mut(y * self.width + x).filter(|_| inside)
    }

    fn set(&mut self, x: usize, y: usize, colour: u32) {
        if let Some(pixel) = self.at(x, y) {
            *pixel = colour;
        }
    }

    fn darken(&mut self, x: usize, y: usize) {
        if let Some(pixel) = self.at(x, y) {
            // Reduces each channel to a quarter.
            *pixel = *pixel >> 2 & 0x003F_3F3F;
        }
    }

    fn text(&mut self, left: usize, top: usize, text: &str) {
        for (place, letter) in text.chars().enumerate() {
            let unknown = BASIC_LEGACY['?' as usize];
            let rows = BASIC_LEGACY
                .get(letter as usize)
                .copied()
                .unwrap_or(unknown);
            for (y, bits) in rows.into_iter().enumerate() {
                for x in (0..LETTER).filter(|x| bits >> x & 1 == 1) {
                    self.set(left + place * LETTER + x, top + y, INK);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(overlay: &Overlay, width: usize, height: usize) -> Vec<u32> {
        let mut pixels = vec![0x0080_8080; width * height];
        draw(overlay, &mut pixels, width);
        pixels
    }

    fn count(pixels: &[u32], colour: u32) -> usize {
        pixels.iter().filter(|&&pixel| pixel == colour).count()
    }

    #[test]
    fn bars_are_as_high_as_the_loads() {
        let overlay = Overlay {
            lines: vec!["fps".into()],
            loads: vec![0.0, 0.5, 1.0],
            message: None,
        };
        let pixels = drawn(&overlay, 200, 100);
        assert_eq!(count(&pixels, LOAD), BAR_WIDTH * BAR_HEIGHT * 3 / 2);
        assert_eq!(count(&pixels, ROOM), BAR_WIDTH * BAR_HEIGHT * 3 / 2);
        assert!(count(&pixels, INK) > 20);
        assert!(count(&pixels, 0x0080_8080) > 100 * 100);
        // A message alone has no room for bars under it.
        let message = Overlay {
            message: Some("news".into()),
            ..Overlay::default()
        };
        let pixels = drawn(&message, 200, 100);
        let box_of = (2 * MARGIN + 4 * LETTER) * (2 * MARGIN + LINE);
        assert_eq!(count(&pixels, 0x0080_8080), 200 * 100 - box_of);
    }

    #[test]
    fn letters_are_those_of_the_text() {
        let text = |text: &str| {
            let lines = vec![text.to_owned()];
            let loads = Vec::new();
            let overlay = Overlay {
                lines,
                loads,
                message: None,
            };
            drawn(&overlay, 64, 24)
        };
        // The upright of an L, and its foot.
        let letter = text("L");
        let is_ink = |x: usize, y: usize| letter[(MARGIN + y) * 64 + MARGIN + x] == INK;
        assert!((0..7).all(|y| is_ink(1, y) || is_ink(2, y)) && is_ink(5, 6) && !is_ink(5, 2));
        assert_eq!(text("\u{1F600}"), text("?"));
    }

    #[test]
    fn what_does_not_fit_is_left_out() {
        let overlay = Overlay {
            lines: vec!["a long line of text".into(); 9],
            loads: vec![1.0; 6],
            message: Some("news".into()),
        };
        for (width, height) in [(1, 1), (7, 3), (64, 64)] {
            drawn(&overlay, width, height);
        }
        drawn(&Overlay::default(), 1, 1);
    }
}
