//! Places the overlay's text on a terminal's characters: speeds and messages in the last line, and
//! the rest as panels and labels over the picture.

use super::super::Fit;
use super::super::text::{Grid, Placed, place, place_labels, words};
use crate::overlay::Overlay;

/// Text at a place of the terminal, all in one row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Text {
    pub column: usize,
    pub row: usize,
    /// The characters. The first ones are emphasised.
    pub letters: String,
    /// The column after the emphasised characters.
    pub emphasised: usize,
    /// The colour of the other characters.
    pub colour: [u8; 3],
}

const WHITE: [u8; 3] = [255; 3];

/// The overlay's text on a terminal of this many columns and rows, of which each is two pixels of
/// the picture.
pub fn texts(overlay: &Overlay, (columns, rows): (u16, u16), fit: Fit) -> Vec<Text> {
    let (columns, rows) = (usize::from(columns), usize::from(rows));
    let line = overlay.line();
    let [corner, size] = [fit.corner(), fit.size()].map(|(x, y)| (x as usize, y as usize / 2));
    let grid = Grid {
        area: (columns, rows.saturating_sub(usize::from(line.is_some()))),
        cell: (1, 1),
        margin: (1, 0),
        bar: (0, 0),
        picture: (corner, size),
    };
    let panels = place(words(overlay), grid);
    let mut texts: Vec<_> = panels.iter().flat_map(rows_of).collect();
    let labels = place_labels(&overlay.labels, &panels, grid);
    texts.extend(labels.into_iter().map(|label| Text {
        column: label.corner.0,
        row: label.corner.1,
        letters: label.text,
        emphasised: label.corner.0,
        colour: label.colour,
    }));
    if let Some(line) = line.filter(|_| rows > 0) {
        texts.push(Text {
            column: 0,
            row: rows - 1,
            letters: format!("{line:columns$}"),
            emphasised: 0,
            colour: WHITE,
        });
    }
    texts
}

/// A panel's rows, as wide as the panel.
fn rows_of(placed: &Placed) -> impl Iterator<Item = Text> {
    let ((column, top), (width, height)) = (placed.corner, placed.size);
    let lines = placed.panel.lines.iter().take(height);
    lines.enumerate().map(move |(number, line)| Text {
        column,
        row: top + number,
        letters: format!("{:width$}", format!(" {}", line.text)),
        emphasised: match line.emphasised {
            0 => column,
            letters => column + 1 + letters,
        },
        colour: WHITE,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use cellray::game::{PlacedLabel, Side};

    #[test]
    fn panels_are_as_wide_as_their_longest_line_and_stay_above_the_last() {
        let overlay = Overlay {
            speeds: vec!["60 frames/s".into()],
            status: vec!["Blue's turn".into(), "3 of 7".into()],
            ..Overlay::default()
        };
        let fit = Fit::new((30, 20), (30, 20));
        let texts = texts(&overlay, (30, 10), fit);
        let parts: Vec<_> =
            texts.iter().map(|text| (text.column, text.row, text.letters.as_str())).collect();
        let last = format!("{:30}", "60 frames/s");
        let expected = [(16, 0, " Blue's turn "), (16, 1, " 3 of 7      "), (0, 9, last.as_str())];
        assert_eq!(parts, expected);
        // Everything is cut off on a terminal that is too small.
        for size in [(1, 1), (3, 2), (80, 1)] {
            for text in super::texts(&overlay, size, fit) {
                assert!(text.row < usize::from(size.1), "{text:?}");
            }
        }
    }

    #[test]
    fn label_is_at_characters_of_its_position() {
        let overlay = Overlay {
            labels: vec![PlacedLabel {
                text: "Mars".into(),
                place: [0.5, 0.75],
                side: Side::Right,
                colour: [200, 10, 10],
            }],
            ..Overlay::default()
        };
        // The picture has bars at both sides.
        let fit = Fit::new((20, 20), (40, 20));
        let expected = Text {
            column: 20,
            row: 7,
            letters: "Mars".into(),
            emphasised: 20,
            colour: [200, 10, 10],
        };
        assert_eq!(texts(&overlay, (40, 10), fit), [expected]);
    }
}
